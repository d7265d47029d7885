//! Checks that a description makes a table.

use alloc::format;

use super::pocket_kind::PocketKind;
use super::{Capture, Pocket, PocketDescription, TableDescription, TableError};
use crate::math::Vec2;

fn positive(key: &str, value: f64) -> Result<(), TableError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(TableError::new(key, format!("is {value}, but must be a finite number of metres above 0")))
}

/// Checks the sizes of the whole table.
pub(super) fn lengths(d: &TableDescription) -> Result<(), TableError> {
    positive("width", d.width)?;
    positive("length", d.length)?;
    positive("cushion_height", d.cushion_height)?;
    positive("cushion_width", d.cushion_width)?;
    if !(d.rail_width.is_finite() && d.rail_width >= d.cushion_width) {
        let problem = format!(
            "is {}, but the rail includes the cushion: make it at least {} (cushion_width)",
            d.rail_width, d.cushion_width
        );
        return Err(TableError::new("rail_width", problem));
    }
    Ok(())
}

/// The pocket of this kind, with its own figures checked.
pub(super) fn pocket(
    description: &Option<PocketDescription>,
    kind: PocketKind,
) -> Result<&PocketDescription, TableError> {
    let key = kind.key();
    let Some(pocket) = description else {
        let problem =
            "is missing: describe it, name a \"base\" that has it, or set pockets to \"none\"";
        return Err(TableError::new(key, problem));
    };
    let at = |field: &str| format!("{key}.{field}");
    positive(&at("mouth"), pocket.mouth)?;
    positive(&at("hole_radius"), pocket.hole_radius)?;
    if let Some(throat) = pocket.throat {
        positive(&at("throat"), throat)?;
    }
    if !(pocket.point_radius.is_finite() && pocket.point_radius >= 0.0) {
        let problem = format!("is {}, but must be 0 (sharp) or more metres", pocket.point_radius);
        return Err(TableError::new(at("point_radius"), problem));
    }
    if !(pocket.cut_angle_deg >= 90.0 && pocket.cut_angle_deg < 180.0) {
        let problem = format!(
            "is {}, but the angle between nose and facing must be at least 90 and below 180 degrees",
            pocket.cut_angle_deg
        );
        return Err(TableError::new(at("cut_angle_deg"), problem));
    }
    let least = match kind {
        PocketKind::Corner => 0.5 * pocket.mouth - pocket.hole_radius,
        PocketKind::Side => -pocket.hole_radius,
    };
    if !(pocket.shelf.is_finite() && pocket.shelf >= least) {
        let problem = format!(
            "is {}, which puts the middle of the hole into the playing area: make it at least {least}",
            pocket.shelf
        );
        return Err(TableError::new(at("shelf"), problem));
    }
    Ok(pocket)
}

/// Checks a jaw. `deep` is its deep end in the coordinates of its rail (along, behind);
/// `round_all_through` says that it has no facing.
pub(super) fn jaw(
    shape: &PocketDescription,
    kind: PocketKind,
    rubber: f64,
    round_all_through: bool,
    deep: [f64; 2],
) -> Result<(), TableError> {
    let key = kind.key();
    if round_all_through && shape.throat.is_some() {
        let problem = "has no facing to move, as the point is rounded through the whole cushion: \
                       leave it out, or make point_radius smaller";
        return Err(TableError::new(format!("{key}.throat"), problem));
    }
    let open = match kind {
        PocketKind::Corner => deep[0] + rubber > 0.0,
        PocketKind::Side => deep[0] > 0.0,
    };
    if !open {
        let problem = "is so small that the facings meet before they end: widen it, or make \
                       cut_angle_deg or cushion_width smaller";
        return Err(TableError::new(format!("{key}.mouth"), problem));
    }
    Ok(())
}

/// Checks the back of a pocket: the hole is as wide as the facings are apart (`wide`), its back
/// lies behind the deep ends (`deep`), and the facings' lines reach that back before they meet
/// (`open`).
pub(super) fn liner(
    kind: PocketKind,
    wide: bool,
    deep: bool,
    open: bool,
) -> Result<(), TableError> {
    let (field, problem) = if !wide {
        (
            "hole_radius",
            "leaves slate between the hole and the facings' lines, where nothing closes the pocket: make \
             it larger, or mouth or throat smaller",
        )
    } else if !deep {
        (
            "hole_radius",
            "ends the hole in front of the facings' deep ends: make it or shelf larger, or cushion_width \
             smaller",
        )
    } else if !open {
        (
            "cut_angle_deg",
            "lets the facings' lines meet before the back of the hole: make it smaller, or mouth or \
             throat larger",
        )
    } else {
        return Ok(());
    };
    Err(TableError::new(format!("{}.{field}", kind.key()), problem))
}

/// Checks that straight noses remain between the points.
pub(super) fn noses(nose_x: f64, nose_y: [f64; 2]) -> Result<(), TableError> {
    let remedy = "make mouth or point_radius smaller, or the table larger";
    if nose_x <= 0.0 {
        let problem = format!("leaves no straight nose on the short rails: {remedy}");
        return Err(TableError::new("corner_pocket.mouth", problem));
    }
    if nose_y[0] >= nose_y[1] {
        let problem =
            format!("and corner_pocket.mouth leave no straight nose between them: {remedy}");
        return Err(TableError::new("side_pocket.mouth", problem));
    }
    Ok(())
}

/// Checks that the holes do not overlap.
pub(super) fn holes(pockets: &[Pocket]) -> Result<(), TableError> {
    let overlap = |a: &Pocket, b: &Pocket| {
        let apart: Vec2 = a.center - b.center;
        apart.length() <= a.radius + b.radius
    };
    for (i, a) in pockets.iter().enumerate() {
        for b in &pockets[i + 1..] {
            if overlap(a, b) {
                let problem = format!(
                    "makes the holes {} and {} overlap: make the holes smaller or the table larger",
                    a.name.name(),
                    b.name.name()
                );
                let of_side = b.axis.y == 0.0 || a.axis.y == 0.0;
                let key = if of_side { "side_pocket" } else { "corner_pocket" };
                return Err(TableError::new(format!("{key}.hole_radius"), problem));
            }
        }
    }
    Ok(())
}

/// Checks that the rails are wide enough for the holes.
pub(super) fn rails(border: Vec2, half: Vec2, pockets: &[Pocket]) -> Result<(), TableError> {
    let drops = |p: &&Pocket| matches!(p.capture, Capture::DropCircle);
    for pocket in pockets.iter().filter(drops) {
        let x = pocket.center.x.abs() + pocket.radius;
        let y = pocket.center.y.abs() + pocket.radius;
        if x >= border.x || y >= border.y {
            let problem = format!(
                "is too narrow for the hole {}: make it more than {}, or the hole smaller",
                pocket.name.name(),
                (x - half.x).max(y - half.y)
            );
            return Err(TableError::new("rail_width", problem));
        }
    }
    Ok(())
}
