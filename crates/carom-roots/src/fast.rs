//! First contact of bodies that are apart and closing: closed form, or a few steps and a certificate.
//!
//! Whatever is not proved here is left to [`crate::robust`].

use crate::motion::{Gap, Motion, cross_squared, dot};
use crate::root::sqrt;

/// What was proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Proof {
    /// This is the first contact.
    Contact(f64),
    /// There is no contact within the horizon.
    NoContact,
    /// Nothing was proved.
    Open,
}

/// v and h are parallel if the sine of their angle is at most this: two roundings in each product of
/// h = −c v/|v|. Taking the path as straight then moves it by less than 1e-15 of the way h t².
const PARALLEL: f64 = 4.0 * f64::EPSILON;

/// A Halley step from a sample with |f f″| below this much of f′²/2 is the last. Its error, of the
/// third power, leaves a gap of at most LAST_STEP³/16 contact distances: 5e-16 of a ball's diameter.
const LAST_STEP: f64 = 2e-5;

/// More steps than a start that deserves the name needs.
const MAX_STEPS: usize = 5;

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
    // Touching, or not closing at first: signs decide, and the robust finder reasons on signs.
    if !(c0 > 0.0 && g0 < 0.0) {
        return Proof::Open;
    }
    let vv = dot(v, v);
    let vh = dot(v, h);
    let hh = dot(h, h);
    if cross_squared(v, h) <= (PARALLEL * PARALLEL) * (vv * hh) {
        return on_straight_path(motion, distance, horizon, [g0, vv, vh]);
    }
    on_curved_path(motion, distance, horizon, c0, [g0, vv + 2.0 * dot(d, h), 3.0 * vh, 2.0 * hh])
}

/// v ∥ h: the distance of the line from the centre decides whether, and a quadratic when.
///
/// With x = d + τ v, |x| = D at τ = (−d·v − √(v²D² − |d × v|²))/v², and τ = t + κt² with κ = v·h/v².
#[inline(always)]
fn on_straight_path<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    [dv, vv, vh]: [f64; 3],
) -> Proof {
    let discriminant = vv * (distance * distance) - cross_squared(&motion.d, &motion.v);
    // The line passes the contact circle, or only grazes it.
    if discriminant <= 0.0 {
        return Proof::NoContact;
    }
    let tau = ((-dv - sqrt(discriminant)) / vv).max(0.0);
    let arrival = 1.0 + 4.0 * (vh / vv) * tau;
    // The bodies stop, and go back the way they came, before they touch.
    if arrival <= 0.0 {
        return Proof::NoContact;
    }
    let t = 2.0 * tau / (1.0 + sqrt(arrival));
    if t <= horizon { Proof::Contact(t) } else { Proof::NoContact }
}

/// Halley's method on the actual positions, and a certificate that f falls all the way to its end.
#[inline(always)]
fn on_curved_path<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
    c0: f64,
    g: [f64; 4],
) -> Proof {
    let gap = Gap::new(motion, distance);
    // At least 2|x·h| near the contact: x·h alone may cancel |ẋ|² in f″ where f‴ does not vanish.
    let pull_limit = 2.0 * distance * motion.h.iter().map(|h| h.abs()).sum::<f64>();
    let Some(mut t) = straight_start(motion, distance, c0, g[0]) else { return Proof::Open };
    for _ in 0..MAX_STEPS {
        let (here, speed_squared, pull) = gap.sample_with_curvature(t);
        let gg = here.g * here.g;
        t -= 2.0 * (here.f * here.g) / (4.0 * gg - here.f * (speed_squared + pull));
        if here.f.abs() * (speed_squared + pull_limit) <= LAST_STEP * gg {
            return certified(&gap, t, horizon, g);
        }
    }
    Proof::Open
}

/// A time near the contact: that of a straight path at the mean velocity of the way there.
///
/// The mean velocity to the time s is v + hs. For s the head-on approach will do, (|d| − D)|d|/−d·v,
/// with |d|/(|d| + D) read as |d|²/(|d|² + D²): equal at contact and far away, and no square root.
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
    // A straight path that misses most often means a miss, which the robust finder proves sooner.
    (discriminant > 0.0).then(|| c0 / (sqrt(discriminant) - dot(d, &mean)))
}

/// f falls on [0, t] if the Bernstein coefficients of f′ there are negative; so its root is the first.
#[inline(always)]
fn certified<const N: usize>(gap: &Gap<'_, N>, t: f64, horizon: f64, g: [f64; 4]) -> Proof {
    let first = g[0] + t * g[1] / 3.0;
    let second = g[0] + t * (2.0 * g[1] + t * g[2]) / 3.0;
    let last = g[0] + t * (g[1] + t * (g[2] + t * g[3]));
    if !(t >= 0.0 && first < 0.0 && second < 0.0 && last < 0.0) {
        return Proof::Open;
    }
    if t <= horizon {
        return Proof::Contact(t);
    }
    // That the root lies after the horizon is shown by the gap at the horizon, not by t, which is only
    // as good as the last step.
    if gap.sample(horizon).f > 0.0 { Proof::NoContact } else { Proof::Open }
}
