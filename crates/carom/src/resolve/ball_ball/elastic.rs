//! Normal restitution without friction: the velocities along the line of centres are exchanged
//! (Leckie & Greenspan 2006; TP 3.1), reduced by the coefficient of restitution. Spins do not
//! change.

use super::contact::Contact;
use crate::math::Vec3;
use crate::physics::BallBall;
use crate::resolve::{Body, restitution};

/// Resolves `contact`.
#[inline]
pub fn resolve(law: &BallBall, contact: &Contact, a: &mut Body, b: &mut Body) {
    let e = restitution::effective(law.restitution, contact.approach);
    contact.apply((1.0 + e) * contact.approach, Vec3::ZERO, a, b);
}
