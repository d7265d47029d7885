//! The edges and walls that a ball off the bed can touch, at the point of contact.

use crate::math::{Vec2, Vec3};
use crate::resolve::ball_edge::Edge;
use crate::table::TableGeometry;
use crate::table::{Shape, TableFeature};

/// The lip of a hole, where a ball with its centre at `position` (m) touches it.
pub(super) fn lip_edge(table: &TableGeometry, pocket: u8, position: Vec3, radius: f64) -> Edge {
    let normal = table.contact_normal(TableFeature::Lip(pocket), position, radius);
    round(normal, position, table.pockets[usize::from(pocket)].center, radius)
}

/// The edge or wall of a part of the cushions, where a ball with its centre at `position` (m)
/// touches it.
pub(super) fn cushion_edge(table: &TableGeometry, part: u16, position: Vec3, radius: f64) -> Edge {
    let normal = table.contact_normal(TableFeature::Cushion(part), position, radius);
    match table.cushions[usize::from(part)].shape {
        Shape::Segment { normal: across, .. } => straight(normal, across.perp(), radius),
        Shape::Arc { center, .. } | Shape::Hollow { center, .. } => {
            round(normal, position, center, radius)
        }
        Shape::Plane { .. } => straight(normal, Vec2::ZERO, radius),
    }
}

fn straight(normal: Vec3, along: Vec2, radius: f64) -> Edge {
    Edge { normal, along, bend: 0.0, turn: turn(normal, radius) }
}

fn round(normal: Vec3, position: Vec3, center: Vec2, radius: f64) -> Edge {
    let from_center = position.xy() - center;
    let distance = from_center.length();
    if distance == 0.0 {
        return straight(normal, Vec2::ZERO, radius);
    }
    let outwards = from_center * (1.0 / distance);
    let bend = normal.xy().dot(outwards) / distance;
    Edge { normal, along: outwards.perp(), bend, turn: turn(normal, radius) }
}

/// A ball turns about an edge, but slides along an upright wall.
fn turn(normal: Vec3, radius: f64) -> f64 {
    if normal.z == 0.0 { 0.0 } else { 1.0 / radius }
}
