//! Ball on a fixed sharp edge, held there by gravity: the lip of a hole in the slate, or a
//! cushion's edge for a ball that comes over it from the rail's top.
//!
//! A ball that tips over an edge turns about it. Here it does so in small hops off the edge, each a
//! parabola and a contact like any other, so that nothing but impacts and flight is needed, and
//! the moment at which the ball leaves the edge emerges. A contact is one rigid impulse along the
//! true normal **n** (from the centre to the edge), with Coulomb friction against the slip
//! **v** − (**v**·**n**)**n** + R **ω** × **n**, which it drives towards turning about the edge
//! without slip. Two rules keep the hops from dying out, so that their number is bounded:
//!
//! * up to [`EDGE_HOP`] the ball parts as fast as it came: a gentle contact keeps the energy of the
//!   motion along **n**;
//! * it parts with [`EDGE_HOP`], or with as much of it as [`HOP_SHARE`] of its energy gives, if it
//!   would part slower. The rest of its motion pays for that: the velocity along the edge's
//!   surface and the spin shrink together, which keeps a ball that turns without slip so.
//!
//! Energy never rises. A hop of 3 cm/s is 0.05 mm high and takes 6 ms. In the mean over the hops the
//! edge pushes as a smooth support would, so a ball that rolls on to it at speed v leaves it where
//! cos θ = (10 + 7v²/gR)/17 from the vertical if it does not slip (textbook: 5/7 of the work of
//! gravity goes into the speed), and at once from v = √(gR) up.

use super::{Body, SPIN_PER_IMPULSE};
use crate::math::{Vec3, sqrt};
use crate::physics::Surface;

/// Parting speed of the hops, m/s: 0.05 mm high. Higher, and a tipping ball would be seen to hop;
/// lower, and it would need more contacts.
pub const EDGE_HOP: f64 = 0.03;

/// The largest share of a ball's energy that goes into a hop. A larger one takes more of the speed
/// of a slow ball, and delays its fall; a smaller one means more hops.
pub const HOP_SHARE: f64 = 0.5;

/// A ball touches an edge on which gravity presses it; `normal` is the unit vector from its centre
/// to the touched point. It need not approach: a ball that rolls on to an edge does not. `law` is
/// that of the edge's surface.
pub fn resolve(law: &Surface, normal: Vec3, ball: &mut Body) {
    let along = ball.velocity.dot(normal);
    let approach = along.max(0.0);
    let mut parting = (law.restitution * approach).max(approach.min(EDGE_HOP)).max(-along);
    let mut velocity = ball.velocity - normal * along;
    let mut spin = ball.angular_velocity;

    let slip = velocity + spin.cross(normal) * ball.radius;
    let speed = slip.length();
    if speed > 0.0 && approach > 0.0 {
        let share =
            (law.friction * (approach + parting) / speed).min(1.0 / (1.0 + SPIN_PER_IMPULSE));
        let impulse = slip * -share;
        velocity += impulse;
        spin += normal.cross(impulse) * (SPIN_PER_IMPULSE / ball.radius);
    }

    // Twice the energies per unit mass.
    let across = velocity.length_squared()
        + ball.radius * ball.radius * spin.length_squared() * (1.0 / SPIN_PER_IMPULSE);
    let total = across + parting * parting;
    let least = (EDGE_HOP * EDGE_HOP).min(HOP_SHARE * total);
    if parting * parting < least {
        let kept = sqrt((total - least) / across);
        velocity = velocity * kept;
        spin = spin * kept;
        parting = sqrt(least);
    }
    ball.velocity = velocity - normal * parting;
    ball.angular_velocity = spin;
}
