//! A recorded shot: every event with the states before and after, in the file's coordinates.

mod difference;
mod hash;
mod impact;
mod orientation;
mod piece;
mod polyline;
mod record;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

pub use hash::TraceHashRecorder;
pub use orientation::Orientations;
pub use piece::Piece;
pub use polyline::Waypoint;
pub use record::TraceRecorder;

use crate::BallState;
use crate::error::{Error, ErrorKind};
use crate::motion::Path;
use crate::outcome::Outcome;
use crate::shot::Shot;
pub use crate::trace_event::{TraceEvent, TraceEventKind};

pub use crate::version::ENGINE;

/// What ended a recorded shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TraceEnd {
    /// Nothing more can happen: every ball is at rest, or no friction stops it and it meets
    /// nothing.
    Rest,
    /// The shot's end time ([`Shot::until`]), at which a ball still moves.
    Until,
    /// The cap on events ([`Shot::max_events`]). The trace is part of an error.
    Cap,
}

impl TraceEnd {
    /// Every end.
    pub const ALL: [Self; 3] = [Self::Rest, Self::Until, Self::Cap];

    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rest => "rest",
            Self::Until => "until",
            Self::Cap => "cap",
        }
    }

    /// The end of a simulation of `shot` that did not reach its cap; `last` are the final states.
    pub(crate) fn of(shot: &Shot, last: &[BallState]) -> Self {
        let moves = last.iter().any(|state| !state.motion.is_at_rest());
        if moves && shot.until.is_some() { Self::Until } else { Self::Rest }
    }
}

/// A recorded shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    shot: Shot,
    engine: String,
    duration: f64,
    end: TraceEnd,
    log: Log,
    last: Vec<BallState>,
    outcome: Outcome,
}

/// The events in order. The balls of all events share one list, and so do the states, so that
/// recording allocates a few times per shot and not for each event.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Log {
    entries: Vec<Entry>,
    balls: Vec<u16>,
    pub(crate) before: Vec<BallState>,
    pub(crate) after: Vec<BallState>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    time: f64,
    kind: TraceEventKind,
    start: usize,
    end: usize,
}

impl Log {
    pub(crate) fn push(&mut self, time: f64, kind: TraceEventKind, balls: &[u16]) {
        let start = self.balls.len();
        self.balls.extend_from_slice(balls);
        self.entries.push(Entry { time, kind, start, end: self.balls.len() });
    }

    fn get(&self, entry: &Entry) -> TraceEvent<'_> {
        let Entry { time, kind, start, end } = *entry;
        TraceEvent {
            time,
            kind,
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

    /// Time from the strike to the end, s: to the last event, or to the shot's end time if a ball
    /// still moves then.
    pub const fn duration(&self) -> f64 {
        self.duration
    }

    /// What ended the shot.
    pub const fn end(&self) -> TraceEnd {
        self.end
    }

    /// The last time that the trace describes, s: infinite after an end at rest.
    fn horizon(&self) -> f64 {
        if self.end == TraceEnd::Rest { f64::INFINITY } else { self.duration }
    }

    /// The events, in order.
    pub fn events(&self) -> impl ExactSizeIterator<Item = TraceEvent<'_>> + DoubleEndedIterator {
        self.log.entries.iter().map(|e| self.log.get(e))
    }

    /// The balls' states when the shot is over, in the file's coordinates.
    pub fn last(&self) -> &[BallState] {
        &self.last
    }

    /// The outcome of the shot: the facts that rules need.
    pub const fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    /// All balls' states at `time` (s), in the file's coordinates, exact to rounding: each is
    /// computed from the closed-form path since the ball's last event. At the instant of an event
    /// it is the state after the event. After the end it is the final state; but after an end at
    /// rest a ball that no friction stops moves on.
    ///
    /// # Errors
    /// [`Error::Input`] if `time` is negative or not finite.
    pub fn at(&self, time: f64) -> Result<Vec<BallState>, Error> {
        if !(time >= 0.0 && time.is_finite()) {
            return Err(ErrorKind::OutOfRange.at(
                "time",
                format!("{time:?} s is out of range"),
                "give a finite time ≥ 0",
            ));
        }
        let mut states: Vec<(f64, BallState)> =
            self.shot.balls.iter().map(|b| (0.0, b.state)).collect();
        for event in self.events().take_while(|e| e.time <= time) {
            for (&ball, after) in event.balls.iter().zip(event.after) {
                states[usize::from(ball)] = (event.time, *after);
            }
        }
        if time >= self.horizon() {
            return Ok(self.last.clone());
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
