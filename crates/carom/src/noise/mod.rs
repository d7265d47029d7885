//! Execution noise: the random error of a player's strike; and perception: the random error of the
//! positions at which a player sees the balls.
//!
//! Every parameter of the strike has a Gaussian error of its own, independent of the others, as in
//! the Computational Olympiad (Archibald, Altman & Shoham, *Analysis of a winning computational
//! billiards player*, 2009). A measured player or robot may have more: an error of the speed in
//! proportion to it, errors that depend on each other (a covariance), a systematic error (a bias), or
//! a list of measured errors instead of a normal law. The Gaussian parts add up: the error is normal,
//! with the bias as its mean and the sum of the variances and the covariance as its covariance
//! matrix C. With L the Cholesky factor of C and z five independent deviates, it is bias + Lz.
//!
//! # Random numbers
//!
//! Variant `index` of a seed depends on these two numbers alone: ChaCha8 (Bernstein 2008) with the
//! seed in its key and the index as its stream, uniform numbers of 53 bits, and normal deviates by
//! Box & Muller (1958) in this crate's own arithmetic. So variant 17 is the same alone or among
//! thousands, in any order, for any number of threads, on every platform. Every parameter has its
//! own deviate even where its σ is 0: changing one σ changes no other parameter.
//!
//! # Strikes that cannot be played
//!
//! A drawn strike that cannot be played is replaced by the nearest that can. This is the one law of
//! execution errors; batches, evaluations, searches, sweeps, environments and the page all use it
//! ([`Noise::draw`]):
//!
//! - An offset beyond [`OFFSET_KEPT`] of the miscue limit is moved back to it, along its direction.
//!   If the shot plays miscues (`strike.miscue`), it is that share of the ball's radius.
//! - A speed below [`SLOWEST`] becomes that speed, and one above 50 m/s becomes 50 m/s.
//! - An elevation below 0 becomes 0, since a cue never points upwards, and one above [`STEEPEST`]
//!   becomes that angle.
//! - A parameter without an error stays exactly as intended.
//!
//! So every intended strike has a result, the results stay continuous in the strike, and every shot
//! takes the same number of random numbers. Drawing again would have neither of the last two
//! properties. The price: an intended strike near the miscue limit looks safer than it is, because
//! its miscues are replaced by strikes at the limit. Programs that choose strikes should keep away
//! from the limit, as players do; an environment's actions reach 0.9 of it, and
//! `carom_plan::solve` uses 0.95.
//!
//! Some strikes still fail: an offset that is too large for the tip's efficiency, a cue that would
//! pass through a ball or a rail if the shot refuses that, and a shot that reaches its cap on events.

mod covariance;
mod file;
mod perception;
mod samples;

use alloc::borrow::Cow;
use core::f64::consts::{PI, TAU};

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use crate::Ball;
use crate::error::{Error, ErrorKind};
use crate::math::{log, radians, sin_cos, sqrt};
use crate::physics::ball_surface::CHALKED;
use crate::range::Range;
use crate::resolve::cue_ball::{Strike, miscue_limit};
use crate::shot::{self, Cling, MOST_CONTACTS, Shot};

pub use covariance::Covariance;
pub use perception::{Perception, PositionError};
pub use samples::Samples;

/// Part of the generator's key that separates these random numbers from others of the same seed.
const STRIKE_KEY: &[u8; 24] = b"carom: noise of a strike";
/// The same for contacts that cling.
const CLING_KEY: &[u8; 24] = b"carom: cling of contacts";

