//! `_core.simulate_batch`, `_core.simulate_strikes`, noise and perception.

use std::array::from_fn;

use carom::batch::{self, BatchResult};
use carom::noise::{Errors, SKILLS};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{ErrorKind, Noise};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::device::CudaDevice;
use crate::error::to_exception;
use crate::options::{NoiseOptions, PerceptionOptions, count, numbers_of};
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
    device: Option<PyRef<'py, CudaDevice>>,
) -> PyResult<Arrays<'py>> {
    let shots: Vec<_> = shots.iter().map(|shot| shot.0.clone()).collect();
    let shots: Vec<&carom::Shot> = shots.iter().map(|shot| shot.shot()).collect();
    let runner = runner_on(py, threads, device)?;
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
    device: Option<PyRef<'py, CudaDevice>>,
) -> PyResult<Arrays<'py>> {
    let strikes = strikes_of(&strikes);
    let runner = runner_on(py, threads, device)?;
    let simulate =
        if own_elevation { batch::simulate_at_own_elevation } else { batch::simulate_strikes };
    let result = py.detach(|| simulate(&shot.0, &strikes, &runner));
    arrays(py, result)
}

/// The same with the layouts of `perception` and the cling of `noise`; `draw`: the seed and the number
/// of the first variant.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the variants, threads and device")]
pub(crate) fn simulate_variants<'py>(
    py: Python<'py>,
    shot: &Shot,
    strikes: PyReadonlyArray2<'py, f64>,
    noise: NoiseOptions,
    perception: PerceptionOptions,
    draw: (u64, u64),
    threads: usize,
    device: Option<PyRef<'py, CudaDevice>>,
) -> PyResult<Arrays<'py>> {
    let (strikes, runner) = (strikes_of(&strikes), runner_on(py, threads, device)?);
    let (noise, perception, (seed, first)) = (noise.noise(), perception.perception(), draw);
    let errors = Errors { noise, perception, seed };
    let result = py.detach(|| batch::simulate_variants(&shot.0, &strikes, &errors, first, &runner));
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
pub(crate) fn check_noise(noise: &Bound<'_, PyAny>) -> PyResult<()> {
    // Not an argument, whose error would have a note about the argument.
    let options: NoiseOptions = noise.extract()?;
    options.noise().check().map_err(|e| to_exception(noise.py(), &e))
}

/// The mean and the standard deviations of the errors of a strike with this speed (m/s).
#[pyfunction]
pub(crate) fn noise_moments(noise: NoiseOptions, speed: f64) -> ([f64; 5], [f64; 5]) {
    let noise = noise.noise();
    (noise.mean(), noise.deviations(speed))
}

/// The shot with the strike and the cling of variant `index` of `seed`.
#[pyfunction]
pub(crate) fn variant(
    py: Python<'_>,
    shot: &Shot,
    noise: NoiseOptions,
    seed: u64,
    index: u64,
) -> PyResult<Shot> {
    let drawn = batch::draw_variant(&shot.0, &noise.noise(), seed, index);
    drawn.map(|drawn| Shot(drawn.into())).map_err(|e| to_exception(py, &e))
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

/// The Computational Olympiad's noise: the fields of `carom.Noise`, in order.
#[pyfunction]
pub(crate) fn olympiad(multiplier: f64) -> [f64; 7] {
    numbers_of(&Noise::olympiad(multiplier))
}

/// The names of the noise presets, and the fields of `carom.Noise`, in order.
#[pyfunction]
pub(crate) fn noise_presets() -> Vec<(&'static str, [f64; 7])> {
    let olympiad = ("olympiad", Noise::olympiad(1.0));
    let all = SKILLS.iter().chain([&olympiad]);
    all.map(|(name, noise)| (*name, numbers_of(noise))).collect()
}

/// The runner of `threads` threads; 0 is one per core.
pub(crate) fn runner(py: Python<'_>, threads: usize) -> PyResult<Runner> {
    Runner::new(count(threads)).map_err(|e| to_exception(py, &e))
}

/// The same, with `device` for batches.
pub(crate) fn runner_on(
    py: Python<'_>,
    threads: usize,
    device: Option<PyRef<'_, CudaDevice>>,
) -> PyResult<Runner> {
    let runner = runner(py, threads)?;
    Ok(match device {
        Some(device) => runner.on(device.0.clone()),
        None => runner,
    })
}

pub(crate) fn arrays<'py>(py: Python<'py>, result: BatchResult) -> PyResult<Arrays<'py>> {
    let BatchResult { shots, balls, final_position, pocket, events, errors } = result;
    let texts = PyDict::new(py);
    for (index, error) in errors {
        // The device has failed, not the shot.
        if error.kind() == ErrorKind::System {
            return Err(to_exception(py, &error));
        }
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
