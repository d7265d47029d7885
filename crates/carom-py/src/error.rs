//! The engine's errors as the exceptions of `carom.errors`.

use carom::ShotFile;
use carom::error::{Error, ErrorDetail, InputError as InputErrorParts};
use carom_arena::ArenaError;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::exceptions::{CaromError, EndlessMotionError, EventCapError, InputError};
use crate::node::to_python;

/// The exception for `error`.
pub(crate) fn to_exception(py: Python<'_>, error: &Error) -> PyErr {
    match error {
        Error::TooManyEvents(cap) => {
            let file = ShotFile::from_json(&cap.shot)
                .map_err(|e| to_exception(py, &e))
                .and_then(|shot| to_python(py, &shot.to_node()).map(Bound::unbind));
            match file {
                Ok(file) => {
                    let parts = (cap.place(), cap.what(), cap.remedy(), file);
                    if error.is_bad_input() {
                        EndlessMotionError::new_err(parts)
                    } else {
                        EventCapError::new_err(parts)
                    }
                }
                Err(other) => other,
            }
        }
        Error::Input(input) => {
            let detail = |(key, value): &(&'static str, ErrorDetail)| match value {
                ErrorDetail::Text(text) => (*key, text.into_py_any(py)),
                ErrorDetail::Number(number) => (*key, number.into_py_any(py)),
            };
            let details = PyDict::new(py);
            for (key, value) in input.details.iter().map(detail) {
                if let Err(raised) = value.and_then(|value| details.set_item(key, value)) {
                    return raised;
                }
            }
            let InputErrorParts { kind, place, what, remedy, .. } = &**input;
            InputError::new_err((
                kind.name(),
                place.clone(),
                what.clone(),
                remedy.clone(),
                details.unbind(),
            ))
        }
        other => CaromError::new_err(other.to_string()),
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
        other => CaromError::new_err(other.to_string()),
    }
}
