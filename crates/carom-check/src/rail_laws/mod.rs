//! What the published laws say about a ball on the bed that meets a rail: closed formulas where the
//! paper has them, and otherwise the paper's equations, integrated in small equal steps.
//!
//! Frame: x points into the rail, y to the left along it, z upwards. θ is the angle of the nose
//! above the ball's centre, sin θ = (h − R)/R. Changes are per unit mass.

#[cfg(test)]
mod compared;
mod han;
mod mathavan;
pub(crate) mod stronge;

use carom::math::{Vec3, atan2, sqrt};
use carom::physics::{Cloth, Cushion, CushionModel};

/// A ball at the rail.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RailImpact {
    /// sin θ and cos θ.
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    /// Velocity, m/s; horizontal.
    pub(crate) velocity: Vec3,
    /// Rω, m/s.
    pub(crate) surface: Vec3,
}

/// The motion after an impact, and how far a result may differ from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rebound {
    pub(crate) velocity: Vec3,
    pub(crate) surface: Vec3,
    /// Largest error of this result, m/s.
    pub(crate) accuracy: f64,
}

/// Approach speed up to which an impact is a mirror reflection, and the one from which the law
/// alone decides, m/s: docs/guarantees.md, “Slow impacts”.
pub(crate) const REFLECTS: f64 = 1e-3;
const FULL: f64 = 2e-3;

/// Restitution at the `approach` speed, m/s, with the reflection of slow impacts; `e` is the law's.
pub(crate) fn restitution(e: f64, approach: f64) -> f64 {
    let reflected = ((FULL - approach) / (FULL - REFLECTS)).clamp(0.0, 1.0);
    e + (1.0 - e) * reflected
}

impl RailImpact {
    /// Slip at the nose: along (sin θ, 0, −cos θ), and along y (Han 2005, with the sign of the
    /// second reversed).
    fn slip(&self) -> [f64; 2] {
        let (v, w) = (self.velocity, self.surface);
        [v.x * self.sin - v.z * self.cos + w.y, v.y + w.z * self.cos - w.x * self.sin]
    }

    /// The motion after the normal impulse `normal` of the nose and the friction `across`, along
    /// the two directions of [`Self::slip`]. The slate takes the downward part.
    fn after(&self, normal: f64, across: [f64; 2]) -> Rebound {
        let (s, c) = (self.sin, self.cos);
        let [p, q] = across;
        let push = Vec3::new(-normal * c + p * s, q, -normal * s - p * c);
        // The lever is R(cos θ, 0, sin θ), the inertia ⅖R².
        let turn = Vec3::new(c, 0.0, s).cross(push) * 2.5;
        let velocity = self.velocity + push;
        let velocity = Vec3::new(velocity.x.min(0.0), velocity.y, velocity.z.max(0.0));
        Rebound { velocity, surface: self.surface + turn, accuracy: 0.0 }
    }

    /// The mirror reflection.
    fn mirrored(&self) -> Rebound {
        let v = self.velocity;
        let velocity = Vec3::new(-v.x, v.y, v.z);
        Rebound { velocity, surface: self.surface, accuracy: 0.0 }
    }

    /// Restitution and friction of `law` at this speed and angle.
    pub(crate) fn coefficients(&self, law: &Cushion) -> (f64, f64) {
        let v = self.velocity;
        let e = law.restitution.a + law.restitution.b * v.x + law.restitution.c * v.x * v.x;
        let incidence = atan2(v.y.abs(), v.x);
        let mu = law.friction.a + law.friction.b * incidence;
        (e.max(law.restitution.lowest).min(law.restitution.highest), mu.max(0.0))
    }

    /// The motion after the impact by `law`.
    pub(crate) fn rebound(&self, law: &Cushion, cloth: &Cloth) -> Rebound {
        let (e, mu) = self.coefficients(law);
        let approach = self.velocity.x;
        if approach <= REFLECTS {
            return self.mirrored();
        }
        let full = match law.model {
            CushionModel::Restitution => {
                let v = self.velocity;
                let velocity = Vec3::new(-e * v.x, v.y, v.z);
                Rebound { velocity, surface: self.surface, accuracy: 0.0 }
            }
            CushionModel::Factors => {
                let v = self.velocity;
                let velocity = Vec3::new(-e * v.x, law.tangential_factor * v.y, v.z);
                Rebound { velocity, surface: self.surface * law.spin_factor, accuracy: 0.0 }
            }
            CushionModel::Han2005 => han::rebound(self, e, mu),
            CushionModel::Stronge => stronge::rebound(self, e, mu, law.frequency_ratio),
            CushionModel::Mathavan2010 => mathavan::rebound(self, e, mu, cloth.sliding_friction),
        };
        let reflected = ((FULL - approach) / (FULL - REFLECTS)).max(0.0);
        let mirror = self.mirrored();
        let mixed = |a: Vec3, b: Vec3| a * (1.0 - reflected) + b * reflected;
        Rebound {
            velocity: mixed(full.velocity, mirror.velocity),
            surface: mixed(full.surface, mirror.surface),
            accuracy: full.accuracy,
        }
    }
}

/// Length of a vector in the plane of contact.
fn size([p, q]: [f64; 2]) -> f64 {
    sqrt(p * p + q * q)
}
