//! The built-in players by their names, for the command line and the bindings.

use std::sync::LazyLock;

use carom::Error;
use carom::format::Node;
use carom_mind::literature::{self, Literature};
use carom_mind::{Player, Searcher};

use crate::clock::Clock;
use crate::settings::PlayerEntry;

/// The name of the searching player.
const SEARCHER: &str = "carom";

/// Makes the players of the literature. They share the potting probabilities that they measure, so
/// each table is measured once in a program.
static LITERATURE: LazyLock<Literature> = LazyLock::new(Literature::default);

/// A built-in player: a name, and simulated shots for each decision if the text gives them.
///
/// It is written `NAME` or `NAME:SIMULATIONS`, such as `carom:2000`.
#[derive(Clone, Copy, Debug)]
pub struct BuiltInPlayer {
    name: &'static str,
    simulations: Option<u32>,
}

impl BuiltInPlayer {
    /// The names of all built-in players.
    pub fn names() -> impl Iterator<Item = &'static str> {
        core::iter::once(SEARCHER).chain(literature::NAMES)
    }

    /// Reads `NAME` or `NAME:SIMULATIONS`.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for an unknown name, and for a number of simulated shots that is
    /// not a whole number from 1 to 2³² − 1.
    pub fn read(text: &str) -> Result<Self, Error> {
        let (name, simulations) = match text.split_once(':') {
            Some((name, number)) => (name, Some(read_simulations(number)?)),
            None => (text, None),
        };
        let Some(name) = Self::names().find(|known| *known == name) else {
            let names: Vec<&str> = Self::names().collect();
            let what = format!("there is no player \"{name}\"");
            let remedy = format!(
                "write one of {}; a number of simulated shots may follow, as in carom:2000",
                names.join(", ")
            );
            return Err(Error::input("player", what, remedy));
        };
        Ok(Self { name, simulations })
    }

    /// The player's name without the number.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The simulated shots for each decision, if the text gave them.
    pub const fn simulations(&self) -> Option<u32> {
        self.simulations
    }

    /// The clock of the simulated shots that the text gave, or else `usual`.
    pub fn clock(&self, usual: Clock) -> Clock {
        self.simulations.map_or(usual, Clock::simulations)
    }

    /// The player, as new.
    pub fn make(&self) -> Box<dyn Player> {
        // Only the searching player is not of the literature, and all names are known.
        LITERATURE.player(self.name).unwrap_or_else(|_| Box::new(Searcher::default()))
    }

    /// Whether it is the searching player, which can also explain a position.
    pub fn is_searcher(&self) -> bool {
        self.name == SEARCHER
    }

    /// The player as a match has it. Its name contains the simulated shots.
    pub fn entry(&self) -> PlayerEntry {
        let name = match self.simulations {
            Some(simulations) => format!("{}:{simulations}", self.name),
            None => self.name.into(),
        };
        PlayerEntry { name, settings: Node::object([("player", self.name.into())]) }
    }
}

fn read_simulations(text: &str) -> Result<u32, Error> {
    text.parse().ok().filter(|number| *number > 0).ok_or_else(|| {
        let what = format!("\"{text}\" is not a number of simulated shots");
        let remedy = format!("write a whole number from 1 to {}, as in carom:2000", u32::MAX);
        Error::input("player", what, remedy)
    })
}

#[cfg(test)]
mod tests {
    use super::BuiltInPlayer;
    use crate::clock::Clock;

    #[test]
    fn every_name_makes_the_player_of_this_name() {
        for name in BuiltInPlayer::names() {
            let player = BuiltInPlayer::read(name).unwrap();
            assert_eq!((player.name(), player.make().name()), (name, name));
            assert_eq!((player.simulations(), player.entry().name.as_str()), (None, name));
        }
    }

    #[test]
    fn a_number_behind_the_name_is_the_clock_of_a_decision() {
        let usual = Clock::seconds(2.0);
        let player = BuiltInPlayer::read("carom:2000").unwrap();
        assert_eq!(player.clock(usual), Clock::simulations(2000));
        assert_eq!(player.entry().name, "carom:2000");
        assert_eq!(BuiltInPlayer::read("carom").unwrap().clock(usual), usual);
    }

    #[test]
    fn rejects_unknown_names_and_numbers() {
        for text in ["", "Carom", "someone", "carom:", "carom:0", "carom:-5", "carom:1e3", ":5"] {
            let error = BuiltInPlayer::read(text).unwrap_err().to_string();
            assert!(error.starts_with("player: ") && error.contains("carom"), "{error}");
        }
    }
}
