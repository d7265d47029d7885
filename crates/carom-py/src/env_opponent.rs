//! The opponents of environments that are outside of them: policies and players in Python, and external
//! programs.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use carom::{Error, ErrorKind};
use carom_arena::Clock;
use carom_env::{Answers, ArenaOpponents, Asked, Reply, VectorEnv};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::program::{Program, ProgramArguments, StopCheck};
use crate::progress::{self, Interrupt};
use crate::rules::{AnswerArguments, Frame};

/// An error of ours, or an exception that an opponent raised.
pub(crate) enum Stopped {
    Ours(Error),
    Theirs(PyErr),
}

impl From<Error> for Stopped {
    fn from(error: Error) -> Self {
        Self::Ours(error)
    }
}

impl From<PyErr> for Stopped {
    fn from(raised: PyErr) -> Self {
        Self::Theirs(raised)
    }
}

impl Stopped {
    pub(crate) fn exception(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Ours(error) => to_exception(py, &error),
            Self::Theirs(raised) => raised,
        }
    }
}

/// Asks an opponent in Python. `ask` gets observations, shape (k, size), and returns actions, shape (k,
/// width); or it gets a list of index, seat and frame, and returns a list of answers.
pub(crate) fn replies(
    ask: Option<&Py<PyAny>>,
    is_policy: bool,
    asked: &[Asked<'_>],
) -> Result<Vec<Reply>, Stopped> {
    let Some(ask) = ask else { return Ok(Vec::new()) };
    Python::attach(|py| {
        if is_policy {
            let mut rows = Vec::new();
            asked.iter().for_each(|asked| asked.observe(&mut rows));
            let size = rows.len() / asked.len();
            let rows = PyArray1::from_vec(py, rows).reshape([asked.len(), size])?;
            let actions: PyReadonlyArray2<'_, f32> = ask.bind(py).call1((rows,))?.extract()?;
            let actions = actions.as_array();
            return Ok(actions.rows().into_iter().map(|row| Reply::Action(row.to_vec())).collect());
        }
        let frames: Vec<(usize, usize, Option<Frame>)> = asked
            .iter()
            .map(|asked| {
                (asked.index, asked.seat(), asked.frame().map(|f| Frame::from(f.without_seed())))
            })
            .collect();
        let answers: Vec<AnswerArguments> = ask.bind(py).call1((frames,))?.extract()?;
        let read = |(asked, answer): (&Asked<'_>, AnswerArguments)| {
            let nothing =
                || ErrorKind::WrongState.at("opponent", "there is no frame", "choose a game");
            let frame = asked.frame().ok_or_else(nothing)?;
            let answer = answer.allowed(frame).map_err(|error| error.inside("opponent"))?;
            Ok(Reply::Answer(answer))
        };
        asked.iter().zip(answers).map(read).collect()
    })
}

/// The programs of a vector of environments, one process tree for each.
pub(crate) struct EnvPrograms {
    program: Arc<Program>,
    clock: Clock,
    interrupt: Arc<Interrupt>,
    opponents: Mutex<ArenaOpponents>,
}

impl EnvPrograms {
    /// A program that has `clock`, s, in each episode of `envs`.
    pub(crate) fn new(
        arguments: ProgramArguments,
        clock: Option<f64>,
        envs: &VectorEnv,
    ) -> Result<Self, Error> {
        let clock = clock.map_or_else(Clock::default, |amount| Clock::seconds(amount).per_frame());
        Self::of(Arc::new(Program::read(arguments)?), clock, envs)
    }

    /// The same program for other environments.
    pub(crate) fn again(&self, envs: &VectorEnv) -> Result<Self, Error> {
        Self::of(Arc::clone(&self.program), self.clock, envs)
    }

    fn of(program: Arc<Program>, clock: Clock, envs: &VectorEnv) -> Result<Self, Error> {
        let interrupt = Arc::new(Interrupt::default());
        let asked = Arc::clone(&interrupt);
        let is_stopped: StopCheck<'static> = Arc::new(move || asked.is_asked());
        let (made, stop) = (Arc::clone(&program), Arc::clone(&is_stopped));
        let make = Arc::new(move || made.player(Arc::clone(&stop), None));
        let opponents = ArenaOpponents::new(envs, make, clock, is_stopped)?.into();
        Ok(Self { program, clock, interrupt, opponents })
    }

    /// Runs `work` with the programs as its opponents, and ends those whose episodes are over. Ctrl-C
    /// stops a program that thinks, and is raised.
    pub(crate) fn run<T: Send>(
        &self,
        py: Python<'_>,
        envs: &mut VectorEnv,
        work: impl FnOnce(&mut VectorEnv, &mut Answers<'_, Stopped>) -> Result<T, Stopped> + Send,
    ) -> PyResult<T> {
        let mut lock = self.lock();
        let opponents = &mut *lock;
        let done = progress::watched(py, &self.interrupt, || {
            let done = work(envs, &mut |asked| Ok(opponents.replies(asked)?));
            opponents.end_over(envs);
            done
        });
        if self.interrupt.take() && done.is_ok() {
            return Err(PyKeyboardInterrupt::new_err(()));
        }
        done?.map_err(|stopped| stopped.exception(py))
    }

    /// Ends the programs whose episodes are over.
    pub(crate) fn end_over(&self, py: Python<'_>, envs: &VectorEnv) {
        let mut lock = self.lock();
        let opponents = &mut *lock;
        py.detach(|| opponents.end_over(envs));
    }

    /// Ends all programs.
    pub(crate) fn end_all(&self, py: Python<'_>) {
        let mut lock = self.lock();
        let opponents = &mut *lock;
        py.detach(|| opponents.end_all());
    }

    fn lock(&self) -> MutexGuard<'_, ArenaOpponents> {
        self.opponents.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
