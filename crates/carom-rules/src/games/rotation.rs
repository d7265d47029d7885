//! Nine-ball (WPA, section 2) and ten-ball (section 9): the lowest ball must be hit first.

use carom::rack::Game;

use super::GameState;
use super::facts::{BREAK, GameFacts, Objective, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::pool::{self, BALLS_TO_RAIL, CUE};
use crate::layout::{BallIndex, BallList};
use crate::play::Call;
use crate::region::Region;
use crate::request::{Calls, Choice, Request};
use crate::ruling::Foul;
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

pub(crate) const NINE_BALL: GameFacts = GameFacts {
    game: Game::NineBall,
    players: 2,
    balls: 10,
    own_cue_balls: false,
    objective: Objective::LowestFirst,
    deciding_ball: Some(9),
    scoring: Scoring::LastBall,
    opening: BREAK,
    stalemate: Stalemate::Rerack,
    random_start: Some(RandomStart {
        count: [1, 9],
        always: &[CUE, 9],
        drawn: Some([1, 9]),
        racked: None,
    }),
    lag: true,
    miss: false,
    conceded: false,
    rule: |foul| pool::rule(foul, "WPA 2.3"),
    state: || GameState::Rotation(Rotation { last: 9, called: false, is_break: true }),
};

pub(crate) const TEN_BALL: GameFacts = GameFacts {
    game: Game::TenBall,
    balls: 11,
    deciding_ball: Some(10),
    random_start: Some(RandomStart {
        count: [1, 10],
        always: &[CUE, 10],
        drawn: Some([1, 10]),
        racked: None,
    }),
    rule: |foul| pool::rule(foul, "WPA 9.3"),
    state: || GameState::Rotation(Rotation { last: 10, called: true, is_break: true }),
    ..NINE_BALL
};

/// Nine-ball or ten-ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// The ball that wins the rack: the 9 or the 10.
    last: BallIndex,
    /// Whether shots are called (WPA 9.5).
    called: bool,
    /// Whether the next shot is the break.
    is_break: bool,
}

state_bytes!(struct Rotation { last, called, is_break });

impl Rotation {
    /// The ball on: the lowest on the table.
    fn lowest(&self, state: &FrameState) -> BallList {
        state.layout.on_table().find(|ball| *ball != CUE).into_iter().collect()
    }

    fn next(
        &self,
        state: &FrameState,
        seat: Seat,
        hand: Option<Region>,
        push_out: bool,
    ) -> Request {
        let calls = if self.called { Calls::REQUIRED } else { Calls::NONE };
        let calls = Calls { push_out, ..calls };
        pool::shot(state, seat, hand, self.lowest(state), calls)
    }
}

impl GameRules for Rotation {
    fn is_opening(&self) -> bool {
        self.is_break
    }

    fn start(&mut self, state: &mut FrameState, breaker: Seat) -> Request {
        self.is_break = true;
        pool::break_shot(breaker, self.lowest(state), Calls::NONE)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.is_break = false;
        self.next(state, seat, None, false)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        pool::missing(self.last, places)
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let (seat, opponent) = (shot.seat(), shot.opponent());
        let is_push_out = shot.call == Call::PushOut;
        let was_break = core::mem::take(&mut self.is_break);
        state.ruling.fouls =
            if is_push_out { pool::push_out_fouls(shot) } else { pool::standard_fouls(shot) };
        let potted = shot.potted().next().is_some();
        let soft = was_break && !potted && shot.balls_driven() < BALLS_TO_RAIL;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);

        let legal = state.ruling.is_legal();
        let third = pool::is_third_foul(state, seat);
        // Other balls may be pocketed besides the called one. After a called safety no pot counts
        // (WPA 9.7).
        let as_called = !self.called || was_break || shot.made().is_some();
        // The ten wins only if it is called and is the last ball (WPA 9.8); the nine wins whenever
        // it is pocketed legally (2.5).
        let wins = !self.called || (shot.turn.on == [self.last] && shot.made() == Some(self.last));
        if wins && legal && !is_push_out && shot.pocket_of(self.last).is_some() {
            return Request::won(seat, "the last ball was pocketed");
        }
        if state.layout.is_down(self.last) {
            pool::spot(state, self.last);
        }
        if third {
            return Request::won(opponent, "three fouls in a row");
        }
        if !legal {
            return self.next(state, opponent, Some(Region::Anywhere), false);
        }
        let either = [Choice::PlayOn, Choice::PassBack];
        if is_push_out {
            return Request::choice(opponent, &either, "after a push-out");
        }
        if potted && !as_called {
            return Request::choice(opponent, &either, "a ball was pocketed that was not called");
        }
        let shooter = if potted && shot.call != Call::Safety { seat } else { opponent };
        self.next(state, shooter, None, was_break)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        let shooter = if choice == Choice::PassBack { seat::opponent(seat) } else { seat };
        self.next(state, shooter, None, false)
    }
}
