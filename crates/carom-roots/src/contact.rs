//! The first contact of two bodies whose relative path is quadratic in time.

use crate::fast::{self, Proof};
use crate::motion::Motion;
use crate::robust;

/// First t in [0, `horizon`] (s) at which the centres are within `distance` (m) and approaching,
/// or `None`.
///
/// With f(t) = |d + vt + ht²|² − `distance`² this is the first t with f ≤ 0 and f′ < 0. Bodies that
/// touch, or overlap by a rounding, and separate do not fire; if friction turns them back before
/// they are apart they fire at the turning point, where a quartic may have no real root at all.
/// `horizon` may be infinite. A motion that holds a NaN never touches.
#[inline]
pub fn first_contact<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
) -> Option<f64> {
    match fast::first_contact(motion, distance, horizon) {
        Proof::Contact(t) => {
            debug_assert!(robust::agrees(motion, distance, horizon, Some(t)), "{motion:?}");
            Some(t)
        }
        Proof::NoContact => {
            debug_assert!(robust::agrees(motion, distance, horizon, None), "{motion:?}");
            None
        }
        Proof::Open => robust::first_contact(motion, distance, horizon),
    }
}
