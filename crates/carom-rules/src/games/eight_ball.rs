//! Eight-ball (WPA, section 3).

use crate::frame::State;
use crate::games::{Played, Rules};
use crate::play::Call;
use crate::pool::{self, BALLS_TO_RAIL, CUE};
use crate::request::{Calls, Choice, Region, Request};
use crate::ruling::{Foul, Ruling};
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

    pub(crate) fn open(&mut self, breaker: Player) -> Request {
        *self = Self { solids_of: None, is_break: true };
        pool::break_shot(breaker, Vec::new(), Calls::default())
    }

    pub(crate) fn after_break(&mut self, state: &State, player: Player) -> Request {
        *self = Self::default();
        self.next(state, player, None)
    }

    fn next(&self, state: &State, player: Player, hand: Option<Region>) -> Request {
        // On an open table any ball may be hit first (WPA 6.2 in 3.9).
        let on = self.group(player).map_or(Vec::new(), |group| {
            let mine = state.layout.left(group.balls());
            if mine.is_empty() { vec![EIGHT] } else { mine }
        });
        let calls = Calls { pocket: true, safety: true, required: true, ..Calls::default() };
        pool::shot(state, player, hand, on, calls)
    }

    pub(crate) fn judge(
        &mut self,
        state: &mut State,
        shot: &Played<'_>,
        ruling: &mut Ruling,
    ) -> Request {
        ruling.fouls = pool::standard_fouls(state, shot);
        if core::mem::take(&mut self.is_break) {
            return self.judge_break(state, shot, ruling);
        }
        let (facts, player) = (shot.facts, shot.turn.player);
        let other = 1 - player;
        let legal = ruling.is_legal();
        let made = match shot.play.call {
            Call::Pocket(ball, pocket) => (facts.pocket_of(ball) == Some(pocket)).then_some(ball),
            _ => None,
        };
        if state.layout.is_down(EIGHT) {
            return self.end(shot, legal, made);
        }
        if !legal {
            return self.next(state, other, Some(Region::Anywhere));
        }
        let group = made.and_then(Group::of);
        if self.solids_of.is_none() {
            self.solids_of = group.map(|g| if g == Group::Solids { player } else { other });
        }
        let scored = group.is_some() && group == self.group(player);
        self.next(state, if scored { player } else { other }, None)
    }

    /// The eight is off the table (WPA 3.8): it wins if it was called, on, and pocketed by a legal shot.
    fn end(&self, shot: &Played<'_>, legal: bool, made: Option<BallIndex>) -> Request {
        let player = shot.turn.player;
        let on = shot.turn.on == [EIGHT];
        let lost = |why| Request::Over { winner: Some(1 - player), why };
        if shot.facts.pocket_of(EIGHT).is_none() {
            lost("the eight was driven off the table")
        } else if !legal {
            lost("the eight was pocketed with a foul")
        } else if !on {
            lost("the eight was pocketed before the group was cleared")
        } else if made != Some(EIGHT) {
            lost("the eight was pocketed in an uncalled pocket")
        } else {
            Request::Over { winner: Some(player), why: "the eight was pocketed" }
        }
    }

    /// WPA 3.3.
    fn judge_break(
        &mut self,
        state: &mut State,
        shot: &Played<'_>,
        ruling: &mut Ruling,
    ) -> Request {
        let (facts, player) = (shot.facts, shot.turn.player);
        let other = 1 - player;
        let eight_fell = facts.pocket_of(EIGHT).is_some();
        if state.layout.is_down(EIGHT) && !eight_fell {
            pool::spot(state, EIGHT, ruling);
        }
        let choice = |player, choices: &[Choice], why| Request::Choice {
            player,
            choices: choices.to_vec(),
            why,
        };
        let (spot, again) = (Choice::SpotEight, Choice::Rebreak);
        if !ruling.is_legal() {
            // No rail at all is part of a break too soft, which is the lesser matter.
            let why = "a foul on the break";
            let from_hand = Choice::PlayFromHand;
            if eight_fell {
                return choice(other, &[spot, again], "the eight was pocketed with a foul");
            }
            if facts.lost_cue_ball() {
                return choice(other, &[from_hand], why);
            }
            return choice(other, &[Choice::PlayOn, from_hand], why);
        }
        if eight_fell {
            return choice(player, &[spot, again], "the eight was pocketed on the break");
        }
        if facts.potted().next().is_some() {
            return self.next(state, player, None);
        }
        if pool::driven(facts) < BALLS_TO_RAIL {
            ruling.fouls.add_if(true, Foul::SoftBreak);
            let choices = [Choice::PlayOn, again, Choice::RebreakByOther];
            return choice(other, &choices, "too few balls were driven to a rail");
        }
        self.next(state, other, None)
    }

    pub(crate) fn choose(
        &mut self,
        state: &mut State,
        player: Player,
        choice: Choice,
        ruling: &mut Ruling,
    ) -> Request {
        let hand = Some(Region::BehindHeadString);
        match choice {
            Choice::Rebreak | Choice::RebreakByOther => {
                state.rack(Rules::EightBall);
                ruling.racked = true;
                self.open(if choice == Choice::Rebreak { player } else { 1 - player })
            }
            Choice::SpotEight => {
                pool::spot(state, EIGHT, ruling);
                let lost = state.layout.is_down(CUE);
                self.next(state, player, hand.filter(|_| lost))
            }
            Choice::PlayFromHand => self.next(state, player, hand),
            _ => self.next(state, player, None),
        }
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
