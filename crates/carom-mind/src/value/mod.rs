//! Values of positions: the probability that a seat wins the frame.

pub mod features;
mod lanes;
mod logistic;
mod markov;
mod needs;
mod ways;
mod weights;

pub use features::Features;
pub use lanes::{Lanes, Reference};
pub use logistic::Logistic;
pub use markov::Markov;

use carom::Noise;
use carom_rules::{Frame, Request, Seat, Turn};

/// A position to be valued: a frame, and the errors of both players.
#[derive(Clone, Copy, Debug)]
pub struct Position<'a> {
    /// The frame.
    pub frame: &'a Frame,
    /// The errors of seat 0 and seat 1.
    pub noise: &'a [Noise; 2],
}

/// An estimate of the probability that a seat wins.
pub trait Value: Sync + Send {
    /// Its name in tables.
    fn name(&self) -> &str;

    /// The probability, 0 to 1, that the player of `turn` wins the position's frame, which asks for
    /// it.
    fn of_shot(&self, position: &Position<'_>, turn: &Turn) -> f64;

    /// The probability, 0 to 1, that `seat` wins the frame. A frame without a winner counts as half
    /// a win. A player who has a choice takes the best option.
    fn win_chance(&self, position: &Position<'_>, seat: Seat) -> f64 {
        let of_player = |player: Seat, value: f64| if player == seat { value } else { 1.0 - value };
        match position.frame.request() {
            Request::Over { winner: None, .. } => 0.5,
            Request::Over { winner: Some(winner), .. } => of_player(*winner, 1.0),
            Request::Shot(turn) => of_player(turn.player, self.of_shot(position, turn)),
            Request::Choice { player, choices, .. } => {
                let values = choices.iter().filter_map(|choice| {
                    let mut next = position.frame.clone();
                    next.choose(*choice).ok()?;
                    Some(self.win_chance(&Position { frame: &next, ..*position }, *player))
                });
                of_player(*player, values.fold(0.0, f64::max))
            }
        }
    }
}
