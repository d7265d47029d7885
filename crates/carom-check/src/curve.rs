//! The motion of a ball between two events, integrated from its equation of motion independently of
//! the engine.

use carom::math::{Vec2, Vec3};
use carom::shot::Shot;
use carom::{BallState, MotionState};

use crate::rolling;

/// The path p + v t + h t² of a ball's centre, and the ball's radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curve {
    pub(crate) p: Vec3,
    pub(crate) v: Vec3,
    pub(crate) h: Vec3,
    pub(crate) radius: f64,
}

impl Curve {
    /// The path from `state`, by m dv/dt = F.
    pub(crate) fn new(shot: &Shot, i: usize, state: &BallState) -> Self {
        let radius = shot.balls()[i].ball.radius;
        let (cloth, g) = (shot.physics().cloth, shot.physics().gravity);
        let (v, w) = (state.velocity, state.angular_velocity);
        let against = |u: Vec2, mu: f64| {
            let size = u.length();
            if size == 0.0 { Vec3::ZERO } else { (u * (-0.5 * mu * g / size)).with_z(0.0) }
        };
        let level = v.xy().with_z(0.0);
        let (v, h) = match state.motion {
            MotionState::Airborne => (v, Vec3::new(0.0, 0.0, -0.5 * g)),
            MotionState::Sliding => {
                let slip = Vec2::new(v.x - radius * w.y, v.y + radius * w.x);
                (level, against(slip, cloth.sliding_friction))
            }
            MotionState::Rolling => {
                (level, against(v.xy(), rolling::band(&cloth, v.xy().length()).0))
            }
            _ => (level, Vec3::ZERO),
        };
        Self { p: state.position, v, h, radius }
    }

    /// Centre after `t` seconds.
    pub(crate) fn place(&self, t: f64) -> Vec3 {
        self.p + self.v * t + self.h * (t * t)
    }

    /// Velocity after `t` seconds.
    pub(crate) fn velocity(&self, t: f64) -> Vec3 {
        self.v + self.h * (2.0 * t)
    }

    /// The same path with its clock set to 0 at `t`.
    pub(crate) fn from(&self, t: f64) -> Self {
        Self { p: self.place(t), v: self.velocity(t), ..*self }
    }

    /// Upper bound of the centre's displacement in `length` seconds, m.
    pub(crate) fn travel(&self, length: f64) -> f64 {
        length * (self.v.length() + length * self.h.length())
    }

    /// Smallest height of the centre in `length` seconds, m. On a straight line, or a parabola that
    /// opens downwards, it is at one of the ends.
    pub(crate) fn lowest(&self, length: f64) -> f64 {
        debug_assert!(self.h.z <= 0.0);
        self.p.z.min(self.place(length).z)
    }

    pub(crate) fn moves(&self) -> bool {
        self.v != Vec3::ZERO || self.h != Vec3::ZERO
    }
}

/// The rotation of a ball between two events.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turning {
    state: BallState,
    radius: f64,
    /// Angular acceleration about the horizontal axes, rad/s².
    gains: Vec3,
    /// Deceleration about the vertical, rad/s².
    decay: f64,
}

impl Turning {
    /// The rotation from `state`, by I dω/dt = T.
    pub(crate) fn new(shot: &Shot, i: usize, state: &BallState) -> Self {
        let radius = shot.balls()[i].ball.radius;
        let (cloth, g) = (shot.physics().cloth, shot.physics().gravity);
        let (v, w) = (state.velocity, state.angular_velocity);
        let mut gains = Vec3::ZERO;
        if state.motion == MotionState::Sliding {
            let slip = Vec2::new(v.x - radius * w.y, v.y + radius * w.x);
            let force = slip * (-cloth.sliding_friction * g / slip.length());
            // The lever is −Rẑ, the inertia ⅖R² per unit of mass.
            gains =
                Vec3::new(0.0, 0.0, -radius).cross(force.with_z(0.0)) * (2.5 / (radius * radius));
        }
        let decay = match state.motion {
            MotionState::Sliding | MotionState::Rolling | MotionState::Spinning => {
                cloth.spin_deceleration
            }
            _ => 0.0,
        };
        Self { state: *state, radius, gains, decay }
    }

    /// Spin after `t` seconds, when the velocity is `v`.
    pub(crate) fn at(&self, t: f64, v: Vec3) -> Vec3 {
        let w = self.state.angular_velocity + self.gains * t;
        let z = w.z.signum() * (w.z.abs() - self.decay * t).max(0.0);
        if self.state.motion == MotionState::Rolling {
            Vec3::new(-v.y / self.radius, v.x / self.radius, z)
        } else {
            Vec3::new(w.x, w.y, z)
        }
    }
}
