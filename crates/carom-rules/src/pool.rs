//! What the pool games share: standard fouls, spotting, a shot's turn.

use crate::facts::Facts;
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
            Rules::StraightPool => "WPA 4.3",
            _ => "WPA 2.3",
        },
        _ => "",
    }
}

/// The standard fouls (WPA 6.1 to 6.3, 6.5, 6.11) of a shot in which one of the turn's balls on must be
/// hit first; any, if it names none. What depends on the player's body and hands cannot happen here.
pub(crate) fn standard_fouls(state: &State, shot: &Played<'_>) -> Fouls {
    let (turn, facts) = (shot.turn, shot.facts);
    let mut fouls = lost_balls(facts);
    let first = facts.first_contact();
    fouls.add_if(first.is_none(), Foul::NoContact);
    if let Some(first) = first {
        let wrong = !turn.on.is_empty() && !turn.on.contains(&first);
        fouls.add_if(wrong, Foul::WrongBallFirst);
        let still = facts.potted().next().is_none() && !facts.rail_after_contact;
        fouls.add_if(still && facts.off_table.is_empty(), Foul::NoRailAfterContact);
        let line = head_string(state.base.table());
        let hidden = shot.before.place(first).is_some_and(|[_, y]| y < line);
        let from_behind = turn.hand == Some(Region::BehindHeadString);
        fouls.add_if(from_behind && hidden && facts.cue_reached < line, Foul::BehindHeadString);
    }
    fouls
}

/// The fouls that a push-out leaves in force (WPA 2.4).
pub(crate) fn lost_balls(facts: &Facts) -> Fouls {
    let mut fouls = Fouls::NONE;
    fouls.add_if(facts.is_scratch(), Foul::Scratch);
    fouls.add_if(facts.off_table.contains(&facts.cue), Foul::CueBallOffTable);
    fouls.add_if(facts.thrown_off().next().is_some(), Foul::BallOffTable);
    fouls
}

/// Object balls driven to a rail.
pub(crate) fn driven(facts: &Facts) -> usize {
    facts.driven.iter().filter(|ball| **ball != facts.cue).count()
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
    layout.spot(ball, foot, CUE, base.table());
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
