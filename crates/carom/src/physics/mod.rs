//! The parameters of the physical models: plain data, immutable during a shot.

pub mod ball_surface;
mod evidence;
pub mod presets;
pub(crate) mod quantities;
mod rolling_friction;
mod rolling_law;

pub use evidence::Evidence;
pub use rolling_friction::{MAX_ROLLING_BANDS, RollingBand, RollingFriction};
pub use rolling_law::{RollingLaw, RollingTolerance};

use crate::table::Part;

/// All physical parameters of a shot except the table's geometry and the single balls.
///
/// It has no pointers, and every compiler lays it out in the same way, so that its bytes can be copied
/// to a device (docs/gpu.md).
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
pub struct Physics {
    /// Gravitational acceleration, m/s².
    pub gravity: f64,
    /// Mass and radius of a ball for which a shot file gives none.
    pub ball: crate::Ball,
    /// Ball on cloth.
    pub cloth: Cloth,
    /// Ball against ball.
    pub ball_ball: BallBall,
    /// Ball against cushion.
    pub cushion: Cushion,
    /// Ball against the facings and points of a pocket's jaws: they replace the cushion's
    /// restitution and friction, in the cushion's model.
    pub facing: Surface,
    /// Ball against a pocket's liner, in the cushion's model.
    pub liner: Surface,
    /// A ball that bounces on the slate or on a rail's top.
    pub slate: Surface,
    /// The cue.
    pub cue: Cue,
    /// How long contacts last that take part in a network.
    pub contact_times: ContactTimes,
}

impl Physics {
    /// The parameters for a `part` of a cushion. Facings, points and liners have their own surfaces
    /// in the cushion's model, and so has a rail's top where a ball collides with it as a cushion.
    pub fn cushion_of(&self, part: Part) -> Cushion {
        match part {
            Part::Nose => self.cushion,
            Part::Facing | Part::Point => self.cushion.with(&self.facing),
            Part::Liner => self.cushion.with(&self.liner),
            Part::Top => self.cushion.with(&self.slate),
        }
    }
}

/// Friction between ball and cloth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Cloth {
    /// Coefficient of sliding friction μ_s.
    pub sliding_friction: f64,
    /// Coefficient of rolling resistance μ_r.
    pub rolling_friction: RollingFriction,
    /// Deceleration of the spin about the vertical, rad/s².
    pub spin_deceleration: f64,
}

/// An enum of published models with their names in shot files.
macro_rules! models {
    (
        $(#[$about:meta])*
        pub enum $models:ident { $($(#[$doc:meta])* $model:ident = $name:literal,)+ }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub enum $models { $($(#[$doc])* $model,)+ }

        impl $models {
            /// All models, with their names in shot files.
            pub const NAMED: &[(&str, Self)] = &[$(($name, Self::$model)),+];

            /// All models.
            pub const ALL: [Self; Self::NAMED.len()] = [$(Self::$model),+];

            /// The model's name in shot files.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$model => $name),+ }
            }
        }
    };
}

models! {
    /// Which published model resolves a collision of two balls.
    pub enum BallBallModel {
        /// Impulse along the line of centres with restitution, no friction. In a shot file this model
        /// has the restitution 1 unless the file gives another.
        Elastic = "elastic",
        /// Impulse with restitution and Coulomb friction, rigid in the tangent plane.
        Frictional = "frictional",
        /// Mathavan, Jackson & Parkin 2014: impulse integrated, with cloth friction.
        Mathavan2014 = "mathavan-2014",
        /// Stronge's tangentially compliant contact, with realistic throw.
        Compliant = "compliant",
    }
}

/// What the law of a model has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairLawTraits {
    /// Friction between the balls.
    pub friction: bool,
    /// A spring in the tangent plane: `frequency_ratio` says how stiff it is.
    pub spring: bool,
    /// Friction of the cloth during the impact of two balls that are on it.
    pub cloth: bool,
}

impl BallBallModel {
    /// What the law has. Contacts of several balls and the checks follow it.
    pub const fn traits(self) -> PairLawTraits {
        let (friction, spring, cloth) = match self {
            Self::Elastic => (false, false, false),
            Self::Frictional => (true, false, false),
            Self::Mathavan2014 => (true, false, true),
            Self::Compliant => (true, true, false),
        };
        PairLawTraits { friction, spring, cloth }
    }
}

/// Friction coefficient as a function of the slip speed: μ(s) = a + b·exp(−c·s).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct SlipFriction {
    /// Limit at high slip speed.
    pub a: f64,
    /// Addition at slip speed 0.
    pub b: f64,
    /// Decay with slip speed, s/m.
    pub c: f64,
}

impl SlipFriction {
    /// A coefficient that does not depend on speed.
    pub const fn constant(mu: f64) -> Self {
        Self { a: mu, b: 0.0, c: 0.0 }
    }
    /// μ at slip speed `s` (m/s).
    #[inline]
    pub fn at(&self, s: f64) -> f64 {
        if self.b == 0.0 { self.a } else { self.a + self.b * crate::math::exp(-self.c * s) }
    }
}

/// Ball against ball.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct BallBall {
    /// Model.
    pub model: BallBallModel,
    /// Coefficient of normal restitution, 0 to 1; it rises to 1 for approaches slower than
    /// [`FULL`](crate::resolve::restitution::FULL).
    pub restitution: f64,
    /// Friction between the balls, at the slip speed with which they meet.
    pub friction: SlipFriction,
    /// ω_t/ω_n of the `compliant` model, 1 to 2: √(7(1 − ν)/(2 − ν)) for Poisson's ratio ν.
    pub frequency_ratio: f64,
}