/// σ of a tip offset: at most a third of a ball's radius. A larger one is a mistake of units.
const OFFSET: Range = Range::closed(0.0, 0.01, " m");
/// σ of an angle: at most half a turn, beyond which every direction is about as likely.
const ANGLE: Range = Range::closed(0.0, PI, " rad");
/// σ of the cue's speed: at most the speed of the fastest breaks.
const SPEED: Range = Range::closed(0.0, 15.0, " m/s");
/// Probability of a cling.
const PROBABILITY: Range = Range::closed(0.0, 1.0, "");
/// Coefficient of friction of a contact that clings: at most 10. With 1 a contact sticks at any angle
/// that players use.
const FRICTION: Range = Range::closed(0.0, 10.0, "");
/// Error of the cue's speed as a share of the intended speed: a third of it is a beginner's.
const SHARE: Range = Range::closed(0.0, 1.0, "");
/// The ranges of σ in the order of a covariance: speed, azimuth, elevation, side, height.
const RANGES: [Range; 5] = [SPEED, ANGLE, ANGLE, OFFSET, OFFSET];

/// Largest tip offset of a drawn strike, as a fraction of the largest with which a strike can be
/// played. Closer to 1, rounding could make a miscue of it; with less, strikes that can be played
/// would be moved.
pub const OFFSET_KEPT: f64 = 0.999;

/// Smallest speed of the cue of a drawn strike, 1 cm/s: the cue ball then moves by less than a
/// millimetre. Much larger, and soft strikes would be made harder.
pub const SLOWEST: f64 = 0.01;

/// Largest elevation of a drawn strike, 89°. A cue cannot point straight down, where it has no
/// azimuth. Smaller, and steep massé strikes would be flattened.
pub const STEEPEST: f64 = radians(89.0);

/// Levels of play, the weakest first.
///
/// **Estimated.** Tests of players order the levels and show that better players also spread less
/// (Pan, Komar & Kong, *Development of new 9-ball test protocols for assessing expertise in cue
/// sports*, 2021; Haar, van Assel & Faisal, *Motor learning in real-world pool billiards*, 2020),
/// but we found none that measures the σ of the cue's motion. The σ of the direction about halves
/// from level to level, around the Olympiad's 0.125°; docs/evaluate.md shows its effect on shots.
pub static SKILLS: [(&str, Noise); 5] = [
    ("beginner", skill(0.40, 0.60, 2.0, 3.0)),
    ("casual", skill(0.25, 0.30, 1.5, 2.0)),
    ("club", skill(0.15, 0.15, 1.0, 1.2)),
    ("advanced", skill(0.10, 0.08, 0.6, 0.8)),
    ("professional", skill(0.06, 0.04, 0.3, 0.4)),
];

/// σ of speed (m/s), of azimuth and elevation (degrees), and of either tip offset (mm).
const fn skill(speed: f64, azimuth: f64, elevation: f64, offset: f64) -> Noise {
    Noise {
        speed,
        azimuth: radians(azimuth),
        elevation: radians(elevation),
        side_m: 0.001 * offset,
        height_m: 0.001 * offset,
        ..Noise::NONE
    }
}

/// Errors of a strike, and how often two balls cling.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Standard deviation of the cue's speed, m/s; 0 to 15.
    pub speed: f64,
    /// Of the cue's direction, rad; 0 to π.
    pub azimuth: f64,
    /// Of the cue's elevation, rad; 0 to π.
    pub elevation: f64,
    /// Of the contact point to the side, m; 0 to 0.01. In metres, unlike the strike's own offsets:
    /// a hand's error does not depend on the ball's radius.
    pub side_m: f64,
    /// Of the contact point's height, m; 0 to 0.01.
    pub height_m: f64,
    /// The probability with which a contact of two balls clings, 0 to 1 ([`Cling`]). No source gives
    /// one for pool; it is 0 in every preset.
    pub cling_probability: f64,
    /// The coefficient of friction of a contact that clings, at every slip speed;
    /// [`CHALKED`] in every preset.
    pub cling_friction: f64,
    /// Standard deviation of a further error of the cue's speed, as a share of the intended speed; 0
    /// to 1.
    pub speed_relative: f64,
    /// Covariance of further errors, which depend on each other.
    pub covariance: Option<Covariance>,
    /// Mean of the error, executed minus intended: speed (m/s), azimuth (rad), elevation (rad), side
    /// (m), height (m).
    pub bias: [f64; 5],
    /// Measured errors in place of σ and covariance.
    pub samples: Option<Samples>,
}

