//! The meaning of a strike's parameters (side, height, elevation and azimuth), from first
//! principles.

use std::sync::LazyLock;

use carom::ball::cloth_slip;
use carom::math::{Vec2, Vec3, cos, radians, sin, sqrt};
use carom::physics::{Cue, Tip};
use carom::resolve::cue_ball::{Strike, resolve};
use carom::{Ball, Physics};

const BALL: Ball = Ball { mass: 0.17, radius: 0.028 };
static CUE: LazyLock<Cue> = LazyLock::new(|| Cue {
    mass: 0.55,
    tip_friction: 0.8,
    tip: Tip::Restitution(0.7),
    ..Physics::ideal().cue
});
/// Rounding error of a few sums and products of numbers near 100.
const ROUNDING: f64 = 1e-11;

/// Azimuths and elevations (degrees), sides and heights (ball radii) over their whole ranges.
fn strikes() -> impl Iterator<Item = Strike> {
    let offsets = [(0.0, 0.0), (0.4, 0.0), (-0.4, 0.3), (0.2, -0.5), (0.0, 0.5)];
    [0.0, 37.0, 90.0, 200.0, 359.0].into_iter().flat_map(move |azimuth| {
        [0.0, 3.0, 30.0, 60.0, 89.0].into_iter().flat_map(move |elevation| {
            offsets.into_iter().map(move |(side, height)| Strike {
                speed: 3.0,
                azimuth: radians(azimuth),
                elevation: radians(elevation),
                side,
                height,
            })
        })
    })
}

fn struck(cue: &Cue, strike: &Strike) -> (Vec3, Vec3) {
    resolve(cue, &BALL, strike).expect("a clean strike")
}

/// Azimuth 90° (the shooter looks along +y, +x is on the right).
fn along_y(elevation: f64, side: f64, height: f64) -> Strike {
    Strike { speed: 3.0, azimuth: radians(90.0), elevation: radians(elevation), side, height }
}

#[test]
fn a_strike_is_one_impulse_along_the_cue_at_the_contact_point() {
    for strike in strikes() {
        // A level cue along +x and its contact point seen from behind; then raised; then turned.
        let (x, y) = (strike.side, strike.height);
        let raise = |v: Vec3| {
            let (s, c) = (sin(strike.elevation), cos(strike.elevation));
            Vec3::new(v.x * c + v.z * s, v.y, v.z * c - v.x * s)
        };
        let turn = |v: Vec3| {
            let (s, c) = (sin(strike.azimuth), cos(strike.azimuth));
            Vec3::new(v.x * c - v.y * s, v.x * s + v.y * c, v.z)
        };
        let cue = turn(raise(Vec3::new(1.0, 0.0, 0.0)));
        let arm = Vec3::new(-sqrt(1.0 - x * x - y * y), -x, y) * BALL.radius;
        let contact = turn(raise(arm));

        let (velocity, spin) = struck(&CUE, &strike);
        let inertia = 0.4 * BALL.mass * BALL.radius * BALL.radius;
        // Newton's law of restitution at the tip: the ball's contact point moves away from the cue
        // with e times the cue's speed.
        let per_impulse =
            1.0 / BALL.mass + 1.0 / CUE.mass + contact.cross(cue).length_squared() / inertia;
        let impulse = 1.7 * strike.speed / per_impulse;
        let expected = contact.cross(cue) * (impulse / inertia);
        assert!((spin - expected).length() < ROUNDING, "{strike:?}: {spin:?}, {expected:?}");
        let expected = cue * (impulse / BALL.mass);
        assert!((velocity - expected).length() < ROUNDING, "{strike:?}");
    }
}

#[test]
fn right_english_spins_the_ball_counter_clockwise_and_left_english_clockwise() {
    for elevation in [0.0, 20.0, 70.0] {
        assert!(struck(&CUE, &along_y(elevation, 0.3, 0.0)).1.z > 0.0);
        assert!(struck(&CUE, &along_y(elevation, -0.3, 0.0)).1.z < 0.0);
    }
}

#[test]
fn a_level_cue_at_height_0_4_makes_the_ball_roll_at_once_and_higher_or_lower_is_follow_or_draw() {
    let slip = |height: f64| {
        let (velocity, spin) = struck(&CUE, &along_y(0.0, 0.0, height));
        assert!(velocity.x.abs() < ROUNDING && velocity.y > 0.0);
        cloth_slip(velocity, spin, BALL.radius).y
    };
    assert!(slip(0.4).abs() < ROUNDING);
    assert!(slip(0.5) < 0.0, "the cloth pushes an over-spinning ball on");
    assert!(slip(0.0) > 0.0 && slip(-0.4) > slip(0.0));
}

#[test]
fn squirt_is_away_from_the_english_and_swerve_towards_it() {
    let shaft = Cue { end_mass: 0.006, ..*CUE };
    for side in [0.4, -0.4] {
        let (velocity, _) = struck(&shaft, &along_y(0.0, side, 0.0));
        assert!(velocity.x * side < 0.0, "{side}: {velocity:?}");
        for elevation in [2.0, 10.0, 60.0] {
            let (velocity, spin) = struck(&CUE, &along_y(elevation, side, 0.0));
            assert!(velocity.x.abs() < ROUNDING);
            // Friction opposes the slip: the ball curves to the side on which it was struck.
            assert!(cloth_slip(velocity, spin, BALL.radius).x * side < 0.0, "{elevation}, {side}");
        }
    }
}

#[test]
fn a_masse_shot_ends_parallel_to_the_line_from_the_balls_foot_to_where_the_cue_points() {
    // TP A.19, after Coriolis: A is where the cue's axis meets the cloth.
    for (elevation, side, height) in [(5.0, 0.4, 0.2), (30.0, -0.3, 0.4), (70.0, 0.35, -0.2)] {
        let strike = along_y(elevation, side, height);
        let (s, c) = (sin(strike.elevation), cos(strike.elevation));
        let ahead = Vec3::new(0.0, c, -s);
        let up = Vec3::new(0.0, s, c);
        let through = (Vec3::new(1.0, 0.0, 0.0) * side + up * height) * BALL.radius;
        let center = Vec3::new(0.0, 0.0, BALL.radius);
        let axis = center + through;
        let foot = (axis + ahead * (axis.z / s)).xy();
        let (velocity, spin) = struck(&CUE, &strike);
        let rolled: Vec2 = velocity.xy() - cloth_slip(velocity, spin, BALL.radius) * (2.0 / 7.0);
        let sine = foot.cross(rolled) / (foot.length() * rolled.length());
        assert!(sine.abs() < ROUNDING && foot.dot(rolled) > 0.0, "{elevation}: {sine}");
    }
}
