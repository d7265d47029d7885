//! Eight-ball (WPA, section 3).

use carom::format::Node;

use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::Layout;
use crate::play::Call;
use crate::pool::{self, BALLS_TO_RAIL};
use crate::request::{Calls, Choice, Region, Request};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

const EIGHT: BallIndex = 8;

/// Seven balls that one player has to pocket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// 1 to 7.
    Solids,
    /// 9 to 15.
    Stripes,
}

impl Group {
    /// The group of `ball`; none for the eight and the cue ball.
    pub const fn of(ball: BallIndex) -> Option<Self> {
        match ball {
            1..=7 => Some(Self::Solids),
            9..=15 => Some(Self::Stripes),
            _ => None,
        }
    }

    fn balls(self) -> impl Iterator<Item = BallIndex> {
        match self {
            Self::Solids => 1..=7,
            Self::Stripes => 9..=15,
        }
    }
}

/// A rack of eight-ball.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EightBall {
    /// Who has the solids; nobody while the table is open.
    solids_of: Option<Player>,
    /// Who broke, or will.
    breaker: Player,
    is_break: bool,
}

impl EightBall {
    /// The group of `player`; none while the table is open.
    pub fn group(&self, player: Player) -> Option<Group> {
        let solids = self.solids_of?;
        Some(if solids == player { Group::Solids } else { Group::Stripes })
    }

    /// The balls of which one must be hit first. On an open table any but the eight may be (WPA 3.4); the
    /// eight too, once a group is off the table, for it may be claimed (2025: 4.4), by calling the eight.
    fn balls_on(&self, layout: &Layout, player: Player) -> Vec<BallIndex> {
        let left = |group: Group| layout.left(group.balls());
        match self.group(player) {
            Some(group) if left(group).is_empty() => vec![EIGHT],
            Some(group) => left(group),
            None => {
                let claimed =
                    [Group::Solids, Group::Stripes].into_iter().any(|g| left(g).is_empty());
                layout.left((1..=15).filter(|ball| *ball != EIGHT || claimed))
            }
        }
    }

    fn next(&self, state: &State, player: Player, hand: Option<Region>) -> Request {
        pool::shot(state, player, hand, self.balls_on(&state.layout, player), Calls::REQUIRED)
    }

    /// Whether a ball of the other kind was hit first than the call on an open table asks for: who calls the
    /// eight claims the group that is gone, and hits the eight; who calls another ball does not.
    fn is_against_call(&self, shot: &Played<'_>) -> bool {
        let is_open = self.solids_of.is_none() && shot.turn.on.contains(&EIGHT);
        let first = shot.facts.first_contact();
        match shot.play.call {
            Call::Pocket(ball, _) if is_open => {
                first.is_some_and(|first| (first == EIGHT) != (ball == EIGHT))
            }
            _ => false,
        }
    }

    /// The eight is off the table (WPA 3.8): it wins if it was called, on, and pocketed by a legal shot.
    fn end(state: &State, shot: &Played<'_>) -> Request {
        let lost = |why| Request::won(shot.other(), why);
        if shot.facts.pocket_of(EIGHT).is_none() {
            lost("the eight was driven off the table")
        } else if !state.ruling.is_legal() {
            lost("the eight was pocketed with a foul")
        } else if !shot.turn.on.contains(&EIGHT) {
            lost("the eight was pocketed before the group was cleared")
        } else if shot.made() != Some(EIGHT) {
            lost("the eight was pocketed in an uncalled pocket")
        } else {
            Request::won(shot.player(), "the eight was pocketed")
        }
    }

