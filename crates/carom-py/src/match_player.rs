//! The players of a match: built-in ones, external programs, and objects in Python that are asked
//! through a function.

use std::sync::{Arc, Mutex, PoisonError};

use carom::ErrorKind;
use carom::error::{Error, InputError};
use carom::format::Node;
use carom_arena::{
    ArenaFrame, Ask, BuiltInPlayer, Clock, ClockUnit, EndReason, MatchPlayer, PlayerEntry,
    ProtocolSettings, Response,
};
use carom_mind::{Budget, Decision, Player, Spent};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::program::{Program, ProgramArguments, StopCheck};
use crate::rules::{AnswerArguments, Frame};

/// A player of a match: the name of a built-in one; name, class, and the function that begins a frame,
/// which returns the one that is asked, see [`Outside::said`]; or the arguments of [`program::Program`].
#[derive(FromPyObject)]
pub(crate) enum EntrantArguments {
    BuiltIn(String),
    Outside(String, String, Py<PyAny>),
    Program(ProgramArguments),
}

/// Simulated shots of a decision of a built-in player that is checked, if its name has none.
const BUILT_IN_SIMULATIONS: u32 = 200;

/// The first exception that ends a match.
#[derive(Clone, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<PyErr>>>);

impl Raised {
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn keep(&self, error: PyErr) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }
}

/// A player of a match, before its frames.
pub(crate) enum Entrant {
    BuiltIn(BuiltInPlayer),
    Outside { entry: PlayerEntry, begin: Arc<Py<PyAny>>, raised: Raised },
    Program(Box<Program>),
}

impl Entrant {
    pub(crate) fn read(arguments: EntrantArguments, raised: &Raised) -> Result<Self, Error> {
        Ok(match arguments {
            EntrantArguments::BuiltIn(name) => Self::BuiltIn(BuiltInPlayer::read(&name)?),
            EntrantArguments::Outside(name, class, begin) => {
                let settings = Node::object([("python", class.into())]);
                let entry = PlayerEntry { name, settings };
                Self::Outside { entry, begin: begin.into(), raised: raised.clone() }
            }
            EntrantArguments::Program(arguments) => Self::Program(Program::read(arguments)?.into()),
        })
    }

    pub(crate) const fn is_outside(&self) -> bool {
        matches!(self, Self::Outside { .. })
    }

    /// The player's clock where `usual` is that of a player that is asked: built-in ones count simulated
    /// shots.
    pub(crate) fn clock(&self, usual: Clock) -> Clock {
        match self {
            Self::BuiltIn(player) => player.clock(Clock::simulations(BUILT_IN_SIMULATIONS)),
            Self::Outside { .. } | Self::Program(_) => usual,
        }
    }

    /// Whether it is a program that speaks the protocol.
    pub(crate) const fn is_program(&self) -> bool {
        matches!(self, Self::Program(_))
    }

    /// The player for one frame; a program is asked as `settings` say.
    pub(crate) fn make_checked<'s>(
        &'s self,
        settings: ProtocolSettings,
        is_stopped: &StopCheck<'s>,
    ) -> Result<Seated<'s>, Error> {
        match self {
            Self::Program(program) => {
                Ok(Seated::Program(program.player(Arc::clone(is_stopped), Some(settings))))
            }
            _ => self.make(is_stopped),
        }
    }

    /// The player as the header of a record has it.
    pub(crate) fn entry(&self) -> Node {
        let PlayerEntry { name, settings } = match self {
            Self::BuiltIn(player) => player.entry(),
            Self::Outside { entry, .. } => entry.clone(),
            Self::Program(program) => program.entry(),
        };
        Node::object([("name", name.into()), ("settings", settings)])
    }

    /// The player for one frame. `is_stopped` says whether the match was stopped.
    pub(crate) fn make<'s>(&'s self, is_stopped: &StopCheck<'s>) -> Result<Seated<'s>, Error> {
        Ok(match self {
            Self::BuiltIn(player) => Seated::BuiltIn(player.make()?),
            Self::Outside { begin, raised, .. } => {
                let (begin, raised) = (Arc::clone(begin), raised.clone());
                Seated::Outside(Outside { begin, ask: None, raised })
            }
            Self::Program(program) => Seated::Program(program.player(Arc::clone(is_stopped), None)),
        })
    }
}

