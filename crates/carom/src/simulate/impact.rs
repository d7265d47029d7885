//! Impacts: the balls in one take new velocities in place.

use super::flight::edge_at;
use super::support::{Support, on_plane};
use super::{Simulation, earlier};
use crate::detect::ball_ball::ContactFinder;
use crate::detect::ball_table::TableFeature;
use crate::event::{Event, EventKind, Recorder};
use crate::math::{Vec3, sqrt};
use crate::physics::{Cushion, Surface};
use crate::resolve::ball_ball::held;
use crate::resolve::ball_edge::{self, Edge};
use crate::resolve::{self, Body, ball_slate};
use crate::table::Part;
use crate::{Ball, BallState, MotionState, Physics, Table};

/// A push without end: cloth friction presses a ball against another, or against a cushion, that
/// it touches, and their bounces would shrink for ever, for the cloth brakes each recoil away. A
/// contact is part of such a push if both bodies have been in another within this time, s, and
/// now meet at less than [`PRESS_SPEED`]. A lone gentle touch is not.
const PUSH_PERIOD: f64 = 1e-3;

/// Bodies under a push part with at least this speed, m/s, as if they had been pressed together
/// so fast. The contact then recurs after 2v/a, 1 ms under a sliding ball. Faster, and bounces
/// would be seen (now they are 0.25 µm high under a sliding ball, 10 µm under the faintest push of
/// rolling ones); slower, and there are more events.
const PRESS_SPEED: f64 = 1e-3;

/// Pressing lends energy, which the friction of that very contact takes. Where the contact has no
/// friction, the spins whose slip on the cloth is the push pay it, with at most this share of
/// their energy. A sliding pool ball pays about 1e-6: the cloth takes thousands of times more
/// between two contacts. (With friction they may not: a ball's angular momentum about the contact
/// is kept.)
const SPIN_SHARE: f64 = 1e-3;

/// The same speed, m/s, where neither pays. What is lent is then at most ½mv², 1e-9 J for a pool
/// ball.
const UNPAID_PRESS_SPEED: f64 = 1e-4;

/// Nor do they part with more than this share of the speeds of their surfaces, so that bodies
/// that hardly move are hardly moved.
const PRESS_SHARE: f64 = 0.1;

/// Sine and cosine of the angle, 15° as the back draft of a facing, by which the wall of a liner leans over
/// the hole: it throws a fast ball down. Detection takes the wall as upright, in the mean of its
/// height. (Estimated: no rule book has it. Upright, a wall would let a ball that rolls at 2.3 m/s into
/// the middle of the pocket climb it and come out again.)
const LINER_LEAN: [f64; 2] = [0.258_819_045_102_520_76, 0.965_925_826_289_068_3];

/// A ball that keeps bouncing on the very top of another would stay there for ever. Up to this slope of the
/// line of centres it is taken to lean so far, along x: no ball balances within 0.06 mm.
const BALANCE: f64 = 1e-3;

