//! The balls of a frame and their places.

use std::sync::Arc;

use carom::math::{Vec3, sqrt};
use carom::rack::{self, Game};
use carom::shot::PlacedBall;
use carom::{Ball, BallState, Error, Shot, Table};

use crate::markings::distance;
use crate::short_list::ShortList;

/// A ball, by its position in the list of the frame's balls ([`FrameLayout::balls`]). In games with
/// numbered balls the cue ball is 0 and every other ball has its number.
pub type BallIndex = u16;

/// Largest gap at which a ball counts as touching (frozen to) another ball or a cushion, m: 0.1 mm,
/// a sheet of paper, since a referee judges by eye whether light passes between them. The engine's
/// outcome uses the same distance for balls frozen to a rail that leave it. Balls never come to
/// rest within rounding of each other, so with a much smaller value the rules for frozen balls
/// would never apply; with a much larger one they would apply to balls that are visibly apart.
pub(crate) const FROZEN: f64 = 1e-4;

/// Gap between a spotted ball and a ball that it must not touch, m: 0.1 mm, a sheet of paper.
const SPOTTING_GAP: f64 = 1e-4;

/// Rounding error of a distance, m.
const ROUNDING: f64 = 1e-12;

/// A ball of the frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameBall {
    /// The ball's id in shots.
    pub id: String,
    /// Mass and radius.
    pub ball: Ball,
}

/// The most balls of a frame: the cue ball, fifteen reds and six colours of snooker. Lists of balls
/// and of places have this capacity.
pub const MOST_BALLS: usize = 22;

/// Balls of a frame, in order.
pub type BallList = ShortList<BallIndex, MOST_BALLS>;

/// Centre of each ball (file coordinates, m); none if it is not on the table.
pub(crate) type BallPlaces = [Option<[f64; 2]>; MOST_BALLS];

/// The balls of a frame and their places.
#[derive(Debug, PartialEq)]
pub struct FrameLayout {
    balls: Arc<[FrameBall]>,
    /// The first ones belong to `balls`, and the others are not used.
    places: BallPlaces,
}

impl Clone for FrameLayout {
    fn clone(&self) -> Self {
        Self { balls: self.balls.clone(), places: self.places }
    }

    // Frames of one game share their balls. Counts of references are left alone then: threads would
    // wait for each other to change them.
    fn clone_from(&mut self, source: &Self) {
        let Self { balls, places } = self;
        if !Arc::ptr_eq(balls, &source.balls) {
            balls.clone_from(&source.balls);
        }
        *places = source.places;
    }
}

impl FrameLayout {
    /// The rack of `game` on the table of `base`, with the balls of its physics.
    pub(crate) fn rack(game: Game, base: &Shot, seed: u64) -> Result<Self, Error> {
        let (table, ball) = (base.table(), base.physics().ball);
        let mut racked = rack::rack(game, table, ball.radius, seed, rack::USUAL_GAP)?;
        // The index of a numbered ball is its number.
        let number = |id: &str| id.parse::<BallIndex>().ok();
        if racked[1..].iter().all(|(id, _)| number(id).is_some()) {
            racked[1..].sort_by_key(|(id, _)| number(id));
        }
        let mut places = BallPlaces::default();
        for (place, (_, racked)) in places.iter_mut().zip(&racked) {
            *place = Some(*racked);
        }
        let mut balls: Vec<FrameBall> =
            racked.into_iter().map(|(id, _)| FrameBall { id, ball }).collect();
        if let Some(cue_ball) = rack::cue_ball_of_its_own(table) {
            balls[0].ball = cue_ball;
        }
        Ok(Self { balls: balls.into(), places })
    }

    /// The balls, on the table or not, in the order of their [`BallIndex`].
    pub fn balls(&self) -> &[FrameBall] {
        &self.balls
    }

    /// Number of balls, on the table or not.
    pub fn len(&self) -> usize {
        self.balls.len()
    }

    /// Whether the frame has no balls. Every game has some.
    pub fn is_empty(&self) -> bool {
        self.balls.is_empty()
    }

    /// Centre of `ball` (file coordinates, m); none if it is not on the table or the frame has no
    /// such ball.
    pub fn place(&self, ball: BallIndex) -> Option<[f64; 2]> {
        self.places.get(usize::from(ball)).copied().flatten()
    }

    /// Whether `ball` is off the table. A ball that the frame does not have counts as off the
    /// table.
    pub fn is_down(&self, ball: BallIndex) -> bool {
        self.place(ball).is_none()
    }

