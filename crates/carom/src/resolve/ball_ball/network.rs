//! Balls that touch each other when one of them is struck: all their contacts act at once.
//!
//! No law of restitution knows what comes out of three balls in a row: rigid bodies leave it
//! undetermined, and taking the pairs one after another makes the result depend on their order.
//! What decides is how the balls yield (Alciatore, TP B.29). So here the impact is followed in
//! time, with the positions fixed and every contact a spring:
//!
//! * **Along the normal** Hertz's force F = k·δ^(3/2), k = (4/3)E*·√(R₁R₂/(R₁+R₂)). While the
//!   contact opens it returns e² times that, so that a pair alone parts with e times its approach
//!   speed. e is the law's, at the fastest approach that the contact has seen
//!   ([`restitution::effective`]).
//! * **Across it** friction: at most μF, against the slip **u** of a's surface over b's (as in
//!   [`contact`](super::contact)), μ at the fastest slip that the contact has seen. In the rigid
//!   models it stops the slip. For the `compliant` model it is a spring too, which yields where μF
//!   holds it no longer and loses its part of what it stores as the contact opens. Its stiffness is
//!   (5/4)(ω_t/ω_n)²·(2/7) times F/δ: during a pair's contact it then swings as far as Stronge's
//!   linear springs do, at any speed (the phase of √(7/2·k_t/m*) is π·ω_t/ω_n).
//!   `mathavan-2014` acts as `frictional` does: its friction of the cloth has no many-ball form.
//!
//! A pair alone never comes here ([`super::resolve`] is its law). If it did, it would leave with
//! the law's restitution and rigid friction to 3e-3 of its approach speed; `compliant` balls would
//! be thrown as by their law to 0.4°.
//!
//! **Units.** Balls that touch come out the same whatever the modulus E* is, and their speeds grow
//! with that of the impact: the equations are solved in units of the fastest approach V, the
//! heaviest ball, and the time T = (m*²/(k²V))^(1/5) of the stiffest pair (a pair's contact lasts
//! 3.21 T). E* matters only where gaps have to close first.
//!
//! **What is conserved.** Impulses are kept on a grid ([`GRID`]), on which sums are exact: their
//! order does not matter, mirrored ones cancel to the bit, and both balls of a contact get the
//! same. The steps keep the energy to about 1e-4; what they would gain is taken back by
//! scaling the whole change, and an impact without losses is scaled to lose nothing.

use super::contact::TANGENT_COMPLIANCE;
use crate::math::{Vec2, Vec3, pow, sqrt};
use crate::physics::{BallBall, BallBallModel};
use crate::resolve::{Body, SPIN_PER_IMPULSE, restitution};
use crate::table::TOUCH_TOLERANCE;

/// Most balls in a network.
pub const MAX_BODIES: usize = 24;

/// Most contacts: as many equal balls on a table have ⌊3n − √(12n − 3)⌋ = 55 (Harborth 1974). The
/// rest is left to a next impact, at the same instant.
pub const MAX_CONTACTS: usize = 64;

/// More than [`MAX_BODIES`]: an index modulo a power of two needs no check.
const BITS: usize = 32;

/// E* = E/(2(1 − ν²)) of ball material, Pa: 2270 N press two 2¼ in balls together by 0.2 mm
/// (Alciatore, TP B.29).
pub const CONTACT_MODULUS: f64 = 5.04e9;

/// A pair's contact is followed in about this many steps: rows of up to eight balls then leave
/// within 6e-4 of the speed of the first from what they do in the limit.
const STEPS_PER_CONTACT: f64 = 11.0;

/// How far ahead the force of a step is taken, in parts of (step)²·(acceleration): what cancels
/// most of the leapfrog's error (Takahashi & Imada 1984). It is 1/12 for small steps; for steps as
/// long as these, this leaves the least error in rows of three to eight balls.
const AHEAD: f64 = 0.065;

/// The acceleration of a step is that of the last one and this many times its change since the one
/// before. It is 1 for small steps, and chosen like [`AHEAD`].
const TREND: f64 = 1.25;

