//! Ball against cushion.

use super::Body;
use crate::math::Vec2;
use crate::physics::{Cloth, Cushion};

/// Resolves the impact of a ball with a cushion nose. `into` is the horizontal unit vector from
/// the ball's centre towards the nose; the nose stands at angle θ above the ball's centre,
/// sin θ = (h − R)/R (negative if below).
pub fn resolve(law: &Cushion, cloth: &Cloth, into: Vec2, sin_theta: f64, ball: &mut Body) {
    let _ = (law, cloth, into, sin_theta, ball);
}
