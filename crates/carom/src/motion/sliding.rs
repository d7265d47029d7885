//! Sliding on the cloth (Leckie & Greenspan 2005; 2006, eqs. 1–3).

use super::{Path, decayed, rolling};
use crate::ball::cloth_slip;
use crate::math::{Vec2, Vec3};
use crate::physics::Cloth;
use crate::{BallState, MotionState};

/// A ball is at rest after a slide if its computed speed is then at most this fraction of the
/// initial slip speed, because that is a rounding error. The exact speed is 0 for Rω₀ = −2.5 v₀.
const DEAD_STOP: f64 = 1e-13;

/// Friction opposes the slip u = v + Rẑ×ω, whose direction û does not change:
/// a = −μ_s g û, dω/dt = (5μ_s g/2R) ẑ×û, for 2|u|/(7μ_s g) seconds.
#[inline(always)]
pub(super) fn path(state: &BallState, radius: f64, cloth: &Cloth, gravity: f64) -> Path {
    let velocity = Vec3::new(state.velocity.x, state.velocity.y, 0.0);
    let slip = cloth_slip(velocity, state.angular_velocity, radius);
    let speed = slip.length();
    let direction = slip * (1.0 / speed);
    let deceleration = cloth.sliding_friction * gravity;
    Path {
        position: state.position,
        velocity,
        half_acceleration: (direction * (-0.5 * deceleration)).with_z(0.0),
        angular_velocity: state.angular_velocity,
        angular_acceleration: direction.perp() * (2.5 * deceleration / radius),
        spin_deceleration: cloth.spin_deceleration,
        motion: MotionState::Sliding,
        duration: 2.0 * speed / (7.0 * deceleration),
        radius,
    }
}

/// At the end the ball rolls at v₀ − (2/7)u₀, whatever the friction, or is at rest if that is 0.
/// With sidespin left it rolls at speed 0 for 0 s, and then spins.
pub(super) fn successor(path: &Path) -> BallState {
    let slip = cloth_slip(path.velocity, path.angular_velocity, path.radius);
    let end = path.velocity.xy() - slip * (2.0 / 7.0);
    let spin = decayed(path.angular_velocity.z, path.spin_deceleration, path.duration);
    let stops = end.length_squared() <= DEAD_STOP * DEAD_STOP * slip.length_squared();
    let velocity = if stops { Vec2::ZERO } else { end }.with_z(0.0);
    BallState {
        position: path.position_at(path.duration),
        velocity,
        angular_velocity: rolling::spin(velocity, path.radius, spin),
        motion: if stops && spin == 0.0 { MotionState::Stationary } else { MotionState::Rolling },
    }
}
