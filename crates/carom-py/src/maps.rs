//! `_core.pot_map`, `position_map`, `acceptance`, `breaks`, `kick_table` and `bank_table`.

use carom::rack::{Break, Game};
use carom::table::Rail;
use carom_plan::breaks;
use carom_plan::cushions::{self, CushionContact, Kicks};
use carom_plan::maps::{self, Accepted, Approaches, PotTarget};
use carom_plan::{Chance, Interval};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::batch::{Arrays, arrays};
use crate::error::to_exception;
use crate::options::{SamplingOptions, count};
use crate::plan::drawn;
use crate::progress;
use crate::shot::Shot;

/// Chance, the ends of its interval, variants, azimuth: arrays of shape (rows, columns).
type Pots<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray2<f64>>,
);

/// The probability of a pot from each cell.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the question, threads and progress")]
pub(crate) fn pot_map<'py>(
    py: Python<'py>,
    shot: &Shot,
    target: (usize, usize),
    cells: [usize; 2],
    sampling: SamplingOptions,
    tables: Vec<PyRef<'py, Shot>>,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Pots<'py>> {
    let shot = shot.0.clone();
    let (model, tables) = (sampling.model(), drawn(py, &tables)?);
    let target = PotTarget { ball: target.0, pocket: target.1 };
    let map = progress::run(py, &report, |progress| {
        maps::pot_map(&shot, target, cells, &model, &tables, count(threads), progress)
    })?;
    let shape = [cells[1], cells[0]];
    let grid = |values| PyArray1::from_vec(py, values).reshape(shape);
    // Without variants the interval would be [0, 1]; NaN marks that there is none.
    let of = |value: &dyn Fn(&Chance, &Interval) -> f64| {
        let known = |(c, interval): (&Chance, _)| match c.variants {
            0 => f64::NAN,
            _ => value(c, interval),
        };
        grid(map.chance.iter().zip(&map.interval).map(known).collect())
    };
    let variants = map.chance.iter().map(|c| c.variants as i64).collect();
    Ok((
        of(&|c, _| c.share())?,
        of(&|_, interval| interval.low)?,
        of(&|_, interval| interval.high)?,
        PyArray1::from_vec(py, variants).reshape(shape)?,
        grid(map.azimuth)?,
    ))
}

type Positions<'py> =
    (Bound<'py, PyArray2<bool>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray3<f64>>);

/// Whether the ball falls, the azimuth, and the cue ball's end, for each speed (rows) and spin
/// (columns).
#[pyfunction]
pub(crate) fn position_map<'py>(
    py: Python<'py>,
    shot: &Shot,
    target: (usize, usize),
    speeds: Vec<f64>,
    spins: Vec<[f64; 2]>,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Positions<'py>> {
    let shot = shot.0.clone();
    let map = progress::run(py, &report, |progress| {
        maps::position_map(&shot, target.0, target.1, &speeds, &spins, count(threads), progress)
    })?;
    let (rows, columns) = (speeds.len(), spins.len());
    Ok((
        PyArray1::from_vec(py, map.met).reshape([rows, columns])?,
        PyArray1::from_vec(py, map.azimuth).reshape([rows, columns])?,
        PyArray1::from_vec(py, map.end.into_flattened()).reshape([rows, columns, 2])?,
    ))
}

/// 1 where the ball falls, 0 where it does not, −1 where it has no room at the start: shape (speeds,
/// angles, offsets).
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the axes of the map, threads and progress")]
pub(crate) fn acceptance<'py>(
    py: Python<'py>,
    shot: &Shot,
    pocket: usize,
    speeds: Vec<f64>,
    angles: Vec<f64>,
    offsets: Vec<f64>,
    distance: f64,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Bound<'py, PyArray3<i8>>> {
    let shot = shot.0.clone();
    let approaches = Approaches { angles: &angles, offsets: &offsets, speeds: &speeds, distance };
    let found = progress::run(py, &report, |progress| {
        maps::acceptance(&shot, pocket, &approaches, count(threads), progress)
    })?;
    let number = |accepted: Accepted| match accepted {
        Accepted::Falls => 1,
        Accepted::Stays => 0,
        Accepted::Nowhere => -1,
    };
    let flat: Vec<i8> = found.into_iter().map(number).collect();
    PyArray1::from_vec(py, flat).reshape([speeds.len(), angles.len(), offsets.len()])
}