/// A separation below this fraction of the bodies' speeds is rounding: the next contact would
/// find the same two numbers again, for ever.
const SEPARATION_ROUNDING: f64 = 16.0 * f64::EPSILON;

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// A ball meets a part of a cushion. Returns the number of events.
    pub(super) fn rebound<R: Recorder>(
        &mut self,
        i: usize,
        part: u16,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let before = self.state(i, time);
        let kind = table.cushions[usize::from(part)].part;
        if kind == Part::Top {
            return self.land_on_top(i, part, &before, time, table, physics, recorder);
        }
        let ball = self.ball[i];
        let other;
        let law = if kind == Part::Nose {
            &physics.cushion
        } else {
            other = physics.cushion_of(kind);
            &other
        };
        let on_bed = !self.aloft[i];
        let feature = TableFeature::Cushion(part);
        let edge = self.aloft[i].then(|| edge_at(table, feature, before.position, ball.radius));
        // A ball on the slate is pushed along it.
        let (normal, push) = match edge {
            Some(edge) => (edge.normal, edge.normal),
            None => {
                let into = table.normal_at(usize::from(part), before.position.xy());
                let sin = (table.cushion_height - ball.radius) / ball.radius;
                ((into * sqrt(1.0 - sin * sin)).with_z(sin), into.with_z(0.0))
            }
        };
        let is_liner = kind == Part::Liner;
        let bounce = Bounce { before: &before, ball: &ball, law, normal, push, edge, is_liner };
        let again = self.touched_lately(i, time);
        // A cushion hit so gently reflects.
        let impact =
            Impact { before: &[before], balls: &[ball], normal: push, push, again, smooth: true };
        let after = [bounce.with(0.0, physics)];
        let [after] = impact.settle(after, |press| [bounce.with(press, physics)]);
        self.touched[i] = time;
        let kind = EventKind::RailCollision(part);
        let events = self.happen(i, kind, [before, after], time, table, physics, recorder);
        if on_bed {
            return events;
        }
        events + self.catch(i, &after, time, table, physics, recorder)
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
    ) -> u32 {
        let balls = [a as u16, b as u16];
        let before = [self.state(a, time), self.state(b, time)];
        let d = before[1].position - before[0].position;
        let again = self.touched_lately(a, time) && self.touched_lately(b, time);
        let normal = d * (1.0 / d.length());
        let pair = [self.ball[a], self.ball[b]];
        let on_bed = [!self.aloft[a], !self.aloft[b]];
        // Two balls on the slate push each other along it, also where their sizes differ and their
        // centres stand aslant.
        let push = if on_bed == [true, true] { level(normal) } else { normal };
        // What the slate holds is pushed along it alone.
        let held = on_bed.map(|lies| lies && on_bed != [true, true]);
        let level = push.xy().with_z(0.0);
        let along = held.map(|held| if held { level } else { push });
        let mobility = |k: usize| along[k].length_squared() / pair[k].mass;
        let reduced = 1.0 / (mobility(0) + mobility(1));
        let pushes = [0, 1].map(|k| along[k] * (reduced / pair[k].mass));
        let smooth = physics.ball_ball.is_smooth();
        let collision = Collision { before: &before, balls: &pair, on_bed, normal, pushes };
        let impact = Impact { before: &before, balls: &pair, normal, push, again, smooth };
        let after = collision.with(0.0, physics);
        let after = impact.settle(after, |press| collision.with(press, physics));
        for (i, after) in [(a, &after[0]), (b, &after[1])] {
            self.begin(i, after, time, physics);
            self.touched[i] = time;
        }
        recorder.record(&Event {
            time,
            kind: EventKind::BallCollision,
            balls: &balls,
            before: &before,
            after: &after,
        });
        self.find(&balls, time, table);
        1
    }

    /// Whether ball `i` has been in another contact within [`PUSH_PERIOD`].
    #[inline(always)]
    fn touched_lately(&self, i: usize, time: f64) -> bool {
        time - self.touched[i] < PUSH_PERIOD
    }
}

/// A ball that meets a cushion.
struct Bounce<'a> {
    before: &'a BallState,
    ball: &'a Ball,
    law: &'a Cushion,
    normal: Vec3,
    /// Along which it can be pushed.
    push: Vec3,
    /// What it meets if it is off the slate.
    edge: Option<Edge>,
    is_liner: bool,
}

impl Bounce<'_> {
    /// The state after it, the approach speed being raised by `press`, m/s.
    #[inline(always)]
    fn with(&self, press: f64, physics: &Physics) -> BallState {
        let mut body = body(self.before, self.ball);
        body.velocity += self.push * press;
        let law = self.law;
        match &self.edge {
            None => {
                resolve::ball_cushion::resolve(law, &physics.cloth, self.normal, true, &mut body)
            }
            Some(edge) => body = meet_edge(law, physics, edge, self.is_liner, body),
        }
        let (v, spin) = (body.velocity, body.angular_velocity);
        Support::under(self.before).settled(self.before, v, spin, self.ball, physics)
    }
}

/// Two balls that meet.
struct Collision<'a> {
    before: &'a [BallState; 2],
    balls: &'a [Ball; 2],
    on_bed: [bool; 2],
    /// From the first one's centre to the second's.
    normal: Vec3,
    /// What raises their approach speed by 1 m/s.
    pushes: [Vec3; 2],
}

