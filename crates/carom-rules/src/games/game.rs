//! The interface of a game's rules, and the played shot on which they rule.

use carom::format::Node;
use carom::outcome::{Outcome, Touched};
use carom::table::PocketName;

use super::group::Group;
use super::snooker::On;
use crate::layout::{BallIndex, FrameLayout};
use crate::play::Call;
use crate::referee::{CueBallTravel, NearHit};
use crate::request::{Choice, Request, Turn};
use crate::seat::{self, Seat};
use crate::state::FrameState;

/// A shot that was played. All balls are indices of the frame.
pub(crate) struct PlayedShot<'a> {
    /// The shot that the frame asked for.
    pub(crate) turn: &'a Turn,
    pub(crate) call: Call,
    pub(crate) outcome: &'a Outcome,
    pub(crate) travel: &'a CueBallTravel,
    /// The balls before the shot, with a cue ball in hand where it was placed.
    pub(crate) before: &'a FrameLayout,
}

impl PlayedShot<'_> {
    /// The seat of the shooter.
    pub(crate) const fn seat(&self) -> Seat {
        self.turn.player
    }

    /// The seat of the other player.
    pub(crate) const fn opponent(&self) -> Seat {
        seat::opponent(self.turn.player)
    }

    /// The called ball, if it was pocketed in the called pocket.
    pub(crate) fn made(&self) -> Option<BallIndex> {
        let Call::Pocket(ball, pocket) = self.call else { return None };
        (self.pocket_of(ball) == Some(pocket)).then_some(ball)
    }

    /// The first ball that the cue ball touched.
    pub(crate) const fn first_contact(&self) -> Option<BallIndex> {
        self.outcome.first_contact
    }

    /// The pocket in which `ball` was pocketed.
    pub(crate) fn pocket_of(&self, ball: BallIndex) -> Option<PocketName> {
        self.outcome.pocketed.iter().find(|(b, _)| *b == ball).map(|(_, pocket)| *pocket)
    }

    /// Whether the cue ball was pocketed.
    pub(crate) fn is_scratch(&self) -> bool {
        self.pocket_of(self.turn.cue).is_some()
    }

    /// Whether the cue ball left the table other than by a pocket.
    pub(crate) fn is_cue_ball_off_table(&self) -> bool {
        self.outcome.off_table.contains(&self.turn.cue)
    }

    /// Whether the cue ball was pocketed or left the table.
    pub(crate) fn lost_cue_ball(&self) -> bool {
        self.is_scratch() || self.is_cue_ball_off_table()
    }

    /// The object balls that were pocketed, in order.
    pub(crate) fn potted(&self) -> impl Iterator<Item = BallIndex> + '_ {
        self.outcome.pocketed.iter().map(|(ball, _)| *ball).filter(|ball| *ball != self.turn.cue)
    }

    /// The object balls that left the table other than by a pocket, in order.
    pub(crate) fn thrown_off(&self) -> impl Iterator<Item = BallIndex> + '_ {
        self.outcome.off_table.iter().copied().filter(|ball| *ball != self.turn.cue)
    }

    /// Whether the tip touched the cue ball more than once, unless a frozen ball or a hit of a near
    /// ball that is less full than `least` held the cue ball up.
    pub(crate) fn is_double_hit(&self, least: NearHit) -> bool {
        let alone = self.outcome.met_during_strike.is_empty();
        self.outcome.tip_contacts > 1 && (alone || self.travel.near_hit >= least)
    }

    /// Whether the tip was still on the cue ball when it hit a ball that was not frozen to it, at
    /// least as full as `least`.
    pub(crate) fn is_push_shot(&self, least: NearHit) -> bool {
        self.outcome.pushed && self.travel.near_hit >= least
    }

    /// Number of object balls driven to a rail. Balls that were pocketed or left the table count as
    /// driven (WPA 8.4).
    pub(crate) fn balls_driven(&self) -> usize {
        let driven = &self.outcome.driven_to_rail;
        let gone = self.potted().chain(self.thrown_off());
        let rails = driven.iter().filter(|ball| **ball != self.turn.cue);
        rails.count() + gone.filter(|ball| !driven.contains(ball)).count()
    }

    /// Whether any ball was driven to a rail after the first contact. A ball that is only pressed
    /// into the rail to which it is frozen does not count.
    pub(crate) fn is_rail_driven_after_contact(&self) -> bool {
        let mut after = self.outcome.rails_after_first_contact.iter();
        after.any(|(ball, _)| self.outcome.driven_to_rail.contains(ball))
    }

    /// Whether the cue ball was driven to a rail after its first contact, or was lost.
    pub(crate) fn is_cue_ball_driven_after_contact(&self) -> bool {
        let is_rail = |touched: &&Touched| matches!(touched, Touched::Rail(_));
        let mut after = self.outcome.cue_ball_touched.iter().skip_while(is_rail);
        let contact = after.next().is_some();
        contact && (self.lost_cue_ball() || after.any(|touched| is_rail(&touched)))
    }
}

/// The rules of one game, with the state that only this game has.
pub(crate) trait GameRules {
    /// Starts the game: the first request to the breaker.
    fn start(&mut self, state: &mut FrameState, breaker: Seat) -> Request;

    /// Continues a game of which only the places of the balls are known: the request to `seat`, who
    /// shoots next.
    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request;

    /// Describes balls that have no place but must be on the table while the game continues; none if all are there.
    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String>;

    /// Rules on a shot: writes the ruling into `state` and returns the next request. The balls
    /// already are where they came to rest.
    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request;

    /// Applies a choice of `seat` and returns the next request.
    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request;

    /// Whether the next shot is the opening shot of a rack, which has rules of its own.
    fn is_opening(&self) -> bool;

    /// The group of `seat`; none while the table is open, and in games without groups.
    fn group(&self, _: Seat) -> Option<Group> {
        None
    }

    /// The kind of ball that is on in snooker.
    fn kind_on(&self) -> Option<On> {
        None
    }

    /// Points for `ball` in snooker: 1 for a red, 2 to 7 for a colour.
    fn value(&self, _: &FrameLayout, _: BallIndex) -> i32 {
        0
    }

    /// The state that only this game has, as sentences.
    fn describe(&self, _: &FrameLayout) -> Option<String> {
        None
    }

    /// The state that only this game has, for reports.
    fn to_node(&self, _: &FrameState) -> Node {
        Node::object([])
    }
}
