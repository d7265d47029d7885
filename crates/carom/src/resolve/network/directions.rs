//! The directions of a contact during the impact.

use crate::math::{Vec2, Vec3};

/// The normal of a contact and two unit vectors in its tangent plane; **n** × the first is the
/// second.
#[derive(Clone, Copy)]
pub(super) struct Directions {
    pub(super) normal: Vec3,
    /// Horizontal.
    pub(super) first: Vec2,
    pub(super) second: Vec3,
}

impl Directions {
    /// Those of a normal that does not turn.
    pub(super) fn of(normal: Vec3) -> Self {
        let level = normal.xy();
        let length = level.length();
        let first = if length > 0.0 { level.perp() * (1.0 / length) } else { Vec2::new(1.0, 0.0) };
        Self { normal, first, second: normal.cross(first.with_z(0.0)) }
    }

    /// The components of the slip, from the velocity of the first ball's centre relative to the
    /// second's and the sum of both Rω.
    #[inline(always)]
    pub(super) fn slip(&self, velocity: Vec3, surface: Vec3) -> Vec2 {
        let Self { first, second, .. } = *self;
        Vec2::new(
            velocity.xy().dot(first) + surface.dot(second),
            velocity.dot(second) - surface.xy().dot(first),
        )
    }

    /// The vector with these components.
    #[inline(always)]
    pub(super) fn vector(&self, x: f64, y: f64) -> Vec3 {
        let level = self.first * x + self.second.xy() * y;
        level.with_z(self.second.z * y)
    }
}
