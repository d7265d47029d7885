//! What happens when a ball and something else meet? `resolve/<a>_<b>/<model_year>.rs`.

pub mod ball_ball;
pub mod ball_cushion;
pub mod ball_edge;
pub mod ball_slate;
pub mod cue_ball;
pub mod restitution;
pub mod stronge;

use crate::math::Vec3;

/// Torque factor of a homogeneous ball: mR²/I.
pub(crate) const SPIN_PER_IMPULSE: f64 = 2.5;

/// A ball in an impact: what it is and how it moves. Resolvers change the two velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Velocity of the centre, m/s.
    pub velocity: Vec3,
    /// Spin vector, rad/s.
    pub angular_velocity: Vec3,
    /// Mass, kg.
    pub mass: f64,
    /// Radius, m.
    pub radius: f64,
}
