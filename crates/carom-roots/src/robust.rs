//! First contact for any motion, with a proof in every step: split by convexity, and monotone
//! Newton.
//!
//! f(t) = |d + vt + ht²|² − D² is a quartic with a leading coefficient |h|² ≥ 0, and f″/2 = c₂ +
//! 3c₃t + 6c₄t² has at most two roots: f is convex, then perhaps concave, then convex again. On
//! each of these spans Newton's method is monotone from the right end. So it cannot skip a root,
//! and it needs no bracket:
//!
//! * convex, f > 0 and falling: from the left the tangent is below f, so no step passes the first
//!   root. A step past the span's end, or a rising f, proves that there is no root.
//! * concave, f > 0 at the left: if f > 0 at the right as well, there is no root between. Otherwise
//!   there is exactly one, and from the right the tangent is above f, so no step passes it.
//! * f ≤ 0 and rising at the left (touching and separating): on a convex span f keeps rising; on a
//!   concave one it may turn, and the turning point is a contact if f ≤ 0 there.

use crate::crossing::first_crossing;
use crate::motion::{Gap, Motion, Sample, dot};
use crate::root::sqrt;

/// The most Newton steps. On a quartic each monotone step covers at least a quarter of the distance
/// to the root, so 53 bits and twelve decades of time need fewer than 230.
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
            SpanResult::At(t) => return Some(t),
            SpanResult::Clear if bend < horizon => from = gap.sample(bend),
            SpanResult::Clear => return None,
        }
    }
    if from.t < unbend {
        let to = gap.sample(unbend.min(horizon));
        match on_concave(&gap, from, to) {
            SpanResult::At(t) => return Some(t),
            SpanResult::Clear if unbend < horizon => from = to,
            SpanResult::Clear => return None,
        }
    }
    match on_convex(&gap, from, horizon) {
        SpanResult::At(t) => Some(t),
        SpanResult::Clear => None,
    }
}

/// Whether the result of this finder agrees with `answer`. If only one of the two is a contact,
/// they agree if the bodies graze within rounding errors.
///
/// Builds with debug assertions compare every answer of the fast finder.
pub(crate) fn agrees<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    answer: Option<f64>,
) -> bool {
    /// Relative to the greatest length in the motion; a hundred rounding errors.
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
            // In contact (an overlap at the start is possible), and no deeper between the two
            // times.
            let (here, tolerance) = depth_at(ours);
            let level = |t: f64| (depth_at(t).0 - here).abs() <= tolerance;
            here <= tolerance && level(answer) && level(0.5 * (ours + answer))
        }
        (Some(t), None) | (None, Some(t)) => {
            // At the horizon, or at the closest approach, where rounding decides about a graze.
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

/// The result on one span, on which f is convex or concave.
enum SpanResult {
    /// The first contact.
    At(f64),
    /// No contact, with proof.
    Clear,
}

/// A time before which bodies that are apart cannot touch, or `None` if they cannot touch at all.
///
/// The separation n·x along the axis n = d/|d| is at most |x|, and is only quadratic in time.
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

/// The span of time in which f is concave; it may begin before 0. `None` if f is convex everywhere.
fn concave_span<const N: usize>(motion: &Motion<N>) -> Option<(f64, f64)> {
    let c4 = dot(&motion.h, &motion.h);
    let c2 = dot(&motion.v, &motion.v) + 2.0 * dot(&motion.d, &motion.h);
    let three_c3 = 6.0 * dot(&motion.v, &motion.h);
    let discriminant = three_c3 * three_c3 - 24.0 * (c4 * c2);
    // An acceleration whose square underflows has no effect within any representable time.
    if discriminant <= 0.0 || c4 < f64::MIN_POSITIVE {
        return None;
    }
    // The root of larger magnitude comes first; the other follows from the product of both.
    let q = if three_c3 > 0.0 {
        -0.5 * (three_c3 + sqrt(discriminant))
    } else {
        -0.5 * (three_c3 - sqrt(discriminant))
    };
    let (s, t) = (q / (6.0 * c4), c2 / q);
    Some(if s < t { (s, t) } else { (t, s) })
}

fn on_convex<const N: usize>(gap: &Gap<'_, N>, from: Sample, end: f64) -> SpanResult {
    let mut here = from;
    for _ in 0..MAX_STEPS {
        // On a convex span a rising gap never falls again, whether it is positive or not.
        if here.g >= 0.0 {
            return SpanResult::Clear;
        }
        if here.f <= 0.0 {
            return SpanResult::At(here.t);
        }
        let t = here.t - 0.5 * here.f / here.g;
        if t > end || t.is_nan() {
            return SpanResult::Clear;
        }
        if t <= here.t {
            break;
        }
        here = gap.sample(t);
    }
    SpanResult::At(here.t)
}

fn on_concave<const N: usize>(gap: &Gap<'_, N>, from: Sample, to: Sample) -> SpanResult {
    let mut earliest = from;
    if from.f <= 0.0 {
        if from.g <= 0.0 {
            return SpanResult::At(from.t);
        }
        if to.g >= 0.0 {
            return SpanResult::Clear;
        }
        let turn = turning_point(gap, from, to);
        if turn.f <= 0.0 {
            return SpanResult::At(turn.t);
        }
        // The bodies separate by less than a rounding error and meet no earlier than at the turning
        // point.
        earliest = turn;
    }
    // Still rising at the end, f has not fallen. If it is ≤ 0 there, it is so by rounding.
    if to.f > 0.0 || to.g >= 0.0 {
        return SpanResult::Clear;
    }
    let mut here = to;
    for _ in 0..MAX_STEPS {
        let t = here.t - 0.5 * here.f / here.g;
        if t <= earliest.t {
            here = earliest;
            break;
        }
        if t >= here.t {
            break;
        }
        here = gap.sample(t);
        if here.f >= 0.0 {
            break;
        }
    }
    // Rounding may make a gap ≤ 0 that is still opening. Bodies that separate have not met.
    SpanResult::At(if here.g > 0.0 { turning_point(gap, here, to).t } else { here.t })
}

/// The point at which f stops rising and begins to fall, between a rising and a falling point of a
/// concave span.
fn turning_point<const N: usize>(gap: &Gap<'_, N>, rising: Sample, falling: Sample) -> Sample {
    let (mut low, mut high) = (rising, falling);
    // Bisection is fast enough for this rare case, and exact to the last bit.
    loop {
        let middle = 0.5 * (low.t + high.t);
        if middle <= low.t || middle >= high.t {
            return high;
        }
        let sample = gap.sample(middle);
        if sample.g > 0.0 { low = sample } else { high = sample }
    }
}
