//! The engine's errors as the exceptions of `carom.errors`.

use carom::ShotFile;
use carom::error::Error;
use carom_arena::ArenaError;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

use crate::exceptions::{EndlessMotionError, EventCapError, InputError};
use crate::node::to_python;

/// The exception for `error`.
pub(crate) fn to_exception(py: Python<'_>, error: &Error) -> PyErr {
    let text = error.to_string();
    match error {
        Error::TooManyEvents(cap) => {
            let file = ShotFile::from_json(&cap.shot)
                .map_err(|e| to_exception(py, &e))
                .and_then(|shot| to_python(py, &shot.to_node()).map(Bound::unbind));
            match file {
                Ok(file) if error.is_bad_input() => EndlessMotionError::new_err((text, file)),
                Ok(file) => EventCapError::new_err((text, file)),
                Err(other) => other,
            }
        }
        _ => InputError::new_err(text),
    }
}

/// The exception for an error of a match: Python's own for a file.
pub(crate) fn arena_exception(py: Python<'_>, error: &ArenaError) -> PyErr {
    match error {
        ArenaError::Input(error) => to_exception(py, error),
        ArenaError::File { path, error } => {
            let code = error.raw_os_error();
            let words = |code| py.import("os")?.call_method1("strerror", (code,))?.extract();
            let text = code.map_or_else(|| Ok(error.to_string()), words);
            text.map_or_else(
                |raised| raised,
                |text: String| PyOSError::new_err((code, text, path.clone())),
            )
        }
        other => InputError::new_err(other.to_string()),
    }
}
