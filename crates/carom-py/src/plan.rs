//! `_core.evaluate`, `_core.solve`, the maps, and `_core.wilson`.

use carom::rack::{Break, Game, USUAL_GAP};
use carom::resolve::cue_ball::Strike;
use carom_plan::maps::{self, Accepted, Approaches, Errs};
use carom_plan::{Disc, Evaluation, Goal, Precision, Question, Referee, Search, Watched};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::batch::{Arrays, arrays, count, noise_of};
use crate::error::to_exception;
use crate::rules::Frame;
use crate::shot::Shot;

/// A ball or `scratch` or `legal`, and a pocket.
type Watch = (String, Option<String>);
/// Kind, ball, pocket.
type CallArguments = (String, Option<String>, Option<String>);

/// What comes of a shot's variants, as plain values and arrays. `noise` as in `draw_strikes`;
/// `precision`: half-width, and what is watched (everything if None); `progress` is called with the number
/// of variants after every round.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn evaluate<'py>(
    py: Python<'py>,
    shot: &Shot,
    noise: [f64; 5],
    seed: u64,
    most: usize,
    level: f64,
    precision: Option<(f64, Option<Watch>)>,
    referee: Option<(PyRef<'py, Frame>, CallArguments)>,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let shot = shot.0.clone();
    let raise = |error| to_exception(py, &error);
    let precision = precision
        .map(|(half_width, watch)| {
            let watched = watch.map_or(Ok(Watched::Everything), |(name, pocket)| {
                Watched::read(&shot, &name, pocket.as_deref())
            })?;
            Ok(Precision { half_width, watched })
        })
        .transpose()
        .map_err(raise)?;
    let referee = referee
        .map(|(frame, (kind, ball, pocket))| {
            let frame = frame.0.clone();
            let call = frame.call(&kind, ball.as_deref(), pocket.as_deref())?;
            Ok((frame, call))
        })
        .transpose()
        .map_err(raise)?;
    let question = Question {
        noise: noise_of(noise),
        seed,
        most,
        level,
        precision,
        referee: referee.as_ref().map(|(frame, call)| Referee { frame, call: *call }),
        threads: count(threads),
    };
    let evaluation = told(py, &progress, |tell| {
        carom_plan::evaluate(&shot, &question, &mut |played| tell(played as usize))
    })?;
    to_dict(py, &evaluation)
}

/// What `work` gives; what it tells goes to `progress`, and between two tellings Ctrl-C is heard.
fn told<T: Send>(
    py: Python<'_>,
    progress: &Py<PyAny>,
    work: impl FnOnce(&mut dyn FnMut(usize) -> bool) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    let mut interrupted = None;
    let found = py.detach(|| {
        work(&mut |done| {
            let told = Python::attach(|py| {
                py.check_signals()?;
                progress.call1(py, (done,))
            });
            interrupted = told.err();
            interrupted.is_none()
        })
    });
    match interrupted {
        Some(error) => Err(error),
        None => found.map_err(|e| to_exception(py, &e)),
    }
}

fn to_dict<'py>(py: Python<'py>, evaluation: &Evaluation) -> PyResult<Bound<'py, PyDict>> {
    let balls = evaluation.off_table.len();
    let signed = |counts: &[u64]| counts.iter().map(|&c| c as i64).collect::<Vec<i64>>();
    let vectors: Vec<f64> = evaluation.ends.iter().flat_map(|m| m.mean()).collect();
    let matrices: Vec<f64> = evaluation
        .ends
        .iter()
        .map(carom_plan::Moments::covariance)
        .flat_map(|[xx, xy, yy]| [xx, xy, xy, yy])
        .collect();
    let rested: Vec<u64> = evaluation.ends.iter().map(carom_plan::Moments::count).collect();
    let places: Vec<f64> = evaluation.cue_ball_ends.iter().copied().flatten().collect();
    let potted = signed(&evaluation.potted);
    let dict = PyDict::new(py);
    dict.set_item("n", evaluation.variants)?;
    dict.set_item("failed", evaluation.failed)?;
    let failure = evaluation.first_failure.as_ref().map(ToString::to_string);
    dict.set_item("first_failure", failure)?;
    dict.set_item("cue_ball", evaluation.cue_ball)?;
    dict.set_item("legal_count", evaluation.legal)?;
    dict.set_item("turn_kept_count", evaluation.turn_kept)?;
    dict.set_item("potted", PyArray1::from_vec(py, potted).reshape([balls, evaluation.pockets])?)?;
    dict.set_item("off_table", PyArray1::from_vec(py, signed(&evaluation.off_table)))?;
    dict.set_item("at_rest", PyArray1::from_vec(py, signed(&rested)))?;
    dict.set_item("end_mean", PyArray1::from_vec(py, vectors).reshape([balls, 2])?)?;
    let covariance = PyArray1::from_vec(py, matrices).reshape([balls, 2, 2])?;
    dict.set_item("end_covariance", covariance)?;
    let ends: Bound<'py, PyArray2<f64>> =
        PyArray1::from_vec(py, places).reshape([evaluation.cue_ball_ends.len(), 2])?;
    dict.set_item("cue_ball_ends", ends)?;
    Ok(dict)
}

