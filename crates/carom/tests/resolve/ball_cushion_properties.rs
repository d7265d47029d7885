//! Laws that every cushion model obeys with any parameters.

use crate::random::Random;
use carom::Physics;
use carom::math::{Vec2, Vec3, atan2, sin_cos, sqrt};
use carom::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::resolve::{Body, ball_cushion::resolve};

const MODELS: [CushionModel; 5] = [
    CushionModel::Restitution,
    CushionModel::Han2005,
    CushionModel::Mathavan2010,
    CushionModel::Stronge,
    CushionModel::Factors,
];

/// Impacts per model: enough for every regime with every kind of parameter.
const IMPACTS: u32 = 100_000;

#[derive(Clone)]
struct Case {
    law: Cushion,
    cloth: Cloth,
    normal: Vec3,
    on_bed: bool,
    ball: Body,
}

/// Speeds from 1e-9 to 20 m/s, spins up to 500 rad/s or none, every angle of incidence, every
/// geometry, and fits that leave the physical range and must be clamped. Half of the balls are on
/// the bed, the others at any height, some directly above the edge.
fn case(model: CushionModel, random: &mut Random) -> Case {
    let on_bed = random.unit() < 0.5;
    let (sin, cos) = sin_cos(random.between(-1.57, 1.57));
    let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
    let into = Vec2::new(c, s);
    let up = if on_bed { random.between(-0.3, 0.6) } else { random.between(-1.0, 1.0) };
    let mut normal = (into * sqrt(1.0 - up * up)).with_z(up);
    if !on_bed && random.unit() < 0.1 {
        normal = Vec3::new(0.0, 0.0, if up < 0.0 { -1.0 } else { 1.0 });
    }
    let speed =
        one_of(random, [1e-9, 1e-6, 1e-3, 2e-3, 0.1, 1.0, 3.0, 10.0]) * random.between(0.5, 2.0);
    let mut velocity = ((into * cos + into.perp() * sin) * speed).with_z(0.0);
    if !on_bed {
        velocity.z = speed * random.between(-1.0, 1.0);
        if velocity.dot(normal) < 0.0 {
            velocity = -velocity;
        }
    }
    let radius = random.between(0.02, 0.04);
    let spin_size = one_of(random, [0.0, speed / radius, 3.0 * speed / radius, 500.0]);
    let mut spin =
        Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0))
            * spin_size;
    if random.unit() < 0.3 {
        let rolling = velocity.xy().perp() * (1.0 / radius);
        spin = rolling.with_z(one_of(random, [0.0, spin.z]));
    }
    let mut law = Cushion { model, ..Physics::pool().cushion };
    law.restitution = CushionRestitution {
        a: one_of(random, [0.0, 0.05, 0.39, 0.85, 1.0, 1.4, -0.3]),
        b: one_of(random, [0.0, 0.257]),
        c: one_of(random, [0.0, -0.044]),
        lowest: 0.0,
        highest: 1.0,
    };
    law.friction = CushionFriction {
        a: one_of(random, [0.0, 0.02, 0.14, 0.2, 0.471, 1.0]),
        b: one_of(random, [0.0, -0.241, -0.6]),
    };
    law.frequency_ratio = random.between(1.0, 2.0);
    law.tangential_factor = one_of(random, [0.0, 0.9, 1.0]);
    law.spin_factor = one_of(random, [0.0, 0.1, 1.0]);
    let sliding_friction = one_of(random, [0.0, 0.2, 0.5]);
    Case {
        law,
        cloth: Cloth { sliding_friction, ..Physics::pool().cloth },
        normal,
        on_bed,
        ball: Body { velocity, angular_velocity: spin, mass: random.between(0.09, 0.25), radius },
    }
}

fn one_of<const N: usize>(random: &mut Random, values: [f64; N]) -> f64 {
    values[random.pick(N)]
}

fn energy(b: &Body) -> f64 {
    0.5 * b.mass * b.velocity.length_squared()
        + 0.2 * b.mass * b.radius * b.radius * b.angular_velocity.length_squared()
}

fn after(case: &Case) -> Body {
    let mut ball = case.ball;
    resolve(&case.law, &case.cloth, case.normal, case.on_bed, &mut ball);
    ball
}

/// The horizontal unit vector into the rail.
fn into(case: &Case) -> Vec2 {
    let level = case.normal.xy();
    level * (1.0 / level.length())
}

