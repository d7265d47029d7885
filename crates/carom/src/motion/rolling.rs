//! Rolling without slip: straight, braked by rolling resistance (Leckie & Greenspan 2006, eq. 4).

use super::{Path, decayed};
use crate::math::{Vec2, Vec3};
use crate::physics::Cloth;
use crate::{BallState, MotionState};

/// a = −μ_r g v̂, for v/(μ_r g) seconds.
#[inline(always)]
pub(super) fn path(state: &BallState, radius: f64, cloth: &Cloth, gravity: f64) -> Path {
    let velocity = Vec3::new(state.velocity.x, state.velocity.y, 0.0);
    let speed = velocity.xy().length();
    let deceleration = cloth.rolling_friction * gravity;
    let half_acceleration =
        if speed > 0.0 { velocity * (-0.5 * deceleration / speed) } else { Vec3::ZERO };
    Path {
        position: state.position,
        velocity,
        half_acceleration,
        angular_velocity: spin(velocity, radius, state.angular_velocity.z),
        angular_acceleration: Vec2::ZERO,
        spin_deceleration: cloth.spin_deceleration,
        motion: MotionState::Rolling,
        duration: if speed > 0.0 { speed / deceleration } else { 0.0 },
        radius,
    }
}

/// Spin of a ball that rolls at `velocity`: ω = ẑ×v/R, with the given ω_z.
#[inline(always)]
pub(super) fn spin(velocity: Vec3, radius: f64, about_vertical: f64) -> Vec3 {
    Vec3::new(-velocity.y / radius, velocity.x / radius, about_vertical)
}

/// At the end the ball is at rest, or spins if it still has sidespin.
pub(super) fn successor(path: &Path) -> BallState {
    let spin = decayed(path.angular_velocity.z, path.spin_deceleration, path.duration);
    BallState {
        position: path.position_at(path.duration),
        velocity: Vec3::ZERO,
        angular_velocity: Vec3::new(0.0, 0.0, spin),
        motion: if spin == 0.0 { MotionState::Stationary } else { MotionState::Spinning },
    }
}