impl Default for Noise {
    fn default() -> Self {
        Self::NONE
    }
}

impl Noise {
    /// No errors, and no contact clings.
    pub const NONE: Self = Self {
        speed: 0.0,
        azimuth: 0.0,
        elevation: 0.0,
        side_m: 0.0,
        height_m: 0.0,
        cling_probability: 0.0,
        cling_friction: CHALKED,
        speed_relative: 0.0,
        covariance: None,
        bias: [0.0; 5],
        samples: None,
    };

    /// The Computational Olympiad's noise times `multiplier`; its tournaments were played at 0.5, 1
    /// and 2. σ: offsets 0.5 mm each, elevation 0.1°, azimuth 0.125°, speed 0.075 m/s.
    pub const fn olympiad(multiplier: f64) -> Self {
        Self {
            speed: 0.075 * multiplier,
            azimuth: radians(0.125) * multiplier,
            elevation: radians(0.1) * multiplier,
            side_m: 0.000_5 * multiplier,
            height_m: 0.000_5 * multiplier,
            ..Self::NONE
        }
    }

    /// Independent Gaussian errors, those of this noise times `multiplier`, and no others: for
    /// constants, where [`Self::scaled`] cannot be used.
    #[must_use]
    pub const fn independent(&self, multiplier: f64) -> Self {
        Self {
            speed: self.speed * multiplier,
            azimuth: self.azimuth * multiplier,
            elevation: self.elevation * multiplier,
            side_m: self.side_m * multiplier,
            height_m: self.height_m * multiplier,
            ..Self::NONE
        }
    }

    /// The preset of that name: one of [`SKILLS`], or `olympiad`.
    pub fn preset(name: &str) -> Option<Self> {
        let skill = SKILLS.iter().find(|skill| skill.0 == name).map(|skill| skill.1.clone());
        skill.or_else(|| (name == "olympiad").then(|| Self::olympiad(1.0)))
    }

    /// This noise with every error multiplied by `multiplier`. The cling stays, because it does not
    /// depend on the player.
    #[must_use]
    pub fn scaled(&self, multiplier: f64) -> Self {
        Self {
            cling_probability: self.cling_probability,
            cling_friction: self.cling_friction,
            speed_relative: self.speed_relative * multiplier,
            covariance: self.covariance.as_ref().map(|covariance| covariance.scaled(multiplier)),
            bias: self.bias.map(|mean| mean * multiplier),
            samples: self.samples.as_ref().map(|samples| samples.scaled(multiplier)),
            ..self.independent(multiplier)
        }
    }

    /// Rejects a number out of its range.
    ///
    /// # Errors
    /// [`Error::Input`] for a σ that is negative, not finite, or larger than its field allows, for
    /// a probability outside 0..=1 and for a friction outside 0..=10.
    pub fn check(&self) -> Result<(), Error> {
        for (key, value, range) in [
            ("speed", self.speed, SPEED),
            ("azimuth", self.azimuth, ANGLE),
            ("elevation", self.elevation, ANGLE),
            ("side_m", self.side_m, OFFSET),
            ("height_m", self.height_m, OFFSET),
            ("cling_probability", self.cling_probability, PROBABILITY),
            ("cling_friction", self.cling_friction, FRICTION),
            ("speed_relative", self.speed_relative, SHARE),
        ] {
            range.check(|| alloc::format!("noise.{key}"), value)?;
        }
        for (k, mean) in self.bias.iter().enumerate() {
            RANGES[k].either_sign().check(|| alloc::format!("noise.bias[{k}]"), *mean)?;
        }
        let is_gaussian = self.covariance.is_some() || self.speed_relative != 0.0;
        if self.samples.is_some() && (is_gaussian || self.sigmas() != [0.0; 5]) {
            let what = "measured errors stand beside standard deviations or a covariance";
            let remedy = "write one of them; measured errors already have their spread";
            return Err(ErrorKind::Conflict.at("noise.samples", what, remedy));
        }
        Ok(())
    }

