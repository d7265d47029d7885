//! The score of a match: frames, pairs and their confidence intervals.
//!
//! Both frames of a pair have the same rack and the same streams of errors, so their results are
//! not independent. Every interval of the score is therefore computed from the scores of whole
//! pairs, as in the testing of chess engines, where the five possible scores of a pair are called
//! pentanomial.

mod adjusted;

use std::collections::BTreeMap;

use carom::math::{log, pow, sqrt};
use carom_plan::{Interval, two_sided_quantile, wilson};

use crate::moves::EndReason;

pub use adjusted::{AdjustedPairs, AdjustedShare};

/// Variance of a pair's score if its frames are independent and both players equally strong:
/// ½ · ½ · (1 − ½).
const EVEN_VARIANCE: f64 = 0.125;

/// Number of pairs of [`EVEN_VARIANCE`] that are added to the variance of the pairs played. Without
/// them the variance after a few equal pairs would be 0, and a sequential test would end after two.
/// After a hundred pairs they are a tenth of the estimate.
const PRIOR_PAIRS: f64 = 10.0;

/// Rating points for a tenfold of the odds to win (Elo 1978).
const ELO_DECADE: f64 = 400.0;

/// Points of normalised Elo of a share that is one standard deviation of a frame above ½: 800/ln 10,
/// about 347 (fishtest, `nelo_divided_by_nt`). With it normalised Elo equals Elo for small
/// differences, if frames are independent and none is drawn.
const NORMALISED_ELO: f64 = 2.0 * ELO_DECADE / core::f64::consts::LN_10;

/// Number of pairs with each score of player 0: 0, ½, 1, 1½ and 2 points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PairScores {
    /// The counts, in this order.
    pub counts: [u64; 5],
}

impl PairScores {
    /// Adds a pair in which player 0 had these points in the two frames: 0, ½ or 1 each.
    pub fn add(&mut self, points: [f64; 2]) {
        self.counts[(2.0 * (points[0] + points[1])) as usize] += 1;
    }

    /// Number of pairs.
    pub fn pairs(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// The score of player 0 as a share of the points, 0 to 1; ½ without pairs.
    pub fn share(&self) -> f64 {
        let points = self.sum(|share| share);
        if self.pairs() == 0 { 0.5 } else { points / self.pairs() as f64 }
    }

    /// The variance of a pair's share of the points, at most ¼.
    pub fn variance(&self) -> f64 {
        self.variance_about(self.share())
    }

    /// The mean squared deviation of a pair's share of the points from `share`. To the pairs that
    /// were played, [`PRIOR_PAIRS`] pairs with the variance of independent frames between equal
    /// players are added.
    pub(crate) fn variance_about(&self, share: f64) -> f64 {
        let squares = self.sum(|of_pair| (of_pair - share) * (of_pair - share));
        (squares + PRIOR_PAIRS * EVEN_VARIANCE) / (self.pairs() as f64 + PRIOR_PAIRS)
    }

    /// The confidence interval of [`Self::share`] at the confidence `level`, clustered by pairs:
    /// share ± z·√(variance/pairs), within [0, 1].
    pub fn interval(&self, level: f64) -> Interval {
        if self.pairs() == 0 {
            return Interval { low: 0.0, high: 1.0 };
        }
        let error = sqrt(self.variance() / self.pairs() as f64);
        let half = two_sided_quantile(level) * error;
        let share = self.share();
        Interval { low: (share - half).max(0.0), high: (share + half).min(1.0) }
    }

    /// The difference of normalised Elo that belongs to this expected `share` of the points, with
    /// the variance σ² of the pairs so far: (800/ln 10) (share − ½)/(√2 σ). √2 σ is the standard
    /// deviation of a frame if the frames of a pair are independent (fishtest).
    pub fn normalised_elo(&self, share: f64) -> f64 {
        NORMALISED_ELO * (share - 0.5) / sqrt(2.0 * self.variance())
    }

    /// The expected share of the points that belongs to this difference of normalised Elo.
    pub(crate) fn share_of_normalised_elo(&self, elo: f64) -> f64 {
        0.5 + elo / NORMALISED_ELO * sqrt(2.0 * self.variance())
    }

    /// The variance of a pair's share, divided by that of two independent frames with the same
    /// distribution of points. Below 1 pairing has saved frames; above 1 it has cost some. `None`
    /// if all frames had the same result.
    ///
    /// `frames` counts the points of player 0 in single frames: 0, ½, 1.
    pub fn pairing_ratio(&self, frames: [u64; 3]) -> Option<f64> {
        let n = frames.iter().sum::<u64>() as f64;
        let each = frames.map(|count| count as f64);
        let mean = (0.5 * each[1] + each[2]) / n;
        let square = (0.25 * each[1] + each[2]) / n - mean * mean;
        let mean_of_pairs = self.share();
        let of_pairs = self.sum(|share| (share - mean_of_pairs) * (share - mean_of_pairs))
            / self.pairs() as f64;
        (square > 0.0).then(|| of_pairs / (0.5 * square))
    }

    /// The sum over all pairs of `f` of the pair's share of the points.
    fn sum(&self, f: impl Fn(f64) -> f64) -> f64 {
        (0_u8..).zip(self.counts).map(|(i, n)| n as f64 * f(0.25 * f64::from(i))).sum()
    }
}

/// The share of the points that is expected with this difference of Elo ratings (Elo 1978, *The
/// rating of chessplayers, past and present*): 1/(1 + 10^(−elo/400)).
pub fn share_of_elo(elo: f64) -> f64 {
    1.0 / (1.0 + pow(10.0, -elo / ELO_DECADE))
}

/// The difference of Elo ratings with which this `share` of the points is expected; infinite for 0
/// and 1.
pub fn elo_of_share(share: f64) -> f64 {
    ELO_DECADE / core::f64::consts::LN_10 * log(share / (1.0 - share))
}

/// The result of one frame, for the score.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramePoints {
    /// The points of player 0: 1, ½ or 0; `None` if the frame does not count.
    pub points: Option<f64>,
    /// Why the frame ended.
    pub reason: EndReason,
    /// The luck of player 0 ([`crate::ArenaFrame::luck`]); `None` if it is not measured.
    pub luck: Option<f64>,
}

