//! Any text is either a shot that survives writing and reading, or bad input with an error message.
#![no_main]

use carom::{Shot, Trace};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    match Shot::from_json(text) {
        Ok(shot) => {
            let json = shot.to_json();
            let again = Shot::from_json(&json).expect("a written shot can be read");
            assert_eq!(shot, again);
            assert_eq!(json, again.to_json());
        }
        Err(e) => assert!(e.is_bad_input() && !e.to_string().is_empty()),
    }
    if let Err(e) = Trace::from_json(text) {
        assert!(e.is_bad_input() && !e.to_string().is_empty());
    }
});
