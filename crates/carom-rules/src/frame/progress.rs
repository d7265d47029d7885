//! Does a frame get on?

use super::state::State;
use crate::games::Rules;

/// Of a stalemate's two ends, racking again comes first; the second stalemate of a frame ends it.
const STALEMATES: u32 = 2;

/// Shots since the last progress, the fewest balls and the best scores so far.
#[derive(Clone, Debug)]
pub(super) struct Progress {
    idle: u32,
    fewest: usize,
    best: [i32; 2],
    stalemates: u32,
}

/// What comes of a stalemate.
pub(super) enum Stalemate {
    /// The balls are racked again, and the first breaker breaks.
    Again,
    /// The frame ends undecided.
    End,
}

impl Progress {
    pub(super) fn new(state: &State) -> Self {
        Self { idle: 0, fewest: Self::left(state), best: [0; 2], stalemates: 0 }
    }

    /// The rack begins with the balls that are on the table now.
    pub(super) fn restart(&mut self, state: &State) {
        self.idle = 0;
        self.fewest = Self::left(state);
    }

    /// A choice (`shots` is 0) or a shot is over: is it a stalemate (WPA 1.12)?
    pub(super) fn follow(&mut self, rules: Rules, state: &State, shots: u32) -> Option<Stalemate> {
        let left = Self::left(state);
        if state.ruling.racked {
            self.fewest = left;
        }
        let better = (0..2).any(|player| state.scores[player] > self.best[player]);
        let progress = if rules.is_scored_by_shots() { better } else { left < self.fewest };
        self.fewest = self.fewest.min(left);
        self.best = [0, 1].map(|player| self.best[player].max(state.scores[player]));
        self.idle = if progress { 0 } else { self.idle + shots };
        if self.idle < state.options.patience {
            return None;
        }
        self.idle = 0;
        self.stalemates += 1;
        let again = self.stalemates < STALEMATES && rules.is_racked_after_stalemate();
        Some(if again { Stalemate::Again } else { Stalemate::End })
    }

    fn left(state: &State) -> usize {
        state.layout.on_table().count()
    }
}
