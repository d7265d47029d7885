//! What a break does, counted.

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