#[test]
fn energy_never_rises_and_the_ball_never_moves_on_into_the_rail() {
    /// Rounding error of the sums over the components, as a fraction of the energy.
    const ROUNDING: f64 = 4e-15;
    /// Rounding error of the rotation into the rail's frame and back, as a fraction of the speeds.
    const TURNED: f64 = 1e-15;
    for model in MODELS {
        let mut random = Random(1);
        let mut worst: f64 = f64::NEG_INFINITY;
        for i in 0..IMPACTS {
            let case = case(model, &mut random);
            let ball = after(&case);
            assert!(ball.velocity.is_finite() && ball.angular_velocity.is_finite());
            let before = energy(&case.ball);
            worst = worst.max(energy(&ball) / before - 1.0);
            assert!(
                energy(&ball) <= before * (1.0 + ROUNDING),
                "{model:?} {i}: {:?} {:?} {:?} → {ball:?}: + {:e}",
                case.law,
                case.normal,
                case.ball,
                energy(&ball) / before - 1.0
            );
            let size = case.ball.velocity.length()
                + ball.velocity.length()
                + case.ball.radius * case.ball.angular_velocity.length();
            let approach = ball.velocity.dot(case.normal);
            assert!(approach <= TURNED * size, "{model:?} {i}: {approach} of {size}");
            if case.on_bed {
                assert!(ball.velocity.z >= 0.0);
                let approach = ball.velocity.xy().dot(into(&case));
                assert!(approach <= TURNED * size, "{model:?} {i}: {approach} of {size}");
            }
        }
        println!("{model:?}: largest relative change of energy {worst:e}");
    }
}

#[test]
fn restitution_holds_along_the_normal_off_the_bed_and_the_rest_of_the_impulse_is_friction() {
    /// Rounding error as a fraction of the speeds.
    const ROUNDING: f64 = 1e-14;
    for model in MODELS {
        let mut random = Random(6);
        for _ in 0..IMPACTS {
            let case = case(model, &mut random);
            let approach = case.ball.velocity.dot(case.normal);
            if case.on_bed || approach < 2e-3 {
                continue;
            }
            let ball = after(&case);
            let size = case.ball.velocity.length()
                + case.ball.radius * case.ball.angular_velocity.length();
            let e = case.law.restitution.at(approach);
            let parting = -ball.velocity.dot(case.normal);
            assert!((parting - e * approach).abs() < ROUNDING * size, "{model:?}");
            if model == CushionModel::Factors {
                // Constant factors are not an impulse: the change of the spin has no lever arm.
                continue;
            }
            // The edge's impulse has no moment about the point of contact.
            let kick = ball.velocity - case.ball.velocity;
            let turn = ball.angular_velocity - case.ball.angular_velocity;
            let moment = turn * (0.4 * ball.radius) - case.normal.cross(kick);
            assert!(moment.length() < ROUNDING * size, "{model:?}: {moment:?}");
            // Coulomb's bound, and friction opposite to the slip.
            let friction = kick - case.normal * kick.dot(case.normal);
            let across = case.ball.velocity - case.normal * approach;
            let slip = across + case.ball.angular_velocity.cross(case.normal) * case.ball.radius;
            assert!(friction.dot(slip) <= ROUNDING * size * size);
            let gamma = carom::math::atan2(across.length(), approach);
            let mu = (case.law.friction.a + case.law.friction.b * gamma).max(0.0);
            let most = mu * (1.0 + e) * approach;
            assert!(friction.length() <= most + ROUNDING * size, "{model:?}");
        }
    }
}

#[test]
fn mathavan_2010_keeps_the_ball_on_the_bed_and_off_it_is_a_rigid_impulse() {
    let mut random = Random(7);
    for _ in 0..IMPACTS / 10 {
        let mut case = case(CushionModel::Mathavan2010, &mut random);
        let ball = after(&case);
        if case.on_bed {
            assert_eq!(ball.velocity.z, 0.0);
        } else {
            case.law.model = CushionModel::Han2005;
            assert_eq!(after(&case), ball);
        }
    }
}

#[test]
fn a_rebound_on_the_bed_is_that_in_the_air_without_the_velocity_that_the_slate_stops() {
    /// For models without a fit that distinguishes the two; rounding error as a fraction of the
    /// speeds.
    const ROUNDING: f64 = 1e-14;
    for model in [CushionModel::Han2005, CushionModel::Stronge] {
        let mut random = Random(8);
        let mut compared = 0;
        for _ in 0..IMPACTS / 10 {
            let mut case = case(model, &mut random);
            (case.law.restitution.b, case.law.restitution.c) = (0.0, 0.0);
            case.law.friction.b = 0.0;
            if !case.on_bed || case.ball.velocity.dot(case.normal) < 2e-3 {
                continue;
            }
            let bed = after(&case);
            case.on_bed = false;
            let mut air = after(&case);
            // Slate and nose wedge the ball.
            let on = air.velocity.xy().dot(into(&case)).max(0.0);
            air.velocity -= (into(&case) * on).with_z(0.0);
            air.velocity.z = air.velocity.z.max(0.0);
            let size = case.ball.velocity.length()
                + case.ball.radius * case.ball.angular_velocity.length();
            let off = (air.velocity - bed.velocity).length()
                + bed.radius * (air.angular_velocity - bed.angular_velocity).length();
            assert!(off < ROUNDING * size, "{model:?}: {off:e} of {size}");
            compared += 1;
        }
        assert!(compared > 1000);
    }
}

