//! First contact of a ball on a quadratic path with a round edge: a circle in space.
//!
//! The path is x(t) = d + vt + ht², the edge the circle of radius a about the origin in the plane
//! z = 0. With ρ = |(x, y)| its nearest point is √((ρ − a)² + z²) away, and the squared gap is
//!
//! f(t) = (ρ − a)² + z² − R² = |x|² + a² − R² − 2aρ.
//!
//! Freed of its root it is a polynomial of degree eight, (|x|² + a² − R²)² − 4a²ρ², but one that is
//! also positive where a < R and the ball's centre is deep inside the edge, within R of its far side
//! too. So f is kept as it stands, a quartic less a multiple of ρ, and ρ is a convex function of x:
//! that gives bounds of f, f′ and f″ on a span of time from a few scalar products (`ring::span`).
//!
//! The window of time in which the path is in the box about the torus |ρ − a|² + z² ≤ R² is walked
//! from left to right, in spans of each of which one of these is proved:
//!
//! * **clear**: f > 0;
//! * **falling** or **concave**, f > 0 at the left: one root if f ≤ 0 at the right, else none;
//! * **convex**: Newton from the left is monotone and finds the first root, or that there is none;
//! * touching and not falling at the left: **rising** or **convex** spans keep rising, a **concave** one
//!   fires at its turning point, if f ≤ 0 there.
//!
//! A span without a proof is halved, and a span that was passed is followed by one twice as long.

mod span;

use crate::contact::first_contact;
use crate::crossing::first_crossing;
use crate::motion::Motion;
use crate::root::sqrt;
use span::{Shape, Span};

/// First t in [`from`, `horizon`] (s) at which the path is within `distance` R (m) of the circle of
/// radius `ring` a ≥ 0 (m) about the origin in the plane z = 0 and approaching it, or `None`.
///
/// With g(t) = √((ρ − a)² + z²) − R and ρ = |(x, y)| this is the first t with g ≤ 0 and g′ < 0, g′ being
/// taken to the right where the path crosses the axis. A start that touches, or overlaps by a
/// rounding, and parts does not fire. `horizon` may be infinite. A motion that holds a NaN never
/// touches.
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
    walk(&Tube { motion, ring, distance }, start, end)
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

/// Widens the box by more than the roundings of its own computation, so that a path that touches the
/// torus where it touches the box is not lost. Relative.
const BOX_MARGIN: f64 = 1.0 + 16.0 * f64::EPSILON;

/// Whether one coordinate's Bernstein coefficients on [from, horizon] all lie on one side of the box
/// |x|, |y| ≤ `width`, |z| ≤ `height`.
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
    // Without end only for what rests, or moves for longer than any number.
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
    // In the end the coordinate leaves to this side; the larger root of c₂t² + c₁t + c₀ ∓ bound.
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

/// The torus of the points within `distance` of the ring, and a path.
#[derive(Clone, Copy)]
struct Tube<'a> {
    motion: &'a Motion<3>,
    ring: f64,
    distance: f64,
}

/// A point of the path, and of the squared gap f.
#[derive(Clone, Copy)]
struct Sample {
    t: f64,
    x: [f64; 3],
    velocity: [f64; 3],
    /// ρ.
    radius: f64,
    /// ρ′, to the right.
    radial_rate: f64,
    /// f.
    f: f64,
    /// f′/2.
    g: f64,
}

impl Tube<'_> {
    #[inline(always)]
    fn sample(&self, t: f64) -> Sample {
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
        Sample { t, x, velocity, radius, radial_rate, f, g }
    }

    /// How long a hop off the ring takes if f″ stays as it is: from where it touches and parts
    /// until it comes back. A guess at where to look first.
    #[inline(always)]
    fn hop(&self, here: &Sample) -> Option<f64> {
        let Sample { x, velocity, radius, radial_rate, f, g, .. } = here;
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

    /// An f′/2 whose sign is a matter of roundings.
    #[inline(always)]
    fn graze(&self, here: &Sample) -> f64 {
        let [x, y, z] = here.velocity.map(f64::abs);
        GRAZE * (self.ring + self.distance) * (x + y + z)
    }
}

/// A squared gap below this share of R² is as good as zero: it is the rounding of its terms.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// A squared gap below this share of R² is taken for a touch, where only speed depends on it.
const TOUCH: f64 = 1e-9;

/// How much further than a guessed hop is looked at once: far enough that it ends there, not so far that
/// the signs of its derivatives are unsettled.
const HOP_SPAN: f64 = 1.25;

/// A ball that leaves the slate is on top of the lip's torus, and its normal speed there, zero, is known
/// only as well as its position. What closes by no more than this does not fire if f is convex: it
/// then falls by no more than f′ times the time, that is, by roundings of the path. Relative.
const GRAZE: f64 = 32.0 * f64::EPSILON;

