//! What every game keeps.

use carom::{Error, Shot};

use crate::games::{Options, Rules};
use crate::layout::Layout;
use crate::ruling::Ruling;

/// What every game keeps.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) options: Options,
    /// Any shot on this table, under these physics.
    pub(crate) base: Shot,
    pub(crate) layout: Layout,
    pub(crate) scores: [i32; 2],
    /// Fouls in a row.
    pub(crate) fouls: [u32; 2],
    /// What the referee says of the shot or choice at hand.
    pub(crate) ruling: Ruling,
    rules: Rules,
    seed: u64,
    racks: u64,
}

impl State {
    pub(super) fn new(
        rules: Rules,
        options: Options,
        base: Shot,
        seed: u64,
    ) -> Result<Self, Error> {
        let layout = Layout::rack(rules.rack(), &base, seed)?;
        let (scores, fouls, ruling) = ([0; 2], [0; 2], Ruling::default());
        Ok(Self { options, base, layout, scores, fouls, ruling, rules, seed, racks: 1 })
    }

    /// The scores with what the ruling gives.
    pub(crate) fn scores_after(&self) -> [i32; 2] {
        [0, 1].map(|player| self.scores[player] + self.ruling.points[player])
    }

    /// Racks the balls, another way each time.
    pub(crate) fn rack(&mut self) {
        self.layout = self.fresh_rack();
        self.ruling.racked = true;
    }

    pub(crate) fn fresh_rack(&mut self) -> Layout {
        let seed = self.next_seed();
        // What was racked at the start of the frame can be racked again.
        Layout::rack(self.rules.rack(), &self.base, seed).unwrap_or_else(|_| self.layout.clone())
    }

    pub(crate) fn next_seed(&mut self) -> u64 {
        self.racks += 1;
        // An odd number: no two racks of a frame, and hardly two of any frames, get the same seed.
        self.seed.wrapping_add((self.racks - 1).wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }
}
