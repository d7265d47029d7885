//! `_core.simulate_batch`, `_core.simulate_strikes`, noise and perception.

use std::array::from_fn;

use carom::Noise;
use carom::batch::{self, BatchResult};
use carom::noise::SKILLS;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::to_exception;
use crate::options::{NoiseOptions, PerceptionOptions, count};
use crate::shot::{Shot, strike_of};

pub(crate) type Arrays<'py> = (
    Bound<'py, PyArray3<f64>>,
    Bound<'py, PyArray2<i8>>,
    Bound<'py, PyArray1<i32>>,
    Bound<'py, PyDict>,
);

/// Final positions (shots, balls, 3), pockets (shots, balls), events (shots), errors by index.
/// `threads` 0 is one per core.
#[pyfunction]
pub(crate) fn simulate_batch<'py>(
    py: Python<'py>,
    shots: Vec<PyRef<'py, Shot>>,
    threads: usize,
) -> PyResult<Arrays<'py>> {
    let shots: Vec<_> = shots.iter().map(|shot| shot.0.clone()).collect();
    let shots: Vec<&carom::Shot> = shots.iter().map(|shot| shot.shot()).collect();
    let runner = runner(py, threads)?;
    let result = py.detach(|| batch::simulate_batch(&shots, &runner));
    arrays(py, result)
}

/// The same for one shot with other strikes: rows of speed, azimuth, elevation, side, height. With
/// `own_elevation` the elevations are those that the shot gives the strikes.
#[pyfunction]
pub(crate) fn simulate_strikes<'py>(
    py: Python<'py>,
    shot: &Shot,
    strikes: PyReadonlyArray2<'py, f64>,
    own_elevation: bool,
    threads: usize,
) -> PyResult<Arrays<'py>> {
    let strikes = strikes_of(&strikes);
    let runner = runner(py, threads)?;
    let simulate =
        if own_elevation { batch::simulate_at_own_elevation } else { batch::simulate_strikes };
    let result = py.detach(|| simulate(&shot.0, &strikes, &runner));
    arrays(py, result)
}

/// The same on the layouts of `perception` and `seed` from number `first` on.
#[pyfunction]
pub(crate) fn simulate_seen<'py>(
    py: Python<'py>,
    shot: &Shot,
    strikes: PyReadonlyArray2<'py, f64>,
    perception: PerceptionOptions,
    seed: u64,
    first: u64,
    threads: usize,
) -> PyResult<Arrays<'py>> {
    let strikes = strikes_of(&strikes);
    let (perception, runner) = (perception.perception(), runner(py, threads)?);
    let result =
        py.detach(|| batch::simulate_seen(&shot.0, &strikes, &perception, seed, first, &runner));
    arrays(py, result.map_err(|e| to_exception(py, &e))?)
}

fn strikes_of(rows: &PyReadonlyArray2<'_, f64>) -> Vec<Strike> {
    let strike = |row: numpy::ndarray::ArrayView1<'_, f64>| strike_of(from_fn(|k| row[k]));
    rows.as_array().rows().into_iter().map(strike).collect()
}

/// `n` executions of the shot's own strike under `noise`, from number `first` of `seed` on: rows as
/// `simulate_strikes` takes them.
#[pyfunction]
pub(crate) fn draw_strikes<'py>(
    py: Python<'py>,
    shot: &Shot,
    noise: NoiseOptions,
    n: usize,
    seed: u64,
    first: u64,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let strikes = batch::draw_strikes(&shot.0, &noise.noise(), n, seed, first)
        .map_err(|e| to_exception(py, &e))?;
    let row = |s: Strike| [s.speed, s.azimuth, s.elevation, s.side, s.height];
    PyArray1::from_vec(py, strikes.into_iter().flat_map(row).collect()).reshape([n, 5])
}

/// Rejects an invalid standard deviation of positions.
#[pyfunction]
pub(crate) fn check_perception(py: Python<'_>, perception: PerceptionOptions) -> PyResult<()> {
    perception.perception().check().map_err(|e| to_exception(py, &e))
}

/// Rejects invalid standard deviations of a strike.
#[pyfunction]
pub(crate) fn check_noise(py: Python<'_>, noise: NoiseOptions) -> PyResult<()> {
    noise.noise().check().map_err(|e| to_exception(py, &e))
}

/// The shot with its balls where they are perceived: layout number `index` of `seed`.
#[pyfunction]
pub(crate) fn see(
    py: Python<'_>,
    shot: &Shot,
    perception: PerceptionOptions,
    seed: u64,
    index: u64,
) -> PyResult<Shot> {
    let seen = perception.perception().draw(&shot.0, seed, index);
    seen.map(Shot::from).map_err(|e| to_exception(py, &e))
}

/// The σ of the Computational Olympiad's noise: speed, azimuth, elevation, side, height.
#[pyfunction]
pub(crate) fn olympiad(multiplier: f64) -> [f64; 5] {
    let Noise { speed, azimuth, elevation, side_m: side, height_m: height } =
        Noise::olympiad(multiplier);
    [speed, azimuth, elevation, side, height]
}

/// The names of the noise presets and their σ: speed, azimuth, elevation, side, height.
#[pyfunction]
pub(crate) fn noise_presets() -> Vec<(&'static str, [f64; 5])> {
    let olympiad = ("olympiad", Noise::olympiad(1.0));
    let all = SKILLS.into_iter().chain([olympiad]);
    all.map(|(name, n)| (name, [n.speed, n.azimuth, n.elevation, n.side_m, n.height_m])).collect()
}

/// The runner of `threads` threads; 0 is one per core.
fn runner(py: Python<'_>, threads: usize) -> PyResult<Runner> {
    Runner::new(count(threads)).map_err(|e| to_exception(py, &e))
}

pub(crate) fn arrays<'py>(py: Python<'py>, result: BatchResult) -> PyResult<Arrays<'py>> {
    let BatchResult { shots, balls, final_position, pocket, events, errors } = result;
    let texts = PyDict::new(py);
    for (index, error) in errors {
        texts.set_item(index, error.to_string())?;
    }
    let flat = final_position.into_iter().flatten().collect::<Vec<f64>>();
    Ok((
        PyArray1::from_vec(py, flat).reshape([shots, balls, 3])?,
        PyArray1::from_vec(py, pocket).reshape([shots, balls])?,
        PyArray1::from_vec(py, events),
        texts,
    ))
}
