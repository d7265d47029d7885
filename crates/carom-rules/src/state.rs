//! The state that every game has.

use std::sync::Arc;

use carom::rack::Game;
use carom::{Error, Shot};

use crate::layout::FrameLayout;
use crate::options::Options;
use crate::ruling::Ruling;
use crate::state_bytes::StateBytes;

/// 2⁶⁴ divided by the golden ratio. It is odd, so that all racks of a frame get different seeds.
const SEED_STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The state that every game has.
#[derive(Debug)]
pub(crate) struct FrameState {
    pub(crate) options: Options,
    /// A shot on the frame's table with its physics; the balls of this shot are not used.
    pub(crate) base: Arc<Shot>,
    pub(crate) layout: FrameLayout,
    pub(crate) scores: [i32; 2],
    /// Consecutive fouls of each seat.
    pub(crate) fouls: [u32; 2],
    /// The ruling on the current shot or choice.
    pub(crate) ruling: Ruling,
    game: Game,
    seed: u64,
    seeds_drawn: u64,
}

impl Clone for FrameState {
    fn clone(&self) -> Self {
        Self { base: self.base.clone(), layout: self.layout.clone(), ..*self }
    }

    // As for the layout, counts of references are left alone where possible.
    fn clone_from(&mut self, source: &Self) {
        let Self { base, layout, .. } = self;
        if !Arc::ptr_eq(base, &source.base) {
            base.clone_from(&source.base);
        }
        layout.clone_from(&source.layout);
        let Self { options, scores, fouls, ruling, game, seed, seeds_drawn, .. } = self;
        (*options, *game) = (source.options, source.game);
        (*scores, *fouls, *ruling) = (source.scores, source.fouls, source.ruling);
        (*seed, *seeds_drawn) = (source.seed, source.seeds_drawn);
    }
}

impl FrameState {
    pub(crate) fn new(
        game: Game,
        options: Options,
        base: Arc<Shot>,
        seed: u64,
    ) -> Result<Self, Error> {
        let layout = FrameLayout::rack(game, &base, seed)?;
        let (scores, fouls, ruling) = ([0; 2], [0; 2], Ruling::default());
        Ok(Self { options, base, layout, scores, fouls, ruling, game, seed, seeds_drawn: 0 })
    }

    /// Appends everything that changes during a frame, and the options.
    pub(crate) fn write_to(&self, out: &mut Vec<u8>) {
        let Options { points, miss, patience } = self.options;
        points.write_to(out);
        miss.write_to(out);
        patience.write_to(out);
        self.layout.places().write_to(out);
        self.scores.write_to(out);
        self.fouls.write_to(out);
        [self.seed, self.seeds_drawn].write_to(out);
    }

    /// The state that `bytes` begin with, of a frame with this table and these balls.
    pub(crate) fn read_same(&self, bytes: &mut &[u8]) -> Option<Self> {
        let (points, miss) = (i32::read_from(bytes)?, bool::read_from(bytes)?);
        let options = Options { points, miss, patience: StateBytes::read_from(bytes)? };
        let mut state = Self { options, ruling: Ruling::default(), ..self.clone() };
        state.layout.put_all(&StateBytes::read_from(bytes)?);
        state.scores = StateBytes::read_from(bytes)?;
        state.fouls = StateBytes::read_from(bytes)?;
        [state.seed, state.seeds_drawn] = StateBytes::read_from(bytes)?;
        Some(state)
    }

    /// Replaces the seed of the racks to come.
    pub(crate) const fn reseed(&mut self, seed: u64) {
        (self.seed, self.seeds_drawn) = (seed, 0);
    }

    /// The scores including the points of the current ruling.
    pub(crate) fn scores_after(&self) -> [i32; 2] {
        [0, 1].map(|seat| self.scores[seat] + self.ruling.points[seat])
    }

    /// Racks the balls, with a new seed.
    pub(crate) fn rack(&mut self) {
        self.layout = self.fresh_rack();
        self.ruling.racked = true;
    }

    pub(crate) fn fresh_rack(&mut self) -> FrameLayout {
        let seed = self.next_seed();
        // The frame began with this rack on this table, so racking cannot fail.
        FrameLayout::rack(self.game, &self.base, seed).unwrap_or_else(|_| self.layout.clone())
    }

    /// The next seed of the frame's own sequence.
    pub(crate) fn next_seed(&mut self) -> u64 {
        self.seeds_drawn += 1;
        self.seed.wrapping_add(self.seeds_drawn.wrapping_mul(SEED_STEP))
    }
}
