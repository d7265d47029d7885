//! Boxes around parts of the table, to turn away what is nowhere near.

use alloc::vec::Vec;

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
    #[inline]
    pub(crate) fn of<const N: usize>(points: [Vec2; N]) -> Self {
        let first = points[0];
        points.iter().fold(Self { low: first, high: first }, |b, p| Self {
            low: Vec2::new(lesser(b.low.x, p.x), lesser(b.low.y, p.y)),
            high: Vec2::new(greater(b.high.x, p.x), greater(b.high.y, p.y)),
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

    /// Whether the two do not meet. One jump for all four sides, of which nobody can guess the one.
    #[inline(always)]
    pub(crate) fn is_clear_of(&self, other: &Self) -> bool {
        (self.low.x > other.high.x)
            | (self.high.x < other.low.x)
            | (self.low.y > other.high.y)
            | (self.high.y < other.low.y)
    }
}

/// One instruction, where `f64::min` takes several for what is not a number.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Which of some parts reach into each quadrant of the table: what keeps to one touches no others.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Quadrants {
    /// Left and right at the bottom, left and right at the top.
    parts: [Vec<u16>; 4],
    all: Vec<u16>,
}

impl Quadrants {
    /// Of parts, each with its box.
    pub(super) fn new(parts: impl Iterator<Item = (u16, Bounds)>) -> Self {
        let mut quadrants = Self::default();
        for (part, Bounds { low, high }) in parts {
            let (beside, along) = ([low.x <= 0.0, high.x >= 0.0], [low.y <= 0.0, high.y >= 0.0]);
            for (k, parts) in quadrants.parts.iter_mut().enumerate() {
                if beside[k % 2] && along[k / 2] {
                    parts.push(part);
                }
            }
            quadrants.all.push(part);
        }
        quadrants
    }

    /// The parts that what keeps to `field` may touch, and some more, in the order in which they were given.
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

    /// Around two points.
    fn around(a: [f64; 2], b: [f64; 2]) -> Bounds {
        Bounds::of([a, b].map(|[x, y]| Vec2::new(x, y)))
    }

    #[test]
    fn what_keeps_to_a_quadrant_is_near_the_parts_that_reach_into_it() {
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
    fn what_crosses_an_axis_may_be_near_any_part() {
        let parts = [(0, around([1.0, 1.0], [2.0, 2.0])), (1, around([-2.0, 1.0], [-1.0, 2.0]))];
        let quadrants = Quadrants::new(parts.into_iter());
        assert_eq!(quadrants.near(&around([-0.1, 1.0], [0.0, 2.0])), [0, 1]);
    }
}
