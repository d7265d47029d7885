//! A sequential test of which player is stronger: play goes on until the evidence suffices.
//!
//! The test compares two hypotheses on the expected share s of the points of player 0: s = s₀ and
//! s = s₁. After N pairs the log-likelihood ratio of normal distributions, each with the variance
//! that makes the scores of the pairs most likely, is
//!
//!   LLR = (N/2) ln(σ₀²/σ₁²),  σᵢ² = mean of (x − sᵢ)² over the shares x of the pairs.
//!
//! This is a generalized sequential probability ratio test (Li, Liu & Ying 2014, *Generalized
//! sequential probability ratio test for separate families of hypotheses*). Chess engines are
//! tested with it on pentanomial counts (fishtest, docs "Fishtest mathematics"). The test accepts
//! s₁ once LLR ≥ ln((1 − β)/α), and s₀ once LLR ≤ ln(β/(1 − α)) (Wald 1945, *Sequential tests of
//! statistical hypotheses*).
//!
//! The hypotheses may also be differences of normalised Elo, n = (800/ln 10) (s − ½)/(√2 σ), where σ
//! is the standard deviation of a pair's share: the error of the score, not the score itself, is
//! the unit, so the number of pairs that a test needs hardly depends on how much of a pair is luck
//! or on the advantage of the breaker. n₀ and n₁ become the shares sᵢ = ½ + nᵢ √2 σ ln 10/800 with
//! the σ of the pairs so far, and the test of shares decides (fishtest, `LLR_normalized_alt` in
//! server/fishtest/stats/LLRcalc.py; Van den Bergh, *Normalized Elo in practice*, section 4.2).
//!
//! Departure: tests of chess engines last for thousands of pairs, here a few dozen may suffice.
//! σᵢ² contains ten pairs of known variance ([`PairScores::variance`]), so that a few equal results
//! do not end a test. The tests of this file measure the error rates.

use carom::math::log;
use carom::{Error, ErrorKind};

use crate::score::{PairScores, share_of_elo};

/// The usual probability of a wrong decision, for each hypothesis.
const ERROR_RATE: f64 = 0.05;

/// Largest normalised Elo of a hypothesis, in size. A share is 1 at this value or above it if the
/// frames of a pair are independent and hardly ever lost.
const LARGEST_NORMALISED_ELO: f64 = 2000.0;

/// The unit of the hypotheses of a test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TestUnit {
    /// Expected shares of the points of player 0, above 0 and below 1.
    #[default]
    Shares,
    /// Differences of normalised Elo ([`PairScores::normalised_elo`]), from −2000 to 2000.
    NormalisedElo,
}

impl TestUnit {
    /// All units.
    pub const ALL: [Self; 2] = [Self::Shares, Self::NormalisedElo];

    /// Its name in records.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shares => "shares",
            Self::NormalisedElo => "nelo",
        }
    }

    /// The unit with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }
}

/// A sequential test on the scores of pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SequentialTest {
    /// The null hypothesis, in [`Self::unit`].
    pub p0: f64,
    /// The alternative, above `p0`.
    pub p1: f64,
    /// The unit of `p0` and `p1`.
    pub unit: TestUnit,
    /// Probability of accepting `p1` if `p0` is true, above 0 and below ½.
    pub alpha: f64,
    /// Probability of accepting `p0` if `p1` is true, above 0 and below ½.
    pub beta: f64,
}

/// A hypothesis on the expected share of the points of player 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hypothesis {
    /// The null hypothesis, `p0`.
    P0,
    /// The alternative, `p1`.
    P1,
}

/// The state of a sequential test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TestState {
    /// The log-likelihood ratio.
    pub llr: f64,
    /// At or below this ratio the test accepts `p0`.
    pub lower: f64,
    /// At or above this ratio the test accepts `p1`.
    pub upper: f64,
    /// The hypothesis that is accepted; `None` if play has to go on.
    pub accepted: Option<Hypothesis>,
}

impl SequentialTest {
    /// A test of two shares of the points of player 0, with error probabilities of 0.05.
    ///
    /// # Errors
    /// [`Error::Input`] as [`Self::check`].
    pub fn of_shares(p0: f64, p1: f64) -> Result<Self, Error> {
        Self::of(TestUnit::Shares, p0, p1)
    }

