//! `_core.evaluate`, `_core.solve`, `_core.wilson`, `_core.clustered` and `_core.spread`.

use std::sync::Arc;

use carom::device::Device;
use carom::resolve::cue_ball::Strike;
use carom_plan::{
    ChanceByTable, DrawnTables, Evaluation, Moments, Question, Referee, ResultCounts, Stage,
    Watched,
};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::device::CudaDevice;
use crate::error::to_exception;
use crate::options::{GoalOptions, SamplingOptions, SearchOptions, count};
use crate::progress;
use crate::rules::Frame;
use crate::shot::Shot;

/// A ball's id, `scratch` or `legal`; and a pocket's name.
type WatchArguments = (String, Option<String>);
/// Kind, ball, pocket.
type CallArguments = (String, Option<String>, Option<String>);

/// The shots on drawn tables from Python, where none stand for the shot's own table.
pub(crate) fn drawn(py: Python<'_>, tables: &[PyRef<'_, Shot>]) -> PyResult<DrawnTables> {
    if tables.is_empty() {
        return Ok(DrawnTables::default());
    }
    let shots = tables.iter().map(|shot| carom::Shot::clone(&shot.0)).collect();
    DrawnTables::new(shots).map_err(|error| to_exception(py, &error))
}

/// The results of a shot's variants, as plain values and arrays. `watch` None watches everything;
/// `report` is called with stage, done, total.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the question, threads and progress")]
pub(crate) fn evaluate<'py>(
    py: Python<'py>,
    shot: &Shot,
    sampling: SamplingOptions,
    watch: Option<WatchArguments>,
    referee: Option<(PyRef<'py, Frame>, CallArguments)>,
    tables: Vec<PyRef<'py, Shot>>,
    threads: usize,
    device: Option<PyRef<'py, CudaDevice>>,
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
        tables: drawn(py, &tables)?,
        watched: watched.unwrap_or_default(),
        referee: referee.as_ref().map(|(frame, call)| Referee { frame, call: *call }),
        threads: count(threads),
        device: device.map(|device| device.0.clone() as Arc<dyn Device>),
    };
    let evaluation =
        progress::run(py, &report, |progress| carom_plan::evaluate(&shot, &question, progress))?;
    to_dict(py, evaluation)
}

fn to_dict(py: Python<'_>, evaluation: Evaluation) -> PyResult<Bound<'_, PyDict>> {
    let balls = evaluation.ends.len();
    let vectors: Vec<f64> = evaluation.ends.iter().flat_map(|m| m.mean()).collect();
    let matrices: Vec<f64> = evaluation
        .ends
        .iter()
        .map(Moments::covariance)
        .flat_map(|[xx, xy, yy]| [xx, xy, xy, yy])
        .collect();
    let rested: Vec<u64> = evaluation.ends.iter().map(Moments::count).collect();
    let dict = PyDict::new(py);
    let failure = evaluation.first_failure.as_ref().map(ToString::to_string);
    dict.set_item("first_failure", failure)?;
    dict.set_item("cue_ball", evaluation.cue_ball)?;
    dict.set_item("counts", counts_dict(py, &evaluation.counts)?)?;
    let by_table = evaluation.by_table.iter().map(|counts| counts_dict(py, counts));
    dict.set_item("by_table", by_table.collect::<PyResult<Vec<_>>>()?)?;
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

fn counts_dict<'py>(py: Python<'py>, counts: &ResultCounts) -> PyResult<Bound<'py, PyDict>> {
    let (balls, potted) = (counts.off_table.len(), signed(&counts.potted));
    let dict = PyDict::new(py);
    dict.set_item("n", counts.variants)?;
    dict.set_item("failed", counts.failed)?;
    dict.set_item("legal", counts.legal)?;
    dict.set_item("turn_kept", counts.turn_kept)?;
    dict.set_item("potted", PyArray1::from_vec(py, potted).reshape([balls, counts.pockets])?)?;
    dict.set_item("off_table", PyArray1::from_vec(py, signed(&counts.off_table)))?;
    Ok(dict)
}

fn signed(counts: &[u64]) -> Vec<i64> {
    counts.iter().map(|&count| count as i64).collect()
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
    /// Goals met and variants on each drawn table; empty if there are none.
    by_table: Vec<(u64, u64)>,
}

/// The strikes that reach a goal, the most probable first. `report` is called with the index into
/// `stages()`, done, total.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the question, threads and progress")]
pub(crate) fn solve(
    py: Python<'_>,
    shot: &Shot,
    goal: GoalOptions,
    search: SearchOptions,
    sampling: SamplingOptions,
    tables: Vec<PyRef<'_, Shot>>,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<Vec<SolutionFields>> {
    let shot = shot.0.clone();
    let (goal, mut search) = (goal.goal(), search.search(&sampling, threads));
    search.tables = drawn(py, &tables)?;
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
            by_table: pairs(&s.by_table),
        }
    };
    Ok(solutions.into_iter().map(fields).collect())
}

/// Goals met and variants on each drawn table; empty for one table.
fn pairs(by_table: &ChanceByTable) -> Vec<(u64, u64)> {
    let tables = by_table.0.iter().map(|chance| (chance.met, chance.variants));
    if by_table.0.len() > 1 { tables.collect() } else { Vec::new() }
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

/// The interval of a probability that was counted on several drawn tables.
#[pyfunction]
pub(crate) fn clustered(
    py: Python<'_>,
    tables: Vec<(u64, u64)>,
    level: f64,
) -> PyResult<(f64, f64)> {
    carom_plan::check_level(level).map_err(|e| to_exception(py, &e))?;
    let interval = carom_plan::clustered(&tables, level);
    Ok((interval.low, interval.high))
}

/// The standard deviation of a probability from one drawn table to another.
#[pyfunction]
pub(crate) fn spread(tables: Vec<(u64, u64)>) -> f64 {
    let chance = |(met, variants)| carom_plan::Chance { met, variants };
    ChanceByTable(tables.into_iter().map(chance).collect()).spread()
}
