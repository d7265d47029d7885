//! Speed bands that follow a measured law of rolling resistance, a + bv.
//!
//! With the deceleration D(v) = a + bv, v dv/ds = −D(v) gives the distance in which a ball slows
//! from c to f:
//!
//! ```text
//! S(f, c) = ∫ v/D(v) dv = (c − f)/b − (a/b²) ln(D(c)/D(f))
//! ```
//!
//! A band from f to c with the constant deceleration A takes the distance (c² − f²)/2A. The bands
//! have A = (c² − f²)/2S(f, c). So a ball that starts at an end of any band rolls exactly as far as
//! by the law. A ball that starts within a band stops short, by S(f, v) − (v² − f²)/2A: below the
//! speed at which D = A the band decelerates it more than the law does, above it less. (Bands
//! that take the right time would have another A. Where a ball comes to rest is what players see
//! and what is measured, so the distance decides.)

use alloc::format;
use alloc::vec::Vec;

use super::{MAX_ROLLING_BANDS, RollingBand, RollingFriction};
use crate::error::{Error, ErrorKind};
use crate::math::log;

/// A measured deceleration of rolling balls, D(v) = a + bv.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingLaw {
    /// Deceleration at speed 0, m/s², > 0.
    pub a: f64,
    /// Growth with speed, 1/s, ≥ 0.
    pub b: f64,
}

/// How well bands follow a law: up to which speed, and how far the resting place of a ball may be
/// from the one by the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingTolerance {
    /// The highest speed at which the law is followed, m/s, > 0. Faster balls have the last band's
    /// coefficient.
    pub fastest: f64,
    /// The largest error as a share of the roll's length.
    pub share: f64,
    /// The error that is always allowed, m. Purpose: without it the shortest rolls, whose ends look
    /// the same, would need ever more bands.
    pub least: f64,
}

/// At how many speeds of a band its error is computed. The error has one maximum in a band, which
/// 64 speeds give within 0.1 %.
const SAMPLES: u32 = 64;

/// Halvings of an interval in the search for the end of a band, and for the smallest error. A band
/// then ends within 1e-9 of its length where it should; more would change no roll by a nanometre.
const HALVINGS: u32 = 30;

/// Below this bc/a the closed form of S loses digits, about 1e-16/(bc/a)² of the distance, so its
/// series is used. Larger, and the series would need more terms.
const NEARLY_CONSTANT: f64 = 0.03;

/// Terms of the series; the next one is less than 1e-12 of the distance.
const TERMS: u32 = 8;

impl RollingLaw {
    /// Deceleration of a ball that rolls at `speed` (m/s), m/s².
    pub fn deceleration(&self, speed: f64) -> f64 {
        self.a + self.b * speed
    }

    /// Distance that a ball rolls while it slows from the speed `high` to `low` (m/s), m.
    pub fn distance(&self, low: f64, high: f64) -> f64 {
        let Self { a, b } = *self;
        let ratio = b / a;
        if ratio * high > NEARLY_CONSTANT {
            let logarithm = log(self.deceleration(high) / self.deceleration(low));
            return ((high - low) - logarithm / ratio) / b;
        }
        // ∫ v/D dv = (1/a) Σ (−b/a)^k (high^(k+2) − low^(k+2))/(k+2), from the highest power down.
        let primitive = |v: f64| {
            let next = |sum: f64, k: u32| 1.0 / f64::from(k + 2) - ratio * v * sum;
            v * v * (0..TERMS).rev().fold(0.0, next)
        };
        (primitive(high) - primitive(low)) / a
    }

    /// The fewest bands that follow the law within `tolerance`, with the smallest error that this
    /// number of bands allows. `gravity` (m/s²) turns decelerations into coefficients, μ_r = A/g.
    ///
    /// # Errors
    /// [`Error::Input`] if a value is out of range, or if more than [`MAX_ROLLING_BANDS`] bands
    /// would be needed.
    pub fn bands(
        &self,
        gravity: f64,
        tolerance: &RollingTolerance,
    ) -> Result<RollingFriction, Error> {
        self.check(gravity, tolerance)?;
        let needed = self.ends(tolerance);
        if needed.len() > MAX_ROLLING_BANDS {
            return Err(ErrorKind::OutOfRange.at(
                "share",
                format!(
                    "the law needs more than {MAX_ROLLING_BANDS} bands up to {:?} m/s with this \
                     error",
                    tolerance.fastest
                ),
                "raise `share` or `least`, or lower `fastest`",
            ));
        }
        let ends = self.best_ends(needed, tolerance);
        let mut low = 0.0;
        let bands = ends.iter().enumerate().map(|(i, &high)| {
            let friction = self.band_deceleration(low, high) / gravity;
            low = high;
            let is_last = i + 1 == ends.len();
            RollingBand { up_to: if is_last { f64::INFINITY } else { high }, friction }
        });
        RollingFriction::from_bands(&bands.collect::<Vec<_>>())
    }

