//! Bounding boxes around parts of the table, for a cheap rejection of parts that are far away.

use arrayvec::ArrayVec;

use super::Shape;
use crate::math::Vec2;

/// An axis-aligned rectangle, m.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Bounds {
    low: Vec2,
    high: Vec2,
}

impl Bounds {
    /// The box around all `points`.
    #[inline]
    pub(crate) fn of<const N: usize>(points: [Vec2; N]) -> Self {
        let first = points[0];
        points.iter().fold(Self { low: first, high: first }, |b, p| Self {
            low: Vec2::new(lesser(b.low.x, p.x), lesser(b.low.y, p.y)),
            high: Vec2::new(greater(b.high.x, p.x), greater(b.high.y, p.y)),
        })
    }

    /// The box around a part of a cushion, seen from above. The box of a round part holds its whole
    /// circle.
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

    /// The box around both.
    pub(crate) fn with(&self, other: &Self) -> Self {
        Self::of([self.low, self.high, other.low, other.high])
    }

    /// The box that is larger by `margin` (m) on every side.
    pub(crate) fn grown(self, margin: f64) -> Self {
        let by = Vec2::new(margin, margin);
        Self { low: self.low - by, high: self.high + by }
    }

    /// Whether the boxes are disjoint. There is one branch for all four sides, because the side
    /// that decides is unpredictable.
    #[inline(always)]
    pub(crate) fn is_clear_of(&self, other: &Self) -> bool {
        (self.low.x > other.high.x)
            | (self.high.x < other.low.x)
            | (self.low.y > other.high.y)
            | (self.high.y < other.low.y)
    }
}

/// One instruction; `f64::min` takes several because it handles NaN.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The parts that reach into each quadrant of the table. A path within one quadrant can touch no
/// others.
#[derive(Clone, Debug, Default, PartialEq)]
#[repr(C)]
pub(crate) struct Quadrants {
    /// Bottom left, bottom right, top left, top right.
    parts: [ArrayVec<u16, 6>; 4],
    all: ArrayVec<u16, 6>,
}

impl Quadrants {
    /// The quadrants of at most six parts, each given with its box.
    pub(super) fn new(parts: impl Iterator<Item = (u16, Bounds)>) -> Self {
        let mut quadrants = Self::default();
        for (part, Bounds { low, high }) in parts {
            let (in_x, in_y) = ([low.x <= 0.0, high.x >= 0.0], [low.y <= 0.0, high.y >= 0.0]);
            for (k, parts) in quadrants.parts.iter_mut().enumerate() {
                if in_x[k % 2] && in_y[k / 2] {
                    parts.push(part);
                }
            }
            quadrants.all.push(part);
        }
        quadrants
    }

    /// All parts that a path within `field` can touch, and possibly others, in the order given.
    #[inline(always)]
    pub(crate) fn near(&self, field: &Bounds) -> &[u16] {
        let Bounds { low, high } = field;
        let is_in_one = (low.x > 0.0 || high.x < 0.0) && (low.y > 0.0 || high.y < 0.0);
        if !is_in_one {
            return &self.all;
        }
        &self.parts[usize::from(low.x > 0.0) + 2 * usize::from(low.y > 0.0)]
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Quadrants};
    use crate::math::Vec2;

    /// The box around two points.
    fn around(a: [f64; 2], b: [f64; 2]) -> Bounds {
        Bounds::of([a, b].map(|[x, y]| Vec2::new(x, y)))
    }

    #[test]
    fn a_field_in_one_quadrant_is_near_the_parts_that_reach_into_it() {
        let bottom_left = around([-3.0, -3.0], [-1.0, -1.0]);
        let bottom = around([-1.0, -2.0], [1.0, -1.0]);
        let top_right = around([1.0, 1.0], [2.0, 2.0]);
        let parts = [(4, top_right), (2, bottom_left), (7, bottom)];
        let quadrants = Quadrants::new(parts.into_iter());
        assert_eq!(quadrants.near(&around([-2.0, -2.0], [-1.0, -0.1])), [2, 7]);
        assert_eq!(quadrants.near(&around([0.1, -2.0], [1.0, -0.1])), [7]);
        assert_eq!(quadrants.near(&around([0.1, 0.1], [1.0, 0.2])), [4]);
        assert!(quadrants.near(&around([-1.0, 0.1], [-0.1, 0.2])).is_empty());
    }

    #[test]
    fn a_field_across_an_axis_may_be_near_any_part() {
        let parts = [(0, around([1.0, 1.0], [2.0, 2.0])), (1, around([-2.0, 1.0], [-1.0, 2.0]))];
        let quadrants = Quadrants::new(parts.into_iter());
        assert_eq!(quadrants.near(&around([-0.1, 1.0], [0.0, 2.0])), [0, 1]);
    }
}
