//! Closest approach on an interval, by subdivision of Bernstein polynomials.

use carom::math::Vec2;
use carom::shot::Shot;
use carom::table::{Capture, Shape};
use carom::{BallState, MotionState};

use crate::bernstein::Bernstein;

/// Deepest subdivision: 2⁻⁵⁰ of an interval is less than the rounding of its ends.
const LEVELS: u32 = 50;

/// A centre's path p + v t + h t², and how the ball meets other things.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curve {
    p: Vec2,
    v: Vec2,
    h: Vec2,
    z: f64,
    radius: f64,
}

impl Curve {
    /// From the equation of motion of the ball's state, written anew: m dv/dt = F.
    pub(crate) fn new(shot: &Shot, i: usize, state: &BallState) -> Self {
        let radius = shot.balls()[i].ball.radius;
        let (cloth, g) = (shot.physics().cloth, shot.physics().gravity);
        let (v, w) = (state.velocity, state.angular_velocity);
        let against = |u: Vec2, mu: f64| {
            let size = u.length();
            if size == 0.0 { Vec2::ZERO } else { u * (-0.5 * mu * g / size) }
        };
        let h = match state.motion {
            MotionState::Sliding => {
                let slip = Vec2::new(v.x - radius * w.y, v.y + radius * w.x);
                against(slip, cloth.sliding_friction)
            }
            MotionState::Rolling => against(v.xy(), cloth.rolling_friction),
            _ => Vec2::ZERO,
        };
        Self { p: state.position.xy(), v: v.xy(), h, z: state.position.z, radius }
    }

    pub(crate) fn at(&self, t: f64) -> (Vec2, Vec2) {
        (self.p + self.v * t + self.h * (t * t), self.v + self.h * (2.0 * t))
    }

    /// The same path with its clock set to 0 at `t`.
    pub(crate) fn from(&self, t: f64) -> Self {
        let (p, v) = self.at(t);
        Self { p, v, ..*self }
    }

    /// No farther than this does the centre come in `length` seconds, m.
    fn travel(&self, length: f64) -> f64 {
        length * (self.v.length() + length * self.h.length())
    }

    pub(crate) fn moves(&self) -> bool {
        self.v != Vec2::ZERO || self.h != Vec2::ZERO
    }
}

/// The deepest overlap on an interval, m (negative or −∞: none), and when, s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Intrusion {
    pub(crate) depth: f64,
    pub(crate) after: f64,
}

impl Intrusion {
    const NONE: Self = Self { depth: f64::NEG_INFINITY, after: 0.0 };
}

/// Two balls.
pub(crate) fn pair(a: &Curve, b: &Curve, length: f64, tolerance: f64) -> Intrusion {
    if !a.moves() && !b.moves() {
        return Intrusion::NONE;
    }
    let (d, v, h) = (b.p - a.p, b.v - a.v, b.h - a.h);
    let dz = b.z - a.z;
    let touching = a.radius + b.radius;
    if d.length() - a.travel(length) - b.travel(length) > touching {
        return Intrusion::NONE;
    }
    let gap = quartic(d, v, h, touching * touching - dz * dz, length);
    search(&gap, 2.0 * touching, tolerance, 0.0, length, LEVELS, &|_| true)
}

/// Something of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Feature {
    Cushion(usize),
    Hole(usize),
}

/// Calls `found` with how a ball comes to every cushion part and hole of the table that it could
/// reach.
pub(crate) fn table(
    shot: &Shot,
    curve: &Curve,
    length: f64,
    tolerance: f64,
    mut found: impl FnMut(Intrusion, Feature),
) {
    let table = shot.table();
    let rise = table.cushion_height - curve.radius;
    let reach = (curve.radius * curve.radius - rise * rise).sqrt();
    // Farther from the edge of the playing area than it can come, a ball meets nothing.
    let travel = curve.travel(length);
    let room = reach + travel;
    let inside = |half: f64, p: f64| half - p.abs() > room;
    if inside(0.5 * table.size.x, curve.p.x) && inside(0.5 * table.size.y, curve.p.y) {
        return;
    }
    for (k, part) in table.parts_on_cloth().iter().enumerate() {
        let intrusion = match part.shape {
            Shape::Segment { start, end, normal } => {
                let above = (curve.p - start).dot(normal);
                let past = ((curve.p - start).dot(end - start)) / (end - start).length();
                if above > room || past < -travel || past > (end - start).length() + travel {
                    continue;
                }
                wall(curve, start, end, normal, reach, length, tolerance)
            }
            Shape::Arc { center, radius, start, end } => {
                let distance = radius + reach;
                // Within the angle that the arc spans, seen from its centre.
                let middle = start + end;
                let inside = |t: f64| {
                    let d = curve.at(t).0 - center;
                    d.dot(middle) >= start.dot(middle) * d.length()
                };
                around(curve, center, distance, length, tolerance, &inside)
            }
            Shape::Hollow { .. } | Shape::Plane { .. } => continue,
        };
        found(intrusion, Feature::Cushion(k));
    }
    for (k, pocket) in table.pockets.iter().enumerate() {
        if pocket.capture == Capture::DropCircle {
            let intrusion =
                around(curve, pocket.center, pocket.radius, length, tolerance, &|_| true);
            found(intrusion, Feature::Hole(k));
        }
    }
}

