//! Fouls on purpose: what does the other player make of them?
//!
//! The value of a position is an estimate that overrates ball in hand where the ball on is hard to reach, for
//! the player who has left it there. Where a foul looks best, a search of the other player's shot corrects it.

use carom::Error;
use carom_plan::Prepared;
use carom_rules::Request;

use super::candidate::Candidate;
use super::rounds::ShotSearch;
use super::task::{SearchTask, ShotTask};
use crate::player::{Budget, Situation};
use crate::value::Position;
use crate::workbench::Workbench;

/// A play that is a foul in a larger share of its samples lives on what the foul leaves.
const OFTEN: f64 = 0.2;
/// Share of a decision's simulations for the search of the other player's shot, the fewest and the most.
const SHARE: f64 = 0.15;
const SIMULATIONS: [f64; 2] = [900.0, 5000.0];

impl SearchTask<'_> {
    /// Whether what fouls are worth decides: the first candidate is often a foul.
    fn lives_on_fouls(candidates: &[Candidate]) -> bool {
        candidates.first().is_some_and(|first| first.share(|sample| sample.foul) > OFTEN)
    }

    /// If the first candidate is often a foul: what has to be added to the value of a foul, by a search of the other
    /// player's shot after one of its fouls, and the simulations; none if no foul is followed by a shot. `spent` is
    /// what the decision has spent so far. The samples of the candidates are corrected, and the candidates ordered.
    ///
    /// # Errors
    /// As [`ShotSearch::play_round`].
    pub(crate) fn doubt_fouls(
        &self,
        prepared: &[Prepared<'_>],
        candidates: &mut [Candidate],
        spent: u64,
    ) -> Result<Option<(f64, u64)>, Error> {
        if !Self::lives_on_fouls(candidates) {
            return Ok(None);
        }
        let first = &candidates[0];
        let Some(played) = first.samples.iter().find(|sample| sample.foul) else { return Ok(None) };
        let ShotTask { situation, turn: own_turn, value } = self.shot;
        let Workbench { mut sampler, mut successor, .. } = Workbench::new(situation.frame);
        let position = &prepared[first.place];
        sampler.simulate(position, &played.executed)?;
        sampler.rule(position, first.play.call, &mut successor)?;
        let Request::Shot(turn) = successor.request() else { return Ok(None) };
        let situation = &Situation { frame: &successor, ..situation.clone() };
        let simulations = (SHARE * spent as f64).clamp(SIMULATIONS[0], SIMULATIONS[1]) as u64;
        let Budget { is_over, ref runner, .. } = *self.budget;
        let budget = &Budget { simulations, rounds: None, is_over, runner: runner.clone() };
        let reply = SearchTask { shot: ShotTask { situation, turn, value }, budget, ..*self };
        // A foul of the other player is not doubted in its turn.
        let mut search = ShotSearch::new(reply, 1).without_doubts();
        while search.play_round()? {}
        let found = search.found()?;
        let cost = found.spent.simulations;
        let Some(best) = found.candidates.first() else { return Ok(None) };
        let is_own = turn.player == own_turn.player;
        let searched = if is_own { best.stated_win() } else { 1.0 - best.stated_win() };
        let position = Position { frame: &successor, noise: &situation.noise };
        let correction = searched - value.win_chance(&position, own_turn.player);
        for sample in candidates.iter_mut().flat_map(|candidate| &mut candidate.samples) {
            if sample.foul {
                sample.value = (sample.value + correction).clamp(0.0, 1.0);
            }
        }
        candidates.sort_by(|a, b| b.mean().total_cmp(&a.mean()));
        Ok(Some((correction, cost)))
    }
}
