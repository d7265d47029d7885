//! Normal restitution and Coulomb friction between rigid surfaces (TP A.5, A.6, A.14, A.24):
//! J_n = (1 + e)·m*·w, J_t = min(μ J_n, m*|u|/3.5) against the slip, which is m|u|/7 for equal
//! balls. μ is taken at the initial slip speed.

use super::contact::{Contact, TANGENT_COMPLIANCE};
use crate::math::Vec2;
use crate::physics::BallBall;
use crate::resolve::{Body, restitution};

/// Resolves `contact`.
#[inline]
pub fn resolve(law: &BallBall, contact: &Contact, a: &mut Body, b: &mut Body) {
    let e = restitution::effective(law.restitution, contact.approach);
    let along = (1.0 + e) * contact.approach;
    contact.apply(along, friction(law, contact, along), a, b);
}

/// The friction impulse on b (per m*), along t₁ and t₂, that goes with the impulse `along` h.
#[inline]
pub(super) fn friction(law: &BallBall, contact: &Contact, along: f64) -> Vec2 {
    let slip = contact.slip_speed();
    if slip == 0.0 {
        return Vec2::ZERO;
    }
    let sliding = law.friction.at(slip) * contact.normal_impulse(along) / slip;
    contact.slip * sliding.min(1.0 / TANGENT_COMPLIANCE)
}