    /// The balls on the table.
    pub fn on_table(&self) -> impl Iterator<Item = BallIndex> + '_ {
        (0..).zip(&self.places).filter(|(_, place)| place.is_some()).map(|(i, _)| i)
    }

    /// Those of `balls` that are on the table.
    pub(crate) fn left(&self, balls: impl Iterator<Item = BallIndex>) -> BallList {
        balls.filter(|ball| !self.is_down(*ball)).collect()
    }

    /// Radius of `ball`, m.
    pub(crate) fn radius(&self, ball: BallIndex) -> f64 {
        self.balls[usize::from(ball)].ball.radius
    }

    pub(crate) fn put(&mut self, ball: BallIndex, place: Option<[f64; 2]>) {
        self.places[usize::from(ball)] = place;
    }

    /// All places, to be put back with [`Self::put_all`].
    pub(crate) const fn places(&self) -> &BallPlaces {
        &self.places
    }

    pub(crate) const fn put_all(&mut self, places: &BallPlaces) {
        self.places = *places;
    }

    /// The balls on the table, for a shot.
    pub(crate) fn placed(&self) -> Vec<PlacedBall> {
        let on_table = self.balls.iter().zip(&self.places);
        on_table
            .filter_map(|(ball, place)| Some((ball, (*place)?)))
            .map(|(FrameBall { id, ball }, [x, y])| PlacedBall {
                id: id.clone(),
                ball: *ball,
                state: BallState { position: Vec3::new(x, y, ball.radius), ..BallState::default() },
            })
            .collect()
    }

    /// Whether `ball` would touch no other ball at `place`.
    pub(crate) fn is_free(&self, ball: BallIndex, place: [f64; 2]) -> bool {
        self.in_the_way(ball, place).is_none()
    }

    /// A ball that `ball` would touch at `place`.
    pub(crate) fn in_the_way(&self, ball: BallIndex, place: [f64; 2]) -> Option<BallIndex> {
        let radius = self.radius(ball);
        let touches = |there, other| distance(place, there) <= radius + other;
        self.others(ball).find(|(_, there, other)| touches(*there, *other)).map(|(i, ..)| i)
    }

    /// The other balls on the table: index, centre, radius.
    fn others(&self, ball: BallIndex) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + '_ {
        let all = (0..).zip(self.places.iter().zip(self.balls.iter()));
        all.filter_map(move |(i, (place, other))| {
            place.filter(|_| i != ball).map(|there| (i, there, other.ball.radius))
        })
    }

    /// The balls that touch `ball`: those with a gap of at most `tolerance`, m.
    pub(crate) fn touching(&self, ball: BallIndex, tolerance: f64) -> BallList {
        let Some(place) = self.place(ball) else { return BallList::new() };
        let reach = self.radius(ball) + tolerance;
        let touches = |there, radius| distance(place, there) <= reach + radius;
        let others = self.others(ball).filter(|(_, there, radius)| touches(*there, *radius));
        others.map(|(other, ..)| other).collect()
    }

    /// Spots `ball` on the line from `spot` to the foot rail, as near to the spot as the other
    /// balls allow; if that line is full, on the line from `spot` to the head rail (WPA 1.4; WPBSA,
    /// section 3, rule 7). The ball may touch other balls, except those for which `keeps_off` is
    /// true.
    pub(crate) fn spot(
        &mut self,
        ball: BallIndex,
        spot: [f64; 2],
        table: &Table,
        keeps_off: impl Fn(BallIndex) -> bool,
    ) {
        let radius = self.radius(ball);
        self.put(ball, None);
        let up = self.first_free(ball, spot, &keeps_off, 1.0, table.size.y - table.reach(radius));
        let down = || self.first_free(ball, spot, &keeps_off, -1.0, table.reach(radius));
        // No game has enough balls to fill both lines, so the last fallback is never used.
        self.put(ball, Some(up.or_else(down).unwrap_or(spot)));
    }

    /// The first free place for `ball` on the line x = spot\[0\], from `spot` in `direction` (±1)
    /// up to y = `end`.
    fn first_free(
        &self,
        ball: BallIndex,
        [x, mut y]: [f64; 2],
        keeps_off: &dyn Fn(BallIndex) -> bool,
        direction: f64,
        end: f64,
    ) -> Option<[f64; 2]> {
        let radius = self.radius(ball);
        // Each pass moves beyond one blocking ball, and none blocks twice.
        for _ in 0..=self.balls.len() {
            let blocking = self.others(ball).find_map(|(i, there, other)| {
                let reach = radius + other + if keeps_off(i) { SPOTTING_GAP } else { 0.0 };
                (distance([x, y], there) < reach - ROUNDING).then_some((there, reach))
            });
            let Some((there, reach)) = blocking else {
                return ((end - y) * direction >= 0.0).then_some([x, y]);
            };
            let beside = there[0] - x;
            y = there[1] + direction * sqrt((reach * reach - beside * beside).max(0.0));
        }
        None
    }
}