    /// WPA 3.3.
    fn judge_break(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (facts, player, other) = (shot.facts, shot.player(), shot.other());
        let fouled = !state.ruling.is_legal();
        let eight = [Choice::SpotEight, Choice::Rebreak];
        if facts.pocket_of(EIGHT).is_some() {
            return if fouled {
                Request::choice(other, &eight, "the eight was pocketed with a foul")
            } else {
                Request::choice(player, &eight, "the eight was pocketed on the break")
            };
        }
        if state.layout.is_down(EIGHT) {
            pool::spot(state, EIGHT);
        }
        let potted = facts.potted().next().is_some();
        let soft = !potted && facts.balls_driven() < BALLS_TO_RAIL;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);
        if !fouled && !soft {
            return self.next(state, if potted { player } else { other }, None);
        }
        let nearest = pool::nearest_behind(state, &self.balls_on(&state.layout, other));
        let choices: Vec<Choice> = [
            (!facts.lost_cue_ball(), Choice::PlayOn),
            (fouled, Choice::PlayFromHand),
            (fouled && nearest.is_some(), Choice::SpotNearest),
            (soft, Choice::Rebreak),
            (soft, Choice::RebreakByOther),
        ]
        .into_iter()
        .filter_map(|(offered, choice)| offered.then_some(choice))
        .collect();
        let why = if soft { "too few balls were driven to a rail" } else { "a foul on the break" };
        Request::Choice { player: other, choices, why }
    }
}

impl Game for EightBall {
    fn open(&mut self, _: &mut State, breaker: Player) -> Request {
        *self = Self { solids_of: None, breaker, is_break: true };
        pool::break_shot(breaker, Vec::new(), Calls::NONE)
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        *self = Self::default();
        self.next(state, player, None)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        state.ruling.fouls = pool::standard_fouls(shot);
        let from_behind = pool::FromBehind::of(state, shot);
        state.ruling.fouls.add_if(from_behind.is_foul(), Foul::BehindHeadString);
        state.ruling.fouls.add_if(self.is_against_call(shot), Foul::WrongBallFirst);
        if core::mem::take(&mut self.is_break) {
            return self.judge_break(state, shot);
        }
        let (player, other) = (shot.player(), shot.other());
        if state.layout.is_down(EIGHT) {
            return Self::end(state, shot);
        }
        if !state.ruling.is_legal() {
            return self.next(state, other, Some(Region::Anywhere));
        }
        let group = shot.made().and_then(Group::of);
        if self.solids_of.is_none() {
            self.solids_of = group.map(|g| if g == Group::Solids { player } else { other });
        }
        let scored = group.is_some() && group == self.group(player);
        self.next(state, if scored { player } else { other }, None)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        let hand = Some(Region::BehindHeadString);
        match choice {
            Choice::Rebreak | Choice::RebreakByOther => {
                state.rack();
                let breaker = if choice == Choice::Rebreak { player } else { 1 - player };
                self.open(state, breaker)
            }
            Choice::SpotEight => {
                pool::spot(state, EIGHT);
                // Who did not break chooses after a foul (WPA 3.3f).
                self.next(state, player, hand.filter(|_| player != self.breaker))
            }
            Choice::SpotNearest => {
                let on = self.balls_on(&state.layout, player);
                if let Some(nearest) = pool::nearest_behind(state, &on) {
                    pool::spot(state, nearest);
                }
                self.next(state, player, hand)
            }
            Choice::PlayFromHand => self.next(state, player, hand),
            _ => self.next(state, player, None),
        }
    }

    fn to_node(&self, _: &State) -> Node {
        let group = |player| match self.group(player) {
            Some(Group::Solids) => Node::from("solids"),
            Some(Group::Stripes) => Node::from("stripes"),
            None => Node::Null,
        };
        Node::object([("groups", Node::List(vec![group(0), group(1)]))])
    }
}

#[cfg(test)]
mod tests {
    use super::Group;

    #[test]
    fn groups_are_seven_balls_each() {
        for group in [Group::Solids, Group::Stripes] {
            assert_eq!(group.balls().count(), 7);
            assert!(group.balls().all(|ball| Group::of(ball) == Some(group)));
        }
    }
}