    /// A test of two differences of normalised Elo, with error probabilities of 0.05. A positive
    /// difference means that player 0 is stronger.
    ///
    /// # Errors
    /// [`Error::Input`] as [`Self::check`].
    pub fn of_normalised_elo(nelo0: f64, nelo1: f64) -> Result<Self, Error> {
        Self::of(TestUnit::NormalisedElo, nelo0, nelo1)
    }

    fn of(unit: TestUnit, p0: f64, p1: f64) -> Result<Self, Error> {
        let test = Self { p0, p1, unit, alpha: ERROR_RATE, beta: ERROR_RATE };
        test.check().map(|()| test)
    }

    /// A test of two differences of Elo ratings, with error probabilities of 0.05. A positive
    /// difference means that player 0 is stronger.
    ///
    /// # Errors
    /// [`Error::Input`] as [`Self::check`].
    pub fn of_elo(elo0: f64, elo1: f64) -> Result<Self, Error> {
        Self::of_shares(share_of_elo(elo0), share_of_elo(elo1))
    }

    /// Rejects hypotheses and error probabilities out of range.
    ///
    /// # Errors
    /// [`Error::Input`] at `test.p0`, `test.p1`, `test.alpha` or `test.beta`.
    pub fn check(&self) -> Result<(), Error> {
        let wrong = |key: &str, value: f64, remedy: &str| {
            Err(ErrorKind::OutOfRange.at(
                format!("test.{key}"),
                format!("{value:?} is out of range"),
                remedy,
            ))
        };
        let (low, high) = match self.unit {
            TestUnit::Shares => (0.0, 1.0),
            TestUnit::NormalisedElo => (-LARGEST_NORMALISED_ELO, LARGEST_NORMALISED_ELO),
        };
        let (remedy0, remedy1) = match self.unit {
            TestUnit::Shares => (
                "write a share between 0 and 1, such as 0.5",
                "write a share between p0 and 1, such as 0.55",
            ),
            TestUnit::NormalisedElo => (
                "write a difference between -2000 and 2000, such as 0",
                "write a difference between p0 and 2000, such as 30",
            ),
        };
        if !(self.p0 > low && self.p0 < high) {
            return wrong("p0", self.p0, remedy0);
        }
        if !(self.p1 > self.p0 && self.p1 < high) {
            return wrong("p1", self.p1, remedy1);
        }
        for (key, rate) in [("alpha", self.alpha), ("beta", self.beta)] {
            if !(rate > 0.0 && rate < 0.5) {
                return wrong(key, rate, "write a probability between 0 and 0.5, such as 0.05");
            }
        }
        Ok(())
    }