impl Collision<'_> {
    /// The states after it, the approach speed being raised by `press`, m/s.
    #[inline(always)]
    fn with(&self, press: f64, physics: &Physics) -> [BallState; 2] {
        let Self { before, balls, on_bed, normal, pushes } = self;
        let mut p = body(&before[0], &balls[0]);
        let mut q = body(&before[1], &balls[1]);
        p.velocity += pushes[0] * press;
        q.velocity -= pushes[1] * press;
        let Physics { ball_ball: law, cloth, gravity, .. } = physics;
        let gentle = || {
            let approach = (p.velocity - q.velocity).dot(*normal);
            approach < ball_slate::last_hop_speed(*gravity)
        };
        match on_bed {
            [false, true] if gentle() => {
                let normal = unbalanced(*normal, &p);
                held::resolve(law.restitution, normal, &mut p, &mut q);
            }
            [true, false] if gentle() => {
                let normal = unbalanced(-*normal, &q);
                held::resolve(law.restitution, normal, &mut q, &mut p);
            }
            _ => resolve::ball_ball::resolve(law, cloth, *normal, &mut p, &mut q),
        }
        let after = |k: usize, body: &Body| {
            let (v, spin) = (body.velocity, body.angular_velocity);
            Support::under(&before[k]).settled(&before[k], v, spin, &balls[k], physics)
        };
        [after(0, &p), after(1, &q)]
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

/// A ball off the slate meets `edge`: it is pressed on it, or thrown off.
#[cold]
fn meet_edge(law: &Cushion, physics: &Physics, edge: &Edge, is_liner: bool, ball: Body) -> Body {
    if edge.presses(physics.gravity, &ball) {
        let (e, mu) = (law.restitution.at(0.0), law.friction.a);
        let surface = Surface { restitution: e, friction: mu };
        let mut pressed = ball;
        ball_edge::resolve(&surface, physics.gravity, edge, &mut pressed);
        return pressed;
    }
    let throw = |normal| {
        let mut thrown = ball;
        resolve::ball_cushion::resolve(law, &physics.cloth, normal, false, &mut thrown);
        thrown
    };
    if !is_liner || edge.normal.z != 0.0 {
        return throw(edge.normal);
    }
    let thrown = throw(leaning(edge.normal));
    // A ball that falls along a wall does not come against its slope.
    if thrown.velocity.dot(edge.normal) > 0.0 { throw(edge.normal) } else { thrown }
}

/// The normal of a liner's wall, given the horizontal one.
fn leaning(normal: Vec3) -> Vec3 {
    let [sin, cos] = LINER_LEAN;
    (normal.xy() * cos).with_z(sin)
}

/// The line of centres from `flyer` to a ball below it, leaning by [`BALANCE`] if it stands upright and the
/// flyer stays on it.
fn unbalanced(normal: Vec3, flyer: &Body) -> Vec3 {
    if normal.xy().length_squared() >= BALANCE * BALANCE
        || flyer.velocity.xy().length_squared() >= PRESS_SPEED * PRESS_SPEED
    {
        return normal;
    }
    let leaning = Vec3::new(BALANCE, 0.0, normal.z);
    leaning * (1.0 / leaning.length())
}

/// The horizontal direction of `normal`.
fn level(normal: Vec3) -> Vec3 {
    if normal.z == 0.0 {
        return normal;
    }
    let along = normal.xy();
    (along * (1.0 / along.length())).with_z(0.0)
}

/// A state after an impact with other velocities.
fn moving(state: &BallState, velocity: Vec3, spin: Vec3, radius: f64) -> BallState {
    if state.motion == MotionState::Airborne {
        return BallState { velocity, angular_velocity: spin, ..*state };
    }
    // The plane takes what would go into it, as for a last hop.
    on_plane(state.position, velocity.xy().with_z(0.0), spin, radius)
}

/// Bodies about to meet along `normal`: a ball and a wall (`K` = 1) or two balls (`K` = 2).
struct Impact<'a, const K: usize> {
    before: &'a [BallState; K],
    balls: &'a [Ball; K],
    normal: Vec3,
    /// The same along which they can be pushed: level for bodies on the slate.
    push: Vec3,
    /// Whether both have been in another contact just now.
    again: bool,
    /// Whether no friction acts between them at low speed.
    smooth: bool,
}

