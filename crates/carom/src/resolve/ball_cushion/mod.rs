//! Ball against cushion, one published model per file.
//!
//! # Frame
//!
//! Every model works in the contact's own frame: x into the rail, y along it (ẑ × x), z up. The
//! nose touches the ball at the angle θ above its centre, sin θ = (h − R)/R, so the contact's
//! normal points along (cos θ, 0, sin θ) from the ball's centre.
//!
//! # What holds for every model
//!
//! * **Energy never rises.** Each model's own outcome loses energy or keeps it, and everything
//!   done to that outcome afterwards (below) loses energy or keeps it too.
//! * **The ball leaves the rail.** The vertical part of the impulse is taken by the slate. Where
//!   a small restitution or a strong back spin would then leave the ball still moving into the
//!   rail, slate and nose hold it as a wedge does: that rest of its approach is lost.
//! * **Slow impacts are lossless.** Below [`restitution::FULL`] an impact fades linearly into a
//!   mirror reflection, which it is below [`restitution::ELASTIC`]; otherwise a ball that the
//!   cloth pushes against a rail would bounce for ever, ever smaller. Kinetic energy is convex in
//!   the velocities, so a mixture of two outcomes has at most the mixture of their energies.
//! * **Mirror symmetry is exact.** Reversing the motion along the rail reverses the outcome's,
//!   bit for bit.

mod han_2005;
mod mathavan_2010;
mod stronge;

use super::{Body, restitution};
use crate::math::{Vec2, Vec3, atan2, sqrt};
use crate::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};

/// A ball about to meet the nose, in the contact's frame.
#[derive(Clone, Copy, Debug)]
struct Impact {
    /// Velocity along x (into the rail, positive) and y, m/s.
    velocity: Vec2,
    /// Spin, rad/s.
    spin: Vec3,
    /// Radius, m.
    radius: f64,
    /// Sine of the nose's angle above the ball's centre.
    sin: f64,
    /// Its cosine.
    cos: f64,
}

/// What an impact changes, in the contact's frame.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// Of the velocity, m/s.
    velocity: Vec2,
    /// Of the spin, rad/s.
    spin: Vec3,
}

impl Impact {
    /// The change due to an impulse (per unit mass, m/s) that acts at the nose; its vertical part
    /// turns the ball but is otherwise taken by the slate. ΔΩ = (5/2R²) **c** × **P**.
    fn change(&self, impulse: Vec3) -> Change {
        let arm = Vec3::new(self.cos, 0.0, self.sin);
        Change { velocity: impulse.xy(), spin: arm.cross(impulse) * (2.5 / self.radius) }
    }

    /// Slip of the ball at the nose along the two tangents of the contact, m/s: (sin θ, 0, −cos θ)
    /// and y (Han 2005, eq. 14, the second with the opposite sign).
    fn nose_slip(&self) -> Vec2 {
        let (v, w) = (self.velocity, self.spin);
        Vec2::new(
            v.x * self.sin + self.radius * w.y,
            v.y + self.radius * (w.z * self.cos - w.x * self.sin),
        )
    }

    /// The impulse (per unit mass, m/s) made of `normal` against the contact's normal and
    /// `tangential` along the two tangents of [`Self::nose_slip`].
    fn impulse(&self, normal: f64, tangential: Vec2) -> Vec3 {
        Vec3::new(
            tangential.x * self.sin - normal * self.cos,
            tangential.y,
            -tangential.x * self.cos - normal * self.sin,
        )
    }
}

impl CushionRestitution {
    /// e = a + bV + cV² at the normal speed `v` (m/s), kept in 0..=1: a fit is a polynomial and
    /// leaves that range outside the speeds that it was made for (Han's is 0 beyond 7.1 m/s).
    #[inline]
    pub fn at(&self, v: f64) -> f64 {
        self.value(v).clamp(0.0, 1.0)
    }

    fn value(&self, v: f64) -> f64 {
        self.a + v * (self.b + v * self.c)
    }

    /// Whether the fit, before it is kept in 0..=1, is there at any normal speed at all.
    pub fn is_possible(&self) -> bool {
        let at_rest = self.a;
        let turns = self.b * self.c < 0.0;
        let turning = if turns { self.value(-self.b / (2.0 * self.c)) } else { at_rest };
        // What it tends to at high speed has the sign of its last coefficient.
        let last = if self.c == 0.0 { self.b } else { self.c };
        let falls_to_1 = at_rest.min(turning) <= 1.0 || last < 0.0;
        let rises_to_0 = at_rest.max(turning) >= 0.0 || last > 0.0;
        falls_to_1 && rises_to_0
    }
}

impl CushionFriction {
    /// μ = a + bγ for a ball that comes in with `velocity` (x into the rail; m/s), never below 0.
    #[inline]
    fn at(&self, velocity: Vec2) -> f64 {
        if self.b == 0.0 {
            return self.a.max(0.0);
        }
        (self.a + self.b * atan2(velocity.y.abs(), velocity.x)).max(0.0)
    }
}

/// Resolves the impact of a ball with a cushion nose. `into` is the horizontal unit vector from
/// the ball's centre towards the nose; the nose stands at angle θ above the ball's centre,
/// sin θ = (h − R)/R (negative if below). A ball that does not approach is left alone.
pub fn resolve(law: &Cushion, cloth: &Cloth, into: Vec2, sin_theta: f64, ball: &mut Body) {
    let along = into.perp();
    let velocity = ball.velocity.xy();
    let approach = velocity.dot(into);
    if approach <= 0.0 {
        return;
    }
    let spin = ball.angular_velocity;
    let impact = Impact {
        velocity: Vec2::new(approach, velocity.dot(along)),
        spin: Vec3::new(spin.xy().dot(into), spin.xy().dot(along), spin.z),
        radius: ball.radius,
        sin: sin_theta,
        cos: sqrt(1.0 - sin_theta * sin_theta),
    };
    let change = settle(law, cloth, &impact);
    let kick = into * change.velocity.x + along * change.velocity.y;
    let turn = into * change.spin.x + along * change.spin.y;
    ball.velocity += kick.with_z(0.0);
    ball.angular_velocity += turn.with_z(change.spin.z);
}

/// The model's outcome, kept from approaching further, and mixed with the mirror reflection where
/// the impact is slow.
fn settle(law: &Cushion, cloth: &Cloth, impact: &Impact) -> Change {
    let approach = impact.velocity.x;
    // Restitution 0 made effective is the reflection's share itself.
    let reflected = restitution::effective(0.0, approach);
    let reflection = -2.0 * approach * reflected;
    if reflected == 1.0 {
        return Change { velocity: Vec2::new(reflection, 0.0), spin: Vec3::ZERO };
    }
    let e = law.restitution.at(approach);
    let mu = law.friction.at(impact.velocity);
    let mut change = match law.model {
        CushionModel::Restitution => {
            Change { velocity: Vec2::new(-(1.0 + e) * approach, 0.0), spin: Vec3::ZERO }
        }
        CushionModel::Han2005 => han_2005::resolve(impact, e, mu),
        CushionModel::Mathavan2010 => mathavan_2010::resolve(impact, cloth, e, mu),
        CushionModel::Stronge => stronge::resolve(impact, e, mu, law.frequency_ratio),
    };
    change.velocity.x = change.velocity.x.min(-approach);
    if reflected > 0.0 {
        change.velocity = change.velocity * (1.0 - reflected);
        change.spin = change.spin * (1.0 - reflected);
        change.velocity.x += reflection;
    }
    change
}