/// Duration of a pair's Hertz contact, in units of (m*²/(k²V))^(1/5).
const CONTACT_TIME: f64 = 3.21;

/// Steps at most. A frozen rack needs a few hundred; what still approaches after these is the next
/// impact, at the same instant.
const MAX_STEPS: usize = 4000;

/// x + `GRID` − `GRID` is x on a grid of 2⁻⁴⁴ (for |x| < 128): sums of such numbers are exact up to
/// 512, and so are the same in any order. The unit is the momentum of the heaviest ball at the
/// fastest approach.
const GRID: f64 = 384.0;

/// The steps grow as the impact fades, like the duration of a contact, with (speed)^(−1/5): when the
/// square of the fastest approach has fallen to this part,
const RELAXED: f64 = 0.5;

/// by this factor: [`RELAXED`]^(−1/10).
const LONGER: f64 = 1.071_773_5;

/// μ is found anew when the slip has grown by this part of the fastest approach.
const SLIP_STEP: f64 = 1.0 / 64.0;

/// Two balls that approach slower than this part of the fastest approach are done with: they have
/// no weight on the grid.
const STILL: f64 = 1e-9;

/// Two balls that touch.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// Index of the first ball.
    pub a: u8,
    /// Index of the second ball.
    pub b: u8,
    /// Unit vector from a's centre to b's.
    pub normal: Vec3,
    /// Distance of the surfaces, m.
    pub gap: f64,
}

/// Resolves the impact of balls that touch. Returns whether there is one: `false`, and nothing is
/// changed, if no two of them approach. Balls that nothing reaches keep their very bits.
///
/// `bodies` are at most [`MAX_BODIES`], and of `touches` the first [`MAX_CONTACTS`] count.
pub fn resolve(law: &BallBall, bodies: &mut [Body], touches: &[Touch]) -> bool {
    let touches = &touches[..touches.len().min(MAX_CONTACTS)];
    let Some(units) = Units::of(bodies, touches) else { return false };
    let mut balls = [Ball::default(); BITS];
    let mut links = [Link::default(); MAX_CONTACTS];
    for (ball, body) in balls.iter_mut().zip(bodies.iter()) {
        ball.mobility = units.mass / body.mass;
    }
    for (k, touch) in touches.iter().enumerate() {
        links[k] = Link::new(touch, bodies, &units);
        balls[usize::from(touch.a)].links |= 1 << k;
        balls[usize::from(touch.b)].links |= 1 << k;
    }
    for link in &mut links[..touches.len()] {
        let most = balls[link.a].links.count_ones().max(balls[link.b].links.count_ones());
        link.share = 1.0 / f64::from(most);
    }
    if law.is_smooth() {
        follow::<SMOOTH>(law, &units, &mut balls, &mut links);
    } else if law.model == BallBallModel::Compliant {
        follow::<SPRUNG>(law, &units, &mut balls, &mut links);
    } else {
        follow::<RIGID>(law, &units, &mut balls, &mut links);
    }
    apply(law, &units, &balls[..bodies.len()], bodies);
    true
}

/// The units of an impact.
struct Units {
    /// Fastest approach V, m/s.
    speed: f64,
    /// Heaviest ball, kg.
    mass: f64,
    /// T, s.
    time: f64,
}

impl Units {
    /// `None` if nothing approaches.
    fn of(bodies: &[Body], touches: &[Touch]) -> Option<Self> {
        let (mut speed, mut rate) = (0.0_f64, 0.0_f64);
        for touch in touches {
            let (a, b) = touch.bodies(bodies);
            speed = speed.max((a.velocity - b.velocity).dot(touch.normal));
            rate = rate.max(stiffness(a, b) * (1.0 / a.mass + 1.0 / b.mass));
        }
        let mass = bodies.iter().fold(0.0_f64, |most, body| most.max(body.mass));
        (speed > 0.0).then(|| Self { speed, mass, time: pow(rate * rate * speed, -0.2) })
    }

    fn length(&self) -> f64 {
        self.speed * self.time
    }
}

impl Touch {
    fn bodies<'a>(&self, bodies: &'a [Body]) -> (&'a Body, &'a Body) {
        (&bodies[usize::from(self.a)], &bodies[usize::from(self.b)])
    }
}

