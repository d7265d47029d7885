//! Bounds of the squared gap to a ring on a span of time.
//!
//! On a span of width w, with s the time since its start, |x|² and its derivatives are polynomials,
//! and lie between the least and the greatest of their Bernstein coefficients. For ρ:
//!
//! * x = Σ Bᵢ pᵢ with the Bézier points pᵢ of the path, so ρ ≤ Σ Bᵢ |pᵢ|, a quadratic;
//! * along any unit vector n, ρ ≥ n·x ≥ min n·pᵢ;
//! * ρ″ = L²/ρ³ + (x, y)·(ẍ, ÿ)/ρ, where L = xẏ − yẋ and (x, y)·(ẍ, ÿ) are quadratics as well;
//! * so ρ″ ≥ −A with A = |(ẍ, ÿ)|, and ρ′ falls by at most Aw, even across the axis, where it jumps
//!   up.

use super::{RingSample, Tube};
use crate::motion::{Motion, dot};
use crate::root::sqrt;

/// What has been proved about the squared gap f on a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum GapShape {
    /// f′ < 0.
    Falling,
    /// f′ ≥ 0.
    Rising,
    /// f″ ≥ 0.
    Convex,
    /// f″ ≤ 0, and f′ jumps down where the path crosses the axis.
    Concave,
    /// Nothing.
    Unknown,
}

/// The path between two samples.
pub(super) struct Span<'a> {
    tube: &'a Tube<'a>,
    here: &'a RingSample,
    there: &'a RingSample,
    /// w.
    width: f64,
    /// |x|²′/2 = Σ gᵢ sⁱ.
    g: [f64; 4],
    /// The middle Bézier point of (x, y).
    middle: [f64; 2],
}

impl<'a> Span<'a> {
    #[inline(always)]
    pub(super) fn new(tube: &'a Tube<'a>, here: &'a RingSample, there: &'a RingSample) -> Self {
        let width = there.t - here.t;
        let h = &tube.motion.h;
        let RingSample { x, velocity, .. } = here;
        let g = [
            dot(x, velocity),
            dot(velocity, velocity) + 2.0 * dot(x, h),
            3.0 * dot(velocity, h),
            2.0 * dot(h, h),
        ];
        let middle = [0, 1].map(|i| x[i] + 0.5 * (width * velocity[i]));
        Span { tube, here, there, width, g, middle }
    }

    /// Whether f > 0 on the whole span: the Bernstein coefficients of a quartic below f are
    /// positive.
    #[inline(always)]
    pub(super) fn is_clear(&self) -> bool {
        let Span { tube, here, there, width: w, g, middle } = self;
        let Tube { ring, distance, .. } = **tube;
        let rest = (ring - distance) * (ring + distance);
        let [first, last] = [dot(&here.x, &here.x), dot(&there.x, &there.x)].map(|x| x + rest);
        let squares = [
            first,
            first + 0.5 * (w * g[0]),
            first + w * (g[0] + w * g[1] / 6.0),
            first + w * (1.5 * g[0] + w * (0.5 * g[1] + w * g[2] / 6.0)),
            last,
        ];
        let [near, far] = [here.radius, there.radius];
        let bend = sqrt(middle[0] * middle[0] + middle[1] * middle[1]);
        let radii =
            [near, 0.5 * (near + bend), (near + 4.0 * bend + far) / 6.0, 0.5 * (bend + far), far];
        let least = |i: usize| squares[i] - 2.0 * (ring * radii[i]);
        // The ends are values of f itself, for which the samples are more accurate.
        here.f > 0.0 && least(1) > 0.0 && least(2) > 0.0 && least(3) > 0.0 && there.f > 0.0
    }

    #[inline(always)]
    pub(super) fn shape(&self) -> GapShape {
        let Span { tube, here, there, width: w, g, .. } = self;
        let ring = tube.ring;
        // If f′ has different signs at the ends, it is neither negative nor positive on the whole
        // span.
        if (here.g < 0.0) != (there.g < 0.0) {
            return self.curvature();
        }
        let h = &tube.motion.h;
        let drop = 2.0 * w * sqrt(h[0] * h[0] + h[1] * h[1]);
        let rates = [
            g[0],
            g[0] + w * g[1] / 3.0,
            g[0] + w * (2.0 * g[1] + w * g[2]) / 3.0,
            dot(&there.x, &there.velocity),
        ];
        if greatest(&rates) < ring * (here.radial_rate - drop) {
            return GapShape::Falling;
        }
        if least(&rates) >= ring * (there.radial_rate + drop) {
            return GapShape::Rising;
        }
        self.curvature()
    }

