//! Impacts of a ball on a cushion and of two balls.

use super::edge::cushion_edge;
use super::jam::Touched;
use super::persistent_contact::{Encounter, MIN_SEPARATION, SLIPPERY, SLIPPERY_PUSH};
use super::step::StepContext;
use super::support::Support;
use super::{Simulation, earlier};
use crate::event::{EventKind, Recorder};
use crate::math::{Vec3, sqrt};
use crate::physics::{BallBall, Cushion, Surface};
use crate::resolve::ball_ball::contact::Contact;
use crate::resolve::ball_ball::held;
use crate::resolve::ball_edge::{self, Edge};
use crate::resolve::{self, Body, ball_slate};
use crate::table::Part;
use crate::{Ball, BallState, MotionState, Physics};

/// Sine and cosine of the angle by which the wall of a liner leans over the hole, so that it
/// deflects a fast ball downwards: 15°, like the back draft of a facing. Detection treats the wall
/// as upright, at its mean position. Estimated: no rule book gives the angle. Smaller, and a ball
/// that rolls at 2.3 m/s into the middle of the pocket climbs the wall and comes out again.
const LINER_LEAN: [f64; 2] = [0.258_819_045_102_520_76, 0.965_925_826_289_068_3];

/// Least slope of the line of centres of a ball that bounces on top of another. A smaller slope is
/// replaced by this one, along x. Without it a ball would bounce on the highest point of another
/// for ever; with it no ball balances closer than 0.06 mm to that point.
const BALANCE: f64 = 1e-3;

impl<const N: usize> Simulation<N> {
    /// A ball meets a part of a cushion.
    pub(super) fn on_cushion_contact<R: Recorder>(
        &mut self,
        i: usize,
        part: u16,
        step: &mut StepContext<'_, R>,
    ) {
        let before = self.state(i, step.time);
        let StepContext { table, physics, .. } = *step;
        let kind = table.cushions[usize::from(part)].part;
        if kind == Part::Top {
            return self.on_rail_top_contact(i, part, &before, step);
        }
        let ball = self.ball[i];
        let other;
        let law = if kind == Part::Nose {
            &physics.cushion
        } else {
            other = physics.cushion_of(kind);
            &other
        };
        let on_bed = !self.off_bed[i];
        let edge = (!on_bed).then(|| cushion_edge(table, part, before.position, ball.radius));
        // A ball on the slate can only be pushed along it.
        let (normal, push) = match edge {
            Some(edge) => (edge.normal, edge.normal),
            None => {
                let into = table.normal_at(usize::from(part), before.position.xy());
                let sin = (table.cushion_height - ball.radius) / ball.radius;
                ((into * sqrt(1.0 - sin * sin)).with_z(sin), into.with_z(0.0))
            }
        };
        let is_liner = kind == Part::Liner;
        let impact =
            CushionImpact { before: &before, ball: &ball, law, normal, push, edge, is_liner };
        let encounter = Encounter {
            before: &[before],
            balls: &[ball],
            normal: push,
            push,
            recent: self.push[i].is_recent(step.time),
            pushed_for: if on_bed { self.push[i].lasted(step.time) } else { 0.0 },
            // At speeds this low a cushion reflects the ball without friction.
            smooth: true,
        };
        let after = [impact.raised(0.0, physics)];
        let [after] = encounter.settle(after, |speed| [impact.raised(speed, physics)]);
        self.push[i].touch(step.time);
        self.emit(i, EventKind::RailCollision(part), [before, after], step);
        if !on_bed {
            self.pocket_if_trapped(i, &after, step);
            self.stop_if_jammed(i, Touched::Cushion(part), &after, step);
        }
    }

    /// Two balls meet, and no third ball touches them.
    pub(super) fn on_pair_contact<R: Recorder>(
        &mut self,
        a: usize,
        b: usize,
        step: &mut StepContext<'_, R>,
    ) {
        let clung = step.next_cling();
        let StepContext { physics, time, .. } = *step;
        let law = clung.as_ref().unwrap_or(&physics.ball_ball);
        let balls = [a as u16, b as u16];
        let before = [self.state(a, time), self.state(b, time)];
        let d = before[1].position - before[0].position;
        let normal = d * (1.0 / d.length());
        let pair = [self.ball[a], self.ball[b]];
        let on_bed = [!self.off_bed[a], !self.off_bed[b]];
        let recent = self.push[a].is_recent(time) && self.push[b].is_recent(time);
        let pushed_for = if on_bed == [true, true] {
            earlier(self.push[a].lasted(time), self.push[b].lasted(time))
        } else {
            0.0
        };
        // Two balls on the slate push each other along it, even if they differ in size and the line
        // of centres is not horizontal.
        let push = if on_bed == [true, true] { horizontal(normal) } else { normal };
        // A ball that the slate holds against a flying ball can only be pushed along the slate.
        let held = on_bed.map(|is_on_bed| is_on_bed && on_bed != [true, true]);
        let level = push.xy().with_z(0.0);
        let along = held.map(|held| if held { level } else { push });
        let mobility = |k: usize| along[k].length_squared() / pair[k].mass;
        let reduced = 1.0 / (mobility(0) + mobility(1));
        let pushes = [0, 1].map(|k| along[k] * (reduced / pair[k].mass));
        let smooth = law.is_smooth()
            || (pushed_for > SLIPPERY_PUSH && is_slippery(law, normal, &before, &pair));
        let impact = PairImpact { before: &before, balls: &pair, law, on_bed, normal, pushes };
        let encounter =
            Encounter { before: &before, balls: &pair, normal, push, recent, pushed_for, smooth };
        let after = impact.raised(0.0, physics);
        let after = encounter.settle(after, |speed| impact.raised(speed, physics));
        for (i, after) in [(a, &after[0]), (b, &after[1])] {
            self.begin_path(i, after, step);
            self.push[i].touch(time);
        }
        step.record(EventKind::BallCollision, &balls, &before, &after);
        self.find_candidates(&balls, time, step.table);
    }
}

