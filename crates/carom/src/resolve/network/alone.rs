//! A ball alone between the tip of the cue and a wall: the strike of most shots. The equations are
//! those of the whole network, without the search for contacts and without lines that turn. A strike
//! takes a third of the time.

use super::ball::Ball;
use super::directions::Directions;
use super::grip::{Grip, GripStep};
use super::spring::{NormalSprings, Spring};
use super::step::TimeStep;
use super::strike::Cue;
use super::{
    MOST_CONTACTS, STILL, Stepping, TipReport, TipTouch, Units, WallTouch, larger, smaller,
};
use crate::math::Vec3;
use crate::physics::SlipFriction;
use crate::resolve::Body;

/// Resolves the impact of the tip on the ball that touches the wall.
pub(super) fn resolve(
    tip: &TipTouch,
    wall: &WallTouch,
    body: &mut Body,
    units: &Units,
    stepping: &Stepping,
) -> TipReport {
    let mut ball = Ball::default();
    ball.begin(body, units);
    let mut cue = Cue::new(tip, core::slice::from_ref(body), units);
    let mut contact = Contact::new(wall, body, units);
    integrate(&mut ball, &mut cue, &mut contact, units, stepping);
    let ((work, cost), (lost, gained)) = (ball.work_and_cost(Vec3::ZERO), cue.work_and_cost());
    let (work, cost) = (work + lost, cost + gained);
    let share = if cost > work { (work / cost).clamp(0.0, 2.0) } else { 1.0 };
    ball.apply(share, units, body);
    let approach = body.velocity.dot(wall.normal);
    if contact.springs.at(0).has_touched && approach > STILL * units.speed {
        body.velocity -= wall.normal * approach;
    }
    cue.report(share, units)
}

/// The contact with the wall.
struct Contact {
    springs: NormalSprings<1>,
    grip: Grip,
    normal: Vec3,
    directions: Directions,
}

impl Contact {
    fn new(wall: &WallTouch, body: &Body, units: &Units) -> Self {
        let mut springs = NormalSprings::NONE;
        springs.set(0, &Spring::of_wall(wall, body, units), units);
        let directions = Directions::of(wall.normal);
        Self { springs, grip: Grip::of_wall(wall), normal: wall.normal, directions }
    }
}

/// Integrates the impact until no contact carries a force and none is about to.
fn integrate(
    ball: &mut Ball,
    cue: &mut Cue,
    contact: &mut Contact,
    units: &Units,
    stepping: &Stepping,
) {
    let fastest = larger(contact.springs.square_speed(), cue.spring.square_speed());
    let mut step = TimeStep::first(units, stepping, fastest);
    // Forces act in the middle of a step.
    let mut drift = 0.5 * step.length;
    let mut is_loaded = false;
    let most = (MOST_CONTACTS * stepping.steps_per_contact) as usize;
    for _ in 0..most {
        let mut greatest_square = 0.0;
        let approach = ball.velocity.dot(contact.normal);
        let now = contact.springs.advance([approach], drift, &step, stepping, &mut greatest_square);
        let steady = is_loaded;
        is_loaded = false;
        let (mut push, mut turn) = (Vec3::ZERO, Vec3::ZERO);
        if now.loaded() != 0 {
            let normal = contact.springs.impulse(0, steady, &now, &step, &mut greatest_square);
            if normal != 0.0 {
                is_loaded = true;
                (push, turn) = contact.grip.impulse(&GripStep {
                    directions: contact.directions,
                    velocity: ball.velocity,
                    surface: ball.surface,
                    normal,
                    spring: contact.springs.at(0),
                    steady,
                    time: step.length,
                    law: &SlipFriction::constant(0.0),
                    speed_unit: step.speed,
                });
            }
        }
        let (velocity, surface) = (ball.velocity, ball.surface);
        let tip = cue.impulse(velocity, surface, drift, &step, stepping, &mut greatest_square);
        ball.push += cue.launch * tip - push;
        ball.turn += turn - cue.twist * tip;
        let last = step.length;
        step.adapt(greatest_square);
        if is_loaded || tip != 0.0 {
            drift = 0.5 * (last + step.length);
            ball.accelerate();
            continue;
        }
        let (wall, tip) = (contact.springs.at(0), cue.spring.at(0));
        let wait = smaller(wall.time_to_contact(), tip.time_to_contact());
        if wait == f64::INFINITY {
            return;
        }
        drift = wait + 0.5 * step.length;
    }
}
