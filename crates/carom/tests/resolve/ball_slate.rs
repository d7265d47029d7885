//! A ball on the slate: bounces, the last hop, and launches by a raised cue.

use crate::near::assert_near;
use crate::random::Random;
use carom::Ball;
use carom::Physics;
use carom::ball::cloth_slip;
use carom::math::{Vec2, Vec3, radians, sin_cos, sqrt};
use carom::physics::{Cue, Surface, Tip};
use carom::resolve::Body;
use carom::resolve::ball_slate::{LAST_HOP, bounce, last_hop_speed, settle};
use carom::resolve::cue_ball::{self, Strike};

const GRAVITY: f64 = 9.81;
const MASS: f64 = 0.170097;
const RADIUS: f64 = 0.028575;
const SLATE: Surface = Surface::new(0.6, 0.2);

fn ball(velocity: Vec3, angular_velocity: Vec3) -> Body {
    Body { velocity, angular_velocity, mass: MASS, radius: RADIUS }
}

fn energy(ball: &Body) -> f64 {
    0.5 * ball.mass * ball.velocity.length_squared()
        + 0.2 * ball.mass * ball.radius * ball.radius * ball.angular_velocity.length_squared()
}

fn slip(ball: &Body) -> Vec2 {
    cloth_slip(ball.velocity, ball.angular_velocity, ball.radius)
}

/// Falling balls of any speed and spin, on slates of any kind.
fn falls(check: impl Fn(Surface, Body)) {
    let mut random = Random(1);
    for _ in 0..100_000 {
        let law =
            Surface::new([0.0, 0.5, 0.6, 1.0][random.pick(4)], [0.0, 0.2, 0.7][random.pick(3)]);
        let size = [1e-6, 1e-3, 0.04, 1.0, 10.0][random.pick(5)];
        let spin = [0.0, 1.0, 5.0][random.pick(3)] * size / RADIUS;
        let mut ball = ball(random.vector(size), random.vector(spin));
        ball.velocity.z = -ball.velocity.z.abs();
        check(law, ball);
    }
}

fn bounced(law: &Surface, mut ball: Body) -> Body {
    bounce(law, &mut ball);
    ball
}

fn settled(law: &Surface, mut ball: Body) -> Body {
    settle(law, GRAVITY, &mut ball);
    ball
}

#[test]
fn a_bounce_has_restitution_e_and_friction_mu_and_at_most_stops_the_slip() {
    falls(|law, before| {
        let after = bounced(&law, before);
        let fall = -before.velocity.z;
        assert_eq!(after.velocity.z, law.restitution * fall);
        assert_eq!(after.angular_velocity.z, before.angular_velocity.z);
        let scale = before.velocity.length() + RADIUS * before.angular_velocity.length();
        let (old, new) = (slip(&before), slip(&after));
        let impulse = (after.velocity - before.velocity).xy();
        let expected = (law.friction * (1.0 + law.restitution) * fall).min(old.length() / 3.5);
        assert_near(impulse.length(), expected, 1e-15 * scale);
        assert_near(impulse.cross(old), 0.0, 1e-15 * scale * scale);
        assert!(impulse.dot(old) <= 0.0);
        // The slip falls by 7/2 of the impulse and never changes its direction.
        assert_near((new - old - impulse * 3.5).length(), 0.0, 2e-15 * scale);
        assert!(new.dot(old) >= -1e-15 * scale * scale);
    });
}

#[test]
fn neither_a_bounce_nor_settling_raises_the_energy() {
    falls(|law, before| {
        let most = energy(&before) * (1.0 + 1e-15);
        assert!(energy(&bounced(&law, before)) <= most);
        assert!(energy(&settled(&law, before)) <= most);
    });
}

#[test]
fn mirrored_bounces_are_mirrored_to_the_bit() {
    let flip = |v: Vec3| Vec3 { x: -v.x, ..v };
    falls(|law, before| {
        let image = Body {
            velocity: flip(before.velocity),
            angular_velocity: -flip(before.angular_velocity),
            ..before
        };
        let (ours, theirs) = (bounced(&law, before), bounced(&law, image));
        assert_eq!(theirs.velocity, flip(ours.velocity));
        assert_eq!(theirs.angular_velocity, -flip(ours.angular_velocity));
    });
}

