//! Ball against cushion, one published model per file.
//!
//! The nose is an edge, and the contact's normal **n** points from the ball's centre to the point
//! of it that is touched: at the angle θ above the horizontal, sin θ = (h − z)/R for an edge at
//! height h and a centre at z, straight down for a ball that lands on the edge. The approach speed
//! is **v**·**n** (Han's c = v_x cos θ + v_z sin θ), and the slip at the nose
//! **v** − (**v**·**n**)**n** + R **ω** × **n** (his s_x = v_x sin θ − v_z cos θ + Rω_y, and s_y).
//!
//! # On the bed and off it
//!
//! The slate takes part in the impact of a ball on the bed. Rubber gives way slowly, and a slate
//! does not: it holds what the nose presses down for as long as the nose presses, and throws
//! nothing back. (If it did, with restitution ½, a stunned pool ball would leave every rail at a
//! fifth of its speed upwards, 8 mm high at 2 m/s.) `mathavan-2010` contains that together with
//! the friction at the cloth, and leaves v_z at 0. `restitution` is made for the bed: the horizontal
//! normal speed times −e, nothing else; so is `factors`, which multiplies the speed along the rail and
//! the spin as well. In `han-2005` and `stronge` the slate takes the downward
//! part of the nose's impulse, without friction, as their authors have it. An upward part, where
//! friction at the nose lifts the ball more than the nose presses it, is a hop, and is kept.
//!
//! Off the bed every model acts along **n**, and `mathavan-2010` has no cloth term. The speed V of a
//! restitution's fit and the incidence γ of a friction's are those in the plane on the bed, as
//! their authors measured them, and those against **n** off it.
//!
//! # What holds for every model
//!
//! * **Energy never rises.** Each model's own outcome loses energy or keeps it, and everything
//!   done to that outcome afterwards (below) loses energy or keeps it too.
//! * **The ball leaves the rail.** It parts along **n**. On the bed a small restitution or a strong
//!   back spin may still leave it moving into the rail horizontally: slate and nose hold it then as
//!   a wedge does, and that rest of its approach is lost.
//! * **Slow impacts are lossless.** Below [`restitution::FULL`] an impact fades linearly into a
//!   mirror reflection, which it is below [`restitution::ELASTIC`] (in the plane on the bed, along
//!   **n** off it); otherwise a ball that the cloth pushes against a rail would bounce for ever,
//!   ever smaller. Kinetic energy is convex in the velocities, so a mixture of two outcomes has at
//!   most the mixture of their energies.
//! * **Mirror symmetry is exact.** Reversing the motion along the rail reverses the outcome's,
//!   bit for bit.

mod factors;
mod han_2005;
mod mathavan_2010;
mod stronge;

use super::{Body, SPIN_PER_IMPULSE, restitution};
use crate::math::{Vec2, Vec3, atan2};
use crate::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};

/// A ball about to meet the nose.
#[derive(Clone, Copy, Debug)]
struct Impact {
    /// Unit vector from the centre to the touched point.
    normal: Vec3,
    /// Velocity, m/s.
    velocity: Vec3,
    /// Spin, rad/s.
    spin: Vec3,
    /// Radius, m.
    radius: f64,
    /// Speed along the normal, m/s, > 0.
    approach: f64,
}

/// The nose seen from above, as a ball on the bed meets it.
#[derive(Clone, Copy, Debug)]
struct Rail {
    /// Horizontal unit vector into the rail.
    into: Vec2,
    /// cos θ.
    cos: f64,
    /// Horizontal speed into the rail, m/s, > 0.
    approach: f64,
}

/// What an impact changes.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// Of the velocity, m/s.
    velocity: Vec3,
    /// Of the spin, rad/s.
    spin: Vec3,
}

impl Impact {
    /// Slip of the ball's surface at the nose, m/s.
    fn slip(&self) -> Vec3 {
        (self.velocity - self.normal * self.approach) + self.spin.cross(self.normal) * self.radius
    }

    /// The change due to an impulse (per unit mass, m/s) of the nose, made of `normal` against the
    /// contact's normal and `tangential` across it.
    fn change(&self, normal: f64, tangential: Vec3) -> Change {
        Change {
            velocity: tangential - self.normal * normal,
            spin: self.normal.cross(tangential) * (SPIN_PER_IMPULSE / self.radius),
        }
    }
}

impl Rail {
    /// A horizontal vector's parts into the rail (x) and along it (y, to the left).
    fn turned(&self, v: Vec2) -> Vec2 {
        Vec2::new(v.dot(self.into), v.dot(self.into.perp()))
    }

    /// The vector with these parts.
    fn unturned(&self, v: Vec2) -> Vec2 {
        self.into * v.x + self.into.perp() * v.y
    }
}

