//! Contact of two balls on the cloth: the quartic of Leckie & Greenspan 2006, eq. 7.

use carom_roots::Motion;

use crate::math::sqrt;

/// Finds the first contact of two balls on quadratic paths. The event loop has the finder's type as
/// a generic parameter, so that other root finders can be measured in whole shots
/// (validation/leckie_greenspan_2006).
pub trait ContactFinder {
    /// Whether cheap proofs of no contact come before this finder.
    const PROOFS: bool = true;

    /// First time in [0, `horizon`] (s) at which the relative path comes within `distance` (m)
    /// while approaching.
    fn first_contact(path: &Motion<2>, distance: f64, horizon: f64) -> Option<f64>;
}

/// The engine's finder, from the crate `carom-roots`.
#[derive(Clone, Copy, Debug)]
pub struct FirstContact;

impl ContactFinder for FirstContact {
    #[inline(always)]
    fn first_contact(path: &Motion<2>, distance: f64, horizon: f64) -> Option<f64> {
        carom_roots::first_contact(path, distance, horizon)
    }
}

/// Distance of the centres in the table plane at which two balls on the cloth touch, m: (R₁+R₂)² −
/// (R₁−R₂)² = 4R₁R₂.
#[inline(always)]
pub fn touching_distance(a: f64, b: f64) -> f64 {
    if a == b { a + b } else { 2.0 * sqrt(a * b) }
}
