//! What happens, and who is told.

use crate::{BallState, MotionState};

/// The kinds of event (Leckie & Greenspan 2006, section 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// The cue meets the cue ball.
    CueStrike,
    /// Two balls collide, or several in one many-ball contact.
    BallCollision,
    /// A ball meets a cushion: index into `Table::cushions`.
    RailCollision(u16),
    /// A ball falls into a pocket: index into `Table::pockets`.
    PocketCollision(u8),
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

/// One event, with the states of the balls in it just before and just after.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a> {
    /// Time since the strike, s.
    pub time: f64,
    /// What happened.
    pub kind: EventKind,
    /// The balls in it, by index into the shot's balls.
    pub balls: &'a [u16],
    /// Their states just before, in the engine's frame (origin at the table's centre).
    pub before: &'a [BallState],
    /// Their states just after.
    pub after: &'a [BallState],
}

/// Listens to a shot while it is simulated. A generic parameter of the event loop, so that a
/// batch that only counts pays for nothing else.
pub trait Recorder {
    /// Called once per event, in order.
    fn record(&mut self, event: &Event<'_>);
}

/// Listens to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NullRecorder;

impl Recorder for NullRecorder {
    #[inline(always)]
    fn record(&mut self, _: &Event<'_>) {}
}
