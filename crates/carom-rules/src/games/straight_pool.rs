//! 14.1 continuous pool (WPA, section 4).

use carom::Table;
use carom::math::sqrt;
use carom::rack::{Game, USUAL_GAP};

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use super::pool::{self, CUE};
use crate::layout::{BallIndex, BallList, FrameLayout};
use crate::markings::{distance, head_string, spot_named};
use crate::region::Region;
use crate::request::{Calls, Choice, Request};
use crate::ruling::Foul;
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// Points for a standard foul (WPA 4.9).
const STANDARD_FOUL: i32 = -1;

/// Points for a breaking foul (WPA 4.10).
const BREAKING_FOUL: i32 = -2;

/// Points for the third consecutive foul, in addition to those of the standard foul (WPA 4.11).
const SERIOUS_FOUL: i32 = -15;

/// Object balls that the opening break must drive to a rail, besides the cue ball (WPA 4.3).
const OPENING_BALLS: usize = 2;

/// Fewest object balls; with fewer, the others are racked again (WPA 4.4).
const LEAST_BALLS: usize = 2;

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::StraightPool,
    players: 2,
    balls: 16,
    own_cue_balls: false,
    objective: Objective::AnyBall,
    deciding_ball: None,
    scoring: Scoring::Target { usual: 100, negative: true, equal_innings: false },
    opening: Opening { kind: OpeningKind::Safety, speeds: [1.0, 8.0] },
    stalemate: Stalemate::Rerack,
    random_start: Some(RandomStart {
        count: [LEAST_BALLS, 15],
        always: &[CUE],
        drawn: Some([1, 15]),
        racked: None,
    }),
    lag: true,
    miss: false,
    conceded: false,
    rule: |foul| pool::rule(foul, "WPA 4.10"),
    state: || GameState::StraightPool(StraightPool::default()),
};

/// A game of straight pool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StraightPool {
    /// Whether the next shot is an opening break.
    is_opening: bool,
}

state_bytes!(struct StraightPool { is_opening });

impl StraightPool {
    fn next(state: &FrameState, seat: Seat, hand: Option<Region>) -> Request {
        pool::shot(state, seat, hand, BallList::new(), Calls::REQUIRED)
    }

    /// The request with the cue ball in hand behind the head string.
    fn from_hand(state: &FrameState, seat: Seat) -> Request {
        if pool::nearest_behind(state, &Self::left(state)).is_some() {
            let choices = [Choice::PlayFromHand, Choice::SpotNearest];
            return Request::choice(seat, &choices, "all balls are behind the head string");
        }
        Self::next(state, seat, Some(Region::BehindHeadString))
    }

    /// The object balls on the table.
    fn left(state: &FrameState) -> BallList {
        state.layout.left(1..state.layout.len() as BallIndex)
    }

    /// A breaking foul. It does not count towards three consecutive fouls (WPA 4.11).
    fn breaking_foul(state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        state.ruling.points[shot.seat()] = BREAKING_FOUL;
        let lost = state.layout.is_down(CUE);
        let accept = if lost { Choice::PlayFromHand } else { Choice::PlayOn };
        Request::choice(shot.opponent(), &[accept, Choice::RebreakByOther], "a breaking foul")
    }

    /// The third consecutive foul: all balls are racked again, and the offender breaks (WPA 4.11).
    fn third_foul(&mut self, state: &mut FrameState, seat: Seat) -> Request {
        state.ruling.points[seat] += SERIOUS_FOUL;
        state.fouls[seat] = 0;
        state.rack();
        self.start(state, seat)
    }

    /// Racks the other balls again when one object ball or none is left (WPA 4.4, 4.8). Returns the
    /// region of the cue ball if it is then in hand.
    fn rack_fourteen(state: &mut FrameState) -> Option<Region> {
        let left = Self::left(state);
        if left.len() > 1 {
            return None;
        }
        state.ruling.racked = true;
        let fresh = state.fresh_rack();
        let table = state.base.table().clone();
        let cue = state.layout.place(CUE);
        let last = left.first().and_then(|ball| Some((*ball, state.layout.place(*ball)?)));
        let plan = IntermediateRack::new(&table, &fresh, cue, last);
        // The apex place stays empty, unless the last ball was pocketed too.
        let mut places = racked_places(&fresh);
        if let Some((ball, place)) = plan.last_ball {
            places.remove(0);
            state.layout.put(ball, Some(place));
        }
        let down: Vec<BallIndex> =
            (1..fresh.len() as BallIndex).filter(|b| !left.contains(b)).collect();
        for (ball, place) in down.into_iter().zip(places) {
            state.layout.put(ball, Some(place));
        }
        if plan.cue_ball.is_some() || plan.hand.is_some() {
            state.layout.put(CUE, plan.cue_ball);
        }
        plan.hand
    }
}

