//! Impacts: the balls in one take new velocities in place.

use core::array::from_fn;

use super::{Simulation, earlier, struck_state};
use crate::detect::ball_ball::ContactFinder;
use crate::event::{Event, EventKind, Recorder};
use crate::math::Vec3;
use crate::motion::Path;
use crate::resolve::{self, Body};
use crate::{Ball, BallState, Physics, Table};

/// A push without end: cloth friction presses a ball against another, or against a cushion, that
/// it touches. Bounces against it would shrink for ever: each one's recoil is braked away by the
/// cloth, or there was none to begin with. So contacts of a push recur after this time at the
/// earliest, s: the ball is resolved as if it had been pressed with the speed ½aT that the push
/// gives it meanwhile, at most 1 mm/s. Shorter, and there are more events; longer, and bounces
/// would be seen (now they are 0.25 µm high).
const PRESS_PERIOD: f64 = 1e-3;

/// The same, s, where the friction of that very contact does not take the energy which pressing
/// lends, as between frictionless balls. What is lent is then less than ½m(aT/2)², 1e-9 J for a
/// pool ball.
const UNPAID_PRESS_PERIOD: f64 = 1e-4;

/// A separation below this fraction of the bodies' speeds is rounding: the next contact would
/// find the same two numbers again, for ever.
const SEPARATION_ROUNDING: f64 = 16.0 * f64::EPSILON;

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// A ball meets a cushion.
    pub(super) fn rebound<R: Recorder>(
        &mut self,
        i: usize,
        part: u16,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) {
        let before = self.state(i, time);
        let ball = self.ball[i];
        let into = table.normal_at(usize::from(part), before.position.xy());
        let sin_theta = (table.cushion_height - ball.radius) / ball.radius;
        let strike = |press: f64| {
            let mut body = body(&before, &ball);
            body.velocity += (into * press).with_z(0.0);
            let law = &physics.cushion;
            resolve::ball_cushion::resolve(law, &physics.cloth, into, sin_theta, &mut body);
            [struck_state(&before, body.velocity, body.angular_velocity, ball.radius)]
        };
        let ([after], [path]) = settle(&[before], &[ball], into.with_z(0.0), physics, strike);
        self.set(i, path, time);
        recorder.record(&Event {
            time,
            kind: EventKind::RailCollision(part),
            balls: &[i as u16],
            before: &[before],
            after: &[after],
        });
        self.find(&[i as u16], time, table);
    }

    /// Two balls meet.
    pub(super) fn collide_pair<R: Recorder>(
        &mut self,
        a: usize,
        b: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) {
        let balls = [a as u16, b as u16];
        let before = [self.state(a, time), self.state(b, time)];
        let d = before[1].position - before[0].position;
        let normal = d * (1.0 / d.length());
        let pair = [self.ball[a], self.ball[b]];
        let reduced = 1.0 / (1.0 / pair[0].mass + 1.0 / pair[1].mass);
        let strike = |press: f64| {
            let mut p = body(&before[0], &pair[0]);
            let mut q = body(&before[1], &pair[1]);
            // Level, also where balls of different size stand with their centres aslant.
            let along = normal.xy().with_z(0.0);
            p.velocity += along * (press * reduced / p.mass);
            q.velocity -= along * (press * reduced / q.mass);
            let Physics { ball_ball: law, cloth, gravity, .. } = physics;
            resolve::ball_ball::resolve(law, cloth, *gravity, normal, &mut p, &mut q);
            [
                struck_state(&before[0], p.velocity, p.angular_velocity, p.radius),
                struck_state(&before[1], q.velocity, q.angular_velocity, q.radius),
            ]
        };
        let (after, path) = settle(&before, &pair, normal, physics, strike);
        self.set(a, path[0], time);
        self.set(b, path[1], time);
        recorder.record(&Event {
            time,
            kind: EventKind::BallCollision,
            balls: &balls,
            before: &before,
            after: &after,
        });
        self.find(&balls, time, table);
    }
}

pub(super) fn body(state: &BallState, ball: &Ball) -> Body {
    Body {
        velocity: state.velocity,
        angular_velocity: state.angular_velocity,
        mass: ball.mass,
        radius: ball.radius,
    }
}

/// The states after an impact along `normal`, of a ball with a wall (`K` = 1) or with another
/// (`K` = 2), and the paths that follow. `strike` gives the states if the approach speed is raised
/// by so many m/s; it is, if they would otherwise meet again too soon ([`PRESS_PERIOD`]).
#[inline(always)]
fn settle<const K: usize>(
    before: &[BallState; K],
    balls: &[Ball; K],
    normal: Vec3,
    physics: &Physics,
    strike: impl Fn(f64) -> [BallState; K],
) -> ([BallState; K], [Path; K]) {
    let begin = |after: [BallState; K]| {
        let path = |k: usize| Path::new(&after[k], &balls[k], &physics.cloth, physics.gravity);
        (after, from_fn(path))
    };
    let result = begin(strike(0.0));
    let Some(speed) = press_speed(&result.1, normal, PRESS_PERIOD) else {
        return result;
    };
    let energy = |states: &[BallState; K]| -> f64 {
        states.iter().zip(balls).map(|(s, b)| b.kinetic_energy(s)).sum()
    };
    let other = if K == 2 { before[K - 1].velocity } else { Vec3::ZERO };
    let approach = (before[0].velocity - other).dot(normal);
    let pressed = strike(speed - approach);
    if energy(&pressed) <= energy(before) {
        return begin(pressed);
    }
    match press_speed(&result.1, normal, UNPAID_PRESS_PERIOD) {
        Some(speed) => begin(strike(speed - approach)),
        None => result,
    }
}

/// The approach speed (m/s) that makes the contact recur after `period`, if it would do so sooner.
#[inline(always)]
fn press_speed<const K: usize>(paths: &[Path; K], normal: Vec3, period: f64) -> Option<f64> {
    let (mut parting, mut speeds, mut pressed) = (0.0, 0.0, 0.0);
    for (path, side) in paths.iter().zip([1.0, -1.0]) {
        parting -= side * path.velocity.dot(normal);
        speeds += path.velocity.length();
        let push = 2.0 * side * path.half_acceleration.dot(normal);
        if push > 0.0 {
            // A push ends with its motion state, so that a faint slide lends as little.
            pressed += 0.5 * push * earlier(path.duration, period);
        }
    }
    let rounding = SEPARATION_ROUNDING * speeds;
    let enough = if pressed > rounding { pressed } else { rounding };
    (parting < enough).then_some(enough)
}
