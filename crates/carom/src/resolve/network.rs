//! One impact of all that touches: balls, the slate under a struck ball, and the tip of the cue.
//!
//! A law of restitution does not determine the result for three balls in a row: for rigid bodies it
//! is undetermined, and resolving the pairs one after another makes the result depend on their
//! order. The result depends on how the bodies deform (Alciatore, TP B.29). So the impact is
//! integrated in time, with a spring for every contact:
//!
//! * **Along the normal** Hertz's force F = k·δ^(3/2). Between balls k = (4/3)E*·√(R₁R₂/(R₁+R₂)); the
//!   slate and the tip have the k of their contact times ([`stiffness_of_time`]). While
//!   a contact opens, its force is e² times as large, so that a pair alone separates with e times
//!   its approach speed. e is the law's restitution at the fastest approach that the contact has had
//!   ([`restitution::effective`](super::restitution::effective)).
//! * **Tangentially** friction of at most μF against the slip **u** of a's surface over b's (as in
//!   [`contact`](super::ball_ball::contact)), μ being that of the fastest slip that the contact has
//!   had. In the rigid models friction stops the slip. In the models `compliant` and `stronge` it is
//!   a spring as well: it slides where μF is too small to hold it, and loses its part of the stored
//!   energy as the contact opens. Its stiffness is (5/4)(ω_t/ω_n)²·(2/7) times F/δ. During a pair's
//!   contact it then oscillates through the same phase as Stronge's linear springs, at any speed
//!   (the phase of √(7/2·k_t/m*) is π·ω_t/ω_n). `mathavan-2014` is treated like `frictional`,
//!   because its friction of the cloth has no form for many balls.
//! * **The lines of centres** turn as the balls move, by about a hundredth of a radian in a break.
//!   The normals of walls and the cue's axis do not turn.
//!
//! A contact alone is resolved by its own law, not here. If a pair of balls were resolved here, the
//! result would agree with the law's restitution and rigid friction to 1e-3 of the approach speed,
//! and the throw of `compliant` balls with their law to 0.4°.
//!
//! **Units.** The equations are solved in units of the fastest approach speed V, the heaviest ball's
//! mass and the time T = (m*²/(k²V))^(1/5) of the stiffest contact (a pair's contact lasts 3.22 T).
//!
//! **Conservation.** Impulses are rounded to a grid ([`GRID`]) on which sums are exact. So their
//! order does not matter, mirrored impulses cancel to the bit, and both balls of a contact receive
//! the same impulse. The steps conserve the energy to about 1e-4. If they would gain energy, the
//! whole change of velocity is scaled down; an impact without losses is scaled to conserve the
//! energy. At last any two bodies that touch and still approach, by a rounding error or by this
//! scaling, lose their approach speed.

mod link;
mod step;
mod strike;

use crate::math::{Vec3, pow, sqrt};
use crate::physics::BallBall;
use crate::resolve::{Body, SPIN_PER_IMPULSE};
use link::{Link, NormalSpring};
use step::TimeStep;
use strike::Cue;
pub use strike::TipTouch;

/// The most balls in a network.
pub const MAX_BODIES: usize = 24;

/// The most contacts in a network. [`MAX_BODIES`] equal balls in a plane have at most
/// ⌊3n − √(12n − 3)⌋ = 55 contacts (Harborth 1974). Any others are resolved in a further impact at
/// the same instant.
pub const MAX_CONTACTS: usize = 64;

/// Length of the array of balls: more than [`MAX_BODIES`], and a power of two, so that an index
/// modulo this number needs no bounds check.
const BALL_SLOTS: usize = 32;

/// The slot of the walls. It has no mobility, so it never moves.
const WALL: usize = BALL_SLOTS - 1;

/// E* = E/(2(1 − ν²)) of ball material, Pa: 2270 N compress two 2¼ in balls by 0.2 mm
/// (Alciatore, TP B.29).
pub const CONTACT_MODULUS: f64 = 5.04e9;

/// Duration of a contact with Hertz's force and without losses, as a multiple of the greatest
/// compression divided by the approach speed: 2∫dx/√(1 − x^(5/2)) from 0 to 1.
const TIME_PER_DEPTH: f64 = 2.943_275_5;

