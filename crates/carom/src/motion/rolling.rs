//! Rolling without slip: straight, braked by rolling resistance (Leckie & Greenspan 2006, eq. 4).
//!
//! Where the resistance depends on speed, it is constant in bands of speed. A path lasts until the
//! ball has the speed at which its band ends; there the ball begins the path of the next band.

use super::{Path, decayed};
use crate::math::{Vec2, Vec3};
use crate::physics::Cloth;
use crate::{BallState, MotionState};

/// a = −μ_r g v̂, for (v − v_end)/(μ_r g) seconds; v_end is the speed at which the band of μ_r ends,
/// 0 in the lowest one.
#[inline(always)]
pub(super) fn path(state: &BallState, radius: f64, cloth: &Cloth, gravity: f64) -> Path {
    let velocity = Vec3::new(state.velocity.x, state.velocity.y, 0.0);
    let speed = velocity.xy().length();
    let (friction, end_speed) = cloth.rolling_friction.band(speed);
    let deceleration = friction * gravity;
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
        duration: if speed > 0.0 { (speed - end_speed) / deceleration } else { 0.0 },
        radius,
    }
}

/// Spin of a ball that rolls at `velocity`: ω = ẑ×v/R, with the given ω_z.
#[inline(always)]
pub(super) fn spin(velocity: Vec3, radius: f64, about_vertical: f64) -> Vec3 {
    Vec3::new(-velocity.y / radius, velocity.x / radius, about_vertical)
}

/// At the end of the lowest band the ball is at rest, or spins if it still has sidespin.
pub(super) fn successor(path: &Path) -> BallState {
    let spin = decayed(path.angular_velocity.z, path.spin_deceleration, path.duration);
    BallState {
        position: path.position_at(path.duration),
        velocity: Vec3::ZERO,
        angular_velocity: Vec3::new(0.0, 0.0, spin),
        motion: if spin == 0.0 { MotionState::Stationary } else { MotionState::Spinning },
    }
}

/// At the end of another band the ball rolls on, at exactly the speed of the end, so that its next
/// path is in the next band.
#[cold]
pub(super) fn band_end(path: &Path, cloth: &Cloth) -> Option<BallState> {
    let speed = path.velocity.length();
    let (_, end_speed) = cloth.rolling_friction.band(speed);
    if end_speed == 0.0 {
        return None;
    }
    let velocity = path.velocity * (end_speed / speed);
    let about_vertical = decayed(path.angular_velocity.z, path.spin_deceleration, path.duration);
    Some(BallState {
        position: path.position_at(path.duration),
        velocity,
        angular_velocity: spin(velocity, path.radius, about_vertical),
        motion: MotionState::Rolling,
    })
}
