//! I. Han, "Dynamics in Carom and Three Cushion Billiards", J. Mech. Sci. Technol. 19 (2005) 976.
//!
//! One rigid impulse at the nose: restitution along the contact's normal, and Coulomb friction that
//! at most stops the slip. Two errata of the paper are corrected: the impulse that stops the slip
//! is compared with μ times the normal impulse (the paper omits μ), and sine and cosine are
//! exchanged in its eq. 21.

use super::{Change, NoseContact};
use crate::math::{Vec3, sqrt};

/// The change by one impact (Han 2005, eqs. 14–21), with restitution `e` along the contact's normal
/// and friction `mu` at the nose.
pub(super) fn resolve(impact: &NoseContact, e: f64, mu: f64) -> Change {
    let slip = impact.slip();
    let speed = sqrt(slip.length_squared());
    let normal = (1.0 + e) * impact.approach;
    if speed == 0.0 {
        return impact.change(normal, Vec3::ZERO);
    }
    // An impulse changes a sphere's slip by 7/2m: 1/m from the motion of the centre and 5/2m from
    // the spin.
    let share = (mu * normal / speed).min(2.0 / 7.0);
    impact.change(normal, slip * -share)
}
