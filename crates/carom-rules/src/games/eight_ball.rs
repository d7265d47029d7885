//! Eight-ball (WPA, section 3).

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::facts::{BREAK, GameFacts, Objective, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
pub use super::group::Group;
use super::pool::{self, BALLS_TO_RAIL};
use crate::layout::{BallIndex, BallList, FrameLayout};
use crate::play::Call;
use crate::region::Region;
use crate::request::{Calls, Choice, Choices, Request};
use crate::ruling::Foul;
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// The ball that decides the rack.
pub const EIGHT: BallIndex = 8;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::EightBall,
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
        always: &[pool::CUE, EIGHT],
        drawn: Some([1, 15]),
        racked: None,
    }),
    lag: true,
    miss: false,
    conceded: false,
    rule: |foul| pool::rule(foul, "WPA 3.3"),
    state: || GameState::EightBall(EightBall::default()),
};

/// What differs between games with the groups of eight-ball.
#[derive(Clone, Copy)]
pub(super) struct Style {
    /// The calls of every shot but the break.
    pub(super) calls: Calls,
    /// Whether the opponent may play the balls as they lie after a foul on the break.
    pub(super) may_play_on: bool,
}

const STYLE: Style = Style { calls: Calls::REQUIRED, may_play_on: true };

/// A rack of eight-ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EightBall {
    /// The seat with the solids; none while the table is open.
    solids_of: Option<Seat>,
    /// The seat that breaks or broke this rack.
    breaker: Seat,
    /// Whether the next shot is the break.
    is_break: bool,
}

state_bytes!(struct EightBall { solids_of, breaker, is_break });

impl EightBall {
    /// The balls on. On an open table these are all balls but the eight (WPA 3.4). Once one group
    /// is off the table, the player may claim it by calling the eight (2025: 4.4), so the eight is
    /// on too.
    fn balls_on(&self, layout: &FrameLayout, seat: Seat) -> BallList {
        let left = |group: Group| layout.left(group.balls());
        match self.group(seat) {
            Some(group) if left(group).is_empty() => BallList::from(&[EIGHT][..]),
            Some(group) => left(group),
            None => {
                let claimed =
                    [Group::Solids, Group::Stripes].into_iter().any(|g| left(g).is_empty());
                layout.left((1..=15).filter(|ball| *ball != EIGHT || claimed))
            }
        }
    }

    fn next(&self, style: Style, state: &FrameState, seat: Seat, hand: Option<Region>) -> Request {
        pool::shot(state, seat, hand, self.balls_on(&state.layout, seat), style.calls)
    }

    /// The group of which the shooter has pocketed a ball. Without calls this is the group of the first ball hit.
    fn scored(style: Style, shot: &PlayedShot<'_>) -> Option<Group> {
        if style.calls.required {
            return shot.made().and_then(Group::of);
        }
        let hit = shot.first_contact().and_then(Group::of);
        hit.filter(|group| shot.potted().any(|ball| Group::of(ball) == Some(*group)))
    }

    /// On an open table with one group gone: whether the first ball hit contradicts the call. A
    /// player who calls the eight claims the group that is gone and must hit the eight first; a
    /// player who calls another ball must not.
    fn is_against_call(&self, shot: &PlayedShot<'_>) -> bool {
        let is_open = self.solids_of.is_none() && shot.turn.on.contains(&EIGHT);
        let first = shot.first_contact();
        match shot.call {
            Call::Pocket(ball, _) if is_open => {
                first.is_some_and(|first| (first == EIGHT) != (ball == EIGHT))
            }
            _ => false,
        }
    }

    /// The end of the rack, once the eight is off the table (WPA 3.8). The shooter wins if the
    /// eight was on, called where calls are required, and pocketed by a legal shot.
    fn end(style: Style, state: &FrameState, shot: &PlayedShot<'_>) -> Request {
        let lost = |why| Request::won(shot.opponent(), why);
        if shot.pocket_of(EIGHT).is_none() {
            lost("the eight was driven off the table")
        } else if !state.ruling.is_legal() {
            lost("the eight was pocketed with a foul")
        } else if !shot.turn.on.contains(&EIGHT) {
            lost("the eight was pocketed before the group was cleared")
        } else if style.calls.required && shot.made() != Some(EIGHT) {
            lost("the eight was pocketed in an uncalled pocket")
        } else {
            Request::won(shot.seat(), "the eight was pocketed")
        }
    }

