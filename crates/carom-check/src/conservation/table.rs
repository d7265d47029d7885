//! What the table gives a flying ball: an impulse at the point that it touches, which pushes, and turns
//! it as that point tells; its friction is at most μ times its push.

use carom::event::Event;
use carom::math::Vec3;
use carom::shot::Shot;
use carom::table::Part;
use carom::{Ball, MotionState};

use super::{ROUNDING, STILL};
use crate::places::TABLE_GAP;
use crate::solid::Solid;
use crate::table_contact;

/// How fast a ball that tips over an edge, or runs along a round one, may fall on to it and be thrown
/// off it again: m/s, and m/s per m/s of its speed. What that takes comes out of its motion along, which
/// no force at one point does. Twice the hops of 8 ms and of 0.04 rad that the engine promises.
const TIPPING: [f64; 2] = [0.08, 0.06];

/// By how much the wall of a liner may lean over its hole, rad: 15°, the back draft of a facing. It
/// stands where an upright one does, but pushes a ball down as well.
const LEAN: f64 = std::f64::consts::PI / 12.0;

/// A flying ball meets a rail.
pub(super) fn rail(
    shot: &Shot,
    solid: &Solid,
    event: &Event<'_>,
    ball: &Ball,
    part: usize,
) -> Option<String> {
    let s = event.before[0];
    // The bed takes part in what happens to a ball that stands on it.
    if s.motion != MotionState::Airborne || s.position.z <= ball.radius + TABLE_GAP {
        return None;
    }
    let physics = shot.physics();
    let fit = physics.cushion.friction;
    let steepest = fit.a + fit.b * core::f64::consts::FRAC_PI_2;
    let friction = [physics.facing, physics.liner, physics.slate]
        .iter()
        .map(|surface| surface.friction)
        .fold(fit.a.max(steepest), f64::max);
    let touched = table_contact::rail(shot.table(), solid, part, s.position, ball.radius)?;
    let is_edge = shot.table().cushions[part].part != Part::Top;
    if is_edge && tips(event, touched.away) {
        return None;
    }
    let wrong = push(event, ball, touched.away, friction)?;
    if shot.table().cushions[part].part == Part::Liner && touched.away.z == 0.0 {
        let (sin, cos) = carom::math::sin_cos(LEAN);
        return push(event, ball, (touched.away.xy() * cos).with_z(-sin), friction);
    }
    Some(wrong)
}

/// Whether a ball is rather pressed on an edge, by its weight or its way around it, than thrown at it.
fn tips(event: &Event<'_>, away: Vec3) -> bool {
    let v = event.before[0].velocity;
    v.dot(away).abs() <= TIPPING[0] + TIPPING[1] * v.length()
}

/// A ball meets the bed.
pub(super) fn slate(shot: &Shot, solid: &Solid, event: &Event<'_>, ball: &Ball) -> Option<String> {
    let touched = table_contact::slate(solid, event.before[0].position, ball.radius);
    let at_lip = solid.over_hole(event.before[0].position.xy()) > -TABLE_GAP;
    if at_lip && tips(event, touched.away) {
        return None;
    }
    push(event, ball, touched.away, shot.physics().slate.friction)
}

/// What is wrong with an impulse from a point in the direction −`away` of the centre, if anything.
fn push(event: &Event<'_>, ball: &Ball, away: Vec3, friction: f64) -> Option<String> {
    let (before, after) = (event.before[0], event.after[0]);
    let impulse = (after.velocity - before.velocity) * ball.mass;
    let inertia = 0.4 * ball.mass * ball.radius * ball.radius;
    let turn = (after.angular_velocity - before.angular_velocity) * inertia;
    let speeds = before.velocity.length()
        + ball.radius * before.angular_velocity.length().max(after.angular_velocity.length());
    let rounding = ball.mass * (ROUNDING * speeds + 4.0 * STILL);
    let off = (turn - (away * -ball.radius).cross(impulse)).length() / ball.radius;
    if off > rounding {
        return Some(format!(
            "angular momentum about the contact changes by {off:e}, allowed {rounding:e}, at {:?}",
            event.kind
        ));
    }
    // By what it came with: a bounce too small to see is kept down, which takes part of the push.
    let came = -before.velocity.dot(away).min(0.0) * ball.mass;
    let pushed = impulse.dot(away).max(2.0 * came);
    let across = (impulse - away * impulse.dot(away)).length();
    (across > friction * pushed + rounding || impulse.dot(away) < -rounding).then(|| {
        format!("the table gives {across:e} across, with a friction of {friction} on {pushed:e}")
    })
}
