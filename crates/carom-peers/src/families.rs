//! Nine hard families of motions, and uniformly random motions.
//!
//! Each family is a case in which finders can fail: a graze within rounding, a quartic whose
//! leading coefficient vanishes, bodies that already touch. Lengths are in m and times in s, as on
//! a table.

use carom_roots::Motion;

use crate::random::{Random, RandomMotion};

/// Two pool balls of 2 1/4 in: the distance of their centres in contact, m.
pub const BALL_DIAMETER: f64 = 0.057_15;

/// The diagonal of a 12-ft snooker table, the largest distance of two balls, m. The rounding of
/// positions grows with distance, so faults of 1e-15 m have a meaning only within it.
pub const LARGEST_TABLE: f64 = 4.0;

/// The input of a finder, and the scale of its faults.
#[derive(Clone, Copy, Debug)]
pub struct Case<const N: usize = 2> {
    /// The relative motion.
    pub motion: Motion<N>,
    /// Contact distance, m.
    pub distance: f64,
    /// The last time of interest, s; may be infinite.
    pub horizon: f64,
    /// The length of a table's metre in this case; 1 except in [`Family::Scaled`].
    pub metre: f64,
}

/// Families of hard cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// N1: the closest approach is within 1e-4 … 0 (relative) of touching.
    Grazing,
    /// N2: accelerations down to 1e-12 m/s², so that the quartic's leading coefficient vanishes.
    LeadingToZero,
    /// N3: no acceleration.
    LeadingZero,
    /// N4: touching within rounding, separating, accelerated back.
    TouchingSeparating,
    /// N5: touching within rounding, approaching.
    TouchingApproaching,
    /// N6: gaps down to 1e-15 m and speeds down to 1e-9 m/s.
    TinyGapAndSpeed,
    /// N7: grazing from metres away, at up to 20 m/s.
    FarFastGrazing,
    /// N8: touching within rounding, with a normal speed of exactly zero.
    NoNormalSpeed,
    /// N9: the other families in units of 1e-6 … 1e6 m and s.
    Scaled,
}

impl Family {
    /// N1 to N9.
    pub const ALL: [Family; 9] = [
        Family::Grazing,
        Family::LeadingToZero,
        Family::LeadingZero,
        Family::TouchingSeparating,
        Family::TouchingApproaching,
        Family::TinyGapAndSpeed,
        Family::FarFastGrazing,
        Family::NoNormalSpeed,
        Family::Scaled,
    ];

    /// One case. At the start its bodies overlap by no more than rounding.
    pub fn sample(self, random: &mut Random) -> Case {
        apart(random, |random| self.draw(random))
    }

    fn draw(self, random: &mut Random) -> Case {
        let motion = match self {
            Family::Grazing => {
                let t = random.magnitude(-2.0, 0.3);
                grazing(random, t, 4.0)
            }
            Family::LeadingToZero => {
                let size = random.magnitude(-12.0, -3.0);
                Motion { h: scaled(random.direction(), size), ..aimed(random) }
            }
            Family::LeadingZero => Motion { h: [0.0; 2], ..aimed(random) },
            Family::TouchingSeparating => touching(random, 1.0),
            Family::TouchingApproaching => touching(random, -1.0),
            Family::TinyGapAndSpeed => tiny(random),
            Family::FarFastGrazing => {
                let t = random.between(0.05, 0.2);
                grazing(random, t, 20.0)
            }
            Family::NoNormalSpeed => no_normal_speed(random),
            Family::Scaled => return scaled_case(random),
        };
        Case { motion, distance: BALL_DIAMETER, horizon: horizon(random), metre: 1.0 }
    }
}

/// The first drawn case that fits on a table and overlaps at the start by no more than rounding.
fn apart(random: &mut Random, draw: impl Fn(&mut Random) -> Case) -> Case {
    /// Relative to the contact distance: 1e-16 m for balls.
    const ROUNDINGS: f64 = 8.0 * f64::EPSILON;
    loop {
        let case = draw(random);
        let [x, y] = case.motion.d;
        let apart = (x * x + y * y).sqrt();
        if apart >= case.distance * (1.0 - ROUNDINGS) && apart <= LARGEST_TABLE * case.metre {
            return case;
        }
    }
}

