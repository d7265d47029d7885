//! Impact of a ball on a cushion: one file per published model.
//!
//! The nose is an edge. The contact's normal **n** points from the ball's centre to the point of
//! contact, at the angle θ above the horizontal: sin θ = (h − z)/R for an edge at height h and a
//! centre at height z; straight down for a ball that lands on the edge. The approach speed is
//! **v**·**n** (Han's c = v_x cos θ + v_z sin θ), and the slip at the nose **v** −
//! (**v**·**n**)**n** + R **ω** × **n** (his s_x = v_x sin θ − v_z cos θ + Rω_y, and s_y).
//!
//! # On the bed and off it
//!
//! The slate takes part in the impact of a ball on the bed. It holds the ball for as long as the
//! nose presses it down, and does not throw it back, because rubber yields slowly and slate does
//! not. (With a restitution of ½ at the slate, a stunned pool ball would leave every rail with a
//! fifth of its speed upwards, 8 mm high at 2 m/s.) `mathavan-2010` contains this, with friction at
//! the cloth, and keeps v_z at 0. `restitution` is meant for the bed: it multiplies the horizontal
//! normal speed by −e and does nothing else. `factors` is meant for the bed, too, and also
//! multiplies the speed along the rail and the spin. In `han-2005` and `stronge` the slate absorbs
//! the downward part of the nose's impulse without friction, as in the publications. An upward
//! part, where friction at the nose lifts the ball more than the nose presses it down, makes the
//! ball hop.
//!
//! Off the bed every model acts along **n**, and `mathavan-2010` has no term for the cloth.
//!
//! In every model a fitted restitution depends on the normal speed V, and a fitted friction on the
//! angle of incidence γ. On the bed V and γ are taken in the horizontal plane, in which the authors
//! of the fits measured them; off the bed they are relative to **n**. Both are those at the first
//! touch: `mathavan-2010`, which integrates the impact, and `stronge`, which follows its phases,
//! keep this e and μ until the ball leaves.
//!
//! # What holds for every model
//!
//! * **The energy never rises.** Each model's own result, and each of the corrections below, loses
//!   or conserves energy.
//! * **The ball leaves the rail.** It separates along **n**. On the bed a ball with little
//!   restitution or strong back spin may still move horizontally into the rail: slate and nose then
//!   wedge it, and this rest of its velocity is lost.
//! * **Slow impacts are lossless.** Below [`restitution::FULL`] the result is mixed linearly with a
//!   mirror reflection, and below [`restitution::ELASTIC`] it is that reflection (horizontal on the
//!   bed, along **n** off it). Otherwise a ball that the cloth pushes against a rail would make
//!   ever smaller bounces without end. Kinetic energy is convex in the velocities, so a mixture of
//!   two results has at most the mixture of their energies.
//! * **Mirror symmetry is exact.** Reversing the motion along the rail reverses the result, bit for
//!   bit.

mod factors;
mod han_2005;
mod mathavan_2010;
mod stronge;

use super::{Body, SPIN_PER_IMPULSE, restitution};
use crate::math::{Vec2, Vec3, atan2};
use crate::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};

/// A ball at the instant of contact with the nose.
#[derive(Clone, Copy, Debug)]
struct NoseContact {
    /// Unit vector from the centre to the point of contact.
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

/// The nose in plan view, for a ball on the bed.
#[derive(Clone, Copy, Debug)]
struct RailFrame {
    /// Horizontal unit vector into the rail.
    into: Vec2,
    /// cos θ.
    cos: f64,
    /// Horizontal speed into the rail, m/s, > 0.
    approach: f64,
}

/// The change of a ball's motion by an impact.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// Change of the velocity, m/s.
    velocity: Vec3,
    /// Change of the spin, rad/s.
    spin: Vec3,
}

impl NoseContact {
    /// Slip of the ball's surface at the nose, m/s.
    fn slip(&self) -> Vec3 {
        (self.velocity - self.normal * self.approach) + self.spin.cross(self.normal) * self.radius
    }

    /// The change by an impulse of the nose (per unit mass, m/s): `normal` against the contact's
    /// normal, and `tangential` across it.
    fn change(&self, normal: f64, tangential: Vec3) -> Change {
        Change {
            velocity: tangential - self.normal * normal,
            spin: self.normal.cross(tangential) * (SPIN_PER_IMPULSE / self.radius),
        }
    }
}

impl RailFrame {
    /// The components of a horizontal vector into the rail (x) and along it (y, to the left).
    fn turned(&self, v: Vec2) -> Vec2 {
        Vec2::new(v.dot(self.into), v.dot(self.into.perp()))
    }

