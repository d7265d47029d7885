//! What the pool games share: standard fouls, spotting, a shot's turn.

use crate::facts::{Facts, Touch};
use crate::frame::State;
use crate::games::{Played, Rules};
use crate::layout::{head_string, spot_named};
use crate::request::{Calls, Region, Request, Turn};
use crate::ruling::{Foul, Fouls};
use crate::{BallIndex, Player};

/// The cue ball in every pool game.
pub(crate) const CUE: BallIndex = 0;

/// Object balls that a break must drive to a rail if it pockets none (WPA 2.3, 3.3, 9.3).
pub(crate) const BALLS_TO_RAIL: usize = 4;

/// Fouls in a row that lose a rack, or points (WPA 6.14).
pub(crate) const SERIOUS: u32 = 3;

/// The WPA's number of the rule (Rules of Play, 15 March 2016).
pub(crate) const fn rule(rules: Rules, foul: Foul) -> &'static str {
    match foul {
        Foul::Scratch | Foul::CueBallOffTable => "WPA 6.1",
        Foul::WrongBallFirst => "WPA 6.2",
        Foul::NoContact | Foul::NoRailAfterContact => "WPA 6.3",
        Foul::BallOffTable => "WPA 6.5",
        Foul::BehindHeadString => "WPA 6.11",
        Foul::SoftBreak => match rules {
            Rules::EightBall => "WPA 3.3",
            Rules::TenBall => "WPA 9.3",
            Rules::StraightPool => "WPA 4.10",
            _ => "WPA 2.3",
        },
        _ => "",
    }
}

/// The standard fouls (WPA 6.1 to 6.3, 6.5) of a shot in which one of the turn's balls on must be hit
/// first; any, if it names none. What depends on the player's body and hands cannot happen here.
pub(crate) fn standard_fouls(shot: &Played<'_>) -> Fouls {
    let (turn, facts) = (shot.turn, shot.facts);
    let mut fouls = lost_balls(facts);
    let first = facts.first_contact();
    fouls.add_if(first.is_none(), Foul::NoContact);
    if let Some(first) = first {
        let wrong = !turn.on.is_empty() && !turn.on.contains(&first);
        fouls.add_if(wrong, Foul::WrongBallFirst);
        // What leaves the bed of the table was driven to a rail (WPA 8.4).
        let driven = facts.rail_after_contact || facts.pocketed.len() + facts.off_table.len() > 0;
        fouls.add_if(!driven, Foul::NoRailAfterContact);
    }
    fouls
}

/// Play from behind the head string (WPA 6.11).
pub(crate) struct FromBehind {
    /// The first ball hit was behind the string, and the cue ball had not crossed it.
    pub(crate) hit_behind: bool,
    /// The cue ball neither crossed the string nor touched a ball that was not behind it.
    pub(crate) stayed: bool,
}

impl FromBehind {
    pub(crate) fn of(state: &State, shot: &Played<'_>) -> Self {
        let (facts, line) = (shot.facts, head_string(state.base.table()));
        let restricted = shot.turn.hand == Some(Region::BehindHeadString);
        let is_behind = |ball| shot.before.place(ball).is_some_and(|[_, y]| y < line);
        let mut balls = facts.touched.iter().filter_map(|touch| match touch {
            Touch::Ball(ball) => Some(*ball),
            Touch::Rail(_) => None,
        });
        let first_behind = facts.first_contact().is_some_and(is_behind);
        Self {
            hit_behind: restricted && first_behind && facts.cue_reached < line,
            stayed: restricted && facts.cue_farthest < line && balls.all(is_behind),
        }
    }

    pub(crate) const fn is_foul(&self) -> bool {
        self.hit_behind || self.stayed
    }
}

/// With the cue ball in hand behind the head string and all `legal` balls behind it as well, the one nearest
/// to the string may be spotted (WPA 1.5): which that is.
pub(crate) fn nearest_behind(state: &State, legal: &[BallIndex]) -> Option<BallIndex> {
    let line = head_string(state.base.table());
    let height = |ball: BallIndex| state.layout.place(ball).map_or(0.0, |[_, y]| y);
    let all_behind = legal.iter().all(|ball| height(*ball) < line);
    let nearest = || legal.iter().copied().max_by(|a, b| height(*a).total_cmp(&height(*b)));
    if all_behind { nearest() } else { None }
}

/// The fouls that a push-out leaves in force (WPA 2.4).
pub(crate) fn lost_balls(facts: &Facts) -> Fouls {
    let mut fouls = Fouls::NONE;
    fouls.add_if(facts.is_scratch(), Foul::Scratch);
    fouls.add_if(facts.off_table.contains(&facts.cue), Foul::CueBallOffTable);
    fouls.add_if(facts.thrown_off().next().is_some(), Foul::BallOffTable);
    fouls
}

/// Counts the shooter's fouls in a row; whether this was the third.
pub(crate) fn is_third_foul(state: &mut State, player: Player) -> bool {
    let fouls = &mut state.fouls[player];
    *fouls = if state.ruling.is_legal() { 0 } else { *fouls + 1 };
    *fouls == SERIOUS
}

/// Puts `ball` on the foot spot, or behind it (WPA 1.4).
pub(crate) fn spot(state: &mut State, ball: BallIndex) {
    let State { base, layout, ruling, .. } = state;
    let foot = spot_named(base.table(), "foot", 0.75);
    layout.spot(ball, foot, base.table(), |other| other == CUE);
    ruling.spotted.push(ball);
}

/// A shot of `player`; a cue ball that is not on the table is in hand anywhere.
pub(crate) fn shot(
    state: &State,
    player: Player,
    hand: Option<Region>,
    on: Vec<BallIndex>,
    calls: Calls,
) -> Request {
    let lost = state.layout.is_down(CUE).then_some(Region::Anywhere);
    Request::Shot(Turn { player, cue: CUE, hand: hand.or(lost), on, calls })
}

/// The breaker's shot: the cue ball in hand behind the head string.
pub(crate) fn break_shot(player: Player, on: Vec<BallIndex>, calls: Calls) -> Request {
    let hand = Some(Region::BehindHeadString);
    Request::Shot(Turn { player, cue: CUE, hand, on, calls })
}