/// A uniformly random pair on a 9-ft table, sliding, rolling or at rest.
pub fn uniform_pair(random: &mut Random) -> Case {
    apart(random, draw_uniform_pair)
}

fn draw_uniform_pair(random: &mut Random) -> Case {
    let place = |random: &mut Random| [random.between(-1.24, 1.24), random.between(-0.6, 0.6)];
    let (a, b) = (place(random), place(random));
    let (one, other) = (moving_ball(random), moving_ball(random));
    let still = ([0.0; 2], [0.0; 2], f64::INFINITY);
    let other = if random.chance(0.6) { still } else { other };
    let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
    Case {
        motion: Motion { d: minus(a, b), v: minus(one.0, other.0), h: minus(one.1, other.1) },
        distance: BALL_DIAMETER,
        horizon: one.2.min(other.2),
        metre: 1.0,
    }
}

/// A pair as in the first moments of a break: close together and mostly without spin, so that
/// friction acts along the path.
pub fn cluster_pair(random: &mut Random) -> Case {
    let mut case = uniform_pair(random);
    let distance = BALL_DIAMETER + random.magnitude(-4.0, -0.3);
    case.motion.d = scaled(random.direction(), distance);
    let aim = random.between(-1.1, 1.1) * BALL_DIAMETER / distance;
    let speed = random.between(0.2, 4.0);
    let [x, y] = scaled(case.motion.d, -1.0 / distance);
    let direction = normalised([x - aim * y, y + aim * x]);
    case.motion.v = scaled(direction, speed);
    if random.chance(0.6) {
        case.motion.h = scaled(direction, -0.5 * SLIDING_DECELERATION);
        case.horizon = 2.0 / 7.0 * speed / SLIDING_DECELERATION;
    } else {
        let slips = [random.direction(), random.direction()];
        case.motion.h = [0, 1].map(|i| 0.5 * SLIDING_DECELERATION * (slips[1][i] - slips[0][i]));
        case.horizon = random.between(0.05, 0.6);
    }
    case
}

/// μ g of a sliding ball, 0.2 × 9.81 m/s².
const SLIDING_DECELERATION: f64 = 1.962;
/// μ g of a rolling ball, 0.01 × 9.81 m/s².
const ROLLING_DECELERATION: f64 = 0.0981;

/// Velocity, half the acceleration, and the time for which the acceleration holds.
fn moving_ball(random: &mut Random) -> ([f64; 2], [f64; 2], f64) {
    let direction = random.direction();
    let speed = random.magnitude(-1.0, 0.8);
    let velocity = scaled(direction, speed);
    if random.chance(0.5) {
        let half = scaled(direction, -0.5 * ROLLING_DECELERATION);
        (velocity, half, speed / ROLLING_DECELERATION)
    } else {
        let slip = random.between(0.1, 1.5) * speed;
        let half = scaled(random.direction(), -0.5 * SLIDING_DECELERATION);
        (velocity, half, 2.0 / 7.0 * slip / SLIDING_DECELERATION)
    }
}

fn scaled(a: [f64; 2], by: f64) -> [f64; 2] {
    [a[0] * by, a[1] * by]
}

fn normalised(a: [f64; 2]) -> [f64; 2] {
    scaled(a, 1.0 / (a[0] * a[0] + a[1] * a[1]).sqrt())
}

/// d + v t + h t².
fn quadratic(d: [f64; 2], v: [f64; 2], h: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|i| d[i] + t * (v[i] + t * h[i]))
}

/// Half of a relative acceleration by friction on the cloth.
fn friction(random: &mut Random) -> [f64; 2] {
    let size = random.magnitude(-2.0, 0.4);
    scaled(random.direction(), size)
}

