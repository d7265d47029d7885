//! Checks of the impulse of the table on a flying ball. It acts at the touched point, pushes the
//! ball away, and its friction is at most μ times its normal part. An edge of a rail returns the
//! restitution of its law. The model `factors` is compared with its factors instead, unless the ball
//! is pressed on the edge.

use carom::event::Event;
use carom::math::Vec3;
use carom::physics::{Cushion, CushionModel};
use carom::shot::Shot;
use carom::{Ball, MotionState};

use super::{Circumstances, ROUNDING, STILL, rail_on_bed};
use crate::places::TABLE_GAP;
use crate::rail_laws::restitution;
use crate::solid::Solid;
use crate::table::EdgeKind;
use crate::table_contact;

/// Largest normal speed of a ball that tips over an edge or runs along a round one: m/s, and m/s
/// per m/s of its speed. The engine replaces such a motion by small hops whose energy comes from
/// the motion along the edge, which no force at one point could do. The values are twice the hops
/// of 8 ms and of 0.04 rad that the engine guarantees.
const TIPPING: [f64; 2] = [0.08, 0.06];

/// Largest inclination of a liner's wall over its hole, rad: 15°, the back draft of a facing. The
/// wall is where a vertical one would be, but also pushes a ball down.
const LEAN: f64 = std::f64::consts::PI / 12.0;

/// Checks the contact of a ball with a rail.
pub(super) fn rail(
    scene: &Circumstances<'_>,
    event: &Event<'_>,
    ball: &Ball,
    part: usize,
) -> Option<String> {
    let Circumstances { shot, solid, .. } = *scene;
    let s = event.before[0];
    if s.motion != MotionState::Airborne {
        return rail_on_bed::audit(scene, event, ball, part);
    }
    let physics = shot.physics();
    let fit = physics.cushion.friction;
    let steepest = fit.a + fit.b * core::f64::consts::FRAC_PI_2;
    let friction = [physics.facing, physics.liner, physics.slate]
        .iter()
        .map(|surface| surface.friction)
        .fold(fit.a.max(steepest), f64::max);
    let touched = table_contact::rail(solid, part, s.position, ball.radius)?;
    let (_, kind, _) = solid.plan.parts[part];
    let is_edge = kind != EdgeKind::Top;
    if is_edge && tips(event, touched.away) {
        return None;
    }
    let law = rail_on_bed::law_of(physics, kind);
    let check = |away: Vec3| {
        if is_edge && law.model == CushionModel::Factors {
            let wrong = check_factors(&law, event, ball, away)?;
            return (!is_pressed(event, ball, touched.away, friction)).then_some(wrong);
        }
        check_impulse(event, ball, away, friction)
            .or_else(|| if is_edge { check_restitution(&law, event, ball, away) } else { None })
    };
    let wrong = check(touched.away)?;
    if kind == EdgeKind::Liner && touched.away.z == 0.0 {
        let (sin, cos) = carom::math::sin_cos(LEAN);
        return check((touched.away.xy() * cos).with_z(-sin));
    }
    Some(wrong)
}

/// Largest error of the separation speed, as a fraction of the approach speed: the steps of
/// `mathavan-2010`, which end where the law's work is done.
const SEPARATION: f64 = 1e-4;

/// The separation speed of a flying ball from an edge, m/s, by the law's restitution.
fn separation(law: &Cushion, approach: f64) -> f64 {
    let fit = law.restitution;
    let e = fit.a + approach * fit.b + approach * approach * fit.c;
    restitution(e.max(fit.lowest).min(fit.highest), approach) * approach
}

/// The error in the separation speed from an edge, if there is one. A ball that approaches at less
/// than twice the speed of a hop may leave with that speed instead.
fn check_restitution(law: &Cushion, event: &Event<'_>, ball: &Ball, away: Vec3) -> Option<String> {
    if is_slow(event, away, 2.0) {
        return None;
    }
    let (before, after) = (event.before[0].velocity, event.after[0].velocity);
    let approach = -before.dot(away);
    let (leaves, expected) = (after.dot(away), separation(law, approach));
    let spin = event.before[0].angular_velocity.length();
    let rounding = ROUNDING * (before.length() + ball.radius * spin) + 4.0 * STILL;
    let exact = law.model != CushionModel::Mathavan2010;
    let allowed = rounding + if exact { 0.0 } else { SEPARATION * approach };
    ((leaves - expected).abs() > allowed).then(|| {
        format!("the rail returns {leaves:e} of {approach:e} m/s, where the law has {expected:e}")
    })
}

/// The error in a rebound by the model `factors`, which is not that of an impulse at one point.
fn check_factors(law: &Cushion, event: &Event<'_>, ball: &Ball, away: Vec3) -> Option<String> {
    let (before, after) = (event.before[0], event.after[0]);
    let approach = -before.velocity.dot(away);
    let across = before.velocity + away * approach;
    let share = |factor: f64| restitution(factor, approach);
    let velocity = away * separation(law, approach) + across * share(law.tangential_factor);
    let spin = before.angular_velocity * share(law.spin_factor);
    let off = (after.velocity - velocity).length()
        + ball.radius * (after.angular_velocity - spin).length();
    let speeds = before.velocity.length() + ball.radius * before.angular_velocity.length();
    let allowed = ROUNDING * speeds + 4.0 * STILL;
    (off > allowed)
        .then(|| format!("the rebound by factors is off by {off:e}, allowed {allowed:e}"))
}

/// Whether a ball is pressed on an edge rather than bounces off it, and gets an impulse at one point,
/// with the friction of the surface. A ball that runs around a liner comes to this from its second
/// contact on. The speed below which the engine does so is twice that of a hop, for every law of the
/// rail.
fn is_pressed(event: &Event<'_>, ball: &Ball, away: Vec3, friction: f64) -> bool {
    is_slow(event, away, 2.0) && check_impulse(event, ball, away, friction).is_none()
}

/// Whether a ball is pressed against an edge by its weight, or by its motion around the edge.
fn tips(event: &Event<'_>, away: Vec3) -> bool {
    is_slow(event, away, 1.0)
}

/// Whether a ball approaches so slowly, at up to `times` the speed of tipping.
fn is_slow(event: &Event<'_>, away: Vec3, times: f64) -> bool {
    let v = event.before[0].velocity;
    v.dot(away).abs() <= times * (TIPPING[0] + TIPPING[1] * v.length())
}

/// Checks the contact of a flying ball with the bed.
pub(super) fn slate(shot: &Shot, solid: &Solid, event: &Event<'_>, ball: &Ball) -> Option<String> {
    let touched = table_contact::slate(solid, event.before[0].position, ball.radius);
    let at_lip = solid.over_hole(event.before[0].position.xy()) > -TABLE_GAP;
    if at_lip && tips(event, touched.away) {
        return None;
    }
    check_impulse(event, ball, touched.away, shot.physics().slate.friction)
}

/// The error in an impulse at the point in the direction −`away` from the centre, if there is one.
fn check_impulse(event: &Event<'_>, ball: &Ball, away: Vec3, friction: f64) -> Option<String> {
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
    // A suppressed bounce loses part of its impulse, so the incoming momentum limits the friction
    // too.
    let came = -before.velocity.dot(away).min(0.0) * ball.mass;
    let pushed = impulse.dot(away).max(2.0 * came);
    let across = (impulse - away * impulse.dot(away)).length();
    (across > friction * pushed + rounding || impulse.dot(away) < -rounding).then(|| {
        format!("the table gives {across:e} across, with a friction of {friction} on {pushed:e}")
    })
}
