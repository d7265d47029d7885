//! A ball comes down gently on a ball that lies on the slate.
//!
//! The slate holds the lower ball, which cannot move downwards. So only its horizontal inertia
//! takes part, 1/m* = 1/m + n_h²/m′, where n_h is the horizontal part of the normal **n**.
//! Otherwise the slate would absorb the lower ball's momentum in each hop, and a ball on top of
//! another would hop without end. Friction is neglected in so gentle a contact.

use crate::math::Vec3;
use crate::resolve::{Body, restitution};

/// Resolves the contact of `flyer` with `held`. `normal` is the unit vector from the first ball's
/// centre to the second's, `restitution` the law's coefficient. Balls that do not approach are left
/// unchanged.
pub fn resolve(restitution: f64, normal: Vec3, flyer: &mut Body, held: &mut Body) {
    let approach = (flyer.velocity - held.velocity).dot(normal);
    if approach <= 0.0 {
        return;
    }
    let level = normal.xy();
    let mobility = 1.0 / flyer.mass + level.length_squared() / held.mass;
    let impulse = (1.0 + restitution::effective(restitution, approach)) * approach / mobility;
    flyer.velocity -= normal * (impulse / flyer.mass);
    held.velocity += (level * (impulse / held.mass)).with_z(0.0);
}

#[cfg(test)]
mod tests {
    use super::resolve;
    use crate::math::Vec3;
    use crate::resolve::Body;

    fn ball(velocity: Vec3) -> Body {
        Body { velocity, angular_velocity: Vec3::ZERO, mass: 0.17, radius: 0.028575 }
    }

    fn energy(balls: [&Body; 2]) -> f64 {
        balls.iter().map(|b| 0.5 * b.mass * b.velocity.length_squared()).sum()
    }

    #[test]
    fn a_ball_that_is_hit_from_straight_above_acts_like_a_wall() {
        let (mut a, mut b) = (ball(Vec3::new(0.1, 0.0, -0.04)), ball(Vec3::ZERO));
        resolve(0.9, Vec3::new(0.0, 0.0, -1.0), &mut a, &mut b);
        assert!((a.velocity.z - 0.036).abs() < 1e-17 && a.velocity.x == 0.1);
        assert_eq!(b.velocity, Vec3::ZERO);
    }

    #[test]
    fn a_hit_at_an_angle_moves_the_lower_ball_along_the_slate_and_conserves_energy() {
        let normal = Vec3::new(0.6, 0.0, -0.8);
        let (mut a, mut b) = (ball(Vec3::new(0.0, 0.0, -0.04)), ball(Vec3::ZERO));
        let before = energy([&a, &b]);
        resolve(1.0, normal, &mut a, &mut b);
        assert!((energy([&a, &b]) / before - 1.0).abs() < 1e-15);
        assert!(b.velocity.x > 0.0 && b.velocity.z == 0.0);
        let level = a.velocity.x + b.velocity.x;
        assert!(level.abs() < 1e-17, "momentum along the slate: {level}");
        let parting = (b.velocity - a.velocity).dot(normal);
        assert!((parting - 0.032).abs() < 1e-16);
    }
}