/// The score of a match.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MatchScore {
    /// Frames that player 0 lost, drew and won.
    pub frames: [u64; 3],
    /// Number of pairs in which both frames counted, by the score of player 0.
    pub pairs: PairScores,
    /// Number of frames that did not count. The other frame of the pair counts in `frames`, not in
    /// `pairs`.
    pub void: u64,
    /// Number of frames by the reason of their end.
    pub reasons: BTreeMap<EndReason, u64>,
    /// The pairs in which both frames counted and the luck was measured.
    pub adjusted: AdjustedPairs,
}

impl MatchScore {
    /// Adds a pair.
    pub fn add(&mut self, pair: &[FramePoints; 2]) {
        for frame in pair {
            *self.reasons.entry(frame.reason).or_default() += 1;
            match frame.points {
                Some(points) => self.frames[(2.0 * points) as usize] += 1,
                None => self.void += 1,
            }
        }
        if let [Some(first), Some(second)] = pair.map(|frame| frame.points) {
            self.pairs.add([first, second]);
            if let [Some(luck), Some(other)] = pair.map(|frame| frame.luck) {
                self.adjusted.add(0.5 * (first + second), 0.5 * (luck + other));
            }
        }
    }

    /// The share of the decided frames that player 0 won, with its Wilson interval at the
    /// confidence `level`. The interval takes the frames as independent; for the strength of the
    /// players use [`PairScores::interval`].
    pub fn wins(&self, level: f64) -> (f64, Interval) {
        let [lost, _, won] = self.frames;
        let decided = lost + won;
        let share = if decided == 0 { f64::NAN } else { won as f64 / decided as f64 };
        (share, wilson(won, decided, level))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12
    }

    #[test]
    fn a_score_counts_frames_and_pairs() {
        let won = |points| FramePoints { points, reason: EndReason::Won, luck: Some(0.25) };
        let void = FramePoints { points: None, reason: EndReason::EventCap, luck: None };
        let mut score = MatchScore::default();
        score.add(&[won(Some(1.0)), won(Some(0.0))]);
        score.add(&[won(Some(1.0)), won(Some(1.0))]);
        score.add(&[won(Some(0.5)), won(Some(1.0))]);
        score.add(&[won(Some(0.0)), void]);
        assert_eq!(score.frames, [2, 1, 4]);
        assert_eq!(score.pairs.counts, [0, 0, 1, 1, 1]);
        assert_eq!((score.void, score.reasons[&EndReason::EventCap]), (1, 1));
        assert!(close(score.pairs.share(), 0.75));
        assert_eq!(score.adjusted.pairs(), 3);
        assert!(close(score.wins(0.95).0, 4.0 / 6.0));
    }