#[test]
fn the_rebound_of_a_flying_ball_changes_smoothly_with_the_height_of_the_nose() {
    /// Over a step of 1e-6 in the angle, as a fraction of the speeds.
    const STEP: f64 = 1e-6;
    const SMOOTH: f64 = 200.0 * STEP;
    for model in MODELS {
        let mut random = Random(9);
        for _ in 0..IMPACTS / 100 {
            let mut case = case(model, &mut random);
            case.on_bed = false;
            let level = Vec2::new(1.0, 0.0);
            case.ball.velocity = Vec3::new(
                random.between(0.5, 3.0),
                random.between(-2.0, 2.0),
                random.between(-0.4, 0.4),
            );
            case.ball.angular_velocity = Vec3::new(
                random.between(-50.0, 50.0),
                random.between(-50.0, 50.0),
                random.between(-50.0, 50.0),
            );
            let mut last: Option<Body> = None;
            for angle in [-STEP, 0.0, STEP] {
                let (sin, cos) = sin_cos(angle);
                case.normal = (level * cos).with_z(sin);
                let ball = after(&case);
                if let Some(last) = last {
                    let off = (last.velocity - ball.velocity).length()
                        + ball.radius * (last.angular_velocity - ball.angular_velocity).length();
                    assert!(off < SMOOTH, "{model:?}: {off:e}");
                }
                last = Some(ball);
            }
        }
    }
}

#[test]
fn mirrored_impacts_have_mirrored_results_bit_for_bit() {
    type Mirror = fn(Vec3) -> Vec3;
    let mirrors: [Mirror; 3] =
        [|v| Vec3 { x: -v.x, ..v }, |v| Vec3 { y: -v.y, ..v }, |v| Vec3 { x: v.y, y: v.x, z: v.z }];
    for model in MODELS {
        let mut random = Random(2);
        for _ in 0..IMPACTS / 10 {
            let case = case(model, &mut random);
            let ball = after(&case);
            for mirror in mirrors {
                let mut image = case.clone();
                image.normal = mirror(case.normal);
                image.ball.velocity = mirror(case.ball.velocity);
                // A spin is an axial vector.
                image.ball.angular_velocity = -mirror(case.ball.angular_velocity);
                let other = after(&image);
                assert_eq!(other.velocity, mirror(ball.velocity), "{:?}", case.law);
                assert_eq!(other.angular_velocity, -mirror(ball.angular_velocity));
            }
        }
    }
}

#[test]
fn a_rotated_rail_has_the_rotated_result_to_rounding() {
    /// Rounding error of the rail's direction, as a fraction of the speeds. Mathavan's step control
    /// may enlarge it to the error of its steps.
    const ROUNDING: f64 = 2e-13;
    const INTEGRATED: f64 = 1e-7;
    let turned =
        |v: Vec3, by: Vec2| Vec3::new(v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x, v.z);
    for model in MODELS {
        let tolerance = if model == CushionModel::Mathavan2010 { INTEGRATED } else { ROUNDING };
        let mut random = Random(3);
        let mut worst: f64 = 0.0;
        for i in 0..IMPACTS / 10 {
            let mut case = case(model, &mut random);
            let ball = after(&case);
            let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
            let by = Vec2::new(c, s);
            let (v, w) = (case.ball.velocity, case.ball.angular_velocity);
            case.normal = turned(case.normal, by);
            case.ball.velocity = turned(v, by);
            case.ball.angular_velocity = turned(w, by);
            let other = after(&case);
            let dv = other.velocity - turned(ball.velocity, by);
            let dw = other.angular_velocity - turned(ball.angular_velocity, by);
            let size = v.length() + case.ball.radius * w.length();
            let error = (dv.length() + case.ball.radius * dw.length()) / size;
            worst = worst.max(error);
            assert!(error < tolerance, "{model:?} {i}: {error:e}; {:?}", case.law);
        }
        println!("{model:?}: largest difference {worst:e}");
    }
}

