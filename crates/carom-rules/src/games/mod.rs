//! The games, one file each.

pub mod eight_ball;
mod game;
mod pool;
pub mod practice;
pub mod rotation;
pub mod snooker;
pub mod straight_pool;
pub mod three_cushion;

use crate::rules::Rules;
use crate::ruling::Foul;
use crate::state_bytes::StateBytes;

pub(crate) use game::{GameRules, PlayedShot};

impl Rules {
    /// The number in the rule book of the rule that forbids `foul` in this game. Empty where the
    /// rule is implemented from general knowledge of the game.
    pub const fn rule(self, foul: Foul) -> &'static str {
        match self {
            Self::EightBall | Self::NineBall | Self::TenBall | Self::StraightPool => {
                pool::rule(self, foul)
            }
            Self::Snooker => snooker::rule(foul),
            Self::ThreeCushion => three_cushion::rule(foul),
            Self::Practice => "",
        }
    }
}

/// The state that only one game has.
#[expect(clippy::large_enum_variant, reason = "a heap would make copies of frames allocate")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GameState {
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

/// The rules in a `&GameState` or `&mut GameState`.
macro_rules! rules_of {
    ($state:expr) => {
        match $state {
            GameState::EightBall(game) => game,
            GameState::Rotation(game) => game,
            GameState::StraightPool(game) => game,
            GameState::Snooker(game) => game,
            GameState::ThreeCushion(game) => game,
            GameState::Practice(game) => game,
        }
    };
}

impl GameState {
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

    /// The state that `bytes` begin with, of the same game as this one.
    pub(crate) fn read_same(&self, bytes: &mut &[u8]) -> Option<Self> {
        Some(match self {
            Self::EightBall(_) => Self::EightBall(StateBytes::read_from(bytes)?),
            Self::Rotation(_) => Self::Rotation(StateBytes::read_from(bytes)?),
            Self::StraightPool(_) => Self::StraightPool(StateBytes::read_from(bytes)?),
            Self::Snooker(_) => Self::Snooker(StateBytes::read_from(bytes)?),
            Self::ThreeCushion(_) => Self::ThreeCushion(StateBytes::read_from(bytes)?),
            Self::Practice(_) => Self::Practice(StateBytes::read_from(bytes)?),
        })
    }

    pub(crate) fn write_to(&self, out: &mut Vec<u8>) {
        match self {
            Self::EightBall(game) => game.write_to(out),
            Self::Rotation(game) => game.write_to(out),
            Self::StraightPool(game) => game.write_to(out),
            Self::Snooker(game) => game.write_to(out),
            Self::ThreeCushion(game) => game.write_to(out),
            Self::Practice(game) => game.write_to(out),
        }
    }

    pub(crate) fn rules(&self) -> &dyn GameRules {
        rules_of!(self)
    }

    pub(crate) fn rules_mut(&mut self) -> &mut dyn GameRules {
        rules_of!(self)
    }
}
