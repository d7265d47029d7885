//! A ball on a fixed sharp edge, pressed on it by gravity: the lip of a hole in the slate, or a
//! cushion's edge for a ball that comes over it from the rail's top. Also a ball that runs along
//! the round wall of a hole, or inside along its lip, and is pressed on it by its own speed.
//!
//! A contact is one rigid impulse along the true normal **n** (from the centre to the edge) with
//! restitution, and Coulomb friction against the slip **v** − (**v**·**n**)**n** + R **ω** × **n**,
//! which tends towards turning about the edge without slip.
//!
//! A ball that falls over an edge turns about it. Here it does so in small hops, each of them a
//! parabola between two contacts. So impacts and flight suffice, and the place where the ball
//! leaves the edge need not be computed. With restitution alone the hops would die out in an
//! infinite number of contacts. So the ball separates at a minimum speed, with which it comes back
//! after the shortest of these times:
//!
//! * [`HOP_TIME`];
//! * the fraction [`PULL_SHARE`] of the time until the force that presses it on the edge would
//!   vanish, or the time in which it turns by [`HOP_ANGLE`] if that is longer;
//! * on a round edge or wall, the time in which it moves by [`ROUND_ANGLE`] about the axis.
//!
//! So the hops become shorter towards the place where the ball leaves the edge. A hop has at most
//! the fraction [`HOP_SHARE`] of the ball's kinetic energy. Velocity and spin of the rest of the
//! motion are reduced by one common factor that makes up for this energy; a ball that turns without
//! slip continues to do so. The energy never rises, and all hops together lose at most the energy
//! of the highest hop, m·g·0.08 mm.
//!
//! Averaged over the hops, the edge supports the ball like a smooth support. So a ball that rolls
//! on to it with speed v and does not slip leaves it when its centre is at the angle θ from the
//! vertical, cos θ = (10 + 7v²/gR)/17 (textbook: 5/7 of the work of gravity become translational
//! energy), and at once if v ≥ √(gR).

use super::{Body, SPIN_PER_IMPULSE, restitution};
use crate::math::{Vec2, Vec3, sqrt};
use crate::physics::Surface;

/// Longest duration of a hop, s; the hop is then 0.08 mm high. Longer, and the hops of a falling
/// ball would be visible; shorter, and a slow ball would need more contacts.
pub const HOP_TIME: f64 = 8e-3;

/// A hop may always turn the ball about the edge by this angle, rad: two degrees, which is the
/// accuracy of the place where the ball leaves the edge.
pub const HOP_ANGLE: f64 = 0.04;

/// A hop may last this fraction of the time after which the ball would leave the edge if it turned
/// on uniformly. Larger, and the ball might not come back: it returns within 0.75 of that time or
/// never.
pub const PULL_SHARE: f64 = 0.33;

/// Bound on how fast the pull on the edge, g cos θ − v²/R, decreases, as a multiple of the decrease
/// of g cos θ: v² grows by 10/7 of it for a rolling ball and by twice as much for a sliding one.
const LOSS: f64 = 3.0;

/// Largest angle about the axis of a round edge or wall in one hop, rad. The separation speed is
/// then a twentieth of the speed along the edge. Smaller, and a ball that runs around a hole would
/// need more contacts.
pub const ROUND_ANGLE: f64 = 0.1;

/// Largest fraction of a ball's kinetic energy in the motion along the normal after a contact.
/// Larger, and a slow ball would lose more speed and fall later; smaller, and there would be more
/// hops.
pub const HOP_SHARE: f64 = 0.5;

/// An edge or an upright wall at the point where a ball touches it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Unit vector from the ball's centre to the point of contact.
    pub normal: Vec3,
    /// Horizontal unit vector along the edge, in either direction.
    pub along: Vec2,
    /// Curvature, along `normal`, of the centre's path along the edge, 1/m: positive where the edge
    /// curves around the ball, as a hole's lip does around a ball inside; 0 for a straight edge.
    pub bend: f64,
    /// Curvature of the centre's path across the edge, 1/m, away from the ball: 1/R at an edge, 0
    /// at a wall.
    pub turn: f64,
}

