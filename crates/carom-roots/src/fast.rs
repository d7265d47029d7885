//! The fast finder of a first contact: a closed form, or a few iterations and a certificate.
//!
//! Cases without a proof here are left to [`crate::robust`].

use crate::motion::{Gap, Motion, cross_squared, dot};
use crate::root::sqrt;

/// The result of the fast finder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Proof {
    /// This is the first contact.
    Contact(f64),
    /// There is no contact within the horizon.
    NoContact,
    /// Nothing was proved.
    Open,
}

/// v and h count as parallel if the sine of their angle is at most this: two rounding errors in
/// each product of h = −c v/|v|. The error of treating the path as straight is then below 1e-15 of
/// the displacement h t².
const PARALLEL: f64 = 4.0 * f64::EPSILON;

/// A Halley step is the last one if |f f″| at its start is below this fraction of f′²/2. Its error
/// is of third order and leaves a gap of at most LAST_STEP³/16 contact distances: 5e-16 of a ball's
/// diameter.
const LAST_STEP: f64 = 2e-5;

/// The most Halley steps. A start close to the root needs fewer.
const MAX_STEPS: usize = 5;

/// Number of Newton steps to a turning point, from a distance of 1e-8 of the motion's time scale.
const TURN_STEPS: usize = 2;

/// First t in [0, `horizon`] with f ≤ 0 and f′ < 0, if it can be proved at little cost.
#[inline(always)]
pub(crate) fn first_contact<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
) -> Proof {
    let Motion { d, v, h } = motion;
    let c0 = dot(d, d) - distance * distance;
    let g0 = dot(d, v);
    let vv = dot(v, v);
    let vh = dot(v, h);
    let hh = dot(h, h);
    let g = [g0, vv + 2.0 * dot(d, h), 3.0 * vh, 2.0 * hh];
    if g0 >= 0.0 && g[1] < 0.0 {
        return on_return(motion, distance, horizon, c0, g);
    }
    // Touching, or separating without end: signs decide such cases, and the robust finder uses
    // signs.
    if !(c0 > 0.0 && g0 < 0.0) {
        return Proof::Open;
    }
    if cross_squared(v, h) <= (PARALLEL * PARALLEL) * (vv * hh) {
        return on_straight_path(motion, distance, horizon, [g0, vv, vh]);
    }
    on_curved_path(motion, distance, horizon, c0, g)
}

/// v ∥ h: whether there is a contact follows from the distance of the line from the centre, and its
/// time from a quadratic.
///
/// With x = d + τ v, |x| = D at τ = (−d·v − √(v²D² − |d × v|²))/v², and τ = t + κt² with κ =
/// v·h/v².
#[inline(always)]
fn on_straight_path<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    [dv, vv, vh]: [f64; 3],
) -> Proof {
    let discriminant = vv * (distance * distance) - cross_squared(&motion.d, &motion.v);
    // The line passes outside the contact circle or grazes it.
    if discriminant <= 0.0 {
        return Proof::NoContact;
    }
    let tau = ((-dv - sqrt(discriminant)) / vv).max(0.0);
    let arrival = 1.0 + 4.0 * (vh / vv) * tau;
    // The bodies stop and return before they touch.
    if arrival <= 0.0 {
        return Proof::NoContact;
    }
    let t = 2.0 * tau / (1.0 + sqrt(arrival));
    if t <= horizon { Proof::Contact(t) } else { Proof::NoContact }
}

/// Bodies that approach each other on a curved path.
#[inline(always)]
fn on_curved_path<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    c0: f64,
    g: [f64; 4],
) -> Proof {
    let gap = Gap::new(motion, distance);
    let start = straight_start(motion, distance, c0, g[0]);
    match start.and_then(|start| converged(&gap, distance, start)) {
        Some(t) if falls_to(t, g) => answer(&gap, t, horizon),
        _ => Proof::Open,
    }
}

/// Bodies that separate and are pulled back, usually just after a contact.
///
/// If f is concave up to its root t, it rises and then falls, and stays above its chord from 0 to
/// t. So t is the first contact if f is positive anywhere before t.
#[inline(always)]
fn on_return<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    c0: f64,
    g: [f64; 4],
) -> Proof {
    let gap = Gap::new(motion, distance);
    let discriminant = g[0] * g[0] - g[1] * c0;
    if discriminant <= 0.0 {
        return at_turn(&gap, horizon, g);
    }
    let start = (g[0] + sqrt(discriminant)) / -g[1];
    // Far beyond the horizon the axis test of the robust finder proves a miss without iterations.
    if start > 2.0 * horizon {
        return Proof::Open;
    }
    match converged(&gap, distance, start) {
        Some(t)
            if is_concave_to(t, g)
                && rate(t, g) < 0.0
                && (c0 > 0.0 || gap.sample(0.5 * t).f > 0.0) =>
        {
            answer(&gap, t, horizon)
        }
        _ => Proof::Open,
    }
}

