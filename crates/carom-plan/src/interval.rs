//! Confidence intervals of probabilities that were counted.

use core::f64::consts::FRAC_PI_2;

use carom::math::{sin_cos, sqrt};

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
    score(hits as f64, trials as f64, two_sided_quantile(level))
}

/// Wilson's interval with the quantile `z`; `n` trials may be those of an effective sample.
fn score(hits: f64, n: f64, z: f64) -> Interval {
    let z2 = z * z;
    let middle = (hits + 0.5 * z2) / (n + z2);
    let half = z / (n + z2) * sqrt(hits * (n - hits) / n + 0.25 * z2);
    // At the ends the formula gives 0 and 1 up to rounding.
    let low = if hits == 0.0 { 0.0 } else { middle - half };
    let high = if hits == n { 1.0 } else { middle + half };
    Interval { low, high }
}

/// The interval of a probability whose trials are in clusters that have a probability each, such as
/// those on drawn tables: (hits, trials) of every cluster. It is the interval of the mean over all
/// clusters that might have been drawn. Clusters without trials do not count; one cluster has the
/// interval of [`wilson`].
///
/// The variance v of the share p is that between the clusters (the ratio estimator of Cochran 1977,
/// *Sampling techniques*, eq. 11.12), but at least that of independent trials, p(1 − p)/n. Wilson's
/// interval is then that of the effective sample of p(1 − p)/v trials, with the quantile of Student's
/// t for one degree of freedom fewer than clusters (Korn & Graubard 1998, *Confidence intervals for
/// proportions with small expected number of positive counts estimated from survey data*, for
/// another interval; Dean & Pagano 2015, *Evaluating confidence interval methods for binomial
/// proportions in clustered surveys*, for Wilson's).
pub fn clustered(clusters: &[(u64, u64)], level: f64) -> Interval {
    let drawn: Vec<(f64, f64)> = clusters
        .iter()
        .filter(|(_, trials)| *trials > 0)
        .map(|&(hits, trials)| (hits as f64, trials as f64))
        .collect();
    let (hits, n) = drawn.iter().fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    if drawn.len() < 2 {
        return wilson(hits as u64, n as u64, level);
    }
    let (share, freedom) = (hits / n, drawn.len() - 1);
    let squares: f64 =
        drawn.iter().map(|(hits, trials)| hits - share * trials).map(|rest| rest * rest).sum();
    let between = squares / (n * n) * drawn.len() as f64 / freedom as f64;
    let binomial = share * (1.0 - share);
    let t = student_quantile(level, freedom);
    if between * n <= binomial {
        return score(hits, n, t);
    }
    let effective = binomial / between;
    score(share * effective, effective, t)
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

/// The t for which Student's t with `freedom` > 0 degrees of freedom is in (−t, t) with probability
/// `level`: the inverse of [`student_share`], by bisection of the angle.
pub fn student_quantile(level: f64, freedom: usize) -> f64 {
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            let (sin, cos) = sin_cos(middle);
            return sqrt(freedom as f64) * sin / cos;
        }
        let is_below = student_share(middle, freedom) < level;
        (low, high) = if is_below { (middle, high) } else { (low, middle) };
    }
}

/// The probability that Student's t with a whole number of degrees of freedom ν is in (−t, t), where
/// `angle` is θ = arctan(t/√ν): Abramowitz & Stegun 1964, eq. 26.7.3 and 26.7.4.
fn student_share(angle: f64, freedom: usize) -> f64 {
    let (sin, cos) = sin_cos(angle);
    // Odd ν: cos θ (1 + 2/3 cos² θ + …); even ν: 1 + 1/2 cos² θ + …
    let mut term = if freedom % 2 == 1 { cos } else { 1.0 };
    let mut sum = 0.0;
    for k in (2 + freedom % 2..=freedom).step_by(2) {
        sum += term;
        term *= cos * cos * (k - 1) as f64 / k as f64;
    }
    if freedom % 2 == 1 { (angle + sin * sum) / FRAC_PI_2 } else { sin * sum }
}

#[cfg(test)]
mod tests {
    use super::{clustered, student_quantile, two_sided_quantile, wilson};

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

    // Abramowitz & Stegun 1964, table 26.10.
    #[test]
    fn quantiles_of_student_agree_with_abramowitz_and_stegun() {
        for (freedom, level, t) in [
            (1, 0.9, 6.314),
            (1, 0.95, 12.706),
            (2, 0.95, 4.303),
            (3, 0.99, 5.841),
            (4, 0.8, 1.533),
            (7, 0.95, 2.365),
            (30, 0.95, 2.042),
            (31, 0.5, 0.682),
            (120, 0.99, 2.617),
        ] {
            assert!(close(student_quantile(level, freedom), t, 6e-4), "{freedom} {level}");
        }
        assert!(close(student_quantile(0.95, 999), two_sided_quantile(0.95), 3e-3));
    }

    #[test]
    fn clusters_that_differ_by_counting_alone_have_almost_the_interval_of_one() {
        let alike: Vec<(u64, u64)> = (0..200).map(|k| (29 + 2 * (k % 2), 100)).collect();
        let (found, one) = (clustered(&alike, 0.95), wilson(6000, 20_000, 0.95));
        assert!(close(found.low, one.low, 1e-4) && close(found.high, one.high, 1e-4), "{found:?}");
        assert!(found.half_width() > one.half_width());
    }

    #[test]
    fn clusters_that_are_all_or_nothing_count_as_one_trial_each() {
        let decided: Vec<(u64, u64)> =
            (0..40).map(|k| (if k % 4 == 0 { 500 } else { 0 }, 500)).collect();
        // The variance has a denominator of 39, a binomial one of 40; t is 1 % above the normal z.
        let (found, one) = (clustered(&decided, 0.95), wilson(10, 40, 0.95));
        assert!(
            close(found.low, one.low, 0.008) && close(found.high, one.high, 0.008),
            "{found:?}"
        );
        assert!(found.low < one.low && found.high > one.high);
    }

    #[test]
    fn clusters_without_trials_do_not_count_and_one_has_the_interval_of_wilson() {
        assert_eq!(clustered(&[(3, 10), (0, 0)], 0.9), wilson(3, 10, 0.9));
        assert_eq!(clustered(&[], 0.9), wilson(0, 0, 0.9));
        let none = clustered(&[(0, 50); 8], 0.95);
        assert!(none.low == 0.0 && none.high > wilson(0, 400, 0.95).high);
        assert_eq!(clustered(&[(50, 50); 8], 0.95).high, 1.0);
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
