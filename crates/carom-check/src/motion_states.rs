//! Checks the motion states: a ball moves as its state says, a state ends when it has to, and
//! nothing jumps where it ends (docs/guarantees.md, “Every shot ends”).

use carom::event::{Event, EventKind};
use carom::math::Vec2;
use carom::shot::Shot;
use carom::{BallState, MotionState};

use crate::rolling;

/// Largest jump of a velocity, or of the velocity of a ball's surface, where a motion state ends,
/// m/s per m/s: rounding, and the slip below which the engine lets a ball roll.
pub(crate) const SMOOTH: f64 = 1e-11;

/// Slip below which the engine lets a ball roll, m/s, rounded up.
const STILL: f64 = 1.000_001e-13;

/// Largest time by which a motion state may last too long, s: the rounding of a time of a long
/// shot.
const OVERRUN: f64 = 1e-11;

/// Slip at the cloth, v + Rẑ×ω, m/s.
fn slip(s: &BallState, radius: f64) -> Vec2 {
    let (v, w) = (s.velocity, s.angular_velocity);
    Vec2::new(v.x - radius * w.y, v.y + radius * w.x)
}

/// Speed of the centre and of the surface, m/s.
fn speeds(s: &BallState, radius: f64) -> f64 {
    s.velocity.length() + radius * s.angular_velocity.length()
}

/// How long a ball stays in its motion state if nothing touches it, s (Leckie & Greenspan 2005); a
/// rolling ball, in its band of rolling resistance.
fn longest(shot: &Shot, s: &BallState, radius: f64) -> f64 {
    let (cloth, g) = (shot.physics().cloth, shot.physics().gravity);
    match s.motion {
        // The slip falls at 7/2 of μg: one part is the centre's, 5/2 are the surface's.
        MotionState::Sliding => slip(s, radius).length() / (3.5 * cloth.sliding_friction * g),
        MotionState::Rolling => {
            let speed = s.velocity.length();
            let (friction, low) = rolling::band(&cloth, speed);
            (speed - low) / (friction * g)
        }
        MotionState::Spinning => s.angular_velocity.z.abs() / cloth.spin_deceleration,
        _ => f64::INFINITY,
    }
}

/// The error in a motion state of ball `ball` that began with `s` and has lasted `since`, s.
pub(crate) fn overrun(shot: &Shot, ball: usize, s: &BallState, since: f64) -> Option<String> {
    let longest = longest(shot, s, shot.balls()[ball].ball.radius);
    let late = since - longest;
    (late > OVERRUN * (1.0 + longest)).then(|| {
        let state = s.motion.name();
        format!("ball {ball} is {state} for {late:e} s longer than friction lets it")
    })
}

/// The place of a state in the order in which a ball passes through them without an impact.
fn order(state: MotionState) -> u8 {
    match state {
        MotionState::Sliding => 0,
        MotionState::Rolling => 1,
        MotionState::Spinning => 2,
        MotionState::Stationary => 3,
        MotionState::Airborne => 4,
        MotionState::Pocketed | MotionState::OffTable => 5,
    }
}

/// The error in the velocities after an event, if there is one.
pub(crate) fn audit(shot: &Shot, event: &Event<'_>) -> Option<String> {
    for (k, s) in event.after.iter().enumerate() {
        let ball = event.balls[k];
        let radius = shot.balls()[usize::from(ball)].ball.radius;
        let (slip, spin) = (slip(s, radius).length(), s.angular_velocity);
        let rounding = SMOOTH * speeds(s, radius) + STILL;
        let wrong = match s.motion {
            MotionState::Sliding if slip == 0.0 => Some(("slides without slip", slip)),
            MotionState::Rolling if slip > rounding => Some(("rolls with a slip of", slip)),
            MotionState::Spinning if s.velocity.length() != 0.0 => {
                Some(("spins in place with a velocity of", s.velocity.length()))
            }
            MotionState::Spinning if spin.xy().length() != 0.0 => {
                Some(("spins in place about a horizontal axis at", spin.xy().length() * radius))
            }
            MotionState::Stationary if speeds(s, radius) != 0.0 => {
                Some(("rests with a speed of", speeds(s, radius)))
            }
            _ => None,
        };
        if let Some((what, size)) = wrong {
            return Some(format!("ball {ball} {what} {size:e} m/s after {:?}", event.kind));
        }
    }
    match event.kind {
        EventKind::MotionTransition { from, to } => transition(shot, event, from, to),
        _ => None,
    }
}

/// Where a motion state ends, the spin is continuous, and the next state is a later one. A ball also
/// goes from rolling to rolling, at the end of a band of rolling resistance.
fn transition(
    shot: &Shot,
    event: &Event<'_>,
    from: MotionState,
    to: MotionState,
) -> Option<String> {
    let (ball, before, after) = (event.balls[0], event.before[0], event.after[0]);
    let speed = after.velocity.length();
    let rolls_on = (from, to) == (MotionState::Rolling, MotionState::Rolling);
    if rolls_on && !rolling::is_end(&shot.physics().cloth, speed) {
        return Some(format!(
            "ball {ball} begins to roll again at {speed:e} m/s, where no band ends"
        ));
    }
    if order(to) <= order(from) && !rolls_on {
        return Some(format!("ball {ball} goes from {} back to {}", from.name(), to.name()));
    }
    let radius = shot.balls()[usize::from(ball)].ball.radius;
    let jump = after.angular_velocity - before.angular_velocity;
    // A ball that stops at an edge loses the spin with which it rolled on, with its velocity.
    let stops = after.velocity.length() == 0.0 && before.velocity.length() > SMOOTH;
    let size = radius * if stops { jump.z.abs() } else { jump.length() };
    (size > SMOOTH * (1.0 + speeds(&before, radius)))
        .then(|| format!("the spin of ball {ball} jumps by {size:e} m/s at its surface"))
}
