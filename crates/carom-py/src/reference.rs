//! What the engine knows by itself: table presets and schemas.

use carom::shot::Node;
use carom::{Shot, Table};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::table::geometry;

/// Every preset's geometry.
#[pyfunction]
pub(crate) fn tables(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let presets = carom::table::presets::all();
    to_python(py, &Node::List(presets.iter().map(geometry).collect()))
}
