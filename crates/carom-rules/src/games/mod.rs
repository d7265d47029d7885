//! The games, a file each.

pub mod eight_ball;
pub mod practice;
pub mod rotation;
pub mod snooker;
pub mod straight_pool;
pub mod three_cushion;

use carom::Error;
use carom::format::Node;
use carom::rack;

use crate::facts::Facts;
use crate::frame::State;
use crate::layout::Layout;
use crate::play::{Call, Play};
use crate::request::{Choice, Request, Turn};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

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
    /// A table with a rack of fifteen, where nothing is forbidden.
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

    /// Its name on the command line and in Python.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Practice => "practice",
            _ => self.rack().name(),
        }
    }

    /// The game of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|rules| rules.name() == name)
    }

    /// The game of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        let names = Self::ALL.map(Self::name).join(", ");
        Self::named(name).ok_or_else(|| {
            Error::input(
                "game",
                format!("no rules are called \"{name}\""),
                format!("write one of {names}"),
            )
        })
    }

    /// How its balls are racked.
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

    /// The ball that decides the game, if it is one.
    pub(crate) const fn deciding_ball(self) -> Option<BallIndex> {
        match self {
            Self::EightBall => Some(8),
            Self::NineBall => Some(9),
            Self::TenBall => Some(10),
            _ => None,
        }
    }

    pub(crate) const fn needs_pockets(self) -> bool {
        !matches!(self, Self::ThreeCushion)
    }

    /// Whether points, not balls off the table, tell progress.
    pub(crate) const fn is_scored_by_shots(self) -> bool {
        matches!(self, Self::StraightPool | Self::ThreeCushion)
    }

    pub(crate) const fn is_racked_after_stalemate(self) -> bool {
        !matches!(self, Self::ThreeCushion | Self::Practice)
    }

    /// Whether scores are lost when the balls are racked again (WPBSA, section 3, rule 16).
    pub(crate) const fn is_nullified_by_stalemate(self) -> bool {
        matches!(self, Self::Snooker)
    }

    /// The number of the rule that forbids `foul` in this game, where the rule book has it; empty where
    /// the rule is implemented from general knowledge.
    pub const fn rule(self, foul: Foul) -> &'static str {
        match self {
            Self::EightBall | Self::NineBall | Self::TenBall | Self::StraightPool => {
                crate::pool::rule(self, foul)
            }
            Self::Snooker => snooker::rule(foul),
            Self::ThreeCushion => three_cushion::rule(foul),
            Self::Practice => "",
        }
    }
}

/// What can be agreed on before a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Points that win: straight pool (usually 100 to 150) and three-cushion (usually 40).
    pub target: i32,
    /// Whether a foul and a miss is called in snooker.
    pub miss: bool,
    /// Shots in a row without progress (no ball gone for good, no score better than any before) that
    /// make a stalemate. So every frame ends.
    pub patience: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { target: 40, miss: true, patience: 100 }
    }
}

impl Options {
    pub(crate) fn check(&self) -> Result<(), Error> {
        let wrong = |place: &str, value: i64| {
            Err(Error::input(place, format!("{value} is out of range"), "write at least 1"))
        };
        if self.target < 1 {
            return wrong("options.target", self.target.into());
        }
        if self.patience < 1 {
            return wrong("options.patience", self.patience.into());
        }
        Ok(())
    }
}

/// A shot that was played, for a referee.
pub(crate) struct Played<'a> {
    /// What was asked.
    pub(crate) turn: &'a Turn,
    pub(crate) play: &'a Play,
    pub(crate) facts: &'a Facts,
    /// The balls before the shot, with the cue ball where it was put.
    pub(crate) before: &'a Layout,
}

impl Played<'_> {
    /// Who shot.
    pub(crate) const fn player(&self) -> Player {
        self.turn.player
    }

    /// Who did not.
    pub(crate) const fn other(&self) -> Player {
        1 - self.turn.player
    }

    /// The called ball, if it fell into the called pocket.
    pub(crate) fn made(&self) -> Option<BallIndex> {
        let Call::Pocket(ball, pocket) = self.play.call else { return None };
        (self.facts.pocket_of(ball) == Some(pocket)).then_some(ball)
    }
}

/// What a game remembers of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Eight-ball.
    EightBall(eight_ball::EightBall),
    /// Nine-ball and ten-ball.
    Rotation(rotation::Rotation),
    /// Straight pool.
    StraightPool(straight_pool::StraightPool),
    /// Snooker.
    Snooker(snooker::Snooker),
    /// Three-cushion.
    ThreeCushion(three_cushion::ThreeCushion),
    /// Practice.
    Practice(practice::Practice),
}

/// The game that a law, shared or not, is of.
macro_rules! any_game {
    ($law:expr) => {
        match $law {
            Law::EightBall(game) => game,
            Law::Rotation(game) => game,
            Law::StraightPool(game) => game,
            Law::Snooker(game) => game,
            Law::ThreeCushion(game) => game,
            Law::Practice(game) => game,
        }
    };
}

impl Law {
    pub(crate) fn new(rules: Rules) -> Self {
        match rules {
            Rules::EightBall => Self::EightBall(Default::default()),
            Rules::NineBall => Self::Rotation(rotation::Rotation::nine_ball()),
            Rules::TenBall => Self::Rotation(rotation::Rotation::ten_ball()),
            Rules::StraightPool => Self::StraightPool(Default::default()),
            Rules::Snooker => Self::Snooker(Default::default()),
            Rules::ThreeCushion => Self::ThreeCushion(Default::default()),
            Rules::Practice => Self::Practice(Default::default()),
        }
    }

    pub(crate) fn game(&self) -> &dyn Game {
        any_game!(self)
    }

    pub(crate) fn game_mut(&mut self) -> &mut dyn Game {
        any_game!(self)
    }
}

/// What a game decides.
pub(crate) trait Game {
    /// The first request, of the player who breaks.
    fn open(&mut self, state: &mut State, breaker: Player) -> Request;

    /// The request in the middle of a game of which nothing is known but where the balls lie, with `player`
    /// to shoot.
    fn middle(&mut self, state: &State, player: Player) -> Request;

    /// Rules on a shot, in the state's ruling, and says what is asked next.
    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request;

    /// Carries out a choice, and says what is asked next.
    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request;

    /// What this game keeps and others do not.
    fn to_node(&self, _: &State) -> Node {
        Node::object([])
    }
}
