//! Parting balls that overlap by little: rounded positions of other programs, and measured ones.
//!
//! The balls on the cloth are moved to the nearest positions (least sum of squares) without overlaps of
//! balls and cushions. That is a convex problem once the directions of the contacts are fixed: Hildreth's
//! method (C. Hildreth, *A quadratic programming procedure*, Naval Research Logistics Quarterly 4, 1957)
//! solves it, and the directions are then taken again at the new positions. The nearest positions are
//! unique, so mirrored layouts have mirrored repairs, and the order of the balls does not matter beyond
//! rounding.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::{BallInSpace, PlacedBall};
use crate::Table;
use crate::error::{Error, ErrorKind};
use crate::math::{Vec2, sqrt};
use crate::range::Range;
use crate::table::TOUCH_TOLERANCE;

/// The largest tolerance of a repair, m: a ball's radius. Beyond it, which ball is where is a guess.
const TOLERANCE: Range = Range::closed(0.0, 0.03, " m");

/// Largest overlap that is left, m: a tenth of what counts as touching.
const EXACT: f64 = 1e-10;
/// How often the directions of the contacts are taken again. Each time the error is squared, so a few
/// suffice; a layout that needs more is jammed.
const ROUNDS: usize = 30;
/// Most sweeps over the contacts with fixed directions. A frozen row of twenty balls needs a few thousand.
const SWEEPS: usize = 20_000;
/// The sweeps end when no contact changes by more, m.
const STILL: f64 = 1e-13;

/// A ball that a repair has moved.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedBall {
    /// Its id.
    pub id: String,
    /// Where it is now, minus where it was, m.
    pub by: [f64; 2],
}

/// What limits a ball: another ball or a cushion part, by index.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Limit {
    Ball(usize),
    Part(usize),
}

/// A contact whose direction is fixed.
struct Contact {
    ball: usize,
    limit: Limit,
    /// Unit vector in which the ball moves away from the limit.
    away: Vec2,
    /// How much larger the distance must become than at the start, m, along `away`.
    needed: f64,
    /// The multiplier: how far the contact has pushed, m.
    push: f64,
}

/// Moves `balls` that overlap each other or a cushion by at most `tolerance` (m) apart, and lists those
/// that moved. Balls in the air stay where they are. Nothing changes if nothing overlaps.
///
/// # Errors
/// [`Error::Input`] for a tolerance out of range, and at the ball that overlaps by more, or that has no
/// room.
pub fn repair(
    balls: &mut [PlacedBall],
    table: &Table,
    tolerance: f64,
) -> Result<Vec<MovedBall>, Error> {
    TOLERANCE.check(|| "tolerance".to_string(), tolerance)?;
    for placed in balls.iter_mut() {
        let (z, radius) = (placed.state.position.z, placed.ball.radius);
        if z < radius && z >= radius - tolerance {
            placed.state.position.z = radius;
        }
    }
    let origin = table.center();
    let start: Vec<Vec2> = balls.iter().map(|placed| placed.state.position.xy() - origin).collect();
    // Balls that were apart may be pushed together, so all near ones are looked at.
    let near = 8.0 * tolerance + 1e-6;
    let Some(deepest) = deepest(balls, table, &start, TOUCH_TOLERANCE) else {
        return Ok(Vec::new());
    };
    refuse_deeper(balls, table, &start, tolerance)?;
    let mut places = start.clone();
    let mut left = Some(deepest);
    for _ in 0..ROUNDS {
        let mut contacts = contacts(balls, table, &start, &places, near);
        push(&mut contacts, &start, &mut places);
        left = self::deepest(balls, table, &places, EXACT);
        if left.is_none() {
            break;
        }
    }
    if let Some((ball, limit, depth)) = left {
        return Err(refusal(
            balls,
            table,
            ball,
            limit,
            &format!("overlaps {{}} by {depth:.3e} m and has no room to move away"),
            "take a ball out, or measure the positions again",
        ));
    }
    let mut moved = Vec::new();
    for (placed, (from, to)) in balls.iter_mut().zip(start.iter().zip(&places)) {
        let by = *to - *from;
        if by != Vec2::ZERO {
            placed.state.position.x += by.x;
            placed.state.position.y += by.y;
            moved.push(MovedBall { id: placed.id.clone(), by: [by.x, by.y] });
        }
    }
    Ok(moved)
}

fn on_cloth(placed: &PlacedBall) -> bool {
    placed.state.position.z == placed.ball.radius
}

/// The horizontal distance of the centres of two balls that touch, m.
fn apart(a: &PlacedBall, b: &PlacedBall) -> f64 {
    let [a, b]: [BallInSpace; 2] = [a.into(), b.into()];
    let (reach, rise) = (a.radius + b.radius, a.center.z - b.center.z);
    sqrt((reach * reach - rise * rise).max(0.0))
}

