//! First contact of a ball on a quadratic path with a round edge: a circle in space.
//!
//! The path is x(t) = d + vt + ht², the edge the circle of radius a about the origin in the plane z
//! = 0. With ρ = |(x, y)|, the nearest point of the circle is √((ρ − a)² + z²) away, and the
//! squared gap is
//!
//! f(t) = (ρ − a)² + z² − R² = |x|² + a² − R² − 2aρ.
//!
//! Without the root this becomes a polynomial of degree eight, (|x|² + a² − R²)² − 4a²ρ². But where
//! a < R that polynomial is positive even for a centre so deep inside the edge that the ball also
//! reaches the far side. So f is kept as it is, a quartic minus a multiple of ρ. As ρ is a convex
//! function of x, a few scalar products give bounds of f, f′ and f″ on a span of time
//! (`ring::span`).
//!
//! The path is in the box around the torus |ρ − a|² + z² ≤ R² during a window of time. The window
//! is searched from left to right, in spans for each of which one of these is proved:
//!
//! * **clear**: f > 0;
//! * **falling** or **concave**, f > 0 at the left: one root if f ≤ 0 at the right, otherwise none;
//! * **convex**: Newton's method from the left is monotone and finds the first root or proves that
//!   there is none;
//! * touching and not falling at the left: on **rising** or **convex** spans f keeps rising; on a
//!   **concave** one the turning point is a contact if f ≤ 0 there.
//!
//! A span without a proof is halved. After a span with a proof the next one is twice as long.

mod span;

use crate::contact::first_contact;
use crate::crossing::first_crossing;
use crate::motion::Motion;
use crate::root::sqrt;
use span::{GapShape, Span};

/// First t in [`from`, `horizon`] (s) at which the path is within `distance` R (m) of the circle
/// and approaching it, or `None`. The circle has the radius `ring` a ≥ 0 (m) about the origin in
/// the plane z = 0.
///
/// With g(t) = √((ρ − a)² + z²) − R and ρ = |(x, y)| this is the first t with g ≤ 0 and g′ < 0,
/// where g′ is the right-hand derivative where the path crosses the axis. A path that touches at
/// the start, or overlaps by a rounding error, and separates is not in contact. `horizon` may be
/// infinite. A motion that contains a NaN has no contact.
#[inline]
pub fn first_ring_contact(
    motion: &Motion<3>,
    ring: f64,
    distance: f64,
    from: f64,
    horizon: f64,
) -> Option<f64> {
    if box_is_clear(motion, ring + distance, distance, from, horizon) {
        return None;
    }
    if ring == 0.0 {
        return first_point_contact(motion, distance, from, horizon);
    }
    let (start, end) = window(motion, ring + distance, distance, from, horizon)?;
    search_window(&Tube { motion, ring, distance }, start, end)
}

/// The contact with the origin: the quartic of two balls.
fn first_point_contact(motion: &Motion<3>, distance: f64, from: f64, horizon: f64) -> Option<f64> {
    if from == 0.0 {
        return first_contact(motion, distance, horizon);
    }
    let later = Motion { d: motion.at(from), v: motion.velocity_at(from), h: motion.h };
    let t = first_contact(&later, distance, horizon - from)?;
    Some((from + t).min(horizon))
}

/// Factor by which the box is enlarged: more than the rounding errors of its computation, so that a
/// contact on the face of the box is not lost.
const BOX_MARGIN: f64 = 1.0 + 16.0 * f64::EPSILON;

/// Whether the Bernstein coefficients of one coordinate on [from, horizon] are all on one side of
/// the box |x|, |y| ≤ `width`, |z| ≤ `height`.
#[inline(always)]
fn box_is_clear(motion: &Motion<3>, width: f64, height: f64, from: f64, horizon: f64) -> bool {
    let first = motion.at(from);
    let last = motion.at(horizon);
    let rate = motion.velocity_at(from);
    let half = 0.5 * (horizon - from);
    let mut clear = false;
    for (i, bound) in [width, width, height].into_iter().enumerate() {
        let bound = bound * BOX_MARGIN;
        let middle = first[i] + half * rate[i];
        clear |= (first[i] > bound) & (middle > bound) & (last[i] > bound);
        clear |= (first[i] < -bound) & (middle < -bound) & (last[i] < -bound);
    }
    clear
}

