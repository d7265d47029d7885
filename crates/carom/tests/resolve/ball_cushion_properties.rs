//! What holds for every cushion model, whatever its parameters.

use carom::math::{Vec2, Vec3, sin_cos};
use carom::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::resolve::{Body, ball_cushion::resolve};

const MODELS: [CushionModel; 4] = [
    CushionModel::Restitution,
    CushionModel::Han2005,
    CushionModel::Mathavan2010,
    CushionModel::Stronge,
];

/// Impacts per model: enough to meet every regime at every kind of parameter.
const IMPACTS: u32 = 100_000;

/// SplitMix64: a fixed sequence, so that a failure can be found again.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    fn one_of<const N: usize>(&mut self, values: [f64; N]) -> f64 {
        values[(self.unit() * N as f64) as usize]
    }
}

struct Case {
    law: Cushion,
    cloth: Cloth,
    into: Vec2,
    sin_theta: f64,
    ball: Body,
}

/// Speeds from 1e-9 to 20 m/s, spins to 500 rad/s and none, every incidence, every geometry, fits
/// that leave the physical range and must be clamped.
fn case(model: CushionModel, random: &mut Random) -> Case {
    let (sin, cos) = sin_cos(random.between(-1.57, 1.57));
    let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
    let into = Vec2::new(c, s);
    let speed =
        random.one_of([1e-9, 1e-6, 1e-3, 2e-3, 0.1, 1.0, 3.0, 10.0]) * random.between(0.5, 2.0);
    let velocity = (into * cos + into.perp() * sin) * speed;
    let radius = random.between(0.02, 0.04);
    let spin_size = random.one_of([0.0, speed / radius, 3.0 * speed / radius, 500.0]);
    let mut spin =
        Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0))
            * spin_size;
    if random.unit() < 0.3 {
        let rolling = velocity.perp() * (1.0 / radius);
        spin = rolling.with_z(random.one_of([0.0, spin.z]));
    }
    Case {
        law: Cushion {
            model,
            restitution: CushionRestitution {
                a: random.one_of([0.0, 0.05, 0.39, 0.85, 1.0, 1.4, -0.3]),
                b: random.one_of([0.0, 0.257]),
                c: random.one_of([0.0, -0.044]),
            },
            friction: CushionFriction {
                a: random.one_of([0.0, 0.02, 0.14, 0.2, 0.471, 1.0]),
                b: random.one_of([0.0, -0.241, -0.6]),
            },
            frequency_ratio: random.between(1.0, 2.0),
        },
        cloth: Cloth {
            sliding_friction: random.one_of([0.0, 0.2, 0.5]),
            rolling_friction: 0.01,
            spin_deceleration: 10.0,
        },
        into,
        sin_theta: random.between(-0.3, 0.6),
        ball: Body {
            velocity: velocity.with_z(0.0),
            angular_velocity: spin,
            mass: random.between(0.09, 0.25),
            radius,
        },
    }
}

fn energy(b: &Body) -> f64 {
    0.5 * b.mass * b.velocity.length_squared()
        + 0.2 * b.mass * b.radius * b.radius * b.angular_velocity.length_squared()
}

fn after(case: &Case) -> Body {
    let mut ball = case.ball;
    resolve(&case.law, &case.cloth, case.into, case.sin_theta, &mut ball);
    ball
}

#[test]
fn energy_never_rises_and_the_ball_never_goes_on_into_the_rail() {
    /// Rounding of the sums over the components, as a share of the energy.
    const ROUNDING: f64 = 4e-15;
    /// Rounding of the turn into the rail's frame and back, as a share of the speeds.
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
                "{model:?} {i}: {:?} θ {} {:?} → {ball:?}: + {:e}",
                case.law,
                case.sin_theta,
                case.ball,
                energy(&ball) / before - 1.0
            );
            let approach = ball.velocity.xy().dot(case.into);
            let size = case.ball.velocity.length() + ball.velocity.length();
            assert!(approach <= TURNED * size, "{model:?} {i}: {approach} of {size}");
        }
        println!("{model:?}: largest relative change of energy {worst:e}");
    }
}

