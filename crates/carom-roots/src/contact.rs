//! The first contact of two bodies with a relative path that is quadratic in time.

use crate::fast::{self, Proof};
use crate::motion::Motion;
use crate::robust;

/// First t in [0, `horizon`] (s) at which the centres are within `distance` (m) and approaching,
/// or `None`.
///
/// With f(t) = |d + vt + ht²|² − `distance`² this is the first t with f ≤ 0 and f′ < 0. Bodies that
/// touch, or overlap by a rounding error, and separate are not in contact. If friction turns them
/// back before they are apart, the contact is at the turning point, where the quartic may have no
/// real root. `horizon` may be infinite. A motion that contains a NaN has no contact.
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