/// Breaks of a game with errors of the strike: the arrays of `simulate_batch`, and the counts behind
/// the statistics, by name.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the rack, its sampling, threads and progress")]
pub(crate) fn break_statistics<'py>(
    py: Python<'py>,
    game: &str,
    preset: Option<String>,
    table: Option<String>,
    speed: Option<f64>,
    gap: Option<f64>,
    sampling: SamplingOptions,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<(Arrays<'py>, Bound<'py, PyDict>)> {
    let game = Game::read(game).map_err(|e| to_exception(py, &e))?;
    let model = sampling.model();
    let usual =
        Break::named(game, preset.as_deref(), model.seed).map_err(|e| to_exception(py, &e))?;
    let (speed, gap) = (speed.or(usual.speed), gap.unwrap_or(usual.gap));
    let opening = Break { table: table.as_deref(), speed, gap, ..usual };
    let found = progress::run(py, &report, |progress| {
        breaks::breaks(&opening, &model, count(threads), progress)
    })?;
    let counts = PyDict::new(py);
    counts.set_item("any_potted", found.any_potted)?;
    counts.set_item("any_potted_without_scratch", found.any_potted_without_scratch)?;
    counts.set_item("scratched", found.scratched)?;
    counts.set_item("any_off_table", found.any_off_table)?;
    counts.set_item("ball_potted", found.ball_potted)?;
    counts.set_item("pocket_used", found.pocket_used)?;
    Ok((arrays(py, found.result)?, counts))
}

/// Rails by name (empty where no cushion is met) and centres, m: cell by cell, `most` of each.
type Cushions<'py> = (Vec<&'static str>, Bound<'py, PyArray2<f64>>);

fn cushions_of<'py>(
    py: Python<'py>,
    cells: &[Vec<CushionContact>],
    most: usize,
) -> PyResult<Cushions<'py>> {
    let (mut rails, mut places) = (Vec::new(), Vec::new());
    for cell in cells {
        for k in 0..most {
            let contact = cell.get(k);
            rails.push(contact.map_or("", |(rail, _): &(Rail, _)| rail.name()));
            places.extend(contact.map_or([f64::NAN; 2], |(_, place)| *place));
        }
    }
    let shape = [rails.len(), 2];
    Ok((rails, PyArray1::from_vec(py, places).reshape(shape)?))
}

/// The first `most` cushions that the struck ball meets, alone on the table: azimuth by azimuth, speed
/// by speed, side by side.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the axes of the table, threads and progress")]
pub(crate) fn kick_table<'py>(
    py: Python<'py>,
    shot: &Shot,
    azimuths: Vec<f64>,
    speeds: Vec<f64>,
    sides: Vec<f64>,
    height: f64,
    most: usize,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Cushions<'py>> {
    let (shot, threads) = (shot.0.clone(), count(threads));
    let kicks = Kicks { azimuths: &azimuths, speeds: &speeds, sides: &sides, height };
    let found = progress::run(py, &report, |progress| {
        cushions::kick_table(&shot, &kicks, most, threads, progress)
    })?;
    cushions_of(py, &found, most)
}

/// The same for a ball that starts with a velocity: azimuth by azimuth, speed by speed.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the axes of the table, threads and progress")]
pub(crate) fn bank_table<'py>(
    py: Python<'py>,
    shot: &Shot,
    ball: usize,
    azimuths: Vec<f64>,
    speeds: Vec<f64>,
    most: usize,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Cushions<'py>> {
    let (shot, threads) = (shot.0.clone(), count(threads));
    let found = progress::run(py, &report, |progress| {
        cushions::bank_table(&shot, ball, &azimuths, &speeds, most, threads, progress)
    })?;
    cushions_of(py, &found, most)
}
