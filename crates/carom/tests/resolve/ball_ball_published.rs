//! Published numbers of ball–ball collisions (Alciatore's technical proofs, Kim, Mathavan).

use std::sync::LazyLock;

use crate::near::assert_near;
use carom::Physics;
use carom::math::{Vec2, Vec3, asin, atan2, cos, radians, sin};
use carom::physics::{BallBall, BallBallModel, Cloth, SlipFriction};
use carom::resolve::{Body, ball_ball};

const MPH: f64 = 0.44704;
/// Alciatore's ball, inches to metres: 1⅛ in.
const RADIUS: f64 = 0.028575;
static CLOTH: LazyLock<Cloth> =
    LazyLock::new(|| Cloth { sliding_friction: 0.2, ..Physics::pool().cloth });
/// TP A.14.
const ALCIATORE: SlipFriction = SlipFriction { a: 0.009951, b: 0.108, c: 1.088 };

fn degrees(angle: f64) -> f64 {
    angle / radians(1.0)
}

fn law(restitution: f64, friction: SlipFriction) -> BallBall {
    BallBall {
        model: BallBallModel::Frictional,
        restitution,
        friction,
        ..Physics::pool().ball_ball
    }
}

/// The cue ball moves along +y at `speed` with `spin` and hits a resting equal ball. The line of
/// centres is turned clockwise by `cut`.
fn collide(law: &BallBall, speed: f64, spin: Vec3, cut: f64) -> (Body, Body) {
    let body = |velocity, angular_velocity| Body {
        velocity,
        angular_velocity,
        mass: 0.17,
        radius: RADIUS,
    };
    let mut cue = body(Vec3::new(0.0, speed, 0.0), spin);
    let mut object = body(Vec3::ZERO, Vec3::ZERO);
    let normal = Vec3::new(sin(cut), cos(cut), 0.0);
    ball_ball::resolve(law, &CLOTH, normal, &mut cue, &mut object);
    (cue, object)
}

/// Spin of a ball that rolls along +y.
fn rolling(speed: f64) -> Vec3 {
    Vec3::new(-speed / RADIUS, 0.0, 0.0)
}

/// Final rolling velocity v − 2/7·u (TP 4.1, A.19).
fn rolled_out(ball: &Body) -> Vec2 {
    let slip = carom::ball::cloth_slip(ball.velocity, ball.angular_velocity, ball.radius);
    ball.velocity.xy() - slip * (2.0 / 7.0)
}

/// Angle of `v` clockwise from +y, degrees.
fn bearing(v: Vec2) -> f64 {
    degrees(atan2(v.x, v.y))
}

/// Throw: the angle between the object ball's direction and the line of centres, positive towards
/// the cue ball's direction of motion, degrees.
fn throw(law: &BallBall, speed: f64, spin: Vec3, cut: f64) -> f64 {
    let (_, object) = collide(law, speed, spin, cut);
    degrees(cut) - bearing(object.velocity.xy())
}

fn maximum(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(a) < f(b) { low = a } else { high = b }
    }
    (low, f(low))
}

#[test]
fn bb1_a_stun_shot_without_losses_parts_at_a_right_angle() {
    for model in BallBallModel::ALL {
        let law = BallBall { model, ..law(1.0, SlipFriction::constant(0.0)) };
        for step in 1..90 {
            let cut = radians(f64::from(step));
            let (cue, object) = collide(&law, 2.0, Vec3::ZERO, cut);
            assert_near(cue.velocity.length(), 2.0 * sin(cut), 1e-9);
            assert_near(object.velocity.length(), 2.0 * cos(cut), 1e-9);
            assert_near(cue.velocity.dot(object.velocity), 0.0, 1e-9);
        }
    }
}

#[test]
fn bb2_a_rolling_cue_ball_is_deflected_by_about_thirty_degrees() {
    let law = law(1.0, SlipFriction::constant(0.0));
    let deflection = |cut: f64| {
        let (cue, _) = collide(&law, 1.0, rolling(1.0), cut);
        bearing(rolled_out(&cue)).abs()
    };
    for (fraction, expected) in [(0.25, 27.267), (0.5, 33.670), (0.75, 27.626)] {
        assert_near(deflection(asin(1.0 - fraction)), expected, 1e-3);
    }
    let (cut, most) = maximum(deflection, 0.1, 1.2);
    assert_near(most, 33.749, 1e-3);
    assert_near(degrees(cut), 28.126, 1e-3);
}

