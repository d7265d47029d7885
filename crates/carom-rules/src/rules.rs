//! The sets of rules and their options.

use carom::{Error, rack};

use crate::layout::BallIndex;

/// A set of rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rules {
    /// Eight-ball (WPA, section 3).
    EightBall,
    /// Nine-ball (WPA, section 2).
    NineBall,
    /// Ten-ball (WPA, section 9).
    TenBall,
    /// 14.1 continuous pool (WPA, section 4).
    StraightPool,
    /// Snooker (WPBSA, section 3).
    Snooker,
    /// Three-cushion carom (UMB).
    ThreeCushion,
    /// A rack of fifteen balls without fouls.
    Practice,
}

impl Rules {
    /// Every game.
    pub const ALL: [Self; 7] = [
        Self::EightBall,
        Self::NineBall,
        Self::TenBall,
        Self::StraightPool,
        Self::Snooker,
        Self::ThreeCushion,
        Self::Practice,
    ];

    /// The game's name on the command line and in Python.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Practice => "practice",
            _ => self.rack().name(),
        }
    }

    /// The game called `name`, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|rules| rules.name() == name)
    }

    /// The game called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        let names = Self::ALL.map(Self::name).join(", ");
        Self::named(name).ok_or_else(|| {
            Error::input(
                "game",
                format!("there are no rules called \"{name}\""),
                format!("write one of {names}"),
            )
        })
    }

    /// The rack of the game.
    pub const fn rack(self) -> rack::Game {
        match self {
            Self::EightBall | Self::Practice => rack::Game::EightBall,
            Self::NineBall => rack::Game::NineBall,
            Self::TenBall => rack::Game::TenBall,
            Self::StraightPool => rack::Game::StraightPool,
            Self::Snooker => rack::Game::Snooker,
            Self::ThreeCushion => rack::Game::ThreeCushion,
        }
    }

    /// The ball that decides the game, if a single ball does.
    pub(crate) const fn deciding_ball(self) -> Option<BallIndex> {
        match self {
            Self::EightBall => Some(8),
            Self::NineBall => Some(9),
            Self::TenBall => Some(10),
            _ => None,
        }
    }

    /// Whether the game is played on a table with pockets.
    pub(crate) const fn needs_pockets(self) -> bool {
        !matches!(self, Self::ThreeCushion)
    }

    /// Whether progress is measured by points instead of balls that have left the table.
    pub(crate) const fn is_scored_by_shots(self) -> bool {
        matches!(self, Self::StraightPool | Self::ThreeCushion)
    }

    /// Whether the first stalemate leads to a new rack. In other games it ends the frame.
    pub(crate) const fn is_racked_after_stalemate(self) -> bool {
        !matches!(self, Self::ThreeCushion | Self::Practice)
    }

    /// Whether the scores are reset after a stalemate (WPBSA, section 3, rule 16).
    pub(crate) const fn is_nullified_by_stalemate(self) -> bool {
        matches!(self, Self::Snooker)
    }
}

/// The settings of a frame, agreed before it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Points needed to win: straight pool (usually 100 to 150) and three-cushion (usually 40).
    pub points: i32,
    /// Whether the foul-and-a-miss rule applies in snooker.
    pub miss: bool,
    /// Number of consecutive shots without progress that make a stalemate. A shot makes progress if
    /// fewer balls than ever since the last rack remain on the table; in straight pool and
    /// three-cushion, if it raises a player's best score. The limit guarantees that every frame
    /// ends.
    pub patience: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { points: 40, miss: true, patience: 100 }
    }
}

impl Options {
    /// Checks that all options are in range.
    ///
    /// # Errors
    /// [`Error::Input`] if one is not.
    pub fn check(&self) -> Result<(), Error> {
        let wrong = |place: &str, value: i64| {
            Err(Error::input(place, format!("{value} is out of range"), "write at least 1"))
        };
        if self.points < 1 {
            return wrong("options.points", self.points.into());
        }
        if self.patience < 1 {
            return wrong("options.patience", self.patience.into());
        }
        Ok(())
    }
}