    /// The independent σ of speed (m/s), azimuth, elevation (rad), side and height (m).
    const fn sigmas(&self) -> [f64; 5] {
        [self.speed, self.azimuth, self.elevation, self.side_m, self.height_m]
    }

    /// Whether all errors are independent, of mean 0, and the same at every speed.
    fn is_independent(&self) -> bool {
        self.speed_relative == 0.0
            && self.covariance.is_none()
            && self.bias == [0.0; 5]
            && self.samples.is_none()
    }

    /// Which parameters have an error: speed, azimuth, elevation, side, height.
    fn has_error(&self) -> [bool; 5] {
        let sigmas = self.sigmas();
        if self.is_independent() {
            return sigmas.map(|sigma| sigma != 0.0);
        }
        core::array::from_fn(|k| {
            sigmas[k] != 0.0
                || self.bias[k] != 0.0
                || (k == 0 && self.speed_relative != 0.0)
                || self.covariance.as_ref().is_some_and(|c| c.matrix()[k][k] != 0.0)
                || self.samples.as_ref().is_some_and(|samples| samples.has_error()[k])
        })
    }

    /// The mean error: speed (m/s), azimuth (rad), elevation (rad), side (m), height (m).
    pub fn mean(&self) -> [f64; 5] {
        let Some(samples) = &self.samples else { return self.bias };
        core::array::from_fn(|k| self.bias[k] + samples.mean()[k])
    }

    /// The covariance matrix of the errors at an intended `speed` (m/s), in the order and the units of
    /// [`Self::mean`].
    pub fn covariance_at(&self, speed: f64) -> [[f64; 5]; 5] {
        if let Some(samples) = &self.samples {
            return *samples.covariance();
        }
        let mut matrix = self.covariance.as_ref().map_or([[0.0; 5]; 5], |c| *c.matrix());
        for (k, sigma) in self.sigmas().into_iter().enumerate() {
            matrix[k][k] += sigma * sigma;
        }
        let relative = self.speed_relative * speed;
        matrix[0][0] += relative * relative;
        matrix
    }

    /// The standard deviations of the errors at an intended `speed` (m/s), in the order and the units
    /// of [`Self::mean`].
    pub fn deviations(&self, speed: f64) -> [f64; 5] {
        if self.is_independent() {
            return self.sigmas();
        }
        let matrix = self.covariance_at(speed);
        core::array::from_fn(|k| sqrt(matrix[k][k]))
    }

    /// This noise without its mean error: that of a player whose intentions allow for it
    /// ([`Self::aim_for`]).
    #[must_use]
    pub fn centered(&self) -> Self {
        let mean = self.samples.as_ref().map_or([0.0; 5], |samples| *samples.mean());
        // 0 − 0 is 0 and never −0, which would be another noise.
        Self { bias: mean.map(|mean| 0.0 - mean), ..self.clone() }
    }

    /// The strike to intend, so that `executed` is its mean execution.
    pub fn aim_for(&self, executed: &Strike, struck: &StruckBall) -> Strike {
        let mean = self.mean();
        if mean == [0.0; 5] {
            return *executed;
        }
        let back = in_radii(mean.map(|mean| -mean), struck.radius);
        self.nearest_playable(added(executed, &back), struck)
    }

    /// Variant `index` of the strike `meant`: a strike that can be played, if `meant` can (see the
    /// module's page).
    pub fn draw(&self, meant: &Strike, struck: &StruckBall, seed: u64, index: u64) -> Strike {
        if self.is_independent() && self.sigmas() == [0.0; 5] {
            return *meant;
        }
        let [speed, azimuth, elevation, side, height, _] = normal_deviates(seed, index);
        self.apply(meant, struck, [speed, azimuth, elevation, side, height])
    }