/// The most steps of an impact, in units of [`Stepping::steps_per_contact`]. A frozen rack needs a
/// twentieth of it. Balls that still approach after that lose their approach speed.
const MOST_CONTACTS: f64 = 360.0;

/// x + `GRID` − `GRID` rounds x to a grid of 2⁻⁴⁴ (for |x| < 128). Sums of such numbers are exact
/// up to 512, so their order does not matter. The unit is the momentum of the heaviest ball at the
/// fastest approach.
const GRID: f64 = 384.0;

/// An approach slower than this fraction of the fastest approach counts as 0.
const STILL: f64 = 1e-9;

/// Number of steps after which the lines of centres are turned. The balls of a break turn a line
/// by 0.001 rad per step at most.
const STEPS_PER_TURN: usize = 4;

/// The lines of centres turn during at most this time without a force, in units of T: three times a
/// contact. The engine leaves the balls where they are, so a contact that takes place later must
/// not see them far away.
const LONGEST_DRIFT: f64 = 10.0;

/// The most passes that take the rest of the approach from bodies that touch.
const PARTING_PASSES: usize = 400;

/// Steps per contact: this number divided by the number of contacts, within two limits.
const STEPS: f64 = 176.0;
const FEWEST_STEPS: f64 = 11.0;
const MOST_STEPS: f64 = 44.0;

/// Steps per contact where a tip acts. The slate is the stiffest contact there, and it carries
/// little of the force.
const STRIKE_STEPS: f64 = 16.0;

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
    /// Steps with the two constants that are best for small ones (Takahashi & Imada 1984).
    pub const fn new(steps_per_contact: f64) -> Self {
        Self { steps_per_contact, ahead: 1.0 / 12.0, trend: 1.0 }
    }

    /// The steps of [`NetworkImpact::resolve`] for a number of contacts. Few contacts are integrated in
    /// short steps. A rack takes long ones: short ones would double the time of a break, and where
    /// its balls go depends on far smaller differences, such as the gaps between them.
    pub fn of(contacts: usize) -> Self {
        Self::new((STEPS / contacts as f64).clamp(FEWEST_STEPS, MOST_STEPS))
    }
}

/// Two balls that touch, or nearly.
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

/// A ball that touches a wall: a body that does not move, as the slate.
#[derive(Clone, Copy, Debug)]
pub struct WallTouch {
    /// Index of the ball.
    pub ball: u8,
    /// Unit vector from the ball's centre to the contact.
    pub normal: Vec3,
    /// Stiffness k, N/m^(3/2).
    pub stiffness: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// ω_t/ω_n of a compliant wall; `None` for a rigid one.
    pub frequency_ratio: Option<f64>,
}

/// The stiffness k, N/m^(3/2), of a contact of reduced mass `mass` (kg) that lasts `time` (s) at an
/// approach of 1 m/s without losses. At the speed V it lasts V^(−1/5) times as long.
pub fn stiffness_of_time(mass: f64, time: f64) -> f64 {
    let rate = TIME_PER_DEPTH / time;
    1.25 * mass * rate * rate * sqrt(rate)
}

/// What a network tells about the tip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TipReport {
    /// How often the tip met the ball.
    pub contacts: u32,
    /// How long the tip was on the ball, s.
    pub time: f64,
    /// Whether the struck ball met a ball across a gap while the tip was on it.
    pub pushes: bool,
    /// The cue's speed along its axis afterwards, m/s.
    pub cue_speed: f64,
}

/// One impact of everything that touches.
#[derive(Clone, Copy, Debug)]
pub struct NetworkImpact<'a> {
    /// The law of the balls.
    pub law: &'a BallBall,
    /// Contacts of balls; only the first [`MAX_CONTACTS`] of these and the walls are used.
    pub touches: &'a [Touch],
    /// Contacts with walls.
    pub walls: &'a [WallTouch],
    /// The tip's contact.
    pub tip: Option<TipTouch>,
}

/// Resolves the impact of balls that touch. Returns `false`, and changes nothing, if no two of them
/// approach. Balls that the impact does not reach keep their exact bits.
///
/// There are at most [`MAX_BODIES`] `bodies`.
pub fn resolve(law: &BallBall, bodies: &mut [Body], touches: &[Touch]) -> bool {
    NetworkImpact { law, touches, walls: &[], tip: None }.resolve(bodies).is_some()
}

