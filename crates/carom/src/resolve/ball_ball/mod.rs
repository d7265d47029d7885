//! Impact of two balls: one file per published model.
//!
//! One law applies to balls on the cloth and in the air, along the true line of centres
//! ([`contact`]). Vertical velocities change, too. The slate's effect on a ball that is pressed
//! down or hardly lifted is not part of the impact; the caller applies it afterwards with
//! [`ball_slate::settle`](super::ball_slate::settle). The models are
//!
//! * [`elastic`]: normal restitution, no friction;
//! * [`frictional`]: normal restitution and Coulomb friction between rigid surfaces;
//! * [`compliant`]: the same with tangential compliance of the surfaces (Stronge);
//! * [`mathavan_2014`]: the impulse integrated, with friction of the cloth where both balls stand
//!   on it;
//! * [`held`]: a ball that comes down gently on a ball that the slate holds.
//!
//! Balls that touch when one of them is hit are resolved all together
//! ([`network`](super::network)).
//!
//! In every model restitution rises to 1 at low speed ([`super::restitution`]), and the energy
//! never rises. If the two balls are exchanged, so are the results, and a mirrored impact has the
//! mirrored result, bit for bit.

pub mod compliant;
pub mod contact;
pub mod elastic;
pub mod frictional;
pub mod held;
pub mod mathavan_2014;

use super::Body;
use crate::math::Vec3;
use crate::physics::{BallBall, BallBallModel, Cloth};
use contact::Contact;

/// Resolves the impact of two balls that touch and approach. `normal` is the unit vector from `a`'s
/// centre to `b`'s. Balls that do not approach are left unchanged.
pub fn resolve(law: &BallBall, cloth: &Cloth, normal: Vec3, a: &mut Body, b: &mut Body) {
    let contact = Contact::between(normal, a, b);
    if contact.approach <= 0.0 {
        return;
    }
    match law.model {
        BallBallModel::Elastic => elastic::resolve(law, &contact, a, b),
        BallBallModel::Frictional => frictional::resolve(law, &contact, a, b),
        BallBallModel::Mathavan2014 => mathavan_2014::resolve(law, cloth, &contact, a, b),
        BallBallModel::Compliant => compliant::resolve(law, &contact, a, b),
    }
}
