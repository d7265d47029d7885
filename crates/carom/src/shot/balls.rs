//! The `balls` of a shot file, and whether they can lie where it says.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::PlacedBall;
use super::physics::{MASS, RADIUS};
use super::read::At;
use crate::error::Error;
use crate::limits::MAX_BALLS;
use crate::math::{Vec3, sqrt};
use crate::table::TOUCH_TOLERANCE;
use crate::{Ball, BallState, MotionState, Table, motion};

/// Balls faster than this do not occur (the fastest breaks are near 15 m/s), m/s.
const LARGEST_SPEED: f64 = 100.0;
/// A tip at the miscue limit gives a ball of 30 m/s about 1300 rad/s; rad/s.
const LARGEST_SPIN: f64 = 10_000.0;

const KEYS: &[&str] = &["id", "position", "velocity", "angular_velocity", "mass", "radius"];

/// Reads `balls`; `default` is the physics' ball.
pub(super) fn read(at: &At<'_>, default: &Ball, table: &Table) -> Result<Vec<PlacedBall>, Error> {
    let items = at.items("a list of balls")?;
    check_count(items.len())?;
    let balls = items.iter().map(|item| read_one(item, default)).collect::<Result<Vec<_>, _>>()?;
    check(&balls, table)?;
    Ok(balls)
}

pub(super) fn check_count(count: usize) -> Result<(), Error> {
    if (1..=MAX_BALLS).contains(&count) {
        return Ok(());
    }
    let remedy = format!("write between 1 and {MAX_BALLS}");
    Err(Error::input("balls", format!("found {count} balls"), remedy))
}

/// Refuses ids that are not unique, balls that are not inside the table, and overlaps.
pub(super) fn check(balls: &[PlacedBall], table: &Table) -> Result<(), Error> {
    for (i, ball) in balls.iter().enumerate() {
        if let Some(first) = balls[..i].iter().position(|b| b.id == ball.id) {
            return Err(Error::input(
                format!("balls[{i}].id"),
                format!("\"{}\" is already the id of balls[{first}]", ball.id),
                "give every ball its own id",
            ));
        }
    }
    for (i, ball) in balls.iter().enumerate() {
        super::place::check(i, ball, table)?;
    }
    check_overlaps(balls)
}

/// Whether ball `index` is inside the table and in no other ball.
pub(crate) fn fits(index: usize, balls: &[PlacedBall], table: &Table) -> bool {
    let ball = &balls[index];
    let mut others = balls.iter().enumerate().filter(|(i, _)| *i != index);
    others.all(|(_, other)| depth(ball, other) <= TOUCH_TOLERANCE)
        && super::place::check(index, ball, table).is_ok()
}

fn read_one(at: &At<'_>, default: &Ball) -> Result<PlacedBall, Error> {
    let fields = at.fields(KEYS)?;
    let id = fields.require("id", "a text that no other ball has")?;
    let id = String::from(id.text("a text that no other ball has")?);
    let mut ball = *default;
    fields.number_into("mass", &MASS, &mut ball.mass)?;
    fields.number_into("radius", &RADIUS, &mut ball.radius)?;

    let at = fields.require("position", "[x, y] in m")?;
    let p = at.numbers(2, 3)?;
    let height =
        height(|| at.place().into(), p.get(2).copied().unwrap_or(ball.radius), ball.radius)?;

    let position = Vec3::new(p[0], p[1], height);
    let mut state = BallState { position, ..BallState::default() };
    if let Some(at) = fields.get("velocity") {
        state.velocity = at.vector()?;
        check_length(|| at.place().into(), state.velocity, LARGEST_SPEED, "m/s")?;
    }
    if let Some(at) = fields.get("angular_velocity") {
        state.angular_velocity = at.vector()?;
        check_length(|| at.place().into(), state.angular_velocity, LARGEST_SPIN, "rad/s")?;
    }
    state.motion = motion(&state, ball.radius);
    Ok(PlacedBall { id, ball, state })
}

/// The height of a centre, m: exactly the radius where it is that but for [`TOUCH_TOLERANCE`], so
/// that a ball either lies on the bed or does not.
pub(super) fn height(place: impl FnOnce() -> String, z: f64, radius: f64) -> Result<f64, Error> {
    if z < radius - TOUCH_TOLERANCE {
        return Err(Error::input(
            place(),
            format!(
                "the ball is {} m deep in the slate: z = {z:?}, its radius {radius:?} m",
                radius - z
            ),
            "leave z out, write the radius, or more for a ball in the air",
        ));
    }
    Ok(if z > radius + TOUCH_TOLERANCE { z } else { radius })
}

/// The motion state that a ball begins in.
pub(super) fn motion(state: &BallState, radius: f64) -> MotionState {
    // Driven down on the bed counts as flying too: it bounces at once.
    if state.position.z > radius || state.velocity.z != 0.0 {
        MotionState::Airborne
    } else {
        motion::classify(state.velocity, state.angular_velocity, radius)
    }
}

/// Refuses velocities that are no numbers or out of range, of `balls[index]`.
pub(super) fn check_speeds(index: usize, state: &BallState) -> Result<(), Error> {
    let place = |key: &'static str| move || format!("balls[{index}].{key}");
    check_length(place("velocity"), state.velocity, LARGEST_SPEED, "m/s")?;
    check_length(place("angular_velocity"), state.angular_velocity, LARGEST_SPIN, "rad/s")
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
    Err(Error::input(place(), format!("{length:?} {unit} is out of range"), remedy))
}

/// Refuses pairs that are deeper in one another than touching.
fn check_overlaps(balls: &[PlacedBall]) -> Result<(), Error> {
    // Sorted along x, only neighbours can overlap.
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
    Err(Error::input(
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
    ))
}

fn depth(a: &PlacedBall, b: &PlacedBall) -> f64 {
    let d = b.state.position - a.state.position;
    a.ball.radius + b.ball.radius - sqrt(d.length_squared())
}
