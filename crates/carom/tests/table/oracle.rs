//! An independent search for the first meeting of a ball with a table, by distances to the drawn
//! curves.
//!
//! It uses neither offset lines nor roots. The distance of the centre from every nose, point and
//! facing (curves with ends) must not fall below the reach. The search walks along the path in
//! steps no longer than the remaining distance, so that it cannot pass anything thicker than a
//! step's sagitta.

use carom::Table;
use carom::math::{Vec2, sqrt};
use carom::table::{Capture, Shape};
use carom_roots::Motion;

/// Shortest step of the walk, m. A graze shallower than step²/8δ ≈ 5e-12 m may be passed.
const SHORTEST_STEP: f64 = 1e-6;
/// An overlap of this depth without a reported meeting is a missed contact, m: ten thousand
/// roundings.
pub(crate) const LOST: f64 = 1e-12;

/// Numbers that are the same on every machine (xorshift64*).
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1_u64 << 53) as f64
    }
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    pub(crate) fn direction(&mut self) -> Vec2 {
        let (sin, cos) = carom::math::sin_cos(self.between(0.0, 2.0 * core::f64::consts::PI));
        Vec2::new(cos, sin)
    }
}

/// Distance of `p` from the curve `shape`, ends included, m.
pub(crate) fn distance(shape: &Shape, p: Vec2) -> f64 {
    match *shape {
        Shape::Segment { start, end, .. } => {
            let along = end - start;
            let s = ((p - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            (p - (start + along * s)).length()
        }
        Shape::Arc { center, radius, start, end } => {
            let from_center = p - center;
            let turn = start.cross(end);
            let inside =
                start.cross(from_center) * turn >= 0.0 && from_center.cross(end) * turn >= 0.0;
            if inside {
                (from_center.length() - radius).abs()
            } else {
                let (a, b) = (center + start * radius, center + end * radius);
                (p - a).length().min((p - b).length())
            }
        }
        Shape::Hollow { .. } | Shape::Plane { .. } => f64::INFINITY,
    }
}

/// Distance to the nearest cushion, m, and the part.
pub(crate) fn clearance(table: &Table, reach: f64, p: Vec2) -> (f64, usize) {
    let mut nearest = (f64::INFINITY, 0);
    for (i, cushion) in table.cushions.iter().enumerate() {
        let free = distance(&cushion.shape, p) - reach;
        if free < nearest.0 {
            nearest = (free, i);
        }
    }
    nearest
}

/// Distance to the nearest pocket, m; negative inside it.
pub(crate) fn distance_to_pocket(table: &Table, p: Vec2) -> f64 {
    let mut least = f64::INFINITY;
    for pocket in &table.pockets {
        let free = match pocket.capture {
            Capture::DropCircle => (p - pocket.center).length() - pocket.radius,
            Capture::MouthLine { start, end } => to_line([start, end], pocket.axis, p),
        };
        least = least.min(free);
    }
    least
}

/// Signed distance to the line between `ends`, m; infinite if `p` is not in front of it.
fn to_line(ends: [Vec2; 2], axis: Vec2, p: Vec2) -> f64 {
    let across = ends[1] - ends[0];
    let s = (p - ends[0]).dot(across) / across.length_squared();
    if !(-0.5..=1.5).contains(&s) {
        return f64::INFINITY;
    }
    axis.dot(ends[0] - p)
}

/// The first time on `path` in [`from`, `to`] at which the ball is [`LOST`] deep in a cushion, or
/// as deep in a pocket.
pub(crate) fn first_violation(
    table: &Table,
    reach: f64,
    path: &Motion<2>,
    from: f64,
    to: f64,
) -> Option<f64> {
    let mut t = from;
    loop {
        let [x, y] = path.at(t);
        let p = Vec2::new(x, y);
        let free = clearance(table, reach, p).0.min(distance_to_pocket(table, p));
        if free < -LOST {
            return Some(t);
        }
        if t >= to {
            return None;
        }
        let [vx, vy] = path.velocity_at(t);
        let speed = sqrt(vx * vx + vy * vy);
        let bend = 2.0 * sqrt(path.h[0] * path.h[0] + path.h[1] * path.h[1]);
        let step = free.max(SHORTEST_STEP);
        // The ball moves at most `step` in this time: v·dt + ½a·dt² = step.
        let dt = 2.0 * step / (speed + sqrt(speed * speed + 2.0 * bend * step));
        t = (t + dt).min(to);
    }
}