/// Hertz's k of two balls, N/m^(3/2).
fn stiffness(a: &Body, b: &Body) -> f64 {
    4.0 / 3.0 * CONTACT_MODULUS * sqrt(a.radius * b.radius / (a.radius + b.radius))
}

/// What the impact has done to a ball so far.
#[derive(Clone, Copy, Default)]
#[repr(align(128))]
struct Ball {
    /// Impulse.
    push: Vec3,
    /// Σ n × (impulse on the second ball of the contact): it turns both balls the same way.
    turn: Vec3,
    /// Change of velocity.
    velocity: Vec3,
    /// Change of the surface's speed Rω.
    surface: Vec3,
    /// 1/mass.
    mobility: f64,
    /// Its contacts, one bit each.
    links: u64,
}

/// A contact as it goes on.
#[derive(Clone, Copy, Default)]
struct Link {
    a: usize,
    b: usize,
    /// The two, one bit each; there are at most [`MAX_BODIES`], fewer than 32.
    both: u32,
    normal: Vec3,
    across: Across,
    /// Approach speed and slip at the start.
    approach: f64,
    slip: Vec2,
    /// k.
    stiffness: f64,
    /// m* and 1/m*.
    mass: f64,
    mobility: f64,
    /// Part of a slip that one step may stop: one over the most contacts of its balls.
    share: f64,
    /// δ, negative where there is a gap.
    depth: f64,
    /// Whether there was no gap at the start.
    touches: bool,
    /// The approach now, and what the last step has changed it by.
    now: f64,
    speedup: f64,
    /// Whether it pressed at the last step.
    presses: bool,
    /// The fastest approach so far.
    fastest: f64,
    /// μ at the fastest slip so far, and the square up to which that holds.
    friction: f64,
    known_slip: f64,
    /// Friction on b, and the stiffness of its spring, at the last step in which they pressed.
    pull: Vec2,
    pull_spring: f64,
}

impl Link {
    fn new(touch: &Touch, bodies: &[Body], units: &Units) -> Self {
        let (a, b) = touch.bodies(bodies);
        let (n, per_speed) = (touch.normal, 1.0 / units.speed);
        let velocity = (a.velocity - b.velocity) * per_speed;
        let surface = (a.angular_velocity * a.radius + b.angular_velocity * b.radius) * per_speed;
        let approach = velocity.dot(n);
        let length = units.length();
        let across = Across::of(n);
        let mobility = units.mass / a.mass + units.mass / b.mass;
        Self {
            a: usize::from(touch.a),
            b: usize::from(touch.b),
            both: 1 << touch.a | 1 << touch.b,
            normal: n,
            across,
            approach,
            now: approach,
            slip: across.slip(velocity, surface),
            stiffness: stiffness(a, b) * sqrt(length) * units.time * units.time / units.mass,
            mass: 1.0 / mobility,
            mobility,
            share: 1.0,
            depth: (-touch.gap / length).min(0.0),
            touches: touch.gap <= TOUCH_TOLERANCE,
            ..Self::default()
        }
    }
}

/// Two unit vectors in the tangent plane, with **n** × the first = the second.
#[derive(Clone, Copy, Default)]
struct Across {
    /// Horizontal.
    first: Vec2,
    second: Vec3,
}

impl Across {
    fn of(normal: Vec3) -> Self {
        let level = normal.xy();
        let length = level.length();
        let first = if length > 0.0 { level.perp() * (1.0 / length) } else { Vec2::new(1.0, 0.0) };
        Self { first, second: normal.cross(first.with_z(0.0)) }
    }

    /// The components of the slip: of what the first ball's centre moves at over the second's, and of
    /// the sum of their Rω.
    #[inline(always)]
    fn slip(&self, velocity: Vec3, surface: Vec3) -> Vec2 {
        let Self { first, second } = *self;
        Vec2::new(
            velocity.xy().dot(first) + surface.dot(second),
            velocity.dot(second) - surface.xy().dot(first),
        )
    }