/// A centre that must stay `distance` from a fixed point, where `counts`.
fn around(
    curve: &Curve,
    center: Vec2,
    distance: f64,
    length: f64,
    tolerance: f64,
    counts: &dyn Fn(f64) -> bool,
) -> Intrusion {
    let d = curve.p - center;
    if d.length() - curve.travel(length) > distance {
        return Intrusion::NONE;
    }
    let gap = quartic(d, curve.v, curve.h, distance * distance, length);
    search(&gap, 2.0 * distance, tolerance, 0.0, length, LEVELS, counts)
}

/// |d + vt + ht²|² − `square` on [0, `length`].
fn quartic(d: Vec2, v: Vec2, h: Vec2, square: f64, length: f64) -> Bernstein<5> {
    Bernstein::from_monomials(
        [d.dot(d) - square, 2.0 * d.dot(v), v.dot(v) + 2.0 * d.dot(h), 2.0 * v.dot(h), h.dot(h)],
        length,
    )
}

/// A straight wall from `start` to `end`.
fn wall(
    curve: &Curve,
    start: Vec2,
    end: Vec2,
    normal: Vec2,
    reach: f64,
    length: f64,
    tolerance: f64,
) -> Intrusion {
    let d = curve.p - start;
    let gap = Bernstein::from_monomials(
        [d.dot(normal) - reach, curve.v.dot(normal), curve.h.dot(normal)],
        length,
    );
    let along = end - start;
    // All of the path beside the wall, or behind it: then it counts nowhere.
    let place =
        Bernstein::from_monomials([d.dot(along), curve.v.dot(along), curve.h.dot(along)], length);
    let beside_it = place.upper() < 0.0 || place.lower() > along.length_squared();
    if beside_it || gap.upper() < -2.0 * reach {
        return Intrusion::NONE;
    }
    // Between its ends only; and behind the wall, where a ball never comes, counts as through it.
    let beside = |t: f64| {
        let s = (curve.at(t).0 - start).dot(along) / along.length_squared();
        let behind = (curve.at(t).0 - start).dot(normal) < -reach;
        (0.0..=1.0).contains(&s) && !behind
    };
    search(&gap, 1.0, tolerance, 0.0, length, LEVELS, &beside)
}

/// Halves the interval until the polynomial is proved nowhere below −`tolerance`·`slope`, or is
/// seen to be, where `counts`. `slope` turns its values into metres.
fn search<const N: usize>(
    gap: &Bernstein<N>,
    slope: f64,
    tolerance: f64,
    from: f64,
    to: f64,
    levels: u32,
    counts: &dyn Fn(f64) -> bool,
) -> Intrusion {
    let lower = gap.lower();
    if lower >= -tolerance * slope {
        return Intrusion { depth: -lower / slope, after: from };
    }
    let middle = 0.5 * (from + to);
    let (left, right) = gap.halves();
    let here = right.0[0];
    if here < -tolerance * slope && counts(middle) {
        return Intrusion { depth: -here / slope, after: middle };
    }
    if levels == 0 || (gap.upper() < -tolerance * slope && levels + 12 < LEVELS && !counts(middle))
    {
        return Intrusion::NONE;
    }
    let a = search(&left, slope, tolerance, from, middle, levels - 1, counts);
    if a.depth > tolerance {
        return a;
    }
    let b = search(&right, slope, tolerance, middle, to, levels - 1, counts);
    if b.depth > a.depth { b } else { a }
}