/// The first and the last time in [from, horizon] at which the path may be in the box.
fn window(
    motion: &Motion<3>,
    width: f64,
    height: f64,
    from: f64,
    horizon: f64,
) -> Option<(f64, f64)> {
    let (mut start, mut end) = (from, horizon);
    for (i, bound) in [(2, height), (0, width), (1, width)] {
        let coordinate = [motion.d[i], motion.v[i], motion.h[i]];
        (start, end) = slab_window(coordinate, bound * BOX_MARGIN, start, end)?;
    }
    // The end is infinite only for a path at rest, or for one that leaves later than any number.
    (start <= end && end < f64::INFINITY).then_some((start, end))
}

/// The first and the last time in [start, end] at which |c₀ + c₁t + c₂t²| ≤ `bound`.
fn slab_window([c0, c1, c2]: [f64; 3], bound: f64, start: f64, end: f64) -> Option<(f64, f64)> {
    let here = c0 + start * (c1 + start * c2);
    let mut first = start;
    if here.abs() > bound {
        let side = if here > 0.0 { 1.0 } else { -1.0 };
        let rate = c1 + 2.0 * (start * c2);
        first += first_crossing(side * here - bound, side * rate, side * c2, end - start)?;
    }
    let there = c0 + end * (c1 + end * c2);
    if there.abs() <= bound || (c1 == 0.0 && c2 == 0.0) {
        return Some((first, end));
    }
    // In the end the coordinate leaves on this side, at the larger root of c₂t² + c₁t + c₀ ∓ bound.
    let (side, curve) = if c2 != 0.0 { (sign(c2), c2.abs()) } else { (sign(c1), 0.0) };
    let (rate, below) = (side * c1, bound - side * c0);
    let root = sqrt((rate * rate + 4.0 * (curve * below)).max(0.0));
    let last = if rate > 0.0 { 2.0 * below / (rate + root) } else { (root - rate) / (2.0 * curve) };
    Some((first, if last < end { last } else { end }))
}

#[inline(always)]
fn sign(x: f64) -> f64 {
    if x > 0.0 { 1.0 } else { -1.0 }
}

/// A path, and the torus of the points within `distance` of the ring.
#[derive(Clone, Copy)]
struct Tube<'a> {
    motion: &'a Motion<3>,
    ring: f64,
    distance: f64,
}

/// A point of the path, with the squared gap f.
#[derive(Clone, Copy)]
struct RingSample {
    t: f64,
    x: [f64; 3],
    velocity: [f64; 3],
    /// ρ.
    radius: f64,
    /// ρ′, from the right.
    radial_rate: f64,
    /// f.
    f: f64,
    /// f′/2.
    g: f64,
}

impl Tube<'_> {
    #[inline(always)]
    fn sample(&self, t: f64) -> RingSample {
        let x = self.motion.at(t);
        let velocity = self.motion.velocity_at(t);
        let radius = sqrt(x[0] * x[0] + x[1] * x[1]);
        let radial_rate = if radius > 0.0 {
            (x[0] * velocity[0] + x[1] * velocity[1]) / radius
        } else {
            sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1])
        };
        let out = radius - self.ring;
        let f = out * out + x[2] * x[2] - self.distance * self.distance;
        let g = out * radial_rate + x[2] * velocity[2];
        RingSample { t, x, velocity, radius, radial_rate, f, g }
    }

    /// An estimate of the duration of a hop off the ring, from the contact to the return, for a
    /// constant f″. It only sets the length of the first span.
    #[inline(always)]
    fn hop(&self, here: &RingSample) -> Option<f64> {
        let RingSample { x, velocity, radius, radial_rate, f, g, .. } = here;
        let touches = f.abs() <= TOUCH * (self.distance * self.distance);
        if !touches || *g <= 0.0 || *radius == 0.0 {
            return None;
        }
        let h = &self.motion.h;
        let across = velocity[0] * velocity[0] + velocity[1] * velocity[1];
        let pull = 2.0 * (x[0] * h[0] + x[1] * h[1]);
        // ½f″, with ρρ″ = ẋ² + ẏ² − ρ′² + (x, y)·(ẍ, ÿ).
        let bend = across + velocity[2] * velocity[2] + pull + 2.0 * (x[2] * h[2])
            - self.ring / radius * (across - radial_rate * radial_rate + pull);
        (bend < 0.0).then(|| -2.0 * g / bend)
    }

    /// The value of f′/2 below which its sign may be a rounding error.
    #[inline(always)]
    fn graze(&self, here: &RingSample) -> f64 {
        let [x, y, z] = here.velocity.map(f64::abs);
        GRAZE * (self.ring + self.distance) * (x + y + z)
    }
}

