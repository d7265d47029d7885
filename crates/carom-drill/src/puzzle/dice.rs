//! The random numbers of a puzzle, from its theme and number alone.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use super::theme::Theme;

/// PCG's stream. Any constant would do; another one changes every puzzle.
const STREAM: u128 = 0x6361_726f_6d20_7075_7a7a;

pub(super) struct Dice(Pcg64);

impl Dice {
    pub(super) fn of(theme: Theme, number: u32) -> Self {
        Self(Pcg64::new(u128::from(number) | (theme as u128) << 64, STREAM))
    }

    /// Uniform in [low, high).
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// One of a list.
    pub(super) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.between(0.0, list.len() as f64) as usize]
    }
}
