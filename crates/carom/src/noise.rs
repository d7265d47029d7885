//! Execution noise: how far a player's strike strays from what was meant; and [`Perception`], how far from
//! where they are the balls are seen.
//!
//! Every parameter of the strike errs by a Gaussian of its own, independent of the others, as in the
//! Computational Olympiad (Archibald, Altman & Shoham, *Analysis of a winning computational
//! billiards player*, 2009).
//!
//! # The random numbers
//!
//! Error `index` of a seed is a function of the two and of nothing else: ChaCha8 (Bernstein 2008)
//! with the seed in its key and the index as its stream, uniform numbers of 53 bits, and normal
//! deviates by Box & Muller (1958) with this crate's own arithmetic. So variant 17 is the same
//! alone or among thousands, in any order, for any number of threads, on every platform. Every
//! parameter has its own deviate, whether or not it errs: to change one σ moves nothing else.
//!
//! # What cannot be played
//!
//! A cue never points upwards: an elevation below 0 becomes 0. All else that a shot file would
//! refuse fails as it would there: a speed ≤ 0, an elevation of 90° and more, a tip that misses the
//! ball or slips off it (the latter only if the shot does not ask for miscues to be played:
//! `strike.miscue`).

use alloc::vec::Vec;
use core::f64::consts::TAU;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use crate::error::Error;
use crate::math::{log, radians, sin_cos, sqrt};
use crate::range::Range;
use crate::resolve::cue_ball::Strike;
use crate::shot::{self, PlacedBall, Shot};

/// Tells these random numbers from all others that have the same seed.
const PURPOSE: &[u8; 24] = b"carom: noise of a strike";
/// The same of what is seen.
const SIGHT_OF_BALLS: &[u8; 24] = b"carom: sight of a layout";

/// Largest σ of a tip offset, m: a third of a ball's radius. Larger ones are in other units by mistake.
const OFFSET: Range = Range::closed(0.0, 0.01, " m");
/// Largest σ of an angle: half a turn, beyond which every direction is as likely.
const ANGLE: Range = Range::closed(0.0, core::f64::consts::PI, " rad");
/// Largest σ of the cue's speed: that of the fastest breaks.
const SPEED: Range = Range::closed(0.0, 15.0, " m/s");

/// Largest σ of a seen position, m: a ball's width and more.
const SIGHT: Range = Range::closed(0.0, 0.1, " m");

/// Levels of play, from the least.
///
/// **Estimated.** Tests of players order the levels, and show that the better ones also spread less (Pan,
/// Komar & Kong, *Development of new 9-ball test protocols for assessing expertise in cue sports*, 2021;
/// Haar, van Assel & Faisal, *Motor learning in real-world pool billiards*, 2020), but none that we found
/// gives the σ of what a cue does. Directions halve from level to level, about the Olympiad's 0.125°; what
/// they mean at the table is measured on the documentation's page of evaluations.
pub const SKILLS: [(&str, Noise); 5] = [
    ("beginner", skill(0.40, 0.60, 2.0, 3.0)),
    ("casual", skill(0.25, 0.30, 1.5, 2.0)),
    ("club", skill(0.15, 0.15, 1.0, 1.2)),
    ("advanced", skill(0.10, 0.08, 0.6, 0.8)),
    ("professional", skill(0.06, 0.04, 0.3, 0.4)),
];

/// σ of speed (m/s), azimuth and elevation (degrees), and of either tip offset (mm).
const fn skill(speed: f64, azimuth: f64, elevation: f64, offset: f64) -> Noise {
    Noise {
        speed,
        azimuth: radians(azimuth),
        elevation: radians(elevation),
        side: 0.001 * offset,
        height: 0.001 * offset,
    }
}

/// Standard deviations of a strike's errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Of the cue's speed, m/s.
    pub speed: f64,
    /// Of the cue's direction, rad.
    pub azimuth: f64,
    /// Of the cue's elevation, rad.
    pub elevation: f64,
    /// Of the contact point to the side, m: a hand's error does not know the ball's radius.
    pub side: f64,
    /// Of the contact point's height, m.
    pub height: f64,
}

impl Noise {
    /// The Computational Olympiad's noise times `multiplier`; its tournaments were played at 0.5, 1
    /// and 2. σ: offsets 0.5 mm each, elevation 0.1°, azimuth 0.125°, speed 0.075 m/s.
    pub const fn olympiad(multiplier: f64) -> Self {
        Self {
            speed: 0.075,
            azimuth: radians(0.125),
            elevation: radians(0.1),
            side: 0.000_5,
            height: 0.000_5,
        }
        .scaled(multiplier)
    }

