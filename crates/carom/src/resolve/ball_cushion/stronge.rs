//! Stronge's impact with tangential compliance ([`stronge`]) at a cushion:
//! part of the slip at the nose is given back, against friction and the nose's own give.

use super::{Change, Impact};
use crate::math::sqrt;
use crate::resolve::stronge;

/// What one impact changes, with restitution `e` along the contact's normal, friction `mu`, and
/// `ratio` the tangential frequency over the normal one.
pub(super) fn resolve(impact: &Impact, e: f64, mu: f64, ratio: f64) -> Change {
    let slip = impact.nose_slip();
    let speed = sqrt(slip.length_squared());
    let approach = impact.velocity.x * impact.cos;
    let normal = (1.0 + e) * approach;
    let share = if speed > 0.0 {
        let contact = stronge::Impact {
            approach,
            slip: speed,
            restitution: e,
            friction: mu,
            frequency_ratio: ratio,
        };
        (contact.final_slip() - speed) / (stronge::BETA * speed)
    } else {
        0.0
    };
    impact.change(impact.impulse(normal, slip * share))
}
