//! Checks that balls have room where a shot puts them.

use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::ops::Deref;

use super::PlacedBall;
use crate::ball::{MASS, RADIUS};
use crate::error::{Error, ErrorKind};
use crate::limits::MAX_BALLS;
use crate::math::{Vec3, sqrt};
use crate::range::Range;
use crate::table::TOUCH_TOLERANCE;
use crate::{BallState, MotionState, Table, motion};

/// Largest speed of a ball, m/s. The fastest breaks are near 15 m/s.
const LARGEST_SPEED: f64 = 100.0;
/// Largest spin of a ball, rad/s. A tip at the miscue limit gives a ball of 30 m/s about 1300
/// rad/s.
const LARGEST_SPIN: f64 = 10_000.0;

/// Balls that have room on a table, with the heights and motion states that a simulation starts
/// from.
#[derive(Clone, Debug)]
pub(crate) struct CheckedBalls(Arc<[PlacedBall]>);

impl CheckedBalls {
    /// The balls, in their order.
    pub(super) fn into_inner(self) -> Arc<[PlacedBall]> {
        self.0
    }
}

impl Deref for CheckedBalls {
    type Target = [PlacedBall];

    fn deref(&self) -> &[PlacedBall] {
        &self.0
    }
}

/// Checks `balls` of a shot on `table`.
///
/// # Errors
/// [`Error::Input`] for too few or too many balls, numbers out of range, ids that are not unique,
/// balls outside the table, and overlaps.
pub(crate) fn checked(mut balls: Vec<PlacedBall>, table: &Table) -> Result<CheckedBalls, Error> {
    check_count(balls.len())?;
    for (i, PlacedBall { ball, state, .. }) in balls.iter_mut().enumerate() {
        let place = |key: &'static str| move || format!("balls[{i}].{key}");
        MASS.check(place("mass"), ball.mass)?;
        RADIUS.check(place("radius"), ball.radius)?;
        for x in state.position.to_array() {
            Range::any(" m").check(place("position"), x)?;
        }
        state.position.z = height(place("position"), state.position.z, ball.radius)?;
        check_length(place("velocity"), state.velocity, LARGEST_SPEED, "m/s")?;
        check_length(place("angular_velocity"), state.angular_velocity, LARGEST_SPIN, "rad/s")?;
        state.motion = motion(state, ball.radius);
    }
    check(&balls, table)?;
    Ok(CheckedBalls(balls.into()))
}

fn check_count(count: usize) -> Result<(), Error> {
    if (1..=MAX_BALLS).contains(&count) {
        return Ok(());
    }
    let remedy = format!("write between 1 and {MAX_BALLS}");
    Err(ErrorKind::BallCount
        .at("balls", format!("found {count} balls"), remedy)
        .with("count", count as f64))
}

/// Refuses ids that are not unique, balls that are not inside the table, and overlaps.
fn check(balls: &[PlacedBall], table: &Table) -> Result<(), Error> {
    for (i, ball) in balls.iter().enumerate() {
        if let Some(first) = balls[..i].iter().position(|b| b.id == ball.id) {
            return Err(ErrorKind::DuplicateId
                .at(
                    format!("balls[{i}].id"),
                    format!("\"{}\" is already the id of balls[{first}]", ball.id),
                    "give every ball its own id",
                )
                .with("id", &*ball.id));
        }
    }
    for (i, ball) in balls.iter().enumerate() {
        super::place::check(i, ball, table)?;
    }
    check_overlaps(balls)
}

/// Whether ball `index` is inside the table and overlaps no other ball.
pub(crate) fn fits(index: usize, balls: &[PlacedBall], table: &Table) -> bool {
    let ball = &balls[index];
    let mut others = balls.iter().enumerate().filter(|(i, _)| *i != index);
    others.all(|(_, other)| depth(ball, other) <= TOUCH_TOLERANCE)
        && super::place::is_inside(ball, table)
}

/// The height of a centre, m: exactly the radius if it is within [`TOUCH_TOLERANCE`] of it, so that
/// a ball either lies on the bed or does not.
fn height(place: impl FnOnce() -> String, z: f64, radius: f64) -> Result<f64, Error> {
    if z < radius - TOUCH_TOLERANCE {
        return Err(ErrorKind::InSlate.at(
            place(),
            format!(
                "the ball is {} m deep in the slate: z = {z:?}, its radius {radius:?} m",
                radius - z
            ),
            "leave z out, or write the radius, or more for a ball in the air",
        ));
    }
    Ok(if z > radius + TOUCH_TOLERANCE { z } else { radius })
}

/// The motion state at the start.
fn motion(state: &BallState, radius: f64) -> MotionState {
    // A ball on the bed with a downward velocity is airborne too: it bounces at once.
    if state.position.z > radius || state.velocity.z != 0.0 {
        MotionState::Airborne
    } else {
        motion::classify(state.velocity, state.angular_velocity, radius)
    }
}

fn check_length(
    place: impl FnOnce() -> String,
    v: Vec3,
    most: f64,
    unit: &str,
) -> Result<(), Error> {
    let length = v.length();
    if length <= most {
        return Ok(());
    }
    let remedy = format!("write at most {most} {unit}");
    Err(ErrorKind::OutOfRange.at(place(), format!("{length:?} {unit} is out of range"), remedy))
}

/// Refuses pairs that overlap by more than [`TOUCH_TOLERANCE`].
fn check_overlaps(balls: &[PlacedBall]) -> Result<(), Error> {
    // Only neighbours in the order along x can overlap.
    let mut order: Vec<usize> = (0..balls.len()).collect();
    let left = |i: usize| balls[i].state.position.x - balls[i].ball.radius;
    order.sort_by(|&i, &j| left(i).total_cmp(&left(j)));
    let mut found: Option<(usize, usize)> = None;
    for (k, &i) in order.iter().enumerate() {
        let right = balls[i].state.position.x + balls[i].ball.radius;
        for &j in order[k + 1..].iter().take_while(|&&j| left(j) < right) {
            if depth(&balls[i], &balls[j]) > TOUCH_TOLERANCE {
                let pair = (i.max(j), i.min(j));
                found = Some(found.map_or(pair, |f| f.min(pair)));
            }
        }
    }
    let Some((later, first)) = found else { return Ok(()) };
    Err(ErrorKind::Overlap
        .at(
            format!("balls[{later}].position"),
            format!(
                "ball \"{}\" overlaps balls[{first}] (\"{}\") by {:.3e} m",
                balls[later].id,
                balls[first].id,
                depth(&balls[later], &balls[first]),
            ),
            format!(
                "put their centres at least {:?} m apart",
                balls[later].ball.radius + balls[first].ball.radius
            ),
        )
        .with("ball", &*balls[later].id)
        .with("other", &*balls[first].id)
        .with("depth", depth(&balls[later], &balls[first])))
}

fn depth(a: &PlacedBall, b: &PlacedBall) -> f64 {
    let d = b.state.position - a.state.position;
    a.ball.radius + b.ball.radius - sqrt(d.length_squared())
}