impl NetworkImpact<'_> {
    /// Resolves the impact. Returns `None`, and changes nothing, if no two bodies approach. Balls
    /// that the impact does not reach keep their exact bits.
    ///
    /// There are at most [`MAX_BODIES`] `bodies`.
    pub fn resolve(&self, bodies: &mut [Body]) -> Option<TipReport> {
        let contacts = self.touches.len() + self.walls.len();
        let stepping = match self.tip {
            Some(_) => Stepping::new(STRIKE_STEPS),
            None => Stepping::of(contacts),
        };
        self.resolve_in_steps(bodies, &stepping)
    }

    /// [`resolve`](Self::resolve) with other steps than the engine's, for studies of their accuracy.
    #[inline]
    pub fn resolve_in_steps(&self, bodies: &mut [Body], stepping: &Stepping) -> Option<TipReport> {
        let touches = &self.touches[..self.touches.len().min(MAX_CONTACTS)];
        let walls = &self.walls[..self.walls.len().min(MAX_CONTACTS - touches.len())];
        let impact = NetworkImpact { touches, walls, ..*self };
        let units = Units::of(&impact, bodies)?;
        let mut balls = [Ball::default(); BALL_SLOTS];
        let mut links = [Link::default(); MAX_CONTACTS];
        let mut cue = self.tip.map(|tip| Cue::new(&tip, bodies, &units));
        for (ball, body) in balls.iter_mut().zip(bodies.iter()) {
            ball.begin(body, &units);
        }
        for (link, touch) in links.iter_mut().zip(touches) {
            link.join(touch, self.law, bodies, &units);
        }
        for (link, wall) in links[touches.len()..].iter_mut().zip(walls) {
            link.join_wall(wall, bodies, &units);
        }
        let links = &mut links[..touches.len() + walls.len()];
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
        let mut network = Network { balls: &mut balls, links, cue: cue.as_mut() };
        let smooth = self.law.is_smooth() && walls.iter().all(|wall| wall.friction == 0.0);
        if smooth {
            network.integrate::<false>(self.law, &units, stepping);
        } else {
            network.integrate::<true>(self.law, &units, stepping);
        }
        let share = network.apply(&impact, &units, bodies);
        network.part(&units, bodies);
        Some(cue.map_or_else(TipReport::default, |cue| cue.report(share, &units)))
    }
}

/// The units of one impact.
struct Units {
    /// Fastest approach V, m/s.
    speed: f64,
    /// Heaviest ball, kg.
    mass: f64,
    /// T, s.
    time: f64,
    /// k/m* of the stiffest contact, N/m^(3/2) per kg.
    rate: f64,
}

impl Units {
    /// `None` if no two bodies approach.
    fn of(impact: &NetworkImpact<'_>, bodies: &[Body]) -> Option<Self> {
        let (mut speed, mut rate) = (0.0_f64, 0.0_f64);
        let mass = bodies.iter().fold(0.0_f64, |most, body| most.max(body.mass));
        for touch in impact.touches {
            let (a, b) = touch.bodies(bodies);
            speed = speed.max((a.velocity - b.velocity).dot(touch.normal));
            rate = rate.max(ball_stiffness(a, b) * (1.0 / a.mass + 1.0 / b.mass));
        }
        for wall in impact.walls {
            let ball = &bodies[usize::from(wall.ball)];
            speed = speed.max(ball.velocity.dot(wall.normal));
            rate = rate.max(wall.stiffness / ball.mass);
        }
        if let Some(tip) = &impact.tip {
            speed = speed.max(tip.approach(bodies));
            rate = rate.max(tip.stiffness / tip.reduced_mass(bodies));
        }
        (speed > 0.0).then(|| Self { speed, mass, time: pow(rate * rate * speed, -0.2), rate })
    }

    fn length(&self) -> f64 {
        self.speed * self.time
    }

    /// A stiffness, N/m^(3/2), in these units.
    fn stiffness(&self, stiffness: f64) -> f64 {
        stiffness * sqrt(self.length()) * self.time * self.time / self.mass
    }

    /// How quickly the force of a contact changes, for the choice of steps: ((k/m*) / (that of the
    /// stiffest contact))⁴. `mobility` is 1/m*.
    fn quickness(&self, stiffness: f64, mobility: f64) -> f64 {
        let share = stiffness * mobility / self.rate;
        let square = share * share;
        square * square
    }
}

