//! `_core.make_puzzle`, `read_puzzle`, `accepted_puzzles`, `puzzle_themes`, `read_drill` and `judge_shot`.

use carom::Simulator;
use carom::format::Reader;
use carom_drill::puzzle::accepted;
use carom_drill::{Drill, DrillGoal, Played, Puzzle, Theme, judge};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::shot::Shot;

/// The puzzle with a number as plain values, or why there is none.
#[pyfunction]
pub(crate) fn make_puzzle(py: Python<'_>, theme: &str, number: u32) -> PyResult<Py<PyAny>> {
    let made = Theme::read(theme).and_then(|theme| Puzzle::make(theme, number));
    match made.map_err(|error| to_exception(py, &error))? {
        Ok(puzzle) => Ok(to_python(py, &puzzle.to_node())?.unbind()),
        Err(why) => why.name().into_py_any(py),
    }
}

/// The puzzle with an id as plain values.
#[pyfunction]
pub(crate) fn read_puzzle<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let puzzle = Puzzle::read(name).map_err(|error| to_exception(py, &error))?;
    to_python(py, &puzzle.to_node())
}

/// Theme, number and rating of every puzzle of the list.
#[pyfunction]
pub(crate) fn accepted_puzzles() -> Vec<(&'static str, u32, u32)> {
    accepted().map(|one| (one.theme.name(), one.number, one.rating)).collect()
}

/// The names of the themes.
#[pyfunction]
pub(crate) fn puzzle_themes() -> Vec<&'static str> {
    Theme::ALL.map(Theme::name).to_vec()
}

/// A drill file, checked, as plain values.
#[pyfunction]
pub(crate) fn read_drill<'py>(
    py: Python<'py>,
    text: &str,
    file: Option<&str>,
) -> PyResult<Bound<'py, PyAny>> {
    let drill = Drill::from_json(text).map_err(|error| {
        to_exception(py, &file.map_or(error.clone(), |file| error.in_file(file)))
    })?;
    to_python(py, &drill.to_node())
}

/// The verdict on a shot, as plain values: `goal` as in a drill file, `left` the balls that a run still has
/// to pot.
#[pyfunction]
pub(crate) fn judge_shot<'py>(
    py: Python<'py>,
    shot: &Shot,
    goal: &Bound<'py, PyAny>,
    left: Vec<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let node = from_python(goal)?;
    let verdict = DrillGoal::read(&Reader::new(&node, "goal")).and_then(|goal| {
        let played = Played::of(&mut Simulator::new(), &shot.0, None)?;
        judge(&shot.0, &played, &goal, &left)
    });
    to_python(py, &verdict.map_err(|error| to_exception(py, &error))?.to_node())
}
