//! Balls that touch each other when one of them is hit: all their contacts act at once.
//!
//! A law of restitution does not determine the result for three balls in a row: for rigid bodies it
//! is undetermined, and resolving the pairs one after another makes the result depend on their
//! order. The result depends on how the balls deform (Alciatore, TP B.29). So the impact is
//! integrated in time, with fixed positions and a spring for every contact:
//!
//! * **Along the normal** Hertz's force F = k·δ^(3/2), k = (4/3)E*·√(R₁R₂/(R₁+R₂)). While a contact
//!   opens, its force is e² times as large, so that a pair alone separates with e times its
//!   approach speed. e is the law's restitution at the fastest approach that the contact has had
//!   ([`restitution::effective`]).
//! * **Tangentially** friction of at most μF against the slip **u** of a's surface over b's (as in
//!   [`contact`](super::contact)), μ being that of the fastest slip that the contact has had. In
//!   the rigid models friction stops the slip. In the `compliant` model it is a spring as well: it
//!   slides where μF is too small to hold it, and loses its part of the stored energy as the
//!   contact opens. Its stiffness is (5/4)(ω_t/ω_n)²·(2/7) times F/δ. During a pair's contact it
//!   then oscillates through the same phase as Stronge's linear springs, at any speed (the phase of
//!   √(7/2·k_t/m*) is π·ω_t/ω_n). `mathavan-2014` is treated like `frictional`, because its
//!   friction of the cloth has no form for many balls.
//!
//! A pair alone is resolved by its own law ([`super::resolve`]), not here. If it were resolved
//! here, the result would agree with the law's restitution and rigid friction to 3e-3 of the
//! approach speed, and the throw of `compliant` balls with their law to 0.4°.
//!
//! **Units.** The equations are solved in units of the fastest approach speed V, the heaviest
//! ball's mass and the time T = (m*²/(k²V))^(1/5) of the stiffest pair (a pair's contact lasts 3.21
//! T). For balls that touch at the start, the result does not depend on the modulus E*, and the
//! velocities are proportional to the speed of the impact. E* matters only where gaps have to close
//! first.
//!
//! **Conservation.** Impulses are rounded to a grid ([`GRID`]) on which sums are exact. So their
//! order does not matter, mirrored impulses cancel to the bit, and both balls of a contact receive
//! the same impulse. The steps conserve the energy to about 1e-4. If they would gain energy, the
//! whole change of velocity is scaled down; an impact without losses is scaled to conserve the
//! energy.

use super::contact::TANGENT_COMPLIANCE;
use crate::math::{Vec2, Vec3, pow, sqrt};
use crate::physics::{BallBall, BallBallModel};
use crate::resolve::{Body, SPIN_PER_IMPULSE, restitution};
use crate::table::TOUCH_TOLERANCE;

/// The most balls in a network.
pub const MAX_BODIES: usize = 24;

/// The most contacts in a network. [`MAX_BODIES`] equal balls in a plane have at most
/// ⌊3n − √(12n − 3)⌋ = 55 contacts (Harborth 1974). Any others are resolved in a further impact at
/// the same instant.
pub const MAX_CONTACTS: usize = 64;

/// Length of the array of balls: at least [`MAX_BODIES`], and a power of two, so that an index
/// modulo this number needs no bounds check.
const BALL_SLOTS: usize = 32;

/// E* = E/(2(1 − ν²)) of ball material, Pa: 2270 N compress two 2¼ in balls by 0.2 mm
/// (Alciatore, TP B.29).
pub const CONTACT_MODULUS: f64 = 5.04e9;

/// Duration of a pair's Hertz contact, in units of (m*²/(k²V))^(1/5).
const CONTACT_TIME: f64 = 3.21;

/// The most steps of an impact. A frozen rack needs a few hundred. Balls that still approach after
/// that meet again in a further impact at the same instant.
const MAX_STEPS: usize = 4000;

/// x + `GRID` − `GRID` rounds x to a grid of 2⁻⁴⁴ (for |x| < 128). Sums of such numbers are exact
/// up to 512, so their order does not matter. The unit is the momentum of the heaviest ball at the
/// fastest approach.
const GRID: f64 = 384.0;