    /// The vector with these components.
    #[inline(always)]
    fn vector(&self, x: f64, y: f64) -> Vec3 {
        let level = self.first * x + self.second.xy() * y;
        level.with_z(self.second.z * y)
    }
}

/// How friction holds: not at all, by stopping the slip, or by a spring.
const SMOOTH: u8 = 0;
const RIGID: u8 = 1;
const SPRUNG: u8 = 2;

/// Follows the impact to its end: no contact carries force and no two balls that touched approach.
/// A gap that has not closed by then is left to a later impact.
fn follow<const GRIP: u8>(
    law: &BallBall,
    units: &Units,
    balls: &mut [Ball; BITS],
    links: &mut [Link; MAX_CONTACTS],
) {
    let mut step = Step::first(units);
    // Forces act in the middle of a step.
    let mut drift = 0.5 * step.length;
    // The contacts of balls that have moved, one bit each: nothing happens in the others.
    let mut stirred = 0_u64;
    for (k, link) in links.iter().enumerate() {
        stirred |= u64::from(link.approach != 0.0) << k;
    }
    for _ in 0..MAX_STEPS {
        let (mut pushed, mut meeting, mut liveliest) = (0_u32, f64::INFINITY, 0.0);
        let ahead = AHEAD * step.length;
        for k in Bits(stirred) {
            let link = &mut links[k];
            let (a, b) = (&balls[link.a % BITS], &balls[link.b % BITS]);
            let velocity = a.velocity - b.velocity;
            let approach = link.approach + velocity.dot(link.normal);
            let (speedup, last) = (approach - link.now, link.speedup);
            (link.now, link.speedup) = (approach, speedup);
            link.depth += approach * drift;
            let depth = link.depth + ahead * (speedup + TREND * (speedup - last));
            if depth <= 0.0 {
                link.presses = false;
                if approach > STILL {
                    liveliest = larger(liveliest, approach * approach);
                    if link.touches {
                        let time = larger(-link.depth, 0.0) / approach;
                        meeting = if time < meeting { time } else { meeting };
                    }
                }
                continue;
            }
            let spring = link.stiffness * sqrt(depth);
            let tension = 0.8 * spring * link.mobility * depth * depth;
            liveliest = larger(liveliest, approach * approach + tension);
            let normal = link.press(law, &step, approach, spring * depth);
            if normal == 0.0 {
                continue;
            }
            let mut push = link.normal * normal;
            let mut turn = Vec3::ZERO;
            if GRIP != SMOOTH {
                let slip = link.slip + link.across.slip(velocity, a.surface + b.surface);
                let friction = link.rub::<GRIP>(law, &step, slip, normal, spring);
                push += link.across.vector(friction.x, friction.y);
                turn = snap(link.across.vector(-friction.y, friction.x));
            }
            let push = snap(push);
            pushed |= link.both;
            let a = &mut balls[link.a % BITS];
            a.push -= push;
            a.turn += turn;
            let b = &mut balls[link.b % BITS];
            b.push += push;
            b.turn += turn;
        }
        let last = step.length;
        step.adapt(liveliest);
        if pushed != 0 {
            drift = 0.5 * (last + step.length);
            for k in Bits(u64::from(pushed)) {
                stirred |= balls[k % BITS].move_on();
            }
        } else if meeting < f64::INFINITY {
            drift = meeting + 0.5 * step.length;
        } else {
            return;
        }
    }
}

/// The places of the bits that are set, from the lowest.
struct Bits(u64);

impl Iterator for Bits {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let place = self.0.trailing_zeros();
        if place == u64::BITS {
            return None;
        }
        self.0 &= self.0 - 1;
        Some(place as usize)
    }
}

/// One step in time.
struct Step {
    /// In units of T.
    length: f64,
    /// (Speed)² for which it was chosen.
    liveliness: f64,
    /// The unit of speed, m/s.
    speed: f64,
}

impl Step {
    fn first(units: &Units) -> Self {
        let length = CONTACT_TIME / STEPS_PER_CONTACT;
        Self { length, liveliness: 1.0, speed: units.speed }
    }

