//! Speed bands from a measured law of rolling resistance.

use carom::physics::{RollingLaw, RollingTolerance};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::to_python;

/// The value of `physics.cloth.rolling_friction` that follows the law (a, b) within the tolerance
/// (fastest, share, least).
#[pyfunction]
pub(crate) fn rolling_bands(
    py: Python<'_>,
    law: (f64, f64),
    tolerance: (f64, f64, f64),
    gravity: f64,
) -> PyResult<Bound<'_, PyAny>> {
    let (fastest, share, least) = tolerance;
    let bands = RollingLaw { a: law.0, b: law.1 }
        .bands(gravity, &RollingTolerance { fastest, share, least })
        .map_err(|e| to_exception(py, &e))?;
    to_python(py, &bands.to_node())
}