#[test]
fn a_slow_ball_is_reflected_without_loss() {
    for model in MODELS {
        let mut random = Random(4);
        let mut case = case(model, &mut random);
        (case.normal, case.on_bed) = (Vec3::new(0.8, 0.0, 0.6), true);
        case.ball.velocity = Vec3::new(0.001, 0.3, 0.0);
        let ball = after(&case);
        assert_eq!(ball.velocity, Vec3::new(-0.001, 0.3, 0.0));
        assert_eq!(ball.angular_velocity, case.ball.angular_velocity);
        // In the air the reflection is along the normal.
        case.on_bed = false;
        let ball = after(&case);
        let expected = Vec3::new(0.001, 0.3, 0.0) - case.normal * 0.0016;
        assert!((ball.velocity - expected).length() < 1e-17);
        assert_eq!(ball.angular_velocity, case.ball.angular_velocity);
        // At 1.5 mm/s, half a reflection and half the model's own result.
        case.law.restitution = CushionRestitution::constant(0.0);
        case.law.friction = CushionFriction { a: 0.0, b: 0.0 };
        case.normal = Vec3::new(1.0, 0.0, 0.0);
        case.cloth.sliding_friction = 0.0;
        case.ball.velocity = Vec3::new(0.0015, 0.0, 0.0);
        for on_bed in [true, false] {
            case.on_bed = on_bed;
            assert!((after(&case).velocity.x + 0.00075).abs() < 1e-12);
        }
    }
}

#[test]
fn a_ball_that_leaves_the_rail_is_left_unchanged() {
    for model in MODELS {
        let mut case = case(model, &mut Random(5));
        case.ball.velocity = -case.ball.velocity;
        assert_eq!(after(&case), case.ball);
    }
}

#[test]
fn a_ball_that_lands_on_the_edge_bounces_as_from_a_floor() {
    for model in MODELS {
        let mut case = case(model, &mut Random(10));
        case.law.restitution = CushionRestitution::constant(0.6);
        case.on_bed = false;
        case.normal = Vec3::new(0.0, 0.0, -1.0);
        case.ball.velocity = Vec3::new(0.0, 0.0, -1.0);
        case.ball.angular_velocity = Vec3::new(0.0, 0.0, 30.0);
        let ball = after(&case);
        assert!((ball.velocity - Vec3::new(0.0, 0.0, 0.6)).length() < 1e-15);
        assert_eq!(ball.angular_velocity, case.ball.angular_velocity);
    }
}

#[test]
fn a_nose_above_the_centre_presses_a_ball_down_and_strong_friction_makes_it_hop() {
    let mut case = case(CushionModel::Han2005, &mut Random(11));
    case.law.restitution = CushionRestitution::constant(0.8);
    (case.normal, case.on_bed) = (Vec3::new(sqrt(1.0 - 0.2 * 0.2), 0.0, 0.2), true);
    case.ball.velocity = Vec3::new(2.0, 0.0, 0.0);
    // Top spin: the ball's surface moves down along the nose, which lifts the ball.
    case.ball.angular_velocity = Vec3::new(0.0, 5.0 / case.ball.radius, 0.0);
    for (friction, hops) in [(0.1, false), (0.4, true)] {
        case.law.friction = CushionFriction { a: friction, b: 0.0 };
        let ball = after(&case);
        let slides = friction * sqrt(1.0 - 0.2 * 0.2) - 0.2;
        let rise = slides.max(0.0) * 1.8 * 2.0 * sqrt(1.0 - 0.2 * 0.2);
        assert!((ball.velocity.z - rise).abs() < 1e-14 && hops == (ball.velocity.z > 0.0));
    }
}

#[test]
fn a_fit_acts_in_every_model_as_its_values_at_the_first_touch() {
    for model in MODELS {
        let mut random = Random(7);
        let mut faster = 0;
        for _ in 0..1000 {
            let mut case = case(model, &mut random);
            if !case.on_bed {
                continue;
            }
            // The carom rail of a tracked match, with a lower limit that fast impacts reach.
            case.law.restitution = CushionRestitution {
                lowest: 0.4,
                ..CushionRestitution::polynomial(0.915, -0.034, -0.005)
            };
            case.law.friction = CushionFriction { a: 0.24, b: 0.034 };
            let fitted = after(&case);
            let (v, into) = (case.ball.velocity.xy(), into(&case));
            let (speed, across) = (v.dot(into), v.dot(into.perp()).abs());
            if speed <= 0.0 {
                continue;
            }
            let e = (0.915 + speed * (-0.034 + speed * -0.005)).max(0.4);
            case.law.restitution = CushionRestitution::constant(e);
            case.law.friction = CushionFriction { a: 0.24 + 0.034 * atan2(across, speed), b: 0.0 };
            let constant = after(&case);
            assert_eq!(fitted.velocity, constant.velocity, "{model:?}");
            assert_eq!(fitted.angular_velocity, constant.angular_velocity, "{model:?}");
            faster += u32::from(e == 0.4);
        }
        assert!(faster > 20, "{model:?}: {faster} impacts at the lower limit");
    }
}
