//! Nine-ball (WPA, section 2) and ten-ball (section 9): the lowest ball must be hit first.

use crate::frame::State;
use crate::games::{Game, Played};
use crate::play::Call;
use crate::pool::{self, BALLS_TO_RAIL, CUE};
use crate::request::{Calls, Choice, Region, Request};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

/// Nine-ball or ten-ball.
#[derive(Clone, Debug, PartialEq)]
pub struct Rotation {
    /// The ball that wins: the 9 or the 10.
    last: BallIndex,
    /// Whether shots are called (WPA 9.5).
    called: bool,
    /// Whether the next shot is the break.
    is_break: bool,
}

impl Rotation {
    pub(crate) const fn nine_ball() -> Self {
        Self { last: 9, called: false, is_break: true }
    }

    pub(crate) const fn ten_ball() -> Self {
        Self { last: 10, called: true, is_break: true }
    }

    /// The ball on: the lowest on the table.
    fn lowest(&self, state: &State) -> Vec<BallIndex> {
        state.layout.on_table().find(|ball| *ball != CUE).into_iter().collect()
    }

    fn next(&self, state: &State, player: Player, hand: Option<Region>, push_out: bool) -> Request {
        let calls = if self.called { Calls::REQUIRED } else { Calls::NONE };
        let calls = Calls { push_out, ..calls };
        pool::shot(state, player, hand, self.lowest(state), calls)
    }
}

impl Game for Rotation {
    fn open(&mut self, state: &mut State, breaker: Player) -> Request {
        self.is_break = true;
        pool::break_shot(breaker, self.lowest(state), Calls::NONE)
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        self.is_break = false;
        self.next(state, player, None, false)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (facts, player, other) = (shot.facts, shot.player(), shot.other());
        let pushes = shot.play.call == Call::PushOut;
        let was_break = core::mem::take(&mut self.is_break);
        state.ruling.fouls =
            if pushes { pool::lost_balls(facts) } else { pool::standard_fouls(shot) };
        let potted = facts.potted().next().is_some();
        let soft = was_break && !potted && facts.balls_driven() < BALLS_TO_RAIL;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);

        let legal = state.ruling.is_legal();
        let third = pool::is_third_foul(state, player);
        // A called ball in its pocket, whatever falls besides; after a called safety, nothing (WPA 9.7).
        let as_called = !self.called || was_break || shot.made().is_some();
        // The ten wins called, and as the last ball (WPA 9.8); the nine whenever it falls (2.5).
        let wins = !self.called || (shot.turn.on == [self.last] && shot.made() == Some(self.last));
        if wins && legal && !pushes && facts.pocket_of(self.last).is_some() {
            return Request::won(player, "the last ball was pocketed");
        }
        if state.layout.is_down(self.last) {
            pool::spot(state, self.last);
        }
        if third {
            return Request::won(other, "three fouls in a row");
        }
        if !legal {
            return self.next(state, other, Some(Region::Anywhere), false);
        }
        let either = [Choice::PlayOn, Choice::PassBack];
        if pushes {
            return Request::choice(other, &either, "after a push-out");
        }
        if potted && !as_called {
            return Request::choice(other, &either, "a ball was pocketed that was not called");
        }
        let shooter = if potted && shot.play.call != Call::Safety { player } else { other };
        self.next(state, shooter, None, was_break)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        let shooter = if choice == Choice::PassBack { 1 - player } else { player };
        self.next(state, shooter, None, false)
    }
}