#[test]
fn bb3_restitution_and_friction_each_close_the_right_angle_of_a_stun_shot() {
    let mu = SlipFriction::constant;
    let separation = |law: &BallBall| {
        let (cue, object) = collide(law, 1.0, Vec3::ZERO, radians(30.0));
        (bearing(object.velocity.xy()), bearing(cue.velocity.xy()))
    };
    let (object, cue) = separation(&law(0.94, mu(0.06)));
    assert_near(30.0 - object, 3.434, 1e-3);
    assert_near(60.0 + cue, 3.307, 1e-3);
    for (law, expected) in
        [(law(0.94, mu(0.06)), 83.259), (law(0.94, mu(0.0)), 87.025), (law(1.0, mu(0.06)), 86.566)]
    {
        let (object, cue) = separation(&law);
        assert_near(object - cue, expected, 1e-3);
    }
}

#[test]
fn bb5_a_rolling_half_ball_hit_with_restitution_and_friction() {
    let mu = SlipFriction::constant;
    for (law, expected) in
        [(law(1.0, mu(0.06)), 35.907), (law(0.94, mu(0.0)), 31.988), (law(0.94, mu(0.06)), 34.026)]
    {
        let (cue, _) = collide(&law, 1.0, rolling(1.0), radians(30.0));
        assert_near(bearing(rolled_out(&cue)).abs(), expected, 2e-3);
    }
}

#[test]
fn bb7_throw_of_a_stun_shot_with_alciatores_friction() {
    let law = law(1.0, ALCIATORE);
    let table = [
        (10.0, [1.443, 1.443, 1.443]),
        (30.0, [4.715, 3.549, 1.697]),
        (45.0, [4.945, 2.773, 1.127]),
        (60.0, [4.621, 2.318, 0.894]),
    ];
    for (cut, expected) in table {
        for (speed, expected) in [0.447, 1.341, 3.129].into_iter().zip(expected) {
            assert_near(throw(&law, speed, Vec3::ZERO, radians(cut)), expected, 2e-3);
        }
    }
}

#[test]
fn bb8_throw_is_greatest_at_a_cut_that_falls_with_speed() {
    let law = law(1.0, ALCIATORE);
    for (speed, angle, at) in [(0.447, 5.302, 33.0), (1.341, 3.876, 25.4), (3.129, 2.698, 18.26)] {
        let (cut, most) = maximum(|cut| throw(&law, speed, Vec3::ZERO, cut), 0.05, 1.2);
        assert_near(most, angle, 5e-3);
        assert_near(degrees(cut), at, 0.1);
    }
}

#[test]
fn bb10_throw_by_english_on_a_straight_shot() {
    let law = law(1.0, ALCIATORE);
    let table =
        [(0.25, [2.556, 2.556, 2.556]), (0.5, [5.102, 3.053, 1.307]), (1.0, [3.933, 1.568, 0.658])];
    for (english, expected) in table {
        for (speed, expected) in [0.447, 1.341, 3.129].into_iter().zip(expected) {
            let spin = Vec3::new(0.0, 0.0, 1.25 * english * speed / RADIUS);
            // Right English throws the object ball to the left.
            assert_near(throw(&law, speed, spin, 0.0), expected, 2e-3);
        }
    }
}

#[test]
fn bb11_follow_and_draw_reduce_throw_alike() {
    let law = law(1.0, ALCIATORE);
    let (speed, cut) = (2.0 * MPH, radians(30.0));
    assert_near(throw(&law, speed, Vec3::ZERO, cut), 4.366, 2e-3);
    assert_near(throw(&law, speed, rolling(speed), cut), 1.454, 2e-3);
    assert_near(throw(&law, speed, -rolling(speed), cut), 1.454, 2e-3);
}

