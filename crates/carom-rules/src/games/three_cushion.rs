//! Three-cushion carom (UMB, World rules of carom billiard).

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::innings::{self, Innings, RED};
use crate::layout::{BallIndex, FROZEN, FrameLayout};
use crate::markings::spot_named;
use crate::request::{Choice, Request};
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// Cushions that the cue ball must touch before it touches the second object ball (article 83).
const CUSHIONS: usize = 3;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::ThreeCushion,
    players: 2,
    balls: 3,
    own_cue_balls: true,
    objective: Objective::Caroms { cushions: CUSHIONS },
    deciding_ball: None,
    scoring: Scoring::Target { usual: 40, negative: false, equal_innings: true },
    opening: Opening { kind: OpeningKind::Carom, speeds: [1.6, 7.0] },
    stalemate: Stalemate::End,
    random_start: Some(RandomStart {
        count: [2, 2],
        always: &[0, 1, RED],
        drawn: None,
        racked: None,
    }),
    lag: false,
    miss: false,
    conceded: false,
    rule: innings::rule,
    state: || GameState::ThreeCushion(ThreeCushion::default()),
};

/// A match of three-cushion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThreeCushion {
    innings: Innings,
}

state_bytes!(struct ThreeCushion { innings });

impl ThreeCushion {
    /// Spots `balls` for `seat`, who shoots next: the red on the foot spot, the own cue ball on the
    /// head spot, the other cue ball on the centre spot. If a ball occupies that spot, the spotted
    /// ball goes to the spot of the ball in the way (article 27).
    fn spot(state: &mut FrameState, balls: &[BallIndex], seat: Seat) {
        let table = state.base.table();
        let own = |ball: BallIndex| match ball {
            RED => spot_named(table, "foot", 0.75),
            _ if usize::from(ball) == seat => spot_named(table, "head", 0.25),
            _ => spot_named(table, "center", 0.5),
        };
        let FrameState { layout, ruling, .. } = state;
        for &ball in balls {
            layout.put(ball, None);
        }
        for &ball in balls {
            let mut place = own(ball);
            // There are three balls, so at most two are in the way.
            for _ in 0..2 {
                place = layout.in_the_way(ball, place).map_or(place, own);
            }
            layout.put(ball, Some(place));
            ruling.spotted.push(ball);
        }
    }
}

impl GameRules for ThreeCushion {
    fn is_opening(&self) -> bool {
        self.innings.is_opening
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        *self = Self::default();
        self.innings.start(breaker, RED)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.innings = Innings::resumed(seat);
        innings::next(state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        places.contains(&None).then(|| "a ball is not on the table".to_owned())
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let seat = shot.seat();
        let was_opening = core::mem::take(&mut self.innings.is_opening);
        state.ruling.fouls = innings::fouls(shot, was_opening, RED);
        Self::spot(state, &shot.outcome.off_table, shot.opponent());
        let count = innings::counted(state, shot, CUSHIONS);
        state.ruling.carom = Some(count);
        let scored = state.ruling.is_legal() && count.is_carom();
        state.ruling.points[seat] = scored.into();
        let scores = state.scores_after();
        if scored && scores[seat] < state.options.points {
            return innings::next(state, seat);
        }
        let end = self.innings.end(state, seat, scores);
        end.unwrap_or_else(|| innings::next(state, seat::opponent(seat)))
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        if choice == Choice::SpotFrozen {
            let cue = seat as BallIndex;
            let mut balls = state.layout.touching(cue, FROZEN);
            balls.push(cue);
            Self::spot(state, &balls, seat);
        }
        innings::turn(seat, Default::default())
    }

    fn describe(&self, _: &FrameLayout) -> Option<String> {
        Some(self.innings.describe())
    }

    fn to_node(&self, _: &FrameState) -> Node {
        Node::object([("innings", Node::list(self.innings.begun.map(i64::from)))])
    }
}
