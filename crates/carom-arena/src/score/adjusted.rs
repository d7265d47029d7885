//! The share of the points, corrected for luck.
//!
//! The luck ℓ of a pair ([`crate::ShotLuck`]) has the mean 0, so the share of the points x and every
//! x − wℓ have the same mean: ℓ is a control variate. The weight w with the smallest variance is the
//! slope of x on ℓ; it is 1 for the true value of positions, and 0 for one that says nothing (White &
//! Bowling 2009, *Learning a value analysis tool for agent evaluation*, learn the whole value). The
//! weight of each pair is estimated from the other pairs alone, so it does not depend on the pair's
//! luck, and the corrected share is unbiased.

use carom::math::sqrt;
use carom_plan::{Interval, two_sided_quantile};

use super::{EVEN_VARIANCE, PRIOR_PAIRS};

/// Number of pairs with the weight 1 that are added to the estimate of a weight: after a few pairs it
/// stays near 1.
const PAIRS_OF_WEIGHT_1: f64 = 10.0;

/// The shares of the points and the luck of the pairs of a match.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AdjustedPairs {
    /// For each pair the share of the points of player 0, and its luck: the mean over both frames.
    pairs: Vec<[f64; 2]>,
}

/// The share of the points of player 0, corrected for luck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdjustedShare {
    /// The share. It may lie a little outside of [0, 1].
    pub share: f64,
    /// Its confidence interval, from whole pairs and within [0, 1].
    pub interval: Interval,
    /// The mean weight of the luck.
    pub weight: f64,
    /// The variance of a pair's share, divided by that of the corrected one. Without the correction
    /// this number of times more pairs would have the same interval. `None` if all pairs are equal.
    pub saved: Option<f64>,
}

impl AdjustedPairs {
    /// Adds a pair: the share of its points of player 0, and the mean luck of player 0 in its frames.
    pub fn add(&mut self, share: f64, luck: f64) {
        self.pairs.push([share, luck]);
    }

    /// Number of pairs.
    pub fn pairs(&self) -> u64 {
        self.pairs.len() as u64
    }

    /// The corrected share, with its confidence interval at `level`: mean ± z·√(σ²/N). To the
    /// variance σ² of the N corrected shares ten pairs are added, as for
    /// [`crate::PairScores::interval`]. Their variance is that of even frames times the share of the
    /// variance that remains. `None` without pairs.
    pub fn share(&self, level: f64) -> Option<AdjustedShare> {
        if self.pairs.is_empty() {
            return None;
        }
        let n = self.pairs.len() as f64;
        let weights = self.weights();
        let corrected: Vec<f64> = self.pairs.iter().zip(&weights).map(corrected).collect();
        let share = corrected.iter().sum::<f64>() / n;
        let squares = sum_of_squares(corrected.iter().copied());
        let raw = sum_of_squares(self.pairs.iter().map(|[share, _]| *share));
        let prior = PRIOR_PAIRS * EVEN_VARIANCE;
        let remaining = (squares + prior) / (raw + prior);
        let variance = (squares + remaining * prior) / (n + PRIOR_PAIRS);
        let half = two_sided_quantile(level) * sqrt(variance / n);
        let interval = Interval { low: (share - half).max(0.0), high: (share + half).min(1.0) };
        let weight = weights.iter().sum::<f64>() / n;
        Some(AdjustedShare { share, interval, weight, saved: ratio(raw, squares) })
    }

    /// The weight of each pair's luck: the slope of the share on the luck in the other pairs.
    fn weights(&self) -> Vec<f64> {
        let others = self.pairs.len() as f64 - 1.0;
        let total = |f: fn(&[f64; 2]) -> f64| self.pairs.iter().map(f).sum::<f64>();
        let (share, luck) = (total(|pair| pair[0]), total(|pair| pair[1]));
        let (product, square) = (total(|pair| pair[0] * pair[1]), total(|pair| pair[1] * pair[1]));
        let of_others = |[x, l]: &[f64; 2]| {
            let square = square - l * l;
            if square <= 0.0 {
                return 1.0;
            }
            // The mean of the luck is known to be 0, and is not estimated.
            let slope = (product - x * l - (share - x) / others * (luck - l)) / square;
            (others * slope + PAIRS_OF_WEIGHT_1) / (others + PAIRS_OF_WEIGHT_1)
        };
        self.pairs.iter().map(of_others).collect()
    }
}