impl Touch {
    fn bodies<'a>(&self, bodies: &'a [Body]) -> (&'a Body, &'a Body) {
        (&bodies[usize::from(self.a)], &bodies[usize::from(self.b)])
    }
}

/// Hertz's k of two balls, N/m^(3/2).
fn ball_stiffness(a: &Body, b: &Body) -> f64 {
    4.0 / 3.0 * CONTACT_MODULUS * sqrt(a.radius * b.radius / (a.radius + b.radius))
}

/// A ball during the impact.
#[derive(Clone, Copy, Default)]
#[repr(align(128))]
struct Ball {
    /// Impulse.
    push: Vec3,
    /// Σ n × (impulse on the second ball of the contact). It turns both balls in the same sense.
    turn: Vec3,
    /// Velocity.
    velocity: Vec3,
    /// Surface velocity Rω.
    surface: Vec3,
    /// Velocity and surface velocity before the impact.
    first_velocity: Vec3,
    first_surface: Vec3,
    /// Displacement at the last impulse, and the time of that impulse.
    shift: Vec3,
    since: f64,
    /// 1/mass.
    mobility: f64,
    /// Set of its contacts, one bit each.
    links: u64,
}

impl Ball {
    fn begin(&mut self, body: &Body, units: &Units) {
        let per_speed = 1.0 / units.speed;
        self.velocity = body.velocity * per_speed;
        self.surface = body.angular_velocity * (body.radius * per_speed);
        self.first_velocity = self.velocity;
        self.first_surface = self.surface;
        self.mobility = units.mass / body.mass;
    }

    /// Computes the velocities after an impulse at the time `now`. Returns the set of contacts that
    /// this changes.
    #[inline(always)]
    fn update(&mut self, now: f64) -> u64 {
        self.shift = self.shift_at(now);
        self.since = now;
        self.velocity = self.first_velocity + self.push * self.mobility;
        self.surface = self.first_surface + self.turn * (-SPIN_PER_IMPULSE * self.mobility);
        self.links
    }

    /// The displacement at the time `now`.
    #[inline(always)]
    fn shift_at(&self, now: f64) -> Vec3 {
        self.shift + self.velocity * (now - self.since)
    }
}

/// All bodies and contacts during the impact.
struct Network<'a> {
    balls: &'a mut [Ball; BALL_SLOTS],
    links: &'a mut [Link],
    cue: Option<&'a mut Cue>,
}

