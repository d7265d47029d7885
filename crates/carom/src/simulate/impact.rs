//! Impacts: the balls in one take new velocities in place.

use super::{Simulation, earlier, struck_state};
use crate::detect::ball_ball::ContactFinder;
use crate::event::{Event, EventKind, Recorder};
use crate::math::Vec3;
use crate::motion::Path;
use crate::resolve::{self, Body};
use crate::{BallState, Physics, Table};

/// A push that never ends: cloth friction presses a ball against another, or against a cushion,
/// that it already touches. Without a remedy the contacts would follow each other in no time. The
/// ball is resolved as if it had been pressed so fast that it comes back after this time, s. The
/// energy that this lends is at most ½m(aT/2)², 4e-11 J for a pool ball that slides, less than
/// friction takes in the same contact; halving T doubles the events of such a push.
const PRESS_PERIOD: f64 = 2e-5;

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
            struck_state(&before, body.velocity, body.angular_velocity, ball.radius)
        };
        let normal = into.with_z(0.0);
        let mut after = strike(0.0);
        self.begin(i, &after, time, physics);
        if let Some(speed) = pressed(&self.path[i], &Path::default(), normal) {
            after = strike(speed - before.velocity.dot(normal));
            self.begin(i, &after, time, physics);
        }
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
        let reduced = 1.0 / (1.0 / self.ball[a].mass + 1.0 / self.ball[b].mass);
        let strike = |press: f64| {
            let mut p = body(&before[0], &self.ball[a]);
            let mut q = body(&before[1], &self.ball[b]);
            p.velocity += normal * (press * reduced / p.mass);
            q.velocity -= normal * (press * reduced / q.mass);
            let law = &physics.ball_ball;
            resolve::ball_ball::resolve(
                law,
                &physics.cloth,
                physics.gravity,
                normal,
                &mut p,
                &mut q,
            );
            [
                struck_state(&before[0], p.velocity, p.angular_velocity, p.radius),
                struck_state(&before[1], q.velocity, q.angular_velocity, q.radius),
            ]
        };
        let mut after = strike(0.0);
        let paths = |after: &[BallState; 2]| {
            [
                Path::new(&after[0], &self.ball[a], &physics.cloth, physics.gravity),
                Path::new(&after[1], &self.ball[b], &physics.cloth, physics.gravity),
            ]
        };
        let mut path = paths(&after);
        if let Some(speed) = pressed(&path[0], &path[1], normal) {
            after = strike(speed - (before[0].velocity - before[1].velocity).dot(normal));
            path = paths(&after);
        }
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

pub(super) fn body(state: &BallState, ball: &crate::Ball) -> Body {
    Body {
        velocity: state.velocity,
        angular_velocity: state.angular_velocity,
        mass: ball.mass,
        radius: ball.radius,
    }
}

/// The approach speed (m/s) with which `a` must be taken to have met `b` along `normal`, if after
/// the impact they would meet again too soon: see [`PRESS_PERIOD`] and [`SEPARATION_ROUNDING`].
#[inline(always)]
fn pressed(a: &Path, b: &Path, normal: Vec3) -> Option<f64> {
    let parting = (b.velocity - a.velocity).dot(normal);
    let rounding = SEPARATION_ROUNDING * (a.velocity.length() + b.velocity.length());
    let push = 2.0 * (a.half_acceleration - b.half_acceleration).dot(normal);
    // The push ends with the first slide, so that a faint one lends as little.
    let lasts = earlier(earlier(a.duration, b.duration), PRESS_PERIOD);
    let enough = if push > 0.0 { 0.5 * push * lasts } else { 0.0 };
    if parting > rounding {
        (parting < enough).then_some(enough)
    } else {
        Some(if enough > rounding { enough } else { 2.0 * rounding })
    }
}
