//! Ball against ball.

use super::Body;
use crate::math::Vec3;
use crate::physics::{BallBall, Cloth};

/// Resolves the impact of two balls that touch and approach. `normal` is the unit vector from
/// `a`'s centre to `b`'s. `gravity`, m/s². Both balls stay on the cloth: the vertical part of
/// the impulse is taken by the slate.
pub fn resolve(
    law: &BallBall,
    cloth: &Cloth,
    gravity: f64,
    normal: Vec3,
    a: &mut Body,
    b: &mut Body,
) {
    let _ = (law, cloth, gravity, normal, a, b);
}
