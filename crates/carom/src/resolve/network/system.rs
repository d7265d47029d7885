//! All bodies and contacts, and their integration in time.

use super::ball::Ball;
use super::grip::GripStep;
use super::link::{self, Block, LANES, Link, PerBall};
use super::spring::SpringState;
use super::step::{Bits, TimeStep};
use super::strike::Cue;
use super::{
    BALL_SLOTS, MOST_CONTACTS, NetworkImpact, NetworkScratch, STILL, Stepping, Units, WALL, larger,
    round_to_grid, smaller,
};
use crate::math::Vec3;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
use crate::math::has_wide_vectors;
use crate::physics::BallBall;
use crate::resolve::Body;

/// Number of steps after which the lines of centres are turned. The balls of a break turn a line
/// by 0.001 rad per step at most.
const STEPS_PER_TURN: usize = 4;

/// The lines of centres turn during at most this time without a force, in units of T: three times a
/// contact. The engine leaves the balls where they are, so a contact that takes place later must
/// not see them far away.
const LONGEST_DRIFT: f64 = 10.0;

/// The most passes that take the rest of the approach from bodies that touch.
const PARTING_PASSES: usize = 400;

/// The bits of one block in a set of contacts.
const LANE_BITS: u64 = (1 << LANES) - 1;

/// All bodies and contacts during the impact.
pub(super) struct Network<'a> {
    balls: &'a mut [Ball; BALL_SLOTS],
    /// The balls' velocities once more, for vector instructions.
    velocities: PerBall,
    /// Number of balls.
    size: usize,
    links: &'a mut [Link],
    /// The contacts' geometry and springs: contact k is in block k / [`LANES`].
    blocks: &'a mut [Block],
    cue: Option<&'a mut Cue>,
}

impl<'a> Network<'a> {
    /// The bodies and contacts of `impact` before it, in `scratch`.
    pub(super) fn new(
        impact: &NetworkImpact<'_>,
        bodies: &[Body],
        units: &Units,
        scratch: &'a mut NetworkScratch,
        cue: Option<&'a mut Cue>,
    ) -> Self {
        let NetworkImpact { law, touches, walls, .. } = *impact;
        let NetworkScratch { balls, links, blocks } = scratch;
        let mut velocities = [[0.0; BALL_SLOTS]; 3];
        let count = touches.len() + walls.len();
        balls.fill(Ball::default());
        let (links, blocks) = (&mut links[..count], &mut blocks[..count.div_ceil(LANES)]);
        blocks.fill(Block::NONE);
        for (k, (ball, body)) in balls.iter_mut().zip(bodies).enumerate() {
            ball.begin(body, units);
            set(&mut velocities, k, ball.velocity);
        }
        for (k, touch) in touches.iter().enumerate() {
            links[k] = blocks[k / LANES].join(k % LANES, touch, law, bodies, units);
        }
        for (k, wall) in (touches.len()..).zip(walls) {
            links[k] = blocks[k / LANES].join_wall(k % LANES, wall, bodies, units);
        }
        blocks.iter_mut().for_each(Block::set_tangents);
        for (k, link) in links.iter().enumerate() {
            balls[link.a].links |= 1 << k;
            if link.b != WALL {
                balls[link.b].links |= 1 << k;
            }
        }
        for link in links.iter_mut() {
            let most = balls[link.a].links.count_ones().max(balls[link.b].links.count_ones());
            link.share = 1.0 / f64::from(most);
        }
        Self { balls, velocities, size: bodies.len(), links, blocks, cue }
    }

    /// Integrates the impact until no contact carries a force and no two bodies that touched at the
    /// start approach. A gap that has not closed by then is left to a later impact.
    pub(super) fn integrate(&mut self, law: &BallBall, units: &Units, stepping: &Stepping) {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if has_wide_vectors() {
            // SAFETY: the processor has AVX2.
            #[allow(unsafe_code)]
            unsafe {
                self.integrate_avx2(law, units, stepping);
            }
            return;
        }
        self.integrate_plain(law, units, stepping);
    }

    /// The same bits as without AVX2: no operation is fused or reordered.
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[target_feature(enable = "avx2")]
    fn integrate_avx2(&mut self, law: &BallBall, units: &Units, stepping: &Stepping) {
        self.integrate_plain(law, units, stepping);
    }