    /// The state of the test after these pairs.
    pub fn state(&self, pairs: &PairScores) -> TestState {
        let Self { alpha, beta, .. } = *self;
        let [p0, p1] = [self.p0, self.p1].map(|hypothesis| match self.unit {
            TestUnit::Shares => hypothesis,
            TestUnit::NormalisedElo => pairs.share_of_normalised_elo(hypothesis),
        });
        let n = pairs.pairs() as f64;
        let llr = 0.5 * n * log(pairs.variance_about(p0) / pairs.variance_about(p1));
        let (lower, upper) = (log(beta / (1.0 - alpha)), log((1.0 - beta) / alpha));
        let accepted = if llr >= upper {
            Some(Hypothesis::P1)
        } else if llr <= lower {
            Some(Hypothesis::P0)
        } else {
            None
        };
        TestState { llr, lower, upper, accepted }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::math::exp;
    use rand_pcg::Pcg64;
    use rand_pcg::rand_core::Rng;

    /// Pairs after which a simulated test is given up: a hundred times the usual number.
    const MOST_PAIRS: u64 = 100_000;

    /// The frequencies with which `test` accepts p0 and p1, and the mean number of pairs, over 4000
    /// matches. Player 0 wins a frame with the probability `wins[0]` if it breaks and `wins[1]` if
    /// not.
    fn frequencies(test: &SequentialTest, wins: [f64; 2]) -> ([f64; 2], f64) {
        frequencies_of(test, |unit| wins.map(|p| if unit() < p { 1.0 } else { 0.0 }))
    }

    /// The same for matches whose pairs `pair` draws with uniform numbers in [0, 1).
    fn frequencies_of(
        test: &SequentialTest,
        mut pair: impl FnMut(&mut dyn FnMut() -> f64) -> [f64; 2],
    ) -> ([f64; 2], f64) {
        let mut random = Pcg64::new(11, 17);
        let mut unit = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        let (mut accepted, mut played) = ([0_u32; 2], 0);
        const MATCHES: u32 = 4000;
        for _ in 0..MATCHES {
            let mut pairs = PairScores::default();
            while pairs.pairs() < MOST_PAIRS {
                pairs.add(pair(&mut unit));
                match test.state(&pairs).accepted {
                    Some(Hypothesis::P0) => accepted[0] += 1,
                    Some(Hypothesis::P1) => accepted[1] += 1,
                    None => continue,
                }
                break;
            }
            played += pairs.pairs();
        }
        let share = |count: u32| f64::from(count) / f64::from(MATCHES);
        (accepted.map(share), played as f64 / f64::from(MATCHES))
    }

    // A frequency of 0.05 among 4000 has a standard error of 0.0034.
    const MOST_ERRORS: f64 = 0.055;

    #[test]
    fn wrong_decisions_are_as_rare_as_promised() {
        for (p0, p1) in [(0.5, 0.55), (0.5, 0.6), (0.45, 0.55), (0.5, 0.75)] {
            let test = SequentialTest::of_shares(p0, p1).unwrap();
            let (under_null, pairs_of_null) = frequencies(&test, [p0; 2]);
            let (under_other, pairs_of_other) = frequencies(&test, [p1; 2]);
            println!(
                "{p0} against {p1}: {} wrong, {pairs_of_null} pairs if {p0} is true; \
                 {} wrong, {pairs_of_other} pairs if {p1} is true",
                under_null[1], under_other[0]
            );
            assert!(under_null[1] < MOST_ERRORS, "{p0} {p1}: {under_null:?}");
            assert!(under_other[0] < MOST_ERRORS, "{p0} {p1}: {under_other:?}");
            assert_eq!([under_null, under_other].map(|[a, b]| a + b), [1.0; 2], "no test ended");
        }
    }

    /// The probabilities of 0, ½, 1, 1½ and 2 points that differ from `base` by a factor that grows
    /// with the points, and whose normalised Elo is `nelo`.
    fn with_normalised_elo(base: [f64; 5], nelo: f64) -> [f64; 5] {
        let tilted = |slope: f64| {
            let weights: [f64; 5] = core::array::from_fn(|i| base[i] * exp(slope * i as f64));
            let sum: f64 = weights.iter().sum();
            weights.map(|weight| weight / sum)
        };
        // A billion pairs have these frequencies.
        let found = |of: [f64; 5]| {
            let pairs = PairScores { counts: of.map(|p| (1e9 * p) as u64) };
            pairs.normalised_elo(pairs.share())
        };
        let (mut low, mut high) = (-5.0, 5.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if found(tilted(middle)) < nelo { low = middle } else { high = middle }
        }
        tilted(low)
    }

    #[test]
    fn wrong_decisions_about_normalised_elo_are_as_rare_for_all_kinds_of_pairs() {
        for (what, base) in [
            ("independent frames", [0.25, 0.0, 0.5, 0.0, 0.25]),
            ("the breaker nearly always wins", [0.05, 0.0, 0.9, 0.0, 0.05]),
            ("both frames nearly always end the same way", [0.45, 0.0, 0.1, 0.0, 0.45]),
            ("most frames are drawn", [0.02, 0.2, 0.56, 0.2, 0.02]),
        ] {
            for (nelo0, nelo1) in [(0.0, 30.0), (0.0, 60.0), (-30.0, 30.0), (0.0, 150.0)] {
                let test = SequentialTest::of_normalised_elo(nelo0, nelo1).unwrap();
                let played = |nelo: f64| {
                    let of = with_normalised_elo(base, nelo);
                    frequencies_of(&test, |unit| {
                        let at = unit();
                        let mut sum = 0.0;
                        let drawn = of.iter().position(|p| {
                            sum += p;
                            at < sum
                        });
                        let half_points = drawn.unwrap_or(4);
                        [half_points.min(2), half_points.saturating_sub(2)].map(|n| 0.5 * n as f64)
                    })
                };
                let (under_null, pairs_of_null) = played(nelo0);
                let (under_other, pairs_of_other) = played(nelo1);
                println!(
                    "{what}, {nelo0} against {nelo1}: {} wrong, {pairs_of_null} pairs if {nelo0} \
                     is true; {} wrong, {pairs_of_other} pairs if {nelo1} is true",
                    under_null[1], under_other[0]
                );
                assert!(under_null[1] < MOST_ERRORS, "{what}: {under_null:?}");
                assert!(under_other[0] < MOST_ERRORS, "{what}: {under_other:?}");
                assert_eq!([under_null, under_other].map(|[a, b]| a + b), [1.0; 2], "no end");
            }
        }
    }

    #[test]
    fn an_advantage_of_the_breaker_does_not_raise_the_errors() {
        let test = SequentialTest::of_shares(0.5, 0.55).unwrap();
        let (under_null, pairs) = frequencies(&test, [0.8, 0.2]);
        let (under_other, _) = frequencies(&test, [0.85, 0.25]);
        assert!(under_null[1] < MOST_ERRORS, "{under_null:?}");
        assert!(under_other[0] < MOST_ERRORS, "{under_other:?}");
        // The variance of a pair is smaller, so fewer pairs are needed.
        let (_, without) = frequencies(&test, [0.5; 2]);
        println!("{} wrong, {pairs} pairs with it, {without} without it", under_null[1]);
        assert!(pairs < 0.8 * without, "{pairs} {without}");
    }

    #[test]
    fn a_strong_player_is_found_sooner_than_with_a_fixed_number_of_pairs() {
        let test = SequentialTest::of_shares(0.5, 0.55).unwrap();
        let (accepted, pairs) = frequencies(&test, [0.65; 2]);
        assert_eq!(accepted[1], 1.0);
        // A test with a fixed number needs (2 · 1.645)² · 0.125 / 0.05² = 541 pairs.
        assert!(pairs < 0.25 * 541.0, "{pairs}");
    }

    #[test]
    fn two_equal_pairs_do_not_end_a_test() {
        let test = SequentialTest::of_shares(0.5, 0.55).unwrap();
        for counts in [[0, 0, 0, 0, 2], [2, 0, 0, 0, 0], [0, 0, 2, 0, 0]] {
            assert_eq!(test.state(&PairScores { counts }).accepted, None);
        }
    }

    #[test]
    fn elo_bounds_are_shares() {
        let test = SequentialTest::of_elo(0.0, 35.0).unwrap();
        assert!((test.p0 - 0.5).abs() < 1e-15 && (test.p1 - 0.5502).abs() < 1e-4);
    }

    #[test]
    fn rejects_bounds_out_of_range_at_their_keys() {
        let good = SequentialTest::of_shares(0.5, 0.6).unwrap();
        let nelo = SequentialTest::of_normalised_elo(-30.0, 0.0).unwrap();
        for (test, place) in [
            (SequentialTest { p0: 0.0, ..good }, "test.p0: "),
            (SequentialTest { p1: 0.5, ..good }, "test.p1: "),
            (SequentialTest { p1: f64::NAN, ..good }, "test.p1: "),
            (SequentialTest { p0: -2000.0, ..nelo }, "test.p0: "),
            (SequentialTest { p1: -30.0, ..nelo }, "test.p1: "),
            (SequentialTest { p1: 2000.0, ..nelo }, "test.p1: "),
            (SequentialTest { alpha: 0.5, ..good }, "test.alpha: "),
            (SequentialTest { beta: 0.0, ..good }, "test.beta: "),
        ] {
            let error = test.check().unwrap_err().to_string();
            assert!(error.starts_with(place), "{error}");
        }
        assert!(good.check().is_ok());
    }
}