impl GameRules for StraightPool {
    fn is_opening(&self) -> bool {
        self.is_opening
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        self.is_opening = true;
        pool::break_shot(breaker, BallList::new(), Calls::REQUIRED)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        *self = Self::default();
        Self::next(state, seat, None)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        let left = places[1..].iter().flatten().count();
        (left < LEAST_BALLS).then(|| format!("of the object balls only {left} are left"))
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let (seat, opponent) = (shot.seat(), shot.opponent());
        state.ruling.fouls = pool::standard_fouls(shot);
        let from_behind = pool::HeadStringShot::of(state, shot);
        state.ruling.fouls.add_if(from_behind.is_foul(), Foul::BehindHeadString);
        let made = shot.made().is_some();
        let was_opening = core::mem::take(&mut self.is_opening);
        let driven =
            shot.balls_driven() >= OPENING_BALLS && shot.is_cue_ball_driven_after_contact();
        let soft = was_opening && !made && !driven;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);
        let legal = state.ruling.is_legal();
        let scored = legal && made;
        if scored {
            state.ruling.points[seat] = shot.potted().count() as i32;
        }
        for ball in shot.potted().filter(|_| !scored).chain(shot.thrown_off()) {
            pool::spot(state, ball);
        }
        if soft {
            return Self::breaking_foul(state, shot);
        }
        if !legal {
            state.ruling.points[seat] = STANDARD_FOUL;
        }
        if pool::is_third_foul(state, seat) {
            return self.third_foul(state, seat);
        }
        if state.scores_after()[seat] >= state.options.points {
            return Request::won(seat, "the target was reached");
        }
        let hand = Self::rack_fourteen(state);
        // WPA 4.9.
        if shot.lost_cue_ball() || from_behind.stayed {
            return Self::from_hand(state, opponent);
        }
        Self::next(state, if scored { seat } else { opponent }, hand)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        match choice {
            Choice::RebreakByOther => {
                state.rack();
                self.start(state, seat::opponent(seat))
            }
            Choice::PlayFromHand | Choice::SpotNearest => {
                let nearest = pool::nearest_behind(state, &Self::left(state));
                if let Some(ball) = nearest.filter(|_| choice == Choice::SpotNearest) {
                    pool::spot(state, ball);
                }
                Self::next(state, seat, Some(Region::BehindHeadString))
            }
            _ => Self::next(state, seat, None),
        }
    }
}

/// The places of the object balls in a rack, from the apex to the back row.
fn racked_places(fresh: &FrameLayout) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> =
        (1..fresh.len() as BallIndex).filter_map(|ball| fresh.place(ball)).collect();
    places.sort_by(|a, b| a[1].total_cmp(&b[1]));
    places
}

/// The places of the fifteenth ball and the cue ball when fourteen balls are racked (WPA 4.8).
struct IntermediateRack {
    /// The ball left on the table and its place; none if it was pocketed too.
    last_ball: Option<(BallIndex, [f64; 2])>,
    /// The spot on which the cue ball is placed, if it is moved to a spot.
    cue_ball: Option<[f64; 2]>,
    /// The region of the cue ball, if it is in hand.
    hand: Option<Region>,
}

impl IntermediateRack {
    fn new(
        table: &Table,
        fresh: &FrameLayout,
        cue: Option<[f64; 2]>,
        last: Option<(BallIndex, [f64; 2])>,
    ) -> Self {
        let spots = [("head", 0.25), ("center", 0.5), ("foot", 0.75)];
        let [head, center, foot] = spots.map(|(name, at)| spot_named(table, name, at));
        let behind_string = Some(Region::BehindHeadString);
        let radius = fresh.radius(CUE);
        let rack = Triangle::around(fresh);
        // A ball is on a spot if a second ball on the spot would touch it.
        let is_on = |spot: [f64; 2], place: [f64; 2]| distance(spot, place) < 2.0 * radius;
        let cue_in_rack = cue.is_some_and(|place| rack.touches(place, radius));
        let cue_on_head = cue.is_some_and(|place| is_on(head, place));
        let stay = Self { last_ball: last, cue_ball: None, hand: None };
        let hand = behind_string.filter(|_| cue_in_rack);
        let Some((ball, place)) = last else { return Self { hand, ..stay } };
        if rack.touches(place, radius) {
            let to = match (cue_in_rack, cue_on_head) {
                (true, _) => foot,
                (false, true) => center,
                (false, false) => head,
            };
            return Self { last_ball: Some((ball, to)), hand, ..stay };
        }
        if !cue_in_rack {
            return stay;
        }
        if place[1] >= head_string(table) {
            Self { hand, ..stay }
        } else if is_on(head, place) {
            Self { cue_ball: Some(center), ..stay }
        } else {
            Self { cue_ball: Some(head), ..stay }
        }
    }
}

/// The triangle through the centres of a rack's outer balls, m.
struct Triangle {
    apex: [f64; 2],
    /// y of the back row.
    back: f64,
    /// Half the width of the back row.
    half_width: f64,
}

impl Triangle {
    fn around(fresh: &FrameLayout) -> Self {
        let places = racked_places(fresh);
        let apex = places.first().copied().unwrap_or_default();
        let back = places.last().map_or(apex[1], |p| p[1]);
        let half_width = places.iter().map(|p| (p[0] - apex[0]).abs()).fold(0.0, f64::max);
        Self { apex, back, half_width }
    }

    /// Whether a ball of `radius` (m) at `place` would touch a ball of the rack.
    fn touches(&self, place: [f64; 2], radius: f64) -> bool {
        // Its distance from the nearest of the three sides; positive outside.
        let (x, y) = ((place[0] - self.apex[0]).abs(), place[1] - self.apex[1]);
        let height = self.back - self.apex[1];
        let slope = self.half_width / height;
        let beside = (x - slope * y) / sqrt(1.0 + slope * slope);
        let outside = beside.max(-y).max(y - height);
        // Racked balls are off their ideal places by up to half the usual gap.
        outside < 2.0 * radius + USUAL_GAP
    }
}