/// Every contact of a ball on the cloth that is closer than `near` (m): ball, limit, unit vector away from
/// the limit, overlap (m).
fn overlaps(
    balls: &[PlacedBall],
    table: &Table,
    places: &[Vec2],
    near: f64,
) -> Vec<(usize, Limit, Vec2, f64)> {
    let mut found = Vec::new();
    for (i, placed) in balls.iter().enumerate().filter(|(_, placed)| on_cloth(placed)) {
        for (j, other) in balls.iter().enumerate() {
            // Once for two balls on the cloth.
            if j == i || (j < i && on_cloth(other)) {
                continue;
            }
            let between = places[i] - places[j];
            let distance = between.length();
            let depth = apart(placed, other) - distance;
            if depth > -near {
                // Balls at one place are parted along the table's width.
                let away =
                    if distance > 0.0 { between * (1.0 / distance) } else { Vec2::new(1.0, 0.0) };
                found.push((i, Limit::Ball(j), away, depth));
            }
        }
        for (part, depth) in table.depths_on_cloth(places[i], placed.ball.radius) {
            if depth > -near {
                let away = Vec2::ZERO - table.normal_at(part, places[i]);
                found.push((i, Limit::Part(part), away, depth));
            }
        }
    }
    found
}

/// The deepest overlap of more than `least` (m).
fn deepest(
    balls: &[PlacedBall],
    table: &Table,
    places: &[Vec2],
    least: f64,
) -> Option<(usize, Limit, f64)> {
    let all = overlaps(balls, table, places, 0.0).into_iter();
    all.filter(|(.., depth)| *depth > least)
        .max_by(|a, b| a.3.total_cmp(&b.3))
        .map(|(ball, limit, _, depth)| (ball, limit, depth))
}

fn refuse_deeper(
    balls: &[PlacedBall],
    table: &Table,
    places: &[Vec2],
    tolerance: f64,
) -> Result<(), Error> {
    let Some((ball, limit, depth)) = deepest(balls, table, places, tolerance.max(TOUCH_TOLERANCE))
    else {
        return Ok(());
    };
    let what =
        format!("overlaps {{}} by {depth:.3e} m, more than the tolerance of {tolerance:e} m");
    Err(refusal(balls, table, ball, limit, &what, "move them apart, or raise the tolerance"))
}

/// `what` has `{}` for what is overlapped.
fn refusal(
    balls: &[PlacedBall],
    table: &Table,
    ball: usize,
    limit: Limit,
    what: &str,
    remedy: &str,
) -> Error {
    let position = |ball: usize| format!("balls[{ball}].position");
    let what = |ball: usize, other: &str| {
        format!("ball \"{}\" {}", balls[ball].id, what.replacen("{}", other, 1))
    };
    match limit {
        // The later one is named first, as where a shot is checked.
        Limit::Ball(other) => {
            let (later, first) = (ball.max(other), ball.min(other));
            let what = what(later, &format!("balls[{first}] (\"{}\")", balls[first].id));
            ErrorKind::Overlap
                .at(position(later), what, remedy)
                .with("ball", &*balls[later].id)
                .with("other", &*balls[first].id)
        }
        Limit::Part(part) => {
            let part = &table.cushions[part];
            let (name, rail) = (part.part.name(), part.rail.name());
            let what = what(ball, &format!("the {name} of the {rail} cushion"));
            ErrorKind::InCushion
                .at(position(ball), what, remedy)
                .with("rail", rail)
                .with("part", name)
        }
    }
}

/// The contacts near `places`, with what they need from `start` on.
fn contacts(
    balls: &[PlacedBall],
    table: &Table,
    start: &[Vec2],
    places: &[Vec2],
    near: f64,
) -> Vec<Contact> {
    let of = |(ball, limit, away, depth): (usize, Limit, Vec2, f64)| {
        let mut so_far = places[ball] - start[ball];
        if let Limit::Ball(other) = limit {
            so_far -= places[other] - start[other];
        }
        Contact { ball, limit, away, needed: depth + away.dot(so_far), push: 0.0 }
    };
    // A contact of two balls of which one is in the air moves only the other.
    overlaps(balls, table, places, near)
        .into_iter()
        .map(|found| {
            let fixed = matches!(found.1, Limit::Ball(other) if !on_cloth(&balls[other]));
            let contact = of(found);
            if fixed { Contact { limit: Limit::Part(usize::MAX), ..contact } } else { contact }
        })
        .collect()
}

/// The positions nearest to `start` that give every contact what it needs.
fn push(contacts: &mut [Contact], start: &[Vec2], places: &mut [Vec2]) {
    let mut by = vec![Vec2::ZERO; start.len()];
    for _ in 0..SWEEPS {
        let mut change: f64 = 0.0;
        for contact in contacts.iter_mut() {
            let (given, weight) = match contact.limit {
                Limit::Ball(other) => (contact.away.dot(by[contact.ball] - by[other]), 2.0),
                Limit::Part(_) => (contact.away.dot(by[contact.ball]), 1.0),
            };
            let push = (contact.push + (contact.needed - given) / weight).max(0.0);
            let more = push - contact.push;
            contact.push = push;
            by[contact.ball] += contact.away * more;
            if let Limit::Ball(other) = contact.limit {
                by[other] -= contact.away * more;
            }
            change = change.max(more.abs());
        }
        if change < STILL {
            break;
        }
    }
    for ((place, start), by) in places.iter_mut().zip(start).zip(by) {
        *place = *start + by;
    }
}
