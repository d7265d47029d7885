//! Confidence intervals of probabilities that were counted.

use carom::math::sqrt;

/// Newton's iteration for the normal quantile ends when a step is smaller than this, which is about
/// the rounding of the result.
const SMALLEST_STEP: f64 = 1e-14;
/// Largest number of these steps. From 0 the iteration increases monotonically, by about 1/z a step;
/// levels below 1 − 1e-15 need fewer.
const MOST_STEPS: u32 = 200;

/// A confidence interval of a probability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end, in [0, 1].
    pub low: f64,
    /// Upper end, in [0, 1].
    pub high: f64,
}

impl Interval {
    /// Half the width.
    pub fn half_width(self) -> f64 {
        0.5 * (self.high - self.low)
    }
}

/// The score interval of Wilson (1927, *Probable inference, the law of succession, and statistical
/// inference*) for `hits` among `trials` at the confidence `level`, such as 0.95. Its coverage is
/// close to the level also near 0 and 1, unlike that of Wald's interval. Without trials it is [0, 1].
pub fn wilson(hits: u64, trials: u64, level: f64) -> Interval {
    if trials == 0 {
        return Interval { low: 0.0, high: 1.0 };
    }
    let (hits, n) = (hits as f64, trials as f64);
    let z = two_sided_quantile(level);
    let z2 = z * z;
    let middle = (hits + 0.5 * z2) / (n + z2);
    let half = z / (n + z2) * sqrt(hits * (n - hits) / n + 0.25 * z2);
    // At the ends the formula gives 0 and 1 up to rounding.
    let low = if hits == 0.0 { 0.0 } else { middle - half };
    let high = if hits == n { 1.0 } else { middle + half };
    Interval { low, high }
}

/// The z for which a normal deviate is in (−z, z) with probability `level`: erf(z/√2) = level.
pub fn two_sided_quantile(level: f64) -> f64 {
    const SQRT_2_OVER_PI: f64 = 0.797_884_560_802_865_4;
    let mut z = 0.0;
    for _ in 0..MOST_STEPS {
        let missing = level - libm::erf(z * core::f64::consts::FRAC_1_SQRT_2);
        let step = missing / (SQRT_2_OVER_PI * libm::exp(-0.5 * z * z));
        z += step;
        if step.abs() < SMALLEST_STEP {
            break;
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::{two_sided_quantile, wilson};

    fn close(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() < tolerance
    }

    #[test]
    fn quantiles_agree_with_published_tables() {
        for (level, z) in [
            (0.5, 0.674_489_750_196_081_7),
            (0.9, 1.644_853_626_951_472_2),
            (0.95, 1.959_963_984_540_054),
            (0.99, 2.575_829_303_548_900_4),
            (0.999_9, 3.890_591_886_413_098),
        ] {
            assert!(close(two_sided_quantile(level), z, 1e-12), "{level}");
        }
    }

    // Newcombe (1998), "Two-sided confidence intervals for the single proportion", table I.
    #[test]
    fn intervals_agree_with_newcombe_1998() {
        for (hits, trials, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let interval = wilson(hits, trials, 0.95);
            assert!(close(interval.low, low, 5e-5), "{interval:?}");
            assert!(close(interval.high, high, 5e-5), "{interval:?}");
        }
    }

    #[test]
    fn the_interval_without_trials_is_zero_to_one() {
        let interval = wilson(0, 0, 0.95);
        assert_eq!((interval.low, interval.high), (0.0, 1.0));
    }

    #[test]
    fn the_intervals_of_all_hits_and_of_none_are_symmetric() {
        let (all, none) = (wilson(50, 50, 0.99), wilson(0, 50, 0.99));
        assert_eq!(all.high, 1.0);
        assert_eq!(none.low, 0.0);
        assert!(close(all.low, 1.0 - none.high, 1e-15));
    }
}
