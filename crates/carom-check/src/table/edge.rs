//! The edges of a table in plan.

use carom::math::{Vec2, sqrt};

/// What an edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EdgeKind {
    Nose,
    Point,
    Facing,
    Liner,
    Top,
}

/// An edge in plan, at the height of the nose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EdgeLine {
    /// A straight edge; `normal` points to the balls.
    Straight { start: Vec2, end: Vec2, normal: Vec2 },
    /// A convex arc between two unit vectors from its centre, the first at the nose.
    Round { center: Vec2, radius: f64, from: Vec2, to: Vec2 },
    /// The wall behind a hole between two unit vectors from its centre, the second along the
    /// pocket's axis.
    Wall { center: Vec2, radius: f64, from: Vec2, to: Vec2 },
    /// The top of a rail.
    Flat,
}

/// The end of a rail at a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RailEnd {
    /// Deep end of the facing, m, or of the point that takes its place.
    pub(crate) deep: Vec2,
    /// Unit vector away from the table along the facing, or along the tangent to the point.
    pub(crate) along: Vec2,
    /// Unit vector into the pocket.
    pub(crate) normal: Vec2,
    /// Number of the pocket.
    pub(crate) pocket: usize,
}

impl RailEnd {
    /// The point where the line leaves the circle, if it meets it.
    pub(crate) fn leaves(&self, center: Vec2, radius: f64) -> Option<Vec2> {
        let d = self.deep - center;
        let b = d.dot(self.along);
        let square = b * b - d.dot(d) + radius * radius;
        (square >= 0.0).then(|| self.deep + self.along * (sqrt(square) - b))
    }
}
