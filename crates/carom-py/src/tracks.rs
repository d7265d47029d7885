//! `_core.Candidates`, `_core.BallTracks`, and the states and residuals of candidates.

use std::array::from_fn;

use carom::candidates::{Candidates as EngineCandidates, Variation};
use carom::error::Error;
use carom::format::PhysicsNumber;
use carom::math::Vec3;
use carom::shot::StartState;
use carom::tracks::{self, BallTrack, StateQuestion, TrackFrame, TrackQuestion};
use numpy::ndarray::{ArrayView1, ArrayView2, ArrayView3};
use numpy::{
    PyArray1, PyArray2, PyArray3, PyArray4, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2,
    PyReadonlyArray3,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::batch::runner;
use crate::error::to_exception;
use crate::shot::{Shot, strike_of};

/// Variants of shots; immutable.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Candidates(EngineCandidates);

/// Position, velocity and spin, each (candidates, balls, 3).
type States<'py> =
    (PyReadonlyArray3<'py, f64>, PyReadonlyArray3<'py, f64>, PyReadonlyArray3<'py, f64>);

#[pymethods]
impl Candidates {
    /// `shot_of` is the index of each candidate's shot. `values` are those of the physics' `numbers`,
    /// (candidates, numbers). `strikes` are rows of speed, azimuth, elevation, side, height; with
    /// `own_elevation` the elevations are those that the shots give them.
    #[new]
    fn new(
        py: Python<'_>,
        shots: Vec<PyRef<'_, Shot>>,
        shot_of: PyReadonlyArray1<'_, u32>,
        numbers: Vec<String>,
        values: PyReadonlyArray2<'_, f64>,
        states: Option<States<'_>>,
        strikes: Option<(PyReadonlyArray2<'_, f64>, bool)>,
    ) -> PyResult<Self> {
        let shots = shots.iter().map(|shot| shot.0.shot().clone()).collect();
        let numbers: Result<Vec<_>, Error> =
            numbers.iter().map(|key| PhysicsNumber::find(key)).collect();
        let (strikes, default_elevation) = match &strikes {
            Some((rows, own)) => (Some(rows_of(&rows.as_array(), strike_of)), *own),
            None => (None, false),
        };
        let variation = Variation {
            numbers: numbers.map_err(|e| to_exception(py, &e.inside("physics")))?,
            values: values.as_array().iter().copied().collect(),
            states: states.as_ref().map(starts),
            strikes,
            default_elevation,
        };
        EngineCandidates::new(shots, shot_of.as_array().to_vec(), variation)
            .map(Self)
            .map_err(|e| to_exception(py, &e))
    }

    /// Candidate `index` as a shot.
    fn shot(&self, py: Python<'_>, index: usize) -> PyResult<Shot> {
        let shot = self.0.shot(index).map_err(|e| to_exception(py, &e))?;
        Ok(shot.into_owned().into())
    }

    /// Candidates from one index up to but not including another.
    fn part(&self, first: usize, end: usize) -> Self {
        Self(self.0.part(first, end))
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}

/// Observed positions of balls; immutable.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct BallTracks(tracks::BallTracks);

/// Times (n), positions (n, 2), standard deviations (n).
type Observed<'py> =
    (PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, f64>);

#[pymethods]
impl BallTracks {
    /// The tracks of balls by their ids.
    #[new]
    fn new(py: Python<'_>, balls: Vec<(String, Observed<'_>)>) -> PyResult<Self> {
        let track = |(id, (times, positions, sigmas)): &(String, Observed<'_>)| BallTrack {
            id: id.clone(),
            times: times.as_array().to_vec(),
            positions: rows_of(&positions.as_array(), |row: [f64; 2]| row),
            sigmas: sigmas.as_array().to_vec(),
        };
        tracks::BallTracks::new(balls.iter().map(track).collect())
            .map(Self)
            .map_err(|e| to_exception(py, &e))
    }

    /// Number of samples of each ball up to each horizon, s.
    fn counts(&self, horizons: Vec<f64>) -> Vec<Vec<usize>> {
        let balls = 0..self.0.ids().len();
        balls.map(|ball| horizons.iter().map(|&h| self.0.count(ball, h)).collect()).collect()
    }
}

/// The start states of a shot: position, velocity and spin, each (balls, 3).
#[pyfunction]
pub(crate) fn start_states<'py>(
    py: Python<'py>,
    shot: &Shot,
) -> PyResult<[Bound<'py, PyArray2<f64>>; 3]> {
    let balls = shot.0.balls();
    let array = |of: fn(&carom::BallState) -> Vec3| {
        let flat = balls.iter().flat_map(|ball| of(&ball.state).to_array()).collect();
        PyArray1::from_vec(py, flat).reshape([balls.len(), 3])
    };
    Ok([array(|s| s.position)?, array(|s| s.velocity)?, array(|s| s.angular_velocity)?])
}

type Cube<'py> = Bound<'py, PyArray4<f64>>;
type Sampled<'py> = (
    Cube<'py>,
    Option<Cube<'py>>,
    Option<Cube<'py>>,
    Bound<'py, PyArray3<bool>>,
    Bound<'py, PyDict>,
);

/// Positions, velocities and spins (candidates, times, balls, 3), whether they are in play
/// (candidates, times, balls), and errors by index. `times` has one row, or one for each candidate.
#[pyfunction]
pub(crate) fn sample_states<'py>(
    py: Python<'py>,
    candidates: &Candidates,
    times: PyReadonlyArray2<'py, f64>,
    balls: Vec<usize>,
    velocity: bool,
    angular_velocity: bool,
    threads: usize,
) -> PyResult<Sampled<'py>> {
    let runner = runner(py, threads)?;
    let candidates = &candidates.0;
    let count = times.as_array().ncols();
    let times: Vec<f64> = times.as_array().iter().copied().collect();
    let question =
        StateQuestion { times: &times, count, balls: &balls, velocity, angular_velocity };
    let found = py
        .detach(|| tracks::sample_states(candidates, &question, &runner))
        .map_err(|e| to_exception(py, &e))?;
    let shape = [candidates.len(), count, balls.len(), 3];
    let cube = |rows: Vec<[f64; 3]>| PyArray1::from_vec(py, rows.into_flattened()).reshape(shape);
    Ok((
        cube(found.position)?,
        velocity.then(|| cube(found.velocity)).transpose()?,
        angular_velocity.then(|| cube(found.angular_velocity)).transpose()?,
        PyArray1::from_vec(py, found.in_play).reshape([shape[0], shape[1], shape[2]])?,
        texts(py, found.errors)?,
    ))
}

