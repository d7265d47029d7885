//! Where a ball may lie: places for the cue ball in hand, and layouts at random.

use core::f64::consts::PI;

use carom::math::{Vec2, sin_cos, sqrt};
use carom::{Error, Table};
use carom_rules::{BallIndex, Piece, Region};

use crate::random::Dice;
use crate::scene::Scene;

/// Distance between neighbouring places that are tried, m.
const SPACING: f64 = 0.003;

/// How many are tried: enough to leave the largest rack behind.
const PLACES: u32 = 40_000;

/// Gap left to other balls, so that what is placed touches nothing, m.
const GAP: f64 = 1e-6;

/// Places at random tried for a ball before the whole layout is begun anew, and layouts tried.
const TRIES: u32 = 1000;

/// The golden angle, rad: a spiral turned by it at every step is evenly dense everywhere (Vogel 1979).
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// Whether a ball of `radius` (m) on the cloth at `place` (m, in the file's frame) is on the bed, clear of
/// holes and cushions, and within the lines of the noses.
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

/// The legal place of ball `cue` in `region` that is nearest to where `wanted` points: −1 to 1 from side to
/// side of the region's bounding box. None where the whole region is full.
pub(crate) fn nearest(
    scene: &dyn Scene,
    cue: BallIndex,
    region: Region,
    wanted: [f64; 2],
) -> Option<[f64; 2]> {
    let table = scene.base().table();
    let radius = scene.pieces()[usize::from(cue)].ball.radius;
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
            && scene
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

/// Finds places at random for the balls marked in `wanted`, on the table of `table` with what has a place in
/// `places` already.
///
/// # Errors
/// [`Error::Input`] if there is no room.
pub(crate) fn scatter(
    table: &Table,
    pieces: &[Piece],
    wanted: &[bool],
    places: &mut [Option<[f64; 2]>],
    dice: &mut Dice,
) -> Result<(), Error> {
    for _ in 0..TRIES {
        let is_whole = (0..pieces.len()).filter(|ball| wanted[*ball]).all(|ball| {
            places[ball] = find(table, pieces, places, pieces[ball].ball.radius, dice);
            places[ball].is_some()
        });
        if is_whole {
            return Ok(());
        }
        (0..pieces.len()).filter(|ball| wanted[*ball]).for_each(|ball| places[ball] = None);
    }
    Err(Error::input("balls", "there is no room for so many", "ask for fewer, or a larger table"))
}

/// A place at random for a ball of `radius` (m) beside those that have one.
fn find(
    table: &Table,
    pieces: &[Piece],
    places: &[Option<[f64; 2]>],
    radius: f64,
    dice: &mut Dice,
) -> Option<[f64; 2]> {
    (0..TRIES).find_map(|_| {
        let place = [dice.between(0.0, table.size.x), dice.between(0.0, table.size.y)];
        let is_free = pieces.iter().zip(places).all(|(other, there)| {
            there.is_none_or(|there| distance(place, there) > radius + other.ball.radius + GAP)
        });
        (is_free && is_on_bed(table, place, radius)).then_some(place)
    })
}
