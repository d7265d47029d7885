//! Balls: their properties, and their state at one instant.

use crate::math::{Vec2, Vec3};
use crate::range::Range;

/// The masses that a ball or a cue may have.
pub(crate) const MASS: Range = Range::positive(" kg");
/// The radii that a ball may have.
pub(crate) const RADIUS: Range = Range::positive(" m");

/// A solid, homogeneous ball. Its moment of inertia is ⅖mR².
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ball {
    /// Mass, kg.
    pub mass: f64,
    /// Radius, m.
    pub radius: f64,
}

/// How a ball moves between events (Leckie & Greenspan 2005). The module [`motion`](crate::motion)
/// has the path of each state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum MotionState {
    /// At rest on the cloth.
    #[default]
    Stationary,
    /// Spinning about the vertical without moving.
    Spinning,
    /// Rolling without slip on the cloth.
    Rolling,
    /// Sliding on the cloth.
    Sliding,
    /// Free flight.
    Airborne,
    /// In a pocket.
    Pocketed,
    /// Off the table.
    OffTable,
}

impl MotionState {
    /// Every state, in order of its number.
    pub const ALL: [Self; 7] = [
        Self::Stationary,
        Self::Spinning,
        Self::Rolling,
        Self::Sliding,
        Self::Airborne,
        Self::Pocketed,
        Self::OffTable,
    ];

    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stationary => "stationary",
            Self::Spinning => "spinning",
            Self::Rolling => "rolling",
            Self::Sliding => "sliding",
            Self::Airborne => "airborne",
            Self::Pocketed => "pocketed",
            Self::OffTable => "off-table",
        }
    }

    /// Whether nothing but an impact moves the ball: it lies still, or is out of play.
    pub const fn is_at_rest(self) -> bool {
        matches!(self, Self::Stationary | Self::Pocketed | Self::OffTable)
    }

    /// Whether the ball still takes part in the shot.
    pub const fn in_play(self) -> bool {
        !matches!(self, Self::Pocketed | Self::OffTable)
    }
}

/// A ball's complete state at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct BallState {
    /// Centre, m.
    pub position: Vec3,
    /// Velocity of the centre, m/s.
    pub velocity: Vec3,
    /// Spin vector, rad/s.
    pub angular_velocity: Vec3,
    /// Motion state.
    pub motion: MotionState,
}

impl Ball {
    /// Kinetic energy, J: ½mv² + ½·⅖mR²ω².
    pub fn kinetic_energy(&self, s: &BallState) -> f64 {
        0.5 * self.mass * s.velocity.length_squared()
            + 0.2 * self.mass * self.radius * self.radius * s.angular_velocity.length_squared()
    }
}

/// Slip velocity at the cloth contact, u = v + Rẑ×ω (Leckie & Greenspan 2005), m/s.
#[inline(always)]
pub fn cloth_slip(velocity: Vec3, angular_velocity: Vec3, radius: f64) -> Vec2 {
    Vec2::new(velocity.x - radius * angular_velocity.y, velocity.y + radius * angular_velocity.x)
}
