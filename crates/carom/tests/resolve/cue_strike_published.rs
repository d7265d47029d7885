//! Published numbers of the cue strike (Alciatore's technical proofs, Shepard, Leckie & Greenspan,
//! pooltool).

use crate::near::assert_near;
use carom::ball::cloth_slip;
use carom::math::{Vec2, Vec3, atan2, cos, radians, sin, sqrt};
use carom::physics::{Cue, Tip};
use carom::resolve::cue_ball::{Strike, StrikeError, miscue_limit, resolve, squirt};
use carom::{Ball, Physics};

const MPH: f64 = 0.44704;
/// Alciatore's 6 oz ball of 2¼ in and 19 oz cue.
const BALL: Ball = Ball { mass: 0.170097, radius: 0.028575 };
const MASS_RATIO: f64 = 6.0 / 19.0;

fn cue(tip: Tip) -> Cue {
    Cue { mass: BALL.mass / MASS_RATIO, tip_friction: 0.8, tip, ..Physics::ideal().cue }
}

fn level(speed: f64, side: f64, height: f64) -> Strike {
    Strike { speed, azimuth: radians(90.0), elevation: 0.0, side, height }
}

fn degrees(angle: f64) -> f64 {
    angle / radians(1.0)
}

/// Final rolling velocity v − 2/7·u (TP 4.1, A.19).
fn rolled_out((velocity, spin): (Vec3, Vec3)) -> Vec2 {
    velocity.xy() - cloth_slip(velocity, spin, BALL.radius) * (2.0 / 7.0)
}

#[test]
fn cu1_ball_speed_of_a_centre_hit_with_tip_efficiency() {
    let (v, spin) = resolve(&cue(Tip::Efficiency(0.87)), &BALL, &level(1.0, 0.0, 0.0)).unwrap();
    assert_near(v.y, 1.2745, 1e-4);
    assert_eq!((v.z, spin.length()), (0.0, 0.0));
}

#[test]
fn cu2_ball_speed_and_spin_of_a_hit_at_half_a_radius() {
    let cue = cue(Tip::Efficiency(0.87));
    for (side, height) in [(0.5, 0.0), (-0.5, 0.0), (0.0, 0.5), (0.3, -0.4)] {
        let (v, spin) = resolve(&cue, &BALL, &level(15.0 * MPH, side, height)).unwrap();
        assert_near(v.length() / MPH, 11.194, 1e-3);
        assert_near(v.length() / (15.0 * MPH), 0.74628, 1e-3);
        assert_near(spin.length() / radians(360.0), 34.841, 1e-3);
    }
}

#[test]
fn cu4_ball_speed_of_a_leather_and_a_phenolic_tip() {
    let speed = |e| resolve(&cue(Tip::Restitution(e)), &BALL, &level(1.0, 0.0, 0.0)).unwrap().0.y;
    let (leather, phenolic) = (speed(0.73), speed(0.87));
    assert_near(leather, 1.3148, 1e-3);
    assert_near(phenolic, 1.4212, 1e-3);
    assert_near((phenolic / leather) * (phenolic / leather), 1.168, 1e-3);
}

#[test]
fn restitution_and_efficiency_agree_for_a_centre_hit() {
    let e = 0.73;
    let efficiency = {
        let lost = 1.0 - MASS_RATIO * e;
        let gain = (1.0 + e) * (1.0 + e);
        (lost * lost + MASS_RATIO * gain) / ((1.0 + MASS_RATIO) * (1.0 + MASS_RATIO))
    };
    let speed = |tip| resolve(&cue(tip), &BALL, &level(1.0, 0.0, 0.0)).unwrap().0.y;
    assert_near(speed(Tip::Restitution(e)), speed(Tip::Efficiency(efficiency)), 1e-12);
}

#[test]
fn cu6_the_fastest_rolling_ball_is_struck_above_centre() {
    let cue = cue(Tip::Restitution(1.0));
    let rolled = |height| rolled_out(resolve(&cue, &BALL, &level(1.0, 0.0, height)).unwrap()).y;
    let (mut low, mut high) = (0.0, 0.5);
    for _ in 0..100 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if rolled(a) < rolled(b) { low = a } else { high = b }
    }
    assert_near(low, sqrt(1.4 + 0.4 * MASS_RATIO) - 1.0, 1e-6);
    assert_near(low, 0.235, 1e-3);
}

