//! Mathavan 2014 compared with an independent implementation of its force laws, in many small equal
//! steps of impulse, as in the paper.

use std::sync::LazyLock;

use crate::near::assert_near;
use carom::Physics;
use carom::math::{Vec3, cos, radians, sin};
use carom::physics::{BallBall, BallBallModel, Cloth, SlipFriction};
use carom::resolve::{Body, ball_ball};

static CLOTH: LazyLock<Cloth> =
    LazyLock::new(|| Cloth { sliding_friction: 0.212, ..Physics::pool().cloth });
const UP: Vec3 = Vec3::new(0.0, 0.0, 1.0);
const STEPS: u32 = 160_000;

/// Error of the steps, m/s, for balls that slip on each other until the end.
const SMOOTH: f64 = 1e-9;

/// Error of the steps where the slip ends, m/s: there the friction of a step overshoots and
/// alternates.
const CHATTER: f64 = 2e-5;

fn law(restitution: f64, friction: f64) -> BallBall {
    BallBall {
        model: BallBallModel::Mathavan2014,
        restitution,
        friction: SlipFriction::constant(friction),
        ..Physics::pool().ball_ball
    }
}

fn unit(v: Vec3) -> Vec3 {
    let length = v.length();
    if length < 1e-12 { Vec3::ZERO } else { v * (1.0 / length) }
}

/// Applies `impulse` to `ball` at `arm` from its centre; the height of the centre stays constant.
fn push(ball: &mut Body, arm: Vec3, impulse: Vec3) {
    let inertia = 0.4 * ball.mass * ball.radius * ball.radius;
    ball.velocity += Vec3 { z: 0.0, ..impulse * (1.0 / ball.mass) };
    ball.angular_velocity += arm.cross(impulse) * (1.0 / inertia);
}

/// One step of the normal impulse, from the forces at the state given as `at`.
fn step(law: &BallBall, n: Vec3, size: f64, at: (Body, Body), a: &mut Body, b: &mut Body) {
    let (arm_a, arm_b) = (n * at.0.radius, n * -at.1.radius);
    let surface = |ball: &Body, arm: Vec3| ball.velocity + ball.angular_velocity.cross(arm);
    let relative = surface(&at.0, arm_a) - surface(&at.1, arm_b);
    let slip = relative - n * relative.dot(n);
    let rub = unit(slip) * -(law.friction.a * size);
    push(a, arm_a, rub - n * size);
    push(b, arm_b, -(rub - n * size));
    for (ball, at, load) in [(a, &at.0, -rub.z), (b, &at.1, rub.z)] {
        let foot = UP * -at.radius;
        let slip = Vec3 { z: 0.0, ..surface(at, foot) };
        push(ball, foot, unit(slip) * -(CLOTH.sliding_friction * load.max(0.0)));
    }
}

fn stepped(law: &BallBall, n: Vec3, mut a: Body, mut b: Body) -> (Body, Body) {
    let approach = |a: &Body, b: &Body| (a.velocity - b.velocity).dot(n);
    let reduced = a.mass * b.mass / (a.mass + b.mass);
    let size = (1.0 + law.restitution) * reduced * approach(&a, &b) / f64::from(STEPS);
    let (mut work, mut end) = (0.0, f64::NEG_INFINITY);
    loop {
        let w = approach(&a, &b);
        if end == f64::NEG_INFINITY && w <= 0.0 {
            // Up to the maximum of the parabola of the work.
            end = (work + 0.5 * reduced * w * w) * (1.0 - law.restitution * law.restitution);
        }
        let before = (a, b, work);
        let (mut half_a, mut half_b) = (a, b);
        step(law, n, 0.5 * size, (a, b), &mut half_a, &mut half_b);
        step(law, n, size, (half_a, half_b), &mut a, &mut b);
        work += 0.5 * size * (w + approach(&a, &b));
        if work <= end {
            let share = (before.2 - end) / (before.2 - work);
            return (between(&before.0, &a, share), between(&before.1, &b, share));
        }
    }
}