impl CushionRestitution {
    /// e = a + bV + cV² at the normal speed `v` (m/s), kept in 0..=1: a fit is a polynomial and
    /// leaves that range outside the speeds that it was made for (Han's is 0 beyond 7.1 m/s).
    #[inline]
    pub fn at(&self, v: f64) -> f64 {
        // A constant need not wait for the speed.
        let e = if self.b == 0.0 && self.c == 0.0 { self.a } else { self.value(v) };
        e.clamp(0.0, 1.0)
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
    /// μ = a + bγ, never below 0, for a ball that comes in at the speeds `across` the normal and
    /// `into` the rail along it, m/s; γ is the angle between.
    #[inline]
    fn at(&self, across: f64, into: f64) -> f64 {
        if self.b == 0.0 {
            return self.a.max(0.0);
        }
        (self.a + self.b * atan2(across, into)).max(0.0)
    }
}

/// Resolves the impact of a ball with a cushion's edge, or with a pocket's liner. `normal` is the
/// unit vector from the ball's centre to the point that it touches; `on_bed` says whether the ball
/// stands on the bed (then the normal has a horizontal part, and the velocity no vertical one). A
/// ball that does not approach is left alone.
#[inline(always)]
pub fn resolve(law: &Cushion, cloth: &Cloth, normal: Vec3, on_bed: bool, ball: &mut Body) {
    let impact = Impact {
        normal,
        velocity: ball.velocity,
        spin: ball.angular_velocity,
        radius: ball.radius,
        approach: ball.velocity.dot(normal),
    };
    if impact.approach <= 0.0 {
        return;
    }
    let change = if on_bed { on_the_bed(law, cloth, &impact) } else { aloft(law, &impact) };
    ball.velocity += change.velocity;
    ball.angular_velocity += change.spin;
}

/// Off the bed: the model's outcome along the normal.
#[cold]
fn aloft(law: &Cushion, impact: &Impact) -> Change {
    let approach = impact.approach;
    let reflection = impact.change(2.0 * approach, Vec3::ZERO);
    faded(approach, reflection, || {
        let e = law.restitution.at(approach);
        let mu = || {
            let across = impact.velocity - impact.normal * approach;
            law.friction.at(across.length(), approach)
        };
        match law.model {
            CushionModel::Restitution => impact.change((1.0 + e) * approach, Vec3::ZERO),
            CushionModel::Factors => {
                factors::resolve(impact, e, law.tangential_factor, law.spin_factor)
            }
            CushionModel::Han2005 | CushionModel::Mathavan2010 => {
                han_2005::resolve(impact, e, mu())
            }
            CushionModel::Stronge => stronge::resolve(impact, e, mu(), law.frequency_ratio),
        }
    })
}

/// On the bed: the model's outcome, kept from going on into the rail and into the slate.
#[inline(always)]
fn on_the_bed(law: &Cushion, cloth: &Cloth, impact: &Impact) -> Change {
    let (velocity, normal) = (impact.velocity.xy(), impact.normal.xy());
    let cos = normal.length();
    let into = normal * (1.0 / cos);
    let rail = Rail { into, cos, approach: velocity.dot(into) };
    let approach = rail.approach;
    let back = |speed: f64| Change { velocity: (into * -speed).with_z(0.0), spin: Vec3::ZERO };
    faded(approach, back(2.0 * approach), || {
        let e = law.restitution.at(approach);
        let mu = || law.friction.at(velocity.dot(into.perp()).abs(), approach);
        let mut change = match law.model {
            CushionModel::Restitution => back((1.0 + e) * approach),
            CushionModel::Factors => {
                let level = Impact { normal: into.with_z(0.0), approach, ..*impact };
                factors::resolve(&level, e, law.tangential_factor, law.spin_factor)
            }
            CushionModel::Han2005 => han_2005::resolve(impact, e, mu()),
            CushionModel::Mathavan2010 => mathavan_2010::resolve(impact, &rail, cloth, e, mu()),
            CushionModel::Stronge => stronge::resolve(impact, e, mu(), law.frequency_ratio),
        };
        let on = approach + change.velocity.xy().dot(into);
        if on > 0.0 {
            change.velocity -= (into * on).with_z(0.0);
        }
        change.velocity.z = change.velocity.z.max(0.0);
        change
    })
}

/// The model's `outcome`, mixed with the mirror reflection where the impact is slow.
#[inline(always)]
fn faded(approach: f64, reflection: Change, outcome: impl FnOnce() -> Change) -> Change {
    // Restitution 0 made effective is the reflection's share itself.
    let reflected = restitution::effective(0.0, approach);
    if reflected == 1.0 {
        return reflection;
    }
    let change = outcome();
    if reflected == 0.0 {
        return change;
    }
    let kept = 1.0 - reflected;
    Change {
        velocity: change.velocity * kept + reflection.velocity * reflected,
        spin: change.spin * kept + reflection.spin * reflected,
    }
}
