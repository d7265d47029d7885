//! Practice: no fouls, and one player shoots until all object balls are down.

use carom::rack::Game;

use super::GameState;
use super::facts::{BREAK, GameFacts, Objective, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::pool::{self, CUE};
use crate::layout::BallList;
use crate::region::Region;
use crate::request::{Calls, Choice, Request};
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::Practice,
    players: 1,
    balls: 16,
    own_cue_balls: false,
    objective: Objective::AnyBall,
    deciding_ball: None,
    scoring: Scoring::LastBall,
    opening: BREAK,
    stalemate: Stalemate::End,
    random_start: None,
    lag: false,
    miss: false,
    conceded: false,
    rule: |_| "",
    state: || GameState::Practice(Practice::default()),
};

/// A practice table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Practice {
    /// Whether the next shot is the break.
    is_opening: bool,
}

state_bytes!(struct Practice { is_opening });

impl GameRules for Practice {
    fn is_opening(&self) -> bool {
        self.is_opening
    }

    fn start(&mut self, _: &mut FrameState, seat: Seat) -> Request {
        self.is_opening = true;
        pool::break_shot(seat, BallList::new(), Calls::NONE)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.is_opening = false;
        pool::shot(state, seat, None, BallList::new(), Calls::NONE)
    }

    fn missing(&self, _: &[Option<[f64; 2]>]) -> Option<String> {
        None
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        self.is_opening = false;
        let seat = shot.seat();
        state.ruling.points[seat] = shot.potted().count() as i32;
        if state.layout.on_table().all(|ball| ball == CUE) {
            return Request::won(seat, "all balls are down");
        }
        pool::shot(state, seat, Some(Region::Anywhere), BallList::new(), Calls::NONE)
    }

    /// Practice offers no choices.
    fn choose(&mut self, state: &mut FrameState, seat: Seat, _: Choice) -> Request {
        self.start(state, seat)
    }
}