#[test]
fn cu7_the_tip_slips_off_beyond_its_friction() {
    assert_near(miscue_limit(0.577), 0.5, 1e-3);
    assert_near(miscue_limit(0.659), 0.55, 1e-3);
    let cue = Cue { tip_friction: 0.577, ..cue(Tip::Restitution(0.73)) };
    let refused = resolve(&cue, &BALL, &level(1.0, 0.36, 0.36)).unwrap_err();
    assert!(matches!(refused, StrikeError::Miscue { .. }));
    assert!(refused.to_string().contains("slips off beyond 0.4998"), "{refused}");
    let (v, spin) = resolve(&cue, &BALL, &level(1.0, 0.35, 0.35)).unwrap();
    assert_near(spin.length() * BALL.radius / v.length(), 2.5 * 0.35 * sqrt(2.0), 1e-12);
}

#[test]
fn cu8_squirt_for_four_end_masses_to_the_left_of_right_english_at_any_speed() {
    for (ratio, expected) in [(15.0, 3.466), (20.0, 2.709), (40.0, 1.446), (160.0 / 3.0, 1.103)] {
        let cue = Cue { end_mass: BALL.mass / ratio, ..cue(Tip::Restitution(0.73)) };
        assert_near(degrees(squirt(&cue, &BALL, 0.5)), expected, 1e-3);
        for speed in [0.1, 1.0, 10.0] {
            let (v, spin) = resolve(&cue, &BALL, &level(speed, 0.5, 0.0)).unwrap();
            assert_near(degrees(atan2(v.y, v.x)), 90.0 + expected, 1e-3);
            assert!(spin.z > 0.0);
        }
    }
}

#[test]
fn cl10_a_masse_shot_ends_in_coriolis_direction_at_any_speed() {
    // TP A.19 measures b downwards.
    let offset = 0.5 * cos(radians(45.0));
    for speed in [0.5, 3.0, 9.0] {
        let strike = Strike { elevation: radians(4.0), ..level(speed, offset, -offset) };
        let v = rolled_out(resolve(&cue(Tip::Restitution(0.73)), &BALL, &strike).unwrap());
        // Right English with a raised butt curves the ball to the right.
        assert_near(degrees(atan2(v.x, v.y)), 2.193, 5e-3);
    }
}

#[test]
fn cl12_a_steep_masse_shot_slides_to_the_side() {
    let strike = Strike { elevation: radians(75.0), ..level(1.0, 0.25, -0.25) };
    let cue = cue(Tip::Restitution(0.73));
    // The row gives the ball's speed along the cue's axis.
    let ratio = 1.73 / (MASS_RATIO + 1.0 + 2.5 * 0.125);
    let strike = Strike { speed: 9.0 * MPH / ratio, ..strike };
    let launch = resolve(&cue, &BALL, &strike).unwrap();
    assert_near(launch.0.y, 9.0 * MPH * cos(radians(75.0)), 1e-12);
    let slip = cloth_slip(launch.0, launch.1, BALL.radius);
    let (gravity, friction) = (9.807, 0.2);
    let time = 2.0 * slip.length() / (7.0 * friction * gravity);
    assert_near(time / 0.6273, 1.0, 1e-3);
    let end =
        launch.0.xy() * time - slip * (0.5 * friction * gravity * time * time / slip.length());
    assert_near(end.x / 0.2177, 1.0, 1e-3);
    assert_near(end.y / 0.3346, 1.0, 1e-3);
    let v = rolled_out(launch);
    assert_near(v.length() / 0.6944, 1.0, 1e-3);
    assert_near(degrees(atan2(v.x, v.y)), 87.908, 5e-3);
}

