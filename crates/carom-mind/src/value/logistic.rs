//! A logistic regression on the features of a position, fitted to matches of almost equal players.

use carom::math::exp;
use carom_rules::{Game, Turn};

use super::features::{COUNT, Features};
use super::weights;
use super::{Markov, Position, Value};

/// The value by logistic regression: 1/(1 + e^(−w·x)) with the features x and weights w of the
/// game. `scripts/fit_values.py` fits them. Opening shots are valued by [`Markov`], because no
/// feature tells one rack from another.
#[derive(Clone, Copy, Debug, Default)]
pub struct Logistic;

impl Value for Logistic {
    fn name(&self) -> &'static str {
        "logistic"
    }

    fn of_shot(&self, position: &Position<'_>, turn: &Turn) -> f64 {
        let Some(weights) = weights_of(position.frame.game()) else {
            return Markov::default().of_shot(position, turn);
        };
        if position.frame.is_opening() {
            return Markov::default().of_shot(position, turn);
        }
        let Features(features) = Features::of(position, turn);
        let sum: f64 = features.iter().zip(weights).map(|(x, w)| x * w).sum();
        1.0 / (1.0 + exp(-sum))
    }
}

/// The weights of a game; none if they have not been fitted.
fn weights_of(game: Game) -> Option<&'static [f64; COUNT]> {
    let of_game = weights::WEIGHTS.iter().find(|(name, _)| *name == game.name());
    of_game.map(|(_, weights)| weights)
}
