//! `_core.Frame`.

use carom::format::Node;
use carom::shot::StrikePolicy;
use carom::{Error, Trace as Played};
use carom_rules::{Choice, Options, Play, Rules};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::shot::{Shot, StrikeArguments, strike_or_default};
use crate::trace::Trace;

/// `carom.rules.PlayArguments`, read by attribute.
#[derive(FromPyObject)]
pub(crate) struct PlayArguments {
    strike: StrikeArguments,
    /// `obstruction` and `miscue`.
    policy: (String, String),
    cue_ball: Option<[f64; 2]>,
    /// Kind, ball, pocket.
    call: (String, Option<String>, Option<String>),
}

fn optional(value: &Bound<'_, PyAny>) -> PyResult<Option<Node>> {
    if value.is_none() { Ok(None) } else { from_python(value).map(Some) }
}

/// A game in progress.
#[pyclass(module = "carom._core")]
pub(crate) struct Frame(pub(crate) carom_rules::Frame);

impl Frame {
    fn play_of(&self, arguments: PlayArguments) -> Result<Play, Error> {
        let PlayArguments { strike, policy, cue_ball, call: (kind, ball, pocket) } = arguments;
        let (strike, has_elevation) = strike_or_default(strike);
        let call = self.0.call(&kind, ball.as_deref(), pocket.as_deref())?;
        let policy = StrikePolicy::from_names(&policy.0, &policy.1)?;
        let play = Play { strike, cue_ball, call, policy };
        if has_elevation { Ok(play) } else { self.0.at_default_elevation(&play) }
    }
}

#[pymethods]
impl Frame {
    #[new]
    fn new(
        game: &str,
        table: &Bound<'_, PyAny>,
        physics: &Bound<'_, PyAny>,
        seed: u64,
        options: (i32, bool, u32),
    ) -> PyResult<Self> {
        let py = table.py();
        let (points, miss, patience) = options;
        let rules = Rules::read(game).map_err(|e| to_exception(py, &e))?;
        let options = Options { points, miss, patience };
        carom_rules::Frame::new(rules, options, optional(table)?, optional(physics)?, seed)
            .map(Self)
            .map_err(|e| to_exception(py, &e))
    }

    /// Table and physics as the record of a new frame keeps them, with dated names.
    #[staticmethod]
    fn recorded_setup<'py>(
        game: &str,
        table: &Bound<'py, PyAny>,
        physics: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = table.py();
        let rules = Rules::read(game).map_err(|e| to_exception(py, &e))?;
        let setup = carom_rules::recorded_setup(rules, optional(table)?, optional(physics)?);
        to_python(py, &setup)
    }

    /// A frame that continues from the balls of a shot.
    #[staticmethod]
    fn of_shot(
        py: Python<'_>,
        game: &str,
        shot: &Shot,
        options: (i32, bool, u32),
    ) -> PyResult<Self> {
        let (points, miss, patience) = options;
        let options = Options { points, miss, patience };
        let frame = Rules::read(game)
            .and_then(|rules| carom_rules::Frame::of_shot(rules, options, &shot.0));
        frame.map(Self).map_err(|e| to_exception(py, &e))
    }

    fn to_object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.0.to_node())
    }

    fn shot(&self, py: Python<'_>, play: PlayArguments) -> PyResult<Shot> {
        let shot = self.play_of(play).and_then(|play| self.0.shot(&play));
        shot.map(Shot::from).map_err(|e| to_exception(py, &e))
    }

    /// The ruling, and the trace of the shot.
    fn play<'py>(
        &mut self,
        py: Python<'py>,
        play: PlayArguments,
    ) -> PyResult<(Bound<'py, PyAny>, Trace)> {
        let played = self.play_of(play).and_then(|play| {
            let trace: Played = self.0.shot(&play)?.simulate()?;
            Ok((self.0.apply(&play, &trace)?, trace))
        });
        let (ruling, trace) = played.map_err(|e| to_exception(py, &e))?;
        Ok((to_python(py, &self.0.ruling_node(&ruling))?, Trace::from(trace)))
    }

    fn choose<'py>(&mut self, py: Python<'py>, choice: &str) -> PyResult<Bound<'py, PyAny>> {
        let chosen = Choice::read(choice).and_then(|choice| self.0.choose(choice));
        let ruling = chosen.map_err(|e| to_exception(py, &e))?;
        to_python(py, &self.0.ruling_node(&ruling))
    }

    fn concede<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let ruling = self.0.concede().map_err(|e| to_exception(py, &e))?;
        to_python(py, &self.0.ruling_node(&ruling))
    }

    fn copy(&self) -> Self {
        Self(self.0.clone())
    }
}

/// The names of all rule sets.
#[pyfunction]
pub(crate) fn rule_sets() -> Vec<&'static str> {
    Rules::ALL.into_iter().map(Rules::name).collect()
}