    /// Grows a little where the impact fades, and shrinks at once where it becomes livelier.
    #[inline(always)]
    fn adapt(&mut self, liveliest: f64) {
        if liveliest < RELAXED * self.liveliness {
            self.liveliness *= RELAXED;
            self.length *= LONGER;
        }
        while liveliest > self.liveliness {
            self.liveliness *= 1.0 / RELAXED;
            self.length *= 1.0 / LONGER;
        }
    }
}

impl Ball {
    /// Finds the velocities anew after a push; returns the contacts that this stirs.
    #[inline(always)]
    fn move_on(&mut self) -> u64 {
        self.velocity = self.push * self.mobility;
        self.surface = self.turn * (-SPIN_PER_IMPULSE * self.mobility);
        self.links
    }
}

impl Link {
    /// The normal impulse of one step, `force` being that of a contact that closes.
    #[inline(always)]
    fn press(&mut self, law: &BallBall, step: &Step, approach: f64, force: f64) -> f64 {
        let full = force * step.length;
        self.fastest = larger(approach, self.fastest);
        // What it takes to stop the approach: then the contact begins to open.
        let stopping = approach * self.mass;
        if stopping >= full {
            return full;
        }
        let e = restitution::effective(law.restitution, self.fastest * step.speed);
        let open = e * e;
        full * open + larger(stopping, 0.0) * (1.0 - open)
    }

    /// The friction impulse of one step on b, `spring` being F/δ.
    #[inline(always)]
    fn rub<const GRIP: u8>(
        &mut self,
        law: &BallBall,
        step: &Step,
        slip: Vec2,
        normal: f64,
        spring: f64,
    ) -> Vec2 {
        let square = slip.length_squared();
        if square > self.known_slip {
            let speed = sqrt(square);
            self.friction = law.friction.at(speed * step.speed);
            let known = speed + SLIP_STEP;
            self.known_slip = known * known;
        }
        let most = self.friction * normal;
        let impulse = if GRIP == RIGID {
            slip * (self.share * self.mass / TANGENT_COMPLIANCE)
        } else {
            let ratio = law.frequency_ratio;
            let spring = (1.25 / TANGENT_COMPLIANCE) * ratio * ratio * spring;
            if !self.presses {
                self.pull = Vec2::ZERO;
            } else if spring < self.pull_spring {
                self.pull = self.pull * (spring / self.pull_spring);
            }
            self.presses = true;
            self.pull_spring = spring;
            self.pull += slip * (spring * step.length);
            self.pull * step.length
        };
        let square = impulse.length_squared();
        if square <= most * most {
            return impulse;
        }
        let held = most / sqrt(square);
        self.pull = self.pull * held;
        impulse * held
    }
}

/// Gives the balls what the impact has done to them, as much of it as raises no energy.
fn apply(law: &BallBall, units: &Units, balls: &[Ball], bodies: &mut [Body]) {
    // Of the share λ the energy takes −λ·work + λ²·cost. Velocities are relative to one of the
    // balls, so that one they share does not drown the rest in rounding.
    let (mut work, mut cost) = (0.0, 0.0);
    let frame = bodies[0].velocity;
    for (ball, body) in balls.iter().zip(&*bodies) {
        let (velocity, surface) = (body.velocity - frame, body.angular_velocity * body.radius);
        work += (surface.dot(ball.turn) - velocity.dot(ball.push)) / units.speed;
        let energy = ball.velocity.length_squared() + 0.4 * ball.surface.length_squared();
        cost += 0.5 * energy / ball.mobility;
    }
    let lossless = law.restitution == 1.0 && law.is_smooth();
    let share = if cost > work || lossless { (work / cost).clamp(0.0, 2.0) } else { 1.0 };
    for (ball, body) in balls.iter().zip(bodies) {
        if ball.push != Vec3::ZERO || ball.turn != Vec3::ZERO {
            body.velocity += ball.velocity * (share * units.speed);
            body.angular_velocity += ball.surface * (share * units.speed / body.radius);
        }
    }
}

/// One instruction, where `f64::max` takes several for what is not a number.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

fn snap(v: Vec3) -> Vec3 {
    let snap = |x: f64| (x + GRID) - GRID;
    Vec3::new(snap(v.x), snap(v.y), snap(v.z))
}
