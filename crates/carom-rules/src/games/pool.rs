//! Parts of the rules that all pool games share: standard fouls, spotting and shots.

use carom::outcome::Touched;

use super::game::PlayedShot;
use crate::layout::{BallIndex, BallList};
use crate::markings::{head_string, spot_named};
use crate::referee::NearHit;
use crate::region::Region;
use crate::request::{Calls, Request, Turn};
use crate::ruling::{Foul, Fouls};
use crate::seat::Seat;
use crate::state::FrameState;

/// The cue ball in every pool game.
pub(crate) const CUE: BallIndex = 0;

/// Object balls that a break must drive to a rail if it pockets none (WPA 2.3, 3.3, 9.3).
pub(crate) const BALLS_TO_RAIL: usize = 4;

/// Consecutive fouls that make a serious foul: loss of the rack, or of points (WPA 6.14).
pub(crate) const SERIOUS: u32 = 3;

/// The WPA's number of the rule (Rules of Play, 15 March 2016).
/// `soft_break` is that of a soft break, which each game has.
pub(crate) const fn rule(foul: Foul, soft_break: &'static str) -> &'static str {
    match foul {
        Foul::Scratch | Foul::CueBallOffTable => "WPA 6.1",
        Foul::WrongBallFirst => "WPA 6.2",
        Foul::NoContact | Foul::NoRailAfterContact => "WPA 6.3",
        Foul::BallOffTable => "WPA 6.5",
        Foul::DoubleHit | Foul::PushShot => "WPA 6.7",
        Foul::BehindHeadString => "WPA 6.11",
        Foul::SoftBreak => soft_break,
        _ => "",
    }
}

/// The standard fouls of a shot (WPA 6.1 to 6.3, 6.5, 6.7). One of the turn's balls on must be hit
/// first; any ball may be, if the turn names none. Fouls of the player's body and hands are not
/// simulated.
pub(crate) fn standard_fouls(shot: &PlayedShot<'_>) -> Fouls {
    let mut fouls = push_out_fouls(shot);
    let first = shot.first_contact();
    fouls.add_if(first.is_none(), Foul::NoContact);
    if let Some(first) = first {
        let on = &shot.turn.on;
        fouls.add_if(!on.is_empty() && !on.contains(&first), Foul::WrongBallFirst);
        // A ball that was pocketed or left the table counts as driven to a rail (WPA 8.4).
        let gone = shot.outcome.pocketed.len() + shot.outcome.off_table.len() > 0;
        let driven = gone || shot.is_rail_driven_after_contact();
        fouls.add_if(!driven, Foul::NoRailAfterContact);
    }
    fouls
}

/// A shot from behind the head string (WPA 6.11).
pub(crate) struct HeadStringShot {
    /// The first ball hit was behind the string, and the cue ball had not crossed the string.
    hit_behind: bool,
    /// The cue ball neither crossed the string nor touched a ball in front of it.
    pub(crate) stayed: bool,
}

impl HeadStringShot {
    pub(crate) fn of(state: &FrameState, shot: &PlayedShot<'_>) -> Self {
        let line = head_string(state.base.table());
        let restricted = shot.turn.hand == Some(Region::BehindHeadString);
        let is_behind = |ball| shot.before.place(ball).is_some_and(|[_, y]| y < line);
        let mut balls = shot.outcome.cue_ball_touched.iter().filter_map(|touched| match touched {
            Touched::Ball(ball) => Some(*ball),
            Touched::Rail(_) => None,
        });
        let first_behind = shot.first_contact().is_some_and(is_behind);
        Self {
            hit_behind: restricted && first_behind && shot.travel.reached_before_contact < line,
            stayed: restricted && shot.travel.reached < line && balls.all(is_behind),
        }
    }

    pub(crate) const fn is_foul(&self) -> bool {
        self.hit_behind || self.stayed
    }
}

/// With the cue ball in hand behind the head string and all `legal` balls behind the string too,
/// the player may have the legal ball nearest to the string spotted (WPA 1.5). Returns that ball.
pub(crate) fn nearest_behind(state: &FrameState, legal: &[BallIndex]) -> Option<BallIndex> {
    let line = head_string(state.base.table());
    let height = |ball: BallIndex| state.layout.place(ball).map_or(0.0, |[_, y]| y);
    let all_behind = legal.iter().all(|ball| height(*ball) < line);
    let nearest = || legal.iter().copied().max_by(|a, b| height(*a).total_cmp(&height(*b)));
    if all_behind { nearest() } else { None }
}

/// The fouls that also apply to a push-out (WPA 2.4).
pub(crate) fn push_out_fouls(shot: &PlayedShot<'_>) -> Fouls {
    let mut fouls = Fouls::NONE;
    fouls.add_if(shot.is_scratch(), Foul::Scratch);
    fouls.add_if(shot.is_cue_ball_off_table(), Foul::CueBallOffTable);
    fouls.add_if(shot.thrown_off().next().is_some(), Foul::BallOffTable);
    fouls.add_if(shot.is_double_hit(NearHit::Full), Foul::DoubleHit);
    fouls.add_if(shot.is_push_shot(NearHit::Full), Foul::PushShot);
    fouls
}

/// Updates the shooter's consecutive fouls. Returns whether this shot was the third.
pub(crate) fn is_third_foul(state: &mut FrameState, seat: Seat) -> bool {
    let fouls = &mut state.fouls[seat];
    *fouls = if state.ruling.is_legal() { 0 } else { *fouls + 1 };
    *fouls == SERIOUS
}

/// Spots `ball` on the foot spot, or on the long string as near to it as possible (WPA 1.4).
pub(crate) fn spot(state: &mut FrameState, ball: BallIndex) {
    let FrameState { base, layout, ruling, .. } = state;
    let foot = spot_named(base.table(), "foot", 0.75);
    layout.spot(ball, foot, base.table(), |other| other == CUE);
    ruling.spotted.push(ball);
}

/// Describes the deciding ball, if it has no place.
pub(crate) fn missing(deciding: BallIndex, places: &[Option<[f64; 2]>]) -> Option<String> {
    places[usize::from(deciding)].is_none().then(|| format!("the {deciding} is down"))
}

/// The request for a shot. A cue ball that is off the table is in hand anywhere, if `hand` is none.
pub(crate) fn shot(
    state: &FrameState,
    player: Seat,
    hand: Option<Region>,
    on: BallList,
    calls: Calls,
) -> Request {
    let lost = state.layout.is_down(CUE).then_some(Region::Anywhere);
    Request::Shot(Turn { player, cue: CUE, hand: hand.or(lost), on, calls })
}

/// The request for a break shot, with the cue ball in hand behind the head string.
pub(crate) fn break_shot(player: Seat, on: BallList, calls: Calls) -> Request {
    let hand = Some(Region::BehindHeadString);
    Request::Shot(Turn { player, cue: CUE, hand, on, calls })
}
