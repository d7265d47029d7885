//! Levels of strength, from a beginner's to the strongest.
//!
//! A level has two knobs: the errors of its strikes, and how much it thinks. Both are set so that
//! each level wins 65 to 75 % of its frames of eight-ball against the level below; docs/strategy.md
//! has the matches.

use carom::Noise;
use carom::noise::SKILLS;

/// A level of strength of the searching player.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Its name, `level-1` to `level-5`.
    pub name: &'static str,
    /// The errors of its strikes.
    pub noise: Noise,
    /// Its simulated shots for each decision.
    pub simulations: u32,
}

impl Level {
    /// The level with `errors` times the errors of a club player.
    const fn new(name: &'static str, errors: f64, simulations: u32) -> Self {
        let (_, club) = &SKILLS[2];
        Self { name, noise: club.independent(errors), simulations }
    }

    /// The level of that name.
    pub fn named(name: &str) -> Option<&'static Self> {
        LEVELS.iter().find(|level| level.name == name)
    }
}

/// The levels, the weakest first.
pub static LEVELS: [Level; 5] = [
    Level::new("level-1", 1.42, 120),
    Level::new("level-2", 1.18, 250),
    Level::new("level-3", 0.9, 600),
    Level::new("level-4", 0.65, 1500),
    Level::new("level-5", 0.33, 6000),
];
