//! Whether a player is snookered (WPBSA, section 2, rule 17).

use carom::Table;
use carom::math::{Vec2, sqrt};

use super::balls::CUE;
use crate::layout::{BallIndex, FrameLayout};
use crate::markings::{distance, the_d};

/// Steps of the grid of places in the D where a cue ball in hand is tried: this many across the D
/// and half as many along it. With a coarser grid an open place could be missed.
const TRIALS: u32 = 12;

/// Rounding error of a distance, m.
const ROUNDING: f64 = 1e-12;

/// Whether balls that are not `on` obstruct, wholly or in part, a straight shot at every ball `on`.
/// A player with the cue ball in hand is snookered if this holds everywhere in the D.
pub(super) fn is_snookered(table: &Table, layout: &FrameLayout, on: &[BallIndex]) -> bool {
    let blocks = |ball: BallIndex| !on.contains(&ball);
    match layout.place(CUE) {
        Some(place) => hides(layout, place, on, &blocks),
        None => places_in_the_d(table).all(|place| hides(layout, place, on, &blocks)),
    }
}

/// Whether the cue ball is snookered by `ball`: for every ball `on`, `ball` obstructs the straight
/// shot, wholly or in part, and is the nearest of the obstructing balls (section 2, rule 17b, c).
pub(super) fn is_snookered_by(layout: &FrameLayout, ball: BallIndex, on: &[BallIndex]) -> bool {
    let Some(from) = layout.place(CUE) else { return false };
    let far = |ball| layout.place(ball).map_or(f64::INFINITY, |there| distance(from, there));
    let obstructs = |ball, target| !is_open(layout, from, target, &|other| other == ball);
    on.iter().all(|target| {
        let nearer = |other: &BallIndex| far(*other) < far(ball);
        let mut nearer = layout.on_table().filter(|b| *b != CUE && !on.contains(b)).filter(nearer);
        obstructs(ball, *target) && !nearer.any(|other| obstructs(other, *target))
    })
}

/// Whether balls for which `blocking` is true obstruct the shot from `from` at every ball `on`.
fn hides(
    layout: &FrameLayout,
    from: [f64; 2],
    on: &[BallIndex],
    blocking: &dyn Fn(BallIndex) -> bool,
) -> bool {
    !on.iter().any(|target| is_open(layout, from, *target, blocking))
}

/// Whether both edges of `target` can be hit in a straight line from `from`.
fn is_open(
    layout: &FrameLayout,
    from: [f64; 2],
    target: BallIndex,
    blocking: &dyn Fn(BallIndex) -> bool,
) -> bool {
    let Some(there) = layout.place(target) else { return false };
    let way = Vec2::new(there[0] - from[0], there[1] - from[1]);
    let (reach, length) = (layout.radius(CUE) + layout.radius(target), way.length());
    if length <= reach {
        return true;
    }
    // The cue ball's centre moves along the two tangents to the circle of its centres at contact.
    let tangent = sqrt(length * length - reach * reach);
    let along = way * (tangent / (length * length));
    let across = Vec2::new(-way.y, way.x) * (reach / (length * length));
    [1.0, -1.0].into_iter().all(|side| {
        let path = (along + across * side) * tangent;
        is_clear(layout, from, path, |ball| ball != target && blocking(ball))
    })
}

/// Whether one of the balls `on` can be hit full in a straight line.
pub(super) fn is_full_ball_open(layout: &FrameLayout, on: &[BallIndex]) -> bool {
    let Some(from) = layout.place(CUE) else { return false };
    on.iter().filter_map(|target| layout.place(*target)).any(|there| {
        let path = Vec2::new(there[0] - from[0], there[1] - from[1]);
        is_clear(layout, from, path, |ball| !on.contains(&ball))
    })
}

/// Whether the cue ball can move from `from` along `path` without touching a `blocking` ball.
fn is_clear(
    layout: &FrameLayout,
    from: [f64; 2],
    path: Vec2,
    blocking: impl Fn(BallIndex) -> bool,
) -> bool {
    layout.on_table().filter(|ball| *ball != CUE && blocking(*ball)).all(|ball| {
        let place = layout.place(ball).unwrap_or(from);
        let to = Vec2::new(place[0] - from[0], place[1] - from[1]);
        let nearest = (to.dot(path) / path.length_squared()).clamp(0.0, 1.0);
        (to - path * nearest).length() >= layout.radius(CUE) + layout.radius(ball) - ROUNDING
    })
}

/// The places in the D where a cue ball in hand is tried.
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
