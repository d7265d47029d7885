//! Korean four-ball (sagu): a point for every shot that touches both reds and not the opponent's ball; the last point by
//! three cushions.
//!
//! There is no rule book: the Korean federation has rules for three-cushion only. Sources: Wikipedia, "Four-ball
//! billiards" (points, the penalty of a point, the shot that wins, and that the cue ball starts beside a red and the red
//! at the other end is played first); mk2info.com on four-ball and a post of a Korean club (cafe.daum.net/_c21_) on
//! fouls: the opponent's ball, no red, a touching ball that is moved, a double hit, a ball off the table. The place of
//! the opponent's ball at the start, the last point in place of one more, and the usual number of points (a handicap of
//! 150) are estimates.

use carom::format::Node;
use carom::outcome::Touched;
use carom::rack::Game;

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::innings::{self, Innings};
use crate::layout::{BallIndex, BallList, FrameLayout};
use crate::request::{Choice, Request};
use crate::ruling::Foul;
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// The reds; the second is at the far end in the starting position.
const REDS: [BallIndex; 2] = [2, 3];

/// Points for a foul.
const PENALTY: i32 = -1;

/// Cushions that the cue ball must touch before the second red in the shot for the last point.
const LAST_CUSHIONS: usize = 3;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::FourBall,
    players: 2,
    balls: 4,
    own_cue_balls: true,
    objective: Objective::Caroms { cushions: 0 },
    deciding_ball: None,
    scoring: Scoring::Target { usual: 15, negative: true, equal_innings: false },
    opening: Opening { kind: OpeningKind::Carom, speeds: [1.0, 6.0] },
    stalemate: Stalemate::End,
    random_start: Some(RandomStart {
        count: [3, 3],
        always: &[0, 1, REDS[0], REDS[1]],
        drawn: None,
        racked: None,
    }),
    lag: false,
    miss: false,
    conceded: false,
    rule: |_| "",
    state: || GameState::FourBall(FourBall::default()),
};

/// A match of four-ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FourBall {
    innings: Innings,
}

state_bytes!(struct FourBall { innings });

impl FourBall {
    /// Puts balls that left the table back where they were racked, or as near as possible.
    fn spot(state: &mut FrameState, balls: &[BallIndex]) {
        // A fresh rack allocates.
        if balls.is_empty() {
            return;
        }
        let fresh = state.fresh_rack();
        let FrameState { base, layout, ruling, .. } = state;
        for &ball in balls {
            layout.put(ball, None);
        }
        for &ball in balls {
            let Some(place) = fresh.place(ball) else { continue };
            layout.spot(ball, place, base.table(), |_| true);
            ruling.spotted.push(ball);
        }
    }
}

impl GameRules for FourBall {
    fn is_opening(&self) -> bool {
        self.innings.is_opening
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        *self = Self::default();
        self.innings.start(breaker, REDS[1])
    }

    fn resume(&mut self, _: &FrameState, seat: Seat) -> Request {
        self.innings = Innings::resumed(seat);
        innings::turn(seat, BallList::from(&REDS[..]))
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        places.contains(&None).then(|| "a ball is not on the table".to_owned())
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let (seat, opponent) = (shot.seat(), shot.opponent());
        let was_opening = core::mem::take(&mut self.innings.is_opening);
        let touched = |ball| shot.outcome.cue_ball_touched.contains(&Touched::Ball(ball));
        let hits = REDS.into_iter().filter(|red| touched(*red)).count();
        let mut fouls = innings::fouls(shot, was_opening, REDS[1]);
        fouls.add_if(touched(opponent as BallIndex), Foul::OpponentsBall);
        fouls.add_if(hits == 0, Foul::NoContact);
        state.ruling.fouls = fouls;
        Self::spot(state, &shot.outcome.off_table);
        let is_last = state.scores[seat] + 1 == state.options.points;
        let cushions = if is_last { LAST_CUSHIONS } else { 0 };
        let count = innings::counted(state, shot, cushions);
        state.ruling.carom = Some(count);
        let scored = fouls.is_empty() && hits == REDS.len() && count.is_carom();
        state.ruling.points[seat] = if fouls.is_empty() { scored.into() } else { PENALTY };
        if state.scores_after()[seat] >= state.options.points {
            return Request::won(seat, "the target was reached");
        }
        let next = if scored { seat } else { opponent };
        self.innings.begun[next] += u32::from(!scored);
        innings::turn(next, BallList::from(&REDS[..]))
    }

    /// Four-ball offers no choices.
    fn choose(&mut self, _: &mut FrameState, seat: Seat, _: Choice) -> Request {
        innings::turn(seat, BallList::from(&REDS[..]))
    }

    fn describe(&self, _: &FrameLayout) -> Option<String> {
        Some(self.innings.describe())
    }

    fn to_node(&self, _: &FrameState) -> Node {
        Node::object([("innings", Node::list(self.innings.begun.map(i64::from)))])
    }
}
