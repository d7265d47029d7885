//! Errors for balls that are not inside the table.

use alloc::format;
use alloc::string::String;

use super::PlacedBall;
use crate::MotionState;
use crate::error::Error;
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
        return Err(Error::input(
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
        return Err(Error::input(
            format!("balls[{index}].radius"),
            format!(
                "a ball of radius {radius:?} m cannot fall into the {} pocket, whose hole has the radius \
                 {:?} m",
                pocket.name.name(),
                pocket.radius
            ),
            "choose a smaller ball, or a larger hole_radius of the table's pockets",
        ));
    }
    let position = table.to_engine_frame(&placed.state).position;
    let problem = if placed.state.motion == MotionState::Airborne {
        in_the_air(table, position, radius)
    } else {
        on_the_cloth(table, position.xy(), radius)
    };
    problem.map_or(Ok(()), |(what, remedy)| {
        Err(Error::input(format!("balls[{index}].position"), what, remedy))
    })
}

/// Whether [`check`] accepts the place of a ball whose radius it has accepted on this table.
pub(super) fn is_inside(placed: &PlacedBall, table: &Table) -> bool {
    if !table.size.x.is_finite() {
        return true;
    }
    let (position, radius) = (table.to_engine_frame(&placed.state).position, placed.ball.radius);
    let placement = if placed.state.motion == MotionState::Airborne {
        table.place_in_air(position, radius)
    } else {
        table.place_check(position.xy(), radius)
    };
    placement.is_inside()
}

/// What is wrong, and the remedy.
type Problem = Option<(String, String)>;

fn on_the_cloth(table: &Table, position: Vec2, radius: f64) -> Problem {
    let reach = table.reach(radius);
    match table.place_check(position, radius) {
        Placement::Inside | Placement::TouchesCushion { .. } => None,
        Placement::InCushion { part, depth } => Some((
            deep_in(table, part, depth),
            format!("keep its centre at least {reach:.6} m from every nose line"),
        )),
        Placement::OverHole { pocket } => {
            Some((over(table, pocket), "move it onto the cloth".into()))
        }
        Placement::Outside => {
            Some(("the ball is outside the table".into(), keep_within(table, -reach)))
        }
    }
}

fn in_the_air(table: &Table, position: Vec3, radius: f64) -> Problem {
    let top = table.cushion_height + radius;
    match table.place_in_air(position, radius) {
        Placement::Inside | Placement::TouchesCushion { .. } => None,
        Placement::InCushion { part, depth } => Some((
            deep_in(table, part, depth),
            format!("move it away from there, or raise it above the rails, to z ≥ {top:.6} m"),
        )),
        Placement::OverHole { pocket } => Some((
            over(table, pocket),
            format!("move it over the cloth, or raise it above the rails, to z ≥ {top:.6} m"),
        )),
        Placement::Outside => {
            let rail = table.description.as_ref().map_or(0.0, |d| d.rail_width);
            Some(("the ball is beyond the rails".into(), keep_within(table, rail)))
        }
    }
}

fn deep_in(table: &Table, part: u16, depth: f64) -> String {
    let part = &table.cushions[usize::from(part)];
    let (name, rail) = (part.part.name(), part.rail.name());
    format!("the ball is {depth:.3e} m deep in the {name} of the {rail} cushion")
}

fn over(table: &Table, pocket: u8) -> String {
    format!("the ball stands over the {} pocket", table.pockets[usize::from(pocket)].name.name())
}

/// The remedy: stay within the playing area, widened on all sides by `margin` (m).
fn keep_within(table: &Table, margin: f64) -> String {
    let least = -margin;
    format!(
        "keep x in [{least:.6}, {:.6}] and y in [{least:.6}, {:.6}] m",
        table.size.x + margin,
        table.size.y + margin
    )
}
