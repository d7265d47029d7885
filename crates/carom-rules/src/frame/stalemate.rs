//! Detects stalemates: frames without progress.

use crate::games::{GameFacts, Stalemate};
use crate::state::FrameState;
use crate::state_bytes::StateBytes;

/// The stalemate that ends every frame.
const LAST_STALEMATE: u32 = 2;

/// The progress of a frame so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct StalemateCounter {
    /// Shots since the last progress.
    idle: u32,
    /// The fewest balls on the table so far, since the last rack.
    fewest: usize,
    best_scores: [i32; 2],
    stalemates: u32,
}

impl StateBytes for StalemateCounter {
    fn write_to(&self, out: &mut Vec<u8>) {
        let Self { idle, fewest, best_scores, stalemates } = self;
        (*fewest as u16).write_to(out);
        [*idle, *stalemates].write_to(out);
        best_scores.write_to(out);
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        let fewest = u16::read_from(bytes)?.into();
        let [idle, stalemates] = StateBytes::read_from(bytes)?;
        Some(Self { idle, fewest, best_scores: StateBytes::read_from(bytes)?, stalemates })
    }
}

impl StalemateCounter {
    pub(super) fn new(state: &FrameState) -> Self {
        Self { idle: 0, fewest: Self::left(state), best_scores: [0; 2], stalemates: 0 }
    }

    /// Starts counting again, with the balls that are on the table now.
    pub(super) fn restart(&mut self, state: &FrameState) {
        self.idle = 0;
        self.fewest = Self::left(state);
    }

    /// Updates the counter after a shot or a choice (`shots` is 1 or 0). Returns a stalemate if
    /// there is one (WPA 1.12).
    pub(super) fn update(
        &mut self,
        facts: &GameFacts,
        state: &FrameState,
        shots: u32,
    ) -> Option<Stalemate> {
        let left = Self::left(state);
        if state.ruling.racked {
            self.fewest = left;
        }
        let better = (0..2).any(|seat| state.scores[seat] > self.best_scores[seat]);
        let progress = if facts.has_target() { better } else { left < self.fewest };
        self.fewest = self.fewest.min(left);
        self.best_scores = [0, 1].map(|seat| self.best_scores[seat].max(state.scores[seat]));
        self.idle = if progress { 0 } else { self.idle + shots };
        if self.idle < state.options.patience {
            return None;
        }
        self.idle = 0;
        self.stalemates += 1;
        Some(if self.stalemates < LAST_STALEMATE { facts.stalemate } else { Stalemate::End })
    }

    fn left(state: &FrameState) -> usize {
        state.layout.on_table().count()
    }
}
