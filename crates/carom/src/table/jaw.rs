//! One jaw of a pocket: point and facing.
//!
//! A jaw is built in coordinates of its own rail: `along` the nose line from the pocket's middle
//! (the corner, or the middle of a long rail), and `behind` it:
//!
//! ```text
//!                tip      nose line
//!   pocket  .    +╌╌╌╌╭───────────────  along →
//!            .     ╲ │   φ = 180° − cut angle
//!             .     ╲╯ ← point, tangent to both
//!              .     ╲
//!               .     ╲ facing          behind ↓
//!                      + deep end, `cushion_width` behind the nose line
//! ```
//!
//! With tip T, point radius r and turn φ, the point's centre is r behind the nose line and
//! r·tan(φ/2) further along than T. The arc is tangent to the nose there, and to the facing at the
//! same distance from T.

use alloc::vec::Vec;
use core::f64::consts::FRAC_1_SQRT_2;

use super::pocket_kind::PocketKind;
use super::{Part, PocketDescription, Shape, TableError, check};
use crate::math::{Vec2, radians, sin_cos, sqrt, tan};

/// One jaw of the pocket in the quadrant x ≤ 0, y ≤ 0.
pub(super) struct Jaw {
    pub(super) kind: PocketKind,
    pub(super) rail: RailFrame,
    /// Tip, m.
    pub(super) tip: Vec2,
    /// Deep end of the facing, m.
    pub(super) deep: Vec2,
    /// Unit normal of the facing, towards the pocket's axis.
    pub(super) facing_normal: Vec2,
    /// Unit vector along the facing, away from the nose.
    pub(super) down: Vec2,
    /// Radius of the point, m.
    pub(super) point_radius: f64,
    /// Depth behind the nose line at which the point ends, m.
    pub(super) point_end: f64,
    /// The parts that a ball can touch, from nose to deep end.
    pub(super) parts: Vec<(Part, Shape)>,
    /// The end of the straight nose at this jaw, m.
    pub(super) nose_end: Vec2,
    /// Distance of that end along the rail from the pocket's middle, m.
    pub(super) nose_start: f64,
    /// The deep end along the rail and behind it, m.
    pub(super) deep_in_rail: [f64; 2],
}

/// Coordinates along and behind a nose line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(super) struct RailFrame {
    /// The pocket's middle on the nose line, m.
    pub(super) origin: Vec2,
    /// Away from the pocket.
    pub(super) along: Vec2,
    /// Into the rubber.
    pub(super) behind: Vec2,
}

impl RailFrame {
    fn point(&self, [along, behind]: [f64; 2]) -> Vec2 {
        self.origin + self.direction([along, behind])
    }
    fn direction(&self, [along, behind]: [f64; 2]) -> Vec2 {
        self.along * along + self.behind * behind
    }
}

/// φ, the angle between the nose and the facing, rad.
fn turn(shape: &PocketDescription) -> f64 {
    radians(180.0 - shape.cut_angle_deg)
}

/// Distance from a tip to the beginning of the rounding, on either side, m.
pub(super) fn tangent_length(shape: &PocketDescription) -> f64 {
    shape.point_radius * tan(0.5 * turn(shape))
}

/// Distance along the pocket's axis from the middle of the pocket on the nose line (the corner, or
/// the middle of the rail) to the hole's centre, m.
fn hole_depth(shape: &PocketDescription, kind: PocketKind) -> f64 {
    match kind {
        // The mouth lies in front of the corner.
        PocketKind::Corner => shape.shelf + shape.hole_radius - 0.5 * shape.mouth,
        PocketKind::Side => shape.shelf + shape.hole_radius,
    }
}

/// The centre of the hole of the quadrant's pocket, m.
pub(super) fn hole_center(shape: &PocketDescription, kind: PocketKind, half: Vec2) -> Vec2 {
    kind.middle(half) + kind.axis() * hole_depth(shape, kind)
}

/// The jaw of `shape` on the rail whose frame is `rail`.
pub(super) fn jaw(
    shape: &PocketDescription,
    kind: PocketKind,
    rubber: f64,
    rail: RailFrame,
) -> Result<Jaw, TableError> {
    let radius = shape.point_radius;
    let tip = match kind {
        PocketKind::Corner => shape.mouth * FRAC_1_SQRT_2,
        PocketKind::Side => 0.5 * shape.mouth,
    };
    let nose_start = tip + tangent_length(shape);
    let (mut sin, mut cos) = sin_cos(turn(shape));
    let round_all_through = radius * (1.0 - cos) >= rubber;
    if round_all_through {
        // The rubber ends before the arc has turned by φ: there is no facing.
        cos = 1.0 - rubber / radius;
        sin = sqrt(1.0 - cos * cos);
    }
    let point_end = [nose_start - radius * sin, radius * (1.0 - cos)];
    let deep = match (shape.throat, kind) {
        _ if round_all_through => point_end,
        (None, _) => [tip - rubber * cos / sin, rubber],
        (Some(throat), PocketKind::Corner) => [throat * FRAC_1_SQRT_2 - rubber, rubber],
        (Some(throat), PocketKind::Side) => [0.5 * throat, rubber],
    };
    check::jaw(shape, kind, rubber, round_all_through, deep)?;

    let tangent_normal = [-sin, -cos];
    let normal = match shape.throat {
        None => tangent_normal,
        Some(_) => {
            let [x, y] = [deep[0] - point_end[0], deep[1] - point_end[1]];
            let length = sqrt(x * x + y * y);
            [-y / length, x / length]
        }
    };
    let arc = |[along, behind]: [f64; 2], radius, start, end| {
        let center = rail.point([along, behind]);
        let (start, end) = (rail.direction(start), rail.direction(end));
        (Part::Point, Shape::Arc { center, radius, start, end })
    };
    let mut parts = Vec::new();
    parts.push(arc([nose_start, radius], radius, [0.0, -1.0], tangent_normal));
    // With an explicit throat the facing is not tangent to the arc. Where that makes a convex
    // corner, the corner is a point of radius 0; in a concave one the ball touches both parts.
    if tangent_normal[1] * normal[0] - tangent_normal[0] * normal[1] > 0.0 {
        parts.push(arc(point_end, 0.0, tangent_normal, normal));
    }
    if !round_all_through {
        let facing = Shape::Segment {
            start: rail.point(point_end),
            end: rail.point(deep),
            normal: rail.direction(normal),
        };
        parts.push((Part::Facing, facing));
    }
    Ok(Jaw {
        kind,
        rail,
        tip: rail.point([tip, 0.0]),
        deep: rail.point(deep),
        facing_normal: rail.direction(normal),
        down: rail.direction([normal[1], -normal[0]]),
        point_radius: radius,
        point_end: point_end[1],
        parts,
        nose_end: rail.point([nose_start, 0.0]),
        nose_start,
        deep_in_rail: deep,
    })
}
