//! `_core.Study` and `_core.judge`.

use carom::format::{Node, Reader};
use carom::limits::MOST_BYTES;
use carom_drill::study;
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::json;
use crate::node::{from_python, to_python};
use crate::shot::Shot;
use crate::trace::Trace;

/// A study whose parts were read; immutable.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Study(study::Study);

#[pymethods]
impl Study {
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str, file: Option<&str>) -> PyResult<Self> {
        let raise = |error| to_exception(py, &error);
        study::check_size(text).map_err(raise)?;
        let node = json::read(py, text, file, MOST_BYTES)?;
        study::Study::from_node(node).map(Self).map_err(raise)
    }

    #[staticmethod]
    fn from_object(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let read = study::Study::from_node(from_python(value)?);
        read.map(Self).map_err(|e| to_exception(value.py(), &e))
    }

    fn to_object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, self.0.to_node())
    }

    fn to_json(&self) -> String {
        self.0.to_node().to_json()
    }

    /// The shot of each chapter, and the shot of its task's solution.
    fn shots(&self) -> Vec<(Shot, Option<Shot>)> {
        let shots = |chapter: &study::Chapter| {
            let solution = chapter.task.as_ref().and_then(|task| task.solution.clone());
            (Shot(chapter.shot.clone().into()), solution.map(|shot| Shot(shot.into())))
        };
        self.0.chapters.iter().map(shots).collect()
    }

    /// What the simulation of every chapter found.
    fn check<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let reports = py.detach(|| self.0.check());
        to_python(py, &Node::list(reports.iter().map(study::ChapterReport::to_node)))
    }
}

/// How a trace stands to the goal of a task.
#[pyfunction]
pub(crate) fn judge<'py>(
    trace: PyRef<'py, Trace>,
    goal: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = trace.py();
    let node = from_python(goal)?;
    let trace = trace.trace();
    let verdict = study::goal_from_node(&Reader::new(&node, "goal"), trace.shot())
        .and_then(|goal| study::judge(trace, &goal));
    to_python(py, &verdict.map_err(|error| to_exception(py, &error))?.to_node())
}