/// Bodies that overlap by a rounding error and turn back before they separate. Contact is where f
/// stops rising, if f is concave up to that point and not positive there.
#[inline(always)]
fn at_turn<const N: usize>(gap: &Gap<'_, N>, horizon: f64, g: [f64; 4]) -> Proof {
    let mut t = g[0] / -g[1];
    for _ in 0..TURN_STEPS {
        t -= rate(t, g) / (g[1] + t * (2.0 * g[2] + t * (3.0 * g[3])));
    }
    let settled = rate(t, g).abs() <= f64::EPSILON * g[0];
    if settled && t <= horizon && is_concave_to(t, g) && gap.sample(t).f <= 0.0 {
        return Proof::Contact(t);
    }
    Proof::Open
}

/// Halley's method on the actual positions; `None` if it does not converge within a few steps.
#[inline(always)]
fn converged<const N: usize>(gap: &Gap<'_, N>, distance: f64, start: f64) -> Option<f64> {
    // At least 2|x·h| near the contact. The value of x·h itself may cancel |ẋ|² in f″ although f‴
    // is not 0.
    let pull_limit = 2.0 * distance * gap.motion.h.iter().map(|h| h.abs()).sum::<f64>();
    let mut t = start;
    for _ in 0..MAX_STEPS {
        let (here, speed_squared, pull) = gap.sample_with_curvature(t);
        let gg = here.g * here.g;
        t -= 2.0 * (here.f * here.g) / (4.0 * gg - here.f * (speed_squared + pull));
        if here.f.abs() * (speed_squared + pull_limit) <= LAST_STEP * gg {
            return Some(t);
        }
    }
    None
}

/// A time near the contact: the contact on a straight path with the mean velocity until then.
///
/// The mean velocity until the time s is v + hs. For s a head-on approach is accurate enough, (|d|
/// − D)|d|/−d·v, with |d|/(|d| + D) replaced by |d|²/(|d|² + D²): equal at contact and far away,
/// and without a square root.
#[inline(always)]
fn straight_start<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    c0: f64,
    g0: f64,
) -> Option<f64> {
    let Motion { d, v, h } = motion;
    let (dd, squared) = (dot(d, d), distance * distance);
    let s = c0 * dd / (-g0 * (dd + squared));
    let mean: [f64; N] = core::array::from_fn(|i| v[i] + s * h[i]);
    let discriminant = dot(&mean, &mean) * squared - cross_squared(d, &mean);
    // A straight path that misses usually means a miss, which the robust finder proves faster.
    (discriminant > 0.0).then(|| c0 / (sqrt(discriminant) - dot(d, &mean)))
}

/// f′(t)/2 = g₀ + g₁t + g₂t² + g₃t³.
#[inline(always)]
fn rate(t: f64, g: [f64; 4]) -> f64 {
    g[0] + t * (g[1] + t * (g[2] + t * g[3]))
}

/// Whether f provably falls on [0, t]: the Bernstein coefficients of f′ are negative there. Then it
/// has at most one root there.
#[inline(always)]
fn falls_to(t: f64, g: [f64; 4]) -> bool {
    let first = g[0] + t * g[1] / 3.0;
    let second = g[0] + t * (2.0 * g[1] + t * g[2]) / 3.0;
    let last = rate(t, g);
    t >= 0.0 && g[0] < 0.0 && first < 0.0 && second < 0.0 && last < 0.0
}

/// Whether f is provably concave on [0, t], by the Bernstein coefficients of f″.
#[inline(always)]
fn is_concave_to(t: f64, g: [f64; 4]) -> bool {
    let middle = g[1] + t * g[2];
    let last = g[1] + t * (2.0 * g[2] + t * (3.0 * g[3]));
    t >= 0.0 && g[1] < 0.0 && middle < 0.0 && last < 0.0
}

/// The result for a contact at t that is the only one in [0, t].
#[inline(always)]
fn answer<const N: usize>(gap: &Gap<'_, N>, t: f64, horizon: f64) -> Proof {
    if t <= horizon {
        return Proof::Contact(t);
    }
    // Whether the root is after the horizon follows from the gap at the horizon, not from t, which
    // is only as accurate as the last step.
    if gap.sample(horizon).f > 0.0 { Proof::NoContact } else { Proof::Open }
}