    /// Rules on the break (WPA 3.3).
    fn judge_break(
        &mut self,
        style: Style,
        state: &mut FrameState,
        shot: &PlayedShot<'_>,
    ) -> Request {
        let (seat, opponent) = (shot.seat(), shot.opponent());
        let fouled = !state.ruling.is_legal();
        let eight = [Choice::SpotEight, Choice::Rebreak];
        if shot.pocket_of(EIGHT).is_some() {
            return if fouled {
                Request::choice(opponent, &eight, "the eight was pocketed with a foul")
            } else {
                Request::choice(seat, &eight, "the eight was pocketed on the break")
            };
        }
        if state.layout.is_down(EIGHT) {
            pool::spot(state, EIGHT);
        }
        let potted = shot.potted().next().is_some();
        let soft = !potted && shot.balls_driven() < BALLS_TO_RAIL;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);
        if !fouled && !soft {
            return self.next(style, state, if potted { seat } else { opponent }, None);
        }
        let nearest = pool::nearest_behind(state, &self.balls_on(&state.layout, opponent));
        let choices: Choices = [
            (!shot.lost_cue_ball() && (style.may_play_on || !fouled), Choice::PlayOn),
            (fouled, Choice::PlayFromHand),
            (fouled && nearest.is_some(), Choice::SpotNearest),
            (soft, Choice::Rebreak),
            (soft, Choice::RebreakByOther),
        ]
        .into_iter()
        .filter_map(|(offered, choice)| offered.then_some(choice))
        .collect();
        // After a scratch there is nothing to choose: the cue ball is in hand behind the head
        // string.
        if let [only] = choices[..] {
            return self.choose_with(style, state, opponent, only);
        }
        let why = if soft { "too few balls were driven to a rail" } else { "a foul on the break" };
        Request::choice(opponent, &choices, why)
    }

    /// Continues from given places, as [`GameRules::resume`].
    pub(super) fn resume_with(&mut self, style: Style, state: &FrameState, seat: Seat) -> Request {
        *self = Self::default();
        self.next(style, state, seat, None)
    }

    /// Rules on a shot, as [`GameRules::judge`].
    pub(super) fn judge_with(
        &mut self,
        style: Style,
        state: &mut FrameState,
        shot: &PlayedShot<'_>,
    ) -> Request {
        state.ruling.fouls = pool::standard_fouls(shot);
        let from_behind = pool::HeadStringShot::of(state, shot);
        state.ruling.fouls.add_if(from_behind.is_foul(), Foul::BehindHeadString);
        state.ruling.fouls.add_if(self.is_against_call(shot), Foul::WrongBallFirst);
        if core::mem::take(&mut self.is_break) {
            return self.judge_break(style, state, shot);
        }
        let (seat, opponent) = (shot.seat(), shot.opponent());
        if state.layout.is_down(EIGHT) {
            return Self::end(style, state, shot);
        }
        if !state.ruling.is_legal() {
            return self.next(style, state, opponent, Some(Region::Anywhere));
        }
        let group = Self::scored(style, shot);
        if self.solids_of.is_none() {
            self.solids_of = group.map(|g| if g == Group::Solids { seat } else { opponent });
        }
        let scored = group.is_some() && group == self.group(seat);
        self.next(style, state, if scored { seat } else { opponent }, None)
    }

    /// Applies a choice, as [`GameRules::choose`].
    pub(super) fn choose_with(
        &mut self,
        style: Style,
        state: &mut FrameState,
        seat: Seat,
        choice: Choice,
    ) -> Request {
        let hand = Some(Region::BehindHeadString);
        match choice {
            Choice::Rebreak | Choice::RebreakByOther => {
                state.rack();
                let breaker = if choice == Choice::Rebreak { seat } else { seat::opponent(seat) };
                self.start(state, breaker)
            }
            Choice::SpotEight => {
                pool::spot(state, EIGHT);
                // The player who did not break chooses after a foul only (WPA 3.3f).
                self.next(style, state, seat, hand.filter(|_| seat != self.breaker))
            }
            Choice::SpotNearest => {
                let on = self.balls_on(&state.layout, seat);
                if let Some(nearest) = pool::nearest_behind(state, &on) {
                    pool::spot(state, nearest);
                }
                self.next(style, state, seat, hand)
            }
            Choice::PlayFromHand => self.next(style, state, seat, hand),
            _ => self.next(style, state, seat, None),
        }
    }
}

impl GameRules for EightBall {
    fn is_opening(&self) -> bool {
        self.is_break
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        *self = Self { solids_of: None, breaker, is_break: true };
        pool::break_shot(breaker, BallList::new(), Calls::NONE)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        self.resume_with(STYLE, state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        pool::missing(EIGHT, places)
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        self.judge_with(STYLE, state, shot)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        self.choose_with(STYLE, state, seat, choice)
    }

    fn group(&self, seat: Seat) -> Option<Group> {
        let solids = self.solids_of.filter(|_| seat <= 1)?;
        Some(if solids == seat { Group::Solids } else { Group::Stripes })
    }

    fn describe(&self, _: &FrameLayout) -> Option<String> {
        let line = match self.group(0) {
            None => "The table is open.",
            Some(Group::Solids) => "Player 0 has 1 to 7, player 1 has 9 to 15.",
            Some(Group::Stripes) => "Player 0 has 9 to 15, player 1 has 1 to 7.",
        };
        Some(line.into())
    }

    fn to_node(&self, _: &FrameState) -> Node {
        let group = |seat| match self.group(seat) {
            Some(Group::Solids) => Node::from("solids"),
            Some(Group::Stripes) => Node::from("stripes"),
            None => Node::Null,
        };
        Node::object([("groups", Node::List(vec![group(0), group(1)]))])
    }
}
