//! Straight rail, the free game of carom (UMB, World rules of carom billiard): a point for every shot that touches
//! both object balls.
//!
//! The corners are zones, as in the championship game: while both object balls are in the same zone, the second point
//! counts only if it drives one of them out. This is judged by where the balls come to rest, so a ball that leaves the
//! zone and comes back counts as inside, although a referee would count it as out. Sources: the UMB's articles 21 to 29
//! and 41, which three-cushion has too; bilardomatematigi.com, on Caudron's free game: the line of a zone goes from the
//! first sight of the short rail to the second of the long rail, and two points are allowed. That all balls return to
//! the starting position after one has left the table, or where the cue ball is frozen, is from memory, not verified.

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::innings::{self, Innings, RED};
use crate::carom_way::CaromCount;
use crate::layout::{BallIndex, FrameLayout};
use crate::request::{Choice, Request};
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// Points that may be scored while both object balls stay in a corner, without the last, which must drive one out.
const INSIDE: u32 = 1;

/// A corner's zone reaches this far along a rail, as a share of the rail: one sight of four, or two of eight.
const ZONE: f64 = 0.25;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::StraightRail,
    players: 2,
    balls: 3,
    own_cue_balls: true,
    objective: Objective::Caroms { cushions: 0 },
    deciding_ball: None,
    // 200 or 300 in matches of professionals.
    scoring: Scoring::Target { usual: 200, negative: false, equal_innings: true },
    opening: Opening { kind: OpeningKind::Carom, speeds: [1.0, 5.0] },
    stalemate: Stalemate::End,
    random_start: Some(RandomStart {
        count: [2, 2],
        always: &[0, 1, RED],
        drawn: None,
        racked: None,
    }),
    lag: true,
    miss: false,
    conceded: false,
    rule: innings::rule,
    state: || GameState::StraightRail(StraightRail::default()),
};

/// A match of straight rail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StraightRail {
    innings: Innings,
    /// Points since both object balls came into the same corner.
    inside: u32,
}

state_bytes!(struct StraightRail { innings, inside });

/// The corner in whose zone both object balls of `seat` are: whether it is on the right and at the top.
fn corner(state: &FrameState, layout: &FrameLayout, seat: Seat) -> Option<[bool; 2]> {
    let size = state.base.table().size;
    let corner_of = |ball: BallIndex| {
        let [x, y] = layout.place(ball)?;
        let [right, top] = [x > 0.5 * size.x, y > 0.5 * size.y];
        let across = if right { size.x - x } else { x } / size.x;
        let along = if top { size.y - y } else { y } / size.y;
        (across + along < ZONE).then_some([right, top])
    };
    let other = 1 - seat as BallIndex;
    corner_of(other).filter(|corner| corner_of(RED) == Some(*corner))
}

impl GameRules for StraightRail {
    fn is_opening(&self) -> bool {
        self.innings.is_opening
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        *self = Self::default();
        self.innings.start(breaker, RED)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        *self = Self { innings: Innings::resumed(seat), inside: 0 };
        innings::next(state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        places.contains(&None).then(|| "a ball is not on the table".to_owned())
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let (seat, opponent) = (shot.seat(), shot.opponent());
        let was_opening = core::mem::take(&mut self.innings.is_opening);
        state.ruling.fouls = innings::fouls(shot, was_opening, RED);
        let before = corner(state, shot.before, seat);
        let stayed = before.is_some() && corner(state, &state.layout, seat) == before;
        let inside = if stayed { self.inside + 1 } else { 0 };
        let count = innings::counted(state, shot, 0);
        let touched = state.ruling.is_legal() && count.is_carom();
        let scored = touched && inside <= INSIDE;
        state.ruling.carom = Some(CaromCount { stayed: touched && !scored, ..count });
        self.inside = if scored { inside } else { 0 };
        state.ruling.points[seat] = scored.into();
        let scores = state.scores_after();
        if scored && scores[seat] < state.options.points {
            return innings::next(state, seat);
        }
        if let Some(request) = self.innings.end(state, seat, scores) {
            return request;
        }
        if !shot.outcome.off_table.is_empty() {
            innings::starting_position(state, opponent);
            return self.innings.begin_again(opponent, RED);
        }
        innings::next(state, opponent)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        if choice == Choice::SpotFrozen {
            innings::starting_position(state, seat);
            return self.innings.begin_again(seat, RED);
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
