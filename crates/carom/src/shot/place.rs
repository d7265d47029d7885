//! Errors for balls that are not inside the table.

use alloc::format;
use alloc::string::String;

use super::PlacedBall;
use crate::MotionState;
use crate::error::{Error, ErrorKind};
use crate::math::{Vec2, Vec3};
use crate::table::{Capture, Placement, Pocket, Table, nose_reach};

/// Refuses a ball that is not inside the table ([`Table::place_check`], [`Table::place_in_air`]).
/// `index` is its index in `balls`.
pub(super) fn check(index: usize, placed: &PlacedBall, table: &Table) -> Result<(), Error> {
    if !table.size.x.is_finite() {
        return Ok(());
    }
    let radius = placed.ball.radius;
    if nose_reach(table.cushion_height, radius).is_none() {
        return Err(ErrorKind::WrongRadius.at(
            format!("balls[{index}].radius"),
            format!(
                "a ball of radius {radius:?} m cannot meet a cushion nose at the height of {:?} m",
                table.cushion_height
            ),
            format!(
                "choose a radius of more than {:?} m, or a lower table.cushion_height",
                0.5 * table.cushion_height
            ),
        ));
    }
    let too_narrow = |p: &&Pocket| matches!(p.capture, Capture::DropCircle) && p.radius <= radius;
    if let Some(pocket) = table.pockets.iter().find(too_narrow) {
        return Err(ErrorKind::WrongRadius.at(format!("balls[{index}].radius"),
            format!(
                "a ball of radius {radius:?} m cannot fall into the {} pocket, whose hole has the radius \
                 {:?} m",
                pocket.name.name(),
                pocket.radius
            ),
            "choose a smaller ball, or a larger hole_radius of the table's pockets",
        ));
    }
    let position = table.to_engine_coordinates(&placed.state).position;
    let problem = if placed.state.motion == MotionState::Airborne {
        in_the_air(table, position, radius)
    } else {
        on_the_cloth(table, position.xy(), radius)
    };
    problem.map_or(Ok(()), |error| Err(error.at(format!("balls[{index}].position"))))
}

/// Whether [`check`] accepts the place of a ball whose radius it has accepted on this table.
pub(super) fn is_inside(placed: &PlacedBall, table: &Table) -> bool {
    if !table.size.x.is_finite() {
        return true;
    }
    let (position, radius) =
        (table.to_engine_coordinates(&placed.state).position, placed.ball.radius);
    let placement = if placed.state.motion == MotionState::Airborne {
        table.place_in_air(position, radius)
    } else {
        table.place_check(position.xy(), radius)
    };
    placement.is_inside()
}

/// What is wrong; its place is filled in later.
type Problem = Option<Error>;

fn on_the_cloth(table: &Table, position: Vec2, radius: f64) -> Problem {
    let reach = table.reach(radius);
    match table.place_check(position, radius) {
        Placement::Inside | Placement::TouchesCushion { .. } => None,
        Placement::InCushion { part, depth } => Some(deep_in(
            table,
            part,
            depth,
            format!("keep its centre at least {reach:.6} m from every nose line"),
        )),
        Placement::OverHole { pocket } => {
            Some(over(table, pocket, "move it onto the cloth".into()))
        }
        Placement::Outside => Some(outside(table, "the ball is outside the table", -reach)),
    }
}

fn in_the_air(table: &Table, position: Vec3, radius: f64) -> Problem {
    let top = table.cushion_height + radius;
    match table.place_in_air(position, radius) {
        Placement::Inside | Placement::TouchesCushion { .. } => None,
        Placement::InCushion { part, depth } => Some(deep_in(
            table,
            part,
            depth,
            format!("move it away from there, or raise it above the rails, to z ≥ {top:.6} m"),
        )),
        Placement::OverHole { pocket } => Some(over(
            table,
            pocket,
            format!("move it over the cloth, or raise it above the rails, to z ≥ {top:.6} m"),
        )),
        Placement::Outside => {
            let rail = table.description.as_ref().map_or(0.0, |d| d.rail_width);
            Some(outside(table, "the ball is beyond the rails", rail))
        }
    }
}

fn deep_in(table: &Table, part: u16, depth: f64, remedy: String) -> Error {
    let part = &table.cushions[usize::from(part)];
    let (name, rail) = (part.part.name(), part.rail.name());
    let what = format!("the ball is {depth:.3e} m deep in the {name} of the {rail} cushion");
    ErrorKind::InCushion
        .at("", what, remedy)
        .with("rail", rail)
        .with("part", name)
        .with("depth", depth)
}

fn over(table: &Table, pocket: u8, remedy: String) -> Error {
    let name = table.pockets[usize::from(pocket)].name.name();
    let what = format!("the ball stands over the {name} pocket");
    ErrorKind::OverPocket.at("", what, remedy).with("pocket", name)
}

/// The remedy is to stay within the playing area, widened on all sides by `margin` (m).
fn outside(table: &Table, what: &str, margin: f64) -> Error {
    let least = -margin;
    let remedy = format!(
        "keep x in [{least:.6}, {:.6}] and y in [{least:.6}, {:.6}] m",
        table.size.x + margin,
        table.size.y + margin
    );
    ErrorKind::OutsideTable.at("", what, remedy)
}