    fn check(&self, gravity: f64, tolerance: &RollingTolerance) -> Result<(), Error> {
        let RollingTolerance { fastest, share, least } = *tolerance;
        for (name, value, is_valid, remedy) in [
            ("a", self.a, self.a > 0.0, "write a deceleration > 0, m/s²"),
            ("b", self.b, self.b >= 0.0, "write a number ≥ 0, 1/s"),
            ("gravity", gravity, gravity > 0.0, "write a number > 0, m/s²"),
            ("fastest", fastest, fastest > 0.0, "write a speed > 0, m/s"),
            ("share", share, share >= 0.0, "write a number ≥ 0, such as 0.005"),
            ("least", least, least > 0.0, "write a length > 0, m, such as 0.005"),
        ] {
            if !(is_valid && value.is_finite()) {
                return Err(ErrorKind::OutOfRange.at(
                    name,
                    format!("{value:?} is out of range"),
                    remedy,
                ));
            }
        }
        Ok(())
    }

    /// The constant deceleration of a band that takes the same distance as the law, m/s².
    fn band_deceleration(&self, low: f64, high: f64) -> f64 {
        (high - low) * (high + low) / (2.0 * self.distance(low, high))
    }

    /// The upper ends of the fewest bands within the tolerance, each as long as possible, at most
    /// one more than [`MAX_ROLLING_BANDS`]; the last end is the highest speed.
    fn ends(&self, tolerance: &RollingTolerance) -> Vec<f64> {
        let mut ends = Vec::new();
        let mut low = 0.0;
        while low < tolerance.fastest && ends.len() <= MAX_ROLLING_BANDS {
            low = self.longest(low, tolerance);
            ends.push(low);
        }
        ends
    }

