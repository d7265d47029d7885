//! The pool preset compared with measured throw (Alciatore, Billiards Digest, Sept 2006, diagram 4;
//! Throw follow-up II, 2014), read from figures to ±0.5°. The two tests differ by up to 2° where
//! they overlap (30° cut, 1 to 1.3 m/s), so no single friction agrees with both.

use crate::near::assert_near;
use carom::Physics;
use carom::math::{Vec3, atan2, cos, radians, sin, sqrt};
use carom::physics::{BallBall, BallBallModel, SlipFriction};
use carom::resolve::{Body, ball_ball};

/// Object-ball speed (ft/s) and throw (°) at a 30° cut, stun (2014).
const BY_SPEED: [(f64, f64); 5] = [(2.8, 6.05), (3.55, 6.15), (4.5, 5.5), (7.2, 4.2), (10.7, 3.45)];

/// Cut (°) and throw (°) at slow, medium and fast stun (2006), with the speeds of TP A.14.
const BY_CUT: [(f64, [f64; 3]); 5] = [
    (10.0, [1.6, 2.05, 1.55]),
    (20.0, [4.5, 3.5, 3.4]),
    (30.0, [4.5, 4.15, 3.45]),
    (45.0, [5.6, 3.9, 2.4]),
    (60.0, [4.6, 3.9, 2.05]),
];
const SPEEDS_MPH: [f64; 3] = [1.0, 3.0, 7.0];
const MPH: f64 = 0.44704;
const FOOT: f64 = 0.3048;

/// Throw of a stun shot, °.
fn throw(physics: &Physics, law: &BallBall, speed: f64, cut: f64) -> f64 {
    let ball = |velocity| Body {
        velocity,
        angular_velocity: Vec3::ZERO,
        mass: physics.ball.mass,
        radius: physics.ball.radius,
    };
    let (mut cue, mut object) = (ball(Vec3::new(0.0, speed, 0.0)), ball(Vec3::ZERO));
    let line = Vec3::new(sin(radians(cut)), cos(radians(cut)), 0.0);
    ball_ball::resolve(law, &physics.cloth, line, &mut cue, &mut object);
    cut - atan2(object.velocity.x, object.velocity.y) / radians(1.0)
}

/// Root mean square of throw minus measured throw in the tests of 2014 and 2006, °.
fn rms_errors(law: &BallBall) -> (f64, f64) {
    let physics = Physics::pool();
    let to_object = 0.5 * (1.0 + law.restitution) * cos(radians(30.0));
    let by_speed: f64 = BY_SPEED
        .iter()
        .map(|&(speed, measured)| throw(&physics, law, speed * FOOT / to_object, 30.0) - measured)
        .map(|miss| miss * miss)
        .sum();
    let by_cut: f64 = BY_CUT
        .iter()
        .flat_map(|&(cut, measured)| SPEEDS_MPH.into_iter().zip(measured).map(move |p| (cut, p)))
        .map(|(cut, (speed, measured))| throw(&physics, law, speed * MPH, cut) - measured)
        .map(|miss| miss * miss)
        .sum();
    (sqrt(by_speed / 5.0), sqrt(by_cut / 15.0))
}

/// The preset has used balls, so it agrees with the test of 2006. The balls of 2014 threw more; they
/// are the surface `dirty`.
#[test]
fn the_pool_preset_throws_as_measured_in_2006_to_two_fifths_of_a_degree() {
    let (by_speed, by_cut) = rms_errors(&Physics::pool().ball_ball);
    assert!(by_cut < 0.4 && by_speed > 1.0, "{by_speed}°, {by_cut}°");
}

#[test]
fn bb23_a_friction_fitted_to_the_2014_test_alone_meets_it_within_reading_error() {
    let friction = SlipFriction { a: 0.0, b: 0.150, c: 0.52 };
    let (by_speed, by_cut) = rms_errors(&BallBall { friction, ..Physics::pool().ball_ball });
    assert!(by_speed < 0.35 && by_cut > 1.0, "{by_speed}°, {by_cut}°");
}

#[test]
fn the_rigid_model_cannot_reach_the_measured_throw() {
    let physics = Physics::pool();
    let model = BallBallModel::Frictional;
    // With any friction the throw is at most atan(2/7·tan φ/(1 + e)).
    let grip = BallBall { model, friction: SlipFriction::constant(10.0), ..physics.ball_ball };
    let rigid = throw(&physics, &grip, 1.0, 30.0);
    assert_near(rigid, 4.84, 0.01);
    assert!(BY_SPEED[0].1 - rigid > 1.0);
    // With Alciatore's friction (TP A.14) the error of the rigid model is twice that of ours.
    let friction = SlipFriction { a: 0.009951, b: 0.108, c: 1.088 };
    let (by_speed, by_cut) = rms_errors(&BallBall { model, friction, ..physics.ball_ball });
    assert!(by_speed > 2.0 && by_cut > 0.9, "{by_speed}°, {by_cut}°");
}

/// The law of the pool preset with the surface of this name.
fn with_surface(name: &str) -> BallBall {
    let (_, friction) = SlipFriction::SURFACES
        .into_iter()
        .find(|(known, _)| *known == name)
        .unwrap_or_else(|| panic!("no surface {name}"));
    BallBall { friction, ..Physics::pool().ball_ball }
}

#[test]
fn bb23_dirty_balls_throw_within_half_a_degree_of_the_test_of_2014() {
    let (physics, law) = (Physics::pool(), with_surface("dirty"));
    let to_object = 0.5 * (1.0 + law.restitution) * cos(radians(30.0));
    for (speed, measured) in BY_SPEED {
        assert_near(throw(&physics, &law, speed * FOOT / to_object, 30.0), measured, 0.25);
    }
}

#[test]
fn bb25_used_balls_throw_within_half_a_degree_of_twelve_readings_of_2006() {
    let (physics, law) = (Physics::pool(), with_surface("used"));
    let misses: Vec<f64> = BY_CUT
        .iter()
        .flat_map(|&(cut, measured)| SPEEDS_MPH.into_iter().zip(measured).map(move |p| (cut, p)))
        .map(|(cut, (speed, measured))| throw(&physics, &law, speed * MPH, cut) - measured)
        .filter(|miss| miss.abs() > 0.5)
        .collect();
    assert_eq!(misses.len(), 3, "{misses:?}");
    assert!(misses.iter().all(|miss| miss.abs() < 0.8), "{misses:?}");
}

#[test]
fn bb25_no_falling_friction_meets_the_slow_throws_at_30_and_at_45_degrees() {
    // At 45° the balls slip throughout, so 5.1° (5.6° − 0.5°) takes this friction; the slip is slower
    // at 30°, so a falling friction is at least as large there.
    let friction = SlipFriction::constant(carom::math::sin(radians(5.1)) / cos(radians(5.1)));
    let (physics, slow) = (Physics::pool(), SPEEDS_MPH[0] * MPH);
    let law = BallBall { friction, ..physics.ball_ball };
    assert_near(throw(&physics, &law, slow, 45.0), 5.1, 1e-6);
    assert!(throw(&physics, &law, slow, 30.0) > 4.5 + 0.5);
}

#[test]
fn bb27_surfaces_throw_as_measured_after_their_treatments() {
    let (physics, slow) = (Physics::pool(), SPEEDS_MPH[0] * MPH);
    for (surface, measured) in [("clean", 3.6), ("used", 4.9)] {
        assert_near(throw(&physics, &with_surface(surface), slow, 45.0), measured, 0.1);
    }
}
