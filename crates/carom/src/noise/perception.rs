//! Errors of the positions at which a player, or a camera, sees the balls.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{normal_pair, random};
use crate::Table;
use crate::error::Error;
use crate::math::sqrt;
use crate::range::Range;
use crate::shot::{self, PlacedBall, Shot};

/// Part of the generator's key that separates these random numbers from others of the same seed.
const PERCEPTION_KEY: &[u8; 24] = b"carom: sight of a layout";

/// σ of a perceived position: at most about two balls' diameters.
const POSITION: Range = Range::closed(0.0, 0.1, " m");
/// A coefficient of correlation.
const CORRELATION: Range = Range::closed(-1.0, 1.0, "");

/// Gaussian error of a position, true minus perceived, of mean 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PositionError {
    /// Standard deviations along x and y, m; 0 to 0.1.
    pub sigma: [f64; 2],
    /// Correlation of the two, −1 to 1.
    pub correlation: f64,
}

impl PositionError {
    /// The same error along x and y, independent of each other: `sigma` in m.
    pub const fn round(sigma: f64) -> Self {
        Self { sigma: [sigma; 2], correlation: 0.0 }
    }

    /// The error that belongs to two independent deviates of variance 1, m.
    fn of(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        let r = self.correlation;
        let along_y = if r == 0.0 { second } else { r * first + sqrt(1.0 - r * r) * second };
        [self.sigma[0] * first, self.sigma[1] * along_y]
    }

    fn check(&self, place: &str) -> Result<(), Error> {
        for sigma in self.sigma {
            POSITION.check(|| format!("{place}.position"), sigma)?;
        }
        CORRELATION.check(|| format!("{place}.correlation"), self.correlation)
    }
}

/// Errors of the positions at which a player perceives the balls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Perception {
    /// Of every ball that [`Self::balls`] does not name.
    pub position: PositionError,
    /// Of single balls, by id, in place of [`Self::position`]. A ball that is not there has no effect.
    pub balls: Option<Arc<BTreeMap<String, PositionError>>>,
}

/// The most errors that are tried for a ball, each half as large as the one before, until one
/// leaves room for the ball. If none does, the ball keeps its position.
const MAX_TRIES: u32 = 8;

impl Perception {
    /// Rejects a standard deviation out of its range.
    ///
    /// # Errors
    /// [`Error::Input`] for a σ that is negative, not finite, or larger than 0.1 m, and for a
    /// correlation outside −1..=1.
    pub fn check(&self) -> Result<(), Error> {
        self.position.check("perception")?;
        for (id, error) in self.balls.iter().flat_map(|balls| balls.iter()) {
            error.check(&format!("perception.balls[{id:?}]"))?;
        }
        Ok(())
    }

    /// The same error of every coordinate of every ball: `sigma` in m.
    pub const fn round(sigma: f64) -> Self {
        Self { position: PositionError::round(sigma), balls: None }
    }

    /// Whether all positions are perceived exactly.
    pub fn is_exact(&self) -> bool {
        let mut all = core::iter::once(&self.position)
            .chain(self.balls.iter().flat_map(|balls| balls.values()));
        all.all(|error| error.sigma == [0.0; 2])
    }

    /// The error of the ball with this id.
    fn of(&self, id: &str) -> &PositionError {
        self.balls.as_ref().and_then(|balls| balls.get(id)).unwrap_or(&self.position)
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
        let mut balls = shot.balls().to_vec();
        self.displace(&mut balls, shot.table(), seed, index);
        balls
    }

    /// Moves `balls`, which have room on `table`, to their positions in layout `index` of this seed.
    pub(super) fn displace(&self, balls: &mut [PlacedBall], table: &Table, seed: u64, index: u64) {
        let mut random = random(PERCEPTION_KEY, seed, index);
        for i in 0..balls.len() {
            let mut error = self.of(&balls[i].id).of(normal_pair(&mut random));
            let own = balls[i].state.position;
            for _ in 0..MAX_TRIES {
                balls[i].state.position.x = own.x + error[0];
                balls[i].state.position.y = own.y + error[1];
                if shot::fits(i, balls, table) {
                    break;
                }
                balls[i].state.position = own;
                error = error.map(|x| 0.5 * x);
            }
        }
    }
}