impl Edge {
    /// Whether `ball` approaches so slowly that it is pressed on the edge and does not bounce off
    /// it: slower than twice the speed of hops. `gravity` in m/s².
    pub fn presses(&self, gravity: f64, ball: &Body) -> bool {
        let approach = ball.velocity.dot(self.normal);
        approach < 2.0 * self.hop_speed(gravity, ball.velocity - self.normal * approach)
    }

    /// The separation speed, m/s, after which a ball with the `velocity` across the normal comes
    /// back within [`HOP_TIME`], [`PULL_SHARE`] or [`HOP_ANGLE`], and [`ROUND_ANGLE`]; 0 if it
    /// leaves the edge.
    fn hop_speed(&self, gravity: f64, velocity: Vec3) -> f64 {
        let along = velocity.xy().dot(self.along);
        let turning = (velocity.length_squared() - along * along).max(0.0);
        // What remains of gravity and of the centrifugal force along the edge after holding the
        // centre on its path across the edge.
        let pull = along * along * self.bend - gravity * self.normal.z - turning * self.turn;
        if pull <= 0.0 {
            return 0.0;
        }
        let within = |amount: f64, rate: f64| amount / rate.max(f64::MIN_POSITIVE);
        let speed = sqrt(turning);
        // An upper bound: the ball descends faster while it turns.
        let sinking = velocity.z.abs() + HOP_ANGLE * speed;
        let loss = LOSS * gravity * self.turn * sinking;
        let across = within(HOP_ANGLE, self.turn * speed).max(within(PULL_SHARE * pull, loss));
        let around = within(ROUND_ANGLE, self.bend.max(0.0) * along.abs());
        0.5 * pull * HOP_TIME.min(across).min(around)
    }
}

/// Resolves the contact of `ball` with an edge on which gravity (m/s²), or its own motion along a
/// round edge, presses it. The ball need not approach; a ball that rolls on to an edge does not.
/// `law` is that of the edge's surface.
pub fn resolve(law: &Surface, gravity: f64, edge: &Edge, ball: &mut Body) {
    let normal = edge.normal;
    let along = ball.velocity.dot(normal);
    let approach = along.max(0.0);
    let e = restitution::effective(law.restitution, approach);
    let rebound = (e * approach).max(-along);
    let mut velocity = ball.velocity - normal * along;
    let mut spin = ball.angular_velocity;
    let hop = edge.hop_speed(gravity, velocity);
    // The separation speed that the energy allows; twice the kinetic energy per unit mass, of the
    // motion across the normal and of the whole motion.
    let parting_and_energies = |velocity: Vec3, spin: Vec3| {
        let across = velocity.length_squared()
            + ball.radius * ball.radius * spin.length_squared() * (1.0 / SPIN_PER_IMPULSE);
        let total = across + along * along;
        (rebound.max(hop.min(sqrt(HOP_SHARE * total))), across, total)
    };

    let slip = velocity + spin.cross(normal) * ball.radius;
    let speed = slip.length();
    if speed > 0.0 {
        let (parting, ..) = parting_and_energies(velocity, spin);
        let grip = law.friction * (along + parting);
        let share = (grip / speed).min(1.0 / (1.0 + SPIN_PER_IMPULSE));
        let impulse = slip * -share;
        velocity += impulse;
        spin += normal.cross(impulse) * (SPIN_PER_IMPULSE / ball.radius);
    }

    let (parting, across, total) = parting_and_energies(velocity, spin);
    if parting > along.abs() {
        let kept = sqrt((total - parting * parting) / across);
        velocity = velocity * kept;
        spin = spin * kept;
    }
    ball.velocity = velocity - normal * parting;
    ball.angular_velocity = spin;
}
