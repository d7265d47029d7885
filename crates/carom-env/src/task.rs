//! The tasks.

use carom::Error;
use carom_rules::{Game, GameFacts, Scoring};

use crate::names::named;

/// The task of an environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// One shot at randomly placed balls: pot one.
    Potting,
    /// A frame of a game.
    Game(Game),
    /// Two balls on a table without pockets: touch exactly three cushions.
    SumToThree,
}

impl Task {
    /// Every task: the games that can begin in a random middle, and the others.
    pub fn all() -> Vec<Self> {
        let games = Game::ALL.into_iter().map(Self::Game);
        let mut tasks = vec![Self::Potting];
        tasks.extend(games.filter(|task| task.random_balls().is_some()));
        tasks.push(Self::SumToThree);
        tasks
    }

    /// The task's name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Potting => "potting",
            Self::Game(game) => game.name(),
            Self::SumToThree => "sum-to-three",
        }
    }

    /// The task called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::all(), Self::name, "task", name)
    }

    /// The name of the task's own table.
    pub(crate) const fn table(self) -> &'static str {
        match self {
            Self::Potting => "wpa-9ft",
            Self::Game(game) => game.table(),
            Self::SumToThree => "carom-10ft",
        }
    }

    /// Whether the cue ball can ever be in hand.
    pub const fn has_hand(self) -> bool {
        match self {
            Self::Potting | Self::SumToThree => false,
            Self::Game(game) => !GameFacts::of(game).is_carom(),
        }
    }

    /// Whether fouls can make a score negative.
    pub(crate) const fn has_negative_scores(self) -> bool {
        match self {
            Self::Potting | Self::SumToThree => false,
            Self::Game(game) => {
                matches!(GameFacts::of(game).scoring, Scoring::Target { negative: true, .. })
            }
        }
    }

    /// Smallest and largest number of object balls that can be placed at random at the start; none
    /// where the start is always the same. In snooker these are the reds; the colours are on their
    /// spots.
    pub(crate) const fn random_balls(self) -> Option<[usize; 2]> {
        match self {
            Self::Potting => Some([1, 15]),
            Self::Game(game) => match &GameFacts::of(game).random_start {
                Some(start) => Some(start.count),
                None => None,
            },
            Self::SumToThree => None,
        }
    }
}
