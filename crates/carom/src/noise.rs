//! Execution noise: the random error of a player's strike; and perception: the random error of the
//! positions at which a player sees the balls.
//!
//! Every parameter of the strike has a Gaussian error of its own, independent of the others, as in
//! the Computational Olympiad (Archibald, Altman & Shoham, *Analysis of a winning computational
//! billiards player*, 2009).
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
//! A cue never points upwards: an elevation below 0 becomes 0. Any other variant that would be
//! refused in a shot file fails with the same error: a speed ≤ 0, an elevation of 90° or more, a
//! tip that misses the ball or slips off it (unless `strike.miscue` says that miscues are played).

use alloc::borrow::Cow;
use alloc::vec::Vec;
use core::f64::consts::{PI, TAU};

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use crate::error::Error;
use crate::math::{log, radians, sin_cos, sqrt};
use crate::physics::ball_surface::CHALKED;
use crate::range::Range;
use crate::resolve::cue_ball::Strike;
use crate::shot::{self, Cling, MOST_CONTACTS, PlacedBall, Shot};

/// Part of the generator's key that separates these random numbers from others of the same seed.
const STRIKE_KEY: &[u8; 24] = b"carom: noise of a strike";
/// The same for perception.
const PERCEPTION_KEY: &[u8; 24] = b"carom: sight of a layout";
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
/// σ of a perceived position: at most about two balls' diameters.
const POSITION: Range = Range::closed(0.0, 0.1, " m");

/// Levels of play, the weakest first.
///
/// **Estimated.** Tests of players order the levels and show that better players also spread less
/// (Pan, Komar & Kong, *Development of new 9-ball test protocols for assessing expertise in cue
/// sports*, 2021; Haar, van Assel & Faisal, *Motor learning in real-world pool billiards*, 2020),
/// but we found none that measures the σ of the cue's motion. The σ of the direction about halves
/// from level to level, around the Olympiad's 0.125°; docs/evaluate.md shows its effect on shots.
pub const SKILLS: [(&str, Noise); 5] = [
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

/// Standard deviations of a strike's errors, and how often two balls cling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Of the cue's speed, m/s; 0 to 15.
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
    };

    /// The Computational Olympiad's noise times `multiplier`; its tournaments were played at 0.5, 1
    /// and 2. σ: offsets 0.5 mm each, elevation 0.1°, azimuth 0.125°, speed 0.075 m/s.
    pub const fn olympiad(multiplier: f64) -> Self {
        Self {
            speed: 0.075,
            azimuth: radians(0.125),
            elevation: radians(0.1),
            side_m: 0.000_5,
            height_m: 0.000_5,
            ..Self::NONE
        }
        .scaled(multiplier)
    }

    /// The preset of that name: one of [`SKILLS`], or `olympiad`.
    pub fn preset(name: &str) -> Option<Self> {
        let skill = SKILLS.iter().find(|skill| skill.0 == name).map(|skill| skill.1);
        skill.or_else(|| (name == "olympiad").then(|| Self::olympiad(1.0)))
    }

    /// This noise with every σ multiplied by `multiplier`. The cling stays,
    /// because it does not depend on the player.
    #[must_use]
    pub const fn scaled(self, multiplier: f64) -> Self {
        Self {
            speed: self.speed * multiplier,
            azimuth: self.azimuth * multiplier,
            elevation: self.elevation * multiplier,
            side_m: self.side_m * multiplier,
            height_m: self.height_m * multiplier,
            ..self
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
        ] {
            range.check(|| alloc::format!("noise.{key}"), value)?;
        }
        Ok(())
    }

    /// Variant `index` of the strike `meant`. `radius` is that of the struck ball, m.
    pub fn draw(&self, meant: &Strike, radius: f64, seed: u64, index: u64) -> Strike {
        let [speed, azimuth, elevation, side, height, _] = normal_deviates(seed, index);
        Strike {
            speed: meant.speed + self.speed * speed,
            azimuth: meant.azimuth + self.azimuth * azimuth,
            elevation: (meant.elevation + self.elevation * elevation).max(0.0),
            side: meant.side + self.side_m / radius * side,
            height: meant.height + self.height_m / radius * height,
        }
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

/// Standard deviation of true minus perceived position: independent Gaussian errors of x and y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Perception {
    /// Of each coordinate of each ball, m; 0 to 0.1.
    pub position: f64,
}

/// The most errors that are tried for a ball, each half as large as the one before, until one
/// leaves room for the ball. If none does, the ball keeps its position.
const MAX_TRIES: u32 = 8;

impl Perception {
    /// Rejects a standard deviation out of its range.
    ///
    /// # Errors
    /// [`Error::Input`] for a σ that is negative, not finite, or larger than 0.1 m.
    pub fn check(&self) -> Result<(), Error> {
        POSITION.check(|| "perception.position".into(), self.position)
    }

    /// Layout `index` of this seed: `shot` with the balls of [`Self::places`].
    ///
    /// # Errors
    /// As [`Self::check`], and as [`Shot::with_layout`] for a strike that cannot be played there.
    pub fn draw(&self, shot: &Shot, seed: u64, index: u64) -> Result<Shot, Error> {
        self.check()?;
        shot.with_layout(self.places(shot, seed, index))
    }

    /// The balls of `shot` with their positions in layout `index` of this seed. The balls are moved
    /// in the order of the shot. A ball that would overlap another or leave the table gets a
    /// smaller error.
    pub fn places(&self, shot: &Shot, seed: u64, index: u64) -> Vec<PlacedBall> {
        let mut random = random(PERCEPTION_KEY, seed, index);
        let mut balls = shot.balls().to_vec();
        for i in 0..balls.len() {
            let mut error = normal_pair(&mut random).map(|deviate| self.position * deviate);
            let own = balls[i].state.position;
            for _ in 0..MAX_TRIES {
                balls[i].state.position.x = own.x + error[0];
                balls[i].state.position.y = own.y + error[1];
                if shot::fits(i, &balls, shot.table()) {
                    break;
                }
                balls[i].state.position = own;
                error = error.map(|x| 0.5 * x);
            }
        }
        balls
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
