//! What every event must keep: energy, momentum, angular momentum, and plain sanity.

use carom::event::{Event, EventKind};
use carom::math::Vec3;
use carom::physics::BallBallModel;
use carom::shot::Shot;
use carom::{Ball, BallState, MotionState};

/// Relative rounding that is let pass in sums over the balls of an event.
const ROUNDING: f64 = 1e-12;

/// Energy that a push may lend, J: `UNPAID_PRESS_SPEED` in the engine's `simulate/impact.rs`.
pub const LENT: f64 = 2e-9;

/// Share of a spin that a push between smooth balls may cost: `SPIN_SHARE` there.
const SPIN_SHARE: f64 = 1e-3;

/// Speed that the engine takes for rest, m/s: `STILL` in its `motion.rs`.
const STILL: f64 = 1e-13;

/// What is wrong with an event, if anything.
pub(crate) fn audit(shot: &Shot, event: &Event<'_>) -> Option<String> {
    let balls: Vec<Ball> = event.balls.iter().map(|&i| shot.balls()[usize::from(i)].ball).collect();
    for (k, s) in event.after.iter().enumerate() {
        if !(s.position.is_finite() && s.velocity.is_finite() && s.angular_velocity.is_finite()) {
            return Some(format!("ball {} is not finite after {:?}", event.balls[k], event.kind));
        }
        let moved = event.before[k].position != s.position;
        if moved && s.motion != MotionState::Pocketed && s.motion == event.before[k].motion {
            return Some(format!("ball {} jumps at {:?}", event.balls[k], event.kind));
        }
    }
    let energy = |states: &[BallState]| -> f64 {
        states.iter().zip(&balls).map(|(s, b)| b.kinetic_energy(s)).sum()
    };
    let (before, after) = (energy(event.before), energy(event.after));
    if event.kind != EventKind::CueStrike && after > before * (1.0 + ROUNDING) + LENT {
        return Some(format!("{:?} raises the energy by {:e} J", event.kind, after - before));
    }
    (event.kind == EventKind::BallCollision).then(|| momenta(shot, event, &balls)).flatten()
}

/// Linear momentum in the plane; and, of two balls, each one's angular momentum about the contact.
/// A model with cloth friction during the impact gives some of both to the cloth.
fn momenta(shot: &Shot, event: &Event<'_>, balls: &[Ball]) -> Option<String> {
    let mut total = Vec3::ZERO;
    let mut scale = 0.0;
    for (k, ball) in balls.iter().enumerate() {
        total += (event.after[k].velocity - event.before[k].velocity) * ball.mass;
        scale += ball.mass * event.before[k].velocity.length();
    }
    let stilled: f64 = balls.iter().map(|b| b.mass * STILL).sum();
    let on_cloth = shot.physics().ball_ball.model == BallBallModel::Mathavan2014;
    let to_cloth = if on_cloth { shot.physics().cloth.sliding_friction } else { 0.0 };
    if total.xy().length() > (ROUNDING + to_cloth) * scale + stilled {
        return Some(format!("momentum changes by {:e} of {scale:e}", total.xy().length()));
    }
    if let (false, [a, b], [p, q]) = (on_cloth, balls, event.before) {
        let d = q.position - p.position;
        let normal = d * (1.0 / d.length());
        for (k, (ball, side)) in [(a, 1.0), (b, -1.0)].into_iter().enumerate() {
            let dv = event.after[k].velocity - event.before[k].velocity;
            let dw = event.after[k].angular_velocity - event.before[k].angular_velocity;
            let inertia = 0.4 * ball.mass * ball.radius * ball.radius;
            // About the vertical and about the line of centres no other force has a say.
            let arm = normal * (side * ball.radius);
            let change = dw * inertia - arm.cross(dv) * ball.mass;
            let about_normal = dw.dot(normal) * inertia;
            let scale = inertia * (1.0 + event.before[k].angular_velocity.length())
                + ball.mass * ball.radius * dv.length();
            // A ball that is taken for at rest loses a spin of up to 2·STILL/R, too; and between
            // smooth balls the spin pays for being pressed.
            let paid = if shot.physics().ball_ball.is_smooth() { SPIN_SHARE } else { 0.0 };
            let most = (ROUNDING + paid) * scale + ball.radius * stilled;
            if change.z.abs() > most || about_normal.abs() > most {
                let change = change.z.abs().max(about_normal.abs());
                return Some(format!("angular momentum changes by {change:e}, allowed {most:e}"));
            }
        }
    }
    None
}
