//! Six-red snooker: snooker (WPBSA, section 3) with six reds and three exceptions.
//!
//! The exceptions are those of the world championship as the International Billiards and Snooker Federation uses them:
//! Wikipedia, "Six-red snooker", and billardblog.info, 16 February 2021. (1) At most five fouls and misses are called
//! in a row. (2) After the fifth the balls are not replaced; the other player may place the cue ball anywhere instead,
//! unless penalty points are needed to win. (3) No player may snooker the next one behind a nominated colour. That the
//! other player who places the cue ball has no free ball is an estimate. South Africa's rules (sasnooker.co.za), which
//! have no miss at all, are not implemented.

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::facts::{GameFacts, Objective, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::snooker::{CUE, KeptClear, OPENING, On, Snooker, rule};
use crate::layout::{BallIndex, FrameLayout};
use crate::region::Region;
use crate::request::{Choice, Request};
use crate::ruling::Foul;
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// Fouls and misses in a row of which the last one is not replayed.
const MOST_MISSES: u32 = 5;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::SixRed,
    players: 2,
    balls: 13,
    own_cue_balls: false,
    objective: Objective::RedsAndColors,
    deciding_ball: None,
    scoring: Scoring::Points { maximum: 75 },
    opening: OPENING,
    stalemate: Stalemate::Restart,
    random_start: Some(RandomStart {
        count: [0, 6],
        always: &[CUE],
        drawn: Some([1, 6]),
        racked: Some([7, 12]),
    }),
    lag: false,
    miss: true,
    conceded: true,
    rule: |foul| match foul {
        Foul::SnookeredByFreeBall => "six-red 3",
        _ => rule(foul),
    },
    state: || GameState::SixRed(SixRed::default()),
};

/// A frame of six-red snooker.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SixRed {
    snooker: Snooker,
    /// Fouls and misses in a row that were called on the same player, who played again after each.
    misses: u32,
}

state_bytes!(struct SixRed { snooker, misses });

impl SixRed {
    /// The frame as one of snooker.
    pub const fn snooker(&self) -> &Snooker {
        &self.snooker
    }

    /// Fouls and misses in a row that were called on the same player.
    pub const fn misses(&self) -> u32 {
        self.misses
    }
}

impl GameRules for SixRed {
    fn is_opening(&self) -> bool {
        self.snooker.is_opening()
    }

    fn start(&mut self, state: &mut FrameState, breaker: Seat) -> Request {
        self.misses = 0;
        self.snooker.start(state, breaker)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.misses = 0;
        self.snooker.resume(state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        self.snooker.missing(places)
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let request = self.snooker.judge_with(state, shot, KeptClear::AnyNominated);
        let Request::Choice { player, choices, why } = request else {
            self.misses = 0;
            return request;
        };
        if !choices.contains(&Choice::Replace) {
            self.misses = 0;
            return request;
        }
        self.misses += 1;
        if self.misses < MOST_MISSES {
            return request;
        }
        let instead = self.snooker.is_open(state).then_some(Choice::PlayFromAnywhere);
        let kept = choices.iter().copied().filter(|choice| *choice != Choice::Replace);
        Request::Choice { player, choices: kept.chain(instead).collect(), why }
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        if choice != Choice::Replace {
            self.misses = 0;
        }
        match choice {
            Choice::PlayFromAnywhere => self.snooker.play_from(state, seat, Region::Anywhere),
            _ => self.snooker.choose(state, seat, choice),
        }
    }

    fn kind_on(&self) -> Option<On> {
        self.snooker.kind_on()
    }

    fn value(&self, layout: &FrameLayout, ball: BallIndex) -> i32 {
        self.snooker.value(layout, ball)
    }

    fn describe(&self, layout: &FrameLayout) -> Option<String> {
        let line = self.snooker.describe(layout)?;
        Some(match self.misses {
            0 => line,
            misses => format!("{line} Fouls and misses in a row: {misses}; {MOST_MISSES} at most."),
        })
    }

    fn to_node(&self, state: &FrameState) -> Node {
        let Node::Object(mut entries) = self.snooker.to_node(state) else { return Node::Null };
        entries.push(("misses".into(), self.misses.into()));
        Node::Object(entries)
    }
}
