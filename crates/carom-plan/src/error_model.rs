//! The errors of a player, and the sampling of a probability up to a precision.

use carom::math::sqrt;
use carom::noise::{Errors, Perception};
use carom::{Error, ErrorKind, Noise};

use crate::interval::{Interval, clustered, wilson};
use crate::progress::Progress;

/// Variants between two checks of one probability's precision. A nearly certain probability needs
/// few variants, so checks are frequent. A check costs little compared with 128 variants.
const VARIANTS_BETWEEN_CHECKS: u64 = 128;

/// The errors of a player, and the sampling of a probability up to a precision.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorModel {
    /// Errors of the strike.
    pub noise: Noise,
    /// Errors of the balls' perceived positions. The shot is what the player perceives and plans;
    /// every variant has a layout of its own around it. The tip meets the cue ball at its true
    /// position: errors of the contact point belong to `noise`.
    pub perception: Perception,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Largest number of variants.
    pub variants: u64,
    /// Half the width of the confidence interval at which sampling stops early, in (0, 0.5). None
    /// plays all variants.
    pub half_width: Option<f64>,
    /// Confidence level of all intervals, in (0, 1).
    pub level: f64,
}

impl Default for ErrorModel {
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

impl ErrorModel {
    /// Rejects an invalid standard deviation, confidence level or half-width.
    ///
    /// # Errors
    /// [`Error::Input`] for what [`Noise::check`] and [`Perception::check`] reject, and for a level
    /// or a half-width out of range.
    pub fn check(&self) -> Result<(), Error> {
        self.errors().check()?;
        check_level(self.level)?;
        self.half_width.map_or(Ok(()), check_half_width)
    }

    /// The errors and their seed.
    pub fn errors(&self) -> Errors {
        let Self { noise, perception, seed, .. } = self;
        Errors { noise: noise.clone(), perception: perception.clone(), seed: *seed }
    }

    /// Whether the probabilities with these `counts` among `trials` have the requested precision.
    /// False if there is no requested precision.
    pub(crate) fn is_precise(&self, counts: impl IntoIterator<Item = u64>, trials: u64) -> bool {
        let chances =
            counts.into_iter().map(|met| ChanceByTable(vec![Chance { met, variants: trials }]));
        self.are_precise(chances)
    }

    /// Whether these probabilities have the requested precision. False if there is none.
    pub(crate) fn are_precise(&self, chances: impl IntoIterator<Item = ChanceByTable>) -> bool {
        self.half_width.is_some_and(|wanted| {
            chances.into_iter().all(|chance| chance.interval(self.level).half_width() <= wanted)
        })
    }

    /// The probability that `happens` holds for a variant, counted until it is precise enough;
    /// the variants take turns on `tables` tables. A stopped `progress` ends the count early.
    pub(crate) fn count(
        &self,
        tables: usize,
        progress: &Progress,
        mut happens: impl FnMut(u64) -> bool,
    ) -> ChanceByTable {
        let mut chance = ChanceByTable(vec![Chance::default(); tables]);
        let mut played = 0;
        while played < self.variants && !progress.is_stopped() {
            let end = self.variants.min(played + VARIANTS_BETWEEN_CHECKS);
            for k in played..end {
                let table = &mut chance.0[(k % tables as u64) as usize];
                table.met += u64::from(happens(k));
                table.variants += 1;
            }
            played = end;
            if self.are_precise([chance.clone()]) {
                break;
            }
        }
        chance
    }
}

/// Rejects an invalid confidence level.
///
/// # Errors
/// [`Error::Input`] unless it is between 0 and 1.
pub fn check_level(level: f64) -> Result<(), Error> {
    if level > 0.0 && level < 1.0 {
        return Ok(());
    }
    let what = format!("{level:?} is not a confidence level");
    Err(ErrorKind::OutOfRange.at("level", what, "give a number between 0 and 1, such as 0.95"))
}

/// Rejects an invalid half-width.
fn check_half_width(half_width: f64) -> Result<(), Error> {
    if half_width > 0.0 && half_width < 0.5 {
        return Ok(());
    }
    let what = format!("{half_width:?} is not a half-width of a probability's interval");
    Err(ErrorKind::OutOfRange.at(
        "precision",
        what,
        "give a number between 0 and 0.5, such as 0.01",
    ))
}

/// A probability that was counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chance {
    /// Number of variants in which it happened.
    pub met: u64,
    /// Number of variants.
    pub variants: u64,
}

impl Chance {
    /// The share of variants in which it happened; NaN without variants.
    pub fn share(self) -> f64 {
        self.met as f64 / self.variants as f64
    }

    /// Its confidence interval.
    pub fn interval(self, level: f64) -> Interval {
        wilson(self.met, self.variants, level)
    }

