//! Ball against the slate under the cloth, or the flat top of a rail.
//!
//! A bounce is one rigid impulse with restitution e and Coulomb friction μ: v_z′ = −e·v_z, and
//! against the slip **u** at the foot the impulse per mass min(μ(1 + e)|v_z|, 2/7·|u|), whose
//! second value stops the slip (Alciatore, TP B.10; a sphere's slip changes by 7/2 of it). The
//! spin about the vertical has no lever there and stays.
//!
//! # The last hop
//!
//! Hops shrink like a geometric series and would never end. A ball that leaves the slate so slowly
//! that it would rise by less than [`LAST_HOP`] stays down instead. Each time, it loses the energy
//! of that rise, at most m·g·0.05 mm (0.08 mJ for a pool ball), and nothing else; energy never
//! rises. A hop left out would have lasted at most 2·√(2·0.05 mm/g) = 6 ms.

use super::{Body, SPIN_PER_IMPULSE};
use crate::ball::cloth_slip;
use crate::math::sqrt;
use crate::physics::Surface;

/// A ball that would rise less than this, m, stays down: a twentieth of a millimetre is less than
/// cloth gives under a ball. Higher, and hops that were published would be left out (the fifth of
/// TP B.10 rises by 0.059 mm); lower, and every impact on the cloth that lifts a ball a little
/// would cost more events.
pub const LAST_HOP: f64 = 5e-5;

/// The slip that an impulse per mass J against it takes away is 7/2·J.
const STOP: f64 = 1.0 / (1.0 + SPIN_PER_IMPULSE);

/// The vertical speed with which a ball rises by [`LAST_HOP`], m/s. `gravity` in m/s².
#[inline]
pub fn last_hop_speed(gravity: f64) -> f64 {
    sqrt(2.0 * gravity * LAST_HOP)
}

/// A ball that comes down on the slate bounces (TP B.10). One that does not is left alone.
#[inline]
pub fn bounce(law: &Surface, ball: &mut Body) {
    let fall = -ball.velocity.z;
    if fall <= 0.0 {
        return;
    }
    ball.velocity.z = law.restitution * fall;
    let slip = cloth_slip(ball.velocity, ball.angular_velocity, ball.radius);
    let speed = slip.length();
    if speed == 0.0 {
        return;
    }
    let grip = law.friction * (1.0 + law.restitution) * fall;
    let impulse = slip * -(grip / speed).min(STOP);
    ball.velocity += impulse.with_z(0.0);
    // The arm is −Rẑ.
    let turn = impulse.perp() * (-SPIN_PER_IMPULSE / ball.radius);
    ball.angular_velocity += turn.with_z(0.0);
}

/// What the slate does at once to a ball that touches it after another impact.
///
/// A ball that would rise by less than the last hop stays down, and so does one that is driven into
/// the slate so gently that its bounce would rise by less: it loses its vertical speed and nothing
/// else, so that two balls that meet on the cloth keep their momentum along it. What friction would
/// do in such a press, the cloth does soon after: where the ball rolls in the end does not depend on
/// it. Any other is left as it is: it flies, or its bounce is an event of its own.
#[inline]
pub fn settle(law: &Surface, gravity: f64, ball: &mut Body) {
    let rise = ball.velocity.z;
    if rise == 0.0 {
        return;
    }
    let next = if rise < 0.0 { law.restitution * -rise } else { rise };
    if next < last_hop_speed(gravity) {
        ball.velocity.z = 0.0;
    }
}
