//! Constant factors: the rail of FastFiz, the engine of the Computational Olympiad.
//!
//! The speed into the rail is reversed with restitution e, and the speed along the rail and the
//! spin are multiplied by constant factors (FastFiz 0.2, `RAIL_VEL_DAMPING_X`,
//! `RAIL_VEL_DAMPING_Y`, `RAIL_SPIN_DAMPING`). Spin does not change the velocity, so English has no
//! effect. With factors of at most 1 the energy never rises.

use super::{Change, NoseContact};

/// The change by one impact, with restitution `e` along the normal and the factors `tangential` of
/// the velocity across it and `spin` of the spin.
pub(super) fn resolve(impact: &NoseContact, e: f64, tangential: f64, spin: f64) -> Change {
    let across = impact.velocity - impact.normal * impact.approach;
    Change {
        velocity: across * (tangential - 1.0) - impact.normal * ((1.0 + e) * impact.approach),
        spin: impact.spin * (spin - 1.0),
    }
}
