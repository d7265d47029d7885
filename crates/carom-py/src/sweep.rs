//! Functions for sweeps: `_core.play_rows`, `row_shot`, `read_json`, `points` and `quantiles`.

use carom::format::{KeyPath, Node, Reader, with_value_dated};
use carom::limits::MOST_BYTES;
use carom::sample::{Distribution, Sequence};
use carom::{Error, ErrorKind, ShotFile};
use carom_plan::sweep::{self, Column, OutcomeColumns, RowResults, STRIKE, SweepRows, Values};
use numpy::{
    PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArrayDyn,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::device::CudaDevice;
use crate::error::to_exception;
use crate::exceptions::refuse;
use crate::json;
use crate::node::{from_python, to_python};
use crate::options::NoiseOptions;
use crate::shot::Shot;

/// Numbers of shape (n,), lists of shape (n, width), or indices of shape (n,) into a list of
/// values.
#[derive(FromPyObject)]
pub(crate) enum Given<'py> {
    Numbers(PyReadonlyArrayDyn<'py, f64>),
    Choices(Vec<Bound<'py, PyAny>>, PyReadonlyArray1<'py, i32>),
}

enum Kept<'py> {
    Numbers(usize, PyReadonlyArrayDyn<'py, f64>),
    Choices(Vec<Node>, PyReadonlyArray1<'py, i32>),
}

impl<'py> Kept<'py> {
    fn new(given: Given<'py>) -> PyResult<Self> {
        Ok(match given {
            Given::Numbers(numbers) => {
                let width = numbers.as_array().shape().get(1).copied().unwrap_or(0);
                Self::Numbers(width, numbers)
            }
            Given::Choices(choices, index) => {
                let choices = choices.iter().map(from_python).collect::<PyResult<_>>()?;
                Self::Choices(choices, index)
            }
        })
    }

    fn values(&self) -> PyResult<Values<'_>> {
        Ok(match self {
            Self::Numbers(0, numbers) => Values::Numbers(numbers.as_slice()?),
            Self::Numbers(width, numbers) => Values::Lists(*width, numbers.as_slice()?),
            Self::Choices(choices, index) => Values::Choices(choices, index.as_slice()?),
        })
    }
}

/// The name of a column of outcomes, and the function that returns its value.
type OutcomeColumn = (&'static str, fn(&OutcomeColumns) -> i16);

/// `carom.sweeps.play.RowArguments`, read by attribute. All arrays are contiguous.
#[derive(FromPyObject)]
pub(crate) struct RowArguments<'py> {
    layouts: Vec<PyRef<'py, Shot>>,
    /// The index of each row's layout, shape (n,).
    layout: PyReadonlyArray1<'py, i32>,
    /// Paths and values.
    columns: Vec<(String, Given<'py>)>,
    /// Keys of a strike and numbers of shape (n,).
    strike: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    noise: Option<NoiseOptions>,
    seed: u64,
    /// The index of each row's noise, shape (n,).
    noise_index: PyReadonlyArray1<'py, i64>,
}

/// The results of rows; a `device` computes no outcomes. A dict of arrays of shape (n,), or (n, balls) for columns per ball.
#[pyfunction]
pub(crate) fn play_rows<'py>(
    py: Python<'py>,
    rows: RowArguments<'py>,
    balls: usize,
    outcomes: bool,
    device: Option<PyRef<'py, CudaDevice>>,
) -> PyResult<Bound<'py, PyDict>> {
    let device = device.map(|device| device.0.clone());
    let results = with_rows(py, rows, |rows| {
        py.detach(|| match &device {
            Some(device) => sweep::play_on(rows, balls, &**device),
            None => Ok(sweep::play(rows, balls, outcomes)),
        })
    })?;
    to_dict(py, results.map_err(|error| to_exception(py, &error))?)
}

/// The shot of the first row.
#[pyfunction]
pub(crate) fn row_shot<'py>(py: Python<'py>, rows: RowArguments<'py>) -> PyResult<Shot> {
    let shot = with_rows(py, rows, |rows| sweep::shot(rows, 0))?;
    shot.map(|shot| Shot(shot.into())).map_err(|error| to_exception(py, &error))
}

