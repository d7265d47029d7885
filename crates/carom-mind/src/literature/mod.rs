//! The players of the literature, as opponents and as measures.
//!
//! Each file has one published player: [`Greedy`], [`DeepGreen`], [`PoolMaster`], [`PickPocket`]
//! and [`CueCard`]. Their settings are structures whose defaults are the papers' numbers where
//! these are printed; every other number is marked as a guess in its comment. docs/players.md
//! describes the players and lists the guesses.
//!
//! All of them are a [`Planner`]: they choose pots by their own method and answer every other
//! request in the same way. They count simulated shots instead of seconds:
//! [`Budget::simulations`](crate::Budget) limits a decision, apart from a least search. A decision
//! has the same bits for any number of threads.

mod baseline;
mod best_shots;
mod clusters;
mod cue_card;
mod deep_green;
mod greedy;
mod levels;
mod pick_pocket;
mod planner;
mod pool_master;
mod position_grid;
mod pot_table;
mod shots;
#[cfg(test)]
mod tests;

pub use cue_card::{CueCard, CueCardBreak, CueCardSettings, LevelTwo};
pub use deep_green::{DeepGreen, DeepGreenSettings};
pub use greedy::{Greedy, GreedyAim, GreedySettings};
pub use pick_pocket::{PickPocket, PickPocketSettings};
pub use planner::Planner;
pub use pool_master::{PoolMaster, PoolMasterSettings};

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};

use crate::player::Player;
use planner::Method;
use pot_table::PotTables;

/// The names of the players that [`Literature::player`] makes.
pub const NAMES: [&str; 7] = [
    "greedy",
    "deep-green-0",
    "deep-green-1",
    "deep-green-2",
    "pool-master",
    "pick-pocket",
    "cue-card",
];

/// Makes the players with their default settings. The players of one `Literature` share the potting
/// probabilities that they measure.
#[derive(Clone, Debug, Default)]
pub struct Literature {
    tables: PotTables,
}

impl Literature {
    /// The player called `name`, one of [`NAMES`].
    ///
    /// # Errors
    /// [`Error::Input`] at `player` if there is none.
    pub fn player(&self, name: &str) -> Result<Box<dyn Player>, Error> {
        self.player_with(name, &Reader::new(&Node::object([]), "settings"))
    }

    /// The same with some settings: `samples` of `pick-pocket`; `samples`, `level-two` (`searched`,
    /// `off` or `given-to-level-one`) and `break` (`searched` or `usual`) of `cue-card`; `aim`
    /// (`geometric` or `simulated`) of `greedy`.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` if there is none, and at a setting that is not the player's.
    pub fn player_with(&self, name: &str, settings: &Reader<'_>) -> Result<Box<dyn Player>, Error> {
        let deep_green = |depth| {
            let method = DeepGreenSettings { depth, ..DeepGreenSettings::default() };
            settings.keys(&[]).map(|()| self.planner(method))
        };
        Ok(match name {
            "greedy" => self.planner(GreedySettings::read(settings)?),
            "deep-green-0" => deep_green(0)?,
            "deep-green-1" => deep_green(1)?,
            "deep-green-2" => deep_green(2)?,
            "pool-master" => {
                settings.keys(&[])?;
                self.planner(PoolMasterSettings::default())
            }
            "pick-pocket" => self.planner(PickPocketSettings::read(settings)?),
            "cue-card" => self.planner(CueCardSettings::read(settings)?),
            _ => {
                return Err(ErrorKind::UnknownName
                    .at(
                        "player",
                        format!("there is no player of the literature called \"{name}\""),
                        format!("write one of {}", NAMES.join(", ")),
                    )
                    .with("name", name));
            }
        })
    }

    fn planner<M: Method + 'static>(&self, method: M) -> Box<dyn Player> {
        Box::new(Planner::with_tables(method, self.tables.clone()))
    }
}

/// The example of the documentation's page on these players.
#[cfg(doctest)]
#[doc = include_str!("../../../../docs/players.md")]
struct Documentation;
