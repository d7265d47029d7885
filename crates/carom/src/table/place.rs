//! Whether a ball is inside the table, and what it touches or overlaps.

use super::{Capture, CushionPart, Shape, Table, arc_sides};
use crate::math::{Vec2, Vec3, sqrt};

/// Gaps and overlaps up to this count as touching, m: 1 nm, far more than the rounding of positions
/// in a file and far less than can be measured. Deeper overlap is refused.
pub const TOUCH_TOLERANCE: f64 = 1e-9;

/// Largest distance of a ball's centre beyond the lip of a hole, in ball radii, at which rolling
/// friction may hold the ball as if it stood on the slate. A ball on the lip is less than 2e-10 m
/// lower there.
pub const LIP_OVERHANG: f64 = 1e-4;

/// Whether a ball at a position is inside the table, and what it touches or overlaps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Placement {
    /// Inside, without contact.
    Inside,
    /// Inside, touching a cushion.
    TouchesCushion {
        /// Index into `Table::cushions`.
        part: u16,
    },
    /// Overlapping a cushion.
    InCushion {
        /// Index into `Table::cushions`.
        part: u16,
        /// Depth of the overlap, m.
        depth: f64,
    },
    /// Where a pocket captures the ball.
    OverHole {
        /// Index into `Table::pockets`.
        pocket: u8,
    },
    /// Outside the table.
    Outside,
}

impl Placement {
    /// Whether a shot may start with a ball there.
    pub fn is_inside(&self) -> bool {
        matches!(self, Self::Inside | Self::TouchesCushion { .. })
    }
}

impl Table {
    /// The placement of a ball of radius `radius` (m) on the cloth with its centre at `position`
    /// (m, engine's coordinates).
    pub fn place_check(&self, position: Vec2, radius: f64) -> Placement {
        let reach = self.reach(radius);
        let half = self.index.half;
        let rubber = self.description.as_ref().map_or(0.0, |d| d.cushion_width);
        let within = |margin: f64| {
            position.x.abs() <= half.x + margin && position.y.abs() <= half.y + margin
        };
        let in_opening = self.opening_at(position).is_some();
        let (in_area, in_rails) = (within(0.0), within(rubber) || in_opening);
        // A shot may leave a ball hanging over a lip, and the next shot starts with it. Rounding
        // adds less than the tolerance.
        let overhang = LIP_OVERHANG * radius + TOUCH_TOLERANCE;
        if let Some(pocket) = self.captured_at(position, reach, overhang, in_rails) {
            return Placement::OverHole { pocket };
        }
        // No part that a ball on the cloth can touch lies inside the nose lines.
        if within(-reach - 2.0 * TOUCH_TOLERANCE) {
            return Placement::Inside;
        }
        let parts = self.parts_on_cloth().iter();
        let deepest = deepest(parts, |part| depth_in(part, position, reach, rubber));
        match deepest {
            // NaN comes here too, because every comparison with it is false.
            _ if !in_rails => Placement::Outside,
            Some((part, depth)) if depth > TOUCH_TOLERANCE => Placement::InCushion { part, depth },
            _ if !in_area && !in_opening => Placement::Outside,
            Some((part, depth)) if depth >= -TOUCH_TOLERANCE => Placement::TouchesCushion { part },
            _ => Placement::Inside,
        }
    }

    /// How deep (m, negative if apart) a ball of radius `radius` (m) on the cloth at `position` (m,
    /// engine's coordinates) is in each cushion part beside it, by index.
    pub(crate) fn depths_on_cloth(
        &self,
        position: Vec2,
        radius: f64,
    ) -> impl Iterator<Item = (usize, f64)> {
        let reach = self.reach(radius);
        let rubber = self.description.as_ref().map_or(0.0, |d| d.cushion_width);
        let parts = self.parts_on_cloth().iter().enumerate();
        parts.filter_map(move |(i, part)| Some((i, depth_in(part, position, reach, rubber)?)))
    }

