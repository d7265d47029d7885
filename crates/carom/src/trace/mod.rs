//! A recorded shot: every event with the states before and after, in the file's frame.

mod difference;
mod file;
mod hash;
mod orientation;
mod piece;
mod polyline;
mod record;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

pub use orientation::Orientations;
pub use piece::Piece;
pub use polyline::Waypoint;
pub use record::TraceRecorder;

use crate::error::Error;
use crate::event::EventKind;
use crate::motion::Path;
use crate::outcome::Outcome;
use crate::shot::Shot;
use crate::table::{Part, PocketName, Rail};
use crate::{BallState, MotionState, Table};

/// What `format` says in a trace.
pub const FORMAT: &str = "carom-trace/1";

/// The name and version that this engine writes into its traces.
pub const ENGINE: &str = concat!("carom ", env!("CARGO_PKG_VERSION"));

/// What happened in an event, in the words of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum What {
    /// The cue meets the cue ball.
    CueStrike,
    /// Two balls collide, or several in one many-ball contact.
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

impl What {
    /// What the engine's `kind` of event is called on `table`.
    pub fn of(kind: EventKind, table: &Table) -> Self {
        match kind {
            EventKind::CueStrike => Self::CueStrike,
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
            Self::CueStrike => "cue-strike",
            Self::BallCollision => "ball-collision",
            Self::RailCollision { .. } => "rail-collision",
            Self::PocketCollision(_) => "pocket-collision",
            Self::SlateCollision => "slate-collision",
            Self::OffTable => "off-table",
            Self::MotionTransition { .. } => "motion-transition",
        }
    }
}

/// One event of a trace; states in the file's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceEvent<'a> {
    /// Time since the strike, s.
    pub time: f64,
    /// What happened.
    pub what: What,
    /// The balls in it, by index into the shot's balls.
    pub balls: &'a [u16],
    /// Their states just before.
    pub before: &'a [BallState],
    /// Their states just after.
    pub after: &'a [BallState],
}

/// A recorded shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    shot: Shot,
    engine: String,
    duration: f64,
    log: Log,
    last: Vec<BallState>,
    outcome: Outcome,
}

/// Events in a row: the balls and states of all of them stand in one list each, so that recording
/// allocates a few times a shot and not a few times an event.
#[derive(Clone, Debug, Default, PartialEq)]
struct Log {
    entries: Vec<Entry>,
    balls: Vec<u16>,
    before: Vec<BallState>,
    after: Vec<BallState>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    time: f64,
    what: What,
    start: usize,
    end: usize,
}

impl Log {
    fn push(&mut self, time: f64, what: What, balls: &[u16]) {
        let start = self.balls.len();
        self.balls.extend_from_slice(balls);
        self.entries.push(Entry { time, what, start, end: self.balls.len() });
    }

    fn get(&self, entry: &Entry) -> TraceEvent<'_> {
        let Entry { time, what, start, end } = *entry;
        TraceEvent {
            time,
            what,
            balls: &self.balls[start..end],
            before: &self.before[start..end],
            after: &self.after[start..end],
        }
    }
}

impl Trace {
    /// The shot that was simulated.
    pub const fn shot(&self) -> &Shot {
        &self.shot
    }

    /// Name and version of the engine that simulated it.
    pub fn engine(&self) -> &str {
        &self.engine
    }

    /// Time from the strike to the last event, s.
    pub const fn duration(&self) -> f64 {
        self.duration
    }

    /// The events, in order.
    pub fn events(&self) -> impl ExactSizeIterator<Item = TraceEvent<'_>> + DoubleEndedIterator {
        self.log.entries.iter().map(|e| self.log.get(e))
    }

    /// The balls' states when the shot is over, in the file's frame.
    pub fn last(&self) -> &[BallState] {
        &self.last
    }

    /// What a referee needs.
    pub const fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    /// All balls' states at `time` (s), in the file's frame: exact to rounding, since each follows
    /// the closed form from its last event. At the instant of an event, the state after it; after
    /// the end, the final state.
    ///
    /// # Errors
    /// [`Error::Input`] if `time` is negative or not finite.
    pub fn at(&self, time: f64) -> Result<Vec<BallState>, Error> {
        if !(time >= 0.0 && time.is_finite()) {
            return Err(Error::input(
                "time",
                format!("there is nothing at {time:?} s"),
                "ask for a finite time ≥ 0",
            ));
        }
        let mut states: Vec<(f64, BallState)> =
            self.shot.balls.iter().map(|b| (0.0, b.state)).collect();
        for event in self.events().take_while(|e| e.time <= time) {
            for (&ball, after) in event.balls.iter().zip(event.after) {
                states[usize::from(ball)] = (event.time, *after);
            }
        }
        let physics = &*self.shot.physics;
        let on = |((since, state), placed): (&(f64, BallState), &crate::shot::PlacedBall)| {
            if time == *since {
                return *state;
            }
            let path = Path::new(state, &placed.ball, &physics.cloth, physics.gravity);
            path.at((time - since).min(path.duration))
        };
        Ok(states.iter().zip(self.shot.balls()).map(on).collect())
    }
}