    #[test]
    fn the_variance_of_many_pairs_is_that_of_their_scores() {
        let pairs = PairScores { counts: [250_000, 0, 500_000, 0, 250_000] };
        assert!((pairs.variance() - 0.125).abs() < 1e-9);
        let mirrored = PairScores { counts: [0, 0, 1_000_000, 0, 0] };
        assert!(mirrored.variance() < 2e-6);
    }

    #[test]
    fn the_interval_without_pairs_is_zero_to_one() {
        let none = PairScores::default().interval(0.95);
        assert_eq!((none.low, none.high), (0.0, 1.0));
        let few = PairScores { counts: [0, 0, 0, 0, 2] }.interval(0.95);
        assert!(few.low < 0.6 && few.high == 1.0, "{few:?}");
    }

    #[test]
    fn intervals_of_pairs_cover_the_true_share() {
        // 400 pairs with an expected share of 0.6: frames won with 0.7 and 0.5, independently.
        let mut state = 1_u64;
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut covered = 0;
        for _ in 0..2000 {
            let mut pairs = PairScores::default();
            for _ in 0..400 {
                let won = |p: f64, u: f64| if u < p { 1.0 } else { 0.0 };
                pairs.add([won(0.7, unit()), won(0.5, unit())]);
            }
            let interval = pairs.interval(0.95);
            covered += u32::from(interval.low <= 0.6 && 0.6 <= interval.high);
        }
        assert!((1870..=1930).contains(&covered), "{covered} of 2000");
    }

    #[test]
    fn pairing_saves_frames_if_the_breaker_wins() {
        // The breaker always wins: every pair is equal.
        let mirrored = PairScores { counts: [0, 0, 10, 0, 0] };
        assert_eq!(mirrored.pairing_ratio([10, 0, 10]), Some(0.0));
        // Both frames of a pair always end the same way.
        let equal = PairScores { counts: [5, 0, 0, 0, 5] };
        assert_eq!(equal.pairing_ratio([10, 0, 10]), Some(2.0));
        let independent = PairScores { counts: [5, 0, 10, 0, 5] };
        assert_eq!(independent.pairing_ratio([20, 0, 20]), Some(1.0));
        assert_eq!(PairScores { counts: [0, 0, 0, 0, 3] }.pairing_ratio([0, 0, 6]), None);
    }

    #[test]
    fn normalised_elo_is_elo_for_small_differences_of_independent_frames() {
        let even = PairScores { counts: [250_000, 0, 500_000, 0, 250_000] };
        for elo in [-20.0, -1.0, 0.0, 7.0] {
            assert!((even.normalised_elo(share_of_elo(elo)) - elo).abs() < 0.03);
            assert!((even.normalised_elo(even.share_of_normalised_elo(elo)) - elo).abs() < 1e-9);
        }
    }

    // fishtest's formula for these counts: the mean is 0.55 and the variance 0.06, so it is
    // 0.05/√0.12 · 800/ln 10.
    #[test]
    fn normalised_elo_is_that_of_fishtest() {
        let pairs = PairScores { counts: [5, 15, 45, 25, 10].map(|n| 100_000 * n) };
        assert!(close(pairs.share(), 0.55));
        assert!(
            (pairs.normalised_elo(0.55) - 50.148).abs() < 0.001,
            "{}",
            pairs.normalised_elo(0.55)
        );
    }

    // Elo (1978), table 2.11: a difference of 200 points gives a share of 0.76.
    #[test]
    fn ratings_and_shares_convert_both_ways() {
        assert!((share_of_elo(200.0) - 0.76).abs() < 0.005);
        for elo in [-300.0, -1.0, 0.0, 7.0, 500.0] {
            assert!((elo_of_share(share_of_elo(elo)) - elo).abs() < 1e-9);
        }
    }
}