/// As the impact fades, contacts last longer, in proportion to (speed)^(−1/5). The steps grow in
/// the same way: each time the square of the fastest approach has fallen to this fraction, they
/// grow by the factor [`LONGER`].
const RELAXED: f64 = 0.5;

/// Growth of a step: [`RELAXED`]^(−1/10).
const LONGER: f64 = 1.071_773_5;

/// μ is computed again when the slip has grown by this fraction of the fastest approach.
const SLIP_STEP: f64 = 1.0 / 64.0;

/// An approach slower than this fraction of the fastest approach counts as 0.
const STILL: f64 = 1e-9;

/// How the impact is integrated. The leapfrog method places forces in the middle of steps;
/// evaluating each force at an extrapolated position cancels most of its error (Takahashi & Imada
/// 1984).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepping {
    /// Number of steps in the contact of a pair alone.
    pub steps_per_contact: f64,
    /// How far ahead a force is evaluated, as a multiple of (step)²·(acceleration); 1/12 is best
    /// for small steps.
    pub ahead: f64,
    /// The acceleration is extrapolated: the last one plus this multiple of its last change; 1 is
    /// best for small steps.
    pub trend: f64,
}

impl Stepping {
    /// The steps of [`resolve`]. The velocities of rows of three to eight balls then differ by less
    /// than 9e-4 of the first ball's speed from the limit of small steps. `ahead` and `trend` were
    /// chosen for these long steps: the example `network_step_choice` computes the errors around
    /// them. Longer steps, or other values of the two, and that error grows.
    pub const CHOSEN: Self = Self { steps_per_contact: 11.0, ahead: 0.065, trend: 1.25 };
}

/// A pair of balls that touch.
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

/// Resolves the impact of balls that touch. Returns `false`, and changes nothing, if no two of them
/// approach. Balls that the impact does not reach keep their exact bits.
///
/// There are at most [`MAX_BODIES`] `bodies`; only the first [`MAX_CONTACTS`] of `touches` are
/// used.
pub fn resolve(law: &BallBall, bodies: &mut [Body], touches: &[Touch]) -> bool {
    resolve_in_steps(law, bodies, touches, &Stepping::CHOSEN)
}

/// [`resolve`] with other steps than the engine's, for studies of their accuracy.
#[inline]
pub fn resolve_in_steps(
    law: &BallBall,
    bodies: &mut [Body],
    touches: &[Touch],
    stepping: &Stepping,
) -> bool {
    let touches = &touches[..touches.len().min(MAX_CONTACTS)];
    let Some(units) = Units::of(bodies, touches) else { return false };
    let mut balls = [BallChange::default(); BALL_SLOTS];
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
        integrate::<SMOOTH>(law, &units, stepping, &mut balls, &mut links);
    } else if law.model == BallBallModel::Compliant {
        integrate::<SPRUNG>(law, &units, stepping, &mut balls, &mut links);
    } else {
        integrate::<RIGID>(law, &units, stepping, &mut balls, &mut links);
    }
    apply(law, &units, &balls[..bodies.len()], bodies);
    true
}

/// The units of one impact.
struct Units {
    /// Fastest approach V, m/s.
    speed: f64,
    /// Heaviest ball, kg.
    mass: f64,
    /// T, s.
    time: f64,
}

