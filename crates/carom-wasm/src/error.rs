//! The engine's errors as exceptions.

use carom::error::Error;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

/// An `Error` with the engine's message. Refused input has a `place`; a shot that reached its cap of
/// events has a `shot` (JSON), and its input a `place` if nothing but an end time stops it.
pub(crate) fn to_exception(error: &Error) -> JsValue {
    let exception = js_sys::Error::new(&error.to_string());
    let set = |key: &str, value: &str| {
        // Setting a key of a new object cannot fail.
        let _ = Reflect::set(&exception, &key.into(), &value.into());
    };
    match error {
        Error::Input(input) => set("place", &input.place),
        Error::TooManyEvents(cap) => {
            set("shot", &cap.shot);
            if error.is_bad_input() {
                set("place", "until");
            }
        }
        _ => {}
    }
    exception.into()
}
