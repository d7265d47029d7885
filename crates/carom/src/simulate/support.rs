//! What supports a ball, and the state of a supported ball after an impact.

use crate::math::Vec3;
use crate::motion::classify;
use crate::physics::Surface;
use crate::resolve::{Body, ball_slate};
use crate::{Ball, BallState, MotionState, Physics};

/// What supports a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Support {
    /// The slate, or a rail's top.
    Plane,
    /// Nothing: the ball flies or turns about an edge.
    Air,
}

impl Support {
    /// What supports a ball in `state`.
    #[inline(always)]
    pub(super) fn under(state: &BallState) -> Self {
        if state.motion == MotionState::Airborne { Self::Air } else { Self::Plane }
    }

    /// The state right after an impact that gave the ball these velocities: the same position, and
    /// the motion state that follows from the velocities. On a plane a vertical velocity too small
    /// for a hop becomes 0 ([`ball_slate::settle`]).
    #[inline(always)]
    pub(super) fn settled(
        self,
        before: &BallState,
        velocity: Vec3,
        spin: Vec3,
        ball: &Ball,
        physics: &Physics,
    ) -> BallState {
        if self == Self::Plane && velocity.z == 0.0 {
            return on_plane(before.position, velocity, spin, ball.radius);
        }
        self.settled_from_hop(before, velocity, spin, ball, physics)
    }

    fn settled_from_hop(
        self,
        before: &BallState,
        velocity: Vec3,
        angular_velocity: Vec3,
        ball: &Ball,
        physics: &Physics,
    ) -> BallState {
        let position = before.position;
        let mut body = Body { velocity, angular_velocity, mass: ball.mass, radius: ball.radius };
        if self == Self::Plane {
            let law: &Surface = &physics.slate;
            ball_slate::settle(law, physics.gravity, &mut body);
            if body.velocity.z == 0.0 {
                return on_plane(position, body.velocity, body.angular_velocity, ball.radius);
            }
        }
        let Body { velocity, angular_velocity, .. } = body;
        BallState { position, velocity, angular_velocity, motion: MotionState::Airborne }
    }
}

/// The state of a ball on a plane, with the motion state that follows from its velocities.
#[inline(always)]
pub(super) fn on_plane(position: Vec3, velocity: Vec3, spin: Vec3, radius: f64) -> BallState {
    let motion = classify(velocity, spin, radius);
    let state = BallState { position, velocity, angular_velocity: spin, motion };
    match motion {
        MotionState::Spinning => BallState {
            velocity: Vec3::ZERO,
            angular_velocity: Vec3::new(0.0, 0.0, spin.z),
            ..state
        },
        MotionState::Stationary => {
            BallState { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, ..state }
        }
        _ => state,
    }
}
