//! Which balls a frame has, and where they lie.

use std::sync::Arc;

use carom::math::{Vec2, Vec3, sqrt};
use carom::rack::{self, Game};
use carom::shot::PlacedBall;
use carom::{Ball, BallState, Error, Shot, Table};

use crate::BallIndex;

/// A spotted ball is kept this far from a ball that it must not touch, m: a sheet of paper.
const KEPT_OFF: f64 = 1e-4;

/// What rounding may take from a distance, m.
const ROUNDING: f64 = 1e-12;

/// A ball of the frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Its id in shots.
    pub id: String,
    /// Mass and radius.
    pub ball: Ball,
}

/// The balls of a frame, and where they lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    pieces: Arc<[Piece]>,
    places: Vec<Option<[f64; 2]>>,
}

impl Layout {
    /// The rack of `game` on the table of `base`, whose physics gives the balls.
    pub(crate) fn rack(game: Game, base: &Shot, seed: u64) -> Result<Self, Error> {
        let (table, ball) = (base.table(), base.physics().ball);
        let mut racked = rack::rack(game, table, ball.radius, seed, rack::USUAL_GAP)?;
        // Numbered balls stand where their number says.
        let number = |id: &str| id.parse::<u8>().ok();
        if racked[1..].iter().all(|(id, _)| number(id).is_some()) {
            racked[1..].sort_by_key(|(id, _)| number(id));
        }
        let places = racked.iter().map(|(_, place)| Some(*place)).collect();
        let mut pieces: Vec<Piece> = racked.into_iter().map(|(id, _)| Piece { id, ball }).collect();
        if let Some(cue_ball) = rack::cue_ball_of_its_own(table) {
            pieces[0].ball = cue_ball;
        }
        Ok(Self { pieces: pieces.into(), places })
    }

    /// The balls; a [`BallIndex`] is a place in this list.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Number of balls, on the table or not.
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// Whether the frame has no ball, which none does.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Where `ball` lies, if it is on the table.
    pub fn place(&self, ball: BallIndex) -> Option<[f64; 2]> {
        self.places[usize::from(ball)]
    }

    /// Whether `ball` is on the table.
    pub fn is_down(&self, ball: BallIndex) -> bool {
        self.place(ball).is_none()
    }

    /// The balls on the table.
    pub fn on_table(&self) -> impl Iterator<Item = BallIndex> + '_ {
        (0..).zip(&self.places).filter(|(_, place)| place.is_some()).map(|(i, _)| i)
    }

    /// Of `balls`, those on the table.
    pub(crate) fn left(&self, balls: impl Iterator<Item = BallIndex>) -> Vec<BallIndex> {
        balls.filter(|ball| !self.is_down(*ball)).collect()
    }

    pub(crate) fn put(&mut self, ball: BallIndex, place: Option<[f64; 2]>) {
        self.places[usize::from(ball)] = place;
    }

    /// The balls on the table as a shot has them.
    pub(crate) fn placed(&self) -> Vec<PlacedBall> {
        let on_table = self.pieces.iter().zip(&self.places);
        on_table
            .filter_map(|(piece, place)| Some((piece, (*place)?)))
            .map(|(piece, [x, y])| PlacedBall {
                id: piece.id.clone(),
                ball: piece.ball,
                state: BallState {
                    position: Vec3::new(x, y, piece.ball.radius),
                    ..BallState::default()
                },
            })
            .collect()
    }

    /// Whether `ball` could lie at `place` touching no other ball.
    pub(crate) fn is_free(&self, ball: BallIndex, place: [f64; 2]) -> bool {
        self.in_the_way(ball, place).is_none()
    }

    /// A ball that `ball` would touch at `place`.
    pub(crate) fn in_the_way(&self, ball: BallIndex, place: [f64; 2]) -> Option<BallIndex> {
        let radius = self.pieces[usize::from(ball)].ball.radius;
        let touches = |there, other| distance(place, there) <= radius + other;
        self.others(ball).find(|(_, there, other)| touches(*there, *other)).map(|(i, ..)| i)
    }

    /// The other balls on the table: number, centre, radius.
    fn others(&self, ball: BallIndex) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + '_ {
        let all = (0..).zip(self.places.iter().zip(self.pieces.iter()));
        all.filter_map(move |(i, (place, piece))| {
            place.filter(|_| i != ball).map(|there| (i, there, piece.ball.radius))
        })
    }

    /// The balls that touch `ball`: nearer to it than `tolerance`, m.
    pub(crate) fn touching(&self, ball: BallIndex, tolerance: f64) -> Vec<BallIndex> {
        let Some(place) = self.place(ball) else { return Vec::new() };
        let reach = self.pieces[usize::from(ball)].ball.radius + tolerance;
        let touches = |there, radius| distance(place, there) <= reach + radius;
        let others = self.others(ball).filter(|(_, there, radius)| touches(*there, *radius));
        others.map(|(other, ..)| other).collect()
    }

    /// Puts `ball` on the line from `spot` up the table (to the foot rail), as near to the spot as the
    /// other balls allow; where there is no room, on the line down the table (WPA 1.4; WPBSA, section 3,
    /// rule 7). It may touch other balls, but not those that it `keeps_off`.
    pub(crate) fn spot(
        &mut self,
        ball: BallIndex,
        spot: [f64; 2],
        table: &Table,
        keeps_off: impl Fn(BallIndex) -> bool,
    ) {
        let radius = self.pieces[usize::from(ball)].ball.radius;
        self.put(ball, None);
        let up = self.first_free(ball, spot, &keeps_off, 1.0, table.size.y - table.reach(radius));
        let down = || self.first_free(ball, spot, &keeps_off, -1.0, table.reach(radius));
        // A line full of balls from end to end does not occur: there are not enough of them.
        self.put(ball, Some(up.or_else(down).unwrap_or(spot)));
    }

    /// The first place along the line x = spot[0], from `spot` in `direction`, up to y = `end`.
    fn first_free(
        &self,
        ball: BallIndex,
        [x, mut y]: [f64; 2],
        keeps_off: &dyn Fn(BallIndex) -> bool,
        direction: f64,
        end: f64,
    ) -> Option<[f64; 2]> {
        let radius = self.pieces[usize::from(ball)].ball.radius;
        // Every ball is passed at most once.
        for _ in 0..=self.pieces.len() {
            let blocking = self.others(ball).find_map(|(i, there, other)| {
                let reach = radius + other + if keeps_off(i) { KEPT_OFF } else { 0.0 };
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

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    Vec2::new(b[0] - a[0], b[1] - a[1]).length()
}

/// The spot of that name, or else the point at `fraction` of the length on the long string.
pub(crate) fn spot_named(table: &Table, name: &str, fraction: f64) -> [f64; 2] {
    let spots = table.description.as_ref().map_or(&[][..], |d| &d.markings.spots);
    let marked = spots.iter().find(|s| s.name == name).map(|s| s.position);
    marked.unwrap_or([0.5 * table.size.x, fraction * table.size.y])
}

/// y of the head string (the baulk line), m.
pub(crate) fn head_string(table: &Table) -> f64 {
    let marked = table.description.as_ref().and_then(|d| d.markings.head_string);
    marked.unwrap_or(0.25 * table.size.y)
}