    /// The preset of that name: one of [`SKILLS`], or `olympiad`.
    pub fn preset(name: &str) -> Option<Self> {
        let skill = SKILLS.iter().find(|skill| skill.0 == name).map(|skill| skill.1);
        skill.or_else(|| (name == "olympiad").then(|| Self::olympiad(1.0)))
    }

    /// The same with every σ times `multiplier`.
    #[must_use]
    pub const fn scaled(self, multiplier: f64) -> Self {
        Self {
            speed: self.speed * multiplier,
            azimuth: self.azimuth * multiplier,
            elevation: self.elevation * multiplier,
            side: self.side * multiplier,
            height: self.height * multiplier,
        }
    }

    /// Refuses what is no standard deviation.
    ///
    /// # Errors
    /// [`Error::Input`] for a σ that is negative, not finite, or beyond all sense.
    pub fn check(&self) -> Result<(), Error> {
        for (key, value, range) in [
            ("speed", self.speed, SPEED),
            ("azimuth", self.azimuth, ANGLE),
            ("elevation", self.elevation, ANGLE),
            ("side", self.side, OFFSET),
            ("height", self.height, OFFSET),
        ] {
            range.check(|| alloc::format!("noise.{key}"), value)?;
        }
        Ok(())
    }

    /// Strike `index` of those that come out when `meant` is meant. `radius`: of the struck ball, m.
    pub fn draw(&self, meant: &Strike, radius: f64, seed: u64, index: u64) -> Strike {
        let [speed, azimuth, elevation, side, height, _] = normal_deviates(seed, index);
        Strike {
            speed: meant.speed + self.speed * speed,
            azimuth: meant.azimuth + self.azimuth * azimuth,
            elevation: (meant.elevation + self.elevation * elevation).max(0.0),
            side: meant.side + self.side / radius * side,
            height: meant.height + self.height / radius * height,
        }
    }
}

/// How far from where they are a player sees the balls: independent Gaussian errors of x and y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Perception {
    /// Standard deviation of each coordinate of each ball, m.
    pub position: f64,
}

/// A ball that would be seen where there is no room for it is seen half as far off, at most so many times;
/// then where it is.
const HALVINGS: u32 = 8;

impl Perception {
    /// Refuses what is no standard deviation.
    ///
    /// # Errors
    /// [`Error::Input`] for a σ that is negative, not finite, or beyond all sense.
    pub fn check(&self) -> Result<(), Error> {
        SIGHT.check(|| "perception.position".into(), self.position)
    }

    /// `shot` as it is seen the time number `index` of this seed; the balls are those of [`Self::places`].
    ///
    /// # Errors
    /// As [`Self::check`], and what a strike that cannot be played on the seen balls is refused for.
    pub fn draw(&self, shot: &Shot, seed: u64, index: u64) -> Result<Shot, Error> {
        self.check()?;
        shot.with_balls(self.places(shot, seed, index), shot.strike())
    }

    /// The balls of `shot` as they are seen the time number `index` of this seed. No ball is seen in
    /// another or outside the table: one that would be, in the order of the shot, is seen nearer to where it
    /// is.
    pub fn places(&self, shot: &Shot, seed: u64, index: u64) -> Vec<PlacedBall> {
        let mut random = random(SIGHT_OF_BALLS, seed, index);
        let mut balls = shot.balls().to_vec();
        for i in 0..balls.len() {
            let mut off = normal_pair(&mut random).map(|deviate| self.position * deviate);
            let there = balls[i].state.position;
            for _ in 0..HALVINGS {
                balls[i].state.position.x = there.x + off[0];
                balls[i].state.position.y = there.y + off[1];
                if shot::fits(i, &balls, shot.table()) {
                    break;
                }
                balls[i].state.position = there;
                off = off.map(|x| 0.5 * x);
            }
        }
        balls
    }
}

/// Six independent normal deviates, of mean 0 and variance 1.
fn normal_deviates(seed: u64, index: u64) -> [f64; 6] {
    let mut random = random(PURPOSE, seed, index);
    let mut deviates = [0.0; 6];
    for pair in deviates.chunks_exact_mut(2) {
        pair.copy_from_slice(&normal_pair(&mut random));
    }
    deviates
}

/// The random numbers of a purpose that belong to `index` of this seed.
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

/// Uniform in (0, 1], in steps of 2⁻⁵³: it has a logarithm.
fn positive_unit(random: &mut impl Rng) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
    ((random.next_u64() >> 11) + 1) as f64 * STEP
}