    #[inline(always)]
    fn curvature(&self) -> GapShape {
        let Span { tube, here, there, width: w, g, middle } = self;
        let Tube { ring, motion: Motion { h, .. }, .. } = **tube;
        let curves = [g[1], g[1] + w * g[2], g[1] + w * (2.0 * g[2] + w * (3.0 * g[3]))];
        let start = cross(&here.x, &here.velocity);
        let spins = [start, start + w * cross(&here.x, h), cross(&there.x, &there.velocity)];
        let (slow, fast) = magnitudes(&spins);
        let bend = sqrt(middle[0] * middle[0] + middle[1] * middle[1]);
        let closest = least_radius(here, there, middle).max(0.0);
        let farthest = greatest(&[here.radius, bend, there.radius]);
        let (least_pull, greatest_pull) = self.pull(closest, farthest);
        if closest > 0.0 && least(&curves) >= ring * (centrifugal(fast, closest) + greatest_pull) {
            return GapShape::Convex;
        }
        if greatest(&curves) <= ring * (centrifugal(slow, farthest) + least_pull) {
            return GapShape::Concave;
        }
        GapShape::Unknown
    }

    /// Bounds of (x, y)·(ẍ, ÿ)/ρ, from bounds of ρ.
    #[inline(always)]
    fn pull(&self, closest: f64, farthest: f64) -> (f64, f64) {
        let Span { tube, here, there, middle, .. } = self;
        let h = &tube.motion.h;
        if h[0] == 0.0 && h[1] == 0.0 {
            return (0.0, 0.0);
        }
        let most = 2.0 * sqrt(h[0] * h[0] + h[1] * h[1]);
        let along = |x: f64, y: f64| 2.0 * (x * h[0] + y * h[1]);
        let parts = [
            along(here.x[0], here.x[1]),
            along(middle[0], middle[1]),
            along(there.x[0], there.x[1]),
        ];
        let (low, high) = (least(&parts), greatest(&parts));
        let low = if low > 0.0 { low / farthest } else { (low / closest).max(-most) };
        let high = if high < 0.0 { high / farthest } else { (high / closest).min(most) };
        (low, high)
    }
}

/// A lower bound of ρ: the least component of a Bézier point along the mean of the ends.
#[inline(always)]
fn least_radius(here: &RingSample, there: &RingSample, middle: &[f64; 2]) -> f64 {
    let n = [here.x[0] + there.x[0], here.x[1] + there.x[1]];
    let length = sqrt(n[0] * n[0] + n[1] * n[1]);
    let along = |x: f64, y: f64| n[0] * x + n[1] * y;
    let parts =
        [along(here.x[0], here.x[1]), along(middle[0], middle[1]), along(there.x[0], there.x[1])];
    least(&parts) / length
}

/// L²/ρ³.
#[inline(always)]
fn centrifugal(spin: f64, radius: f64) -> f64 {
    spin * spin / (radius * radius * radius)
}

/// The vertical component of a × b.
#[inline(always)]
fn cross(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The least and the greatest magnitude between the least and the greatest of some numbers.
#[inline(always)]
fn magnitudes(numbers: &[f64; 3]) -> (f64, f64) {
    let (low, high) = (least(numbers), greatest(numbers));
    (low.max(-high).max(0.0), high.max(-low))
}

#[inline(always)]
fn least<const N: usize>(numbers: &[f64; N]) -> f64 {
    numbers.iter().fold(f64::INFINITY, |a, &b| if b < a { b } else { a })
}

#[inline(always)]
fn greatest<const N: usize>(numbers: &[f64; N]) -> f64 {
    numbers.iter().fold(f64::NEG_INFINITY, |a, &b| if b > a { b } else { a })
}