    #[inline(always)]
    fn integrate_plain(&mut self, law: &BallBall, units: &Units, stepping: &Stepping) {
        let mut step = TimeStep::first(units, stepping, self.greatest_square());
        // Forces act in the middle of a step.
        let mut drift = 0.5 * step.length;
        // Sets of contacts, one bit each: those of balls that have moved, and those that carried a
        // force in the last step. The others cannot change.
        let (mut active, mut loaded) = (self.approaching(), 0_u64);
        let most = (MOST_CONTACTS * stepping.steps_per_contact) as usize;
        let (mut now, mut until_turn) = (0.0, 0);
        for _ in 0..most {
            now += smaller(drift, LONGEST_DRIFT);
            if until_turn == 0 {
                self.turn(active, now, 0.5 * (STEPS_PER_TURN - 1) as f64 * step.length);
                until_turn = STEPS_PER_TURN;
            }
            until_turn -= 1;
            // The balls with an impulse, one bit each.
            let mut struck = 0_u32;
            let mut greatest_square = 0.0;
            let last_loaded = core::mem::take(&mut loaded);
            for (index, block) in self.blocks.iter_mut().enumerate() {
                let first = index * LANES;
                if active >> first & LANE_BITS == 0 {
                    continue;
                }
                let velocity = block.velocity(&self.velocities);
                let approach = block.approach(&velocity);
                let now =
                    block.springs.advance(approach, drift, &step, stepping, &mut greatest_square);
                for lane in Bits(now.loaded()) {
                    let Some(link) = self.links.get_mut(first + lane) else { break };
                    let lane = lane % LANES;
                    let steady = last_loaded >> (first + lane) & 1 != 0;
                    let normal =
                        block.springs.impulse(lane, steady, &now, &step, &mut greatest_square);
                    if normal == 0.0 {
                        continue;
                    }
                    let a = self.balls[link.a % BALL_SLOTS].surface;
                    let b = self.balls[link.b % BALL_SLOTS].surface;
                    let (push, turn) = link.grip.impulse(&GripStep {
                        directions: block.directions(lane),
                        velocity: link::vector(&velocity, lane),
                        surface: a + b,
                        normal,
                        spring: block.springs.at(lane),
                        steady,
                        time: step.length,
                        law: &law.friction,
                        speed_unit: step.speed,
                    });
                    let (push, turn) = (round_to_grid(push), round_to_grid(turn));
                    loaded |= 1 << (first + lane);
                    struck |= link.both;
                    let a = &mut self.balls[link.a % BALL_SLOTS];
                    a.push -= push;
                    a.turn += turn;
                    let b = &mut self.balls[link.b % BALL_SLOTS];
                    b.push += push;
                    b.turn += turn;
                }
            }
            if let Some(cue) = &mut self.cue {
                let met = |k: usize| {
                    self.links[k].has_gap
                        && self.blocks[k / LANES].springs.at(k % LANES).has_touched
                };
                let ball = &mut self.balls[cue.ball % BALL_SLOTS];
                let (velocity, surface) = (ball.velocity, ball.surface);
                let impulse =
                    cue.impulse(velocity, surface, drift, &step, stepping, &mut greatest_square);
                if impulse != 0.0 {
                    cue.pushes = cue.pushes || Bits(ball.links).any(met);
                    ball.push += round_to_grid(cue.launch * impulse);
                    ball.turn -= round_to_grid(cue.twist * impulse);
                    struck |= 1 << cue.ball;
                }
            }
            let last = step.length;
            step.adapt(greatest_square);
            if struck != 0 {
                drift = 0.5 * (last + step.length);
                for k in Bits(u64::from(struck)) {
                    let ball = &mut self.balls[k % BALL_SLOTS];
                    active |= ball.update(now);
                    set(&mut self.velocities, k, ball.velocity);
                }
                continue;
            }
            let Some(wait) = self.wait(active) else { return };
            drift = wait + 0.5 * step.length;
            until_turn = 0;
        }
    }

    /// The largest (speed)² of the approaches, for the choice of steps.
    fn greatest_square(&self) -> f64 {
        let links = self.blocks.iter().map(|block| block.springs.square_speed());
        links.chain(self.cue.as_ref().map(|cue| cue.spring.square_speed())).fold(0.0, larger)
    }

    /// Set of the contacts whose bodies approach or separate, one bit each.
    fn approaching(&self) -> u64 {
        let mut set = 0;
        for k in 0..self.links.len() {
            set |= u64::from(self.spring(k).approach != 0.0) << k;
        }
        set
    }