/// The impact of a ball on a cushion.
struct CushionImpact<'a> {
    before: &'a BallState,
    ball: &'a Ball,
    law: &'a Cushion,
    normal: Vec3,
    /// The direction in which the ball can be pushed.
    push: Vec3,
    /// The edge or wall that a ball off the bed touches; `None` for a ball on the bed.
    edge: Option<Edge>,
    is_liner: bool,
}

impl CushionImpact<'_> {
    /// The state after the impact, with the approach speed raised by `speed`, m/s.
    #[inline(always)]
    fn raised(&self, speed: f64, physics: &Physics) -> BallState {
        let mut body = Body::new(self.ball, self.before);
        body.velocity += self.push * speed;
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

/// The impact of two balls.
struct PairImpact<'a> {
    before: &'a [BallState; 2],
    balls: &'a [Ball; 2],
    law: &'a BallBall,
    on_bed: [bool; 2],
    /// Unit vector from the first ball's centre to the second's.
    normal: Vec3,
    /// The changes of the two velocities that raise the approach speed by 1 m/s; the second is
    /// subtracted.
    pushes: [Vec3; 2],
}

impl PairImpact<'_> {
    /// The states after the impact, with the approach speed raised by `speed`, m/s.
    #[inline(always)]
    fn raised(&self, speed: f64, physics: &Physics) -> [BallState; 2] {
        let Self { before, balls, law, on_bed, normal, pushes } = self;
        let mut p = Body::new(&balls[0], &before[0]);
        let mut q = Body::new(&balls[1], &before[1]);
        p.velocity += pushes[0] * speed;
        q.velocity -= pushes[1] * speed;
        let Physics { cloth, gravity, .. } = physics;
        let gentle = || {
            let approach = (p.velocity - q.velocity).dot(*normal);
            approach < ball_slate::last_hop_speed(*gravity)
        };
        // A ball on a rail's top does not come down on the other ball: it meets it like a ball on the
        // slate.
        let flies = before.map(|state| state.motion == MotionState::Airborne);
        match on_bed {
            [false, true] if flies[0] && gentle() => {
                let normal = unbalanced(*normal, &p, &q);
                held::resolve(law.restitution, normal, &mut p, &mut q);
            }
            [true, false] if flies[1] && gentle() => {
                let normal = unbalanced(-*normal, &q, &p);
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

/// Whether two balls slip so fast over each other that their friction is too weak to make up for
/// the energy of a hop: the measured friction falls with the speed of the slip.
#[cold]
fn is_slippery(law: &BallBall, normal: Vec3, states: &[BallState; 2], balls: &[Ball; 2]) -> bool {
    let [a, b] = [0, 1].map(|k| Body::new(&balls[k], &states[k]));
    law.friction.at(Contact::between(normal, &a, &b).slip_speed()) < SLIPPERY
}

/// A ball off the bed meets `edge`: it is pressed on the edge or bounces off it.
#[cold]
fn meet_edge(law: &Cushion, physics: &Physics, edge: &Edge, is_liner: bool, ball: Body) -> Body {
    if edge.presses(physics.gravity, &ball) {
        let (e, mu) = (law.restitution.at(0.0), law.friction.a);
        let surface = Surface::new(e, mu);
        let mut pressed = ball;
        ball_edge::resolve(&surface, physics.gravity, edge, &mut pressed);
        return pressed;
    }
    let bounce = |normal| {
        let mut bounced = ball;
        resolve::ball_cushion::resolve(law, &physics.cloth, normal, false, &mut bounced);
        bounced
    };
    if !is_liner || edge.normal.z != 0.0 {
        return bounce(edge.normal);
    }
    let bounced = bounce(leaning(edge.normal));
    // A ball that falls along the wall does not hit its slope.
    if bounced.velocity.dot(edge.normal) > 0.0 { bounce(edge.normal) } else { bounced }
}

/// The normal of a liner's leaning wall, given that of the upright wall.
fn leaning(normal: Vec3) -> Vec3 {
    let [sin, cos] = LINER_LEAN;
    (normal.xy() * cos).with_z(sin)
}

/// The line of centres from `flyer` to the ball below it. If it is nearly vertical and the two balls
/// do not move sideways past each other, it is inclined by [`BALANCE`].
fn unbalanced(normal: Vec3, flyer: &Body, below: &Body) -> Vec3 {
    let past = (flyer.velocity - below.velocity).xy();
    if normal.xy().length_squared() >= BALANCE * BALANCE
        || past.length_squared() >= MIN_SEPARATION * MIN_SEPARATION
    {
        return normal;
    }
    let leaning = Vec3::new(BALANCE, 0.0, normal.z);
    leaning * (1.0 / leaning.length())
}

/// The horizontal direction of `normal`.
fn horizontal(normal: Vec3) -> Vec3 {
    if normal.z == 0.0 {
        return normal;
    }
    let along = normal.xy();
    (along * (1.0 / along.length())).with_z(0.0)
}
