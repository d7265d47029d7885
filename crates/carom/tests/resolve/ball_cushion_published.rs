//! Published rebounds from a cushion, each test named after its source.

use carom::Physics;
use carom::math::{Vec3, atan2, radians, sin_cos, sqrt};
use carom::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::resolve::{Body, ball_cushion::resolve};

/// Mathavan 2010: ball, nose height 7R/5, and the parameters fitted to the film.
const SNOOKER: (f64, f64) = (0.1406, 0.02625);
const MATHAVAN_SIN: f64 = 0.4;

fn law(model: CushionModel, e: f64, mu: f64) -> Cushion {
    Cushion {
        model,
        restitution: CushionRestitution::constant(e),
        friction: CushionFriction { a: mu, b: 0.0 },
        frequency_ratio: 1.7,
        ..Physics::pool().cushion
    }
}

fn cloth(mu: f64) -> Cloth {
    Cloth { sliding_friction: mu, ..Physics::pool().cloth }
}

/// Rebound of a ball of 1 m/s by Mathavan's model: speed ratio, and angle from the rail (degrees).
/// The ball comes in at `alpha` degrees from the rail, with `k_t` times the spin of rolling and
/// `k_s` times that as sidespin.
fn mathavan(alpha: f64, k_t: f64, k_s: f64, speed: f64) -> (f64, f64) {
    let (sin, cos) = sin_cos(radians(alpha));
    let (mass, radius) = SNOOKER;
    let w = speed / radius;
    let mut ball = Body {
        velocity: Vec3::new(sin, cos, 0.0) * speed,
        angular_velocity: Vec3::new(-cos * k_t, sin * k_t, k_s) * w,
        mass,
        radius,
    };
    let law = law(CushionModel::Mathavan2010, 0.98, 0.14);
    resolve(&law, &cloth(0.212), nose(MATHAVAN_SIN), true, &mut ball);
    let v = ball.velocity;
    (v.length() / speed, atan2(-v.x, v.y).abs() * 180.0 / core::f64::consts::PI)
}

/// From the centre of a ball on the bed to a nose in the direction +x, at `sin` above the centre.
fn nose(sin: f64) -> Vec3 {
    Vec3::new(sqrt(1.0 - sin * sin), 0.0, sin)
}

#[track_caller]
fn assert_close(ours: f64, published: f64, tolerance: f64) {
    assert!((ours - published).abs() <= tolerance, "{ours} against {published} ± {tolerance}");
}

#[test]
fn mathavan_2010_figure_9_perpendicular_rebounds() {
    /// Rows CU-1, CU-2: 0.3 %.
    const TOLERANCE: f64 = 0.003;
    for speed in [0.3, 1.0, 2.4] {
        for (k_t, rebound) in [(1.0, 0.911), (-1.0, 0.866), (0.0, 0.837)] {
            assert_close(mathavan(90.0, k_t, 0.0, speed).0, rebound, TOLERANCE * rebound);
        }
    }
}

#[test]
fn mathavan_2010_figure_9_rolling_at_any_angle() {
    /// Row CU-3: 0.5 %, 0.3°.
    const SPEED: f64 = 0.005;
    const ANGLE: f64 = 0.3;
    for (alpha, rebound, angle) in [
        (10.0, 0.943, 10.34),
        (20.0, 0.895, 21.75),
        (30.0, 0.861, 34.0),
        (45.0, 0.848, 52.68),
        (60.0, 0.867, 68.83),
        (80.0, 0.905, 83.39),
    ] {
        let (ours, out) = mathavan(alpha, 1.0, 0.0, 1.0);
        assert_close(ours, rebound, SPEED * rebound);
        assert_close(out, angle, ANGLE);
    }
}

#[test]
fn mathavan_2010_figure_10_rolling_with_sidespin() {
    /// Row CU-6: 0.5 %, 0.4°.
    const SPEED: f64 = 0.005;
    const ANGLE: f64 = 0.4;
    for (alpha, k_s, rebound, angle) in [
        (30.0, -1.0, 0.857, 34.5),
        (60.0, -1.0, 0.867, 73.4),
        (90.0, -1.0, 0.967, 103.85),
        (30.0, 1.0, 0.909, 30.5),
        (60.0, 1.0, 0.970, 54.6),
        (90.0, 1.0, 0.968, 76.0),
    ] {
        // The paper's x axis has the opposite direction along the rail.
        let (ours, out) = mathavan(alpha, 1.0, -k_s, 1.0);
        assert_close(ours, rebound, SPEED * rebound);
        assert_close(out, angle, ANGLE);
    }
}

