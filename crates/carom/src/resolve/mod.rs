//! Impacts: the velocities after the contact of a ball with something else. One file per pair and
//! model: `resolve/<a>_<b>/<model_year>.rs`.

pub mod ball_ball;
pub mod ball_cushion;
pub mod ball_edge;
pub mod ball_slate;
pub mod cue_ball;
pub mod network;
pub mod restitution;
pub mod stronge;

use crate::math::Vec3;
use crate::{Ball, BallState};

/// Torque factor of a homogeneous ball: mR²/I.
pub(crate) const SPIN_PER_IMPULSE: f64 = 2.5;

/// A ball in an impact: its properties and its velocities. Resolvers change the two velocities.
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

impl Body {
    /// `ball`, moving as in `state`.
    #[inline]
    pub fn new(ball: &Ball, state: &BallState) -> Self {
        Self {
            velocity: state.velocity,
            angular_velocity: state.angular_velocity,
            mass: ball.mass,
            radius: ball.radius,
        }
    }
}
