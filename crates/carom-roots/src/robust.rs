//! First contact of any motion, every step a proof: convexity split and monotone Newton.
//!
//! f(t) = |d + vt + ht²|² − D² is a quartic whose leading coefficient |h|² is not negative, and
//! f″/2 = c₂ + 3c₃t + 6c₄t² has at most two roots: f is convex, then perhaps concave, then convex
//! again. On each such span Newton's method is monotone from the proper end, so it neither skips a
//! root nor needs a bracket:
//!
//! * convex, f > 0 and falling: from the left the tangent lies below f, so no step passes the first
//!   root. A step past the span's end, or a rising f, proves that there is none.
//! * concave, f > 0 at the left: if f > 0 at the right too, there is no root between. Otherwise there
//!   is exactly one, and from the right the tangent lies above f, so no step passes it.
//! * f ≤ 0 and rising at the left, that is, touching and separating: a convex span keeps rising; a
//!   concave one may turn, and fires at the turning point if f ≤ 0 there.

use crate::crossing::first_crossing;
use crate::motion::{Gap, Motion, Sample, dot};
use crate::root::sqrt;

/// More steps than Newton can take. On a quartic each monotone step removes at least a quarter of
/// the way to the root, so 53 bits over twelve decades of time take less than 230.
const MAX_STEPS: usize = 256;

/// First t in [0, `horizon`] with f ≤ 0 and f′ < 0.
pub(crate) fn first_contact<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
) -> Option<f64> {
    let gap = Gap::new(motion, distance);
    let mut from = gap.sample(0.0);
    if from.f > 0.0 {
        from = gap.sample(earliest_along_axis(motion, distance, horizon)?);
    }
    let (bend, unbend) = concave_span(motion).unwrap_or((f64::INFINITY, f64::INFINITY));
    if from.t < bend {
        match on_convex(&gap, from, bend.min(horizon)) {
            Outcome::At(t) => return Some(t),
            Outcome::Passed if bend < horizon => from = gap.sample(bend),
            Outcome::Passed => return None,
        }
    }
    if from.t < unbend {
        let to = gap.sample(unbend.min(horizon));
        match on_concave(&gap, from, to) {
            Outcome::At(t) => return Some(t),
            Outcome::Passed if unbend < horizon => from = to,
            Outcome::Passed => return None,
        }
    }
    match on_convex(&gap, from, horizon) {
        Outcome::At(t) => Some(t),
        Outcome::Passed => None,
    }
}

/// Whether this finder says the same as `answer`, but for roundings: that is, whether wherever only
/// one of the two sees a contact the bodies come within roundings of grazing.
///
/// Every answer of the fast finder is compared so in builds with debug assertions.
pub(crate) fn agrees<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    answer: Option<f64>,
) -> bool {
    /// Of the greatest length in the motion; a hundred roundings.
    const ROUNDINGS: f64 = 2e-14;
    let ours = first_contact(motion, distance, horizon);
    let gap = Gap::new(motion, distance);
    let length = |a: &[f64; N]| sqrt(dot(a, a));
    let depth_at = |t: f64| {
        let extent = length(&motion.d) + t * (length(&motion.v) + t * length(&motion.h));
        (gap.sample(t).f / (2.0 * distance), ROUNDINGS * extent)
    };
    match (ours, answer) {
        (None, None) => true,
        (Some(ours), Some(answer)) => {
            // In contact, perhaps overlapping from the start, and no deeper between the two.
            let (here, tolerance) = depth_at(ours);
            let level = |t: f64| (depth_at(t).0 - here).abs() <= tolerance;
            here <= tolerance && level(answer) && level(0.5 * (ours + answer))
        }
        (Some(t), None) | (None, Some(t)) => {
            // At the horizon, or at the closest approach, where a graze may be either.
            let (gap_there, tolerance) = depth_at(t);
            let here = gap.sample(t);
            let left = (horizon - t).abs() * here.g.abs() / distance;
            let closest = here.g * here.g / (2.0 * distance * distance);
            let curvature = dot(&motion.velocity_at(t), &motion.velocity_at(t)) / distance
                + 2.0 * length(&motion.h);
            gap_there <= tolerance && (left <= tolerance || closest <= tolerance * curvature)
        }
    }
}