/// How likely a pot is from each cell, and the azimuths: arrays (rows, columns).
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn pot_map<'py>(
    py: Python<'py>,
    shot: &Shot,
    target: (usize, usize),
    cells: [usize; 2],
    noise: [f64; 5],
    seed: u64,
    variants: u64,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<[Bound<'py, PyArray2<f64>>; 2]> {
    let shot = shot.0.clone();
    let errs = Errs { noise: noise_of(noise), seed, variants };
    let map = told(py, &progress, |tell| {
        maps::pot_map(&shot, target, cells, &errs, count(threads), tell)
    })?;
    let shape = [cells[1], cells[0]];
    let grid = |values| PyArray1::from_vec(py, values).reshape(shape);
    Ok([grid(map.chance)?, grid(map.azimuth)?])
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
    let map = told(py, &progress, |tell| {
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
    let found = told(py, &progress, |tell| {
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

/// A solution: speed, azimuth, elevation, side, height; kind and words of its way; the cue ball's end; how
/// often the goal was met, of how many variants, and the interval.
type Solved = ([f64; 5], String, String, [f64; 2], u64, u64, (f64, f64));

/// The strikes that meet a goal, the likeliest first. `pot`: ball, and pocket if it matters; `leave`: a disc's
/// centre and radius; `first`: the ball to hit. `limits`: least and greatest speed, largest offset.
/// `counts`: samples, variants, solutions wanted, of them by one way.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn solve(
    py: Python<'_>,
    shot: &Shot,
    pot: Option<(usize, Option<usize>)>,
    leave: Option<([f64; 2], f64)>,
    first: Option<usize>,
    limits: [f64; 3],
    counts: (usize, u64, usize, usize),
    noise: [f64; 5],
    seed: u64,
    level: f64,
    threads: usize,
) -> PyResult<Vec<Solved>> {
    let shot = shot.0.clone();
    let leave = leave.map(|(center, radius)| Disc { center, radius });
    let goal = Goal { pot, leave, first };
    let [least, most, offset] = limits;
    let (samples, variants, wanted, of_a_way) = counts;
    let search = Search {
        speed: [least, most],
        offset,
        samples,
        noise: noise_of(noise),
        seed,
        variants,
        wanted,
        of_a_way,
        level,
        threads: count(threads),
    };
    let found = py.detach(|| carom_plan::solve(&shot, &goal, &search));
    let solutions = found.map_err(|e| to_exception(py, &e))?;
    let row = |s: carom_plan::Solution| {
        let Strike { speed, azimuth, elevation, side, height } = s.strike;
        (
            [speed, azimuth, elevation, side, height],
            s.way.kind(),
            s.way.words(&shot),
            s.cue_ball_end,
            s.met,
            s.variants,
            (s.interval.low, s.interval.high),
        )
    };
    Ok(solutions.into_iter().map(row).collect())
}

/// The Wilson interval of `hits` among `trials`.
#[pyfunction]
pub(crate) fn wilson(hits: u64, trials: u64, level: f64) -> (f64, f64) {
    let interval = carom_plan::wilson(hits, trials, level);
    (interval.low, interval.high)
}
