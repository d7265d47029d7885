//! A ball against the slate under the cloth, or against the flat top of a rail.
//!
//! A bounce is one rigid impulse with restitution e and Coulomb friction μ: v_z′ = −e·v_z, and an
//! impulse per mass of min(μ(1 + e)|v_z|, 2/7·|u|) against the slip **u** at the contact; the
//! second value stops the slip (Alciatore, TP B.10; a sphere's slip changes by 7/2 of the impulse).
//! Spin about the vertical has no lever arm there and does not change.
//!
//! # The last hop
//!
//! Hops shrink in a geometric series and would never end. A ball that leaves the slate so slowly
//! that it would rise by less than [`LAST_HOP`] stays down instead. It loses only the energy of
//! this rise, at most m·g·0.05 mm (0.08 mJ for a pool ball) each time; the energy never rises. An
//! omitted hop would have lasted at most 2·√(2·0.05 mm/g) = 6 ms.

use super::{Body, SPIN_PER_IMPULSE};
use crate::ball::cloth_slip;
use crate::math::sqrt;
use crate::physics::Surface;

/// A ball that would rise by less than this, m, stays down: cloth is compressed by more than a
/// twentieth of a millimetre under a ball. Larger, and hops of published examples would be omitted
/// (the fifth of TP B.10 rises by 0.059 mm); smaller, and every impact that lifts a ball a little
/// would cost more events.
pub const LAST_HOP: f64 = 5e-5;

/// The impulse per mass and slip that stops the slip: an impulse J reduces it by 7/2·J.
const STOP: f64 = 1.0 / (1.0 + SPIN_PER_IMPULSE);

/// The vertical speed with which a ball rises by [`LAST_HOP`], m/s. `gravity` in m/s².
#[inline]
pub fn last_hop_speed(gravity: f64) -> f64 {
    sqrt(2.0 * gravity * LAST_HOP)
}

/// The bounce of a ball that comes down on the slate (TP B.10). A ball that does not is left
/// unchanged.
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
    // The lever arm is −Rẑ.
    let turn = impulse.perp() * (-SPIN_PER_IMPULSE / ball.radius);
    ball.angular_velocity += turn.with_z(0.0);
}

/// The slate's immediate effect on a ball that lies on it and has just had another impact.
///
/// A ball that would rise by less than the last hop stays down. So does a ball that is driven into
/// the slate so gently that its bounce would rise by less. It loses its vertical velocity and
/// nothing else, so that two balls that meet on the cloth conserve their horizontal momentum.
/// Friction during this contact is neglected, because friction of the cloth does the same soon
/// after: it does not change where the ball rolls in the end. Any other ball is left unchanged; it
/// flies, or its bounce is a separate event.
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
