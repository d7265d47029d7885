//! States of balls.

use carom::BallState;

/// The state of a ball at one instant.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_state {
    /// Centre, m: x along the table's width, y along its length, z up from the slate.
    pub position: [f64; 3],
    /// m/s
    pub velocity: [f64; 3],
    /// Spin, rad/s.
    pub angular_velocity: [f64; 3],
    /// Rotation since the start of the shot: a unit quaternion x, y, z, w.
    pub orientation: [f64; 4],
    /// CAROM_STATIONARY to CAROM_OFF_TABLE.
    pub motion: i32,
}

/// A ball just before or just after an event.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_motion {
    /// Centre, m.
    pub position: [f64; 3],
    /// m/s
    pub velocity: [f64; 3],
    /// Spin, rad/s.
    pub angular_velocity: [f64; 3],
    /// CAROM_STATIONARY to CAROM_OFF_TABLE.
    pub motion: i32,
}

impl carom_state {
    pub(crate) fn new(state: &BallState, orientation: [f64; 4]) -> Self {
        let carom_motion { position, velocity, angular_velocity, motion } = state.into();
        Self { position, velocity, angular_velocity, orientation, motion }
    }
}

impl From<&BallState> for carom_motion {
    fn from(state: &BallState) -> Self {
        Self {
            position: state.position.to_array(),
            velocity: state.velocity.to_array(),
            angular_velocity: state.angular_velocity.to_array(),
            motion: state.motion as i32,
        }
    }
}
