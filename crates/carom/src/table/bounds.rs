//! Boxes around parts of the table, to turn away what is nowhere near.

use super::Shape;
use crate::math::Vec2;

/// An upright rectangle, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    low: Vec2,
    high: Vec2,
}

impl Bounds {
    /// Around all `points`.
    pub(crate) fn of<const N: usize>(points: [Vec2; N]) -> Self {
        let first = points[0];
        points.iter().fold(Self { low: first, high: first }, |b, p| Self {
            low: Vec2::new(b.low.x.min(p.x), b.low.y.min(p.y)),
            high: Vec2::new(b.high.x.max(p.x), b.high.y.max(p.y)),
        })
    }

    /// Around a part of a cushion seen from above; around the whole circle of a round one.
    pub(crate) fn of_shape(shape: &Shape) -> Self {
        match *shape {
            Shape::Segment { start, end, .. } => Self::of([start, end]),
            Shape::Arc { center, radius, .. } | Shape::Hollow { center, radius, .. } => {
                Self::of([center]).grown(radius)
            }
            Shape::Plane { corners } => Self::of(corners),
        }
    }

    pub(crate) fn middle(&self) -> Vec2 {
        (self.low + self.high) * 0.5
    }

    /// Around both.
    pub(crate) fn with(&self, other: &Self) -> Self {
        Self::of([self.low, self.high, other.low, other.high])
    }

    /// The same, larger by `margin` (m) on every side.
    pub(crate) fn grown(self, margin: f64) -> Self {
        let by = Vec2::new(margin, margin);
        Self { low: self.low - by, high: self.high + by }
    }

    /// Whether the two do not meet.
    #[inline(always)]
    pub(crate) fn is_clear_of(&self, other: &Self) -> bool {
        self.low.x > other.high.x
            || self.high.x < other.low.x
            || self.low.y > other.high.y
            || self.high.y < other.low.y
    }
}