/// What a span holds.
enum Outcome {
    /// The first contact.
    At(f64),
    /// No contact: proved.
    Passed,
    /// Nothing was proved.
    Open,
}

/// A span is not halved below this part of the window, which is less than a rounding of any of its times
/// but the first few.
const FINEST: f64 = 1.0 / (1u64 << 60) as f64;

/// The first contact in [start, end].
fn walk(tube: &Tube<'_>, start: f64, end: f64) -> Option<f64> {
    let mut here = tube.sample(start);
    // Not a number, and no proof would ever be found.
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
        match search(tube, &here, &there) {
            Outcome::At(t) => return Some(t),
            Outcome::Open if half > finest && here.t + half > here.t && here.t + half < to => {
                width = half;
                continue;
            }
            // Of less than a rounding of time nothing can be told: the signs at its end decide.
            Outcome::Passed | Outcome::Open => {}
        }
        if to >= end {
            return (there.f <= 0.0 && there.g < 0.0).then_some(end);
        }
        here = there;
        width *= 2.0;
    }
}

/// The first contact between two samples, if one proof is enough.
#[inline(always)]
fn search(tube: &Tube<'_>, here: &Sample, there: &Sample) -> Outcome {
    let span = Span::new(tube, here, there);
    let apart = here.f > 0.0;
    if apart && there.f > 0.0 && span.is_clear() {
        return Outcome::Passed;
    }
    match span.shape() {
        Shape::Falling | Shape::Concave if apart => {
            if there.f > 0.0 {
                Outcome::Passed
            } else {
                Outcome::At(only_descent(tube, here, there))
            }
        }
        Shape::Convex if apart => on_convex(tube, here, there.t),
        Shape::Convex | Shape::Rising => Outcome::Passed,
        Shape::Concave => on_concave_from_touch(tube, here, there),
        Shape::Falling => Outcome::At(here.t),
        Shape::Unknown => Outcome::Open,
    }
}

/// More Newton steps than a monotone or bracketed search can take; see [`crate::robust`].
const MAX_STEPS: usize = 256;

/// Newton from the left, where no tangent passes the first root.
fn on_convex(tube: &Tube<'_>, from: &Sample, end: f64) -> Outcome {
    let mut here = *from;
    for _ in 0..MAX_STEPS {
        if here.g >= 0.0 {
            return Outcome::Passed;
        }
        if here.f <= 0.0 {
            break;
        }
        let t = here.t - 0.5 * here.f / here.g;
        if t > end || t.is_nan() {
            return Outcome::Passed;
        }
        if t <= here.t {
            break;
        }
        here = tube.sample(t);
    }
    Outcome::At(here.t)
}

/// Touching and rising on a concave span: contact is where f stops rising, if it is not open there.
fn on_concave_from_touch(tube: &Tube<'_>, here: &Sample, there: &Sample) -> Outcome {
    // It neither rises nor is convex: it is being pressed on.
    if here.g <= 0.0 {
        return Outcome::At(here.t);
    }
    if there.g >= 0.0 {
        return Outcome::Passed;
    }
    // Where f′ would vanish if it changed evenly; if f is open there it has been since it opened.
    let mut top = tube.sample(here.t + (there.t - here.t) * (here.g / (here.g - there.g)));
    if top.f <= 0.0 {
        top = turning_point(tube, here, there);
        if top.f <= 0.0 {
            return Outcome::At(top.t);
        }
    }
    if there.f > 0.0 { Outcome::Passed } else { Outcome::At(only_descent(tube, &top, there)) }
}

/// The only time between `open` (f > 0) and `closed` (f ≤ 0) at which f falls to zero: Newton from the
/// root of the parabola through both, kept between the signs.
fn only_descent(tube: &Tube<'_>, open: &Sample, closed: &Sample) -> f64 {
    let (mut low, mut high) = (open.t, closed.t);
    let mut last_step = high - low;
    let bend = (closed.f - open.f - 2.0 * (open.g * last_step)) / (last_step * last_step);
    let mut here = match first_crossing(open.f, 2.0 * open.g, bend, last_step) {
        Some(step) => tube.sample(low + step),
        None => *closed,
    };
    let rounding = ROUNDING * (tube.distance * tube.distance);
    for _ in 0..MAX_STEPS {
        // Newton has got as near as f can tell; more steps would follow roundings.
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
        // A step that does not halve the last may not be going anywhere.
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
    // Roundings may close a gap that is still opening: what parts has not met.
    if here.g > 0.0 { turning_point(tube, &here, closed).t } else { here.t }
}

/// Where f stops rising, between a rising and a falling point with one turn between them.
fn turning_point(tube: &Tube<'_>, rising: &Sample, falling: &Sample) -> Sample {
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
