//! The cue in a network: a body that moves along its axis, and the spring of its tip.

use super::link::{Link, NormalSpring};
use super::step::{Bits, TimeStep};
use super::{BALL_SLOTS, Ball, SPIN_PER_IMPULSE, Stepping, TipReport, Units, round_to_grid};
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
    ball: usize,
    launch: Vec3,
    twist: Vec3,
    /// Speed before the impact, and now.
    first_velocity: f64,
    velocity: f64,
    /// Impulse on the ball.
    push: f64,
    /// 1/mass.
    mobility: f64,
    pub(super) spring: NormalSpring,
    /// Whether the tip is on the ball, how often it came there, and for how long.
    presses: bool,
    contacts: u32,
    time: f64,
    /// Whether the ball met another across a gap while the tip was on it.
    pushes: bool,
}

impl Cue {
    pub(super) fn new(tip: &TipTouch, bodies: &[Body], units: &Units) -> Self {
        let approach = tip.approach(bodies) / units.speed;
        let mobility = tip.mobility(bodies);
        let velocity = tip.cue_speed / units.speed;
        Self {
            ball: usize::from(tip.ball),
            launch: tip.launch,
            twist: tip.twist,
            first_velocity: velocity,
            velocity,
            push: 0.0,
            mobility: units.mass / tip.cue_mass,
            spring: NormalSpring::new(
                approach,
                tip.stiffness,
                mobility,
                0.0,
                tip.restitution,
                units,
            ),
            presses: false,
            contacts: 0,
            time: 0.0,
            pushes: false,
        }
    }

    /// The tip's impulse of one step. Returns the set of the balls with an impulse.
    pub(super) fn act(
        &mut self,
        balls: &mut [Ball; BALL_SLOTS],
        links: &[Link],
        drift: f64,
        (step, stepping): (&TimeStep, &Stepping),
        greatest_square: &mut f64,
    ) -> u32 {
        let ball = &mut balls[self.ball % BALL_SLOTS];
        let away = ball.velocity.dot(self.launch) + ball.surface.dot(self.twist);
        let approach = self.velocity - away;
        let Some(impulse) = self.spring.impulse(approach, drift, step, stepping, greatest_square)
        else {
            self.presses = false;
            return 0;
        };
        self.contacts += u32::from(!self.presses);
        self.presses = true;
        self.time += step.length;
        let met = |k: usize| links[k].met_across_gap();
        self.pushes = self.pushes || Bits(ball.links).any(met);
        ball.push += round_to_grid(self.launch * impulse);
        ball.turn -= round_to_grid(self.twist * impulse);
        self.push += impulse;
        self.velocity = self.first_velocity - self.push * self.mobility;
        1 << self.ball
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
