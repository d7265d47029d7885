//! The random numbers of an episode. They depend only on the environment's seed and the number of
//! the episode.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// PCG's stream for each purpose: arbitrary different constants.
const LAYOUT: u128 = 0x6361_726f_6d20_6c61_796f;
const OPPONENT: u128 = 0x6361_726f_6d20_706c_6179;
const SETUP: u128 = 0x6361_726f_6d20_7365_7475;
const SEAT: u128 = 0x6361_726f_6d20_7365_6174;
const DECISION: u128 = 0x6361_726f_6d20_6d69_6e64;

/// 2⁶⁴ divided by the golden ratio. It is odd, so that its multiples visit every number.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The seed of episode `episode` of the environment with `seed`: two rounds of the finalizer of
/// SplitMix64 (Steele, Lea & Flood 2014), so that neighbouring seeds are uncorrelated.
pub(crate) fn episode_seed(seed: u64, episode: u64) -> u64 {
    mixed(mixed(seed.wrapping_add(GOLDEN)).wrapping_add(episode.wrapping_mul(GOLDEN)))
}

const fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The seed of a player's decision about move number `index` of an episode. It tells nothing about the
/// noise of the strike, which is drawn with the seed of the episode.
pub(crate) fn decision_seed(episode_seed: u64, index: u64) -> u64 {
    Pcg64::new(episode_seed.into(), DECISION + (u128::from(index) << 64)).next_u64()
}

/// A generator of random numbers.
pub(crate) struct Dice(Pcg64);

impl Dice {
    /// For the layout of the balls.
    pub(crate) fn of_layout(seed: u64) -> Self {
        Self(Pcg64::new(seed.into(), LAYOUT))
    }

    /// For the agent's seat.
    pub(crate) fn of_seat(seed: u64) -> Self {
        Self(Pcg64::new(seed.into(), SEAT))
    }

    /// For the table and the physics.
    pub(crate) fn of_setup(seed: u64) -> Self {
        Self(Pcg64::new(seed.into(), SETUP))
    }

    /// For shot number `shot`, played by the opponent.
    pub(crate) fn of_opponent(seed: u64, shot: u64) -> Self {
        Self(Pcg64::new(seed.into(), OPPONENT + (u128::from(shot) << 64)))
    }

    /// Uniform in (0, 1): the middle of one of 2⁵² cells.
    pub(crate) fn inner(&mut self) -> f64 {
        ((self.0.next_u64() >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform among 0..`count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::episode_seed;

    #[test]
    fn neighbouring_seeds_and_episodes_have_different_seeds() {
        let mut seen = std::collections::HashSet::new();
        for seed in 0..100 {
            for episode in 0..100 {
                assert!(seen.insert(episode_seed(seed, episode)));
            }
        }
    }
}
