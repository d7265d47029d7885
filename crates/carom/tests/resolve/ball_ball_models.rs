//! Relations between the ball–ball models, and simple impacts with known results.

use crate::near::assert_near;
use carom::Physics;
use carom::math::{Vec3, sqrt};
use carom::physics::{BallBall, BallBallModel, SlipFriction};
use carom::resolve::{Body, ball_ball, restitution};

fn law(model: BallBallModel, friction: f64) -> BallBall {
    BallBall {
        model,
        restitution: 0.9,
        friction: SlipFriction::constant(friction),
        ..Physics::pool().ball_ball
    }
}

fn ball(velocity: Vec3, angular_velocity: Vec3, mass: f64, radius: f64) -> Body {
    Body { velocity, angular_velocity, mass, radius }
}

fn resolve(law: &BallBall, normal: Vec3, mut a: Body, mut b: Body) -> (Body, Body) {
    let physics = Physics::pool();
    ball_ball::resolve(law, &physics.cloth, normal, &mut a, &mut b);
    (a, b)
}

const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);

#[test]
fn compliance_has_no_effect_on_surfaces_that_slide_to_the_end() {
    let a = ball(Vec3::new(2.0, 1.0, 0.0), Vec3::new(30.0, -5.0, 20.0), 0.2, 0.03);
    let b = ball(Vec3::new(-0.5, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0), 0.17, 0.03);
    let (rigid, soft) = (
        resolve(&law(BallBallModel::Frictional, 0.05), Y, a, b),
        resolve(&law(BallBallModel::Compliant, 0.05), Y, a, b),
    );
    for (rigid, soft) in [(rigid.0, soft.0), (rigid.1, soft.1)] {
        assert_near((rigid.velocity - soft.velocity).length(), 0.0, 1e-15);
        assert_near((rigid.angular_velocity - soft.angular_velocity).length(), 0.0, 1e-12);
    }
}

#[test]
fn rigid_surfaces_that_stick_end_without_slip_for_any_masses() {
    let a = ball(Vec3::new(0.05, 3.0, 0.0), Vec3::new(0.0, 0.0, 4.0), 0.094, 0.0238);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.2, 0.0238);
    let (a, b) = resolve(&law(BallBallModel::Frictional, 0.5), Y, a, b);
    let slip = (a.velocity - b.velocity).x
        - (a.radius * a.angular_velocity.z + b.radius * b.angular_velocity.z);
    assert_near(slip, 0.0, 1e-15);
}

#[test]
fn compliant_surfaces_that_slip_and_then_stick_spring_back() {
    let a = ball(Vec3::new(0.6, 3.0, 0.0), Vec3::ZERO, 0.17, 0.0286);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.17, 0.0286);
    let (a, b) = resolve(&law(BallBallModel::Compliant, 0.1), Y, a, b);
    let slip = (a.velocity - b.velocity).x
        - (a.radius * a.angular_velocity.z + b.radius * b.angular_velocity.z);
    assert!(slip < -0.1 && slip > -0.6, "{slip}");
}

#[test]
fn a_light_ball_bounces_back_from_a_heavy_one() {
    let law = BallBall { restitution: 1.0, ..law(BallBallModel::Elastic, 0.0) };
    let a = ball(Y, Vec3::ZERO, 0.1, 0.03);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.3, 0.03);
    let (a, b) = resolve(&law, Y, a, b);
    assert_near(a.velocity.y, -0.5, 1e-15);
    assert_near(b.velocity.y, 0.5, 1e-15);
}

#[test]
fn equal_elastic_balls_exchange_their_speeds_exactly() {
    let law = BallBall { restitution: 1.0, ..law(BallBallModel::Elastic, 0.0) };
    let (a, b) = (
        ball(Vec3::new(0.0, 1.7, 0.0), Vec3::ZERO, 0.17, 0.03),
        ball(Vec3::ZERO, Vec3::ZERO, 0.17, 0.03),
    );
    let after = resolve(&law, Y, a, b);
    assert_eq!((after.0.velocity, after.1.velocity), (b.velocity, a.velocity));
}

