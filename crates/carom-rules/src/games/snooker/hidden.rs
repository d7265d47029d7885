//! Is a player snookered? (WPBSA, section 2, rule 17.)

use carom::Table;
use carom::math::{Vec2, sqrt};

use super::CUE;
use crate::BallIndex;
use crate::layout::{Layout, distance};
use crate::request::the_d;

/// A cue ball in hand is tried at so many places across the D, and half as many along it.
const TRIALS: u32 = 12;

/// What rounding may take from a distance, m.
const ROUNDING: f64 = 1e-12;

/// Whether a straight shot at every ball `on` is obstructed, wholly or in part, by balls that are not;
/// with the cue ball in hand, from everywhere in the D.
pub(super) fn is_snookered(table: &Table, layout: &Layout, on: &[BallIndex]) -> bool {
    let blocks = |ball: BallIndex| !on.contains(&ball);
    match layout.place(CUE) {
        Some(place) => hides(layout, place, on, &blocks),
        None => places_in_the_d(table).all(|place| hides(layout, place, on, &blocks)),
    }
}

/// Whether `ball` is what the cue ball is snookered by: at every ball `on` it obstructs a straight shot, wholly
/// or in part, and is the nearest of those that do (section 2, rule 17b, c).
pub(super) fn is_snookered_by(layout: &Layout, ball: BallIndex, on: &[BallIndex]) -> bool {
    let Some(from) = layout.place(CUE) else { return false };
    let way = |ball| layout.place(ball).map_or(f64::INFINITY, |there| distance(from, there));
    let obstructs = |ball, target| !is_open(layout, from, target, &|other| other == ball);
    on.iter().all(|target| {
        let nearer = |other: &BallIndex| way(*other) < way(ball);
        let mut nearer = layout.on_table().filter(|b| *b != CUE && !on.contains(b)).filter(nearer);
        obstructs(ball, *target) && !nearer.any(|other| obstructs(other, *target))
    })
}

fn hides(
    layout: &Layout,
    from: [f64; 2],
    on: &[BallIndex],
    blocking: &dyn Fn(BallIndex) -> bool,
) -> bool {
    !on.iter().any(|target| is_open(layout, from, *target, blocking))
}

/// Whether both edges of `target` can be hit in a straight line.
fn is_open(
    layout: &Layout,
    from: [f64; 2],
    target: BallIndex,
    blocking: &dyn Fn(BallIndex) -> bool,
) -> bool {
    let radius = |ball: BallIndex| layout.pieces()[usize::from(ball)].ball.radius;
    let Some(there) = layout.place(target) else { return false };
    let way = Vec2::new(there[0] - from[0], there[1] - from[1]);
    let (reach, length) = (radius(CUE) + radius(target), way.length());
    if length <= reach {
        return true;
    }
    // The cue ball's centre goes along the two tangents of the circle on which it touches.
    let tangent = sqrt(length * length - reach * reach);
    let along = way * (tangent / (length * length));
    let across = Vec2::new(-way.y, way.x) * (reach / (length * length));
    [1.0, -1.0].into_iter().all(|side| {
        let path = (along + across * side) * tangent;
        is_clear(layout, from, path, |ball| ball != target && blocking(ball))
    })
}

/// Whether one of the balls `on` can be hit full in a straight line.
pub(super) fn is_full_ball_open(layout: &Layout, on: &[BallIndex]) -> bool {
    let Some(from) = layout.place(CUE) else { return false };
    on.iter().filter_map(|target| layout.place(*target)).any(|there| {
        let path = Vec2::new(there[0] - from[0], there[1] - from[1]);
        is_clear(layout, from, path, |ball| !on.contains(&ball))
    })
}

/// Whether the cue ball can go from `from` along `path` past all balls that are `blocking`.
fn is_clear(
    layout: &Layout,
    from: [f64; 2],
    path: Vec2,
    blocking: impl Fn(BallIndex) -> bool,
) -> bool {
    let radius = |ball: BallIndex| layout.pieces()[usize::from(ball)].ball.radius;
    layout.on_table().filter(|ball| *ball != CUE && blocking(*ball)).all(|ball| {
        let place = layout.place(ball).unwrap_or(from);
        let to = Vec2::new(place[0] - from[0], place[1] - from[1]);
        let nearest = (to.dot(path) / path.length_squared()).clamp(0.0, 1.0);
        (to - path * nearest).length() >= radius(CUE) + radius(ball) - ROUNDING
    })
}

fn places_in_the_d(table: &Table) -> impl Iterator<Item = [f64; 2]> {
    let ([middle, line], radius) = the_d(table);
    let step = 2.0 * radius / f64::from(TRIALS);
    (0..=TRIALS / 2).flat_map(move |row| {
        (0..=TRIALS).filter_map(move |column| {
            let (x, y) = (f64::from(column) * step - radius, -f64::from(row) * step);
            (x * x + y * y <= radius * radius * (1.0 + ROUNDING)).then_some([middle + x, line + y])
        })
    })
}
