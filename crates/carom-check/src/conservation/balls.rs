//! Checks of momentum and angular momentum in collisions of balls.
//!
//! The contact gives the two balls opposite impulses J at one point. The ground acts on a ball only
//! if it supports the ball and the ball is driven down. Its impulse is upward, with friction of at
//! most μ times the upward part. At most one of two balls is driven down. J follows, up to rounding,
//! from the change of spin and velocity of the other ball. The rest of the change of the ball that
//! is driven down is the impulse of the ground. An impulse that would lift a ball by less than the
//! smallest hop may be left out. J is then compared with the law of two balls ([`super::pair_law`]).

use carom::event::Event;
use carom::math::Vec3;
use carom::shot::Shot;
use carom::{Ball, MotionState};

use super::pair_law::PairImpulse;
use super::{Circumstances, ROUNDING, SPIN_SHARE, STILL, last_hop_speed, network};
use crate::places::ground;
use crate::solid::Solid;

/// The violation of a conservation law in a collision, if there is one.
pub(super) fn audit(
    scene: &Circumstances<'_>,
    event: &Event<'_>,
    balls: &[Ball],
) -> Option<String> {
    let Circumstances { shot, solid, law, gap, hop } = *scene;
    let all: Vec<CollidingBall> =
        (0..balls.len()).map(|k| CollidingBall::new(shot, solid, event, balls, k)).collect();
    check_total(scene, &all).or_else(|| match &all[..] {
        [a, b] if law.is_smooth() => check_spins(shot, [a, b], 0.0),
        [a, b] => {
            let d = event.before[1].position - event.before[0].position;
            let normal = d * (1.0 / d.length());
            // This model includes the cloth's friction on both balls, so it is not checked.
            if law.model.traits().cloth && a.stands && b.stands {
                return None;
            }
            let approach = (event.before[0].velocity - event.before[1].velocity).dot(normal);
            let is_hop = hop > 0.0 && approach <= hop;
            match [check_pair(shot, a, b, normal), check_pair(shot, b, a, -normal)] {
                // A hop in a long push has the law's impulse for a higher approach speed. Balls that
                // slip fast over each other count as smooth there.
                [Err(_), Err(_)] if is_hop => check_spins(shot, [a, b], SLIPPERY),
                _ if is_hop => None,
                [Err(first), Err(second)] => {
                    Some(if first.0 < second.0 { first.1 } else { second.1 })
                }
                [Ok(impulse), _] => check_law(scene, event, [a, b], impulse),
                [_, Ok(impulse)] => check_law(scene, event, [a, b], -impulse),
            }
        }
        _ => network::audit(shot, solid, event, balls, gap),
    })
}

/// Friction of balls that count as smooth in a long push: the engine's `SLIPPERY`, rounded up.
const SLIPPERY: f64 = 1.1e-3;

/// A persistent contact of smooth balls may take a small fraction of their spins, in addition to
/// what their friction `mu` does. A ball that this friction drives down bounces off the ground, with
/// up to twice that impulse.
fn check_spins(shot: &Shot, balls: [&CollidingBall; 2], mu: f64) -> Option<String> {
    let rubs = mu * (1.0 + 2.0 * friction(shot));
    balls.into_iter().find_map(|p| {
        let turned = p.turn.length();
        let rubbed = rubs * p.push.length() * p.ball.radius;
        let most = p.turn_rounding + SPIN_SHARE * p.spin + rubbed;
        (turned > most).then(|| {
            format!("the spin of ball {}, which is smooth, changes by {turned:e}", p.named)
        })
    })
}

/// One ball of a collision.
struct CollidingBall {
    ball: Ball,
    /// Changes of momentum, kg·m/s, and of angular momentum, kg·m²/s.
    push: Vec3,
    turn: Vec3,
    /// Angular momentum, kg·m²/s.
    spin: f64,
    stands: bool,
    /// Rounding errors of the two changes.
    push_rounding: f64,
    turn_rounding: f64,
    /// Largest upward impulse that may be suppressed because the hop would be too small, kg·m/s.
    lift: f64,
    named: u16,
}

impl CollidingBall {
    fn new(shot: &Shot, solid: &Solid, event: &Event<'_>, balls: &[Ball], k: usize) -> Self {
        let (ball, before, after) = (balls[k], event.before[k], event.after[k]);
        let inertia = 0.4 * ball.mass * ball.radius * ball.radius;
        let stands = ground(solid, &before, ball.radius).is_some();
        let kept_down = stands && after.motion != MotionState::Airborne;
        // Separation speeds are computed from sums over all balls, so each has the rounding error
        // of the fastest.
        let fastest = event.before.iter().map(|s| s.velocity.length()).fold(0.0, f64::max);
        let spins = event.before.iter().chain(event.after).map(|s| s.angular_velocity.length());
        let surface = ball.radius * spins.fold(0.0, f64::max);
        Self {
            ball,
            push: (after.velocity - before.velocity) * ball.mass,
            turn: (after.angular_velocity - before.angular_velocity) * inertia,
            spin: before.angular_velocity.length() * inertia,
            stands,
            push_rounding: ball.mass * (ROUNDING * fastest + STILL),
            turn_rounding: ball.mass
                * ball.radius
                * (ROUNDING * (fastest + surface + ball.radius) + STILL),
            lift: if kept_down { ball.mass * last_hop_speed(shot) } else { 0.0 },
            named: event.balls[k],
        }
    }
}

/// A line of centres with at most this slope counts as vertical, and may be tilted by that much.
const LEAN: f64 = 1.000_001e-3;

/// Largest coefficient of friction of the ground.
fn friction(shot: &Shot) -> f64 {
    shot.physics().cloth.sliding_friction.max(shot.physics().slate.friction)
}

