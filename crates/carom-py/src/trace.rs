//! `_core.Trace`.

use carom::BallState;
use carom::math::Vec3;
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::shot::Shot;

/// A simulated shot with all its events; immutable.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Trace(pub(crate) carom::Trace);

type Cube<'py> = Bound<'py, PyArray3<f64>>;

#[pymethods]
impl Trace {
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        carom::Trace::from_json(text).map(Self).map_err(|e| to_exception(py, &e))
    }

    #[staticmethod]
    fn from_object(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        carom::Trace::from_node(&from_python(value)?)
            .map(Self)
            .map_err(|e| to_exception(value.py(), &e))
    }

    fn to_object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.0.to_node())
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    fn shot(&self) -> Shot {
        Shot(self.0.shot().clone().into())
    }

    /// Position, velocity, spin, each (times, balls, 3), and motions, (times × balls).
    fn at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Cube<'py>, Cube<'py>, Cube<'py>, Vec<&'static str>)> {
        let times = times.as_array();
        let shape = [times.len(), self.0.shot().balls().len(), 3];
        let mut states: Vec<BallState> = Vec::with_capacity(shape[0] * shape[1]);
        for &time in times {
            states.extend(self.0.at(time).map_err(|e| to_exception(py, &e))?);
        }
        let cube = |of: fn(&BallState) -> Vec3| {
            let flat = states.iter().flat_map(|s| of(s).to_array()).collect::<Vec<f64>>();
            PyArray1::from_vec(py, flat).reshape(shape)
        };
        Ok((
            cube(|s| s.position)?,
            cube(|s| s.velocity)?,
            cube(|s| s.angular_velocity)?,
            states.iter().map(|s| s.motion.name()).collect(),
        ))
    }

    /// Where the two part first, in one sentence; None if they are the same to the bit.
    fn first_difference(&self, again: &Self) -> Option<String> {
        self.0.first_difference(&again.0)
    }

    #[getter]
    fn duration(&self) -> f64 {
        self.0.duration()
    }

    #[getter]
    fn hash(&self) -> String {
        format!("{:016x}", self.0.hash())
    }

    fn __len__(&self) -> usize {
        self.0.events().len()
    }
}
