//! 14.1 continuous pool (WPA, section 4).

use carom::Table;
use carom::math::sqrt;
use carom::rack::USUAL_GAP;

use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::{Layout, distance, head_string, spot_named};
use crate::pool::{self, CUE};
use crate::request::{Calls, Choice, Region, Request};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

/// Points for a foul (WPA 4.9), a breaking foul (4.10), and besides for the third foul in a row (4.11).
const STANDARD_FOUL: i32 = -1;
const BREAKING_FOUL: i32 = -2;
const SERIOUS_FOUL: i32 = -15;

/// Object balls that must be driven to a rail in an opening break, and the cue ball (WPA 4.3).
const OPENING_BALLS: usize = 2;

/// A game of straight pool.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StraightPool {
    is_opening: bool,
}

impl StraightPool {
    fn next(state: &State, player: Player, hand: Option<Region>) -> Request {
        pool::shot(state, player, hand, Vec::new(), Calls::REQUIRED)
    }

    /// The cue ball is in hand behind the head string.
    fn from_hand(state: &State, player: Player) -> Request {
        if pool::nearest_behind(state, &Self::left(state)).is_some() {
            let choices = [Choice::PlayFromHand, Choice::SpotNearest];
            return Request::choice(player, &choices, "all balls are behind the head string");
        }
        Self::next(state, player, Some(Region::BehindHeadString))
    }

    fn left(state: &State) -> Vec<BallIndex> {
        state.layout.left(1..state.layout.len() as BallIndex)
    }

    /// It does not count towards three fouls in a row (WPA 4.11).
    fn breaking_foul(state: &mut State, shot: &Played<'_>) -> Request {
        state.ruling.points[shot.player()] = BREAKING_FOUL;
        let lost = state.layout.is_down(CUE);
        let accept = if lost { Choice::PlayFromHand } else { Choice::PlayOn };
        Request::choice(shot.other(), &[accept, Choice::RebreakByOther], "a breaking foul")
    }

    /// All balls are racked, and the offender breaks (WPA 4.11).
    fn third_foul(&mut self, state: &mut State, player: Player) -> Request {
        state.ruling.points[player] += SERIOUS_FOUL;
        state.fouls[player] = 0;
        state.rack();
        self.open(state, player)
    }

