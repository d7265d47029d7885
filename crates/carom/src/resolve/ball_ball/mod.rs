//! Ball against ball: one published model per file.
//!
//! One law holds for balls on the cloth and in the air, along the true line of centres
//! ([`contact`]). Vertical velocities are kept and changed; what the slate does to a ball that is
//! pressed on it or hardly leaves it is not part of the impact, but
//! [`ball_slate::settle`](super::ball_slate::settle), which the caller lets follow. The models are
//!
//! * [`elastic`]: normal restitution, no friction;
//! * [`frictional`]: normal restitution and Coulomb friction between rigid surfaces;
//! * [`compliant`]: the same with surfaces that give way and spring back (Stronge);
//! * [`mathavan_2014`]: the impulse integrated, with the friction of the cloth where both balls
//!   stand on it;
//! * [`network`]: balls that touch when one of them is struck, all together.
//!
//! In all of them restitution rises to 1 at low speed ([`super::restitution`]), energy never
//! rises, exchanging the two balls exchanges the results, and a mirrored impact gives the
//! mirrored result, bit for bit.

pub mod compliant;
pub mod contact;
pub mod elastic;
pub mod frictional;
pub mod held;
pub mod mathavan_2014;
pub mod network;

use super::Body;
use crate::math::Vec3;
use crate::physics::{BallBall, BallBallModel, Cloth};
use contact::Contact;

/// Resolves the impact of two balls that touch and approach. `normal` is the unit vector from
/// `a`'s centre to `b`'s. Balls that do not approach are left as they are.
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
