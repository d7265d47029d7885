//! I. Han, "Dynamics in Carom and Three Cushion Billiards", J. Mech. Sci. Technol. 19 (2005) 976.
//!
//! One rigid impulse at the nose: restitution along the contact's normal, and Coulomb friction
//! that stops the slip if it can. Two errata of the print are corrected: the impulse that stops
//! the slip is compared with μ times the normal impulse (the paper leaves μ out), and sine and
//! cosine in its eq. 21 stand where the geometry has them.

use super::{Change, Impact};
use crate::math::{Vec3, sqrt};

/// What one impact changes (Han 2005, eqs. 14–21), with restitution `e` along the contact's normal
/// and friction `mu` at the nose.
pub(super) fn resolve(impact: &Impact, e: f64, mu: f64) -> Change {
    let slip = impact.slip();
    let speed = sqrt(slip.length_squared());
    let normal = (1.0 + e) * impact.approach;
    if speed == 0.0 {
        return impact.change(normal, Vec3::ZERO);
    }
    // A sphere's slip per unit impulse is 7/2m: ⅖mR² adds 5/2m to the centre's 1/m.
    let share = (mu * normal / speed).min(2.0 / 7.0);
    impact.change(normal, slip * -share)
}
