//! Chinese eight-ball, also called heyball: the groups of eight-ball without calls, on a table with the pockets of snooker.
//!
//! Sources: "World Chinese eight-ball masters, standard rules" of 2017, chapter 12 (forums.azbilliards.com, thread
//! 454320), whose numbers the fouls carry; "Rules of heyball", 2017, updated 2019 (ihpapool.com): no calls, cue ball in
//! hand behind the head string on and after the break; "Black eight billiards rules" of the Chinese Billiards
//! Association (szxjbilliards.com): after a foul on the break the opponent plays from behind the head string, and only at
//! balls in front of it. The text on the break was not found: what follows an eight on the break, or a break that
//! drives too few balls, is as in eight-ball (WPA 3.3), and an estimate. So is that the table stays open if only balls
//! of the other group than the one that was hit fall. The older rules of the Association (2008), by which three fouls in
//! a row lose the rack, are not implemented.

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::eight_ball::{EIGHT, EightBall, Group, Style};
use super::facts::{BREAK, GameFacts, Objective, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::pool::CUE;
use crate::layout::FrameLayout;
use crate::request::{Calls, Choice, Request};
use crate::ruling::Foul;
use crate::seat::Seat;
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

const STYLE: Style = Style { calls: Calls::NONE, may_play_on: false };

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::ChineseEightBall,
    players: 2,
    balls: 16,
    own_cue_balls: false,
    objective: Objective::Groups,
    deciding_ball: Some(EIGHT),
    scoring: Scoring::LastBall,
    opening: BREAK,
    stalemate: Stalemate::Rerack,
    random_start: Some(RandomStart {
        count: [1, 15],
        always: &[CUE, EIGHT],
        drawn: Some([1, 15]),
        racked: None,
    }),
    lag: true,
    miss: false,
    conceded: false,
    rule: |foul| match foul {
        Foul::WrongBallFirst => "heyball 12.1",
        Foul::NoRailAfterContact => "heyball 12.2",
        Foul::BallOffTable => "heyball 12.3",
        Foul::DoubleHit => "heyball 12.6",
        Foul::PushShot => "heyball 12.7",
        _ => "",
    },
    state: || GameState::ChineseEightBall(ChineseEightBall::default()),
};

/// A rack of Chinese eight-ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChineseEightBall {
    rack: EightBall,
}

state_bytes!(struct ChineseEightBall { rack });

impl GameRules for ChineseEightBall {
    fn is_opening(&self) -> bool {
        self.rack.is_opening()
    }

    fn start(&mut self, state: &mut FrameState, breaker: Seat) -> Request {
        self.rack.start(state, breaker)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.rack.resume_with(STYLE, state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        self.rack.missing(places)
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        self.rack.judge_with(STYLE, state, shot)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        self.rack.choose_with(STYLE, state, seat, choice)
    }

    fn group(&self, seat: Seat) -> Option<Group> {
        self.rack.group(seat)
    }

    fn describe(&self, layout: &FrameLayout) -> Option<String> {
        self.rack.describe(layout)
    }

    fn to_node(&self, state: &FrameState) -> Node {
        self.rack.to_node(state)
    }
}