#[test]
fn opposite_sidespins_rebound_at_supplementary_angles() {
    /// Rounding error of the two arctangents in row CU-7. The paper's own curve for k_S = 2
    /// violates the symmetry.
    const ROUNDING: f64 = 1e-12;
    for k_s in [0.5, 1.0, 2.0] {
        // `mathavan` rotates the incidence by its cosine, whose rounding error at 90° is not a
        // mirror image.
        let rebound = |k_s: f64| {
            let (mass, radius) = SNOOKER;
            let mut ball = Body {
                velocity: Vec3::new(1.0, 0.0, 0.0),
                angular_velocity: Vec3::new(0.0, 1.0, k_s) * (1.0 / radius),
                mass,
                radius,
            };
            let law = law(CushionModel::Mathavan2010, 0.98, 0.14);
            resolve(&law, &cloth(0.212), nose(MATHAVAN_SIN), true, &mut ball);
            atan2(-ball.velocity.x, ball.velocity.y)
        };
        assert_close(rebound(k_s) + rebound(-k_s), core::f64::consts::PI, ROUNDING);
    }
}

#[test]
fn stronge_agrees_with_an_independent_integration() {
    /// Row CU-11: the digits given there.
    const TOLERANCE: f64 = 1e-4;
    // Final slip divided by approach speed, positive if the slip has changed its direction.
    for (ratio, last) in [
        (0.05, -0.007_00),
        (0.2, 0.022_79),
        (0.4, 0.190_84),
        (0.8, 0.383_19),
        (1.2, 0.095_00),
        (1.6, -0.305_00),
    ] {
        let (mass, radius) = (0.17, 0.028_575);
        let mut ball = Body {
            velocity: Vec3::new(1.0, ratio, 0.0),
            angular_velocity: Vec3::ZERO,
            mass,
            radius,
        };
        let law = law(CushionModel::Stronge, 0.85, 0.2);
        resolve(&law, &cloth(0.2), nose(0.0), true, &mut ball);
        let slip = ball.velocity.y + radius * ball.angular_velocity.z;
        assert_close(-slip, last, TOLERANCE);
        assert_close(ball.velocity.x, -0.85, 1e-15);
    }
}

#[test]
fn tp_6_3_a_frictionless_rail_turns_tangents_by_restitution() {
    /// Row CU-13; rounding.
    const ROUNDING: f64 = 1e-14;
    for model in [CushionModel::Restitution, CushionModel::Han2005, CushionModel::Stronge] {
        for angle in [5.0, 30.0, 60.0, 85.0] {
            let (sin, cos) = sin_cos(radians(angle));
            let mut ball = Body {
                velocity: Vec3::new(cos, sin, 0.0) * 2.0,
                angular_velocity: Vec3::new(3.0, -20.0, 40.0),
                mass: 0.17,
                radius: 0.028_575,
            };
            let spin = ball.angular_velocity;
            resolve(&law(model, 0.7, 0.0), &cloth(0.2), nose(0.0), true, &mut ball);
            let out = ball.velocity.y / -ball.velocity.x;
            assert_close(out * 0.7 * cos / sin, 1.0, ROUNDING);
            assert_eq!(ball.angular_velocity, spin);
        }
    }
}

#[test]
fn tp_7_3_a_rail_that_pushes_above_the_centre() {
    /// Row CU-9: ft/s and rad/s.
    const TOLERANCE: f64 = 0.01;
    // The rail of TP 7.3 is not a model of the engine: friction σμ at the height of the centre, and
    // the normal impulse `a` above it. The formula is checked with that impulse on the equations of
    // a `Body`.
    const FOOT: f64 = 0.3048;
    let (e, mu, radius) = (0.7, 0.17, 1.125 * 0.0254);
    let (v, a) = (5.0 * FOOT, 0.08 * radius);
    let w = v / radius;
    let impulse = (1.0 + e) * v;
    // For a rolling ball the surface at the nose moves down, and friction lifts it.
    let turn = 2.5 / (radius * radius) * impulse * (mu * radius + a);
    assert_close((impulse - v) / FOOT, 3.5, TOLERANCE);
    assert_close(turn - w, 3.333, TOLERANCE);
    assert_close(e * v / radius, 37.33, TOLERANCE);

    // Han's rail with its nose at the height of the centre has the same friction if the ball slips
    // until the end.
    let w = 2.0 * w;
    let mut ball = Body {
        velocity: Vec3::new(v, 0.0, 0.0),
        angular_velocity: Vec3::new(0.0, w, 0.0),
        mass: 0.17,
        radius,
    };
    resolve(&law(CushionModel::Han2005, e, mu), &cloth(0.2), nose(0.0), true, &mut ball);
    assert_close(-ball.velocity.x, e * v, 1e-14);
    assert_close(ball.angular_velocity.y, w - 2.5 / radius * impulse * mu, 1e-12);
}