#[test]
fn mirrored_impacts_have_mirrored_outcomes_bit_for_bit() {
    for model in MODELS {
        let mut random = Random(2);
        for _ in 0..IMPACTS / 10 {
            let mut case = case(model, &mut random);
            case.into =
                [Vec2::new(1.0, 0.0), Vec2::new(-1.0, 0.0)][usize::from(random.unit() < 0.5)];
            let speed = case.ball.velocity.length();
            case.ball.velocity.x = case.into.x * random.between(0.0, 1.0) * speed;
            let ball = after(&case);
            let (v, w) = (case.ball.velocity, case.ball.angular_velocity);
            // In the plane that holds the rail's normal and the vertical.
            case.ball.velocity = Vec3::new(v.x, -v.y, v.z);
            case.ball.angular_velocity = Vec3::new(-w.x, w.y, -w.z);
            let mirrored = after(&case);
            let (v, w) = (ball.velocity, ball.angular_velocity);
            assert_eq!(mirrored.velocity, Vec3::new(v.x, -v.y, v.z));
            assert_eq!(mirrored.angular_velocity, Vec3::new(-w.x, w.y, -w.z));
            // In the vertical plane along the rail: the opposite rail.
            case.into = -case.into;
            let (v, w) = (case.ball.velocity, case.ball.angular_velocity);
            case.ball.velocity = Vec3::new(-v.x, v.y, v.z);
            case.ball.angular_velocity = Vec3::new(w.x, -w.y, -w.z);
            let opposite = after(&case);
            let (v, w) = (mirrored.velocity, mirrored.angular_velocity);
            assert_eq!(opposite.velocity, Vec3::new(-v.x, v.y, v.z));
            assert_eq!(opposite.angular_velocity, Vec3::new(w.x, -w.y, -w.z));
        }
    }
}

#[test]
fn a_turned_rail_has_the_turned_outcome_to_rounding() {
    /// Rounding in the direction of the rail, as a share of the speeds; Mathavan's step
    /// control may turn it into its own step error.
    const ROUNDING: f64 = 2e-13;
    const INTEGRATED: f64 = 1e-7;
    let turned = |v: Vec2, by: Vec2| Vec2::new(v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x);
    for model in MODELS {
        let tolerance = if model == CushionModel::Mathavan2010 { INTEGRATED } else { ROUNDING };
        let mut random = Random(3);
        let mut worst: f64 = 0.0;
        for i in 0..IMPACTS / 10 {
            let mut case = case(model, &mut random);
            let ball = after(&case);
            let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
            let by = Vec2::new(c, s);
            case.into = turned(case.into, by);
            let (v, w) = (case.ball.velocity, case.ball.angular_velocity);
            case.ball.velocity = turned(v.xy(), by).with_z(0.0);
            case.ball.angular_velocity = turned(w.xy(), by).with_z(w.z);
            let other = after(&case);
            let dv = other.velocity.xy() - turned(ball.velocity.xy(), by);
            let dw = other.angular_velocity
                - turned(ball.angular_velocity.xy(), by).with_z(ball.angular_velocity.z);
            let size = v.length() + case.ball.radius * w.length();
            let error = (dv.length() + case.ball.radius * dw.length()) / size;
            worst = worst.max(error);
            assert!(error < tolerance, "{model:?} {i}: {error:e}; {:?}", case.law);
        }
        println!("{model:?}: largest difference {worst:e}");
    }
}

#[test]
fn a_slow_ball_comes_back_as_it_went() {
    for model in MODELS {
        let mut random = Random(4);
        let mut case = case(model, &mut random);
        case.into = Vec2::new(1.0, 0.0);
        case.ball.velocity = Vec3::new(0.001, 0.3, 0.0);
        let ball = after(&case);
        assert_eq!(ball.velocity, Vec3::new(-0.001, 0.3, 0.0));
        assert_eq!(ball.angular_velocity, case.ball.angular_velocity);
        // At 1.5 mm/s, half a reflection and half the model's own outcome.
        case.law.restitution = CushionRestitution { a: 0.0, b: 0.0, c: 0.0 };
        case.law.friction = CushionFriction { a: 0.0, b: 0.0 };
        case.sin_theta = 0.0;
        case.cloth.sliding_friction = 0.0;
        case.ball.velocity = Vec3::new(0.0015, 0.0, 0.0);
        assert!((after(&case).velocity.x + 0.00075).abs() < 1e-12);
    }
}

#[test]
fn a_ball_that_leaves_the_rail_is_left_alone() {
    for model in MODELS {
        let mut case = case(model, &mut Random(5));
        case.ball.velocity = -case.ball.velocity;
        assert_eq!(after(&case), case.ball);
    }
}