fn horizon(random: &mut Random) -> f64 {
    if random.chance(0.5) { f64::INFINITY } else { random.magnitude(-3.0, 1.0) }
}

/// The closest approach is at `time`, within 1e-4 … 0 (relative) of touching, with a speed up to
/// `speed`.
fn grazing(random: &mut Random, time: f64, speed: f64) -> Motion<2> {
    let offset = match random.bits() % 4 {
        0 => 0.0,
        _ => random.sign() * random.magnitude(-17.0, -4.0),
    };
    let n = random.direction();
    let closest = scaled(n, BALL_DIAMETER * (1.0 + offset));
    let speed = random.sign() * random.between(0.02, 1.0) * speed;
    let velocity = scaled([-n[1], n[0]], speed);
    let h = friction(random);
    // Backwards from the closest approach.
    let back = quadratic(closest, velocity, h, -time);
    Motion { d: back, v: [0, 1].map(|i| velocity[i] - 2.0 * time * h[i]), h }
}

/// From up to 2.5 m away, aimed within two diameters.
fn aimed(random: &mut Random) -> Motion<2> {
    let reach = random.between(1.01 * BALL_DIAMETER, 2.5);
    let d = scaled(random.direction(), reach);
    let miss = scaled(random.direction(), random.between(0.0, 2.0) * BALL_DIAMETER);
    let towards = normalised([miss[0] - d[0], miss[1] - d[1]]);
    let speed = random.magnitude(-2.0, 1.0);
    Motion { d, v: scaled(towards, speed), h: friction(random) }
}

/// Within two roundings of touching; `sign` is that of the normal speed.
fn touching(random: &mut Random, sign: f64) -> Motion<2> {
    let n = random.direction();
    let roundings = (random.bits() % 5) as f64 - 2.0;
    let d = scaled(n, BALL_DIAMETER * (1.0 + roundings * f64::EPSILON));
    let speed = sign * random.magnitude(-9.0, 0.7);
    let across = if random.chance(0.5) { 0.0 } else { random.between(-2.0, 2.0) };
    let v = [n[0] * speed - n[1] * across, n[1] * speed + n[0] * across];
    let h =
        if random.chance(0.7) { scaled(n, -random.magnitude(-2.0, 1.0)) } else { friction(random) };
    Motion { d, v, h }
}

fn tiny(random: &mut Random) -> Motion<2> {
    let n = random.direction();
    let d = scaled(n, BALL_DIAMETER + random.magnitude(-15.0, -6.0));
    let speed = random.magnitude(-9.0, -3.0);
    let v = scaled(random.direction(), speed);
    let size = random.magnitude(-9.0, 0.3);
    Motion { d, v, h: scaled(random.direction(), size) }
}

/// Along an axis, so that d·v is exactly zero.
fn no_normal_speed(random: &mut Random) -> Motion<2> {
    let ulp_inside = (random.bits() % 3) as f64;
    let along = random.sign() * BALL_DIAMETER * (1.0 - ulp_inside * f64::EPSILON);
    let across = if random.chance(0.3) { 0.0 } else { random.sign() * random.magnitude(-6.0, 0.7) };
    let h = friction(random);
    if random.chance(0.5) {
        Motion { d: [along, 0.0], v: [0.0, across], h }
    } else {
        Motion { d: [0.0, along], v: [across, 0.0], h }
    }
}

fn scaled_case(random: &mut Random) -> Case {
    let family = Family::ALL[(random.bits() % 8) as usize];
    let case = family.sample(random);
    let (metre, second) = (random.magnitude(-6.0, 6.0), random.magnitude(-6.0, 6.0));
    Case {
        motion: Motion {
            d: scaled(case.motion.d, metre),
            v: scaled(case.motion.v, metre / second),
            h: scaled(case.motion.h, metre / (second * second)),
        },
        distance: case.distance * metre,
        horizon: case.horizon * second,
        metre,
    }
}
