//! The engine's errors as the exceptions of `carom.errors`.

use carom::ShotFile;
use carom::error::Error;
use pyo3::prelude::*;

use crate::exceptions::{EventCapError, InputError};
use crate::node::to_python;

/// The exception for an `error` of simulating `file`. At the cap of events it has the file as it was
/// written.
pub(crate) fn to_exception_of(py: Python<'_>, error: &Error, file: &ShotFile) -> PyErr {
    if let Error::TooManyEvents { .. } = error {
        return match to_python(py, &file.to_node()) {
            Ok(file) => EventCapError::new_err((error.to_string(), file.unbind())),
            Err(other) => other,
        };
    }
    to_exception(py, error)
}

/// The exception for `error`.
pub(crate) fn to_exception(py: Python<'_>, error: &Error) -> PyErr {
    let text = error.to_string();
    match error {
        Error::TooManyEvents { shot, .. } => {
            let file = ShotFile::from_json(shot)
                .map_err(|e| to_exception(py, &e))
                .and_then(|shot| to_python(py, &shot.to_node()).map(Bound::unbind));
            match file {
                Ok(file) => EventCapError::new_err((text, file)),
                Err(other) => other,
            }
        }
        _ => InputError::new_err(text),
    }
}