    /// The spring of contact k.
    fn spring(&self, k: usize) -> SpringState {
        self.blocks[k / LANES].springs.at(k % LANES)
    }

    /// Turns the lines of centres of the `active` contacts to where they are `ahead` of the time
    /// `now`.
    #[inline(always)]
    fn turn(&mut self, active: u64, now: f64, ahead: f64) {
        let mut shifts = [[0.0; BALL_SLOTS]; 3];
        for (k, ball) in self.balls[..self.size].iter().enumerate() {
            set(&mut shifts, k, ball.shift_at(now));
        }
        for (index, block) in self.blocks.iter_mut().enumerate() {
            if active >> (index * LANES) & LANE_BITS != 0 {
                block.turn(&self.velocities, &shifts, ahead);
            }
        }
    }

    /// The time until the next contact, while no contact carries a force; `None` if the impact is
    /// over.
    fn wait(&self, active: u64) -> Option<f64> {
        let springs = Bits(active).map(|k| self.spring(k));
        let springs = springs.chain(self.cue.as_ref().map(|cue| cue.spring.at(0)));
        let (mut wait, mut goes_on) = (f64::INFINITY, false);
        for spring in springs {
            let time = spring.time_to_contact();
            goes_on |= spring.has_touched && time < f64::INFINITY;
            wait = smaller(time, wait);
        }
        goes_on.then_some(wait)
    }

    /// Applies the changes of the impact to the balls, scaled so that the energy does not rise.
    /// Returns the scale.
    pub(super) fn apply(
        &self,
        impact: &NetworkImpact<'_>,
        units: &Units,
        bodies: &mut [Body],
    ) -> f64 {
        // Scaled by λ, the changes alter the energy by −λ·work + λ²·cost. Without walls, velocities
        // are relative to one of the balls, because a common velocity would add rounding error.
        let alone = impact.walls.is_empty() && impact.tip.is_none();
        let frame = if alone { self.balls[0].first_velocity } else { Vec3::ZERO };
        let (mut work, mut cost) = (0.0, 0.0);
        for ball in &self.balls[..bodies.len()] {
            let (lost, gained) = ball.work_and_cost(frame);
            work += lost;
            cost += gained;
        }
        if let Some(cue) = &self.cue {
            let (lost, gained) = cue.work_and_cost();
            work += lost;
            cost += gained;
        }
        let law = impact.law;
        let lossless = alone && law.restitution == 1.0 && law.is_smooth();
        let share = if cost > work || lossless { (work / cost).clamp(0.0, 2.0) } else { 1.0 };
        for (ball, body) in self.balls.iter().zip(bodies) {
            ball.apply(share, units, body);
        }
        share
    }

    /// Takes the rest of their approach from bodies that have touched. It is measured along the lines
    /// of centres at the start, because the balls stay where they were: two balls that separate along
    /// a line that has turned may approach along that one. All contacts act at once in each pass, so
    /// that their order does not matter.
    pub(super) fn part(&self, units: &Units, bodies: &mut [Body]) {
        let least = STILL * units.speed;
        for _ in 0..PARTING_PASSES {
            let mut pushes = [Vec3::ZERO; BALL_SLOTS];
            let mut parted = true;
            for (k, link) in self.links.iter().enumerate() {
                let spring = self.spring(k);
                if !spring.has_touched {
                    continue;
                }
                let normal = self.blocks[k / LANES].first_normal(k % LANES);
                let b = if link.b == WALL { Vec3::ZERO } else { bodies[link.b].velocity };
                let approach = (bodies[link.a].velocity - b).dot(normal);
                if approach > least {
                    let push = normal * (approach * link.share * spring.mass);
                    pushes[link.a] -= push;
                    pushes[link.b] += push;
                    parted = false;
                }
            }
            if parted {
                return;
            }
            for ((body, ball), push) in bodies.iter_mut().zip(self.balls.iter()).zip(pushes) {
                if push != Vec3::ZERO {
                    body.velocity += push * ball.mobility;
                }
            }
        }
    }
}

/// Sets the vector of a ball.
#[inline(always)]
fn set(vectors: &mut PerBall, ball: usize, vector: Vec3) {
    let k = ball % BALL_SLOTS;
    (vectors[0][k], vectors[1][k], vectors[2][k]) = (vector.x, vector.y, vector.z);
}
