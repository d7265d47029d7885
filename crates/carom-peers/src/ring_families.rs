//! Hard paths near a round edge: the lip and the rim of a pocket, the points of its jaw.

use carom_roots::Motion;

use crate::families::BALL_DIAMETER;
use crate::random::{Random, RandomMotion};

/// A path and a ring.
#[derive(Clone, Copy, Debug)]
pub struct RingCase {
    /// The path of the ball's centre. The origin is the ring's centre, and z is its axis.
    pub motion: Motion<3>,
    /// Radius of the ring, m.
    pub ring: f64,
    /// Radius of the ball, m.
    pub distance: f64,
    /// The first time of interest, s.
    pub from: f64,
    /// The last time of interest, s; finite.
    pub horizon: f64,
}

/// Families of paths near a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RingFamily {
    /// Passes over, through and beside the ring, at up to 20 m/s.
    Passing,
    /// The closest approach is within 1e-4 … 1e-17 R of the torus, on any side of it.
    Grazing,
    /// On the lip with 5 mm/s to 1.2 m/s inward: the ball tips over or flies.
    Tipping,
    /// From inside the ring towards its far side, from above or below its level.
    FarRim,
    /// Touching within rounding and separating; most are accelerated back.
    Parting,
    /// Touching within rounding and approaching.
    Approaching,
    /// Gaps of 1e-15 … 1e-6 m and speeds of 1e-9 … 1e-3 m/s.
    NearlyStatic,
    /// Falls on the edge or down the axis.
    Falling,
    /// In a vertical plane through the axis, so that the path crosses it.
    Meridian,
    /// Passing, with accelerations in every direction.
    Curved,
}

impl RingFamily {
    /// All of them.
    pub const ALL: [RingFamily; 10] = [
        RingFamily::Passing,
        RingFamily::Grazing,
        RingFamily::Tipping,
        RingFamily::FarRim,
        RingFamily::Parting,
        RingFamily::Approaching,
        RingFamily::NearlyStatic,
        RingFamily::Falling,
        RingFamily::Meridian,
        RingFamily::Curved,
    ];

    /// One random case.
    pub fn sample(self, random: &mut Random) -> RingCase {
        let ring = ring(random);
        let motion = match self {
            RingFamily::Passing => passing(random, ring, FREE_FALL),
            RingFamily::Grazing => grazing(random, ring),
            RingFamily::Tipping => tipping(random, ring),
            RingFamily::FarRim => far_rim(random, ring),
            RingFamily::Parting => touching(random, ring, 1.0),
            RingFamily::Approaching => touching(random, ring, -1.0),
            RingFamily::NearlyStatic => nearly_static(random, ring),
            RingFamily::Falling => falling(random, ring),
            RingFamily::Meridian => meridian(random, ring),
            RingFamily::Curved => {
                let size = random.magnitude(-2.0, 1.0);
                let half = scaled(direction(random), size);
                passing(random, ring, half)
            }
        };
        let from = if random.chance(0.8) { 0.0 } else { random.between(0.0, 0.1) };
        let horizon = from + random.magnitude(-2.0, 0.0);
        RingCase { motion, ring, distance: BALL_RADIUS, from, horizon }
    }
}

const BALL_RADIUS: f64 = 0.5 * BALL_DIAMETER;

/// Half of gravity, 9.81 m/s².
const FREE_FALL: [f64; 3] = [0.0, 0.0, -4.905];

/// Radius of a pocket's hole, of a point of its jaw, or near the ball's, where the torus has no
/// hole.
fn ring(random: &mut Random) -> f64 {
    match random.bits() % 4 {
        0 | 1 => random.between(0.04, 0.07),
        2 => random.between(0.001, 0.025),
        _ => BALL_RADIUS * (1.0 + random.sign() * random.magnitude(-16.0, -1.0)),
    }
}

fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|x| by * x)
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// Uniform on the sphere.
fn direction(random: &mut Random) -> [f64; 3] {
    let [x, y] = random.direction();
    let z = random.between(-1.0, 1.0);
    let across = (1.0 - z * z).sqrt();
    [x * across, y * across, z]
}

/// A point of the ring, the normal of the torus there at `tilt` above the horizontal, and the two
/// tangents of its surface: up the tube and along the ring.
struct EdgePoint {
    edge: [f64; 3],
    normal: [f64; 3],
    up: [f64; 3],
    along: [f64; 3],
}

fn place(random: &mut Random, ring: f64, tilt: f64) -> EdgePoint {
    let [x, y] = random.direction();
    let (sin, cos) = tilt.sin_cos();
    EdgePoint {
        edge: [ring * x, ring * y, 0.0],
        normal: [x * cos, y * cos, sin],
        up: [-x * sin, -y * sin, cos],
        along: [-y, x, 0.0],
    }
}

/// The motion that is at `x` with `velocity` at `time`.
fn through(x: [f64; 3], velocity: [f64; 3], h: [f64; 3], time: f64) -> Motion<3> {
    Motion {
        d: [0, 1, 2].map(|i| x[i] - time * (velocity[i] - time * h[i])),
        v: [0, 1, 2].map(|i| velocity[i] - 2.0 * time * h[i]),
        h,
    }
}