type Differences<'py> = (
    Option<Bound<'py, PyArray3<f64>>>,
    Bound<'py, PyArray3<f64>>,
    Bound<'py, PyArray2<u32>>,
    Bound<'py, PyDict>,
);

/// Residuals (candidates, samples, 2), their sums (candidates, tracks, horizons), samples out of play
/// (candidates, tracks), and errors by index. `tracks` are one for all shots, or one for each.
/// `placement` has one row, or one for each candidate: clock, offset x and y, rotation, scale. Without
/// `samples` there are no residuals.
#[pyfunction]
pub(crate) fn track_residuals<'py>(
    py: Python<'py>,
    candidates: &Candidates,
    tracks: Vec<Py<BallTracks>>,
    placement: PyReadonlyArray2<'py, f64>,
    horizons: Vec<f64>,
    samples: bool,
    threads: usize,
) -> PyResult<Differences<'py>> {
    let runner = runner(py, threads)?;
    let candidates = &candidates.0;
    let tracks: Vec<&tracks::BallTracks> = tracks.iter().map(|tracks| &tracks.get().0).collect();
    let placement = placement.as_array();
    let clocks: Vec<f64> = placement.column(0).to_vec();
    let frames = rows_of(&placement, |[_, x, y, rotation, scale]: [f64; 5]| TrackFrame {
        offset: [x, y],
        rotation,
        scale,
    });
    let question = TrackQuestion { clocks: &clocks, frames: &frames, horizons: &horizons, samples };
    let found = py
        .detach(|| tracks::track_residuals(candidates, &tracks, &question, &runner))
        .map_err(|e| to_exception(py, &e))?;
    let count = candidates.len();
    let residual = samples.then(|| {
        let flat = found.residual.into_flattened();
        PyArray1::from_vec(py, flat).reshape([count, found.samples, 2])
    });
    Ok((
        residual.transpose()?,
        PyArray1::from_vec(py, found.sum).reshape([count, found.tracks, horizons.len()])?,
        PyArray1::from_vec(py, found.out_of_play).reshape([count, found.tracks])?,
        texts(py, found.errors)?,
    ))
}

/// The messages of errors by index.
fn texts<'py>(py: Python<'py>, errors: Vec<(usize, Error)>) -> PyResult<Bound<'py, PyDict>> {
    let texts = PyDict::new(py);
    for (index, error) in errors {
        texts.set_item(index, error.to_string())?;
    }
    Ok(texts)
}

/// The rows of an array with N columns.
fn rows_of<const N: usize, T>(array: &ArrayView2<'_, f64>, row: impl Fn([f64; N]) -> T) -> Vec<T> {
    let numbers = |values: ArrayView1<'_, f64>| from_fn(|k| values[k]);
    array.rows().into_iter().map(|values| row(numbers(values))).collect()
}

/// One start state for each ball of each candidate.
fn starts(states: &States<'_>) -> Vec<StartState> {
    let (position, velocity, spin) = states;
    let vectors = |array: &ArrayView3<'_, f64>| -> Vec<Vec3> {
        let numbers = |values: ArrayView1<'_, f64>| Vec3::new(values[0], values[1], values[2]);
        array.rows().into_iter().map(numbers).collect()
    };
    let [positions, velocities, spins] =
        [position, velocity, spin].map(|array| vectors(&array.as_array()));
    let columns = positions.into_iter().zip(velocities).zip(spins);
    let state = |((position, velocity), angular_velocity)| StartState {
        position,
        velocity,
        angular_velocity,
    };
    columns.map(state).collect()
}
