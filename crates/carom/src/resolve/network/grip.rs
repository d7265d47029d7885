//! Friction at a contact during the impact.

use super::directions::Directions;
use super::spring::SpringState;
use super::{STILL, WallTouch, larger, smaller};
use crate::math::{Vec2, Vec3, sqrt};
use crate::physics::{BallBall, SlipFriction};
use crate::resolve::ball_ball::contact::TANGENT_COMPLIANCE;

/// μ is computed again when the slip has grown by this fraction of the fastest approach. Between,
/// it follows its tangent.
const SLIP_STEP: f64 = 1.0 / 64.0;

/// Friction at a contact.
#[derive(Clone, Copy, Default)]
pub(super) struct Grip {
    /// Whether there is friction.
    rubs: bool,
    /// (5/4)(2/7)(ω_t/ω_n)², 0 for a rigid contact.
    stiffness: f64,
    /// Whether μ depends on the slip.
    varies: bool,
    /// μ at the fastest slip so far, and the square of this slip.
    friction: f64,
    fastest: f64,
    /// A slip, μ and its slope there, and the slip up to which they serve.
    base: f64,
    base_friction: f64,
    slope: f64,
    known: f64,
    /// Friction on b, and the stiffness of its spring, in the last step with a force.
    pull: Vec2,
    tightness: f64,
    /// The slip in the last step, and what the friction and the other contacts changed of it.
    slip: Vec2,
    own: Vec2,
    others: Vec2,
}

/// One step of a contact that carries a force.
pub(super) struct GripStep<'a> {
    pub(super) directions: Directions,
    /// Velocity of a's centre relative to b's, and the sum of both Rω.
    pub(super) velocity: Vec3,
    pub(super) surface: Vec3,
    /// The impulse along the normal.
    pub(super) normal: f64,
    /// The spring along the normal.
    pub(super) spring: SpringState,
    /// Whether the contact carried a force in the last step as well.
    pub(super) steady: bool,
    /// Length of the step.
    pub(super) time: f64,
    /// The friction of the balls, and m/s per unit of speed.
    pub(super) law: &'a SlipFriction,
    pub(super) speed_unit: f64,
}

impl Grip {
    /// Friction between balls.
    pub(super) fn of_balls(law: &BallBall) -> Self {
        let sprung = law.model.traits().spring;
        Self {
            rubs: !law.is_smooth(),
            stiffness: grip_stiffness(sprung.then_some(law.frequency_ratio)),
            varies: law.friction.b != 0.0,
            friction: law.friction.at(0.0),
            known: -1.0,
            ..Self::default()
        }
    }

    /// Friction on a wall.
    pub(super) fn of_wall(wall: &WallTouch) -> Self {
        Self {
            rubs: wall.friction > 0.0,
            stiffness: grip_stiffness(wall.frequency_ratio),
            friction: wall.friction,
            ..Self::default()
        }
    }

    /// The impulse of one step on b, and Σ n × this impulse.
    #[inline(always)]
    pub(super) fn impulse(&mut self, step: &GripStep<'_>) -> (Vec3, Vec3) {
        let directions = &step.directions;
        let along = directions.normal * step.normal;
        if !self.rubs {
            return (along, Vec3::ZERO);
        }
        let slip = directions.slip(step.velocity, step.surface);
        let friction = self.friction_impulse(slip, step);
        let push = along + directions.vector(friction.x, friction.y);
        (push, directions.vector(-friction.y, friction.x))
    }

    /// The friction impulse of one step on b. `slip` is that of a's surface over b's.
    #[inline(always)]
    fn friction_impulse(&mut self, slip: Vec2, step: &GripStep<'_>) -> Vec2 {
        // The slip in the middle of the step.
        let change = if step.steady { slip - self.slip } else { Vec2::ZERO };
        let square = (slip + change * 0.5).length_squared();
        if square > self.fastest {
            self.fastest = square;
            self.follow(step.law, step.speed_unit);
        }
        let most = self.friction * step.normal;
        if self.stiffness > 0.0 {
            self.spring(slip, step, most)
        } else {
            self.rigid(slip, step, most)
        }
    }

    /// Computes μ at a new fastest slip.
    fn follow(&mut self, law: &SlipFriction, speed: f64) {
        if !self.varies {
            return;
        }
        let slip = sqrt(self.fastest);
        if slip > self.known {
            self.base = slip;
            self.base_friction = law.at(slip * speed);
            self.slope = -law.c * speed * (self.base_friction - law.a);
            self.known = slip + SLIP_STEP;
        }
        self.friction = self.base_friction + self.slope * (slip - self.base);
    }

    /// Friction that stops the slip, of at most the impulse `most`.
    #[inline(always)]
    fn rigid(&mut self, slip: Vec2, step: &GripStep<'_>, most: f64) -> Vec2 {
        // This impulse per slip would stop it, if the contact were alone.
        let stop = step.spring.mass / TANGENT_COMPLIANCE;
        // What the other contacts change of the slip, in the last step and in this one.
        let (last, others) = if step.steady {
            let last = slip - self.slip + self.own;
            (last, last * 2.0 - self.others)
        } else {
            (Vec2::ZERO, Vec2::ZERO)
        };
        let mut impulse = (slip + others) * stop;
        if impulse.length_squared() > most * most {
            // The surfaces slide: friction acts against the slip in the middle of the step. Its own
            // half of the change does not turn this slip.
            let middle = slip + others * 0.5;
            let speed = middle.length();
            let unit = if speed > 0.0 { middle * (1.0 / speed) } else { Vec2::ZERO };
            impulse = unit * smaller(most, 2.0 * stop * speed);
        }
        (self.slip, self.others) = (slip, last);
        self.own = impulse * (1.0 / stop);
        impulse
    }

    /// Friction of a spring, of at most the impulse `most`.
    #[inline(always)]
    fn spring(&mut self, slip: Vec2, step: &GripStep<'_>, most: f64) -> Vec2 {
        let GripStep { ref spring, steady, time, .. } = *step;
        let stiffness = self.stiffness * spring.tightness;
        if steady {
            if stiffness < self.tightness {
                self.pull = self.pull * (stiffness / self.tightness) + slip * (stiffness * time);
            } else {
                self.pull += slip * (0.5 * (stiffness + self.tightness) * time);
            }
        } else {
            // The contact has closed within this step, and its stiffness has risen as √δ.
            let since = smaller(time, larger(spring.depth, 0.0) / larger(spring.approach, STILL));
            self.pull = slip * (2.0 / 3.0 * stiffness * since);
        }
        self.tightness = stiffness;
        let (change, pull) = (slip - self.slip, self.pull);
        self.slip = slip;
        let impulse = pull * time;
        if impulse.length_squared() <= most * most {
            return impulse;
        }
        // The surfaces slide: friction acts along the slip in the middle of the step.
        let along = if steady { pull + change * (0.5 * stiffness * time) } else { pull };
        let impulse = along * (most / along.length());
        self.pull = impulse * (1.0 / time);
        impulse
    }
}

/// The tangential stiffness of a compliant contact, per F/δ; 0 for a rigid one.
fn grip_stiffness(frequency_ratio: Option<f64>) -> f64 {
    frequency_ratio.map_or(0.0, |ratio| 1.25 / TANGENT_COMPLIANCE * ratio * ratio)
}
