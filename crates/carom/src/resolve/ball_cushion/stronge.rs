//! Stronge's impact with tangential compliance ([`stronge`]) at a cushion: the nose returns part of
//! the slip.

use super::{Change, NoseContact};
use crate::math::{Vec3, sqrt};
use crate::resolve::stronge;

/// The change by one impact, with restitution `e` along the contact's normal, friction `mu`, and
/// `ratio`, the tangential frequency divided by the normal one.
#[inline(always)]
pub(super) fn resolve(impact: &NoseContact, e: f64, mu: f64, ratio: f64) -> Change {
    let slip = impact.slip();
    let speed = sqrt(slip.length_squared());
    let normal = (1.0 + e) * impact.approach;
    if speed == 0.0 {
        return impact.change(normal, Vec3::ZERO);
    }
    let contact = stronge::Impact {
        approach: impact.approach,
        slip: speed,
        restitution: e,
        friction: mu,
        frequency_ratio: ratio,
    };
    let share = (contact.final_slip() - speed) / (stronge::BETA * speed);
    impact.change(normal, slip * share)
}
