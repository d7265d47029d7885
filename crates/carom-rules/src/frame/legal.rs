//! The answers that a frame allows.

use carom::Table;
use carom::sample::Sequence;

use super::{Frame, Prepared};
use crate::play::Call;
use crate::request::{Request, Turn};

/// Points that are tried for every wanted place. On a table with all balls of snooker nine of ten
/// points are free, and a quarter of the box around the D is outside of it.
const TRIES: u64 = 50;

impl Frame {
    /// The calls that the frame allows for its shot, one of which a player makes; none if it does not ask
    /// for a shot.
    pub fn legal_calls(&self) -> Vec<Call> {
        let Request::Shot(turn) = self.request() else { return Vec::new() };
        let balls = || self.layout().on_table().filter(|ball| *ball != turn.cue);
        let pockets = || self.table().pockets.iter().map(|pocket| pocket.name);
        let mut calls = vec![Call::Nothing, Call::Safety, Call::PushOut];
        calls.extend(balls().map(Call::On));
        calls.extend(
            balls().flat_map(|ball| pockets().map(move |pocket| Call::Pocket(ball, pocket))),
        );
        calls.retain(|call| self.check_call(turn, *call).is_ok());
        calls
    }

    /// At most `count` places of a cue ball in hand that the frame allows (file coordinates, m), spread evenly
    /// over its region; `seed` moves them all. None if the cue ball is not in hand.
    pub fn legal_places(&self, count: usize, seed: u64) -> Vec<[f64; 2]> {
        let Request::Shot(Turn { hand: Some(region), .. }) = self.request() else {
            return Vec::new();
        };
        let [low, high] = region.bounds(self.table());
        let at = |index: u64| {
            let mut point = [0.0; 2];
            Sequence::Even.point(seed, index, &mut point);
            core::array::from_fn(|axis| low[axis] + point[axis] * (high[axis] - low[axis]))
        };
        let tries = TRIES * count as u64;
        let free = |place: &[f64; 2]| Prepared::new(self, Some(*place)).is_ok();
        (0..tries).map(at).filter(free).take(count).collect()
    }

    /// The table.
    fn table(&self) -> &Table {
        self.base().table()
    }
}

#[cfg(test)]
mod tests {
    use crate::{Call, Frame, Game, Options};

    #[test]
    fn a_break_of_straight_pool_may_be_a_safety_or_a_called_pot() {
        let frame =
            Frame::new(Game::StraightPool, Options::default(), None, None, 3).expect("a frame");
        let calls = frame.legal_calls();
        assert_eq!(calls[0], Call::Safety);
        assert_eq!(calls.len(), 1 + 15 * 6);
    }
}
