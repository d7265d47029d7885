//! Ball–ball collisions beside pooltool 0.6.0, sample by sample.

mod near;

use carom::math::{Vec3, sqrt};
use carom::physics::{BallBall, BallBallModel, Cloth, SlipFriction};
use carom::resolve::{Body, ball_ball};
use near::assert_near;

const CLOTH: Cloth =
    Cloth { sliding_friction: 0.2, rolling_friction: 0.01, spin_deceleration: 10.9 };
const GRAVITY: f64 = 9.81;

/// pooltool moves the balls apart along their paths to a gap of 1e-6 m before it looks at the line
/// of centres, which turns by up to this angle, rad.
const NUDGE: f64 = 4e-5;

/// What 1000 steps of the normal impulse leave, in parts of the cue ball's speed.
const COARSE_STEPS: f64 = 4e-3;

fn compare(model: BallBallModel, column: usize, tolerance: f64) {
    let law = BallBall {
        model,
        restitution: if model == BallBallModel::Elastic { 1.0 } else { 0.95 },
        friction: SlipFriction { a: 0.009951, b: 0.108, c: 1.088 },
        frequency_ratio: 1.7,
    };
    let mut compared = 0;
    let mut worst = 0.0_f64;
    for line in include_str!("data/pooltool_ball_ball.txt").lines().filter(|l| !l.starts_with('#'))
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
        let scale = a.velocity.length()
            + b.velocity.length()
            + a.radius * (a.angular_velocity.length() + b.angular_velocity.length());
        ball_ball::resolve(&law, &CLOTH, GRAVITY, d * (1.0 / d.length()), &mut a, &mut b);
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
    assert_eq!(compared, 40);
    eprintln!("{model:?}: {worst:e}");
    assert_near(worst, 0.0, tolerance);
}

#[test]
fn elastic_is_pooltools_frictionless_elastic() {
    compare(BallBallModel::Elastic, 0, NUDGE);
}

#[test]
fn frictional_is_pooltools_frictional_inelastic() {
    compare(BallBallModel::Frictional, 1, NUDGE);
}

#[test]
fn mathavan_2014_is_pooltools_within_its_coarse_steps() {
    compare(BallBallModel::Mathavan2014, 2, COARSE_STEPS);
}
