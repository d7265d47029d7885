//! I. Han, J. Mech. Sci. Technol. 19 (2005) 976, eqs. 14–21: one impulse with restitution, and
//! friction that at most stops the slip. Two errata are corrected: μ in the test for sticking, and
//! the exchanged sine and cosine of eq. 21.

use super::{RailImpact, Rebound, size};

pub(super) fn rebound(impact: &RailImpact, e: f64, mu: f64) -> Rebound {
    let slip = impact.slip();
    // His c, P_zE and P_zS, per unit mass: A = 7/2m, B = 1/m.
    let normal = (1.0 + e) * impact.velocity.x * impact.cos;
    let to_stop = size(slip) / 3.5;
    let friction = to_stop.min(mu * normal);
    let share = if to_stop > 0.0 { friction / size(slip) } else { 0.0 };
    impact.after(normal, slip.map(|s| -s * share))
}
