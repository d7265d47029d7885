//! The games, one file each.

pub mod chinese_eight_ball;
pub mod eight_ball;
mod facts;
pub mod four_ball;
mod game;
mod group;
mod innings;
mod pool;
pub mod practice;
pub mod rotation;
pub mod six_red;
pub mod snooker;
pub mod straight_pool;
pub mod straight_rail;
pub mod three_cushion;

use carom::rack::Game;

use crate::state_bytes::StateBytes;

pub use facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
pub(crate) use game::{GameRules, PlayedShot};

/// Makes the enum of the games' states, and what each of them does.
macro_rules! game_states {
    ($($(#[$doc:meta])+ $name:ident($state:ty),)+) => {
        /// The state that only one game has.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum GameState {
            $($(#[$doc])+ $name($state),)+
        }

        impl GameState {
            /// The state that `bytes` begin with, of the same game as this one.
            pub(crate) fn read_same(&self, bytes: &mut &[u8]) -> Option<Self> {
                Some(match self {
                    $(Self::$name(_) => Self::$name(StateBytes::read_from(bytes)?),)+
                })
            }

            pub(crate) fn write_to(&self, out: &mut Vec<u8>) {
                match self {
                    $(Self::$name(state) => state.write_to(out),)+
                }
            }

            pub(crate) fn rules(&self) -> &dyn GameRules {
                match self {
                    $(Self::$name(state) => state,)+
                }
            }

            pub(crate) fn rules_mut(&mut self) -> &mut dyn GameRules {
                match self {
                    $(Self::$name(state) => state,)+
                }
            }
        }
    };
}

game_states! {
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
    /// Straight rail.
    StraightRail(straight_rail::StraightRail),
    /// Korean four-ball.
    FourBall(four_ball::FourBall),
    /// Six-red snooker.
    SixRed(six_red::SixRed),
    /// Chinese eight-ball.
    ChineseEightBall(chinese_eight_ball::ChineseEightBall),
    /// Practice.
    Practice(practice::Practice),
}

impl GameFacts {
    /// The facts of `game`.
    pub const fn of(game: Game) -> &'static Self {
        match game {
            Game::EightBall => &eight_ball::FACTS,
            Game::NineBall => &rotation::NINE_BALL,
            Game::TenBall => &rotation::TEN_BALL,
            Game::StraightPool => &straight_pool::FACTS,
            Game::Snooker => &snooker::FACTS,
            Game::ThreeCushion => &three_cushion::FACTS,
            Game::StraightRail => &straight_rail::FACTS,
            Game::FourBall => &four_ball::FACTS,
            Game::SixRed => &six_red::FACTS,
            Game::ChineseEightBall => &chinese_eight_ball::FACTS,
            Game::Practice => &practice::FACTS,
        }
    }
}
