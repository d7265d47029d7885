//! A practice table: nothing is forbidden, one player shoots until the balls are down.

use crate::Player;
use crate::frame::State;
use crate::games::Played;
use crate::pool::{self, CUE};
use crate::request::{Calls, Region, Request};
use crate::ruling::Ruling;

/// A practice table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Practice;

impl Practice {
    pub(crate) fn open(&mut self, player: Player) -> Request {
        pool::break_shot(player, Vec::new(), Calls::default())
    }

    pub(crate) fn judge(
        &mut self,
        state: &mut State,
        shot: &Played<'_>,
        ruling: &mut Ruling,
    ) -> Request {
        let player = shot.turn.player;
        ruling.points[player] = shot.facts.potted().count() as i32;
        if state.layout.on_table().all(|ball| ball == CUE) {
            return Request::Over { winner: Some(player), why: "all balls are down" };
        }
        let hand = Some(Region::Anywhere);
        pool::shot(state, player, hand, Vec::new(), Calls::default())
    }
}