#[test]
fn a_ball_that_settles_loses_only_its_vertical_speed_or_bounces_later() {
    falls(|law, before| {
        let after = settled(&law, before);
        if bounced(&law, before).velocity.z >= last_hop_speed(GRAVITY) {
            assert_eq!(after, before);
        } else if before.velocity.z < 0.0 {
            assert_eq!(after, Body { velocity: before.velocity.xy().with_z(0.0), ..before });
        }
    });
}

#[test]
fn a_rising_ball_flies_from_the_last_hops_speed_on_and_stays_down_below_it() {
    let least = last_hop_speed(GRAVITY);
    assert_near(least * least / (2.0 * GRAVITY), LAST_HOP, 1e-18);
    let rising = |speed: f64| ball(Vec3::new(1.0, 0.5, speed), Vec3::new(3.0, 4.0, 5.0));
    assert_eq!(settled(&SLATE, rising(least)), rising(least));
    assert_eq!(settled(&SLATE, rising(0.999 * least)), rising(0.0));
    assert_eq!(settled(&SLATE, rising(0.0)), rising(0.0));
    let falling = rising(-0.01);
    let mut up = rising(0.01);
    bounce(&SLATE, &mut up);
    assert_eq!(up, rising(0.01), "a rising ball does not bounce");
    assert_eq!(settled(&SLATE, falling), rising(0.0));
}

#[test]
fn sl4_the_apexes_of_a_dropped_ball_shrink_by_the_square_of_restitution_until_the_last_hop() {
    let height = 0.5;
    let mut ball = ball(Vec3::new(0.0, 0.0, -sqrt(2.0 * GRAVITY * height)), Vec3::ZERO);
    let (mut apex, mut time, mut hops) = (height, sqrt(2.0 * height / GRAVITY), 0);
    loop {
        bounce(&SLATE, &mut ball);
        settle(&SLATE, GRAVITY, &mut ball);
        let rise = ball.velocity.z;
        if rise == 0.0 {
            break;
        }
        apex *= 0.6 * 0.6;
        assert_near(rise * rise / (2.0 * GRAVITY) / apex, 1.0, 1e-12);
        assert!(apex >= LAST_HOP * (1.0 - 1e-12));
        time += 2.0 * rise / GRAVITY;
        hops += 1;
        ball.velocity.z = -rise;
    }
    assert_eq!(hops, 9);
    // The geometric series, minus the duration of the omitted hops.
    let all = sqrt(2.0 * height / GRAVITY) * 1.6 / 0.4;
    let left_out = 2.0 * last_hop_speed(GRAVITY) / GRAVITY / 0.4;
    assert!(time < all && time > all - left_out);
}

/// TP B.10: a draw shot by a 19 oz cue at 15 mph, half a radius low.
fn launch(elevation: f64) -> Body {
    let cue = Cue {
        mass: MASS * 19.0 / 6.0,
        tip_friction: 0.8,
        tip: Tip::Efficiency(0.87),
        ..Physics::ideal().cue
    };
    let strike = Strike {
        speed: 15.0 * MPH,
        azimuth: radians(90.0),
        elevation: radians(elevation),
        side: 0.0,
        height: -0.5,
    };
    let struck = Ball { mass: MASS, radius: RADIUS };
    let (velocity, spin) = cue_ball::resolve(&cue, &struck, &strike).expect("a clean strike");
    ball(velocity, spin)
}

const MPH: f64 = 0.44704;
const FOOT: f64 = 0.3048;
/// Gravity in TP B.10, ft/s².
const FEET_PER_SECOND_SQUARED: f64 = 32.174;

/// Length of the ball's hop, m. The ball then moves towards the slate again.
fn hop(ball: &mut Body) -> f64 {
    let rise = ball.velocity.z;
    ball.velocity.z = -rise;
    ball.velocity.xy().length() * 2.0 * rise / (FEET_PER_SECOND_SQUARED * FOOT)
}

