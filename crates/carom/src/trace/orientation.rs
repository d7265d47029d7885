//! Orientations: the rotation of every ball since the shot began.
//!
//! The spin ω of a ball is linear in time between two of its events, or on two parts of that time
//! if its sidespin ends in between. The orientation obeys dR/dt = ω × R. Where the axis of ω is
//! constant, the rotation is exact: the mean spin times the time. Elsewhere it is integrated with
//! the Magnus expansion of fourth order (Blanes, Casas, Oteo & Ros 2009, section 5.3): a step h
//! with the spin ω at its middle and the rate b of the spin is the rotation vector hω + (h³/12) b ×
//! ω.

use alloc::vec::Vec;

use super::{Piece, Trace};
use crate::math::{Vec3, ceil, sin_cos, sqrt};

/// Largest rotation in a Magnus step, rad. The error over a whole break is then less than 1e-5 rad.
const STEP: f64 = 0.1;

/// Steps between two stored orientations: few enough that any instant is computed in a microsecond,
/// and enough that a break stores only a few thousand orientations.
const STEPS_PER_KEY: usize = 16;

/// Largest number of steps of a stretch: 2 MB of stored orientations. Ten seconds at 10 000 rad/s
/// need this many. A ball that spins longer while it slides, with almost no friction, gets longer
/// steps, which are less exact.
const MOST_STEPS: f64 = 1_048_576.0;

/// Two spins whose directions differ by less, rad, have the same axis: the difference is rounding.
const SAME_AXIS: f64 = 1e-12;

/// A rotation as a unit quaternion.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Quaternion {
    vector: Vec3,
    scalar: f64,
}

impl Quaternion {
    const IDENTITY: Self = Self { vector: Vec3::ZERO, scalar: 1.0 };

    /// The rotation by a rotation vector, rad.
    fn from_rotation_vector(by: Vec3) -> Self {
        let angle = by.length();
        // An angle that overflows has no sine.
        if angle == 0.0 || angle.is_infinite() {
            return Self::IDENTITY;
        }
        let (sin, cos) = sin_cos(0.5 * angle);
        Self { vector: by * (sin / angle), scalar: cos }
    }

    /// This rotation after `first`.
    fn after(self, first: Self) -> Self {
        let (u, v) = (self.vector, first.vector);
        Self {
            vector: v * self.scalar + u * first.scalar + u.cross(v),
            scalar: self.scalar * first.scalar - u.dot(v),
        }
    }

    fn normalized(self) -> Self {
        let by = 1.0 / sqrt(self.vector.length_squared() + self.scalar * self.scalar);
        Self { vector: self.vector * by, scalar: self.scalar * by }
    }
}

/// A stretch of time on which a ball's spin is linear.
#[derive(Clone, Debug)]
struct Stretch {
    /// Time of its start, s since the strike.
    start: f64,
    /// Its length, s; infinite if nothing ends it.
    length: f64,
    /// Spin at its start, rad/s.
    spin: Vec3,
    /// Rate of change of the spin, rad/s².
    rate: Vec3,
    /// Length of a step, s; the length of the stretch if the axis is constant.
    step: f64,
    /// Orientations at the start and after every [`STEPS_PER_KEY`] steps.
    keys: Vec<Quaternion>,
}

impl Stretch {
    /// The stretch from `from` to `to` (s after the start of `piece`); `first` is the orientation
    /// at its start.
    fn new(piece: &Piece, from: f64, to: f64, first: Quaternion) -> Self {
        let length = to - from;
        let spin = piece.path.at(from).angular_velocity;
        let mut stretch = Self {
            start: piece.start + from,
            length,
            spin,
            rate: Vec3::ZERO,
            step: length,
            keys: Vec::from([first]),
        };
        if length.is_finite() && length > 0.0 {
            stretch.divide(piece.path.at(to).angular_velocity);
        }
        stretch
    }

