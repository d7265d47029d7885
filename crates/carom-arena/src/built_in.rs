//! The built-in players by their names, for the command line and the bindings.

use std::sync::LazyLock;

use carom::Error;
use carom::format::Node;
use carom_mind::literature::{self, Literature};
use carom_mind::{Budget, Player, Searcher};

use crate::clock::Clock;
use crate::settings::PlayerEntry;

/// The name of the searching player.
const SEARCHER: &str = "carom";

/// Makes the players of the literature. They share the potting probabilities that they measure, so
/// each table is measured once in a program.
static LITERATURE: LazyLock<Literature> = LazyLock::new(Literature::default);

/// The most simulated shots with which a player of the literature may plan: some minutes of one core.
/// With the number that stands for no limit, a decision would take hours.
pub const MOST_PLANNED: u64 = 5_000_000;

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

    /// The player, as new, if it is the searching one.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for a player of the literature, which does not explain its plays.
    pub fn searcher(&self) -> Result<Searcher, Error> {
        if self.is_searcher() {
            return Ok(Searcher::default());
        }
        let what = format!("{} does not explain its plays", self.name);
        Err(Error::input("player", what, "ask the player carom"))
    }

    /// Rejects a budget without a bound: the players of the literature plan with all simulated shots
    /// of a decision, whatever the clock says.
    ///
    /// # Errors
    /// [`Error::Input`] at `simulations`, for a player of the literature and more than
    /// [`MOST_PLANNED`] of them.
    pub fn check_budget(&self, budget: &Budget<'_>) -> Result<(), Error> {
        if self.is_searcher() || budget.simulations <= MOST_PLANNED {
            return Ok(());
        }
        let what = format!("{} plans with a number of simulated shots, not with a time", self.name);
        Err(Error::input("simulations", what, format!("give a number up to {MOST_PLANNED}")))
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
    use super::{BuiltInPlayer, MOST_PLANNED};
    use crate::clock::Clock;
    use carom_mind::Budget;

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
    fn only_the_searching_player_explains_and_takes_any_budget() {
        let [searcher, other] = ["carom", "greedy"].map(|name| BuiltInPlayer::read(name).unwrap());
        assert!(searcher.searcher().is_ok());
        assert!(other.searcher().is_err_and(|e| e.to_string().starts_with("player: ")));
        for (simulations, is_accepted) in [(MOST_PLANNED, true), (MOST_PLANNED + 1, false)] {
            let budget = Budget::simulations(simulations);
            assert!(searcher.check_budget(&budget).is_ok());
            assert_eq!(other.check_budget(&budget).is_ok(), is_accepted);
        }
    }

    #[test]
    fn rejects_unknown_names_and_numbers() {
        for text in ["", "Carom", "someone", "carom:", "carom:0", "carom:-5", "carom:1e3", ":5"] {
            let error = BuiltInPlayer::read(text).unwrap_err().to_string();
            assert!(error.starts_with("player: ") && error.contains("carom"), "{error}");
        }
    }
}