/// A squared gap below this fraction of R² counts as zero: it is the rounding error of its terms.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// A squared gap below this fraction of R² counts as a touch. Only the speed of the search depends
/// on it.
const TOUCH: f64 = 1e-9;

/// Length of the first span as a multiple of the estimated hop: long enough to contain the end of
/// the hop, and short enough for definite signs of the derivatives.
const HOP_SPAN: f64 = 1.25;

/// A ball that leaves the slate is on top of the lip's torus. Its normal velocity there is zero,
/// with the rounding error of a position. An approach no faster than this is not a contact if f is
/// convex: f then falls by at most f′ times the duration, which is a rounding error of the path.
/// As a fraction of (a + R)(|ẋ| + |ẏ| + |ż|).
const GRAZE: f64 = 32.0 * f64::EPSILON;

/// The result on one span.
enum SpanResult {
    /// The first contact.
    At(f64),
    /// No contact, with proof.
    Clear,
    /// No proof.
    Open,
}

/// Spans are not halved below this fraction of the window. Except near its start, so short a span
/// is less than the rounding error of a time in the window.
const FINEST: f64 = 1.0 / (1u64 << 60) as f64;

/// The first contact in [start, end].
fn search_window(tube: &Tube<'_>, start: f64, end: f64) -> Option<f64> {
    let mut here = tube.sample(start);
    // With a NaN no proof would ever succeed.
    let [x, y, z] = tube.motion.at(end);
    if here.f.is_nan() | x.is_nan() | y.is_nan() | z.is_nan() {
        return None;
    }
    let finest = (end - start) * FINEST;
    let mut width = tube.hop(&here).map_or(end - start, |hop| HOP_SPAN * hop);
    loop {
        if here.f <= 0.0 && here.g < -tube.graze(&here) {
            return Some(here.t);
        }
        let to = if width < end - here.t { here.t + width } else { end };
        let half = 0.5 * (to - here.t);
        let there = tube.sample(to);
        match search_span(tube, &here, &there) {
            SpanResult::At(t) => return Some(t),
            SpanResult::Open if half > finest && here.t + half > here.t && here.t + half < to => {
                width = half;
                continue;
            }
            // Within a rounding error of time nothing can be proved; the signs at the end of the
            // span decide.
            SpanResult::Clear | SpanResult::Open => {}
        }
        if to >= end {
            return (there.f <= 0.0 && there.g < 0.0).then_some(end);
        }
        here = there;
        width *= 2.0;
    }
}

/// The first contact between two samples, if one proof suffices.
#[inline(always)]
fn search_span(tube: &Tube<'_>, here: &RingSample, there: &RingSample) -> SpanResult {
    let span = Span::new(tube, here, there);
    let apart = here.f > 0.0;
    if apart && there.f > 0.0 && span.is_clear() {
        return SpanResult::Clear;
    }
    match span.shape() {
        // Still rising at the end, f has not fallen. If it is ≤ 0 there, it is so by rounding.
        GapShape::Concave if apart && there.g >= 0.0 => SpanResult::Clear,
        GapShape::Falling | GapShape::Concave if apart => {
            if there.f > 0.0 {
                SpanResult::Clear
            } else {
                SpanResult::At(only_descent(tube, here, there))
            }
        }
        GapShape::Convex if apart => on_convex(tube, here, there.t),
        GapShape::Convex | GapShape::Rising => SpanResult::Clear,
        GapShape::Concave => on_concave_from_touch(tube, here, there),
        GapShape::Falling => SpanResult::At(here.t),
        GapShape::Unknown => SpanResult::Open,
    }
}