    /// The strike `meant` with these errors: deviates of mean 0 and variance 1 of the speed, the azimuth,
    /// the elevation, the side and the height. A strike that can be played, if `meant` can. Under a
    /// covariance each deviate also moves the parameters after its own; of measured errors the first
    /// deviate chooses one.
    pub fn apply(&self, meant: &Strike, struck: &StruckBall, deviates: [f64; 5]) -> Strike {
        let bias = in_radii(self.bias, struck.radius);
        let error = if let Some(samples) = &self.samples {
            in_radii(samples.at(deviates[0]), struck.radius)
        } else if self.covariance.is_some() {
            let matrix = self.covariance_at(meant.speed);
            in_radii(covariance::correlated(&matrix, &deviates), struck.radius)
        } else {
            let scale = in_radii(self.deviations(meant.speed), struck.radius);
            core::array::from_fn(|k| scale[k] * deviates[k])
        };
        let error = core::array::from_fn(|k| bias[k] + error[k]);
        self.nearest_playable(added(meant, &error), struck)
    }

    /// The strike nearest to `drawn` that can be played. A parameter without errors is left alone.
    fn nearest_playable(&self, drawn: Strike, struck: &StruckBall) -> Strike {
        let [speed, _, elevation, side, height] = self.has_error();
        let mut strike = drawn;
        if speed {
            strike.speed = drawn.speed.clamp(SLOWEST, shot::FASTEST);
        }
        if elevation {
            strike.elevation = drawn.elevation.clamp(0.0, STEEPEST);
        }
        if side || height {
            let most = struck.largest_offset;
            // Exactly 1, which changes no bit, up to the largest offset. `min` also turns the NaN of
            // a centred strike with a tip without friction into 1.
            let back = (most / drawn.offset().max(most)).min(1.0);
            (strike.side, strike.height) = (drawn.side * back, drawn.height * back);
        }
        strike
    }

    /// The contacts that cling in variant `index` of this seed. A contact that clings with one
    /// probability clings with every higher one.
    pub fn draw_cling(&self, seed: u64, index: u64) -> Cling {
        if self.cling_probability == 0.0 {
            return Cling::NONE;
        }
        let mut random = random(CLING_KEY, seed, index);
        let contacts = (0..MOST_CONTACTS).filter(|_| {
            // In (0, 1], so that a probability of 1 is certain and one of 0 impossible.
            positive_unit(&mut random) <= self.cling_probability
        });
        Cling::new(contacts, self.cling_friction)
    }

    /// `shot` with the contacts that cling in variant `index` of this seed. If this noise has no
    /// cling, those of the shot remain.
    pub fn with_cling<'a>(&self, shot: &'a Shot, seed: u64, index: u64) -> Cow<'a, Shot> {
        if self.cling_probability == 0.0 {
            return Cow::Borrowed(shot);
        }
        Cow::Owned(shot.with_cling(self.draw_cling(seed, index)))
    }
}

/// What limits the strikes of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StruckBall {
    /// The ball's radius, m.
    pub radius: f64,
    /// The largest tip offset of a drawn strike, in ball radii.
    pub largest_offset: f64,
}

impl StruckBall {
    /// `ball`, struck with the cue and by the policies of `shot`.
    pub fn of(shot: &Shot, ball: &Ball) -> Self {
        // If miscues are only reported, this friction is so large that the limit is the ball.
        let limit = miscue_limit(shot.physics().cue.tip_friction).min(1.0);
        Self { radius: ball.radius, largest_offset: OFFSET_KEPT * limit }
    }
}

/// An error with the offsets in ball radii, as a strike has them, from one in metres.
fn in_radii([speed, azimuth, elevation, side, height]: [f64; 5], radius: f64) -> [f64; 5] {
    [speed, azimuth, elevation, side / radius, height / radius]
}

