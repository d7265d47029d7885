//! What a break does, counted.

use std::cmp::Ordering;

/// Counts of what a break does, over many racks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BreakCounts {
    /// Number of breaks.
    pub breaks: u64,
    /// Number of object balls that fell.
    pub fallen: u64,
    /// Breaks in which at least one object ball fell.
    pub any_fallen: u64,
    /// Breaks after which the breaker answers the next request, or has won.
    pub kept: u64,
    /// Breaks with a foul.
    pub fouls: u64,
    /// Breaks in which the ball fell that decides the game: the 8, 9 or 10.
    pub game_ball: u64,
    /// The mean of the estimated probability that the breaker wins.
    pub win: f64,
    /// Its standard error, from the samples alone.
    pub error: f64,
}

impl BreakCounts {
    /// Orders breaks by what they are worth: by the chance of winning, but a break that is a foul in
    /// most of its racks is below all others. Otherwise a player of snooker would foul on purpose: who
    /// misses the pack leaves the first shot to the opponent, for four points.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let is_legal = |counts: &Self| 2 * counts.fouls <= counts.breaks;
        is_legal(self).cmp(&is_legal(other)).then(self.win.total_cmp(&other.win))
    }
}
