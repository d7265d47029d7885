//! How a player errs, and how well a chance is to be known.

use carom::noise::Perception;
use carom::{Error, Noise};

use crate::interval::{Interval, wilson};

/// Variants between two looks at the precision of one chance: so few that what is nearly certain soon ends,
/// so many that the looks cost nothing.
const LOOK: u64 = 128;

/// How a player errs, and how well a chance is to be known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errs {
    /// How far a strike strays.
    pub noise: Noise,
    /// How far from where they are seen, and reckoned with, the balls truly lie.
    pub perception: Perception,
    /// Which random numbers.
    pub seed: u64,
    /// Variants behind a chance, at most; the same errors behind each.
    pub variants: u64,
    /// Stop before that when half the width of the chance's interval is at most this; looked at after
    /// every 128 variants.
    pub half_width: Option<f64>,
    /// Confidence of all intervals, in (0, 1).
    pub level: f64,
}

impl Default for Errs {
    fn default() -> Self {
        Self {
            noise: Noise::olympiad(1.0),
            perception: Perception::default(),
            seed: 0,
            variants: 1000,
            half_width: None,
            level: 0.95,
        }
    }
}

impl Errs {
    /// Refuses what is no standard deviation, no level, and no half-width.
    ///
    /// # Errors
    /// [`Error::Input`] for what [`Noise::check`] and [`Perception::check`] refuse, and for a level or a
    /// half-width out of range.
    pub fn check(&self) -> Result<(), Error> {
        self.noise.check()?;
        self.perception.check()?;
        check_level(self.level)?;
        self.half_width.map_or(Ok(()), check_half_width)
    }

    /// The chance of what `happens` to variant k, counted until it is known well enough.
    pub(crate) fn count(&self, mut happens: impl FnMut(u64) -> bool) -> Chance {
        let mut chance = Chance::default();
        while chance.variants < self.variants {
            let end = self.variants.min(chance.variants + LOOK);
            chance.met += (chance.variants..end).filter(|k| happens(*k)).count() as u64;
            chance.variants = end;
            let half_width = || chance.interval(self.level).half_width();
            if self.half_width.is_some_and(|wanted| half_width() <= wanted) {
                break;
            }
        }
        chance
    }
}

/// Refuses what is no confidence level.
///
/// # Errors
/// [`Error::Input`] unless it is between 0 and 1.
pub fn check_level(level: f64) -> Result<(), Error> {
    if level > 0.0 && level < 1.0 {
        return Ok(());
    }
    let what = format!("{level:?} is no confidence level");
    Err(Error::input("level", what, "give a number between 0 and 1, such as 0.95"))
}

/// Refuses what is no half-width.
pub(crate) fn check_half_width(half_width: f64) -> Result<(), Error> {
    if half_width > 0.0 && half_width < 0.5 {
        return Ok(());
    }
    let what = format!("{half_width:?} is no half-width of a probability's interval");
    Err(Error::input("precision", what, "give a number between 0 and 0.5, such as 0.01"))
}

/// A chance that was counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chance {
    /// In how many variants it happened.
    pub met: u64,
    /// Of how many.
    pub variants: u64,
}

impl Chance {
    /// The share in which it happened; NaN without variants.
    pub fn share(self) -> f64 {
        self.met as f64 / self.variants as f64
    }

    /// Its confidence interval.
    pub fn interval(self, level: f64) -> Interval {
        wilson(self.met, self.variants, level)
    }

    /// Whether it happened more often, as a share of its variants: equal ones are neither more nor less.
    pub(crate) fn compare(self, other: Self) -> core::cmp::Ordering {
        let scaled = |a: u64, b: u64| u128::from(a) * u128::from(b);
        scaled(self.met, other.variants).cmp(&scaled(other.met, self.variants))
    }
}

#[cfg(test)]
mod tests {
    use super::{Chance, Errs, LOOK};

    #[test]
    fn counting_ends_at_the_first_look_at_which_the_chance_is_known() {
        let errs = Errs { variants: 10_000, half_width: Some(0.05), ..Errs::default() };
        let half = errs.count(|k| k % 2 == 0);
        let width = |variants| Chance { met: variants / 2, variants }.interval(0.95).half_width();
        assert!(width(half.variants) <= 0.05 && width(half.variants - LOOK) > 0.05);
        // What is certain is known sooner.
        assert_eq!(errs.count(|_| true), Chance { met: LOOK, variants: LOOK });
        let all = Errs { half_width: None, ..errs }.count(|k| k < 3);
        assert_eq!(all, Chance { met: 3, variants: 10_000 });
    }

    #[test]
    fn chances_compare_as_shares() {
        use core::cmp::Ordering::{Equal, Greater, Less};
        let chance = |met, variants| Chance { met, variants };
        assert_eq!(chance(1, 2).compare(chance(500, 1000)), Equal);
        assert_eq!(chance(2, 3).compare(chance(600, 1000)), Greater);
        assert_eq!(chance(0, 3).compare(chance(1, 1000)), Less);
    }
}
