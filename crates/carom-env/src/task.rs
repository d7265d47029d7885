//! The tasks.

use carom::Error;
use carom_rules::Rules;

use crate::names::named;

/// The task of an environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// One shot at randomly placed balls: pot one.
    Potting,
    /// A frame of a game.
    Game(Rules),
    /// Two balls on a table without pockets: touch exactly three cushions.
    SumToThree,
}

impl Task {
    /// Every task.
    pub const ALL: [Self; 8] = [
        Self::Potting,
        Self::Game(Rules::EightBall),
        Self::Game(Rules::NineBall),
        Self::Game(Rules::TenBall),
        Self::Game(Rules::StraightPool),
        Self::Game(Rules::Snooker),
        Self::Game(Rules::ThreeCushion),
        Self::SumToThree,
    ];

    /// The task's name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Potting => "potting",
            Self::Game(rules) => rules.name(),
            Self::SumToThree => "sum-to-three",
        }
    }

    /// The task called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "task", name)
    }

    /// The name of the task's own table.
    pub(crate) const fn table(self) -> &'static str {
        match self {
            Self::Potting => "wpa-9ft",
            Self::Game(rules) => rules.rack().table(),
            Self::SumToThree => "carom-10ft",
        }
    }

    /// Whether the cue ball can ever be in hand.
    pub const fn has_hand(self) -> bool {
        !matches!(self, Self::Potting | Self::SumToThree | Self::Game(Rules::ThreeCushion))
    }

    /// Whether fouls can make a score negative.
    pub(crate) const fn has_negative_scores(self) -> bool {
        matches!(self, Self::Game(Rules::StraightPool))
    }

    /// Smallest and largest number of object balls that can be placed at random at the start; none
    /// where the start is always the same. In snooker these are the reds; the colours are on their
    /// spots.
    pub(crate) const fn random_balls(self) -> Option<[usize; 2]> {
        match self {
            Self::Potting | Self::Game(Rules::EightBall) => Some([1, 15]),
            Self::Game(Rules::NineBall) => Some([1, 9]),
            Self::Game(Rules::TenBall) => Some([1, 10]),
            Self::Game(Rules::StraightPool) => Some([2, 15]),
            Self::Game(Rules::Snooker) => Some([0, 15]),
            Self::Game(Rules::ThreeCushion) => Some([2, 2]),
            Self::Game(Rules::Practice) | Self::SumToThree => None,
        }
    }
}
