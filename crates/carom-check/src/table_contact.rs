//! The distance and direction from a ball to the part of the table that it touches in an event.

use carom::math::{Vec2, Vec3};

use crate::solid::{Solid, SolidPiece};
use crate::table::EdgeLine;

/// The contact of a ball with a part of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TableContact {
    /// Distance of the ball from the part, m; negative for an overlap.
    pub(crate) gap: f64,
    /// Unit vector from the touched point to the ball's centre.
    pub(crate) away: Vec3,
}

/// Straight parts may be touched this far beyond their ends, m, since they join round parts
/// tangentially.
const JOIN: f64 = 1e-6;

/// A ball of radius `radius` (m) with its centre at `c`, and part `k` of the table.
pub(crate) fn rail(solid: &Solid, k: usize, c: Vec3, radius: f64) -> Option<TableContact> {
    let (_, _, line) = solid.plan.parts.get(k)?;
    let rise = c.z - solid.height;
    match *line {
        EdgeLine::Flat => {
            let over = solid.beside_tops(c.xy());
            let gap = if over > 0.0 { over } else { rise - radius };
            Some(TableContact { gap, away: Vec3::new(0.0, 0.0, 1.0) })
        }
        EdgeLine::Straight { start, end, normal } => {
            let (from_start, along) = (c.xy() - start, end - start);
            let length = along.length();
            let s = from_start.dot(along) / length;
            let beside = (-s).max(s - length);
            let edge = edge(from_start.dot(normal), normal, rise, radius);
            Some(if beside > JOIN { TableContact { gap: beside, ..edge } } else { edge })
        }
        EdgeLine::Round { center, radius: bend, .. } => {
            let d = c.xy() - center;
            let length = d.length();
            let out = if length > 0.0 { d * (1.0 / length) } else { Vec2::ZERO };
            Some(edge(length - bend, out, rise, radius))
        }
        EdgeLine::Wall { .. } => liner(solid, c, radius),
    }
}

/// The contact with an edge at the distance `level` in plan in the direction −`normal`, and `rise`
/// below the ball's centre. The surface under the edge recedes so far that centres can reach the
/// edge's line.
fn edge(level: f64, normal: Vec2, rise: f64, radius: f64) -> TableContact {
    if rise < -radius {
        return TableContact { gap: level, away: normal.with_z(0.0) };
    }
    let distance = (level * level + rise * rise).sqrt();
    let away = (normal * level).with_z(rise) * (1.0 / distance);
    TableContact { gap: distance - radius, away }
}

/// The nearest of the liners.
fn liner(solid: &Solid, c: Vec3, radius: f64) -> Option<TableContact> {
    let liners = solid.rails.iter().filter(|part| matches!(part.piece, SolidPiece::Liner { .. }));
    let nearest = liners.map(|part| part.piece.distance(c));
    let nearest = nearest.min_by(|a, b| a.value.total_cmp(&b.value))?;
    Some(TableContact { gap: nearest.value - radius, away: nearest.away })
}

/// A ball and the bed or the edge of a hole in it.
pub(crate) fn slate(solid: &Solid, c: Vec3, radius: f64) -> TableContact {
    let distance = solid.bed.piece.distance(c);
    TableContact { gap: distance.value - radius, away: distance.away }
}
