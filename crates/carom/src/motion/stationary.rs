//! At rest: on the cloth, in a pocket, or off the table.

use super::Path;
use crate::MotionState;
use crate::math::{Vec2, Vec3};

pub(super) fn path(position: Vec3, radius: f64, motion: MotionState) -> Path {
    Path {
        position,
        velocity: Vec3::ZERO,
        half_acceleration: Vec3::ZERO,
        angular_velocity: Vec3::ZERO,
        angular_acceleration: Vec2::ZERO,
        spin_deceleration: 0.0,
        motion,
        duration: f64::INFINITY,
        radius,
    }
}
