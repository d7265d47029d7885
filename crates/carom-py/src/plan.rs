//! `_core.evaluate` and `_core.wilson`.

use carom_plan::{Evaluation, Precision, Question, Referee, Watched};
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
    // Between rounds Ctrl-C is heard.
    let mut interrupted = None;
    let evaluation = py.detach(|| {
        carom_plan::evaluate(&shot, &question, &mut |played| {
            let told = Python::attach(|py| {
                py.check_signals()?;
                progress.call1(py, (played,))
            });
            interrupted = told.err();
            interrupted.is_none()
        })
    });
    if let Some(error) = interrupted {
        return Err(error);
    }
    to_dict(py, &evaluation.map_err(|e| to_exception(py, &e))?)
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

/// The Wilson interval of `hits` among `trials`.
#[pyfunction]
pub(crate) fn wilson(hits: u64, trials: u64, level: f64) -> (f64, f64) {
    let interval = carom_plan::wilson(hits, trials, level);
    (interval.low, interval.high)
}
