//! Any text is either a shot, which reads back to itself, or bad input with a sentence about it.
#![no_main]

use carom::{Shot, Trace};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    match Shot::from_json(text) {
        Ok(shot) => {
            let json = shot.to_json();
            let again = Shot::from_json(&json).expect("what was written reads back");
            assert_eq!(shot, again);
            assert_eq!(json, again.to_json());
        }
        Err(e) => assert!(e.is_bad_input() && !e.to_string().is_empty()),
    }
    if let Err(e) = Trace::from_json(text) {
        assert!(e.is_bad_input() && !e.to_string().is_empty());
    }
});
