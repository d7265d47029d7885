//! Corner and side pockets.

use core::f64::consts::FRAC_1_SQRT_2;

use crate::math::Vec2;

/// A corner pocket, with two jaws across a right angle, or a side pocket, with two that face each
/// other.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum PocketKind {
    Corner,
    Side,
}

impl PocketKind {
    /// Unit vector along the axis of the quadrant's pocket, away from the table.
    pub(super) fn axis(self) -> Vec2 {
        match self {
            Self::Corner => Vec2::new(-FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
            Self::Side => Vec2::new(-1.0, 0.0),
        }
    }

    /// The middle of the quadrant's pocket on the nose line (the corner, or the middle of the
    /// rail), m.
    pub(super) fn middle(self, half: Vec2) -> Vec2 {
        match self {
            Self::Corner => -half,
            Self::Side => Vec2::new(-half.x, 0.0),
        }
    }

    /// The key of the pockets of this kind.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Corner => "corner_pocket",
            Self::Side => "side_pocket",
        }
    }
}
