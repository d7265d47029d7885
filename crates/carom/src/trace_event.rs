//! Events as traces and outcomes use them: rails and pockets by name, states in the file's
//! coordinates.

use crate::event::EventKind;
use crate::table::{Part, PocketName, Rail};
use crate::{BallState, MotionState, Table};

/// The kind of an event, with the names of rails and pockets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TraceEventKind {
    /// The cue meets the cue ball.
    CueStrike {
        /// How often the tip met the ball. More than one contact is a double hit.
        tip_contacts: u8,
        /// Whether the cue ball met a ball that it did not touch before, while the tip was on it.
        pushed: bool,
    },
    /// Two balls collide, or several balls in one many-ball contact.
    BallCollision,
    /// A ball meets a cushion.
    RailCollision {
        /// The rail.
        rail: Rail,
        /// The part of its cushion.
        part: Part,
    },
    /// A ball falls into a pocket.
    PocketCollision(PocketName),
    /// A ball bounces on the slate, or on the edge of a hole in it.
    SlateCollision,
    /// A ball leaves the table, or comes to rest on a rail's top.
    OffTable,
    /// A motion state ends by the passage of time.
    MotionTransition {
        /// State that ended.
        from: MotionState,
        /// State that follows.
        to: MotionState,
    },
}

impl TraceEventKind {
    /// The engine's `kind` of event with the names of `table`.
    pub fn of(kind: EventKind, table: &Table) -> Self {
        match kind {
            EventKind::CueStrike { tip_contacts, pushed } => {
                Self::CueStrike { tip_contacts, pushed }
            }
            EventKind::BallCollision => Self::BallCollision,
            EventKind::RailCollision(i) => {
                let cushion = &table.cushions[usize::from(i)];
                Self::RailCollision { rail: cushion.rail, part: cushion.part }
            }
            EventKind::PocketCollision(i) => {
                Self::PocketCollision(table.pockets[usize::from(i)].name)
            }
            EventKind::SlateCollision => Self::SlateCollision,
            EventKind::OffTable => Self::OffTable,
            EventKind::MotionTransition { from, to } => Self::MotionTransition { from, to },
        }
    }

    /// The event's `type` in a trace.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CueStrike { .. } => "cue-strike",
            Self::BallCollision => "ball-collision",
            Self::RailCollision { .. } => "rail-collision",
            Self::PocketCollision(_) => "pocket-collision",
            Self::SlateCollision => "slate-collision",
            Self::OffTable => "off-table",
            Self::MotionTransition { .. } => "motion-transition",
        }
    }
}

/// One event of a trace; states in the file's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceEvent<'a> {
    /// Time since the strike, s.
    pub time: f64,
    /// What happened.
    pub kind: TraceEventKind,
    /// The balls in it, by index into the shot's balls.
    pub balls: &'a [u16],
    /// Their states just before.
    pub before: &'a [BallState],
    /// Their states just after.
    pub after: &'a [BallState],
}
