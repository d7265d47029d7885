//! `_core.evaluate`, `_core.solve`, and `_core.wilson`.

use carom::noise::Perception;
use carom::resolve::cue_ball::Strike;
use carom_plan::{
    Disc, Errs, Evaluation, Goal, Precision, Question, Referee, Search, Stage, Watched,
};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::batch::{count, noise_of};
use crate::error::to_exception;
use crate::rules::Frame;
use crate::shot::Shot;

/// A ball or `scratch` or `legal`, and a pocket.
type Watch = (String, Option<String>);
/// Kind, ball, pocket.
type CallArguments = (String, Option<String>, Option<String>);
/// Noise as in `draw_strikes`, σ of positions (m), seed, variants, half-width wanted, level.
pub(crate) type ErrsArguments = ([f64; 5], f64, u64, u64, Option<f64>, f64);

pub(crate) fn errs_of(arguments: ErrsArguments) -> Errs {
    let (noise, position, seed, variants, half_width, level) = arguments;
    let perception = Perception { position };
    Errs { noise: noise_of(noise), perception, seed, variants, half_width, level }
}

/// What comes of a shot's variants, as plain values and arrays. `noise` as in `draw_strikes`;
/// `position`: σ of positions, m; `precision`: half-width, and what is watched (everything if None); `progress` is called with the number
/// of variants after every round.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn evaluate<'py>(
    py: Python<'py>,
    shot: &Shot,
    noise: [f64; 5],
    position: f64,
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
        perception: Perception { position },
        seed,
        most,
        level,
        precision,
        referee: referee.as_ref().map(|(frame, call)| Referee { frame, call: *call }),
        threads: count(threads),
    };
    let evaluation = told(py, |tell| {
        carom_plan::evaluate(&shot, &question, &mut |played| {
            tell(&|py| progress.call1(py, (played,)))
        })
    })?;
    to_dict(py, &evaluation)
}

/// Calls into Python to tell something; says whether to go on.
pub(crate) type Tell<'a> = &'a mut dyn FnMut(&dyn Fn(Python<'_>) -> PyResult<Py<PyAny>>) -> bool;

/// What `work` gives; it tells how far it is, and between two tellings Ctrl-C is heard.
pub(crate) fn told<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(Tell<'_>) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    let mut interrupted = None;
    let found = py.detach(|| {
        work(&mut |call| {
            let told = Python::attach(|py| {
                py.check_signals()?;
                call(py)
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

/// A solution: speed, azimuth, elevation, side, height; kind and words of its way; the cue ball's end; how
/// often the goal was met, of how many variants, and the interval.
type Solved = ([f64; 5], String, String, [f64; 2], u64, u64, (f64, f64));

/// The strikes that meet a goal, the likeliest first. `pot`: ball, and pocket if it matters; `leave`: a disc's
/// centre and radius; `first`: the ball to hit. `limits`: least and greatest speed, largest offset,
/// greatest elevation if the cue may be raised.
/// `counts`: samples, solutions wanted, of them by one way. `progress` is called with the stage's name, how
/// many of its strikes are done, and how many there are.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python, where the face is")]
pub(crate) fn solve(
    py: Python<'_>,
    shot: &Shot,
    pot: Option<(usize, Option<usize>)>,
    leave: Option<([f64; 2], f64)>,
    first: Option<usize>,
    limits: ([f64; 3], Option<f64>),
    counts: (usize, usize, usize),
    errs: ErrsArguments,
    threads: usize,
    progress: Py<PyAny>,
) -> PyResult<Vec<Solved>> {
    let shot = shot.0.clone();
    let leave = leave.map(|(center, radius)| Disc { center, radius });
    let goal = Goal { pot, leave, first };
    let ([least, most, offset], elevation) = limits;
    let (samples, wanted, of_a_way) = counts;
    let search = Search {
        speed: [least, most],
        offset,
        elevation,
        samples,
        errs: errs_of(errs),
        wanted,
        of_a_way,
        threads: count(threads),
    };
    let solutions = told(py, |tell| {
        carom_plan::solve(&shot, &goal, &search, &mut |stage, done, of| {
            tell(&|py| progress.call1(py, (name_of(stage), done, of)))
        })
    })?;
    let row = |s: carom_plan::Solution| {
        let Strike { speed, azimuth, elevation, side, height } = s.strike;
        (
            [speed, azimuth, elevation, side, height],
            s.way.kind(),
            s.way.words(&shot),
            s.cue_ball_end,
            s.chance.met,
            s.chance.variants,
            (s.interval.low, s.interval.high),
        )
    };
    Ok(solutions.into_iter().map(row).collect())
}

const fn name_of(stage: Stage) -> &'static str {
    match stage {
        Stage::Search => "searching",
        Stage::Refine => "refining",
        Stage::Sift => "sifting",
        Stage::Rank => "ranking",
    }
}

/// The Wilson interval of `hits` among `trials`.
#[pyfunction]
pub(crate) fn wilson(py: Python<'_>, hits: u64, trials: u64, level: f64) -> PyResult<(f64, f64)> {
    carom_plan::check_level(level).map_err(|e| to_exception(py, &e))?;
    let interval = carom_plan::wilson(hits, trials, level);
    Ok((interval.low, interval.high))
}
