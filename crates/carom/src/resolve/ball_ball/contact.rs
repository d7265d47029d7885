//! The kinematics of two balls in contact, on the cloth or in the air.
//!
//! The normal **n** points from a's centre to b's, in any direction: a falling ball may be directly
//! above another. The balls approach at w = (v_a − v_b)·n, and a's surface slips over b's with
//!
//! **u** = (v_a − v_b) − w**n** + (R_a ω_a + R_b ω_b) × **n**,
//!
//! which lies in the tangent plane. Equal and opposite impulses act on the two balls at the
//! contact; no other force takes part. So momentum is conserved, and so is each ball's angular
//! momentum about the contact point. The slate acts afterwards on balls that stand on it
//! ([`crate::resolve::ball_slate::settle`]): one is pressed down, the other may hop (Alciatore, TP
//! B.5).
//!
//! Impulses are written per unit of the reduced mass m* = m_a m_b/(m_a + m_b), so they are speeds.

use crate::math::{Vec3, sqrt};
use crate::resolve::{Body, SPIN_PER_IMPULSE};

/// Change of slip per tangential impulse (per unit of m*): 1 from the motion of the centre and
/// mR²/I = 5/2 from the spin of a homogeneous ball.
pub const TANGENT_COMPLIANCE: f64 = 3.5;

/// Two balls at the instant of contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Unit vector **n** from a's centre to b's.
    pub normal: Vec3,
    /// m*/m_a.
    pub share_a: f64,
    /// m*/m_b.
    pub share_b: f64,
    /// Approach speed w along the normal, m/s; positive while the balls approach.
    pub approach: f64,
    /// Slip velocity **u** of a's surface over b's, m/s.
    pub slip: Vec3,
}

impl Contact {
    /// The contact of `a` and `b`; `normal` is the unit vector from a's centre to b's.
    #[inline]
    pub fn between(normal: Vec3, a: &Body, b: &Body) -> Self {
        let total = a.mass + b.mass;
        let velocity = a.velocity - b.velocity;
        let approach = velocity.dot(normal);
        let spin = a.angular_velocity * a.radius + b.angular_velocity * b.radius;
        Self {
            normal,
            share_a: b.mass / total,
            share_b: a.mass / total,
            approach,
            slip: (velocity - normal * approach) + spin.cross(normal),
        }
    }

    /// Applies the impulse `along` n and `tangential` in the tangent plane, both per m*, to b, and
    /// the opposite impulse to a.
    #[inline]
    pub fn apply(&self, along: f64, tangential: Vec3, a: &mut Body, b: &mut Body) {
        let push = self.normal * along + tangential;
        a.velocity -= push * self.share_a;
        b.velocity += push * self.share_b;
        // The lever arms are R_a·n and −R_b·n, so the torque turns both balls in the same sense.
        let torque = self.normal.cross(tangential);
        a.angular_velocity -= torque * (SPIN_PER_IMPULSE * self.share_a / a.radius);
        b.angular_velocity -= torque * (SPIN_PER_IMPULSE * self.share_b / b.radius);
    }

    /// |u|, m/s.
    #[inline(always)]
    pub fn slip_speed(&self) -> f64 {
        sqrt(self.slip.length_squared())
    }
}