#[test]
fn bb11_the_spin_that_follow_and_draw_give_the_object_ball_curves_it_oppositely() {
    let law = law(1.0, ALCIATORE);
    let (speed, cut) = (2.0 * MPH, radians(30.0));
    for (spin, expected) in [(rolling(speed), 0.067), (-rolling(speed), 0.061)] {
        let (_, object) = collide(&law, speed, spin, cut);
        let swerve = bearing(rolled_out(&object)) - bearing(object.velocity.xy());
        assert_near(swerve.abs(), expected, 2e-3);
    }
}

#[test]
fn bb13_a_straight_stop_shot_with_english_gives_at_most_five_fourteenths_of_the_spin() {
    let law = law(1.0, ALCIATORE);
    for (speed, expected) in [(0.447, 35.7), (1.341, 21.3), (3.129, 9.1)] {
        let spin = Vec3::new(0.0, 0.0, 0.5 * 1.25 * speed / RADIUS);
        let (_, object) = collide(&law, speed, spin, 0.0);
        let given = -100.0 * object.angular_velocity.z / spin.z;
        assert_near(given, expected, 0.1);
        assert!(given <= 100.0 * 5.0 / 14.0 + 1e-12);
    }
}

#[test]
fn bb15_shares_of_the_speed_after_a_rolling_hit() {
    let law = law(1.0, SlipFriction::constant(0.0));
    let shares = |cut: f64| {
        let (cue, object) = collide(&law, 1.0, rolling(1.0), cut);
        (100.0 * rolled_out(&object).length(), 100.0 * rolled_out(&cue).length())
    };
    let (object, cue) = shares(radians(30.0));
    assert_near(object, 61.859, 5e-3);
    assert_near(cue, 55.787, 5e-3);
    let (object, cue) = shares(0.0);
    assert_near(object, 71.429, 5e-3);
    assert_near(cue, 28.571, 5e-3);
    assert_near((object / cue) * (object / cue), 6.25, 1e-3);
    let (object, cue) = shares(radians(33.211));
    assert_near(object, cue, 5e-3);
}

#[test]
fn bb18_a_full_rolling_hit_leaves_the_cue_ball_the_speed_that_restitution_predicts() {
    for (e, expected) in [(1.0, 0.2857), (0.95, 0.3036), (0.94, 0.3071), (0.89, 0.3250)] {
        let (cue, _) = collide(&law(e, SlipFriction::constant(0.0)), 1.0, rolling(1.0), 0.0);
        assert_near(rolled_out(&cue).length(), expected, 1e-4);
    }
}

#[test]
fn bb22_mathavan_2014_on_the_papers_own_shots() {
    // Shots 2 to 4 of the paper's table are those of Mathavan et al. 2009 (row BB20), which has
    // their speeds and cuts. The numbers are those after both balls roll.
    let cloth = Cloth { sliding_friction: 0.21, ..*CLOTH };
    let law =
        BallBall { model: BallBallModel::Mathavan2014, ..law(0.89, SlipFriction::constant(0.05)) };
    let radius = 0.02625;
    let table = [
        (1.032, 26.36, [0.520, 0.599, 32.45, 25.07]),
        (1.364, 40.52, [0.917, 0.676, 29.91, 38.62]),
        (1.731, 46.50, [1.28, 0.780, 27.32, 44.38]),
    ];
    for (speed, cut, expected) in table {
        let body =
            |velocity, angular_velocity| Body { velocity, angular_velocity, mass: 0.1406, radius };
        let mut cue = body(Vec3::new(0.0, speed, 0.0), Vec3::new(-speed / radius, 0.0, 0.0));
        let mut object = body(Vec3::ZERO, Vec3::ZERO);
        let cut = radians(cut);
        let normal = Vec3::new(sin(cut), cos(cut), 0.0);
        ball_ball::resolve(&law, &cloth, normal, &mut cue, &mut object);
        let (cue, object) = (rolled_out(&cue), rolled_out(&object));
        let ours = [cue.length(), object.length(), -bearing(cue), bearing(object)];
        for (ours, expected) in ours.into_iter().zip(expected) {
            assert_near(ours / expected, 1.0, 5e-3);
        }
    }
}