fn with_rows<'py, T>(
    py: Python<'py>,
    rows: RowArguments<'py>,
    answer: impl FnOnce(&SweepRows<'_>) -> T,
) -> PyResult<T> {
    let RowArguments { layouts, layout, columns, strike, noise, seed, noise_index } = rows;
    let raise = |error| to_exception(py, &error);
    let layouts: Vec<_> = layouts.iter().map(|shot| shot.0.clone()).collect();
    let layouts: Vec<&ShotFile> = layouts.iter().map(|shot| &**shot).collect();
    let kept = columns
        .into_iter()
        .map(|(path, given)| Ok((KeyPath::parse(&path).map_err(raise)?, Kept::new(given)?)))
        .collect::<PyResult<Vec<_>>>()?;
    let columns = kept
        .iter()
        .map(|(path, kept)| Ok(Column { path, values: kept.values()? }))
        .collect::<PyResult<Vec<_>>>()?;
    let strike = strike
        .iter()
        .map(|(name, numbers)| {
            let key = STRIKE.iter().position(|key| key == name);
            let key = key.ok_or_else(|| {
                refuse(
                    ErrorKind::UnknownName,
                    name,
                    "there is no such number",
                    "write a number of a strike",
                )
            })?;
            Ok((key, numbers.as_slice()?))
        })
        .collect::<PyResult<Vec<_>>>()?;
    let noise = noise.map(|noise| noise.noise());
    let noise = match &noise {
        Some(noise) => Some((noise, seed, noise_index.as_slice()?)),
        None => None,
    };
    Ok(answer(&SweepRows {
        layouts: &layouts,
        layout: layout.as_slice()?,
        columns: &columns,
        strike: &strike,
        noise,
    }))
}

fn to_dict(py: Python<'_>, results: RowResults) -> PyResult<Bound<'_, PyDict>> {
    let RowResults { balls, events, duration, pocket, end, cue_ball, strike, outcomes, errors } =
        results;
    let n = events.len();
    let dict = PyDict::new(py);
    dict.set_item("events", PyArray1::from_vec(py, events))?;
    dict.set_item("duration", PyArray1::from_vec(py, duration))?;
    dict.set_item("pocket", PyArray1::from_vec(py, pocket).reshape([n, balls])?)?;
    dict.set_item("cue_ball", PyArray1::from_vec(py, cue_ball))?;
    for (name, values) in ["end_x", "end_y", "end_z"].into_iter().zip(end) {
        dict.set_item(name, PyArray1::from_vec(py, values).reshape([n, balls])?)?;
    }
    for (name, values) in STRIKE.into_iter().zip(strike).filter(|(_, v)| !v.is_empty()) {
        dict.set_item(format!("played_{name}"), PyArray1::from_vec(py, values))?;
    }
    if !outcomes.is_empty() {
        let scratch = PyArray1::from_iter(py, outcomes.iter().map(|f| f.scratch));
        dict.set_item("scratch", scratch)?;
        let numbers: [OutcomeColumn; 8] = [
            ("first_contact", |f| f.first_contact),
            ("rails_before_contact", |f| f.rails_before_contact),
            ("rails_after_contact", |f| f.rails_after_contact),
            ("driven_to_rail", |f| f.driven_to_rail),
            ("balls_touched", |f| f.balls_touched),
            ("rails_before_second_ball", |f| f.rails_before_second_ball),
            ("jumped", |f| f.jumped),
            ("hanging", |f| f.hanging),
        ];
        for (name, number) in numbers {
            dict.set_item(name, PyArray1::from_iter(py, outcomes.iter().map(number)))?;
        }
    }
    let texts = PyDict::new(py);
    for (row, error) in errors {
        texts.set_item(row, error.to_string())?;
    }
    dict.set_item("errors", texts)?;
    Ok(dict)
}

/// JSON text in plain dicts, lists and values. Rejects duplicate keys and numbers that are not
/// finite; the error names the `file` of the text, if it has one.
#[pyfunction]
pub(crate) fn read_json<'py>(
    py: Python<'py>,
    text: &str,
    file: Option<&str>,
) -> PyResult<Bound<'py, PyAny>> {
    to_python(py, &json::read(py, text, file, MOST_BYTES)?)
}

