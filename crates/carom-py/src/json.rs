//! JSON text of files.

use carom::format::Node;
use pyo3::prelude::*;

use crate::error::to_exception;

/// JSON text of at most `most` bytes as a tree. The error of a syntax fault names the `file` of the text, if
/// it has one.
pub(crate) fn read(py: Python<'_>, text: &str, file: Option<&str>, most: usize) -> PyResult<Node> {
    Node::from_json_within(text, most).map_err(|error| {
        let error = match file {
            Some(file) => error.in_file(file),
            None => error,
        };
        to_exception(py, &error)
    })
}
