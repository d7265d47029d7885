//! Hard motions of two balls of which at least one is in the air, and of a flying ball and a
//! straight edge.
//!
//! In three dimensions the motion is that of a pair: with gravity along the last axis if one ball
//! is in the air, without if both are. In two dimensions it is that of a ball relative to a
//! straight edge: (n·x, z).

use carom_roots::Motion;

use crate::families::{BALL_DIAMETER, Case};
use crate::random::{Random, RandomMotion};

/// Families of motions in the air.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlightFamily {
    /// Passes within two contact distances, at 0.1 to 20 m/s.
    Aimed,
    /// The closest approach is within 1e-4 … 0 (relative) of touching.
    Grazing,
    /// Touching within rounding, separating at down to 1e-9 m/s.
    Parting,
    /// Touching within rounding, approaching.
    Approaching,
    /// Gaps down to 1e-15 m and speeds down to 1e-9 m/s.
    TinyGapAndSpeed,
    /// Touching along an axis, with a normal speed of exactly zero.
    NoNormalSpeed,
}

/// Half of gravity, 9.81 m/s².
const HALF_GRAVITY: f64 = 4.905;

impl FlightFamily {
    /// All of them.
    pub const ALL: [FlightFamily; 6] = [
        FlightFamily::Aimed,
        FlightFamily::Grazing,
        FlightFamily::Parting,
        FlightFamily::Approaching,
        FlightFamily::TinyGapAndSpeed,
        FlightFamily::NoNormalSpeed,
    ];

    /// One case.
    pub fn sample<const N: usize>(self, random: &mut Random) -> Case<N> {
        let h = half_acceleration(random);
        let distance = if N == 3 { BALL_DIAMETER } else { 0.5 * BALL_DIAMETER };
        let motion = match self {
            FlightFamily::Aimed => {
                let near = scaled(direction(random), distance * random.between(0.0, 2.0));
                let speed = random.magnitude(-1.0, 1.3);
                through(near, scaled(direction(random), speed), h, random.magnitude(-2.5, -0.3))
            }
            FlightFamily::Grazing => grazing(random, distance, h),
            FlightFamily::Parting => touching(random, distance, h, 1.0),
            FlightFamily::Approaching => touching(random, distance, h, -1.0),
            FlightFamily::TinyGapAndSpeed => {
                let d = scaled(direction(random), distance + random.magnitude(-15.0, -6.0));
                let speed = random.magnitude(-9.0, -3.0);
                Motion { d, v: scaled(direction(random), speed), h }
            }
            FlightFamily::NoNormalSpeed => no_normal_speed(random, distance, h),
        };
        let horizon = if random.chance(0.5) { f64::INFINITY } else { random.magnitude(-3.0, 0.0) };
        Case { motion, distance, horizon, metre: 1.0 }
    }
}

/// Half of the relative acceleration of one ball in the air and one on the cloth, or of two in the
/// air; with an edge, always of one in the air.
fn half_acceleration<const N: usize>(random: &mut Random) -> [f64; N] {
    let falls = N == 2 || random.chance(0.7);
    let [x, y] = random.direction();
    let size = if random.chance(0.3) { 0.0 } else { random.magnitude(-2.0, 0.0) };
    std::array::from_fn(|i| match (falls, N - 1 - i) {
        (false, _) => 0.0,
        (true, 0) => -HALF_GRAVITY,
        (true, _) if N == 2 => 0.0,
        (true, 1) => size * x,
        (true, _) => size * y,
    })
}

/// Uniform on the sphere.
fn direction<const N: usize>(random: &mut Random) -> [f64; N] {
    loop {
        let a: [f64; N] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let squared = dot(&a, &a);
        if squared > 0.01 && squared < 1.0 {
            return scaled(a, 1.0 / squared.sqrt());
        }
    }
}

/// A unit vector perpendicular to n.
fn across<const N: usize>(random: &mut Random, n: &[f64; N]) -> [f64; N] {
    loop {
        let a = direction::<N>(random);
        let part = dot(&a, n);
        let rest: [f64; N] = std::array::from_fn(|i| a[i] - part * n[i]);
        let squared = dot(&rest, &rest);
        if squared > 0.01 {
            return scaled(rest, 1.0 / squared.sqrt());
        }
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn scaled<const N: usize>(a: [f64; N], by: f64) -> [f64; N] {
    a.map(|x| by * x)
}

/// The motion that passes `x` with `velocity` at `time`.
fn through<const N: usize>(x: [f64; N], velocity: [f64; N], h: [f64; N], time: f64) -> Motion<N> {
    Motion {
        d: std::array::from_fn(|i| x[i] - time * (velocity[i] - time * h[i])),
        v: std::array::from_fn(|i| velocity[i] - 2.0 * time * h[i]),
        h,
    }
}

fn grazing<const N: usize>(random: &mut Random, distance: f64, h: [f64; N]) -> Motion<N> {
    let offset = match random.bits() % 4 {
        0 => 0.0,
        _ => random.sign() * random.magnitude(-17.0, -4.0),
    };
    let n = direction(random);
    let speed = random.magnitude(-1.5, 1.3);
    let velocity = scaled(across(random, &n), speed);
    through(scaled(n, distance * (1.0 + offset)), velocity, h, random.magnitude(-2.5, -0.3))
}

fn touching<const N: usize>(
    random: &mut Random,
    distance: f64,
    h: [f64; N],
    sign: f64,
) -> Motion<N> {
    let n = direction(random);
    let roundings = (random.bits() % 5) as f64 - 2.0;
    let d = scaled(n, distance * (1.0 + roundings * f64::EPSILON));
    let apart = sign * random.magnitude(-9.0, 0.7);
    let slide = if random.chance(0.5) { 0.0 } else { random.between(-2.0, 2.0) };
    let a = across(random, &n);
    Motion { d, v: std::array::from_fn(|i| apart * n[i] + slide * a[i]), h }
}

fn no_normal_speed<const N: usize>(random: &mut Random, distance: f64, h: [f64; N]) -> Motion<N> {
    let axis = (random.bits() % N as u64) as usize;
    let inside = (random.bits() % 3) as f64 * f64::EPSILON;
    let along = random.sign() * distance * (1.0 - inside);
    let speed = if random.chance(0.3) { 0.0 } else { random.magnitude(-6.0, 0.7) };
    let slide = scaled(direction::<N>(random), speed);
    Motion {
        d: std::array::from_fn(|i| if i == axis { along } else { 0.0 }),
        v: std::array::from_fn(|i| if i == axis { 0.0 } else { slide[i] }),
        h,
    }
}