fn corrected(([share, luck], weight): (&[f64; 2], &f64)) -> f64 {
    share - weight * luck
}

/// The sum of the squared deviations from the mean.
fn sum_of_squares(values: impl ExactSizeIterator<Item = f64> + Clone) -> f64 {
    let n = values.len() as f64;
    let mean = values.clone().sum::<f64>() / n;
    values.map(|value| (value - mean) * (value - mean)).sum()
}

fn ratio(of: f64, to: f64) -> Option<f64> {
    (of > 0.0 && to > 0.0).then(|| of / to)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniform numbers in [0, 1).
    struct Uniform(u64);

    impl Uniform {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    /// Pairs with an expected share of 0.6: each of two frames is won if a sum of twelve steps, which
    /// are the luck, is large enough. `scale` multiplies the luck that is measured.
    fn pairs(count: usize, random: &mut Uniform, scale: f64) -> AdjustedPairs {
        let mut pairs = AdjustedPairs::default();
        for _ in 0..count {
            let [mut points, mut luck] = [0.0, 0.0];
            for _ in 0..2 {
                let known = random.next() - 0.5;
                let unknown = random.next() - 0.5;
                points += if 0.7 * known + 0.3 * unknown > -0.1 { 0.5 } else { 0.0 };
                luck += 0.5 * scale * known;
            }
            pairs.add(points, luck);
        }
        pairs
    }

    #[test]
    fn a_share_without_luck_is_the_share_of_the_points() {
        let mut pairs = AdjustedPairs::default();
        assert_eq!(pairs.share(0.95), None);
        for share in [0.5, 1.0, 0.0, 1.0] {
            pairs.add(share, 0.0);
        }
        let found = pairs.share(0.95).unwrap();
        assert_eq!((found.share, found.weight, found.saved), (0.625, 1.0, Some(1.0)));
        assert!(found.interval.low < 0.4 && found.interval.high > 0.85, "{found:?}");
    }

    #[test]
    fn luck_that_explains_all_leaves_no_variance() {
        let mut pairs = AdjustedPairs::default();
        let mut random = Uniform(1);
        for _ in 0..1000 {
            let luck = random.next() - 0.5;
            pairs.add(0.55 + luck, luck);
        }
        let found = pairs.share(0.95).unwrap();
        assert!((found.share - 0.55).abs() < 1e-3, "{found:?}");
        assert!(found.saved.unwrap() > 1000.0, "{found:?}");
    }

    #[test]
    fn the_weight_makes_up_for_a_value_on_a_wrong_scale() {
        let [right, wrong] =
            [1.0, 0.2].map(|scale| pairs(5000, &mut Uniform(3), scale).share(0.95).unwrap());
        assert!((wrong.weight / right.weight - 5.0).abs() < 0.3, "{right:?} {wrong:?}");
        assert!((wrong.saved.unwrap() / right.saved.unwrap() - 1.0).abs() < 0.02);
        assert!(right.saved.unwrap() > 1.8, "{right:?}");
    }

    #[test]
    fn intervals_cover_the_true_share_and_the_mean_is_unbiased() {
        // The true share: 0.7 u + 0.3 v > -0.1 with u and v uniform in [-1/2, 1/2].
        let truth = 0.5 + 0.1 / 0.7;
        for count in [20, 200] {
            let mut random = Uniform(7);
            let (mut covered, mut sum) = (0, 0.0);
            for _ in 0..2000 {
                let found = pairs(count, &mut random, 0.7).share(0.95).unwrap();
                let Interval { low, high } = found.interval;
                covered += u32::from(low <= truth && truth <= high);
                sum += found.share / 2000.0;
            }
            assert!((1860..=1960).contains(&covered), "{covered} of 2000 with {count} pairs");
            assert!(
                (sum - truth).abs() < 4.0 * 0.25 / f64::from(2000 * count as u32).sqrt(),
                "{sum}"
            );
        }
    }
}
