//! Refusing a ball that is not inside the table, in words.
//!
//! A ball in the air may be wherever it is deep in nothing: lower than the rails' tops as on the
//! cloth, but at the distance from the nose lines that belongs to its height; above them anywhere
//! within the rails' outer border. It may drop into a hole that it clears all round.

use alloc::format;
use alloc::string::String;

use super::PlacedBall;
use crate::MotionState;
use crate::error::Error;
use crate::math::{Vec2, Vec3, sqrt};
use crate::table::{Capture, Placement, Pocket, TOUCH_TOLERANCE, Table, nose_reach};

/// Refuses a ball that is not inside (see [`Table::place_check`]). `place` is the ball's own, such
/// as `balls[3]`.
pub(super) fn check(place: &str, placed: &PlacedBall, table: &Table) -> Result<(), Error> {
    if !table.size.x.is_finite() {
        return Ok(());
    }
    let radius = placed.ball.radius;
    let Some(reach) = nose_reach(table.cushion_height, radius) else {
        return Err(Error::input(
            format!("{place}.radius"),
            format!(
                "a ball of radius {radius:?} m cannot meet a cushion nose at the height of {:?} m",
                table.cushion_height
            ),
            format!(
                "choose a radius of more than {:?} m, or a lower table.cushion_height",
                0.5 * table.cushion_height
            ),
        ));
    };
    let position = table.to_engine_frame(&placed.state).position;
    let problem = if placed.state.motion == MotionState::Airborne {
        in_the_air(table, position, radius)
    } else {
        on_the_cloth(table, position.xy(), reach)
    };
    problem.map_or(Ok(()), |(what, remedy)| {
        Err(Error::input(format!("{place}.position"), what, remedy))
    })
}

/// What is wrong and what would be right.
type Problem = Option<(String, String)>;

/// What is wrong with a centre at `position` (m, engine's frame) whose surface stands out by `reach`
/// (m) at the height of the nose.
fn on_the_cloth(table: &Table, position: Vec2, reach: f64) -> Problem {
    match table.place_at(position, reach) {
        Placement::Inside | Placement::TouchesCushion { .. } => None,
        Placement::InCushion { part, depth } => {
            let part = &table.cushions[usize::from(part)];
            Some((
                format!(
                    "the ball is {depth:.3e} m deep in the {} of the {} cushion",
                    part.part.name(),
                    part.rail.name()
                ),
                format!("keep its centre at least {reach:.6} m from every nose line"),
            ))
        }
        Placement::OverHole { pocket } => {
            let name = table.pockets[usize::from(pocket)].name.name();
            Some((
                format!("the ball stands over the {name} pocket"),
                "move it onto the cloth".into(),
            ))
        }
        Placement::Outside => Some((
            "the ball is outside the table".into(),
            format!(
                "keep x in [{reach:.6}, {:.6}] and y in [{reach:.6}, {:.6}] m",
                table.size.x - reach,
                table.size.y - reach
            ),
        )),
    }
}

/// The same for a ball in the air.
fn in_the_air(table: &Table, position: Vec3, radius: f64) -> Problem {
    let (plan, above_nose) = (position.xy(), position.z - table.cushion_height);
    if above_nose >= radius - TOUCH_TOLERANCE {
        return beyond_the_border(table, plan);
    }
    let reach = sqrt(radius * radius - above_nose * above_nose);
    if let Placement::OverHole { pocket } = table.place_at(plan, reach)
        && is_clear_of_rim(&table.pockets[usize::from(pocket)], plan, reach)
    {
        return None;
    }
    on_the_cloth(table, plan, reach).map(|(what, remedy)| {
        let top = table.cushion_height + radius;
        (what, format!("{remedy}, or raise it above the rails, to z ≥ {top:?} m"))
    })
}

fn beyond_the_border(table: &Table, position: Vec2) -> Problem {
    let rail = table.description.as_ref().map_or(0.0, |d| d.rail_width);
    let beyond = |x: f64, size: f64| x.abs() > 0.5 * size + rail;
    (beyond(position.x, table.size.x) || beyond(position.y, table.size.y)).then(|| {
        (
            "the ball is beyond the rails".into(),
            format!(
                "keep x in [{:?}, {:?}] and y in [{:?}, {:?}] m",
                -rail,
                table.size.x + rail,
                -rail,
                table.size.y + rail
            ),
        )
    })
}

/// Whether a ball low over a pocket's hole touches its rim nowhere. `reach` as above.
fn is_clear_of_rim(pocket: &Pocket, position: Vec2, reach: f64) -> bool {
    matches!(pocket.capture, Capture::DropCircle)
        && (position - pocket.center).length() <= pocket.radius - reach + TOUCH_TOLERANCE
}