    /// Divides the stretch into steps; `last` is the spin at its end.
    fn divide(&mut self, last: Vec3) {
        self.rate = (last - self.spin) * (1.0 / self.length);
        let across = self.spin.cross(last).length();
        if across <= SAME_AXIS * self.spin.length() * last.length() {
            return;
        }
        let fastest = self.spin.length().max(last.length());
        let steps = ceil(fastest * self.length / STEP).clamp(1.0, MOST_STEPS);
        self.step = self.length / steps;
        for k in 1..=(steps as usize) / STEPS_PER_KEY {
            let key = self.walk((k - 1) * STEPS_PER_KEY, STEPS_PER_KEY);
            self.keys.push(key.normalized());
        }
    }

    /// The orientation `steps` whole steps after the key at step `from`.
    fn walk(&self, from: usize, steps: usize) -> Quaternion {
        let key = self.keys[from / STEPS_PER_KEY];
        (from..from + steps)
            .fold(key, |q, k| self.rotation(k as f64 * self.step, self.step).after(q))
    }

    /// The rotation during `h` seconds, from `t` seconds after the start of the stretch.
    fn rotation(&self, t: f64, h: f64) -> Quaternion {
        if self.length.is_infinite() {
            // The rate is 0, and the cube of a long time would overflow.
            return Quaternion::from_rotation_vector(self.spin * h);
        }
        let mid = self.spin + self.rate * (t + 0.5 * h);
        Quaternion::from_rotation_vector(mid * h + self.rate.cross(mid) * (h * h * h / 12.0))
    }

    /// The orientation `t` seconds after the start of the stretch.
    fn at(&self, t: f64) -> Quaternion {
        let t = t.clamp(0.0, self.length);
        // In a stretch of no length this is NaN, which the cast turns into 0.
        let whole = (t / self.step) as usize;
        let key = (whole / STEPS_PER_KEY).min(self.keys.len() - 1);
        let q = self.walk(key * STEPS_PER_KEY, whole - key * STEPS_PER_KEY);
        // 0 times an infinite step would be NaN.
        let walked = if whole == 0 { 0.0 } else { whole as f64 * self.step };
        let rest = t - walked;
        if rest > 0.0 { self.rotation(walked, rest).after(q).normalized() } else { q.normalized() }
    }
}

/// The orientations of a trace's balls at any time, computed once for many queries.
#[derive(Clone, Debug)]
pub struct Orientations {
    balls: Vec<Vec<Stretch>>,
}

impl Trace {
    /// The orientations of the balls at any time.
    pub fn orientations(&self) -> Orientations {
        let balls = 0..self.shot.balls.len();
        Orientations { balls: balls.map(|ball| stretches(&self.pieces(ball))).collect() }
    }
}

fn stretches(pieces: &[Piece]) -> Vec<Stretch> {
    let mut list: Vec<Stretch> = Vec::new();
    let mut now = Quaternion::IDENTITY;
    for piece in pieces {
        let path = &piece.path;
        let length = (piece.end - piece.start).min(path.duration);
        // Without sidespin and without its deceleration this is NaN (0/0), which the filter drops.
        let dies_out = path.angular_velocity.z.abs() / path.spin_deceleration;
        let cut = Some(dies_out).filter(|t| *t > 0.0 && *t < length);
        let mut from = 0.0;
        for to in cut.into_iter().chain([length]) {
            let stretch = Stretch::new(piece, from, to, now);
            if stretch.length.is_finite() {
                now = stretch.at(stretch.length);
            }
            list.push(stretch);
            from = to;
        }
    }
    list
}

impl Orientations {
    /// The orientation of ball `ball` (an index into the shot's balls) at `time` (s ≥ 0 since the
    /// strike): the unit quaternion x, y, z, w of its rotation since the start. It is constant once
    /// the ball is at rest.
    pub fn at(&self, ball: usize, time: f64) -> [f64; 4] {
        let stretches = &self.balls[ball];
        let after = stretches.partition_point(|s| s.start <= time);
        let stretch = &stretches[after.saturating_sub(1)];
        let Quaternion { vector, scalar } = stretch.at(time - stretch.start);
        [vector.x, vector.y, vector.z, scalar]
    }
}