impl BallBall {
    /// Whether no friction acts between balls.
    pub fn is_smooth(&self) -> bool {
        !self.model.traits().friction || (self.friction.a == 0.0 && self.friction.b == 0.0)
    }
}

models! {
    /// Which published model resolves a collision with a cushion.
    pub enum CushionModel {
        /// Normal velocity × −e; nothing else changes.
        Restitution = "restitution",
        /// Han 2005.
        Han2005 = "han-2005",
        /// Mathavan, Jackson & Parkin 2010.
        Mathavan2010 = "mathavan-2010",
        /// Stronge's compliant contact.
        Stronge = "stronge",
        /// Constant factors on the velocity's two parts and on the spin, as in FastFiz.
        Factors = "factors",
    }
}

/// Restitution of the cushion as a function of the normal speed V before the impact: e = a + bV +
/// cV², limited to `lowest..=highest`. Han 2005 gives his measurements in this form; here every
/// model can have it. A constant is `a` alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CushionRestitution {
    /// Constant part.
    pub a: f64,
    /// Per m/s of normal speed.
    pub b: f64,
    /// Per (m/s)² of normal speed.
    pub c: f64,
    /// Lower limit, from 0 to `highest`. A polynomial falls below any value at high speed, so a fit
    /// needs it for speeds that were not measured.
    pub lowest: f64,
    /// Upper limit, from `lowest` to 1.
    pub highest: f64,
}

impl CushionRestitution {
    /// A restitution that does not depend on speed, 0 to 1.
    pub const fn constant(e: f64) -> Self {
        Self::polynomial(e, 0.0, 0.0)
    }

    /// e = `a` + `b`V + `c`V² at the normal speed V (m/s), limited to 0..=1.
    pub const fn polynomial(a: f64, b: f64, c: f64) -> Self {
        Self { a, b, c, lowest: 0.0, highest: 1.0 }
    }

    /// Whether it is the same at every speed, with the limits 0 and 1.
    pub fn is_constant(&self) -> bool {
        *self == Self::constant(self.a)
    }
}

/// Friction of the cushion as a function of the incidence γ from the normal, rad: μ = a + bγ, at
/// least 0. Han 2005 gives his measurements in this form; here every model with friction can have
/// it. A constant is `a` alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CushionFriction {
    /// Constant part.
    pub a: f64,
    /// Per radian of incidence.
    pub b: f64,
}

/// Ball against cushion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Cushion {
    /// Model.
    pub model: CushionModel,
    /// Restitution.
    pub restitution: CushionRestitution,
    /// Friction.
    pub friction: CushionFriction,
    /// ω_t/ω_n of the `stronge` model, 1 to 2.
    pub frequency_ratio: f64,
    /// Share of the speed along the rail that the `factors` model keeps, 0 to 1.
    pub tangential_factor: f64,
    /// Share of the spin that the `factors` model keeps, 0 to 1.
    pub spin_factor: f64,
}