#[test]
fn a_small_ball_into_a_large_one_lifts_it_along_the_line_of_centres() {
    let law = BallBall { restitution: 1.0, ..law(BallBallModel::Elastic, 0.0) };
    let (small, large) = (0.02, 0.04);
    let sine = (large - small) / (large + small);
    let normal = Vec3::new(0.0, sqrt(1.0 - sine * sine), sine);
    let a = ball(Y, Vec3::ZERO, 0.17, small);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.17, large);
    let (a, b) = resolve(&law, normal, a, b);
    // Equal masses exchange their velocities along the line of centres.
    let given = normal * normal.y;
    assert_near((b.velocity - given).length(), 0.0, 1e-15);
    assert_near((a.velocity - (Y - given)).length(), 0.0, 1e-15);
    assert!(b.velocity.z > 0.0 && a.velocity.z < 0.0);
    assert_eq!(a.angular_velocity.length() + b.angular_velocity.length(), 0.0);
}

#[test]
fn a_ball_that_falls_on_another_passes_its_velocity_on() {
    let law = BallBall { restitution: 1.0, ..law(BallBallModel::Frictional, 0.1) };
    let down = Vec3::new(0.0, 0.0, -1.0);
    let a = ball(Vec3::new(0.3, 0.0, -2.0), Vec3::new(0.0, 0.0, 50.0), 0.17, 0.03);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.17, 0.03);
    let (a, b) = resolve(&law, down, a, b);
    assert_near(b.velocity.z, -2.0, 1e-15);
    assert_near(a.velocity.z, 0.0, 1e-15);
    // Rigid surfaces that stick: each velocity changes by a seventh of the slip.
    assert_near(b.velocity.x, 0.3 / 7.0, 1e-15);
    assert_near(a.velocity.x, 0.3 - 0.3 / 7.0, 1e-15);
    // A spin about the line of centres causes no slip.
    assert_eq!((a.angular_velocity.z, b.angular_velocity.z), (50.0, 0.0));
}

#[test]
fn a_rolling_ball_hops_off_a_full_hit_by_mu_squared_times_the_object_balls_speed_squared_over_2g() {
    // TP B.5; Kim 2024: h = μ²U²/2g.
    let law = BallBall { restitution: 0.94, ..law(BallBallModel::Frictional, 0.06) };
    let radius = 0.028575;
    let a = ball(Y * 3.0, Vec3::new(-3.0 / radius, 0.0, 0.0), 0.17, radius);
    let b = ball(Vec3::ZERO, Vec3::ZERO, 0.17, radius);
    let (a, b) = resolve(&law, Y, a, b);
    let gravity = 9.81;
    let hop = |v: Vec3| v.z * v.z / (2.0 * gravity);
    assert_near(b.velocity.y, 0.97 * 3.0, 1e-15);
    assert_near(
        hop(a.velocity),
        0.06 * 0.06 * b.velocity.y * b.velocity.y / (2.0 * gravity),
        1e-17,
    );
    assert!(a.velocity.z > 0.0);
    assert_near(a.velocity.z + b.velocity.z, 0.0, 1e-17);
}

#[test]
fn a_gentle_touch_is_elastic_in_every_model() {
    for model in BallBallModel::ALL {
        let approach = 0.5 * restitution::ELASTIC;
        let a = ball(Y * approach, Vec3::ZERO, 0.17, 0.03);
        let b = ball(Vec3::ZERO, Vec3::ZERO, 0.17, 0.03);
        let (a, b) = resolve(&law(model, 0.05), Y, a, b);
        assert_near(b.velocity.y - a.velocity.y, approach, 1e-12 * approach);
    }
}

#[test]
fn balls_that_separate_are_left_unchanged() {
    let a = ball(-Y, Vec3::new(1.0, 2.0, 3.0), 0.17, 0.03);
    let b = ball(Y, Vec3::ZERO, 0.17, 0.03);
    assert_eq!(resolve(&Physics::pool().ball_ball, Y, a, b), (a, b));
}

#[test]
fn elastic_balls_have_restitution_one_unless_the_file_gives_another() {
    let restitution = |ball_ball: &str| {
        let file = format!(
            r#"{{"format": "carom-shot/1", "table": {{"cloth": "unbounded"}},
                "physics": {{"base": "pool", "ball_ball": {ball_ball}}},
                "balls": [{{"id": "cue", "position": [0, 0]}}]}}"#
        );
        carom::Shot::from_json(&file).unwrap().physics().ball_ball.restitution
    };
    assert_eq!(restitution(r#"{"model": "elastic"}"#), 1.0);
    assert_eq!(restitution(r#"{"restitution": 0.9, "model": "elastic"}"#), 0.9);
    assert_eq!(restitution(r#"{"model": "frictional"}"#), Physics::pool().ball_ball.restitution);
}