/// The value at `path` of a shot file with the dated names of presets.
#[pyfunction]
pub(crate) fn dated_value<'py>(
    path: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    to_python(value.py(), &with_value_dated(path, &from_python(value)?))
}

/// Rejects a value that is not an object, and unknown keys. `place` is the value's path in its
/// file.
#[pyfunction]
pub(crate) fn check_keys(
    value: &Bound<'_, PyAny>,
    place: &str,
    known: Vec<String>,
) -> PyResult<()> {
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    read(value, place, |reader| reader.keys(&known))
}

/// A finite number.
#[pyfunction]
pub(crate) fn read_number(value: &Bound<'_, PyAny>, place: &str) -> PyResult<f64> {
    read(value, place, |reader| reader.number())
}

/// A whole number from `low` up to `high`.
#[pyfunction]
pub(crate) fn read_whole(
    value: &Bound<'_, PyAny>,
    place: &str,
    low: i64,
    high: i64,
) -> PyResult<i64> {
    read(value, place, |reader| reader.whole(low, high))
}

/// Raises the error of a value of a wrong type; `wanted` describes a correct value.
#[pyfunction]
pub(crate) fn wrong_type(value: &Bound<'_, PyAny>, place: &str, wanted: &str) -> PyResult<()> {
    read(value, place, |reader| Err(reader.wrong_type(wanted)))
}

/// Raises the error of an unknown word; `kind` is the noun for the `known` words, such as "model".
#[pyfunction]
pub(crate) fn unknown_word(
    py: Python<'_>,
    word: &str,
    place: &str,
    kind: &str,
    known: Vec<String>,
) -> PyResult<()> {
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let error = Reader::new(&Node::Null, place).unknown_word(word, kind, &known);
    Err(to_exception(py, &error))
}

fn read<T>(
    value: &Bound<'_, PyAny>,
    place: &str,
    answer: impl FnOnce(Reader<'_>) -> Result<T, Error>,
) -> PyResult<T> {
    let node = from_python(value)?;
    answer(Reader::new(&node, place)).map_err(|error| to_exception(value.py(), &error))
}

/// Points of the unit cube, shape (n, dimensions): the points of `seed` with these indices.
/// `sequence` is `random` or `even`.
#[pyfunction]
pub(crate) fn points<'py>(
    py: Python<'py>,
    sequence: &str,
    seed: u64,
    index: PyReadonlyArray1<'py, i64>,
    dimensions: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let sequence = match sequence {
        "random" => Sequence::Random,
        "even" => Sequence::Even,
        _ => {
            return Err(refuse(
                ErrorKind::UnknownName,
                "sequence",
                "there is no such sequence",
                "write \"random\" or \"even\"",
            ));
        }
    };
    let index = index.as_slice()?;
    let mut all = vec![0.0; index.len() * dimensions];
    if dimensions > 0 {
        for (point, &index) in all.chunks_exact_mut(dimensions).zip(index) {
            sequence.point(seed, index as u64, point);
        }
    }
    PyArray1::from_vec(py, all).reshape([index.len(), dimensions])
}

/// The quantiles of a distribution at `u` in (0, 1), shape (n, k), column by column: `uniform` from
/// a to b, `log_uniform` from a to b, or `normal` with mean a and σ b; a and b: shape (k,).
#[pyfunction]
pub(crate) fn quantiles<'py>(
    py: Python<'py>,
    distribution: &str,
    a: Vec<f64>,
    b: Vec<f64>,
    u: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let of = match distribution {
        "uniform" => Distribution::Uniform,
        "log_uniform" => Distribution::LogUniform,
        "normal" => Distribution::Normal,
        _ => {
            return Err(refuse(
                ErrorKind::UnknownName,
                distribution,
                "there is no such distribution",
                "write uniform, log_uniform or normal",
            ));
        }
    };
    let columns: Vec<Distribution> = a.into_iter().zip(b).map(|(a, b)| of(a, b)).collect();
    let u = u.as_array();
    let shape = [u.nrows(), columns.len()];
    let rows = u.rows().into_iter();
    let all = rows.flat_map(|row| {
        let pairs = columns.iter().zip(row.to_vec());
        pairs.map(|(column, u)| column.quantile(u)).collect::<Vec<_>>()
    });
    PyArray1::from_vec(py, all.collect()).reshape(shape)
}
