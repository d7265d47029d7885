//! `_core.Trace` and `_core.simulate`.

use std::sync::{Arc, OnceLock};

use carom::format::Node;
use carom::limits::MOST_BYTES;
use carom::math::Vec3;
use carom::trace::{Orientations, Waypoint};
use carom::{BallState, Error, ShotFile};
use carom_plan::{CaromRoute, DiamondReading};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::json;
use crate::node::{PlainNode, from_python, to_python};
use crate::shot::Shot;

/// A simulated shot with all its events; immutable.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Trace {
    trace: carom::Trace,
    shot: Arc<ShotFile>,
    orientations: OnceLock<Orientations>,
}

impl From<carom::Trace> for Trace {
    fn from(trace: carom::Trace) -> Self {
        let shot = ShotFile::from(trace.shot().clone());
        Self::new(trace, shot.into())
    }
}

impl Trace {
    /// A trace of `shot`.
    pub(crate) fn new(trace: carom::Trace, shot: Arc<ShotFile>) -> Self {
        Self { trace, shot, orientations: OnceLock::new() }
    }

    /// The trace itself.
    pub(crate) const fn trace(&self) -> &carom::Trace {
        &self.trace
    }

    fn read(node: &Node) -> Result<Self, Error> {
        let (trace, shot) = carom::Trace::from_node_with_file(node)?;
        Ok(Self::new(trace, shot.into()))
    }

    fn to_node(&self) -> Node {
        self.trace.to_node_with(self.shot.to_node().into_owned())
    }
}

/// The trace of a shot.
#[pyfunction]
pub(crate) fn simulate(py: Python<'_>, shot: &Shot) -> PyResult<Trace> {
    let trace = py.detach(|| shot.0.simulate()).map_err(|e| to_exception(py, &e))?;
    Ok(Trace::new(trace, shot.0.clone()))
}

/// The trace of a shot, up to its cap of events if it reaches it.
#[pyfunction]
pub(crate) fn simulate_to_cap(py: Python<'_>, shot: &Shot) -> PyResult<Trace> {
    let (trace, _) = py.detach(|| shot.0.simulate_to_cap()).map_err(|e| to_exception(py, &e))?;
    Ok(Trace::new(trace, shot.0.clone()))
}

type Cube<'py> = Bound<'py, PyArray3<f64>>;
type States<'py> = (Cube<'py>, Cube<'py>, Cube<'py>, Cube<'py>, Vec<&'static str>);

#[pymethods]
impl Trace {
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str, file: Option<&str>) -> PyResult<Self> {
        let node = json::read(py, text, file, MOST_BYTES)?;
        Self::read(&node).map_err(|e| to_exception(py, &e))
    }

    #[staticmethod]
    fn from_object(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::read(&from_python(value)?).map_err(|e| to_exception(value.py(), &e))
    }

    fn to_object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.to_node())
    }

    fn to_json(&self) -> String {
        self.to_node().to_json()
    }

    fn shot(&self) -> Shot {
        Shot(self.shot.clone())
    }

    /// Position, velocity and spin of shape (times, balls, 3), orientation of shape (times, balls, 4), and
    /// motions (times × balls).
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<States<'py>> {
        let times = times.as_array();
        let balls = self.trace.shot().balls().len();
        let orientations = self.orientations.get_or_init(|| self.trace.orientations());
        let mut states: Vec<BallState> = Vec::with_capacity(times.len() * balls);
        let mut turned: Vec<[f64; 4]> = Vec::with_capacity(times.len() * balls);
        for &time in times {
            states.extend(self.trace.at(time).map_err(|e| to_exception(py, &e))?);
            turned.extend((0..balls).map(|ball| orientations.at(ball, time)));
        }
        let cube = |of: fn(&BallState) -> Vec3| {
            let flat = states.iter().flat_map(|s| of(s).to_array()).collect::<Vec<f64>>();
            PyArray1::from_vec(py, flat).reshape([times.len(), balls, 3])
        };
        Ok((
            cube(|s| s.position)?,
            cube(|s| s.velocity)?,
            cube(|s| s.angular_velocity)?,
            PyArray1::from_vec(py, turned.into_flattened()).reshape([times.len(), balls, 4])?,
            states.iter().map(|s| s.motion.name()).collect(),
        ))
    }

    /// x, y, z (m), t (s) per point of the path of the ball with this index, (points, 4).
    fn polyline<'py>(
        &self,
        py: Python<'py>,
        ball: usize,
        tolerance: f64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = self.trace.polyline(ball, tolerance);
        let numbers = |p: &Waypoint| {
            let [x, y, z] = p.position.to_array();
            [x, y, z, p.time]
        };
        PyArray1::from_vec(py, points.iter().flat_map(numbers).collect()).reshape([points.len(), 4])
    }

    /// What a diamond system says of the way of a ball behind an event, or from the beginning; None if no system fits.
    fn diamond_reading(&self, ball: u16, event: Option<usize>) -> Option<PlainNode> {
        DiamondReading::new(&self.trace, ball, event).map(|found| PlainNode(found.to_node()))
    }

    /// The route of the cue ball to its second object ball; None if it meets fewer than two.
    fn carom_route(&self) -> Option<PlainNode> {
        let balls = self.trace.shot().balls();
        let id = |ball| balls[usize::from(ball)].id.as_str();
        CaromRoute::new(&self.trace).map(|route| PlainNode(route.to_node(id)))
    }

    /// The first difference of two traces, in one sentence; None if they are equal to the bit.
    fn first_difference(&self, again: &Self) -> Option<String> {
        self.trace.first_difference(&again.trace)
    }

    #[getter]
    fn duration(&self) -> f64 {
        self.trace.duration()
    }

    #[getter]
    fn end(&self) -> &'static str {
        self.trace.end().name()
    }

    #[getter]
    fn hash(&self) -> String {
        format!("{:016x}", self.trace.hash())
    }

    fn __len__(&self) -> usize {
        self.trace.events().len()
    }
}
