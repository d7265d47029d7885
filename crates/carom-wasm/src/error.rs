//! The engine's errors as exceptions.

use carom::error::Error;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

/// An `Error` with the engine's sentence. Its `place` is there for refused input, its `shot` (JSON) for
/// a shot that reached its cap of events.
pub(crate) fn to_exception(error: &Error) -> JsValue {
    let exception = js_sys::Error::new(&error.to_string());
    let (key, value) = match error {
        Error::Input(input) => ("place", &input.place),
        Error::TooManyEvents { shot, .. } => ("shot", shot),
        _ => return exception.into(),
    };
    // An object that was just made takes any key.
    let _ = Reflect::set(&exception, &key.into(), &value.into());
    exception.into()
}
