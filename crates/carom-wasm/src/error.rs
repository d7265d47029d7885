//! The engine's errors as exceptions.

use carom::error::Error;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

/// An `Error` with the engine's message. Refused input has a `place`; a shot that reached its cap of
/// events has a `shot` (JSON).
pub(crate) fn to_exception(error: &Error) -> JsValue {
    let exception = js_sys::Error::new(&error.to_string());
    let (key, value) = match error {
        Error::Input(input) => ("place", &input.place),
        Error::TooManyEvents { shot, .. } => ("shot", shot),
        _ => return exception.into(),
    };
    // Setting a key of a new object cannot fail.
    let _ = Reflect::set(&exception, &key.into(), &value.into());
    exception.into()
}
