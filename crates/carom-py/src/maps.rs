//! `_core.pot_map` and its like: one question asked over a grid.

use carom::rack::{Break, Game, USUAL_GAP};
use carom::table::Rail;
use carom_plan::Chance;
use carom_plan::cushions::{self, Met};
use carom_plan::maps::{self, Accepted, Approaches};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;

use crate::batch::{Arrays, arrays, count, noise_of};
use crate::error::to_exception;
use crate::plan::{ErrsArguments, errs_of, told};
use crate::shot::Shot;

/// [`told`] how many rows are done.
fn rows_told<T: Send>(
    py: Python<'_>,
    progress: &Py<PyAny>,
    work: impl FnOnce(maps::Progress<'_>) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    told(py, |tell| work(&mut |done| tell(&|py| progress.call1(py, (done,)))))
}

/// What a map of pots has in each cell: arrays (rows, columns).
type Pots<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray2<f64>>,
);

/// How likely a pot is from each cell, the interval's ends, the variants behind it, and the azimuths.
#[pyfunction]
pub(crate) fn pot_map<'py>(
    py: Python<'py>,
    shot: &Shot,
    target: (usize, usize),
    cells: [usize; 2],
    errs: ErrsArguments,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Pots<'py>> {
    let shot = shot.0.clone();
    let errs = errs_of(errs);
    let map = rows_told(py, &progress, |tell| {
        maps::pot_map(&shot, target, cells, &errs, count(threads), tell)
    })?;
    let shape = [cells[1], cells[0]];
    let grid = |values| PyArray1::from_vec(py, values).reshape(shape);
    // Without variants nothing is known, and the whole of [0, 1] is not what is meant.
    let of = |value: &dyn Fn(&Chance) -> f64| {
        let known = |c: &Chance| if c.variants == 0 { f64::NAN } else { value(c) };
        grid(map.chance.iter().map(known).collect())
    };
    let variants = map.chance.iter().map(|c| c.variants as i64).collect();
    Ok((
        of(&|c| c.share())?,
        of(&|c| c.interval(errs.level).low)?,
        of(&|c| c.interval(errs.level).high)?,
        PyArray1::from_vec(py, variants).reshape(shape)?,
        grid(map.azimuth)?,
    ))
}

type Positions<'py> =
    (Bound<'py, PyArray2<bool>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray3<f64>>);

/// Whether the ball falls, azimuth, and the cue ball's end, for each speed (rows) and spin (columns).
#[pyfunction]
pub(crate) fn position_map<'py>(
    py: Python<'py>,
    shot: &Shot,
    target: (usize, usize),
    speeds: Vec<f64>,
    spins: Vec<[f64; 2]>,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Positions<'py>> {
    let shot = shot.0.clone();
    let map = rows_told(py, &progress, |tell| {
        maps::position_map(&shot, target, &speeds, &spins, count(threads), tell)
    })?;
    let (rows, columns) = (speeds.len(), spins.len());
    Ok((
        PyArray1::from_vec(py, map.met).reshape([rows, columns])?,
        PyArray1::from_vec(py, map.azimuth).reshape([rows, columns])?,
        PyArray1::from_vec(py, map.end.into_flattened()).reshape([rows, columns, 2])?,
    ))
}

/// 1 where the ball falls, 0 where it does not, −1 where it cannot start: (speeds, angles, offsets).
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn acceptance<'py>(
    py: Python<'py>,
    shot: &Shot,
    pocket: usize,
    speeds: Vec<f64>,
    angles: Vec<f64>,
    offsets: Vec<f64>,
    distance: f64,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Bound<'py, PyArray3<i8>>> {
    let shot = shot.0.clone();
    let approaches = Approaches { angles: &angles, offsets: &offsets, speeds: &speeds, distance };
    let found = rows_told(py, &progress, |tell| {
        maps::acceptance(&shot, pocket, &approaches, count(threads), tell)
    })?;
    let number = |accepted: Accepted| match accepted {
        Accepted::Falls => 1,
        Accepted::Stays => 0,
        Accepted::Nowhere => -1,
    };
    let flat: Vec<i8> = found.into_iter().map(number).collect();
    PyArray1::from_vec(py, flat).reshape([speeds.len(), angles.len(), offsets.len()])
}

/// Racks `first`.. of a game broken with errors: as `simulate_batch`.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn breaks<'py>(
    py: Python<'py>,
    game: &str,
    table: Option<String>,
    speed: Option<f64>,
    gap: Option<f64>,
    noise: [f64; 5],
    seed: u64,
    first: u64,
    racks: usize,
    threads: usize,
) -> PyResult<Arrays<'py>> {
    let raise = |e| to_exception(py, &e);
    let game = Game::parse(game).map_err(raise)?;
    let opening =
        Break { game, table: table.as_deref(), speed, seed, gap: gap.unwrap_or(USUAL_GAP) };
    let found =
        py.detach(|| maps::breaks(&opening, &noise_of(noise), first, racks, count(threads)));
    arrays(py, found.map_err(raise)?)
}

/// Rails by name (empty where no cushion is met) and centres, m: cell by cell, `most` of each.
type Cushions<'py> = (Vec<&'static str>, Bound<'py, PyArray2<f64>>);

fn cushions_of<'py>(py: Python<'py>, cells: Vec<Vec<Met>>, most: usize) -> PyResult<Cushions<'py>> {
    let (mut rails, mut places) = (Vec::new(), Vec::new());
    for cell in &cells {
        for k in 0..most {
            let met = cell.get(k);
            rails.push(met.map_or("", |(rail, _): &(Rail, _)| rail.name()));
            places.extend(met.map_or([f64::NAN; 2], |(_, place)| *place));
        }
    }
    let shape = [rails.len(), 2];
    Ok((rails, PyArray1::from_vec(py, places).reshape(shape)?))
}

/// Where the struck ball, alone on the table, meets the first `most` cushions: azimuth by azimuth, speed by
/// speed, side by side.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn kick_table<'py>(
    py: Python<'py>,
    shot: &Shot,
    azimuths: Vec<f64>,
    speeds: Vec<f64>,
    sides: Vec<f64>,
    height: f64,
    most: usize,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Cushions<'py>> {
    let (shot, threads) = (shot.0.clone(), count(threads));
    let found = rows_told(py, &progress, |tell| {
        cushions::kick_table(&shot, &azimuths, &speeds, &sides, height, most, threads, tell)
    })?;
    cushions_of(py, found, most)
}

/// The same of a ball that is sent off: azimuth by azimuth, speed by speed.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn bank_table<'py>(
    py: Python<'py>,
    shot: &Shot,
    ball: usize,
    azimuths: Vec<f64>,
    speeds: Vec<f64>,
    most: usize,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Cushions<'py>> {
    let (shot, threads) = (shot.0.clone(), count(threads));
    let found = rows_told(py, &progress, |tell| {
        cushions::bank_table(&shot, ball, &azimuths, &speeds, most, threads, tell)
    })?;
    cushions_of(py, found, most)
}
