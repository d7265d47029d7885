//! Events of a shot, and the recorders that receive them.

use crate::{BallState, MotionState};

/// The kinds of event (Leckie & Greenspan 2006, section 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// The cue strikes the cue ball. The balls that it moves through others at the same instant
    /// follow the cue ball in the event's list.
    CueStrike {
        /// How often the tip met the ball. More than one contact is a double hit.
        tip_contacts: u8,
        /// Whether the cue ball met a ball that it did not touch before, while the tip was on it.
        pushed: bool,
    },
    /// Two balls collide, or several that touch.
    BallCollision,
    /// A ball hits a cushion: index into `Table::cushions`.
    RailCollision(u16),
    /// A ball falls into a pocket: index into `Table::pockets`.
    PocketCollision(u8),
    /// A ball bounces on the slate, or on the edge of a hole in it.
    SlateCollision,
    /// A ball leaves the table, or comes to rest on a rail's top.
    OffTable,
    /// A motion state ends because its time is over.
    MotionTransition {
        /// State that ended.
        from: MotionState,
        /// State that follows.
        to: MotionState,
    },
}

/// One event, with the states of its balls just before and just after.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a> {
    /// Time since the strike, s.
    pub time: f64,
    /// What happened.
    pub kind: EventKind,
    /// Indices of the event's balls in the shot.
    pub balls: &'a [u16],
    /// States of these balls just before the event, in the engine's coordinates (origin at the
    /// table's centre).
    pub before: &'a [BallState],
    /// States of these balls just after the event.
    pub after: &'a [BallState],
}

impl Event<'_> {
    /// Whether balls meet: in a collision, or in a strike that moves further balls through the cue
    /// ball.
    pub fn is_ball_contact(&self) -> bool {
        match self.kind {
            EventKind::BallCollision => true,
            EventKind::CueStrike { .. } => self.balls.len() > 1,
            _ => false,
        }
    }

    /// The ball nearest to `ball` among the event's other balls, if `ball` takes part.
    pub fn nearest_to(&self, ball: u16) -> Option<u16> {
        let own = self.balls.iter().position(|&b| b == ball)?;
        let apart = |k: usize| (self.before[k].position - self.before[own].position).length();
        let others = (0..self.balls.len()).filter(|&k| k != own);
        others.min_by(|&a, &b| apart(a).total_cmp(&apart(b))).map(|k| self.balls[k])
    }
}

/// Receives the events of a shot while it is simulated. The event loop has the recorder's type as a
/// generic parameter, so that a recorder costs no more than what it does with the events.
pub trait Recorder {
    /// Called once per event, in order.
    fn record(&mut self, event: &Event<'_>);
}

impl<R: Recorder + ?Sized> Recorder for &mut R {
    #[inline(always)]
    fn record(&mut self, event: &Event<'_>) {
        (**self).record(event);
    }
}

/// Both recorders get every event, the first one first.
impl<A: Recorder, B: Recorder> Recorder for (A, B) {
    #[inline(always)]
    fn record(&mut self, event: &Event<'_>) {
        self.0.record(event);
        self.1.record(event);
    }
}

/// Ignores every event.
#[derive(Clone, Copy, Debug, Default)]
pub struct NullRecorder;

impl Recorder for NullRecorder {
    #[inline(always)]
    fn record(&mut self, _: &Event<'_>) {}
}
