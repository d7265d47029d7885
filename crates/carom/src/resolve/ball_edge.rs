//! Ball on a fixed sharp edge, held there by gravity: the lip of a hole in the slate, or a
//! cushion's edge for a ball that comes over it from the rail's top. Likewise a ball that runs along
//! the round wall of a hole, or along its lip from inside, held there by its own speed.
//!
//! A contact is one rigid impulse along the true normal **n** (from the centre to the edge) with
//! restitution, and Coulomb friction against the slip **v** − (**v**·**n**)**n** + R **ω** × **n**,
//! which it drives towards turning about the edge without slip.
//!
//! A ball that tips over an edge turns about it. Here it does so in small hops off the edge, each a
//! parabola between two contacts, so that nothing but impacts and flight is needed, and the place
//! where the ball leaves the edge emerges. Restitution alone would let the hops die out in ever
//! more contacts. So a ball parts at least as fast as brings it back after [`HOP_TIME`], or, if that
//! comes sooner, after [`PULL_SHARE`] of the time in which what holds it on the edge would be used
//! up, but not before it has turned by [`HOP_ANGLE`]: the hops get shorter towards the place where it
//! leaves. At most [`HOP_SHARE`] of its kinetic energy is used for that. The rest of its motion pays
//! what the hop gains: velocity and spin shrink together, which keeps a ball that turns without slip
//! so. Energy never rises; all hops together lose no more than the highest has, m·g·0.08 mm.
//!
//! In the mean over the hops the edge pushes as a smooth support would. So a ball that rolls on to
//! it at speed v and does not slip leaves it where its centre stands at the angle θ from the
//! vertical, cos θ = (10 + 7v²/gR)/17 (textbook: the work of gravity goes 5/7 into the speed), and
//! from v = √(gR) up at once.

use super::{Body, SPIN_PER_IMPULSE, restitution};
use crate::math::{Vec2, Vec3, sqrt};
use crate::physics::Surface;

/// How long a hop lasts at most, s; it is then 0.08 mm high. Longer, and a tipping ball would be
/// seen to hop; shorter, and a slow one would need more contacts.
pub const HOP_TIME: f64 = 8e-3;

/// How far a ball may always turn about the edge in a hop, rad: two degrees, which is how well
/// the place where it leaves the edge is met.
pub const HOP_ANGLE: f64 = 0.04;

/// A hop may last this share of the time after which the ball would leave the edge if it turned on
/// steadily. More, and it would not come back: it returns within 0.75 of that time or never.
pub const PULL_SHARE: f64 = 0.33;

/// What a ball sinks as it turns about an edge takes from gravity's pull on it, g cos θ − v²/R, at most
/// so many times what it takes from g cos θ: v² grows by 10/7 of that if it rolls, by twice if it slides.
const LOSS: f64 = 3.0;

/// How far a ball goes around the axis of a round edge or wall in a hop, rad. It then parts with a
/// twentieth of its speed along it; less, and a ball that runs around a hole would need more contacts.
pub const ROUND_ANGLE: f64 = 0.1;

/// The largest share of a ball's kinetic energy in the motion along the normal after a contact. A
/// larger one takes more of the speed of a slow ball and delays its fall; a smaller one means more
/// hops.
pub const HOP_SHARE: f64 = 0.5;

/// An edge, or an upright wall, where a ball touches it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Unit vector from the ball's centre to the touched point.
    pub normal: Vec3,
    /// Horizontal unit vector along it, either way.
    pub along: Vec2,
    /// Curvature along `normal` of the centre's way along it, 1/m: positive where it bends around the
    /// ball, as a hole's lip does around a ball inside; 0 where it is straight.
    pub bend: f64,
    /// Curvature of the centre's way across it, 1/m, away from the ball: 1/R at an edge, 0 at a wall.
    pub turn: f64,
}

impl Edge {
    /// Whether `ball` comes so gently that it is pressed on the edge rather than thrown at it: not
    /// faster than twice as fast as hops come back. `gravity` in m/s².
    pub fn presses(&self, gravity: f64, ball: &Body) -> bool {
        let approach = ball.velocity.dot(self.normal);
        approach < 2.0 * self.hop_speed(gravity, ball.velocity - self.normal * approach)
    }

    /// The parting speed, m/s, from which a ball that moves with `velocity` across the normal is brought
    /// back within [`HOP_TIME`], [`PULL_SHARE`] or [`HOP_ANGLE`], and [`ROUND_ANGLE`]; 0 if it flies off
    /// anyway.
    fn hop_speed(&self, gravity: f64, velocity: Vec3) -> f64 {
        let along = velocity.xy().dot(self.along);
        let turning = (velocity.length_squared() - along * along).max(0.0);
        // What gravity and the way along the edge leave after holding the centre on its way across.
        let pull = along * along * self.bend - gravity * self.normal.z - turning * self.turn;
        if pull <= 0.0 {
            return 0.0;
        }
        let within = |amount: f64, rate: f64| amount / rate.max(f64::MIN_POSITIVE);
        let speed = sqrt(turning);
        // It sinks faster as it turns: as fast as here is not what it will do in the hop.
        let sinking = velocity.z.abs() + HOP_ANGLE * speed;
        let loss = LOSS * gravity * self.turn * sinking;
        let across = within(HOP_ANGLE, self.turn * speed).max(within(PULL_SHARE * pull, loss));
        let around = within(ROUND_ANGLE, self.bend.max(0.0) * along.abs());
        0.5 * pull * HOP_TIME.min(across).min(around)
    }
}

/// A ball touches an edge on which it is pressed by gravity (m/s²), or by its own way along a round
/// one. The ball need not approach: one that rolls on to an edge does not. `law` is that of the
/// edge's surface.
pub fn resolve(law: &Surface, gravity: f64, edge: &Edge, ball: &mut Body) {
    let normal = edge.normal;
    let along = ball.velocity.dot(normal);
    let approach = along.max(0.0);
    let e = restitution::effective(law.restitution, approach);
    let rebound = (e * approach).max(-along);
    let mut velocity = ball.velocity - normal * along;
    let mut spin = ball.angular_velocity;
    let hop = edge.hop_speed(gravity, velocity);
    // Twice the energy per unit mass, in a hop of the speed `parting` at most.
    let affordable = |velocity: Vec3, spin: Vec3| {
        let across = velocity.length_squared()
            + ball.radius * ball.radius * spin.length_squared() * (1.0 / SPIN_PER_IMPULSE);
        let total = across + along * along;
        (rebound.max(hop.min(sqrt(HOP_SHARE * total))), across, total)
    };

    let slip = velocity + spin.cross(normal) * ball.radius;
    let speed = slip.length();
    if speed > 0.0 {
        let (parting, ..) = affordable(velocity, spin);
        let grip = law.friction * (along + parting);
        let share = (grip / speed).min(1.0 / (1.0 + SPIN_PER_IMPULSE));
        let impulse = slip * -share;
        velocity += impulse;
        spin += normal.cross(impulse) * (SPIN_PER_IMPULSE / ball.radius);
    }

    let (parting, across, total) = affordable(velocity, spin);
    if parting > along.abs() {
        let kept = sqrt((total - parting * parting) / across);
        velocity = velocity * kept;
        spin = spin * kept;
    }
    ball.velocity = velocity - normal * parting;
    ball.angular_velocity = spin;
}