/// `meant` with an error of speed, azimuth, elevation, side and height.
fn added(meant: &Strike, error: &[f64; 5]) -> Strike {
    // Adding 0 would change the sign of −0.
    let add = |meant: f64, error: f64| if error == 0.0 { meant } else { meant + error };
    Strike {
        speed: add(meant.speed, error[0]),
        azimuth: add(meant.azimuth, error[1]),
        elevation: add(meant.elevation, error[2]),
        side: add(meant.side, error[3]),
        height: add(meant.height, error[4]),
    }
}

/// The errors of a player, and the seed of their random numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Errors {
    /// Errors of the strike, and the contacts that cling.
    pub noise: Noise,
    /// Errors of the perceived positions.
    pub perception: Perception,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Errors {
    /// Rejects numbers out of their ranges.
    ///
    /// # Errors
    /// As [`Noise::check`] and [`Perception::check`].
    pub fn check(&self) -> Result<(), Error> {
        self.noise.check()?;
        self.perception.check()
    }

    /// Whether the variants of a shot differ in their strikes alone.
    pub fn are_of_the_strike(&self) -> bool {
        self.perception.is_exact() && self.noise.cling_probability == 0.0
    }

    /// `shot` in variant `index`, with this strike: the balls where they truly lie, and the contacts
    /// that cling.
    ///
    /// # Errors
    /// As [`Shot::with_balls`], if there is an error of perception.
    pub fn shot<'a>(
        &self,
        shot: &'a Shot,
        strike: Option<(usize, Strike)>,
        index: u64,
    ) -> Result<Cow<'a, Shot>, Error> {
        let clung = self.noise.with_cling(shot, self.seed, index);
        if self.perception.is_exact() {
            return Ok(clung);
        }
        let places = self.perception.places(shot, self.seed, index);
        Ok(Cow::Owned(clung.with_balls(places, strike)?))
    }

    /// Turns `variant` into `shot` in variant `index`, with the strike of `shot`. As [`Self::shot`],
    /// but in the memory of `variant`: nothing is allocated if it was a variant of `shot` before.
    /// Strikes are not checked.
    pub fn write_shot(&self, shot: &Shot, index: u64, variant: &mut Shot) {
        let cling = match self.noise.cling_probability {
            0.0 => *shot.cling(),
            _ => self.noise.draw_cling(self.seed, index),
        };
        let balls = variant.become_variant(shot, cling);
        if !self.perception.is_exact() {
            self.perception.displace(balls, shot.table(), self.seed, index);
        }
    }
}

/// Six independent normal deviates, of mean 0 and variance 1.
fn normal_deviates(seed: u64, index: u64) -> [f64; 6] {
    let mut random = random(STRIKE_KEY, seed, index);
    let mut deviates = [0.0; 6];
    for pair in deviates.as_chunks_mut().0 {
        *pair = normal_pair(&mut random);
    }
    deviates
}

/// The generator of `index` of this seed; `purpose` separates it from others of the same seed.
pub(crate) fn random(purpose: &[u8; 24], seed: u64, index: u64) -> ChaCha8Rng {
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key[8..].copy_from_slice(purpose);
    let mut random = ChaCha8Rng::from_seed(key);
    random.set_stream(index);
    random
}

/// Two independent normal deviates (Box & Muller 1958).
fn normal_pair(random: &mut impl Rng) -> [f64; 2] {
    let length = sqrt(-2.0 * log(positive_unit(random)));
    let (sin, cos) = sin_cos(TAU * positive_unit(random));
    [length * cos, length * sin]
}

/// Uniform in (0, 1], in steps of 2⁻⁵³: never 0, whose logarithm is infinite.
fn positive_unit(random: &mut impl Rng) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
    ((random.next_u64() >> 11) + 1) as f64 * STEP
}