fn passing(random: &mut Random, ring: f64, h: [f64; 3]) -> Motion<3> {
    let reach = ring + 1.5 * BALL_RADIUS;
    let x = [0, 1, 2].map(|_| random.between(-reach, reach));
    let speed = random.magnitude(-1.0, 1.3);
    let velocity = scaled(direction(random), speed);
    let time = random.magnitude(-3.0, -0.5);
    through(x, velocity, h, time)
}

fn any_tilt(random: &mut Random) -> f64 {
    random.between(-std::f64::consts::PI, std::f64::consts::PI)
}

fn grazing(random: &mut Random, ring: f64) -> Motion<3> {
    let tilt = any_tilt(random);
    let EdgePoint { edge, normal, up, along } = place(random, ring, tilt);
    let offset = match random.bits() % 4 {
        0 => 0.0,
        _ => random.sign() * random.magnitude(-17.0, -4.0),
    };
    let x = sum(edge, scaled(normal, BALL_RADIUS * (1.0 + offset)));
    let [a, b] = random.direction();
    let speed = random.magnitude(-1.5, 1.3);
    let time = random.magnitude(-2.5, -0.5);
    through(x, sum(scaled(up, a * speed), scaled(along, b * speed)), FREE_FALL, time)
}

/// Within two roundings of `BALL_RADIUS` from the edge.
fn at_touch(random: &mut Random, place: &EdgePoint) -> [f64; 3] {
    let roundings = (random.bits() % 5) as f64 - 2.0;
    sum(place.edge, scaled(place.normal, BALL_RADIUS * (1.0 + roundings * f64::EPSILON)))
}

fn tipping(random: &mut Random, ring: f64) -> Motion<3> {
    let lean = if random.chance(0.3) { 0.0 } else { random.magnitude(-6.0, 0.0) };
    let place = place(random, ring, std::f64::consts::FRAC_PI_2 + lean);
    let speed = random.magnitude(-2.3, 0.1);
    let aside = if random.chance(0.5) { 0.0 } else { random.between(-1.0, 1.0) };
    let apart =
        if random.chance(0.7) { 0.0 } else { random.sign() * random.magnitude(-17.0, -2.0) };
    let d = at_touch(random, &place);
    let slide = sum(scaled(place.up, speed), scaled(place.along, aside * speed));
    Motion { d, v: sum(slide, scaled(place.normal, apart)), h: FREE_FALL }
}

fn far_rim(random: &mut Random, ring: f64) -> Motion<3> {
    let inner = (ring - BALL_RADIUS).max(0.2 * ring);
    let [x, y] = random.direction();
    let out = inner * random.unit().sqrt();
    let d = [out * x, out * y, random.between(-1.5, 1.5) * BALL_RADIUS];
    let [p, q] = random.direction();
    let speed = random.magnitude(-1.0, 1.0);
    Motion { d, v: [p * speed, q * speed, random.between(-0.5, 1.0) * speed], h: FREE_FALL }
}

fn touching(random: &mut Random, ring: f64, sign: f64) -> Motion<3> {
    let tilt = any_tilt(random);
    let place = place(random, ring, tilt);
    let apart = sign * random.magnitude(-9.0, 0.7);
    let across = if random.chance(0.3) { 0.0 } else { random.magnitude(-3.0, 0.7) };
    let [a, b] = random.direction();
    let d = at_touch(random, &place);
    let slide = sum(scaled(place.up, a * across), scaled(place.along, b * across));
    Motion { d, v: sum(slide, scaled(place.normal, apart)), h: FREE_FALL }
}

fn nearly_static(random: &mut Random, ring: f64) -> Motion<3> {
    let tilt = any_tilt(random);
    let EdgePoint { edge, normal, .. } = place(random, ring, tilt);
    let gap = random.magnitude(-15.0, -6.0);
    let speed = random.magnitude(-9.0, -3.0);
    let v = scaled(direction(random), speed);
    let h = if random.chance(0.5) {
        FREE_FALL
    } else {
        let size = random.magnitude(-9.0, 0.3);
        scaled(direction(random), size)
    };
    Motion { d: sum(edge, scaled(normal, BALL_RADIUS + gap)), v, h }
}

fn falling(random: &mut Random, ring: f64) -> Motion<3> {
    let [x, y] = random.direction();
    let aside =
        if random.chance(0.5) { 0.0 } else { random.sign() * random.magnitude(-17.0, -2.0) };
    let out = if random.chance(0.5) { ring + aside } else { aside };
    let lateral = if random.chance(0.5) { 0.0 } else { random.magnitude(-9.0, -1.0) };
    let [p, q] = random.direction();
    let d = [out * x, out * y, BALL_RADIUS + random.magnitude(-6.0, -0.5)];
    Motion { d, v: [lateral * p, lateral * q, random.between(-3.0, 1.0)], h: FREE_FALL }
}

fn meridian(random: &mut Random, ring: f64) -> Motion<3> {
    let reach = ring + 1.5 * BALL_RADIUS;
    let x = [random.between(-reach, reach), 0.0, random.between(-1.2, 1.2) * BALL_RADIUS];
    let [p, q] = random.direction();
    let speed = random.magnitude(-1.0, 1.0);
    let time = random.magnitude(-3.0, -1.0);
    let motion = through(x, [p * speed, 0.0, q * speed], FREE_FALL, time);
    if random.chance(0.5) {
        let turn = |[x, y, z]: [f64; 3]| [y, x, z];
        return Motion { d: turn(motion.d), v: turn(motion.v), h: turn(motion.h) };
    }
    motion
}
