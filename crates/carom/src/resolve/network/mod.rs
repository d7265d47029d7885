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
//! * **A held contact.** While others press a contact with less than the force of closing and more
//!   than e² times it, the contact neither opens nor closes, and its force is theirs. So is the slate
//!   under a ball that a raised cue presses down.
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

mod alone;
mod ball;
mod directions;
mod grip;
mod link;
mod spring;
mod step;
mod strike;
mod system;

use core::fmt;

use crate::math::{Vec3, pow, sqrt};
use crate::physics::BallBall;
use crate::resolve::{Body, SPIN_PER_IMPULSE};
use ball::Ball;
use link::{Block, LANES, Link};
use strike::Cue;
use system::Network;

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

/// Steps per contact: this number divided by the number of contacts, within two limits.
const STEPS: f64 = 176.0;
const FEWEST_STEPS: f64 = 11.0;
const MOST_STEPS: f64 = 44.0;

/// Steps per contact where a tip acts. Beside the tip alone, the slate's share of the speed is the
/// sine of the elevation, and its error is in proportion. So the root of this share times as many
/// steps do, but not fewer than the second number.
const STRIKE_STEPS: f64 = 24.0;
const FEWEST_STRIKE_STEPS: f64 = 8.0;

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

    /// The steps of [`NetworkImpact::resolve`] for a strike.
    fn of_strike(tip: &TipTouch, touches: &[Touch], walls: &[WallTouch]) -> Self {
        if !touches.is_empty() {
            return Self::new(STRIKE_STEPS);
        }
        let share = |wall: &WallTouch| tip.launch.dot(wall.normal).abs();
        let most = walls.iter().map(share).fold(0.0, larger);
        Self::new(larger(STRIKE_STEPS * sqrt(most), FEWEST_STRIKE_STEPS))
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

/// Memory for the bodies and contacts of an impact while it is computed. It is too large for the stack
/// of a device's thread.
#[derive(Clone)]
pub struct NetworkScratch {
    balls: [Ball; BALL_SLOTS],
    links: [Link; MAX_CONTACTS],
    blocks: [Block; MAX_CONTACTS / LANES],
}

impl Default for NetworkScratch {
    fn default() -> Self {
        Self {
            balls: [Ball::default(); BALL_SLOTS],
            links: [Link::default(); MAX_CONTACTS],
            blocks: [Block::NONE; MAX_CONTACTS / LANES],
        }
    }
}

impl fmt::Debug for NetworkScratch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("NetworkScratch").finish_non_exhaustive()
    }
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
    let impact = NetworkImpact { law, touches, walls: &[], tip: None };
    impact.resolve(bodies, &mut NetworkScratch::default()).is_some()
}

impl NetworkImpact<'_> {
    /// Resolves the impact. Returns `None`, and changes nothing, if no two bodies approach. Balls
    /// that the impact does not reach keep their exact bits.
    ///
    /// There are at most [`MAX_BODIES`] `bodies`.
    pub fn resolve(&self, bodies: &mut [Body], scratch: &mut NetworkScratch) -> Option<TipReport> {
        let contacts = self.touches.len() + self.walls.len();
        let stepping = match self.tip {
            Some(tip) => Stepping::of_strike(&tip, self.touches, self.walls),
            None => Stepping::of(contacts),
        };
        self.resolve_in(bodies, &stepping, scratch)
    }

    /// [`resolve`](Self::resolve) with other steps than the engine's, for studies of their accuracy.
    pub fn resolve_in_steps(&self, bodies: &mut [Body], stepping: &Stepping) -> Option<TipReport> {
        self.resolve_in(bodies, stepping, &mut NetworkScratch::default())
    }

    #[inline]
    fn resolve_in(
        &self,
        bodies: &mut [Body],
        stepping: &Stepping,
        scratch: &mut NetworkScratch,
    ) -> Option<TipReport> {
        let touches = &self.touches[..self.touches.len().min(MAX_CONTACTS)];
        let walls = &self.walls[..self.walls.len().min(MAX_CONTACTS - touches.len())];
        let impact = NetworkImpact { touches, walls, ..*self };
        let units = Units::of(&impact, bodies)?;
        if let (Some(tip), [], [wall], [body]) = (self.tip, touches, walls, &mut *bodies) {
            return Some(alone::resolve(&tip, wall, body, &units, stepping));
        }
        let mut cue = self.tip.map(|tip| Cue::new(&tip, bodies, &units));
        let mut network = Network::new(&impact, bodies, &units, scratch, cue.as_mut());
        network.integrate(self.law, &units, stepping);
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