/// What one span of constant curvature holds.
enum Outcome {
    /// The first contact.
    At(f64),
    /// No contact: proved.
    Passed,
}

/// A time before which bodies that are apart cannot touch, or `None` if they cannot at all.
///
/// Along the axis n = d/|d| the separation n·x is at most |x|, and it is only quadratic in time.
fn earliest_along_axis<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
) -> Option<f64> {
    let length = sqrt(dot(&motion.d, &motion.d));
    let speed = dot(&motion.d, &motion.v) / length;
    let half_acceleration = dot(&motion.d, &motion.h) / length;
    first_crossing(length - distance, speed, half_acceleration, horizon)
}

/// The span of time, perhaps partly before 0, in which f is concave; `None` if it is convex throughout.
fn concave_span<const N: usize>(motion: &Motion<N>) -> Option<(f64, f64)> {
    let c4 = dot(&motion.h, &motion.h);
    let c2 = dot(&motion.v, &motion.v) + 2.0 * dot(&motion.d, &motion.h);
    let three_c3 = 6.0 * dot(&motion.v, &motion.h);
    let discriminant = three_c3 * three_c3 - 24.0 * (c4 * c2);
    // Accelerations whose square underflows bend nothing in any time that can be written down.
    if discriminant <= 0.0 || c4 < f64::MIN_POSITIVE {
        return None;
    }
    // The root of larger magnitude first; the other from the product of both.
    let q = if three_c3 > 0.0 {
        -0.5 * (three_c3 + sqrt(discriminant))
    } else {
        -0.5 * (three_c3 - sqrt(discriminant))
    };
    let (s, t) = (q / (6.0 * c4), c2 / q);
    Some(if s < t { (s, t) } else { (t, s) })
}

fn on_convex<const N: usize>(gap: &Gap<'_, N>, from: Sample, end: f64) -> Outcome {
    let mut here = from;
    for _ in 0..MAX_STEPS {
        // A gap that rises never falls again on a convex span, whether it is open or closed.
        if here.g >= 0.0 {
            return Outcome::Passed;
        }
        if here.f <= 0.0 {
            return Outcome::At(here.t);
        }
        let t = here.t - 0.5 * here.f / here.g;
        if t > end || t.is_nan() {
            return Outcome::Passed;
        }
        if t <= here.t {
            break;
        }
        here = gap.sample(t);
    }
    Outcome::At(here.t)
}

fn on_concave<const N: usize>(gap: &Gap<'_, N>, from: Sample, to: Sample) -> Outcome {
    let mut earliest = from.t;
    if from.f <= 0.0 {
        if from.g <= 0.0 {
            return Outcome::At(from.t);
        }
        if to.g >= 0.0 {
            return Outcome::Passed;
        }
        let turn = turning_point(gap, from, to);
        if turn.f <= 0.0 {
            return Outcome::At(turn.t);
        }
        // Bodies that part by less than a rounding come no nearer before they turn.
        earliest = turn.t;
    }
    if to.f > 0.0 {
        return Outcome::Passed;
    }
    let mut here = to;
    for _ in 0..MAX_STEPS {
        let t = here.t - 0.5 * here.f / here.g;
        if t <= earliest {
            return Outcome::At(earliest);
        }
        if t >= here.t {
            break;
        }
        here = gap.sample(t);
        if here.f >= 0.0 {
            break;
        }
    }
    Outcome::At(here.t)
}

/// Where f stops rising and begins to fall, between a rising and a falling point of a concave span.
fn turning_point<const N: usize>(gap: &Gap<'_, N>, rising: Sample, falling: Sample) -> Sample {
    let (mut low, mut high) = (rising, falling);
    // Bisection: nothing here is hot, and every bit of it is certain.
    loop {
        let middle = 0.5 * (low.t + high.t);
        if middle <= low.t || middle >= high.t {
            return high;
        }
        let sample = gap.sample(middle);
        if sample.g > 0.0 { low = sample } else { high = sample }
    }
}