impl Network<'_> {
    /// Integrates the impact until no contact carries a force and no two bodies that touched at the
    /// start approach. A gap that has not closed by then is left to a later impact.
    fn integrate<const GRIP: bool>(&mut self, law: &BallBall, units: &Units, stepping: &Stepping) {
        let Self { balls, links, cue } = self;
        let springs = links.iter().map(|link| &link.spring);
        let springs = springs.chain(cue.as_ref().map(|cue| &cue.spring));
        let greatest_square = springs.map(NormalSpring::square_speed).fold(0.0, larger);
        let mut step = TimeStep::first(units, stepping, greatest_square);
        // Forces act in the middle of a step.
        let mut drift = 0.5 * step.length;
        // Set of the contacts of balls that have moved, one bit each. The other contacts cannot
        // change.
        let mut active = 0_u64;
        for (k, link) in links.iter().enumerate() {
            active |= u64::from(link.spring.approach != 0.0) << k;
        }
        let most = (MOST_CONTACTS * stepping.steps_per_contact) as usize;
        let (mut now, mut until_turn) = (0.0, 0);
        for _ in 0..most {
            now += smaller(drift, LONGEST_DRIFT);
            if until_turn == 0 {
                turn(active, balls, links, now, 0.5 * (STEPS_PER_TURN - 1) as f64 * step.length);
                until_turn = STEPS_PER_TURN;
            }
            until_turn -= 1;
            // The balls with an impulse, one bit each.
            let mut loaded = 0_u32;
            let mut greatest_square = 0.0;
            for k in step::Bits(active) {
                let Some(link) = links.get_mut(k) else { break };
                let (a, b) = (&balls[link.a % BALL_SLOTS], &balls[link.b % BALL_SLOTS]);
                let velocity = a.velocity - b.velocity;
                let approach = velocity.dot(link.normal);
                let Some(normal) =
                    link.spring.impulse(approach, drift, &step, stepping, &mut greatest_square)
                else {
                    link.grip.presses = false;
                    continue;
                };
                let mut push = link.normal * normal;
                let mut turn = Vec3::ZERO;
                if GRIP && link.grip.rubs {
                    let slip = link.tangents.slip(velocity, a.surface + b.surface);
                    let friction = link.friction_impulse(slip, normal, &step, &law.friction);
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
            if let Some(cue) = cue {
                loaded |= cue.act(balls, links, drift, (&step, stepping), &mut greatest_square);
            }
            let last = step.length;
            step.adapt(greatest_square);
            if loaded != 0 {
                drift = 0.5 * (last + step.length);
                for k in step::Bits(u64::from(loaded)) {
                    active |= balls[k % BALL_SLOTS].update(now);
                }
                continue;
            }
            let springs = step::Bits(active).map(|k| &links[k].spring);
            let springs = springs.chain(cue.as_ref().map(|cue| &cue.spring));
            let (mut wait, mut goes_on) = (f64::INFINITY, false);
            for spring in springs {
                let time = spring.time_to_contact();
                goes_on |= spring.has_touched && time < f64::INFINITY;
                wait = smaller(time, wait);
            }
            if !goes_on {
                return;
            }
            drift = wait + 0.5 * step.length;
            until_turn = 0;
        }
    }

    /// Applies the changes of the impact to the balls, scaled so that the energy does not rise.
    /// Returns the scale.
    fn apply(&self, impact: &NetworkImpact<'_>, units: &Units, bodies: &mut [Body]) -> f64 {
        // Scaled by λ, the changes alter the energy by −λ·work + λ²·cost. Without walls, velocities
        // are relative to one of the balls, because a common velocity would add rounding error.
        let alone = impact.walls.is_empty() && impact.tip.is_none();
        let frame = if alone { self.balls[0].first_velocity } else { Vec3::ZERO };
        let (mut work, mut cost) = (0.0, 0.0);
        for ball in &self.balls[..bodies.len()] {
            let velocity = ball.first_velocity - frame;
            work += ball.first_surface.dot(ball.turn) - velocity.dot(ball.push);
            let change = ball.push.length_squared();
            let surface = SPIN_PER_IMPULSE * ball.turn.length_squared();
            cost += 0.5 * ball.mobility * (change + surface);
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
            if ball.push != Vec3::ZERO || ball.turn != Vec3::ZERO {
                let scale = share * units.speed * ball.mobility;
                body.velocity += ball.push * scale;
                body.angular_velocity -= ball.turn * (SPIN_PER_IMPULSE * scale / body.radius);
            }
        }
        share
    }

    /// Takes the rest of their approach from bodies that have touched. It is measured along the lines
    /// of centres at the start, because the balls stay where they were: two balls that separate along
    /// a line that has turned may approach along that one. All contacts act at once in each pass, so
    /// that their order does not matter.
    fn part(&self, units: &Units, bodies: &mut [Body]) {
        let least = STILL * units.speed;
        for _ in 0..PARTING_PASSES {
            let mut pushes = [Vec3::ZERO; BALL_SLOTS];
            let mut parted = true;
            for link in self.links.iter().filter(|link| link.spring.has_touched) {
                let b = if link.b == WALL { Vec3::ZERO } else { bodies[link.b].velocity };
                let approach = (bodies[link.a].velocity - b).dot(link.first_normal);
                if approach > least {
                    let push = link.first_normal * (approach * link.share * link.spring.mass);
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

/// Turns the lines of centres of the `active` contacts to where they are `ahead` of the time `now`.
fn turn(active: u64, balls: &[Ball; BALL_SLOTS], links: &mut [Link], now: f64, ahead: f64) {
    for k in step::Bits(active) {
        let link = &mut links[k];
        let (a, b) = (&balls[link.a % BALL_SLOTS], &balls[link.b % BALL_SLOTS]);
        link.turn(b.shift_at(now) - a.shift_at(now), b.velocity - a.velocity, ahead);
    }
}

/// The smaller of two numbers, neither of which is NaN.
#[inline(always)]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
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
