//! Checks of players: `_core.check_player`.

use std::sync::Arc;

use carom::error::InputError;
use carom_arena::{CheckSettings, CheckVerdict, Clock};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::match_player::{Entrant, EntrantArguments, Raised};
use crate::node::to_python;
use crate::program::StopCheck;
use crate::progress::{self, Watch};

/// A verdict; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct VerdictFields<'py> {
    situation: String,
    game: &'static str,
    passed: Option<bool>,
    answer: Bound<'py, PyAny>,
    /// Kind, place, fault and remedy.
    fault: Option<[String; 4]>,
    seconds: f64,
}

impl<'py> VerdictFields<'py> {
    fn new(py: Python<'py>, verdict: CheckVerdict) -> PyResult<Self> {
        let CheckVerdict { situation, game, passed, answer, fault, seconds } = verdict;
        let fault = fault.map(|InputError { kind, place, what, remedy, .. }| {
            [kind.name().to_owned(), place, what, remedy]
        });
        Ok(Self { situation, game, passed, answer: to_python(py, &answer)?, fault, seconds })
    }
}

/// Asks a player in situations of every kind. `seconds` is its clock in each of them. `report` is called
/// with 0, situations done, all situations. `interrupt` as for `play_match`.
#[pyfunction]
pub(crate) fn check_player<'py>(
    py: Python<'py>,
    player: EntrantArguments,
    seconds: f64,
    report: Py<PyAny>,
) -> PyResult<Vec<VerdictFields<'py>>> {
    let raise = |error| to_exception(py, &error);
    let raised = Raised::default();
    let entrant = Entrant::read(player, &raised).map_err(raise)?;
    let clock = entrant.clock(Clock::seconds(seconds).per_frame());
    clock.check().map_err(raise)?;
    let settings = CheckSettings { clock, is_program: entrant.is_program() };
    let watch = if entrant.is_outside() { Watch::Here } else { Watch::Beside(&|| ()) };
    let found = progress::run_with(py, &report, &watch, |progress| {
        let is_stopped: StopCheck<'_> = Arc::new(|| progress.is_stopped());
        let make = |settings| entrant.make_checked(settings, &is_stopped);
        carom_arena::check(&make, &settings, progress, &mut |_| ())
    });
    if let Some(error) = raised.take() {
        return Err(error);
    }
    found?.into_iter().map(|verdict| VerdictFields::new(py, verdict)).collect()
}