/// The most Newton steps of a monotone or bracketed search; see [`crate::robust`].
const MAX_STEPS: usize = 256;

/// Newton's method from the left, where no tangent passes the first root.
fn on_convex(tube: &Tube<'_>, from: &RingSample, end: f64) -> SpanResult {
    let mut here = *from;
    for _ in 0..MAX_STEPS {
        if here.g >= 0.0 {
            return SpanResult::Clear;
        }
        if here.f <= 0.0 {
            break;
        }
        let t = here.t - 0.5 * here.f / here.g;
        if t > end || t.is_nan() {
            return SpanResult::Clear;
        }
        if t <= here.t {
            break;
        }
        here = tube.sample(t);
    }
    SpanResult::At(here.t)
}

/// Touching and rising on a concave span: contact is where f stops rising, unless f is positive
/// there.
fn on_concave_from_touch(tube: &Tube<'_>, here: &RingSample, there: &RingSample) -> SpanResult {
    // f neither rises nor is convex: the bodies are pressed together.
    if here.g <= 0.0 {
        return SpanResult::At(here.t);
    }
    if there.g >= 0.0 {
        return SpanResult::Clear;
    }
    // The point where f′ would be 0 if it changed linearly. If f is positive there, it has been
    // since it rose above 0.
    let mut top = tube.sample(here.t + (there.t - here.t) * (here.g / (here.g - there.g)));
    if top.f <= 0.0 {
        top = turning_point(tube, here, there);
        if top.f <= 0.0 {
            return SpanResult::At(top.t);
        }
    }
    if there.f > 0.0 { SpanResult::Clear } else { SpanResult::At(only_descent(tube, &top, there)) }
}

/// The only time between `open` (f > 0) and `closed` (f ≤ 0) at which f falls to zero: Newton's
/// method from the root of the parabola through both, bracketed by the signs.
fn only_descent(tube: &Tube<'_>, open: &RingSample, closed: &RingSample) -> f64 {
    let (mut low, mut high) = (open.t, closed.t);
    let mut last_step = high - low;
    let bend = (closed.f - open.f - 2.0 * (open.g * last_step)) / (last_step * last_step);
    let mut here = match first_crossing(open.f, 2.0 * open.g, bend, last_step) {
        Some(step) => tube.sample(low + step),
        None => *closed,
    };
    let rounding = ROUNDING * (tube.distance * tube.distance);
    for _ in 0..MAX_STEPS {
        // f is as close to 0 as rounding allows; more steps would follow rounding errors.
        if here.f.abs() <= rounding {
            break;
        }
        if here.f > 0.0 {
            low = here.t
        } else {
            high = here.t
        }
        let mut t = here.t - 0.5 * here.f / here.g;
        if t == here.t {
            break;
        }
        // A step longer than half the last one may not converge.
        if !(t > low && t < high && (t - here.t).abs() <= 0.5 * last_step) {
            t = 0.5 * (low + high);
            if t <= low || t >= high {
                here = tube.sample(high);
                break;
            }
        }
        last_step = (t - here.t).abs();
        here = tube.sample(t);
    }
    // Rounding may make a gap ≤ 0 that is still opening. Bodies that separate have not met.
    if here.g > 0.0 { turning_point(tube, &here, closed).t } else { here.t }
}

/// The point where f stops rising, between a rising and a falling point with one turn between them.
fn turning_point(tube: &Tube<'_>, rising: &RingSample, falling: &RingSample) -> RingSample {
    let (mut low, mut high) = (rising.t, *falling);
    loop {
        let middle = 0.5 * (low + high.t);
        if middle <= low || middle >= high.t {
            return high;
        }
        let sample = tube.sample(middle);
        if sample.g > 0.0 { low = middle } else { high = sample }
    }
}
