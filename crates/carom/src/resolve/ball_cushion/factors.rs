//! Constant factors: what FastFiz, the engine of the Computational Olympiad, does at a rail.
//!
//! The speed against the rail comes back with restitution e, a share of the speed along the rail is
//! kept, and a share of the spin (FastFiz 0.2, `RAIL_VEL_DAMPING_X`, `RAIL_VEL_DAMPING_Y`,
//! `RAIL_SPIN_DAMPING`). Spin and path do not act on each other at the nose: english does nothing
//! there. With shares of at most 1 energy never rises.

use super::{Change, Impact};

/// What one impact changes, with restitution `e` along the normal, the share `tangential` of the
/// velocity across it and the share `spin` of the spin.
pub(super) fn resolve(impact: &Impact, e: f64, tangential: f64, spin: f64) -> Change {
    let across = impact.velocity - impact.normal * impact.approach;
    Change {
        velocity: across * (tangential - 1.0) - impact.normal * ((1.0 + e) * impact.approach),
        spin: impact.spin * (spin - 1.0),
    }
}
