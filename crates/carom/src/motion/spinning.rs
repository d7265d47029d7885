//! Spinning about the vertical without moving, until friction of the cloth ends it.

use super::{Path, stationary};
use crate::math::Vec3;
use crate::physics::Cloth;
use crate::{BallState, MotionState};

pub(super) fn path(state: &BallState, radius: f64, cloth: &Cloth) -> Path {
    let spin = state.angular_velocity.z;
    Path {
        angular_velocity: Vec3::new(0.0, 0.0, spin),
        spin_deceleration: cloth.spin_deceleration,
        duration: spin.abs() / cloth.spin_deceleration,
        ..stationary::path(state.position, radius, MotionState::Spinning)
    }
}
