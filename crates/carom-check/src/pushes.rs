//! How long the cloth has pressed each ball against others or a rail: while it does, contacts follow
//! each other without end, and hops become longer (docs/guarantees.md, “Slow impacts”).

use carom::event::{Event, EventKind};
use carom::{MotionState, Shot};

/// In a push that has lasted as long as this, s, balls may count as smooth: the engine's
/// `SLIPPERY_PUSH`, rounded down.
const LONG: f64 = 4.9e-3;

/// Contacts that follow each other within this time, s, belong to one push, and in a long one within
/// this share of its time: more than the engine's `PUSH_GAP` and `LONG_PUSH_GAP`.
const GAP: f64 = 5e-3;
const GAP_SHARE: f64 = 0.15;

/// The fastest hop of a push, m/s: the engine's `MIN_SEPARATION`, rounded up, which grows by its
/// `SEPARATION_GROWTH`, m/s², and the engine's `LONG_PUSH_SHARE`, rounded up, of the speeds of the
/// surfaces.
const HOP: f64 = 1.1e-3;
const GROWTH: f64 = 0.01;
const SHARE: f64 = 1.01e-2;

/// The pushes of all balls.
#[derive(Clone, Debug)]
pub(crate) struct Pushes {
    /// When each ball's push began, and its last contact, s.
    balls: Vec<[f64; 2]>,
}

impl Pushes {
    /// No pushes of `count` balls.
    pub(crate) fn new(count: usize) -> Self {
        Self { balls: vec![[f64::INFINITY, f64::NEG_INFINITY]; count] }
    }

    /// Counts the event as a contact of its balls. Returns the speed up to which it may be a hop in a
    /// long push, m/s, or 0 if it is none.
    pub(crate) fn touch(&mut self, event: &Event<'_>, shot: &Shot) -> f64 {
        let touches = matches!(
            event.kind,
            EventKind::CueStrike { .. } | EventKind::BallCollision | EventKind::RailCollision(_)
        );
        if !touches {
            return 0.0;
        }
        let (mut push, mut surfaces) = (f64::INFINITY, 0.0);
        for (&ball, before) in event.balls.iter().zip(event.before) {
            let i = usize::from(ball);
            let [since, last] = &mut self.balls[i];
            if event.time - *last > (GAP_SHARE * (*last - *since)).max(GAP) {
                *since = event.time;
            }
            *last = event.time;
            push = push.min(event.time - *since);
            surfaces += shot.balls()[i].ball.radius * before.angular_velocity.length();
        }
        let flies = event.before.iter().any(|ball| ball.motion == MotionState::Airborne);
        if flies || push <= LONG {
            return 0.0;
        }
        (HOP + GROWTH * push).min((SHARE * surfaces).max(HOP))
    }
}
