//! The engine's errors as exceptions.

use carom::error::{Error, ErrorDetail};
use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;

/// An `Error` with the engine's message, and with `kind`, `place`, `fault`, `remedy` and `details`. A
/// shot that reached its cap of events also has a `shot` (JSON).
pub(crate) fn to_exception(error: &Error) -> JsValue {
    let exception = js_sys::Error::new(&error.to_string());
    let set = |key: &str, value: &JsValue| {
        // Setting a key of a new object cannot fail.
        let _ = Reflect::set(&exception, &key.into(), value);
    };
    let parts = |place: &str, fault: &str, remedy: &str| {
        set("place", &place.into());
        set("fault", &fault.into());
        set("remedy", &remedy.into());
    };
    let details = Object::new();
    set("kind", &error.kind().name().into());
    match error {
        Error::Input(input) => {
            parts(&input.place, &input.what, &input.remedy);
            for (key, value) in &input.details {
                let value = match value {
                    ErrorDetail::Text(text) => text.into(),
                    ErrorDetail::Number(number) => (*number).into(),
                };
                let _ = Reflect::set(&details, &(*key).into(), &value);
            }
        }
        Error::TooManyEvents(cap) => {
            parts(cap.place(), &cap.what(), cap.remedy());
            set("shot", &(&cap.shot).into());
        }
        _ => {}
    }
    set("details", &details);
    exception.into()
}
