//! Ball–ball collisions compared with pooltool 0.6.0, sample by sample.

use std::sync::LazyLock;

use crate::near::assert_near;
use carom::Physics;
use carom::math::{Vec2, Vec3, sqrt};
use carom::physics::{BallBall, BallBallModel, Cloth, SlipFriction};
use carom::resolve::{Body, ball_ball};

static CLOTH: LazyLock<Cloth> =
    LazyLock::new(|| Cloth { sliding_friction: 0.2, ..Physics::pool().cloth });
/// Restitution.
const E: f64 = 0.95;

/// A few rounding errors, as fractions of the speeds.
const ROUNDING: f64 = 1e-14;

/// The error of pooltool's 1000 steps, as a fraction of the speeds.
const COARSE_STEPS: f64 = 1e-3;

/// pooltool's Mathavan model computes the slip on the cloth as v − Rẑ×ω, with the wrong sign of the
/// spin (in none of its samples does friction of the cloth oppose the slip). So samples are
/// comparable only if the ball that friction presses on the cloth has no horizontal spin.
fn pressed_ball_is_unspun(a: &Body, b: &Body, line: Vec3) -> bool {
    let spin = a.angular_velocity + b.angular_velocity;
    let pressed = if spin.dot(Vec3::new(-line.y, line.x, 0.0)) < 0.0 { a } else { b };
    pressed.angular_velocity.xy() == Vec2::ZERO
}

fn compare(model: BallBallModel, column: usize, tolerance: f64) {
    // In pooltool's frictional model friction is μ times the separation speed, e·w, while the
    // normal impulse is (1 + e)/2·w: equivalent to a friction smaller by the factor 2e/(1 + e).
    let correction = if model == BallBallModel::Frictional { 2.0 * E / (1.0 + E) } else { 1.0 };
    let law = BallBall {
        model,
        restitution: if model == BallBallModel::Elastic { 1.0 } else { E },
        friction: SlipFriction { a: 0.009951 * correction, b: 0.108 * correction, c: 1.088 },
        ..Physics::pool().ball_ball
    };
    let mut compared = 0;
    let mut worst = 0.0_f64;
    for line in
        include_str!("../data/pooltool_ball_ball.txt").lines().filter(|l| !l.starts_with('#'))
    {
        let row: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        let body = |s: &[f64]| Body {
            velocity: Vec3::new(s[2], s[3], 0.0),
            angular_velocity: Vec3::new(s[4], s[5], s[6]),
            mass: 0.170097,
            radius: 0.028575,
        };
        let (mut a, mut b) = (body(&row[..7]), body(&row[7..14]));
        let d = Vec3::new(row[7] - row[0], row[8] - row[1], 0.0);
        if model == BallBallModel::Mathavan2014 && !pressed_ball_is_unspun(&a, &b, d) {
            continue;
        }
        let scale = a.velocity.length()
            + b.velocity.length()
            + a.radius * (a.angular_velocity.length() + b.angular_velocity.length());
        ball_ball::resolve(&law, &CLOTH, d * (1.0 / d.length()), &mut a, &mut b);
        for (ball, theirs) in [a, b].iter().zip(row[14 + 10 * column..].chunks(5)) {
            let (v, w) = (ball.velocity, ball.angular_velocity * ball.radius);
            let r = ball.radius;
            let gap = [
                v.x - theirs[0],
                v.y - theirs[1],
                w.x - r * theirs[2],
                w.y - r * theirs[3],
                w.z - r * theirs[4],
            ];
            worst = worst.max(sqrt(gap.iter().map(|g| g * g).sum()) / scale);
        }
        compared += 1;
    }
    assert!(compared >= 10, "only {compared} samples compared");
    assert_near(worst, 0.0, tolerance);
}

#[test]
fn elastic_agrees_with_pooltools_frictionless_elastic() {
    compare(BallBallModel::Elastic, 0, ROUNDING);
}

#[test]
fn frictional_agrees_with_pooltools_frictional_inelastic() {
    compare(BallBallModel::Frictional, 1, ROUNDING);
}

#[test]
fn mathavan_2014_agrees_with_pooltools_within_its_coarse_steps() {
    compare(BallBallModel::Mathavan2014, 2, COARSE_STEPS);
}