    /// The horizontal vector with these components.
    fn unturned(&self, v: Vec2) -> Vec2 {
        self.into * v.x + self.into.perp() * v.y
    }
}

impl CushionRestitution {
    /// e = a + bV + cV² at the normal speed `v` (m/s), limited to `lowest..=highest`. A fitted
    /// polynomial leaves this range beyond the measured speeds (Han's reaches 0 at 7.1 m/s).
    #[inline]
    pub fn at(&self, v: f64) -> f64 {
        // With a constant the processor need not wait for the speed.
        let e = if self.b == 0.0 && self.c == 0.0 { self.a } else { self.value(v) };
        // `f64::clamp` also tests the order of the limits, which is checked where they are set.
        let e = if e < self.lowest { self.lowest } else { e };
        if e > self.highest { self.highest } else { e }
    }

    fn value(&self, v: f64) -> f64 {
        self.a + v * (self.b + v * self.c)
    }

    /// Whether there is a normal speed ≥ 0 at which the fitted polynomial is within the limits.
    pub fn is_possible(&self) -> bool {
        let at_rest = self.a;
        let turns = self.b * self.c < 0.0;
        let turning = if turns { self.value(-self.b / (2.0 * self.c)) } else { at_rest };
        // The sign at high speed is that of the last coefficient.
        let last = if self.c == 0.0 { self.b } else { self.c };
        let comes_down = at_rest.min(turning) <= self.highest || last < 0.0;
        let comes_up = at_rest.max(turning) >= self.lowest || last > 0.0;
        comes_down && comes_up
    }
}

impl CushionFriction {
    /// μ = a + bγ, at least 0, for a ball that approaches with the speeds `across` the normal and
    /// `into` the rail, m/s; γ is the angle between the two.
    #[inline]
    pub fn at(&self, across: f64, into: f64) -> f64 {
        if self.b == 0.0 {
            return self.a.max(0.0);
        }
        (self.a + self.b * atan2(across, into)).max(0.0)
    }
}

/// Resolves the impact of a ball on a cushion's edge or on a pocket's liner. `normal` is the unit
/// vector from the ball's centre to the point of contact. `on_bed`: whether the ball is on the bed;
/// the normal then has a horizontal part, and the velocity has no vertical one. A ball that does
/// not approach is left unchanged.
#[inline(always)]
pub fn resolve(law: &Cushion, cloth: &Cloth, normal: Vec3, on_bed: bool, ball: &mut Body) {
    let impact = NoseContact {
        normal,
        velocity: ball.velocity,
        spin: ball.angular_velocity,
        radius: ball.radius,
        approach: ball.velocity.dot(normal),
    };
    if impact.approach <= 0.0 {
        return;
    }
    let change =
        if on_bed { resolve_on_bed(law, cloth, &impact) } else { resolve_off_bed(law, &impact) };
    ball.velocity += change.velocity;
    ball.angular_velocity += change.spin;
}

/// Off the bed: the model's result along the normal.
#[cold]
fn resolve_off_bed(law: &Cushion, impact: &NoseContact) -> Change {
    let approach = impact.approach;
    let reflection = impact.change(2.0 * approach, Vec3::ZERO);
    blended(approach, reflection, || {
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

/// On the bed: the model's result, without motion into the rail or into the slate.
#[inline(always)]
fn resolve_on_bed(law: &Cushion, cloth: &Cloth, impact: &NoseContact) -> Change {
    let (velocity, normal) = (impact.velocity.xy(), impact.normal.xy());
    let cos = normal.length();
    let into = normal * (1.0 / cos);
    let rail = RailFrame { into, cos, approach: velocity.dot(into) };
    let approach = rail.approach;
    let back = |speed: f64| Change { velocity: (into * -speed).with_z(0.0), spin: Vec3::ZERO };
    blended(approach, back(2.0 * approach), || {
        let e = law.restitution.at(approach);
        let mu = || law.friction.at(velocity.dot(into.perp()).abs(), approach);
        let mut change = match law.model {
            CushionModel::Restitution => back((1.0 + e) * approach),
            CushionModel::Factors => {
                let level = NoseContact { normal: into.with_z(0.0), approach, ..*impact };
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

/// The model's `outcome`, mixed with the mirror reflection if the impact is slow.
#[inline(always)]
fn blended(approach: f64, reflection: Change, outcome: impl FnOnce() -> Change) -> Change {
    // The effective restitution for e = 0 is the weight of the reflection.
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