impl Units {
    /// `None` if no pair approaches.
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

/// The change of a ball's motion by the impact so far.
#[derive(Clone, Copy, Default)]
#[repr(align(128))]
struct BallChange {
    /// Impulse.
    push: Vec3,
    /// Σ n × (impulse on the second ball of the contact). It turns both balls in the same sense.
    turn: Vec3,
    /// Change of velocity.
    velocity: Vec3,
    /// Change of the surface velocity Rω.
    surface: Vec3,
    /// 1/mass.
    mobility: f64,
    /// Set of its contacts, one bit each.
    links: u64,
}

/// The state of a contact during the impact.
#[derive(Clone, Copy, Default)]
struct Link {
    a: usize,
    b: usize,
    /// Set of `a` and `b`, one bit each.
    both: u32,
    normal: Vec3,
    tangents: TangentBasis,
    /// Approach speed and slip at the start.
    approach: f64,
    slip: Vec2,
    /// k.
    stiffness: f64,
    /// m* and 1/m*.
    mass: f64,
    mobility: f64,
    /// The fraction of a slip that one step may stop: 1 / (number of contacts of the ball that has
    /// more).
    share: f64,
    /// δ, negative where there is a gap.
    depth: f64,
    /// Whether there was no gap at the start.
    touches: bool,
    /// The present approach speed, and its change in the last step.
    now: f64,
    speedup: f64,
    /// Whether the contact carried a force in the last step.
    presses: bool,
    /// The fastest approach speed so far.
    fastest: f64,
    /// μ at the fastest slip so far, and the square of the slip up to which it is valid.
    friction: f64,
    known_slip: f64,
    /// Friction on b, and the stiffness of its spring, in the last step with a force.
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
        let tangents = TangentBasis::of(n);
        let mobility = units.mass / a.mass + units.mass / b.mass;
        Self {
            a: usize::from(touch.a),
            b: usize::from(touch.b),
            both: 1 << touch.a | 1 << touch.b,
            normal: n,
            tangents,
            approach,
            now: approach,
            slip: tangents.slip(velocity, surface),
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

/// Two unit vectors in the tangent plane; **n** × the first is the second.
#[derive(Clone, Copy, Default)]
struct TangentBasis {
    /// Horizontal.
    first: Vec2,
    second: Vec3,
}

impl TangentBasis {
    fn of(normal: Vec3) -> Self {
        let level = normal.xy();
        let length = level.length();
        let first = if length > 0.0 { level.perp() * (1.0 / length) } else { Vec2::new(1.0, 0.0) };
        Self { first, second: normal.cross(first.with_z(0.0)) }
    }

    /// The components of the slip, from the velocity of the first ball's centre relative to the
    /// second's and the sum of both Rω.
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

/// Kinds of friction: none, rigid (it stops the slip), or a spring.
const SMOOTH: u8 = 0;
const RIGID: u8 = 1;
const SPRUNG: u8 = 2;

/// Integrates the impact until no contact carries a force and no two balls that touched at the
/// start approach. A gap that has not closed by then is left to a later impact.
fn integrate<const GRIP: u8>(
    law: &BallBall,
    units: &Units,
    stepping: &Stepping,
    balls: &mut [BallChange; BALL_SLOTS],
    links: &mut [Link; MAX_CONTACTS],
) {
    let mut step = TimeStep::first(units, stepping);
    // Forces act in the middle of a step.
    let mut drift = 0.5 * step.length;
    // Set of the contacts of balls that have moved, one bit each. The other contacts cannot change.
    let mut active = 0_u64;
    for (k, link) in links.iter().enumerate() {
        active |= u64::from(link.approach != 0.0) << k;
    }
    for _ in 0..MAX_STEPS {
        // The balls with an impulse, one bit each; the time to the next contact; the largest
        // (speed)².
        let (mut loaded, mut next_contact, mut greatest_square) = (0_u32, f64::INFINITY, 0.0);
        let ahead = stepping.ahead * step.length;
        for k in Bits(active) {
            let link = &mut links[k];
            let (a, b) = (&balls[link.a % BALL_SLOTS], &balls[link.b % BALL_SLOTS]);
            let velocity = a.velocity - b.velocity;
            let approach = link.approach + velocity.dot(link.normal);
            let (speedup, last) = (approach - link.now, link.speedup);
            (link.now, link.speedup) = (approach, speedup);
            link.depth += approach * drift;
            let depth = link.depth + ahead * (speedup + stepping.trend * (speedup - last));
            if depth <= 0.0 {
                link.presses = false;
                if approach > STILL {
                    greatest_square = larger(greatest_square, approach * approach);
                    if link.touches {
                        let time = larger(-link.depth, 0.0) / approach;
                        next_contact = if time < next_contact { time } else { next_contact };
                    }
                }
                continue;
            }
            let spring = link.stiffness * sqrt(depth);
            let tension = 0.8 * spring * link.mobility * depth * depth;
            greatest_square = larger(greatest_square, approach * approach + tension);
            let normal = link.normal_impulse(law, &step, approach, spring * depth);
            if normal == 0.0 {
                continue;
            }
            let mut push = link.normal * normal;
            let mut turn = Vec3::ZERO;
            if GRIP != SMOOTH {
                let slip = link.slip + link.tangents.slip(velocity, a.surface + b.surface);
                let friction = link.friction_impulse::<GRIP>(law, &step, slip, normal, spring);
                push += link.tangents.vector(friction.x, friction.y);
                turn = round_to_grid(link.tangents.vector(-friction.y, friction.x));
            }
            let push = round_to_grid(push);
            loaded |= link.both;
            let a = &mut balls[link.a % BALL_SLOTS];
            a.push -= push;
            a.turn += turn;
            let b = &mut balls[link.b % BALL_SLOTS];
            b.push += push;
            b.turn += turn;
        }
        let last = step.length;
        step.adapt(greatest_square);
        if loaded != 0 {
            drift = 0.5 * (last + step.length);
            for k in Bits(u64::from(loaded)) {
                active |= balls[k % BALL_SLOTS].update();
            }
        } else if next_contact < f64::INFINITY {
            drift = next_contact + 0.5 * step.length;
        } else {
            return;
        }
    }
}

/// The indices of the bits that are set, from the lowest.
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

/// The length of a step in time.
struct TimeStep {
    /// In units of T.
    length: f64,
    /// The (speed)² for which the length was chosen.
    square_speed: f64,
    /// The unit of speed, m/s.
    speed: f64,
}

impl TimeStep {
    fn first(units: &Units, stepping: &Stepping) -> Self {
        let length = CONTACT_TIME / stepping.steps_per_contact;
        Self { length, square_speed: 1.0, speed: units.speed }
    }

    /// Lengthens the step a little where the impact has faded, and shortens it where speeds have
    /// grown.
    #[inline(always)]
    fn adapt(&mut self, greatest_square: f64) {
        if greatest_square < RELAXED * self.square_speed {
            self.square_speed *= RELAXED;
            self.length *= LONGER;
        }
        while greatest_square > self.square_speed {
            self.square_speed *= 1.0 / RELAXED;
            self.length *= 1.0 / LONGER;
        }
    }
}

impl BallChange {
    /// Computes the velocities after an impulse. Returns the set of contacts that this changes.
    #[inline(always)]
    fn update(&mut self) -> u64 {
        self.velocity = self.push * self.mobility;
        self.surface = self.turn * (-SPIN_PER_IMPULSE * self.mobility);
        self.links
    }
}

impl Link {
    /// The normal impulse of one step. `force` is that of a closing contact.
    #[inline(always)]
    fn normal_impulse(
        &mut self,
        law: &BallBall,
        step: &TimeStep,
        approach: f64,
        force: f64,
    ) -> f64 {
        let full = force * step.length;
        self.fastest = larger(approach, self.fastest);
        // The impulse that stops the approach; from there on the contact opens.
        let stopping = approach * self.mass;
        if stopping >= full {
            return full;
        }
        let e = restitution::effective(law.restitution, self.fastest * step.speed);
        let open = e * e;
        full * open + larger(stopping, 0.0) * (1.0 - open)
    }

    /// The friction impulse of one step on b. `spring` is F/δ.
    #[inline(always)]
    fn friction_impulse<const GRIP: u8>(
        &mut self,
        law: &BallBall,
        step: &TimeStep,
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

/// Applies the changes of the impact to the balls, scaled so that the energy does not rise.
fn apply(law: &BallBall, units: &Units, balls: &[BallChange], bodies: &mut [Body]) {
    // Scaled by λ, the changes alter the energy by −λ·work + λ²·cost. Velocities are relative to
    // one of the balls, because a common velocity would add rounding error.
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

/// The larger of two numbers, neither of which is NaN. One instruction; `f64::max` takes several.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

fn round_to_grid(v: Vec3) -> Vec3 {
    let rounded = |x: f64| (x + GRID) - GRID;
    Vec3::new(rounded(v.x), rounded(v.y), rounded(v.z))
}
