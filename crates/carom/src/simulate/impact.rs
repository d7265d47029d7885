//! Impacts: the balls in one take new velocities in place.

use core::array::from_fn;

use super::{Simulation, earlier, struck_state};
use crate::detect::ball_ball::ContactFinder;
use crate::event::{Event, EventKind, Recorder};
use crate::math::Vec3;
use crate::motion::Path;
use crate::resolve::{self, Body};
use crate::{Ball, BallState, MotionState, Physics, Table};

/// A push without end: cloth friction presses a ball against another, or against a cushion, that
/// it touches. Bounces against it would shrink for ever: the cloth brakes each recoil away, or
/// there was none to begin with. So bodies under a push part with at least this speed, m/s, as if
/// they had been pressed together so fast. The contact then recurs after 2v/a, 1 ms under a
/// sliding ball. Faster, and bounces would be seen (now they are 0.25 µm high under a sliding
/// ball, 10 µm under the faintest push of rolling ones); slower, and there are more events.
const PRESS_SPEED: f64 = 1e-3;

/// The same, m/s, where the friction of that very contact does not take the energy that pressing
/// lends, as between frictionless balls. What is lent is then at most ½mv², 1e-9 J for a pool
/// ball.
const UNPAID_PRESS_SPEED: f64 = 1e-4;

/// A ball that is hit while it rolls slides until the cloth has taken 2/7 of what it was given;
/// pressed by this factor more, it still parts.
const BRAKED: f64 = 7.0 / 5.0;

/// A slide shorter than this, s, may be the recoil from a press, which lasts 0.3 ms at most on
/// cloth as slippery as any.
const BRIEF: f64 = 1e-3;

/// And if it is shorter than this share of the other ball's path, it is one.
const BRIEF_SHARE: f64 = 0.25;

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
    if parting(&result.1, normal) >= BRAKED * PRESS_SPEED {
        return result;
    }
    let settled: [Path; K] = from_fn(|k| settled(&result.1, k, &balls[k], physics));
    let push = Push::of(&settled, normal);
    let Some(speed) = press_speed(&result.1, &push, normal, PRESS_SPEED) else {
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
    match press_speed(&result.1, &push, normal, UNPAID_PRESS_SPEED) {
        Some(speed) => begin(strike(speed - approach)),
        None => result,
    }
}

/// The approach speed (m/s) that makes the bodies on `paths` part with `least`, if they would
/// otherwise part more slowly and `push` would bring them together again; or the one that makes
/// them part at all.
fn press_speed<const K: usize>(
    paths: &[Path; K],
    push: &Push,
    normal: Vec3,
    least: f64,
) -> Option<f64> {
    let speeds = paths.iter().fold(0.0, |sum, path| sum + path.velocity.length());
    let rounding = SEPARATION_ROUNDING * speeds;
    let parting = parting(paths, normal);
    let stuck = parting <= rounding;
    let enough = earlier(least, push.gives);
    // What a brief slide takes of the separation comes on top.
    let taken = if parting > push.parting { parting - push.parting } else { 0.0 };
    let speed = if push.parting < enough || stuck { BRAKED * (enough + taken) } else { 0.0 };
    let at_least = if stuck { 2.0 * rounding } else { 0.0 };
    let speed = if speed > at_least { speed } else { at_least };
    (speed > 0.0).then_some(speed)
}

/// Speed at which the bodies on `paths` separate along `normal`, m/s. A wall stands still.
#[inline(always)]
fn parting<const K: usize>(paths: &[Path; K], normal: Vec3) -> f64 {
    paths.iter().zip([-1.0, 1.0]).fold(0.0, |sum, (p, side)| sum + side * p.velocity.dot(normal))
}

/// The path of ball `k`, or the one after it if it is a slide that is over long before the other's
/// path: a recoil, not a push.
fn settled<const K: usize>(paths: &[Path; K], k: usize, ball: &Ball, physics: &Physics) -> Path {
    let path = &paths[k];
    let pushes = K == 2 && paths[1 - k].moves();
    let other = if pushes { paths[1 - k].duration } else { 0.0 };
    let recoil = path.duration < BRIEF && path.duration < BRIEF_SHARE * other;
    if path.motion == MotionState::Sliding && recoil {
        Path::new(&path.successor(), ball, &physics.cloth, physics.gravity)
    } else {
        *path
    }
}

/// How the cloth moves two bodies against each other.
struct Push {
    /// Speed of separation to begin with, m/s.
    parting: f64,
    /// Largest such speed that the push turns back before it ends, m/s; 0 if there is none.
    gives: f64,
}

impl Push {
    fn of<const K: usize>(paths: &[Path; K], normal: Vec3) -> Self {
        let (mut acceleration, mut lasts) = (0.0, f64::INFINITY);
        for (path, side) in paths.iter().zip([1.0, -1.0]) {
            acceleration += 2.0 * side * path.half_acceleration.dot(normal);
            if path.moves() {
                lasts = earlier(path.duration, lasts);
            }
        }
        let gives = if acceleration > 0.0 { 0.5 * acceleration * lasts } else { 0.0 };
        Self { parting: parting(paths, normal), gives }
    }
}
