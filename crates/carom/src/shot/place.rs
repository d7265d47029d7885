//! Refusing a ball that is not inside the table, in words.

use alloc::format;
use alloc::string::String;

use super::PlacedBall;
use crate::error::Error;
use crate::table::{Placement, Table, nose_reach};

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
    let refuse =
        |what: String, remedy: String| Err(Error::input(format!("{place}.position"), what, remedy));
    let position = table.to_engine_frame(&placed.state).position.xy();
    match table.place_check(position, radius) {
        Placement::Inside | Placement::TouchesCushion { .. } => Ok(()),
        Placement::InCushion { part, depth } => {
            let part = &table.cushions[usize::from(part)];
            refuse(
                format!(
                    "the ball is {depth:.3e} m deep in the {} of the {} cushion",
                    part.part.name(),
                    part.rail.name()
                ),
                format!("keep its centre at least {reach:.6} m from every nose line"),
            )
        }
        Placement::OverHole { pocket } => refuse(
            format!(
                "the ball stands over the {} pocket",
                table.pockets[usize::from(pocket)].name.name()
            ),
            "move it onto the cloth".into(),
        ),
        Placement::Outside => refuse(
            "the ball is outside the table".into(),
            format!(
                "keep x in [{reach:.6}, {:.6}] and y in [{reach:.6}, {:.6}] m",
                table.size.x - reach,
                table.size.y - reach
            ),
        ),
    }
}