    /// The ends of as many bands as `ends` has, with the smallest error in proportion to the
    /// tolerance. The longest possible bands would leave an arbitrarily short one at the end.
    fn best_ends(&self, ends: Vec<f64>, tolerance: &RollingTolerance) -> Vec<f64> {
        let mut best = ends;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let scale = 0.5 * (low + high);
            let RollingTolerance { fastest, share, least } = *tolerance;
            let stricter = RollingTolerance { fastest, share: share * scale, least: least * scale };
            let found = self.ends(&stricter);
            if found.len() <= best.len() {
                best = found;
                high = scale;
            } else {
                low = scale;
            }
        }
        best
    }

    /// The upper end of the longest band above `low` within the tolerance, m/s.
    fn longest(&self, low: f64, tolerance: &RollingTolerance) -> f64 {
        if self.is_within(low, tolerance.fastest, tolerance) {
            return tolerance.fastest;
        }
        let (mut inside, mut outside) = (low, tolerance.fastest);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if self.is_within(low, middle, tolerance) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    }

    /// Whether every ball that starts in the band from `low` to `high` stops near enough.
    fn is_within(&self, low: f64, high: f64, tolerance: &RollingTolerance) -> bool {
        let deceleration = self.band_deceleration(low, high);
        let rest = self.distance(0.0, low);
        (1..SAMPLES).all(|k| {
            let v = low + (high - low) * f64::from(k) / f64::from(SAMPLES);
            let exact = self.distance(low, v);
            let error = exact - (v - low) * (v + low) / (2.0 * deceleration);
            error <= (tolerance.share * (rest + exact)).max(tolerance.least)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEATED: RollingLaw = RollingLaw { a: 0.0410, b: 0.0142 };
    const GRAVITY: f64 = 9.80665;

    fn tolerance(fastest: f64, share: f64, least: f64) -> RollingTolerance {
        RollingTolerance { fastest, share, least }
    }

    fn bands(law: &RollingLaw, tolerance: &RollingTolerance) -> Vec<RollingBand> {
        let friction = law.bands(GRAVITY, tolerance).unwrap_or_else(|e| panic!("{e}"));
        friction.bands().collect()
    }

    /// The roll from `speed` in bands, m.
    fn roll(bands: &[RollingBand], speed: f64) -> f64 {
        let mut low = 0.0;
        let mut distance = 0.0;
        for band in bands {
            let high = speed.min(band.up_to);
            if high > low {
                distance += (high * high - low * low) / (2.0 * band.friction * GRAVITY);
            }
            low = band.up_to;
        }
        distance
    }

    /// Simpson's rule for ∫ v/(a + bv) dv, independent of the closed form.
    fn integrated(law: &RollingLaw, low: f64, high: f64) -> f64 {
        const STEPS: u32 = 20_000;
        let h = (high - low) / f64::from(STEPS);
        let f = |k: u32| {
            let v = low + h * f64::from(k);
            v / (law.a + law.b * v)
        };
        let weight = |k: u32| if k.is_multiple_of(2) { 2.0 } else { 4.0 };
        let inner = (1..STEPS).fold(0.0, |sum, k| sum + weight(k) * f(k));
        (f(0) + inner + f(STEPS)) * h / 3.0
    }

    #[test]
    fn the_distance_is_the_integral_of_v_over_the_deceleration() {
        for b in [0.0, 1e-9, 1e-5, 4e-4, 5e-4, 0.0142, 3.0] {
            let law = RollingLaw { b, ..HEATED };
            for (low, high) in [(0.0, 0.05), (0.0, 1.0), (0.9, 1.0), (2.0, 7.0)] {
                let (found, expected) = (law.distance(low, high), integrated(&law, low, high));
                assert!(
                    (found / expected - 1.0).abs() < 2e-12,
                    "{b} {low} {high} {found} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_ball_that_starts_at_the_end_of_a_band_rolls_as_far_as_by_the_law() {
        let bands = bands(&HEATED, &tolerance(3.0, 0.005, 0.005));
        for end in bands.iter().map(|band| band.up_to.min(3.0)) {
            let (found, expected) = (roll(&bands, end), HEATED.distance(0.0, end));
            assert!((found / expected - 1.0).abs() < 1e-12, "{end} {found} {expected}");
        }
    }

    #[test]
    fn no_roll_is_further_from_the_law_than_the_tolerance() {
        for (fastest, share, least) in [(3.0, 0.005, 0.005), (3.0, 0.002, 0.01), (7.0, 0.01, 0.001)]
        {
            let bands = bands(&HEATED, &tolerance(fastest, share, least));
            let mut largest: f64 = 0.0;
            for k in 1..=20_000 {
                let v = fastest * f64::from(k) / 20_000.0;
                let exact = HEATED.distance(0.0, v);
                let error = exact - roll(&bands, v);
                assert!(error > -1e-12, "a ball never rolls further than by the law");
                largest = largest.max(error / (share * exact).max(least));
            }
            // The errors are checked at 64 speeds of each band, and not far below the limit.
            assert!((0.5..1.001).contains(&largest), "{fastest} {share} {least}: {largest}");
        }
    }

    #[test]
    fn the_bands_are_the_fewest() {
        let limits = tolerance(3.0, 0.005, 0.005);
        let found = bands(&HEATED, &limits);
        // Bands that are each as long as possible, one after another.
        let greedy = HEATED.ends(&limits);
        assert_eq!(found.len(), greedy.len());
        // With one band fewer, the last of them does not reach the highest speed.
        assert!(greedy[greedy.len() - 2] < 3.0);
        assert_eq!(found.len(), 10);
    }

    #[test]
    fn a_law_that_hardly_grows_needs_one_band() {
        for b in [0.0, 1e-6] {
            let found = bands(&RollingLaw { b, ..HEATED }, &tolerance(3.0, 0.005, 0.005));
            assert_eq!(found.len(), 1);
            assert!((found[0].friction * GRAVITY / HEATED.a - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn values_out_of_range_are_refused_by_name() {
        let good = tolerance(3.0, 0.005, 0.005);
        let place = |law: RollingLaw, gravity: f64, tolerance: RollingTolerance| match law
            .bands(gravity, &tolerance)
        {
            Err(Error::Input(e)) => e.place,
            other => panic!("expected a refusal, got {other:?}"),
        };
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(place(RollingLaw { a: bad, ..HEATED }, GRAVITY, good), "a");
            assert_eq!(place(HEATED, bad, good), "gravity");
            assert_eq!(
                place(HEATED, GRAVITY, RollingTolerance { fastest: bad, ..good }),
                "fastest"
            );
            assert_eq!(place(HEATED, GRAVITY, RollingTolerance { least: bad, ..good }), "least");
        }
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(place(RollingLaw { b: bad, ..HEATED }, GRAVITY, good), "b");
            assert_eq!(place(HEATED, GRAVITY, RollingTolerance { share: bad, ..good }), "share");
        }
        // Too many bands.
        assert_eq!(place(HEATED, GRAVITY, tolerance(5.0, 1e-4, 1e-4)), "share");
    }
}
