//! Contact of two balls on the cloth. The quartic of Leckie & Greenspan 2006, eq. 7, is solved by
//! `carom_roots::first_contact`.

use crate::math::sqrt;

/// Distance of the centres in the table plane at which two balls on the cloth touch, m: (R₁+R₂)² −
/// (R₁−R₂)² = 4R₁R₂.
#[inline(always)]
pub fn touching_distance(a: f64, b: f64) -> f64 {
    if a == b { a + b } else { 2.0 * sqrt(a * b) }
}
