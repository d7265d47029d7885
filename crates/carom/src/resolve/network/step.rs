//! Steps of time of a network.

use super::{Stepping, Units};

/// As the impact fades, contacts last longer, in proportion to (speed)^(−1/5). The steps grow in
/// the same way: each time the square of the fastest approach has fallen to this fraction, they
/// grow by the factor [`LONGER`].
const RELAXED: f64 = 0.5;

/// Growth of a step: [`RELAXED`]^(−1/10).
const LONGER: f64 = 1.071_773_5;

/// Duration of a pair's Hertz contact, in units of (m*²/(k²V))^(1/5).
const CONTACT_TIME: f64 = 3.21;

/// The length of a step in time.
pub(super) struct TimeStep {
    /// In units of T.
    pub(super) length: f64,
    /// The (speed)² for which the length was chosen.
    square_speed: f64,
    /// The unit of speed, m/s.
    pub(super) speed: f64,
}

impl TimeStep {
    /// The first step. `greatest_square` is the largest (speed)² at the start.
    pub(super) fn first(units: &Units, stepping: &Stepping, greatest_square: f64) -> Self {
        let length = CONTACT_TIME / stepping.steps_per_contact;
        let mut step = Self { length, square_speed: 1.0, speed: units.speed };
        while greatest_square < RELAXED * step.square_speed {
            step.square_speed *= RELAXED;
            step.length *= LONGER;
        }
        step
    }

    /// Lengthens the step a little where the impact has faded, and shortens it where speeds have
    /// grown.
    #[inline(always)]
    pub(super) fn adapt(&mut self, greatest_square: f64) {
        if greatest_square < RELAXED * self.square_speed {
            self.square_speed *= RELAXED;
            self.length *= LONGER;
        }
        while greatest_square > self.square_speed {
            self.square_speed *= 1.0 / RELAXED;
            self.length *= 1.0 / LONGER;
        }
    }
}

/// The indices of the bits that are set, from the lowest.
pub(super) struct Bits(pub(super) u64);

impl Iterator for Bits {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let place = self.0.trailing_zeros();
        if place == u64::BITS {
            return None;
        }
        self.0 &= self.0 - 1;
        Some(place as usize)
    }
}
