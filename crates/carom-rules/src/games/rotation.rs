//! Nine-ball (WPA, section 2) and ten-ball (section 9): the lowest ball must be hit first.

use crate::frame::State;
use crate::games::Played;
use crate::play::Call;
use crate::pool::{self, BALLS_TO_RAIL, CUE};
use crate::request::{Calls, Choice, Region, Request};
use crate::ruling::{Foul, Ruling};
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

    pub(crate) fn open(&mut self, state: &State, breaker: Player) -> Request {
        self.is_break = true;
        pool::break_shot(breaker, self.lowest(state), Calls::default())
    }

    pub(crate) fn after_break(&mut self, state: &State, player: Player) -> Request {
        self.is_break = false;
        self.next(state, player, None, false)
    }

    /// The ball on: the lowest on the table.
    fn lowest(&self, state: &State) -> Vec<BallIndex> {
        state.layout.on_table().find(|ball| *ball != CUE).into_iter().collect()
    }

    fn next(&self, state: &State, player: Player, hand: Option<Region>, push_out: bool) -> Request {
        let calls = Calls {
            pocket: self.called,
            safety: self.called,
            required: self.called,
            push_out,
            nominate: false,
        };
        pool::shot(state, player, hand, self.lowest(state), calls)
    }

    pub(crate) fn judge(
        &mut self,
        state: &mut State,
        shot: &Played<'_>,
        ruling: &mut Ruling,
    ) -> Request {
        let (facts, player) = (shot.facts, shot.turn.player);
        let other = 1 - player;
        let pushes = shot.play.call == Call::PushOut;
        let was_break = core::mem::take(&mut self.is_break);
        ruling.fouls =
            if pushes { pool::lost_balls(facts) } else { pool::standard_fouls(state, shot) };
        let potted = facts.potted().next().is_some();
        let soft = was_break && !potted && pool::driven(facts) < BALLS_TO_RAIL;
        ruling.fouls.add_if(soft, Foul::SoftBreak);

        let legal = ruling.is_legal();
        let third = pool::is_third_foul(state, player, legal);
        let as_called = self.is_as_called(shot, was_break);
        if legal && !pushes && as_called && facts.pocket_of(self.last).is_some() {
            // On the break the ten does not win (WPA 9.3).
            if !(self.called && was_break) {
                return Request::Over { winner: Some(player), why: "the last ball was pocketed" };
            }
        }
        if state.layout.is_down(self.last) {
            pool::spot(state, self.last, ruling);
        }
        if third {
            return Request::Over { winner: Some(other), why: "three fouls in a row" };
        }
        if !legal {
            return self.next(state, other, Some(Region::Anywhere), false);
        }
        if pushes {
            let choices = vec![Choice::PlayOn, Choice::PassBack];
            return Request::Choice { player: other, choices, why: "after a push-out" };
        }
        if potted && !as_called {
            let choices = vec![Choice::PlayOn, Choice::PassBack];
            let why = "a ball was pocketed that was not called";
            return Request::Choice { player: other, choices, why };
        }
        let shooter = if potted && shot.play.call != Call::Safety { player } else { other };
        self.next(state, shooter, None, was_break)
    }

    /// Whether what fell was called, where it must be: a called ball in its pocket, whatever falls
    /// besides; after a called safety, nothing.
    fn is_as_called(&self, shot: &Played<'_>, was_break: bool) -> bool {
        if !self.called || was_break {
            return true;
        }
        match shot.play.call {
            Call::Pocket(ball, pocket) => shot.facts.pocket_of(ball) == Some(pocket),
            _ => false,
        }
    }

    pub(crate) fn choose(&mut self, state: &State, player: Player, choice: Choice) -> Request {
        let shooter = if choice == Choice::PassBack { 1 - player } else { player };
        self.next(state, shooter, None, false)
    }
}