#[test]
fn tp_b_6_a_ball_that_stuns_on_every_rebound() {
    /// Row CU-14: 0.1 %.
    const TOLERANCE: f64 = 0.001;
    const FOOT: f64 = 0.3048;
    const MILE_PER_HOUR: f64 = 0.447_04;
    const GRAVITY: f64 = 9.807;
    /// The centre's distance between two rebounds, 100 in.
    const LEG: f64 = 100.0 * 0.0254;
    let (mu_s, mu_r, e) = (0.2, 0.01, 0.7);

    // One length of the table from rolling (or from stun, where `slide` is the distance until the
    // ball rolls): the distance that is left to roll, or the speed at the end.
    let travel = |mut v: f64| {
        let mut way = 0.0;
        let mut stun = false;
        loop {
            let (slide, rolling) = if stun {
                ((24.0 / 49.0) * v * v / (2.0 * mu_s * GRAVITY), 5.0 / 7.0 * v)
            } else {
                (0.0, v)
            };
            let stop = rolling * rolling / (2.0 * mu_r * GRAVITY);
            if slide + stop <= LEG {
                return way + slide + stop;
            }
            let last = sqrt(rolling * rolling - 2.0 * mu_r * GRAVITY * (LEG - slide));
            let mut ball = Body {
                velocity: Vec3::new(last, 0.0, 0.0),
                angular_velocity: Vec3::ZERO,
                mass: 0.17,
                radius: 0.028_575,
            };
            let rail = law(CushionModel::Restitution, e, 0.0);
            resolve(&rail, &cloth(mu_s), nose(0.27), true, &mut ball);
            v = -ball.velocity.x;
            way += LEG;
            stun = true;
        }
    };
    for (speed, feet) in [(1.5, 7.522), (3.0, 14.033), (7.0, 25.041)] {
        assert_close(travel(speed * MILE_PER_HOUR) / FOOT, feet, TOLERANCE * feet);
    }
    assert_close(travel(3.465 * MILE_PER_HOUR) / LEG, 2.0, 2.0 * TOLERANCE);
}

/// FastFiz.h: the speed along a rail × 0.9, against it × 0.6, the spin × 0.1.
#[test]
fn poolfiz_multiplies_the_two_speeds_and_the_spin() {
    /// For numbers up to 70.
    const ROUNDING: f64 = 1e-13;
    let physics = carom::Physics::poolfiz();
    for on_bed in [true, false] {
        let mut ball = Body {
            velocity: Vec3::new(2.0, 1.0, 0.0),
            angular_velocity: Vec3::new(-30.0, 50.0, 70.0),
            mass: physics.ball.mass,
            radius: physics.ball.radius,
        };
        resolve(&physics.cushion, &physics.cloth, nose(0.0), on_bed, &mut ball);
        let expected = [(-1.2, 0.9), (-3.0, 5.0)];
        let (v, w) = (ball.velocity, ball.angular_velocity);
        for ((x, y), (a, b)) in expected.into_iter().zip([(v.x, v.y), (w.x, w.y)]) {
            assert_close(a, x, ROUNDING);
            assert_close(b, y, ROUNDING);
        }
        assert_close(w.z, 7.0, ROUNDING);
        assert_eq!(v.z, 0.0);
    }
}

#[test]
fn the_fits_of_han_2005_are_as_published_and_stay_physical() {
    const ROUNDING: f64 = 1e-12;
    let fit = Cushion {
        restitution: CushionRestitution::polynomial(0.39, 0.257, -0.044),
        friction: CushionFriction { a: 0.471, b: -0.241 },
        ..law(CushionModel::Han2005, 0.0, 0.0)
    };
    let rebound = |v: f64, along: f64| {
        let mut ball = Body {
            velocity: Vec3::new(v, along, 0.0),
            angular_velocity: Vec3::ZERO,
            mass: 0.23,
            radius: 0.032_75,
        };
        resolve(&fit, &cloth(0.07), nose(0.0), true, &mut ball);
        ball.velocity
    };
    for v in [0.2, 1.0, 2.5, 4.0] {
        let e = 0.39 + 0.257 * v - 0.044 * v * v;
        // At 60° the ball slips until the end: Δv_y = μ(1 + e)V.
        let along = v * sqrt(3.0);
        let mu = 0.471 - 0.241 * core::f64::consts::FRAC_PI_3;
        let out = rebound(v, along);
        assert_close(-out.x / v, e, ROUNDING);
        assert_close((along - out.y) / v, mu * (1.0 + e), ROUNDING);
    }
    // Beyond 7.1 m/s the fit is below 0.
    assert_eq!(rebound(9.0, 0.0).x, 0.0);
}
