//! PickPocket: Monte-Carlo search to depth two.
//!
//! Smith, *PickPocket: A computer billiards shark*, Artificial Intelligence 171, 2007. Direct,
//! bank, kick and combination shots are generated with sampled speeds and spins. Each is played
//! with 15 drawn errors. From every state that keeps the turn the next shots are searched in the
//! same way, and the last states are valued by their best shots.

use carom::Error;
use carom::format::Reader;

use super::baseline::{Baseline, first_best};
use super::best_shots::COUNTED;
use super::levels::{MOST_SAMPLES, NodeSearch, Rated, Rating, generate, level_one, level_two};
use super::planner::{Attack, Method, Planner};
use super::shots::{Stroke, sampled_strokes};
use crate::player::Spent;
use crate::value::Position;

/// Share of the budget for level one.
const LEVEL_ONE: f64 = 0.4;
/// Share of that for generating shots.
const GENERATING: f64 = 0.3;
/// Fewest simulations of a node at level two: about three shots with 15 errors each.
const LEAST_NODE: u64 = 54;
/// Fewest shots among which level two chooses.
const LEAST_FINALISTS: u64 = 2;
/// Speeds of the sampled strokes, m/s: from a ball that hangs in the pocket to three lengths of a
/// table. Guess: the paper samples speeds and spins but prints no ranges.
const SPEEDS: [f64; 2] = [0.6, 5.0];
/// Speed of the plain stroke, m/s.
const USUAL: f64 = 1.8;
/// Number of different parts of the sequence of strokes that the seed can choose.
const SEQUENCES: u64 = 1000;

/// Settings of [`PickPocket`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PickPocketSettings {
    /// Drawn errors of each shot: 15 (Smith 2007).
    pub samples: u64,
    /// Strokes that are tried on each line. Guess: the paper prints no number.
    pub strokes: usize,
    /// Levels of the search, 1 or 2: 2 (Smith 2007).
    pub depth: u32,
    /// Weights of the best three shots of a position. Guess: falling weights, as in the paper, with
    /// numbers of our own.
    pub weights: [f64; COUNTED],
    /// A safety is preferred to a shot that is less probable than this, if the safety is worth
    /// more. The paper has such a threshold; its value is a guess.
    pub safety_below: f64,
}

impl Default for PickPocketSettings {
    fn default() -> Self {
        Self { samples: 15, strokes: 24, depth: 2, weights: [1.0, 0.33, 0.15], safety_below: 0.4 }
    }
}

impl PickPocketSettings {
    /// The settings of an object; see [`super::Literature::player_with`].
    pub(crate) fn read(object: &Reader<'_>) -> Result<Self, Error> {
        object.keys(&["samples"])?;
        let mut settings = Self::default();
        if let Some(samples) = object.get("samples") {
            settings.samples = samples.whole(1, MOST_SAMPLES)? as u64;
        }
        Ok(settings)
    }
}

/// PickPocket.
pub type PickPocket = Planner<PickPocketSettings>;

impl PickPocketSettings {
    /// The sampled strokes: a plain one of usual speed first.
    fn strokes(&self, seed: u64) -> Vec<Stroke> {
        let sampled = sampled_strokes(seed % SEQUENCES, SPEEDS);
        core::iter::once(Stroke::plain(USUAL)).chain(sampled).take(self.strokes).collect()
    }

    /// The shot that the search prefers.
    fn search(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Rated>, Error> {
        let strokes = self.strokes(baseline.situation.seed);
        let gain = |frame: &carom_rules::Frame| {
            let position = Position { frame, noise: &baseline.situation.noise };
            baseline.value.gain(&position, baseline.seat())
        };
        let samples = self.samples.max(1);
        // Every own state of a shot is a node of level two.
        let finalist = LEAST_NODE * samples;
        let budget = baseline.left(spent, 1);
        let second = ((1.0 - LEVEL_ONE) * budget as f64) as u64;
        // A budget that is too small for level two is used at level one.
        let is_deep = self.depth > 1 && second >= LEAST_FINALISTS * finalist;
        let first = if is_deep { budget - second } else { budget };
        let generating = (GENERATING * first as f64) as u64;
        let (mut shots, plays) = generate(baseline, &strokes, generating.max(1), &gain)?;
        spent.simulations += plays;
        shots.truncate((first.saturating_sub(plays) / samples).max(1) as usize);
        spent.simulations += samples * shots.len() as u64;
        spent.rounds += 1;
        let mut rated = level_one(baseline, shots, samples, &gain)?;
        let left = baseline.left(spent, 0);
        rated.truncate(if is_deep { (left / finalist) as usize } else { 1 });
        if rated.len() < 2 || !baseline.budget.allows(*spent, left) {
            return Ok(rated.into_iter().next());
        }
        let most = left / (rated.len() as u64 * samples);
        let search = NodeSearch { strokes: &strokes, rating: Rating::Sampled(samples), most };
        let (values, plays) = level_two(baseline, &rated, usize::MAX, &search, &gain)?;
        spent.simulations += plays;
        spent.rounds += 1;
        let best = first_best(values.into_iter().zip(rated), |(value, _)| *value);
        Ok(best.map(|(_, rated)| rated))
    }
}

impl Method for PickPocketSettings {
    fn name(&self) -> String {
        "pick-pocket".into()
    }

    fn weights(&self) -> [f64; COUNTED] {
        self.weights
    }

    fn safety_below(&self) -> f64 {
        self.safety_below
    }

    fn attack(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Attack>, Error> {
        let best = self.search(baseline, spent)?;
        Ok(best.map(|rated| Attack { play: rated.shot.play, chance: rated.kept }))
    }
}
