//! Restitution and friction between surfaces with tangential compliance ([`stronge`]). Rigid
//! surfaces (`frictional`) throw a ball by at most atan(tan φ/7) at the cut angle φ, 4.7° at 30°;
//! measured throws reach 6° (Alciatore, Billiards Digest, Sept 2006). μ is that of the initial slip
//! speed, and the slip keeps its direction.

use super::contact::{Contact, TANGENT_COMPLIANCE};
use crate::math::Vec3;
use crate::physics::BallBall;
use crate::resolve::{Body, restitution, stronge};

/// Resolves `contact`.
#[inline]
pub fn resolve(law: &BallBall, contact: &Contact, a: &mut Body, b: &mut Body) {
    let e = restitution::effective(law.restitution, contact.approach);
    let along = (1.0 + e) * contact.approach;
    contact.apply(along, friction(law, contact, along, e), a, b);
}

/// The friction impulse on b (per m*) that accompanies the impulse `along` n.
#[inline]
pub(super) fn friction(law: &BallBall, contact: &Contact, along: f64, restitution: f64) -> Vec3 {
    let slip = contact.slip_speed();
    if slip == 0.0 {
        return Vec3::ZERO;
    }
    let impact = stronge::Impact {
        approach: along / (1.0 + restitution),
        slip,
        restitution,
        friction: law.friction.at(slip),
        frequency_ratio: law.frequency_ratio,
    };
    contact.slip * ((1.0 - impact.final_slip() / slip) * (1.0 / TANGENT_COMPLIANCE))
}