impl Cushion {
    /// The same model with the restitution and friction of `surface`.
    fn with(&self, surface: &Surface) -> Self {
        Self {
            restitution: CushionRestitution::constant(surface.restitution),
            friction: CushionFriction { a: surface.friction, b: 0.0 },
            ..*self
        }
    }
}

/// The restitution and friction of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Surface {
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Coefficient of friction.
    pub friction: f64,
}

impl Surface {
    /// A surface with a restitution and a friction.
    pub const fn new(restitution: f64, friction: f64) -> Self {
        Self { restitution, friction }
    }
}

/// How much of the impact the tip returns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub enum Tip {
    /// Newton's coefficient of restitution.
    Restitution(f64),
    /// Energy efficiency η (TP A.30).
    Efficiency(f64),
}

models! {
    /// Which law gives the velocities of a struck ball.
    pub enum StrikeModel {
        /// The tip, the ball, the slate and all that touches the ball act at once
        /// ([`network`](crate::resolve::network)). A tip alone has the law of the model `Sequential`.
        Network = "network",
        /// First the tip alone (Leckie & Greenspan 2005), then the slate (TP B.10), then other balls.
        Sequential = "sequential",
    }
}

/// The cue.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Cue {
    /// Model of the strike.
    pub model: StrikeModel,
    /// Mass, kg.
    pub mass: f64,
    /// Mass of the shaft's end that takes part in squirt, kg; 0 for a cue without squirt.
    pub end_mass: f64,
    /// Radius of the tip's curvature, m. It does not change the strike, because tip offsets are
    /// offsets of the contact point. If the axis of a cue has the offset o from the ball's centre,
    /// the contact point has the offset o/(1 + tip_radius/R).
    pub tip_radius: f64,
    /// Friction between tip and ball. It sets the miscue limit μ/√(1 + μ²), in ball radii.
    pub tip_friction: f64,
    /// Restitution or efficiency of the tip.
    pub tip: Tip,
    /// c, by which the restitution e₀ of the tip falls off the centre: it is e₀/√(1 + c·tan²β) where
    /// the cue's axis meets the ball at the angle β from its surface's normal (sin β is the offset
    /// in ball radii). 0 for a restitution that does not fall. Without effect on
    /// [`Tip::Efficiency`].
    pub tip_off_centre_loss: f64,
    /// Least elevation of a real stroke, rad, in [0, π/2): the default elevation of a strike is at
    /// least this angle. With 0 the default elevation is always 0: the cue needs no room.
    pub stroke_elevation: f64,
}

/// How long contacts last at an approach of 1 m/s without losses, s. At the speed V they last
/// V^(−1/5) times as long (Hertz). The times matter only where several contacts act at once.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct ContactTimes {
    /// The tip of the cue on the ball.
    pub tip: f64,
    /// The ball on the slate.
    pub slate: f64,
}

#[cfg(test)]
mod tests {
    use super::{Physics, Surface};
    use crate::table::Part;

    #[test]
    fn every_part_of_a_cushion_acts_in_its_model_with_its_own_surface() {
        let physics = Physics {
            facing: Surface::new(0.61, 0.31),
            liner: Surface::new(0.42, 0.22),
            slate: Surface::new(0.53, 0.13),
            ..Physics::snooker()
        };
        assert_eq!(physics.cushion_of(Part::Nose), physics.cushion);
        for (part, surface) in [
            (Part::Facing, physics.facing),
            (Part::Point, physics.facing),
            (Part::Liner, physics.liner),
            (Part::Top, physics.slate),
        ] {
            let law = physics.cushion_of(part);
            assert_eq!(law.model, physics.cushion.model);
            assert_eq!(law.frequency_ratio, physics.cushion.frequency_ratio);
            for speed in [0.1, 3.0] {
                assert_eq!(law.restitution.at(speed), surface.restitution);
            }
            assert_eq!((law.friction.a, law.friction.b), (surface.friction, 0.0));
        }
    }
}
