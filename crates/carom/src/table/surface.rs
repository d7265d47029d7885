//! The table as a solid body: what lies under a point, and the normal of a touched part.
//!
//! * The slate is the plane z = 0, with the pockets' holes in it; a hole's edge is the lip.
//! * Every nose, point, facing and straight run of a liner is a sharp edge at the height of the
//!   nose; the rubber below it recedes. Far below the edge it has receded by a ball's radius, so
//!   that a centre can come up to the edge line.
//! * A liner's round wall is the cylinder through the hole's edge, up to the height of the nose.
//! * Behind these edges the top of the rails is flat, out to the border.

use super::{Capture, Shape, TableFeature, TableGeometry, arc_sides};
use crate::math::{Vec2, Vec3};

/// A ball whose centre is lower than an edge by its radius and this margin, m, touches the body
/// under the edge instead of the edge. The margin is ten thousand roundings of a height, so that
/// detection and normals agree on which of the two is touched.
pub(crate) const UNDER_EDGE: f64 = 1e-12;

impl TableGeometry {
    /// The pocket over whose hole the point `p` (m, engine's coordinates) lies; `None` with the
    /// mouth-line model.
    pub fn hole_at(&self, p: Vec2) -> Option<u8> {
        let over = |i: &u8| {
            let pocket = &self.pockets[usize::from(*i)];
            (p - pocket.center).length_squared() < pocket.radius * pocket.radius
                && matches!(pocket.capture, Capture::DropCircle)
        };
        if self.pockets.is_empty() {
            return None;
        }
        self.nearest_pockets(p).into_iter().find(over)
    }

    /// The pocket in whose opening the point `p` (m, engine's coordinates) lies: behind the nose
    /// lines, between the jaws and in front of the liner.
    pub fn opening_at(&self, p: Vec2) -> Option<u8> {
        let openings = self.index.openings.first()?;
        if !self.is_behind_nose_line(p) {
            return None;
        }
        let [corner, side] = openings.contain(Vec2::new(-p.x.abs(), -p.y.abs()));
        let [at_corner, at_side] = self.nearest_pockets(p);
        corner.then_some(at_corner).or(side.then_some(at_side))
    }

    /// The pocket beyond whose mouth line the point `p` (m, engine's coordinates) lies; `None`
    /// with the drop-circle model. There is no table beyond a mouth line.
    pub fn beyond_mouth_line(&self, p: Vec2) -> Option<u8> {
        if self.pockets.is_empty() {
            return None;
        }
        let beyond = |k: &u8| match self.pockets[usize::from(*k)].capture {
            Capture::MouthLine { start, .. } => {
                self.pockets[usize::from(*k)].axis.dot(p - start) >= 0.0
            }
            Capture::DropCircle => false,
        };
        // The mouth line of a corner pocket cuts off the corner of the playing area.
        let in_area = !self.is_behind_nose_line(p);
        let [corner, _] = self.nearest_pockets(p);
        let here = if in_area { Some(corner) } else { self.opening_at(p) };
        here.filter(beyond)
    }

    /// The rail's top (index into `cushions`) under the point `p` (m, engine's coordinates):
    /// behind an edge line, not in a pocket's opening, within the border.
    pub fn top_at(&self, p: Vec2) -> Option<u16> {
        let on_top =
            self.is_behind_nose_line(p) && !self.is_outside(p) && self.opening_at(p).is_none();
        on_top.then(|| {
            let (x, y) = (p.x.abs() - self.index.half.x, p.y.abs() - self.index.half.y);
            let place = if x >= y {
                2 + 2 * usize::from(p.x > 0.0) + usize::from(p.y > 0.0)
            } else {
                usize::from(p.y > 0.0)
            };
            self.index.tops[place]
        })
    }

    /// Whether the point `p` (m, engine's coordinates) lies beyond the outer edge of the rails.
    pub fn is_outside(&self, p: Vec2) -> bool {
        p.x.abs() > self.index.border.x || p.y.abs() > self.index.border.y
    }

    /// Unit vector from the centre `position` (m, engine's coordinates) of a ball of radius
    /// `radius` (m) to the point of `feature` that it touches. Zero for features without a
    /// surface: a capture, the border.
    pub fn contact_normal(&self, feature: TableFeature, position: Vec3, radius: f64) -> Vec3 {
        let down = Vec3::new(0.0, 0.0, -1.0);
        match feature {
            TableFeature::Slate => down,
            TableFeature::Lip(k) => {
                let pocket = &self.pockets[usize::from(k)];
                let from_center = position.xy() - pocket.center;
                if position.z <= 0.0 {
                    return unit(from_center.with_z(0.0));
                }
                to_ring(from_center, pocket.radius, -position.z)
            }
            TableFeature::Cushion(part) => {
                let shape = &self.cushions[usize::from(part)].shape;
                if matches!(shape, Shape::Plane { .. }) {
                    return down;
                }
                edge_normal(shape, position.xy(), self.cushion_height - position.z, radius)
            }
            TableFeature::Pocket(_)
            | TableFeature::Depth(_)
            | TableFeature::Brink
            | TableFeature::Border => Vec3::ZERO,
        }
    }

    /// The corner and the side pocket next to `p`.
    fn nearest_pockets(&self, p: Vec2) -> [u8; 2] {
        let right = u8::from(p.x > 0.0);
        [right + if p.y > 0.0 { 4 } else { 0 }, 2 + right]
    }

    fn is_behind_nose_line(&self, p: Vec2) -> bool {
        p.x.abs() > self.index.half.x || p.y.abs() > self.index.half.y
    }
}

/// The normal of an edge, or of a round wall, that lies `rise` (m) above the centre `p` of a ball.
fn edge_normal(shape: &Shape, p: Vec2, rise: f64, radius: f64) -> Vec3 {
    let under = rise > radius + 0.5 * UNDER_EDGE;
    match *shape {
        Shape::Segment { normal, .. } if under => (-normal).with_z(0.0),
        Shape::Segment { start, normal, .. } => {
            unit((-normal * normal.dot(p - start)).with_z(rise))
        }
        Shape::Arc { center, .. } if under => unit((center - p).with_z(0.0)),
        Shape::Arc { center, radius, .. } => to_ring(p - center, radius, rise),
        Shape::Hollow { center, radius, start, end } => {
            let from_center = p - center;
            let [side, _] = arc_sides(start, end);
            if rise < 0.0 {
                to_ring(from_center, radius, rise)
            } else if side.dot(from_center) >= 0.0 {
                unit(from_center.with_z(0.0))
            } else {
                // The ball is next to the wall and touches its vertical end.
                unit((start * radius - from_center).with_z(0.0))
            }
        }
        Shape::Plane { .. } => Vec3::ZERO,
    }
}

/// Unit vector to the nearest point of a horizontal circle of radius `ring` (m), from a point
/// `rise` (m) below its plane, at `from_center` from its axis.
fn to_ring(from_center: Vec2, ring: f64, rise: f64) -> Vec3 {
    let distance = from_center.length();
    let outwards = if distance > 0.0 { from_center * (1.0 / distance) } else { Vec2::ZERO };
    unit((outwards * (ring - distance)).with_z(rise))
}

fn unit(v: Vec3) -> Vec3 {
    v * (1.0 / v.length())
}