    /// The pocket that has captured a ball at `position`: the centre is beyond the lip of its hole
    /// by more than `overhang` (m), or in the rails beyond its gate.
    fn captured_at(&self, position: Vec2, reach: f64, overhang: f64, in_rails: bool) -> Option<u8> {
        let holds = |i: &usize| {
            let (pocket, gate) = (&self.pockets[*i], &self.index.mouths[*i].gate);
            let from_center = position - pocket.center;
            let over_hole = matches!(pocket.capture, Capture::DropCircle)
                && from_center.length() < pocket.radius - overhang;
            let beyond = pocket.axis.dot(position) - (gate.offset + gate.lean * reach);
            let beside = pocket.axis.cross(from_center).abs();
            over_hole || (in_rails && beyond > TOUCH_TOLERANCE && beside <= gate.half_width)
        };
        (0..self.pockets.len()).find(holds).map(|i| i as u8)
    }

    /// The placement of a ball of radius `radius` (m) in the air with its centre at `position` (m,
    /// engine's coordinates), at least `radius` above the slate. A ball over a hole is inside. A
    /// ball beyond a mouth line is inside only if it is higher than the rails.
    pub fn place_in_air(&self, position: Vec3, radius: f64) -> Placement {
        let (plan, rise) = (position.xy(), self.cushion_height - position.z);
        if self.is_outside(plan) {
            return Placement::Outside;
        }
        // High enough to rest on a rail's top: it can touch no cushion.
        if rise <= TOUCH_TOLERANCE - radius {
            return Placement::Inside;
        }
        let reach = sqrt((radius * radius - rise * rise).max(0.0));
        let gone = self.captured_at(plan, reach, TOUCH_TOLERANCE, true).filter(|pocket| {
            matches!(self.pockets[usize::from(*pocket)].capture, Capture::MouthLine { .. })
        });
        if let Some(pocket) = gone {
            return Placement::OverHole { pocket };
        }
        if let Some(part) = self.top_at(plan) {
            return Placement::InCushion { part, depth: radius + rise };
        }
        let rubber = self.description.as_ref().map_or(0.0, |d| d.cushion_width);
        let depth = |part: &CushionPart| match part.shape {
            Shape::Hollow { center, radius: round, start, end } => {
                let p = plan - center;
                let beside = arc_sides(start, end).iter().all(|side| side.dot(p) >= 0.0);
                let reach = if rise > 0.0 { radius } else { reach };
                beside.then(|| p.length() + reach - round)
            }
            _ => depth_in(part, plan, reach, rubber),
        };
        match deepest(self.cushions.iter(), depth) {
            Some((part, depth)) if depth > TOUCH_TOLERANCE => Placement::InCushion { part, depth },
            Some((part, depth)) if depth >= -TOUCH_TOLERANCE => Placement::TouchesCushion { part },
            _ => Placement::Inside,
        }
    }
}

/// The part that a ball overlaps most, or the nearest one, and the depth of the overlap, m.
fn deepest<'a>(
    parts: impl Iterator<Item = &'a CushionPart>,
    depth: impl Fn(&CushionPart) -> Option<f64>,
) -> Option<(u16, f64)> {
    let mut deepest: Option<(u16, f64)> = None;
    for (i, part) in (0u16..).zip(parts) {
        let Some(depth) = depth(part) else { continue };
        if deepest.is_none_or(|(_, most)| depth > most) {
            deepest = Some((i, depth));
        }
    }
    deepest
}

/// Depth of a ball's overlap with a part, m, negative if apart; `None` if the centre lies beyond
/// the ends of the part.
fn depth_in(cushion: &CushionPart, position: Vec2, reach: f64, rubber: f64) -> Option<f64> {
    match cushion.shape {
        Shape::Segment { start, end, normal } => {
            let (tangent, from_start) = (normal.perp(), position - start);
            let (length, s) = (tangent.dot(end - start), tangent.dot(from_start));
            let gap = normal.dot(from_start);
            let beside = s >= length.min(0.0) && s <= length.max(0.0) && gap >= -rubber;
            beside.then_some(reach - gap)
        }
        Shape::Arc { center, radius, start, end } => {
            let p = position - center;
            let beside = arc_sides(start, end).iter().all(|side| side.dot(p) >= 0.0);
            beside.then(|| radius + reach - p.length())
        }
        Shape::Hollow { .. } | Shape::Plane { .. } => None,
    }
}
