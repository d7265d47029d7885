//! Named frictions of balls by the state of their surface.
//!
//! Alciatore measured the throw of one pair of balls in several states (*Throw follow-up I*: stun,
//! 45° cut, slow): 3.6° after a ball cleaner, 4.9° as used, 11° after alcohol, 11.6° with chalk at
//! the contact. Two further tests have other balls (Billiards Digest, September 2006, and *Throw
//! follow-up II*, 2014). At 45° and slow speed the fit of 2006 gives 4.8°, like used balls; the fit
//! of 2014 gives 6.9°, between used balls and 1.5 times their friction, Alciatore's factor for dirty
//! balls (TP A.14). So each test has its own surface. The tests reach a slip of 3 m/s.
//!
//! The fits are those of the model `compliant` with the restitution and the frequency ratio of the
//! preset `pool`. `scripts/fit_contacts.py` makes them; `scripts/contact_fits.json` has every
//! residual.

use super::SlipFriction;

/// Balls after a ball cleaner: [`USED`] times 0.745, which gives the measured 3.6° at 45° and slow
/// speed. No other speed was measured: the fall with the slip speed is that of [`USED`].
pub const CLEAN: SlipFriction = SlipFriction { a: 0.0, b: 0.0701, c: 0.344 };

/// Used balls: the 15 readings of 2006, 0.38° rms. Twelve are within 0.5°; 20° medium (+0.77°), 45°
/// slow (−0.77°) and 10° fast (+0.54°) are not. No friction that falls with the slip speed meets all:
/// 5.1° at 45° slow takes μ ≥ 0.0892 there, which throws by more than 5.0° at 30° slow. At 45° slow
/// this surface has 4.83°, where follow-up I has 4.9°.
pub const USED: SlipFriction = SlipFriction { a: 0.0, b: 0.0942, c: 0.344 };

/// Dirty balls: the five readings of 2014, 0.21° at most.
pub const DIRTY: SlipFriction = SlipFriction { a: 0.0, b: 0.1393, c: 0.455 };

/// The friction of a contact with chalk on it: 11.6° at 45° and slow speed, as measured in
/// follow-up I.
pub const CHALKED: f64 = 0.22;

impl SlipFriction {
    /// The names of the surfaces, the least friction first.
    pub const SURFACES: [(&str, Self); 3] = [("clean", CLEAN), ("used", USED), ("dirty", DIRTY)];
}