impl<const K: usize> Impact<'_, K> {
    /// The states after the impact. It leaves the bodies in the states `after`, or, if they are under a
    /// push, in those that `strike` gives if the approach speed is raised by so many m/s.
    #[inline(always)]
    fn settle(
        &self,
        after: [BallState; K],
        strike: impl Fn(f64) -> [BallState; K],
    ) -> [BallState; K] {
        let approach = -self.parting(self.before);
        let parting = self.parting(&after);
        let rounding = SEPARATION_ROUNDING * self.speeds(&after);
        if parting > rounding && (parting >= PRESS_SPEED || !self.again || approach >= PRESS_SPEED)
        {
            return after;
        }
        if approach >= PRESS_SPEED {
            return self.parted(&after, 2.0 * rounding - parting);
        }
        self.pushed(after, parting, rounding, strike)
    }

    /// The states after an impact under a push, `parting` being the speed at which the bodies separate in
    /// those `after` it, m/s, and `rounding` that of their speeds.
    #[cold]
    fn pushed(
        &self,
        after: [BallState; K],
        parting: f64,
        rounding: f64,
        strike: impl Fn(f64) -> [BallState; K],
    ) -> [BallState; K] {
        let approach = -self.parting(self.before);
        // Gravity presses also what does not move, and goes on until the upper ball comes off.
        let flies = K == 2 && self.before.iter().any(|s| s.motion == MotionState::Airborne);
        let share = if flies {
            f64::INFINITY
        } else {
            PRESS_SHARE * (self.speeds(self.before) + self.surface_speeds())
        };
        let mut result = after;
        for least in [PRESS_SPEED, UNPAID_PRESS_SPEED] {
            let least = if self.again { earlier(least, share) } else { 0.0 };
            let speed = if least > 2.0 * rounding { least } else { 2.0 * rounding };
            if parting >= speed {
                return after;
            }
            result = strike(speed - approach);
            if self.pay(&mut result) || flies {
                break;
            }
        }
        result
    }

    /// Whether `states` have no more energy than there was before the impact, at the latest once
    /// the spins about horizontal axes have paid for it.
    fn pay(&self, states: &mut [BallState; K]) -> bool {
        let excess = self.energy(states) - self.energy(self.before);
        if excess <= 0.0 {
            return true;
        }
        let of = |(s, b): (&BallState, &Ball)| {
            let rolling = BallState {
                angular_velocity: s.angular_velocity.xy().with_z(0.0),
                ..BallState::default()
            };
            b.kinetic_energy(&rolling)
        };
        let purse = states.iter().zip(self.balls).map(of).fold(0.0, |sum, energy| sum + energy);
        if !self.smooth || excess > SPIN_SHARE * purse {
            return false;
        }
        let kept = sqrt(1.0 - excess / purse);
        for (state, ball) in states.iter_mut().zip(self.balls) {
            let spin = state.angular_velocity;
            let spin = (spin.xy() * kept).with_z(spin.z);
            *state = moving(state, state.velocity, spin, ball.radius);
        }
        true
    }

    /// `states`, parting by so many m/s more. It is for bodies that an impact has left together, for
    /// its restitution is 0, or because slate and nose hold the ball: they meant to part at 0, and
    /// friction has done its work.
    #[cold]
    fn parted(&self, states: &[BallState; K], speed: f64) -> [BallState; K] {
        let mobility = self.balls.iter().fold(0.0, |sum, ball| sum + 1.0 / ball.mass);
        let along = self.push * (speed / mobility);
        let mut side = -1.0;
        let mut result = *states;
        for (state, ball) in result.iter_mut().zip(self.balls) {
            let velocity = state.velocity + along * (side / ball.mass);
            *state = moving(state, velocity, state.angular_velocity, ball.radius);
            side = -side;
        }
        result
    }

    /// Speed at which the bodies separate, m/s. A wall stands still.
    fn parting(&self, states: &[BallState; K]) -> f64 {
        let along = states.iter().map(|s| s.velocity.dot(self.normal));
        along.zip([-1.0, 1.0]).fold(0.0, |sum, (speed, side)| sum + side * speed)
    }

    fn speeds(&self, states: &[BallState; K]) -> f64 {
        states.iter().fold(0.0, |sum, s| sum + s.velocity.length())
    }

    fn surface_speeds(&self) -> f64 {
        let of = |(s, b): (&BallState, &Ball)| b.radius * s.angular_velocity.length();
        self.before.iter().zip(self.balls).map(of).fold(0.0, |sum, speed| sum + speed)
    }

    fn energy(&self, states: &[BallState; K]) -> f64 {
        let of = |(s, b): (&BallState, &Ball)| b.kinetic_energy(s);
        states.iter().zip(self.balls).map(of).fold(0.0, |sum, energy| sum + energy)
    }
}
