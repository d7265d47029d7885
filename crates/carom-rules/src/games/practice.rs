//! A practice table: nothing is forbidden, one player shoots until the balls are down.

use crate::Player;
use crate::frame::State;
use crate::games::{Game, Played};
use crate::pool::{self, CUE};
use crate::request::{Calls, Choice, Region, Request};

/// A practice table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Practice;

impl Game for Practice {
    fn open(&mut self, _: &mut State, player: Player) -> Request {
        pool::break_shot(player, Vec::new(), Calls::NONE)
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        pool::shot(state, player, None, Vec::new(), Calls::NONE)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let player = shot.player();
        state.ruling.points[player] = shot.facts.potted().count() as i32;
        if state.layout.on_table().all(|ball| ball == CUE) {
            return Request::won(player, "all balls are down");
        }
        pool::shot(state, player, Some(Region::Anywhere), Vec::new(), Calls::NONE)
    }

    /// It asks for none.
    fn choose(&mut self, state: &mut State, player: Player, _: Choice) -> Request {
        self.open(state, player)
    }
}
