//! The kinematics of two balls in contact on the cloth.
//!
//! The normal **n** points from a's centre to b's. Balls of different radius stand with their
//! centres at different heights, so n = c**h** + s**ẑ** with **h** horizontal, c = cos and s = sin
//! of the tilt (s = (R_b − R_a)/(R_a + R_b); 0 for equal balls). The tangent plane is spanned by
//! **t₁** = ẑ×h, horizontal, and **t₂** = n×t₁ = cẑ − sh.
//!
//! The centres can move only horizontally, and this fixes the law of a tilted impact:
//!
//! * The approach speed is w = (v_a − v_b)·h; the speed along n is c·w. Restitution therefore
//!   holds along n exactly when w′ = −e·w, whatever the tilt: the horizontal impulse is
//!   (1 + e)·m*·w along h, with m* = m_a m_b/(m_a + m_b), and the impulse along n is 1/c times
//!   that. The slate supplies the vertical balance through the centre of the ball that is pressed
//!   down: no torque. With e = 1 the energy is conserved, and after the impact the balls never
//!   still approach.
//! * The slip **u** is counted as if the balls were level: (v_a − v_b)·t₁ and the spins move it,
//!   the approach w does not (its part along t₂, s·w, changes sign during the impact). Friction
//!   along t₂ turns the balls; its push on the centres belongs to the normal impulse above.
//!
//! Impulses are written per unit of m*, so they are speeds.

use crate::math::{Vec2, Vec3, sqrt};
use crate::resolve::Body;

/// Change of slip per tangential impulse (per unit of m*): 1 from the centre's motion and
/// mR²/I = 5/2 from the spin of a homogeneous ball.
pub const TANGENT_COMPLIANCE: f64 = 3.5;

/// Torque factor of a homogeneous ball: mR²/I.
pub(super) const SPIN_PER_IMPULSE: f64 = 2.5;

/// Two balls at the instant of contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Horizontal unit vector **h** from a to b.
    pub direction: Vec2,
    /// cos of the tilt of the line of centres.
    pub cos_tilt: f64,
    /// sin of the tilt, positive if b's centre is higher.
    pub sin_tilt: f64,
    /// m*/m_a.
    pub share_a: f64,
    /// m*/m_b.
    pub share_b: f64,
    /// Horizontal approach speed w, m/s; positive while the balls approach.
    pub approach: f64,
    /// Slip velocity of a's surface over b's along t₁ (x) and t₂ (y), m/s.
    pub slip: Vec2,
}

impl Contact {
    /// The contact of `a` and `b`; `normal` is the unit vector from a's centre to b's.
    #[inline]
    pub fn between(normal: Vec3, a: &Body, b: &Body) -> Self {
        let (direction, cos_tilt, sin_tilt) = if normal.z == 0.0 {
            (normal.xy(), 1.0, 0.0)
        } else {
            let cos_tilt = normal.xy().length();
            (normal.xy() * (1.0 / cos_tilt), cos_tilt, normal.z)
        };
        let total = a.mass + b.mass;
        let velocity = (a.velocity - b.velocity).xy();
        let spin = a.angular_velocity * a.radius + b.angular_velocity * b.radius;
        let t1 = direction.perp();
        let t2 = (direction * -sin_tilt).with_z(cos_tilt);
        Self {
            direction,
            cos_tilt,
            sin_tilt,
            share_a: b.mass / total,
            share_b: a.mass / total,
            approach: velocity.dot(direction),
            slip: Vec2::new(velocity.dot(t1) + spin.dot(t2), -spin.xy().dot(t1)),
        }
    }

    /// The unit vector n from a's centre to b's.
    #[inline]
    pub fn normal_vector(&self) -> Vec3 {
        (self.direction * self.cos_tilt).with_z(self.sin_tilt)
    }

    /// The impulse along n (per m*) that belongs to the impulse `along` h.
    #[inline(always)]
    pub fn normal_impulse(&self, along: f64) -> f64 {
        along / self.cos_tilt
    }

    /// Applies the impulse `along` h and `tangential` (t₁, t₂), both per m* and on b; a takes the
    /// opposite. Momentum in the plane is conserved, and so is each ball's angular momentum about
    /// the contact point, but for the slate's part.
    #[inline]
    pub fn apply(&self, along: f64, tangential: Vec2, a: &mut Body, b: &mut Body) {
        let t1 = self.direction.perp();
        let push = (self.direction * along + t1 * tangential.x).with_z(0.0);
        a.velocity -= push * self.share_a;
        b.velocity += push * self.share_b;
        self.turn(tangential, a, b);
    }

    /// The torque of `apply` alone: n × impulse turns both balls the same way.
    #[inline]
    fn turn(&self, tangential: Vec2, a: &mut Body, b: &mut Body) {
        let t1 = self.direction.perp();
        let t2 = (self.direction * -self.sin_tilt).with_z(self.cos_tilt);
        let torque = t2 * tangential.x - (t1 * tangential.y).with_z(0.0);
        a.angular_velocity -= torque * (SPIN_PER_IMPULSE * self.share_a / a.radius);
        b.angular_velocity -= torque * (SPIN_PER_IMPULSE * self.share_b / b.radius);
    }

    /// |u|, m/s.
    #[inline(always)]
    pub fn slip_speed(&self) -> f64 {
        sqrt(self.slip.length_squared())
    }
}