fn between(from: &Body, to: &Body, share: f64) -> Body {
    let mix = |from: Vec3, to: Vec3| from + (to - from) * share;
    Body {
        velocity: mix(from.velocity, to.velocity),
        angular_velocity: mix(from.angular_velocity, to.angular_velocity),
        ..*from
    }
}

#[test]
fn results_agree_with_the_papers_equations_in_small_steps() {
    let ball = |v: [f64; 3], w: [f64; 3]| Body {
        velocity: v.into(),
        angular_velocity: w.into(),
        mass: 0.1406,
        radius: 0.02625,
    };
    let rolling = [-1.5 / 0.02625, 0.0, 0.0];
    let cases = [
        (law(0.89, 0.05), 30.0, rolling, [0.0; 3], SMOOTH),
        (law(0.89, 0.05), -50.0, rolling, [0.0; 3], SMOOTH),
        (law(0.95, 0.2), 20.0, [10.0, -5.0, 30.0], [0.0; 3], CHATTER),
        (law(0.5, 0.1), 60.0, [80.0, 0.0, -60.0], [10.0, 20.0, 30.0], SMOOTH),
        (law(1.0, 0.06), 5.0, [0.0, 0.0, 5.0], [0.0; 3], CHATTER),
        (law(0.8, 0.3), 45.0, [40.0, 40.0, 0.0], [0.0, -30.0, 0.0], CHATTER),
        (law(0.0, 0.05), 15.0, [0.0; 3], [0.0; 3], SMOOTH),
    ];
    for (law, cut, spin_a, spin_b, tolerance) in cases {
        let (a, b) = (ball([0.0, 1.5, 0.0], spin_a), ball([0.1, 0.0, 0.0], spin_b));
        let n = Vec3::new(sin(radians(cut)), cos(radians(cut)), 0.0);
        let (mut ours_a, mut ours_b) = (a, b);
        ball_ball::resolve(&law, &CLOTH, n, &mut ours_a, &mut ours_b);
        let (their_a, their_b) = stepped(&law, n, a, b);
        for (ours, theirs) in [(ours_a, their_a), (ours_b, their_b)] {
            let gap = (ours.velocity - theirs.velocity).length()
                + ours.radius * (ours.angular_velocity - theirs.angular_velocity).length();
            assert_near(gap, 0.0, tolerance);
        }
    }
}

#[test]
fn friction_of_the_cloth_acts_on_the_ball_that_the_collision_presses_down() {
    let still =
        Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, mass: 0.1406, radius: 0.02625 };
    for (spin, pressed) in [(-60.0, 1), (60.0, 0)] {
        let mut balls = [
            Body {
                velocity: Vec3::new(0.0, 1.5, 0.0),
                angular_velocity: Vec3::new(spin, 0.0, 0.0),
                ..still
            },
            still,
        ];
        let momentum = |balls: &[Body; 2]| balls[0].velocity.y + balls[1].velocity.y;
        let before = momentum(&balls);
        let (law, n) = (law(0.89, 0.05), Vec3::new(0.0, 1.0, 0.0));
        let [a, b] = &mut balls;
        ball_ball::resolve(&law, &CLOTH, n, a, b);
        // A follow shot presses the object ball down, which slides forwards and is braked. A draw
        // shot presses the cue ball down, whose surface also slides forwards.
        let lost = before - momentum(&balls);
        let normal = [1.5 - balls[0].velocity.y, balls[1].velocity.y][1 - pressed];
        assert_near(lost, 0.212 * 0.05 * normal, 1e-9);
        // Friction between the balls gives both the same spin; the difference is due to the cloth.
        let change = [balls[0].angular_velocity.x - spin, balls[1].angular_velocity.x];
        let cloth = change[pressed] - change[1 - pressed];
        assert_near(cloth * 0.02625 / 2.5, -lost, 1e-9);
    }
}
