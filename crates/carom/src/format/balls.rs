//! The `balls` of a shot file.

use alloc::string::String;
use alloc::vec::Vec;

use super::node::Node;
use super::read::At;
use crate::ball::{MASS, RADIUS};
use crate::error::{Error, ErrorKind};
use crate::math::Vec3;
use crate::shot::PlacedBall;
use crate::{Ball, BallState};

const KEYS: &[&str] =
    &["id", "position", "velocity", "angular_velocity", "rolling", "mass", "radius"];

/// Reads `balls`; `default` is the physics' ball. Whether they have room on the table is checked
/// afterwards.
pub(super) fn read(at: &At<'_>, default: &Ball) -> Result<Vec<PlacedBall>, Error> {
    at.items("a list of balls")?.iter().map(|item| read_one(item, default)).collect()
}

fn read_one(at: &At<'_>, default: &Ball) -> Result<PlacedBall, Error> {
    let fields = at.fields(KEYS)?;
    let id = fields.require("id", "a text that no other ball has")?;
    let id = String::from(id.text("a text that no other ball has")?);
    let mut ball = *default;
    fields.number_into("mass", &MASS, &mut ball.mass)?;
    fields.number_into("radius", &RADIUS, &mut ball.radius)?;

    let p = fields.require("position", "[x, y] in m")?.numbers(2, 3)?;
    let position = Vec3::new(p[0], p[1], p.get(2).copied().unwrap_or(ball.radius));
    let mut state = BallState { position, ..BallState::default() };
    if let Some(at) = fields.get("velocity") {
        state.velocity = at.vector()?;
    }
    if let Some(at) = fields.get("angular_velocity") {
        state.angular_velocity = at.vector()?;
    }
    if let Some(at) = fields.get("rolling")
        && at.flag()?
    {
        if fields.get("angular_velocity").is_some() {
            let what = "a rolling ball's spin follows from its velocity";
            return Err(at.refuse(
                ErrorKind::Conflict,
                what,
                "remove angular_velocity, or rolling",
            ));
        }
        if fields.get("velocity").is_none() {
            return Err(at.refuse(
                ErrorKind::Missing,
                "the ball has no velocity",
                "write its velocity, [x, y, 0] in m/s",
            ));
        }
        state.angular_velocity = rolling_spin(state.velocity, ball.radius);
    }
    Ok(PlacedBall { id, ball, state })
}

/// The spin (rad/s) with which a ball of radius `radius` (m) rolls at `velocity` (m/s): the point that
/// touches the cloth is at rest, so ω = ẑ × v/R.
fn rolling_spin(velocity: Vec3, radius: f64) -> Vec3 {
    Vec3::new(0.0 - velocity.y / radius, velocity.x / radius, 0.0)
}

/// A ball as a shot file has it; `default` is the physics' ball.
pub(super) fn write(placed: &PlacedBall, default: &Ball) -> Node {
    let PlacedBall { id, ball, state } = placed;
    let [x, y, z] = state.position.to_array();
    let position = if z == ball.radius { Node::from([x, y]) } else { Node::list([x, y, z]) };
    let mut node = Node::object([("id", id.into()), ("position", position)]);
    for (key, value) in [("velocity", state.velocity), ("angular_velocity", state.angular_velocity)]
    {
        if value != Vec3::ZERO {
            node.set(key, Node::list(value.to_array()));
        }
    }
    for (key, value, default) in
        [("mass", ball.mass, default.mass), ("radius", ball.radius, default.radius)]
    {
        if value != default {
            node.set(key, value);
        }
    }
    node
}
