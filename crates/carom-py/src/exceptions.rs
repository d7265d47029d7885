//! The exceptions of `carom.errors`.

use carom::ErrorKind;
use pyo3::PyErr;

pyo3::import_exception!(carom.errors, CaromError);
pyo3::import_exception!(carom.errors, EndlessMotionError);
pyo3::import_exception!(carom.errors, EventCapError);
pyo3::import_exception!(carom.errors, InputError);

/// The exception for bad input that is found here.
pub(crate) fn refuse(kind: ErrorKind, place: &str, what: &str, remedy: &str) -> PyErr {
    InputError::new_err((kind.name(), place.to_owned(), what.to_owned(), remedy.to_owned()))
}