#[test]
fn leckie_and_greenspans_own_expressions_give_the_same_launch_at_every_elevation() {
    let cue = cue(Tip::Restitution(1.0));
    for (side, height, elevation) in
        [(0.3, 0.2, 0.0), (0.3, -0.2, 10.0), (-0.4, 0.3, 45.0), (0.1, -0.45, 80.0)]
    {
        let theta = radians(elevation);
        let q = sqrt(1.0 - side * side - height * height);
        // a to the left, b upwards, c towards the shooter; x to the right, y towards the shooter.
        let (a, b, c) =
            (-side, height * cos(theta) + q * sin(theta), q * cos(theta) - height * sin(theta));
        let inertia = a * a + b * cos(theta) * b * cos(theta) + c * sin(theta) * c * sin(theta)
            - 2.0 * b * c * cos(theta) * sin(theta);
        let impulse = 2.0 * BALL.mass * 3.0 / (1.0 + MASS_RATIO + 2.5 * inertia);
        let per_spin = 2.5 * impulse / (BALL.mass * BALL.radius);
        let theirs =
            Vec3::new(-c * sin(theta) + b * cos(theta), a * sin(theta), -a * cos(theta)) * per_spin;
        let strike = Strike { speed: 3.0, azimuth: radians(90.0), elevation: theta, side, height };
        let (v, spin) = resolve(&cue, &BALL, &strike).unwrap();
        assert_near(v.y, impulse / BALL.mass * cos(theta), 1e-12);
        assert_near(v.z, -impulse / BALL.mass * sin(theta), 1e-12);
        // Their y axis points towards the shooter and so their x axis points to the left.
        assert_near(spin.x, -theirs.x, 1e-9);
        assert_near(spin.y, -theirs.y, 1e-9);
        assert_near(spin.z, theirs.z, 1e-9);
    }
}

#[test]
fn rejects_a_tip_that_misses_the_ball_and_an_unreachable_efficiency_with_a_remedy() {
    let refused =
        |cue: &Cue, side, height| resolve(cue, &BALL, &level(1.0, side, height)).unwrap_err();
    let sticky = Cue { tip_friction: 10.0, ..cue(Tip::Efficiency(0.87)) };
    let off = refused(&sticky, 0.8, -0.6);
    assert!(matches!(off, StrikeError::OffBall { .. }), "{off:?}");
    assert!(off.to_string().contains("below 1"));
    let unreachable = refused(&sticky, 0.0, 0.7);
    assert!(matches!(unreachable, StrikeError::Unreachable { .. }), "{unreachable:?}");
    assert!(unreachable.to_string().contains("cue.tip_restitution"));
}

#[test]
fn the_cue_strike_agrees_with_pooltools() {
    let cue = Cue {
        mass: 0.567,
        end_mass: BALL.mass / 30.0,
        tip_friction: 100.0,
        ..cue(Tip::Restitution(1.0))
    };
    let mut compared = 0;
    for line in
        include_str!("../data/pooltool_cue_ball.txt").lines().filter(|l| !l.starts_with('#'))
    {
        let row: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        let [speed, phi, theta, a, b, vx, vy, wx, wy, wz] = row[..] else { panic!("{line}") };
        let strike =
            Strike { speed, azimuth: radians(phi), elevation: radians(theta), side: -a, height: b };
        let (v, spin) = resolve(&cue, &BALL, &strike).unwrap();
        for (ours, theirs) in spin.to_array().into_iter().zip([wx, wy, wz]) {
            assert_near(ours, theirs, 1e-10);
        }
        // pooltool rotates the horizontal velocity by the squirt angle; we rotate the whole
        // velocity, so that the sideways speed does not decrease with elevation.
        let alpha = squirt(&cue, &BALL, strike.side);
        let push = sqrt(vx * vx + vy * vy) / cos(strike.elevation);
        let sideways = v.xy().dot(Vec2::new(sin(strike.azimuth), -cos(strike.azimuth)));
        assert_near(sideways, -push * sin(alpha), 1e-12);
        if theta == 0.0 {
            assert_near(v.x, vx, 1e-12);
            assert_near(v.y, vy, 1e-12);
        }
        compared += 1;
    }
    assert_eq!(compared, 40);
}
