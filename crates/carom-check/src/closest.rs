//! The closest approach of two balls, and of a ball on the cloth and a hole, on an interval of
//! time, by subdivision of Bernstein polynomials. For a ball and the rails see
//! [`crate::clearance`].

use carom::math::{Vec2, Vec3};

use crate::bernstein::Bernstein;
use crate::curve::Curve;

/// Number of subdivisions: 2⁻⁵⁰ of an interval is less than the rounding error of its ends.
const LEVELS: u32 = 50;

/// The largest overlap on an interval, m (negative or −∞ if there is none), and its time from the
/// start, s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Intrusion {
    pub(crate) depth: f64,
    pub(crate) after: f64,
}

impl Intrusion {
    pub(crate) const NONE: Self = Self { depth: f64::NEG_INFINITY, after: 0.0 };
}

/// The largest overlap of two balls.
pub(crate) fn pair(a: &Curve, b: &Curve, length: f64, tolerance: f64) -> Intrusion {
    if !a.moves() && !b.moves() {
        return Intrusion::NONE;
    }
    let (d, v, h) = (b.p - a.p, b.v - a.v, b.h - a.h);
    let touching = a.radius + b.radius;
    if d.length() - a.travel(length) - b.travel(length) > touching {
        return Intrusion::NONE;
    }
    let gap = quartic(d, v, h, touching * touching, length);
    search(&gap, 2.0 * touching, tolerance, 0.0, length, LEVELS)
}

/// The largest distance of a ball's centre beyond the edge of a hole, over which it must not come.
pub(crate) fn hole(
    curve: &Curve,
    center: Vec2,
    radius: f64,
    length: f64,
    tolerance: f64,
) -> Intrusion {
    let flat = |v: Vec3| v.xy().with_z(0.0);
    let d = flat(curve.p) - center.with_z(0.0);
    if d.length() - curve.travel(length) > radius {
        return Intrusion::NONE;
    }
    let gap = quartic(d, flat(curve.v), flat(curve.h), radius * radius, length);
    search(&gap, 2.0 * radius, tolerance, 0.0, length, LEVELS)
}

/// |d + vt + ht²|² − `square` on [0, `length`].
fn quartic(d: Vec3, v: Vec3, h: Vec3, square: f64, length: f64) -> Bernstein<5> {
    Bernstein::from_monomials(
        [d.dot(d) - square, 2.0 * d.dot(v), v.dot(v) + 2.0 * d.dot(h), 2.0 * v.dot(h), h.dot(h)],
        length,
    )
}

/// Halves the interval until the polynomial is proved to stay above −`tolerance`·`slope`, or a
/// value below is found. Dividing its values by `slope` gives metres.
fn search<const N: usize>(
    gap: &Bernstein<N>,
    slope: f64,
    tolerance: f64,
    from: f64,
    to: f64,
    levels: u32,
) -> Intrusion {
    let lower = gap.lower();
    if lower >= -tolerance * slope {
        return Intrusion { depth: -lower / slope, after: from };
    }
    let middle = 0.5 * (from + to);
    let (left, right) = gap.halves();
    let here = right.0[0];
    if here < -tolerance * slope {
        return Intrusion { depth: -here / slope, after: middle };
    }
    if levels == 0 {
        return Intrusion::NONE;
    }
    let a = search(&left, slope, tolerance, from, middle, levels - 1);
    if a.depth > tolerance {
        return a;
    }
    let b = search(&right, slope, tolerance, middle, to, levels - 1);
    if b.depth > a.depth { b } else { a }
}
