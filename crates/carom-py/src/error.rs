//! The engine's errors as the exceptions of `carom.errors`.

use carom::ShotFile;
use carom::error::Error;
use pyo3::prelude::*;

use crate::exceptions::{EventCapError, InputError};
use crate::node::to_python;

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
