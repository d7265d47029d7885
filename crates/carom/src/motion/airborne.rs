//! Free flight: the centre moves on a parabola and the spin is constant. Drag and Magnus force are
//! neglected; they are below 1 % of gravity at the speeds of billiards.

use super::Path;
use crate::math::{Vec2, Vec3};
use crate::{BallState, MotionState};

/// r(t) = r₀ + v₀t − ½gt²ẑ, without end.
#[inline(always)]
pub(super) fn path(state: &BallState, radius: f64, gravity: f64) -> Path {
    Path {
        position: state.position,
        velocity: state.velocity,
        half_acceleration: Vec3::new(0.0, 0.0, -0.5 * gravity),
        angular_velocity: state.angular_velocity,
        angular_acceleration: Vec2::ZERO,
        spin_deceleration: 0.0,
        motion: MotionState::Airborne,
        duration: f64::INFINITY,
        radius,
    }
}
