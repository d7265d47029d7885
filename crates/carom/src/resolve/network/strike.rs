//! The cue in a network: a body that moves along its axis, and the spring of its tip.

use super::spring::{NormalSprings, Spring};
use super::step::TimeStep;
use super::{SPIN_PER_IMPULSE, Stepping, TipReport, Units};
use crate::math::Vec3;
use crate::resolve::Body;

/// The tip of a cue on a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipTouch {
    /// Index of the ball.
    pub ball: u8,
    /// Mass of the cue, kg.
    pub cue_mass: f64,
    /// Speed of the cue along its axis, m/s.
    pub cue_speed: f64,
    /// Unit vector along which the tip pushes the ball's centre: the cue's axis, turned by squirt.
    pub launch: Vec3,
    /// What turns the ball: the contact point, in ball radii from the centre, × the cue's axis.
    pub twist: Vec3,
    /// Stiffness k of the tip, N/m^(3/2).
    pub stiffness: f64,
    /// Restitution of the tip at this contact point.
    pub restitution: f64,
}

impl TipTouch {
    /// 1/m*, with the turning of the ball.
    fn mobility(&self, bodies: &[Body]) -> f64 {
        let ball = &bodies[usize::from(self.ball)];
        let turning = SPIN_PER_IMPULSE * self.twist.length_squared();
        1.0 / self.cue_mass + (1.0 + turning) / ball.mass
    }

    /// m*, kg.
    pub(super) fn reduced_mass(&self, bodies: &[Body]) -> f64 {
        1.0 / self.mobility(bodies)
    }

    /// Speed at which the tip approaches the ball's surface, m/s.
    pub(super) fn approach(&self, bodies: &[Body]) -> f64 {
        let ball = &bodies[usize::from(self.ball)];
        let surface = ball.angular_velocity * ball.radius;
        self.cue_speed - ball.velocity.dot(self.launch) - surface.dot(self.twist)
    }
}

/// The cue during the impact.
pub(super) struct Cue {
    pub(super) ball: usize,
    pub(super) launch: Vec3,
    pub(super) twist: Vec3,
    /// Speed before the impact, and now.
    first_velocity: f64,
    velocity: f64,
    /// Impulse on the ball.
    push: f64,
    /// 1/mass.
    mobility: f64,
    pub(super) spring: NormalSprings<1>,
    /// Whether the tip is on the ball, how often it came there, and for how long.
    presses: bool,
    contacts: u32,
    time: f64,
    /// Whether the ball met another across a gap while the tip was on it.
    pub(super) pushes: bool,
}

impl Cue {
    pub(super) fn new(tip: &TipTouch, bodies: &[Body], units: &Units) -> Self {
        let approach = tip.approach(bodies) / units.speed;
        let mobility = tip.mobility(bodies);
        let velocity = tip.cue_speed / units.speed;
        let mut spring = NormalSprings::NONE;
        let TipTouch { stiffness, restitution, .. } = *tip;
        spring.set(0, &Spring { approach, stiffness, mobility, gap: 0.0, restitution }, units);
        Self {
            ball: usize::from(tip.ball),
            launch: tip.launch,
            twist: tip.twist,
            first_velocity: velocity,
            velocity,
            push: 0.0,
            mobility: units.mass / tip.cue_mass,
            spring,
            presses: false,
            contacts: 0,
            time: 0.0,
            pushes: false,
        }
    }

    /// The tip's impulse of one step on a ball with this velocity and surface velocity; 0 while the
    /// tip is off the ball.
    #[inline(always)]
    pub(super) fn impulse(
        &mut self,
        velocity: Vec3,
        surface: Vec3,
        drift: f64,
        step: &TimeStep,
        stepping: &Stepping,
        greatest_square: &mut f64,
    ) -> f64 {
        let away = velocity.dot(self.launch) + surface.dot(self.twist);
        let approach = self.velocity - away;
        let now = self.spring.advance([approach], drift, step, stepping, greatest_square);
        let impulse = if now.loaded() != 0 {
            self.spring.impulse(0, self.presses, &now, step, greatest_square)
        } else {
            0.0
        };
        if impulse == 0.0 {
            self.presses = false;
            return 0.0;
        }
        self.contacts += u32::from(!self.presses);
        self.presses = true;
        self.time += step.length;
        self.push += impulse;
        self.velocity = self.first_velocity - self.push * self.mobility;
        impulse
    }

    /// What the impulse on the cue takes of the energy, in the first and in the second order.
    pub(super) fn work_and_cost(&self) -> (f64, f64) {
        (self.push * self.first_velocity, 0.5 * self.mobility * self.push * self.push)
    }

    /// What the strike was like. The impulse is scaled by `share`.
    pub(super) fn report(&self, share: f64, units: &Units) -> TipReport {
        TipReport {
            contacts: self.contacts,
            time: self.time * units.time,
            pushes: self.pushes,
            cue_speed: (self.first_velocity - share * self.push * self.mobility) * units.speed,
        }
    }
}
