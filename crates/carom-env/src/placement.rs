//! Free places: for a cue ball in hand, and for random layouts.

use core::f64::consts::PI;

use carom::math::{Vec2, sin_cos, sqrt};
use carom::{Error, ErrorKind, Table};
use carom_rules::{BallIndex, FrameBall, Region};

use crate::episode::Episode;
use crate::random::Dice;

/// Distance between neighbouring places on the spiral, m.
const SPACING: f64 = 0.003;

/// Number of places on the spiral: enough to reach beyond the largest rack.
const PLACES: u32 = 40_000;

/// Smallest gap to other balls, m, so that a placed ball touches none.
const GAP: f64 = 1e-6;

/// Number of random places that are tried for a ball, and of random layouts that are tried.
const TRIES: u32 = 1000;

/// The golden angle, rad. A spiral that turns by it at every step has the same density everywhere
/// (Vogel 1979).
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// Whether a ball of `radius` (m) at `place` (file coordinates, m) is on the bed, clear of holes
/// and cushions, and inside the nose lines.
fn is_on_bed(table: &Table, place: [f64; 2], radius: f64) -> bool {
    let reach = table.reach(radius);
    let inside = |x: f64, size: f64| (reach..=size - reach).contains(&x);
    inside(place[0], table.size.x)
        && inside(place[1], table.size.y)
        && table.place_check(Vec2::new(place[0], place[1]) - table.center(), radius).is_inside()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    Vec2::new(b[0] - a[0], b[1] - a[1]).length()
}

/// The free place of ball `cue` in `region` that is nearest to `wanted`: −1 to 1 across each side
/// of the region's bounding box. None if no free place is found.
pub(crate) fn nearest(
    episode: &dyn Episode,
    cue: BallIndex,
    region: Region,
    wanted: [f64; 2],
) -> Option<[f64; 2]> {
    let table = episode.base().table();
    let radius = episode.radius(cue);
    let reach = table.reach(radius);
    let [low, high] = region.bounds(table);
    let size = [table.size.x, table.size.y];
    let start = [0, 1].map(|k| {
        let place = low[k] + 0.5 * (wanted[k] + 1.0) * (high[k] - low[k]);
        place.clamp(reach, size[k] - reach)
    });
    let is_legal = |place: [f64; 2]| {
        region.holds(table, place)
            && is_on_bed(table, place, radius)
            && episode
                .others(cue)
                .all(|(_, there, other)| distance(place, there) > radius + other + GAP)
    };
    let tried = (0..PLACES).map(|k| {
        let k = f64::from(k);
        let (sin, cos) = sin_cos(k * GOLDEN_ANGLE);
        let away = SPACING * sqrt(k / PI);
        [start[0] + away * cos, start[1] + away * sin]
    });
    tried.into_iter().find(|place| is_legal(*place))
}

/// Places the balls marked in `wanted` at random on `table`, clear of each other and of the balls
/// that already have a place.
///
/// # Errors
/// [`Error::Input`] if there is no room.
pub(crate) fn scatter(
    table: &Table,
    balls: &[FrameBall],
    wanted: &[bool],
    places: &mut [Option<[f64; 2]>],
    dice: &mut Dice,
) -> Result<(), Error> {
    for _ in 0..TRIES {
        let is_whole = (0..balls.len()).filter(|ball| wanted[*ball]).all(|ball| {
            places[ball] = find(table, balls, places, balls[ball].ball.radius, dice);
            places[ball].is_some()
        });
        if is_whole {
            return Ok(());
        }
        (0..balls.len()).filter(|ball| wanted[*ball]).for_each(|ball| places[ball] = None);
    }
    Err(ErrorKind::NoRoom.at(
        "balls",
        "there is no room for this number of balls",
        "ask for fewer balls, or choose a larger table",
    ))
}

/// A random free place for a ball of `radius` (m).
fn find(
    table: &Table,
    balls: &[FrameBall],
    places: &[Option<[f64; 2]>],
    radius: f64,
    dice: &mut Dice,
) -> Option<[f64; 2]> {
    (0..TRIES).find_map(|_| {
        let place = [dice.between(0.0, table.size.x), dice.between(0.0, table.size.y)];
        let is_free = balls.iter().zip(places).all(|(other, there)| {
            there.is_none_or(|there| distance(place, there) > radius + other.ball.radius + GAP)
        });
        (is_free && is_on_bed(table, place, radius)).then_some(place)
    })
}

#[cfg(test)]
mod tests {
    use carom::Ball;

    use super::*;

    #[test]
    fn more_balls_than_the_table_has_room_for_are_refused() {
        let table = Table::preset("bar-7ft").expect("a preset");
        let placed = |count: usize| {
            let ball = Ball { mass: 0.17, radius: 0.1 };
            let balls: Vec<_> = (0..count).map(|k| FrameBall { id: k.to_string(), ball }).collect();
            let mut places = vec![None; count];
            scatter(&table, &balls, &vec![true; count], &mut places, &mut Dice::of_layout(1))
        };
        placed(10).expect("room for ten");
        assert_eq!(placed(60).unwrap_err().kind(), ErrorKind::NoRoom);
    }
}