/// A player in a frame.
pub(crate) enum Seated<'s> {
    BuiltIn(Box<dyn Player>),
    Outside(Outside),
    Program(Box<dyn MatchPlayer + 's>),
}

impl Seated<'_> {
    fn as_player(&mut self) -> &mut dyn MatchPlayer {
        match self {
            Self::BuiltIn(player) => player,
            Self::Outside(player) => player,
            Self::Program(player) => &mut **player,
        }
    }
}

impl MatchPlayer for Seated<'_> {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        self.as_player().respond(ask, budget)
    }

    fn seconds(&self) -> Option<f64> {
        match self {
            Self::BuiltIn(_) | Self::Outside(_) => None,
            Self::Program(player) => player.seconds(),
        }
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        self.as_player().frame_over(frame);
    }
}

/// What the function of a player in Python returns.
#[derive(FromPyObject)]
enum Said {
    /// The answer, the chance to win, simulated shots and rounds.
    Answer(AnswerArguments, Option<f64>, u64, u32),
    /// An answer that is none: kind, place, fault and remedy of the error.
    Unread(String, String, String, String),
    /// The exception of the player, in one line.
    Failed(String),
}

/// A player in Python.
pub(crate) struct Outside {
    begin: Arc<Py<PyAny>>,
    /// The function that is asked; none before the first request of the frame.
    ask: Option<Py<PyAny>>,
    raised: Raised,
}

impl Outside {
    /// Asks the player: the frame that it sees, the number of the frame in the match, its number and
    /// its seat, what is left on its clock and the budget of the decision, whether both are seconds, the
    /// seed of its random numbers, and the refusal of its last answer.
    fn said(&mut self, py: Python<'_>, ask: &Ask<'_>) -> PyResult<Said> {
        let function = match &mut self.ask {
            Some(function) => function,
            none => none.insert(self.begin.call1(py, (ask.frame_number, ask.seat))?),
        };
        let frame = Frame::from(ask.situation.frame.without_seed());
        let left = ask.left[ask.seat].unwrap_or(ask.budget);
        let in_seconds = ask.clock.unit == ClockUnit::Seconds;
        let refused = ask.refused.map(|fault| {
            let exception = to_exception(py, &Error::Input(Box::new(fault.clone())));
            exception.into_value(py)
        });
        let fields = (frame, ask.seat, left, ask.budget, in_seconds, ask.situation.seed, refused);
        function.call1(py, fields)?.extract(py)
    }
}

impl MatchPlayer for Outside {
    fn respond(&mut self, ask: &Ask<'_>, _: &Budget<'_>) -> Response {
        let said = match Python::attach(|py| self.said(py, ask)) {
            Ok(said) => said,
            Err(error) => {
                self.raised.keep(error);
                return Response::Stop;
            }
        };
        match said {
            Said::Answer(arguments, win_chance, simulations, rounds) => {
                let spent = Spent { simulations, rounds };
                match arguments.read(ask.situation.frame) {
                    Ok(answer) => Response::Decision(Decision { answer, win_chance, spent }),
                    Err(Error::Input(fault)) => Response::Unread(*fault, spent),
                    Err(other) => Response::Failed(EndReason::Crash, other.to_string()),
                }
            }
            Said::Unread(kind, place, what, remedy) => {
                let known = ErrorKind::ALL.iter().find(|known| known.name() == kind);
                let kind = known.copied().unwrap_or(ErrorKind::Syntax);
                let details = Vec::new();
                let fault = InputError { kind, place, what, remedy, details };
                Response::Unread(fault, Spent::default())
            }
            Said::Failed(why) => Response::Failed(EndReason::Crash, why),
        }
    }
}
