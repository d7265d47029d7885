//! Eight-ball (WPA, section 3).

use carom::shot::Node;

use crate::frame::State;
use crate::games::{Game, Played};
use crate::pool::{self, BALLS_TO_RAIL, CUE};
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
    is_break: bool,
}

impl EightBall {
    /// The group of `player`; none while the table is open.
    pub fn group(&self, player: Player) -> Option<Group> {
        let solids = self.solids_of?;
        Some(if solids == player { Group::Solids } else { Group::Stripes })
    }

    fn next(&self, state: &State, player: Player, hand: Option<Region>) -> Request {
        // On an open table any ball may be hit first (WPA 6.2 in 3.9).
        let on = self.group(player).map_or(Vec::new(), |group| {
            let mine = state.layout.left(group.balls());
            if mine.is_empty() { vec![EIGHT] } else { mine }
        });
        pool::shot(state, player, hand, on, Calls::REQUIRED)
    }

    /// The eight is off the table (WPA 3.8): it wins if it was called, on, and pocketed by a legal shot.
    fn end(state: &State, shot: &Played<'_>) -> Request {
        let lost = |why| Request::won(shot.other(), why);
        if shot.facts.pocket_of(EIGHT).is_none() {
            lost("the eight was driven off the table")
        } else if !state.ruling.is_legal() {
            lost("the eight was pocketed with a foul")
        } else if shot.turn.on != [EIGHT] {
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
        let eight_fell = facts.pocket_of(EIGHT).is_some();
        if state.layout.is_down(EIGHT) && !eight_fell {
            pool::spot(state, EIGHT);
        }
        let (spot, again) = (Choice::SpotEight, Choice::Rebreak);
        if !state.ruling.is_legal() {
            // No rail at all is part of a break too soft, which is the lesser matter.
            let why = "a foul on the break";
            let from_hand = Choice::PlayFromHand;
            if eight_fell {
                return Request::choice(
                    other,
                    &[spot, again],
                    "the eight was pocketed with a foul",
                );
            }
            if facts.lost_cue_ball() {
                return Request::choice(other, &[from_hand], why);
            }
            return Request::choice(other, &[Choice::PlayOn, from_hand], why);
        }
        if eight_fell {
            return Request::choice(player, &[spot, again], "the eight was pocketed on the break");
        }
        if facts.potted().next().is_some() {
            return self.next(state, player, None);
        }
        if pool::driven(facts) < BALLS_TO_RAIL {
            state.ruling.fouls.add_if(true, Foul::SoftBreak);
            let choices = [Choice::PlayOn, again, Choice::RebreakByOther];
            return Request::choice(other, &choices, "too few balls were driven to a rail");
        }
        self.next(state, other, None)
    }
}

impl Game for EightBall {
    fn open(&mut self, _: &mut State, breaker: Player) -> Request {
        *self = Self { solids_of: None, is_break: true };
        pool::break_shot(breaker, Vec::new(), Calls::NONE)
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        *self = Self::default();
        self.next(state, player, None)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        state.ruling.fouls = pool::standard_fouls(state, shot);
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
                let lost = state.layout.is_down(CUE);
                self.next(state, player, hand.filter(|_| lost))
            }
            Choice::PlayFromHand => self.next(state, player, hand),
            _ => self.next(state, player, None),
        }
    }

    fn to_node(&self) -> Node {
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
