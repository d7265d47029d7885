//! What happened in a frame: its moves, and its end.

use carom::error::InputError;
use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom::shot::Cling;
use carom_mind::Answer;
use carom_rules::{Ruling, Seat};

use crate::clock::Cost;
use crate::luck::ShotLuck;

/// The executed part of a shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Execution {
    /// The strike with its errors, as it was played.
    pub strike: Strike,
    /// Where a cue ball in hand was put (file coordinates, m). It differs from the intended place
    /// only if the player saw the balls with errors and another ball was in the way.
    pub cue_ball: Option<[f64; 2]>,
    /// The contacts that clung.
    pub cling: Cling,
}

/// The consequence of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// The shot was played.
    Played {
        /// The strike that came out.
        execution: Execution,
        /// The ruling on it.
        ruling: Ruling,
        /// The hash of the shot's trace.
        trace: u64,
        /// Its luck; `None` if it is not measured.
        luck: Option<ShotLuck>,
    },
    /// The shot reached its cap of events. The frame ends and does not count.
    Capped {
        /// The strike that came out.
        execution: Execution,
    },
    /// The choice was applied.
    Chosen {
        /// The ruling on it.
        ruling: Ruling,
    },
    /// The player conceded the frame.
    Conceded,
    /// The answer was refused; the same request stands.
    Refused(InputError),
    /// The answer came after the player's time was over. It was not looked at.
    Late,
    /// The player gave no answer: it failed, or the referee ended the frame for another reason.
    Failed {
        /// Why the frame ended.
        reason: EndReason,
        /// The same in words.
        why: String,
    },
}

/// One answer of a player, or its failure, and the consequence.
#[derive(Clone, Debug, PartialEq)]
pub struct ArenaMove {
    /// The seat that was asked.
    pub seat: Seat,
    /// The answer; `None` if the player gave none that could be read.
    pub answer: Option<Answer>,
    /// Whether the answer is the same break of the settings. The player was not asked then.
    pub is_given: bool,
    /// The probability with which the player expected to win.
    pub win_chance: Option<f64>,
    /// What else the player said of its decision.
    pub info: Option<Node>,
    /// What the decision cost.
    pub cost: Cost,
    /// The consequence.
    pub effect: Effect,
}

impl ArenaMove {
    /// A request to `seat` that got no answer that could be read.
    pub(crate) const fn without_answer(seat: Seat, cost: Cost, effect: Effect) -> Self {
        let (answer, win_chance, info) = (None, None, None);
        Self { seat, answer, is_given: false, win_chance, info, cost, effect }
    }
}

/// Why a frame ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EndReason {
    /// A player won by the rules of the game.
    Won,
    /// Undecided by the rules: a second stalemate, or equal scores. Half a point each.
    Drawn,
    /// A player conceded.
    Conceded,
    /// A player's time was over.
    TimeOver,
    /// A player gave more refused answers than a frame allows.
    Refusals,
    /// A shot reached its cap of events. The frame does not count.
    EventCap,
    /// A player ended, or returned an error.
    Crash,
    /// A program did not answer and did not end.
    Stall,
    /// A program wrote more than the referee reads.
    Flood,
    /// A program wrote a line that is too long.
    LongLine,
}

impl EndReason {
    /// Every reason.
    pub const ALL: [Self; 10] = [
        Self::Won,
        Self::Drawn,
        Self::Conceded,
        Self::TimeOver,
        Self::Refusals,
        Self::EventCap,
        Self::Crash,
        Self::Stall,
        Self::Flood,
        Self::LongLine,
    ];

    /// The reasons for which a referee may end a frame ([`crate::ArenaFrame::forfeit`]).
    pub(crate) const FAILURES: [Self; 5] =
        [Self::TimeOver, Self::Crash, Self::Stall, Self::Flood, Self::LongLine];

    /// The reason's name in records.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Won => "won",
            Self::Drawn => "drawn",
            Self::Conceded => "conceded",
            Self::TimeOver => "time-over",
            Self::Refusals => "refusals",
            Self::EventCap => "event-cap",
            Self::Crash => "crash",
            Self::Stall => "stall",
            Self::Flood => "flood",
            Self::LongLine => "long-line",
        }
    }

    /// The reason called `name`, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|reason| reason.name() == name)
    }
}

/// The end of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameEnd {
    /// The seat that won; `None` if the frame is undecided or does not count.
    pub winner: Option<Seat>,
    /// Why the frame ended.
    pub reason: EndReason,
    /// The same in words.
    pub why: String,
}

impl FrameEnd {
    /// The points of seat 0: 1, ½ or 0; `None` if the frame does not count.
    pub const fn points(&self) -> Option<f64> {
        match (self.reason, self.winner) {
            (EndReason::EventCap, _) => None,
            (_, Some(0)) => Some(1.0),
            (_, Some(_)) => Some(0.0),
            (_, None) => Some(0.5),
        }
    }
}
