//! `_core.evaluate`, `_core.solve`, and `_core.wilson`.

use carom::resolve::cue_ball::Strike;
use carom_plan::{Evaluation, Moments, Question, Referee, Stage, Watched};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::to_exception;
use crate::options::{GoalOptions, SamplingOptions, SearchOptions, count};
use crate::progress;
use crate::rules::Frame;
use crate::shot::Shot;

/// A ball's id, `scratch` or `legal`; and a pocket's name.
type WatchArguments = (String, Option<String>);
/// Kind, ball, pocket.
type CallArguments = (String, Option<String>, Option<String>);

/// The results of a shot's variants, as plain values and arrays. `watch` None watches everything;
/// `report` is called with stage, done, total.
#[pyfunction]
pub(crate) fn evaluate<'py>(
    py: Python<'py>,
    shot: &Shot,
    sampling: SamplingOptions,
    watch: Option<WatchArguments>,
    referee: Option<(PyRef<'py, Frame>, CallArguments)>,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let shot = shot.0.clone();
    let raise = |error| to_exception(py, &error);
    let watched = watch
        .map(|(name, pocket)| Watched::read(&shot, &name, pocket.as_deref()))
        .transpose()
        .map_err(raise)?;
    let referee = referee
        .map(|(frame, (kind, ball, pocket))| {
            let frame = frame.get();
            let call = frame.call(&kind, ball.as_deref(), pocket.as_deref())?;
            Ok((frame, call))
        })
        .transpose()
        .map_err(raise)?;
    let question = Question {
        model: sampling.model(),
        watched: watched.unwrap_or_default(),
        referee: referee.as_ref().map(|(frame, call)| Referee { frame, call: *call }),
        threads: count(threads),
    };
    let evaluation =
        progress::run(py, &report, |progress| carom_plan::evaluate(&shot, &question, progress))?;
    to_dict(py, evaluation)
}

fn to_dict(py: Python<'_>, evaluation: Evaluation) -> PyResult<Bound<'_, PyDict>> {
    let balls = evaluation.off_table.len();
    let signed = |counts: &[u64]| counts.iter().map(|&c| c as i64).collect::<Vec<i64>>();
    let vectors: Vec<f64> = evaluation.ends.iter().flat_map(|m| m.mean()).collect();
    let matrices: Vec<f64> = evaluation
        .ends
        .iter()
        .map(Moments::covariance)
        .flat_map(|[xx, xy, yy]| [xx, xy, xy, yy])
        .collect();
    let rested: Vec<u64> = evaluation.ends.iter().map(Moments::count).collect();
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
    let variants = evaluation.cue_ball_ends.len();
    let ends: Bound<'_, PyArray2<f64>> =
        PyArray1::from_vec(py, evaluation.cue_ball_ends.into_flattened()).reshape([variants, 2])?;
    dict.set_item("cue_ball_ends", ends)?;
    Ok(dict)
}

/// A solution; a dict in Python. `strike`: speed, azimuth, elevation, side, height.
#[derive(IntoPyObject)]
pub(crate) struct SolutionFields {
    strike: [f64; 5],
    kind: String,
    route: String,
    cue_ball_end: [f64; 2],
    met: u64,
    variants: u64,
    low: f64,
    high: f64,
}

/// The strikes that reach a goal, the most probable first. `report` is called with the index into
/// `stages()`, done, total.
#[pyfunction]
pub(crate) fn solve(
    py: Python<'_>,
    shot: &Shot,
    goal: GoalOptions,
    search: SearchOptions,
    sampling: SamplingOptions,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Vec<SolutionFields>> {
    let shot = shot.0.clone();
    let (goal, search) = (goal.goal(), search.search(&sampling, threads));
    let solutions =
        progress::run(py, &report, |progress| carom_plan::solve(&shot, &goal, &search, progress))?;
    let fields = |s: carom_plan::Solution| {
        let Strike { speed, azimuth, elevation, side, height } = s.strike;
        SolutionFields {
            strike: [speed, azimuth, elevation, side, height],
            kind: s.route.kind(),
            route: s.route.words(&shot),
            cue_ball_end: s.cue_ball_end,
            met: s.chance.met,
            variants: s.chance.variants,
            low: s.interval.low,
            high: s.interval.high,
        }
    };
    Ok(solutions.into_iter().map(fields).collect())
}

/// The names of a search's stages, in order.
#[pyfunction]
pub(crate) fn stages() -> Vec<&'static str> {
    let name = |stage| match stage {
        Stage::Search => "searching",
        Stage::Refine => "refining",
        Stage::Sift => "sifting",
        Stage::Rank => "ranking",
    };
    Stage::ALL.into_iter().map(name).collect()
}

/// The Wilson interval of `hits` among `trials`.
#[pyfunction]
pub(crate) fn wilson(py: Python<'_>, hits: u64, trials: u64, level: f64) -> PyResult<(f64, f64)> {
    carom_plan::check_level(level).map_err(|e| to_exception(py, &e))?;
    let interval = carom_plan::wilson(hits, trials, level);
    Ok((interval.low, interval.high))
}
