//! Normal restitution and Coulomb friction between rigid surfaces (TP A.5, A.6, A.14, A.24): J_n =
//! (1 + e)·m*·w, and J_t = min(μ J_n, m*|u|/3.5) against the slip; the second value is m|u|/7 for
//! equal balls. μ is that of the initial slip speed. The vertical part of J_t lifts one ball and
//! presses the other down: after a full hit a rolling ball hops by h = μ²U²/2g, where U is the
//! object ball's speed (TP B.5; Kim 2024).

use super::contact::{Contact, TANGENT_COMPLIANCE};
use crate::math::Vec3;
use crate::physics::BallBall;
use crate::resolve::{Body, restitution};

/// Resolves `contact`.
#[inline]
pub fn resolve(law: &BallBall, contact: &Contact, a: &mut Body, b: &mut Body) {
    let e = restitution::effective(law.restitution, contact.approach);
    let along = (1.0 + e) * contact.approach;
    contact.apply(along, friction(law, contact, along), a, b);
}

/// The friction impulse on b (per m*) that accompanies the impulse `along` n.
#[inline]
pub(super) fn friction(law: &BallBall, contact: &Contact, along: f64) -> Vec3 {
    let slip = contact.slip_speed();
    if slip == 0.0 {
        return Vec3::ZERO;
    }
    let sliding = law.friction.at(slip) * along / slip;
    contact.slip * sliding.min(1.0 / TANGENT_COMPLIANCE)
}