#[test]
fn sl1_tp_b_10_a_draw_shot_with_a_cue_raised_by_5_degrees_hops() {
    /// Half a unit of the last digit, and 0.2 %.
    const TOLERANCE: f64 = 0.002;
    let turns = |ball: &Body| ball.angular_velocity.length() / radians(360.0);
    let mut ball = launch(5.0);
    bounce(&SLATE, &mut ball);
    let mut way = 0.0;
    for (n, feet) in [0.848, 0.500, 0.297, 0.177, 0.106].into_iter().enumerate() {
        let published = [(10.855, 32.897, 3.091), (10.658, 31.731, 1.889)];
        if let Some(&(speed, spin, angle)) = published.get(n) {
            assert_near(ball.velocity.length() / MPH / speed, 1.0, TOLERANCE);
            assert_near(turns(&ball) / spin, 1.0, TOLERANCE);
            let rise = carom::math::atan2(ball.velocity.z, ball.velocity.xy().length());
            assert_near(rise / radians(angle), 1.0, TOLERANCE);
        }
        let length = hop(&mut ball) / FOOT;
        assert_near(length, feet, TOLERANCE * feet + 0.0005);
        way += length;
        bounce(&SLATE, &mut ball);
    }
    while way < 2.0 {
        way += hop(&mut ball) / FOOT;
        if way < 2.0 {
            bounce(&SLATE, &mut ball);
        }
    }
    assert_near(turns(&ball) / 30.118, 1.0, TOLERANCE);
    let ratio = RADIUS * ball.angular_velocity.length() / ball.velocity.xy().length();
    assert_near(ratio / 1.164, 1.0, TOLERANCE);
}

#[test]
fn sl3_tp_b_10_a_draw_shot_with_a_cue_raised_by_15_degrees_hops_further() {
    const TOLERANCE: f64 = 0.002;
    let mut ball = launch(15.0);
    bounce(&SLATE, &mut ball);
    let turns = ball.angular_velocity.length() / radians(360.0);
    assert_near(turns / 29.069, 1.0, TOLERANCE);
    assert_near(hop(&mut ball) / FOOT / 2.298, 1.0, TOLERANCE);
}

#[test]
fn tp_a_19_a_masse_shot_keeps_coriolis_direction_however_often_it_hops() {
    const ROUNDING: f64 = 1e-11;
    let cue =
        Cue { mass: 0.55, tip_friction: 0.8, tip: Tip::Restitution(0.7), ..Physics::ideal().cue };
    for (elevation, side, height) in [(5.0, 0.4, 0.2), (30.0, -0.3, 0.4), (70.0, 0.35, -0.2)] {
        for friction in [0.02, 0.1, 0.2] {
            let (s, c) = sin_cos(radians(elevation));
            let strike = Strike {
                speed: 3.0,
                azimuth: radians(90.0),
                elevation: radians(elevation),
                side,
                height,
            };
            let struck = Ball { mass: MASS, radius: RADIUS };
            let (velocity, spin) = cue_ball::resolve(&cue, &struck, &strike).expect("clean");
            let mut ball = ball(velocity, spin);
            let law = Surface::new(0.6, friction);
            loop {
                bounce(&law, &mut ball);
                settle(&law, GRAVITY, &mut ball);
                if ball.velocity.z == 0.0 {
                    break;
                }
                ball.velocity.z = -ball.velocity.z;
            }
            // Sliding ends at v - 2/7 u. A is where the cue's axis meets the cloth.
            let rolled = ball.velocity.xy() - slip(&ball) * (2.0 / 7.0);
            let axis = Vec3::new(side, height * s, 1.0 + height * c) * RADIUS;
            let foot = (axis + Vec3::new(0.0, c, -s) * (axis.z / s)).xy();
            let sine = foot.cross(rolled) / (foot.length() * rolled.length());
            assert!(sine.abs() < ROUNDING && foot.dot(rolled) > 0.0, "{elevation}: {sine}");
        }
    }
}
