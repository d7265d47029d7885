//! The time of one decision.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The expected time of a round and of the statement of the chances after it, divided by the time of the
/// round before. A round of the searching player has 1.6 times as many simulated shots as the one before.
const GROWTH: f64 = 2.0;

/// The time limit of one decision, for any clock. It ends a search when the next round would probably
/// not fit into the time that is left.
#[derive(Debug)]
pub struct TimeLimit {
    /// s
    limit: f64,
    /// When [`Self::is_over`] was last asked, s after the start.
    asked: Mutex<f64>,
}

impl TimeLimit {
    /// A decision that may take `limit` seconds.
    pub const fn new(limit: f64) -> Self {
        Self { limit, asked: Mutex::new(0.0) }
    }

    /// Whether the search should end `now` seconds after its start. Ask it once after every round:
    /// the next round is expected to take twice as long as the one that has just ended.
    pub fn is_over(&self, now: f64) -> bool {
        let mut asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        let last_round = now - core::mem::replace(&mut *asked, now);
        now + GROWTH * last_round > self.limit
    }
}

/// A [`TimeLimit`] with the clock of the machine.
#[derive(Debug)]
pub struct ThinkingTime {
    start: Instant,
    limit: TimeLimit,
}

impl ThinkingTime {
    /// Starts the clock of a decision that may take `limit` seconds.
    pub fn begin(limit: f64) -> Self {
        Self { start: Instant::now(), limit: TimeLimit::new(limit) }
    }

    /// The time since the start, s.
    pub fn elapsed(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// Whether the search should end now, see [`TimeLimit::is_over`].
    pub fn is_over(&self) -> bool {
        self.limit.is_over(self.elapsed())
    }
}

#[cfg(test)]
mod tests {
    use super::{ThinkingTime, TimeLimit};
    use std::thread::sleep;
    use std::time::Duration;

    #[test]
    fn the_next_round_is_expected_to_take_twice_the_time_since_the_clock_was_last_asked() {
        let time = TimeLimit::new(10.0);
        assert!(!time.is_over(2.0)); // the next one would end at 6 s
        assert!(!time.is_over(4.0)); // at 8 s
        assert!(time.is_over(7.0)); // at 13 s
        assert!(TimeLimit::new(5.0).is_over(2.0));
    }

    #[test]
    fn no_round_begins_that_would_probably_not_fit() {
        // The first round took at least 50 ms, so the second one would end after 150 ms.
        for (limit, is_over) in [(0.1, true), (1e6, false), (f64::INFINITY, false)] {
            let time = ThinkingTime::begin(limit);
            sleep(Duration::from_millis(50));
            assert_eq!(time.is_over(), is_over, "{limit}");
        }
    }

    #[test]
    fn the_next_round_is_expected_to_last_twice_as_long_as_the_last_one() {
        let time = ThinkingTime::begin(1e6);
        sleep(Duration::from_millis(20));
        assert!(!time.is_over());
        assert!(time.elapsed() >= 0.02);
    }
}