    /// Compares the shares of two chances, exactly: equal shares of different numbers of variants
    /// are equal.
    pub(crate) fn compare(self, other: Self) -> core::cmp::Ordering {
        let scaled = |a: u64, b: u64| u128::from(a) * u128::from(b);
        scaled(self.met, other.variants).cmp(&scaled(other.met, self.variants))
    }
}

/// A probability that was counted on several tables, of which each may be the true one; or on one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChanceByTable(pub Vec<Chance>);

impl ChanceByTable {
    /// The probability over all tables.
    pub fn total(&self) -> Chance {
        self.0.iter().fold(Chance::default(), |sum, one| Chance {
            met: sum.met + one.met,
            variants: sum.variants + one.variants,
        })
    }

    /// The confidence interval of that; several tables are clusters ([`clustered`]).
    pub fn interval(&self, level: f64) -> Interval {
        match self.0.as_slice() {
            [one] => one.interval(level),
            tables => {
                let counts: Vec<_> = tables.iter().map(|one| (one.met, one.variants)).collect();
                clustered(&counts, level)
            }
        }
    }

    /// Standard deviation of the probability from one table to another: the variance of the shares
    /// less that of counting. NaN unless two tables have two variants each.
    pub fn spread(&self) -> f64 {
        let counted: Vec<_> = self.0.iter().filter(|one| one.variants > 1).collect();
        if counted.len() < 2 {
            return f64::NAN;
        }
        let tables = counted.len() as f64;
        let mean = counted.iter().map(|one| one.share()).sum::<f64>() / tables;
        let square = |share: f64| (share - mean) * (share - mean);
        let variance = counted.iter().map(|one| square(one.share())).sum::<f64>() / (tables - 1.0);
        let counting = |one: &Chance| one.share() * (1.0 - one.share()) / (one.variants - 1) as f64;
        let counting = counted.iter().map(|one| counting(one)).sum::<f64>() / tables;
        sqrt((variance - counting).max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::{Chance, ChanceByTable, ErrorModel, Progress, VARIANTS_BETWEEN_CHECKS};

    #[test]
    fn the_spread_of_tables_is_free_of_the_noise_of_counting() {
        let chance = |rows: &[(u64, u64)]| {
            ChanceByTable(rows.iter().map(|&(met, variants)| Chance { met, variants }).collect())
        };
        // Shares 0, 1/2 and 1: variance 1/4, and of counting (0 + 1/4 / 9 + 0) / 3.
        let three = chance(&[(0, 10), (5, 10), (10, 10)]);
        assert!((three.spread() - (0.25_f64 - 1.0 / 108.0).sqrt()).abs() < 1e-15);
        assert_eq!(chance(&[(5, 10), (5, 10)]).spread(), 0.0);
        assert!(chance(&[(5, 10), (1, 1)]).spread().is_nan());
    }

    #[test]
    fn counting_ends_at_the_first_check_that_finds_the_chance_precise() {
        let progress = Progress::default();
        let model =
            ErrorModel { variants: 10_000, half_width: Some(0.05), ..ErrorModel::default() };
        let half = model.count(1, &progress, |k| k % 2 == 0).total();
        let width = |variants| Chance { met: variants / 2, variants }.interval(0.95).half_width();
        assert!(width(half.variants) <= 0.05);
        assert!(width(half.variants - VARIANTS_BETWEEN_CHECKS) > 0.05);
        // A certain event is precise sooner.
        let first_check =
            Chance { met: VARIANTS_BETWEEN_CHECKS, variants: VARIANTS_BETWEEN_CHECKS };
        assert_eq!(model.count(1, &progress, |_| true).total(), first_check);
        let all = ErrorModel { half_width: None, ..model }.count(1, &progress, |k| k < 3);
        assert_eq!(all.total(), Chance { met: 3, variants: 10_000 });
    }

    #[test]
    fn a_table_that_decides_the_result_needs_more_tables_and_not_more_variants() {
        let progress = Progress::default();
        let model =
            ErrorModel { variants: 10_000, half_width: Some(0.05), ..ErrorModel::default() };
        // On every fourth of 20 tables it always happens.
        let decided = model.count(20, &progress, |k| k % 4 == 0);
        assert_eq!(decided.total(), Chance { met: 2500, variants: 10_000 });
        assert_eq!(decided.0[4], Chance { met: 500, variants: 500 });
        assert_eq!(decided.0[5], Chance { met: 0, variants: 500 });
        assert!(decided.interval(0.95).half_width() > 0.15);
        assert_eq!(
            ChanceByTable(vec![decided.total()]).interval(0.95),
            decided.total().interval(0.95)
        );
    }

    #[test]
    fn a_stopped_count_ends_at_the_next_check() {
        let progress = Progress::default();
        let model = ErrorModel { variants: u64::MAX, ..ErrorModel::default() };
        let chance = model.count(3, &progress, |k| {
            if k == 200 {
                progress.stop();
            }
            true
        });
        assert_eq!(chance.total().variants, 2 * VARIANTS_BETWEEN_CHECKS);
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