    /// With one object ball left, or none, the others are racked again (WPA 4.4, 4.8). Returns where the
    /// cue ball is in hand then, if it is.
    fn rack_fourteen(state: &mut State) -> Option<Region> {
        let left = Self::left(state);
        if left.len() > 1 {
            return None;
        }
        state.ruling.racked = true;
        let fresh = state.fresh_rack();
        let table = state.base.table().clone();
        let cue = state.layout.place(CUE);
        let last = left.first().and_then(|ball| Some((*ball, state.layout.place(*ball)?)));
        let plan = Intermediate::new(&table, &fresh, cue, last);
        // The apex is left out, unless the last ball has fallen too.
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

impl Game for StraightPool {
    fn open(&mut self, _: &mut State, breaker: Player) -> Request {
        self.is_opening = true;
        pool::break_shot(breaker, Vec::new(), Calls::REQUIRED)
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        *self = Self::default();
        Self::next(state, player, None)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (facts, player, other) = (shot.facts, shot.player(), shot.other());
        state.ruling.fouls = pool::standard_fouls(shot);
        let from_behind = pool::FromBehind::of(state, shot);
        state.ruling.fouls.add_if(from_behind.is_foul(), Foul::BehindHeadString);
        let made = shot.made().is_some();
        let was_opening = core::mem::take(&mut self.is_opening);
        let driven =
            facts.balls_driven() >= OPENING_BALLS && facts.is_cue_ball_driven_after_contact();
        let soft = was_opening && !made && !driven;
        state.ruling.fouls.add_if(soft, Foul::SoftBreak);
        let legal = state.ruling.is_legal();
        let scored = legal && made;
        if scored {
            state.ruling.points[player] = facts.potted().count() as i32;
        }
        for ball in facts.potted().filter(|_| !scored).chain(facts.thrown_off()) {
            pool::spot(state, ball);
        }
        if soft {
            return Self::breaking_foul(state, shot);
        }
        if !legal {
            state.ruling.points[player] = STANDARD_FOUL;
        }
        if pool::is_third_foul(state, player) {
            return self.third_foul(state, player);
        }
        if state.scores_after()[player] >= state.options.target {
            return Request::won(player, "the target was reached");
        }
        let hand = Self::rack_fourteen(state);
        // WPA 4.9.
        if facts.lost_cue_ball() || from_behind.stayed {
            return Self::from_hand(state, other);
        }
        Self::next(state, if scored { player } else { other }, hand)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        match choice {
            Choice::RebreakByOther => {
                state.rack();
                self.open(state, 1 - player)
            }
            Choice::PlayFromHand | Choice::SpotNearest => {
                let nearest = pool::nearest_behind(state, &Self::left(state));
                if let Some(ball) = nearest.filter(|_| choice == Choice::SpotNearest) {
                    pool::spot(state, ball);
                }
                Self::next(state, player, Some(Region::BehindHeadString))
            }
            _ => Self::next(state, player, None),
        }
    }
}

/// Where the object balls of a rack stand, from the apex to the back row.
fn racked_places(fresh: &Layout) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> =
        (1..fresh.len() as BallIndex).filter_map(|ball| fresh.place(ball)).collect();
    places.sort_by(|a, b| a[1].total_cmp(&b[1]));
    places
}

/// Where the fifteenth ball and the cue ball go when fourteen are racked (WPA 4.8).
struct Intermediate {
    /// The ball that is left on the table, and where it is put; none if it has fallen, too.
    last_ball: Option<(BallIndex, [f64; 2])>,
    /// Where the cue ball is put, if it is moved to a spot.
    cue_ball: Option<[f64; 2]>,
    /// Where the cue ball is in hand, if it is.
    hand: Option<Region>,
}

impl Intermediate {
    fn new(
        table: &Table,
        fresh: &Layout,
        cue: Option<[f64; 2]>,
        last: Option<(BallIndex, [f64; 2])>,
    ) -> Self {
        let spots = [("head", 0.25), ("center", 0.5), ("foot", 0.75)];
        let [head, center, foot] = spots.map(|(name, at)| spot_named(table, name, at));
        let kitchen = Some(Region::BehindHeadString);
        let radius = fresh.pieces()[0].ball.radius;
        let rack = Triangle::around(fresh);
        // A ball that another one placed on the spot would touch is on it.
        let is_on = |spot: [f64; 2], place: [f64; 2]| distance(spot, place) < 2.0 * radius;
        let cue_in_rack = cue.is_some_and(|place| rack.touches(place, radius));
        let cue_on_head = cue.is_some_and(|place| is_on(head, place));
        let stay = Self { last_ball: last, cue_ball: None, hand: None };
        let hand = kitchen.filter(|_| cue_in_rack);
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

/// The triangle of the centres of a rack's balls.
struct Triangle {
    apex: [f64; 2],
    back: f64,
    half_width: f64,
}

impl Triangle {
    fn around(fresh: &Layout) -> Self {
        let places = racked_places(fresh);
        let apex = places.first().copied().unwrap_or_default();
        let back = places.last().map_or(apex[1], |p| p[1]);
        let half_width = places.iter().map(|p| (p[0] - apex[0]).abs()).fold(0.0, f64::max);
        Self { apex, back, half_width }
    }

    /// Whether a ball of `radius` at `place` is in the way of the balls in the triangle.
    fn touches(&self, place: [f64; 2], radius: f64) -> bool {
        // Its distance from the nearest of the three sides, counted outwards.
        let (x, y) = ((place[0] - self.apex[0]).abs(), place[1] - self.apex[1]);
        let height = self.back - self.apex[1];
        let slope = self.half_width / height;
        let beside = (x - slope * y) / sqrt(1.0 + slope * slope);
        let outside = beside.max(-y).max(y - height);
        // The balls stand within half a gap of their places.
        outside < 2.0 * radius + USUAL_GAP
    }
}