/// Checks the sum of all momenta: it changes only by the impulse of the ground.
fn check_total(scene: &Circumstances<'_>, all: &[CollidingBall]) -> Option<String> {
    let Circumstances { shot, law, .. } = *scene;
    let sum = |of: fn(&CollidingBall) -> f64| all.iter().map(of).sum::<f64>();
    let change = all.iter().fold(Vec3::ZERO, |sum, p| sum + p.push);
    let (rounding, lift) = (sum(|p| p.push_rounding), sum(|p| p.lift));
    let stands = all.iter().any(|p| p.stands);
    // Impulses along horizontal lines of centres do not press any ball down.
    let level =
        law.is_smooth() && all.iter().all(|p| p.stands && p.ball.radius == all[0].ball.radius);
    let pressed = if stands && !level { change.z + lift } else { 0.0 };
    // The model that integrates the cloth's friction drops the vertical part of the impulses.
    let integrated = law.model.traits().cloth && stands;
    let dropped = if integrated { sum(|p| p.push.length()) } else { 0.0 };
    let most = rounding + friction(shot) * (2.0 * pressed.max(0.0) + dropped);
    let (level, up) = (change.xy().length(), change.z);
    let down = if stands { -lift - rounding } else { -rounding };
    let too_high = !stands && up > rounding;
    (level > most || up < down || too_high).then(|| {
        format!("momentum changes by {level:e} level, allowed {most:e}, and {up:e} upwards")
    })
}

/// Checks a collision under the assumption that only `other` is driven down; `normal` points from
/// `free` to it. The result is the impulse on `free`, kg·m/s; the error holds the ratio of the excess
/// to its allowance, and a description.
fn check_pair(
    shot: &Shot,
    free: &CollidingBall,
    other: &CollidingBall,
    normal: Vec3,
) -> Result<Vec3, (f64, String)> {
    let wrong = |size: f64, most: f64, what: &str| {
        if size <= most {
            return Ok(());
        }
        let text = format!(
            "{what} of ball {} changes by {size:e}, allowed {most:e}, when it meets ball {}",
            free.named, other.named
        );
        Err((size / most, text))
    };
    // A ball balanced on top of another is treated as tilted: the impulse is up to 2·LEAN off the
    // line of centres. If a persistent contact separates them along that line, the impulse is up to
    // twice the remaining one.
    let upright = normal.xy().length_squared() < LEAN * LEAN;
    let leaning = if upright { 4.0 * LEAN * free.push.length() } else { 0.0 };
    // The arm of the contact is Rn, so I Δω = Rn × J gives the part of J perpendicular to n.
    let about_normal = free.turn.dot(normal).abs();
    wrong(about_normal, free.turn_rounding, "angular momentum about the line of centres")?;
    let across = free.turn.cross(normal) * (1.0 / free.ball.radius);
    let rounding = free.push_rounding + free.turn_rounding / free.ball.radius;
    let level = normal.xy().length_squared();
    let impulse = if free.stands && level > 0.0 {
        let rest = (free.push - across).xy();
        across + normal * (rest.dot(normal.xy()) / level)
    } else {
        across + normal * free.push.dot(normal)
    };
    let missing = impulse - free.push;
    let left_down = if free.stands { missing.z.clamp(0.0, free.lift) } else { 0.0 };
    let off = (missing - Vec3::new(0.0, 0.0, left_down)).length();
    wrong(off, rounding + leaning, "angular momentum about the contact")?;

    let ground = other.push + impulse;
    let lever = Vec3::new(0.0, 0.0, -other.ball.radius);
    let contact = normal * -other.ball.radius;
    let turn = other.turn - contact.cross(-impulse) - lever.cross(ground);
    let most = other.turn_rounding + other.ball.radius * (rounding + leaning);
    wrong(turn.length(), most, "angular momentum about the contact, on the other side,")?;
    let rounding = rounding + other.push_rounding;
    if !other.stands {
        wrong(ground.length(), rounding, "momentum")?;
        return Ok(impulse);
    }
    wrong(-ground.z, other.lift + rounding, "momentum, downwards,")?;
    // A suppressed bounce has already had its impulse and friction; at most half of it is left.
    let most = friction(shot) * 2.0 * ground.z.max(0.0) + rounding + leaning;
    wrong(ground.xy().length(), most, "momentum, by friction on the ground,")?;
    Ok(impulse)
}

/// Compares the `impulse` on the first of two balls, kg·m/s, with the law of two balls.
fn check_law(
    scene: &Circumstances<'_>,
    event: &Event<'_>,
    [a, b]: [&CollidingBall; 2],
    impulse: Vec3,
) -> Option<String> {
    let [p, q] = [event.before[0], event.before[1]];
    let d = q.position - p.position;
    let normal = d * (1.0 / d.length());
    let spin = p.angular_velocity * a.ball.radius + q.angular_velocity * b.ball.radius;
    let reduced = a.ball.mass * b.ball.mass / (a.ball.mass + b.ball.mass);
    let rounding = |x: &CollidingBall| x.push_rounding + x.turn_rounding / x.ball.radius;
    let pair = PairImpulse {
        normal,
        velocity: p.velocity - q.velocity,
        surface: spin.cross(normal),
        separation: (event.after[1].velocity - event.after[0].velocity).dot(normal),
        impulse: impulse * (1.0 / reduced),
        rounding: 10.0 * (rounding(a) + rounding(b)) / reduced,
        on_bed: [a, b].iter().all(|x| x.stands)
            && [p, q].iter().all(|s| s.motion != MotionState::Airborne),
    };
    let wrong = pair.audit(scene.law)?;
    Some(format!("balls {} and {} get {wrong}", a.named, b.named))
}
