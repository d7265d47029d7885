//! Closed-form paths between events (Leckie & Greenspan 2005; 2006, eqs. 1–4).
//!
//! Within one motion state a ball's centre moves on r(t) = r₀ + v₀t + ht², where h is half its
//! constant acceleration, and its spin is linear in time. Each motion state has a file with its
//! path, its duration and the state that follows.

mod airborne;
mod rolling;
mod sliding;
mod spinning;
mod stationary;

use crate::ball::cloth_slip;
use crate::math::{Vec2, Vec3};
use crate::physics::Cloth;
use crate::{Ball, BallState, MotionState};

/// A slip below this fraction of the ball's surface speeds counts as rounding error: for a rolling
/// ball v and Rω cancel to about 1e-16 of either. With 1e-12 a wrong decision changes a velocity by
/// less than 1e-12 of itself. Much smaller, and rolling balls would be classified as sliding; much
/// larger, and real slip would be ignored.
const SLIP_ROUNDING: f64 = 1e-12;

/// A speed below this, m/s, counts as 0. A slide from this speed would last 1e-14 s, less than the
/// rounding error of the time late in a long shot, so events would repeat at one instant for ever.
/// At this speed a ball takes an hour to move by the width of an atom.
const STILL: f64 = 1e-13;

/// The motion of a ball from now until its motion state ends, in closed form. Times are relative to
/// the start of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Centre at the start, m.
    pub position: Vec3,
    /// Velocity at the start, m/s.
    pub velocity: Vec3,
    /// Half the acceleration, m/s².
    pub half_acceleration: Vec3,
    /// Spin at the start, rad/s.
    pub angular_velocity: Vec3,
    /// Rate of change of the horizontal spin, rad/s².
    pub angular_acceleration: Vec2,
    /// Deceleration of the spin about the vertical, rad/s².
    pub spin_deceleration: f64,
    /// Motion state.
    pub motion: MotionState,
    /// Duration of the path, s; infinite if it does not end by itself.
    pub duration: f64,
    /// The ball's radius, m.
    pub radius: f64,
}

impl Default for Path {
    fn default() -> Self {
        stationary::path(Vec3::ZERO, 0.0, MotionState::Stationary)
    }
}

impl Path {
    /// The path of a ball from `state`. Its motion state must agree with its velocities (see
    /// [`classify`]). `gravity` in m/s².
    // Not inlined, the path would be returned in memory and copied: 80 instructions per event.
    #[inline(always)]
    pub fn new(state: &BallState, ball: &Ball, cloth: &Cloth, gravity: f64) -> Self {
        match state.motion {
            MotionState::Sliding => sliding::path(state, ball.radius, cloth, gravity),
            MotionState::Rolling => rolling::path(state, ball.radius, cloth, gravity),
            MotionState::Spinning => spinning::path(state, ball.radius, cloth),
            MotionState::Airborne => airborne::path(state, ball.radius, gravity),
            _ => stationary::path(state.position, ball.radius, state.motion),
        }
    }

    /// The ball's state `t` seconds after the path's start, 0 ≤ t ≤ duration; exact to rounding.
    #[inline]
    pub fn at(&self, t: f64) -> BallState {
        let velocity = self.velocity_at(t);
        BallState {
            position: self.position_at(t),
            velocity,
            angular_velocity: self.angular_velocity_at(t, velocity),
            motion: self.motion,
        }
    }

    /// Centre `t` seconds after the path's start, m.
    #[inline(always)]
    pub fn position_at(&self, t: f64) -> Vec3 {
        self.position + (self.velocity + self.half_acceleration * t) * t
    }

    /// Velocity `t` seconds after the path's start, m/s.
    #[inline(always)]
    pub fn velocity_at(&self, t: f64) -> Vec3 {
        self.velocity + self.half_acceleration * (2.0 * t)
    }

    #[inline(always)]
    fn angular_velocity_at(&self, t: f64, velocity: Vec3) -> Vec3 {
        let spin = decayed(self.angular_velocity.z, self.spin_deceleration, t);
        if self.motion == MotionState::Rolling {
            rolling::spin(velocity, self.radius, spin)
        } else {
            Vec3::new(
                self.angular_velocity.x + self.angular_acceleration.x * t,
                self.angular_velocity.y + self.angular_acceleration.y * t,
                spin,
            )
        }
    }

    /// The state at the end of a rolling ball's path, if there only its band of rolling resistance
    /// ends and it rolls on; `cloth` is that of the path.
    #[inline(always)]
    pub fn band_end(&self, cloth: &Cloth) -> Option<BallState> {
        if self.motion == MotionState::Rolling && cloth.rolling_friction.as_constant().is_none() {
            rolling::band_end(self, cloth)
        } else {
            None
        }
    }

    /// The state at the end of this path, in which the next path starts, unless
    /// [`band_end`](Self::band_end) has one.
    #[inline(always)]
    pub fn successor(&self) -> BallState {
        match self.motion {
            MotionState::Sliding => sliding::successor(self),
            MotionState::Rolling => rolling::successor(self),
            _ => BallState {
                position: self.position,
                motion: MotionState::Stationary,
                ..BallState::default()
            },
        }
    }

    /// Whether the centre moves.
    #[inline(always)]
    pub fn moves(&self) -> bool {
        matches!(self.motion, MotionState::Sliding | MotionState::Rolling | MotionState::Airborne)
    }
}

/// Whether no friction stops a ball that moves on from `state` and meets nothing. A ball in the air
/// comes down.
pub fn never_rests(state: &BallState, ball: &Ball, cloth: &Cloth, gravity: f64) -> bool {
    let mut path = Path::new(state, ball, cloth, gravity);
    while path.motion != MotionState::Airborne && !path.motion.is_at_rest() {
        if path.duration == f64::INFINITY {
            return true;
        }
        let next = path.band_end(cloth).unwrap_or_else(|| path.successor());
        path = Path::new(&next, ball, cloth, gravity);
    }
    false
}

/// Spin about the vertical after `t` seconds of constant deceleration (Leckie & Greenspan 2005).
#[inline(always)]
fn decayed(spin: f64, deceleration: f64, t: f64) -> f64 {
    let left = spin.abs() - deceleration * t;
    if left > 0.0 { left.copysign(spin) } else { 0.0 }
}

/// The motion state on the cloth that follows from a ball's velocities.
#[inline]
pub fn classify(velocity: Vec3, angular_velocity: Vec3, radius: f64) -> MotionState {
    let slip = cloth_slip(velocity, angular_velocity, radius).length_squared();
    let speeds =
        velocity.length_squared() + radius * radius * angular_velocity.xy().length_squared();
    if slip > SLIP_ROUNDING * SLIP_ROUNDING * speeds && slip > STILL * STILL {
        MotionState::Sliding
    } else if velocity.xy().length_squared() > STILL * STILL {
        MotionState::Rolling
    } else if angular_velocity.z != 0.0 {
        MotionState::Spinning
    } else {
        MotionState::Stationary
    }
}
