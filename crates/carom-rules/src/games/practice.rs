//! Practice: no fouls, and one player shoots until all object balls are down.

use super::game::{GameRules, PlayedShot};
use super::pool::{self, CUE};
use crate::layout::BallList;
use crate::region::Region;
use crate::request::{Calls, Choice, Request};
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

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
