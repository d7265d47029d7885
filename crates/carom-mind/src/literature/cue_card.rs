//! CueCard: two levels of sampled shots, with clusters of states between them.
//!
//! Archibald, Altman & Shoham, *Analysis of a winning computational billiards player*, IJCAI 2009.
//! Two variants of each shot are generated: fine steps of speed, and random spins. Level one plays
//! each shot with 25 to 100 drawn errors. The best 20 shots go on to level two, where 50 states of
//! each shot are represented by 5 to 10 clusters, and the next shots are searched from the
//! representatives. When little time is left, level two plays its shots without errors. The break
//! is found by a search.

use core::ops::Range;

use carom::Error;
use carom::format::Reader;
use carom::resolve::cue_ball::Strike;
use carom_rules::{Frame, Play};

use super::baseline::{Baseline, first_best, usual_break};
use super::best_shots::COUNTED;
use super::levels::{MOST_SAMPLES, NodeSearch, Rated, Rating, generate, level_one, level_two};
use super::planner::{Attack, Method, Planner};
use super::shots::{Stroke, sampled_strokes};
use crate::player::Spent;
use crate::search::{Candidate, Explorer};
use crate::targets::{balls_left, call_of};
use crate::value::{Markov, Position, Value};
use crate::workbench::Workbench;
use carom_plan::Prepared;

/// Share of the budget for level one, with level two. Guess: the paper divides the time, and gives
/// no share.
const LEVEL_ONE: f64 = 0.5;
/// Share of level one for generating shots.
const GENERATING: f64 = 0.3;
/// Fewest simulations of a node at level two: about twenty shots without errors.
const LEAST_NODE: u64 = 50;
/// Fewest errors of a shot: with fewer than 25 to 30, the authors found, the player is much weaker.
const LEAST_SAMPLES: u64 = 25;
/// Slowest and fastest strike, m/s. Guess: the paper prints no range.
const SPEEDS: [f64; 2] = [0.5, 5.5];
/// Number of different parts of the sequence of strokes that the seed can choose.
const SEQUENCES: u64 = 1000;
/// Shares of the break's budget for finding breaks and for a first comparison of them; the rest
/// compares the best. Guess: the authors searched their break in advance, and print no method.
const BREAK_FINDING: f64 = 0.2;
const BREAK_SIFTING: f64 = 0.4;
/// Slowest break, m/s. The value by the best three shots does not see clusters. In a match of 120
/// frames a search without this limit kept the turn after 50 of 60 breaks, and the usual break
/// after 45; yet the player with the usual break won 68 frames.
const HARD: f64 = 9.0;
/// Drawn errors of a break in the first comparison, and the number of breaks that remain.
const FEW_ERRORS: u64 = 6;
const BREAK_FINALISTS: usize = 8;

/// The second level of CueCard's search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LevelTwo {
    /// It is searched.
    #[default]
    Searched,
    /// It is left out, and its simulations are not used.
    Off,
    /// It is left out, and its simulations are given to level one.
    GivenToLevelOne,
}

/// How CueCard breaks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CueCardBreak {
    /// By a search over places and strikes.
    #[default]
    Searched,
    /// As the other players of the literature break.
    Usual,
    /// With the cue ball at this place (file coordinates, m) and this strike.
    Given([f64; 2], Strike),
}

/// Settings of [`CueCard`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueCardSettings {
    /// Drawn errors of each shot at level one: 25 to 100 (Archibald, Altman & Shoham 2009). Level
    /// two has at most as many states. With a small budget fewer are drawn, but at least 25.
    pub samples: u64,
    /// Shots that level two searches: 20 (the same).
    pub finalists: usize,
    /// Representatives of each shot's states: 5 to 10 (the same).
    pub clusters: usize,
    /// Drawn errors of each shot at level two. Guess.
    pub samples_two: u64,
    /// A node of level two with fewer simulations than this is searched without errors. The paper
    /// does so when little time is left; the number is a guess.
    pub noiseless_below: u64,
    /// Strokes on each line, half of them fine steps of speed and half random spins. Guess.
    pub strokes: usize,
    /// The second level.
    pub level_two: LevelTwo,
    /// Number of the player's own balls, the last one included, at which states are valued by the
    /// Markov chain over ball counts instead of their best shots. The paper has such a table; the
    /// number is a guess.
    pub ending: usize,
    /// Weights of the best three shots of a position. Guess: falling weights, as in the paper, with
    /// numbers of our own.
    pub weights: [f64; COUNTED],
    /// A safety is preferred to a shot that is less probable than this, if the safety is worth
    /// more. Guess.
    pub safety_below: f64,
    /// The break.
    pub break_shot: CueCardBreak,
}

impl Default for CueCardSettings {
    fn default() -> Self {
        Self {
            samples: 50,
            finalists: 20,
            clusters: 5,
            samples_two: 25,
            noiseless_below: 400,
            strokes: 40,
            level_two: LevelTwo::Searched,
            ending: 2,
            weights: [1.0, 0.33, 0.15],
            safety_below: 0.4,
            break_shot: CueCardBreak::Searched,
        }
    }
}

impl CueCardSettings {
    /// The settings of an object; see [`super::Literature::player_with`].
    pub(crate) fn read(object: &Reader<'_>) -> Result<Self, Error> {
        object.keys(&["samples", "level-two", "break"])?;
        let mut settings = Self::default();
        if let Some(samples) = object.get("samples") {
            settings.samples = samples.whole(1, MOST_SAMPLES)? as u64;
        }
        if let Some(value) = object.get("level-two") {
            let known = ["searched", "off", "given-to-level-one"];
            settings.level_two = match value.text(&known.join(", "))? {
                "searched" => LevelTwo::Searched,
                "off" => LevelTwo::Off,
                "given-to-level-one" => LevelTwo::GivenToLevelOne,
                other => return Err(value.unknown_word(other, "level two", &known)),
            };
        }
        if let Some(value) = object.get("break") {
            let known = ["searched", "usual"];
            settings.break_shot = match value.text(&known.join(" or "))? {
                "searched" => CueCardBreak::Searched,
                "usual" => CueCardBreak::Usual,
                other => return Err(value.unknown_word(other, "break", &known)),
            };
        }
        Ok(settings)
    }
}

/// CueCard.
pub type CueCard = Planner<CueCardSettings>;

impl CueCardSettings {
    /// The two variants of each shot in turn: a plain stroke with the next fine step of speed, and
    /// one with a random spin. Every part of the list covers the whole range.
    fn strokes(&self, seed: u64) -> Vec<Stroke> {
        let count = self.strokes.max(2);
        let fine = fine_speeds(count / 2).into_iter().map(Stroke::plain);
        let spun = sampled_strokes(seed % SEQUENCES, SPEEDS);
        fine.zip(spun).flat_map(|(plain, spun)| [plain, spun]).collect()
    }

    /// What a state is worth: by the Markov chain in an ending, and else by its best shots.
    fn gain(&self, baseline: &Baseline<'_>) -> impl Fn(&Frame) -> f64 + Sync {
        let is_ending = balls_left(baseline.situation.frame, baseline.seat()) <= self.ending;
        let (noise, seat, value) =
            (baseline.situation.noise.clone(), baseline.seat(), baseline.value.clone());
        move |frame: &Frame| {
            let position = Position { frame, noise: &noise };
            if is_ending {
                Markov::default().win_chance(&position, seat)
            } else {
                value.gain(&position, seat)
            }
        }
    }

    fn search(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Rated>, Error> {
        let strokes = self.strokes(baseline.situation.seed);
        let gain = self.gain(baseline);
        let share = if self.level_two == LevelTwo::GivenToLevelOne { 1.0 } else { LEVEL_ONE };
        let first = (share * baseline.left(spent, 1) as f64) as u64;
        let generating = (GENERATING * first as f64) as u64;
        let (mut shots, plays) = generate(baseline, &strokes, generating.max(1), &gain)?;
        spent.simulations += plays;
        let left = first.saturating_sub(plays);
        // A small budget is better spent on the finalists' number of shots than on many errors.
        let wanted = left / (self.finalists.min(shots.len()).max(1) as u64);
        let samples = wanted.clamp(LEAST_SAMPLES.min(self.samples), self.samples).max(1);
        shots.truncate((left / samples).max(1) as usize);
        spent.simulations += samples * shots.len() as u64;
        spent.rounds += 1;
        let mut rated = level_one(baseline, shots, samples, &gain)?;
        if self.level_two != LevelTwo::Searched {
            return Ok(rated.into_iter().next());
        }
        let left = baseline.left(spent, 0);
        let nodes = self.clusters.max(1).min(samples as usize) as u64;
        let finalists = ((left / (LEAST_NODE * nodes)) as usize).min(self.finalists);
        rated.truncate(finalists.max(1));
        if rated.len() < 2 || !baseline.budget.allows(*spent, left) {
            return Ok(rated.into_iter().next());
        }
        let most = left / (rated.len() as u64 * nodes);
        let is_noiseless = most < self.noiseless_below;
        let samples = self.samples_two.max(1);
        let rating = if is_noiseless { Rating::Noiseless } else { Rating::Sampled(samples) };
        let search = NodeSearch { strokes: &strokes, rating, most };
        let (values, plays) = level_two(baseline, &rated, self.clusters.max(1), &search, &gain)?;
        spent.simulations += plays;
        spent.rounds += 1;
        let best = first_best(values.into_iter().zip(rated), |(value, _)| *value);
        Ok(best.map(|(_, rated)| rated))
    }

    /// The break with the best mean value among places and strikes on a lattice and the usual
    /// break: all are played with a few drawn errors, and the best of them with many.
    fn searched_break(
        &self,
        baseline: &Baseline<'_>,
        spent: &mut Spent,
    ) -> Result<Option<Play>, Error> {
        let budget = baseline.left(spent, 1);
        let share = |share: f64| (share * budget as f64) as u64;
        let mut explorer = Explorer::new(baseline.task());
        let count = baseline.prepared.len().max(1) as u64;
        for at in baseline.places() {
            explorer.breaks(at, share(BREAK_FINDING) * (at.number as u64 + 1) / count)?;
        }
        spent.simulations += explorer.bench.plays;
        let mut found: Vec<Candidate> = explorer.found;
        found.retain(|found| found.play.strike.speed >= HARD);
        found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
        found.truncate((share(BREAK_SIFTING) / FEW_ERRORS) as usize);
        let usual = usual_break(baseline).map(|play| (0, play, 0.0));
        let lattice = found.into_iter().map(|found| (found.place, found.play, 0.0));
        let mut breaks =
            break_values(baseline, usual.into_iter().chain(lattice).collect(), 0..FEW_ERRORS)?;
        spent.simulations += FEW_ERRORS * breaks.len() as u64;
        breaks.sort_by(|a, b| b.2.total_cmp(&a.2));
        breaks.truncate(BREAK_FINALISTS);
        let samples = baseline.left(spent, 0) / (breaks.len() as u64).max(1);
        let last = FEW_ERRORS + samples.min(self.samples);
        spent.simulations += (last - FEW_ERRORS) * breaks.len() as u64;
        let breaks = break_values(baseline, breaks, FEW_ERRORS..last)?;
        Ok(first_best(breaks, |(.., sum)| *sum).map(|(_, play, _)| play))
    }
}

/// A break: the number of its place, the play, and the sum of its values so far.
type Tried = (usize, Play, f64);

/// Adds the values of `breaks` with the drawn errors `indices`.
fn break_values(
    baseline: &Baseline<'_>,
    breaks: Vec<Tried>,
    indices: Range<u64>,
) -> Result<Vec<Tried>, Error> {
    let errors = baseline.errors();
    let tried = baseline.budget.runner.map(
        breaks,
        || Workbench::new(baseline.situation.frame),
        |bench, (place, play, mut sum)| {
            let (prepared, indices) = (&baseline.prepared[place], indices.clone());
            bench.sample(prepared, &play, &errors, indices, |next, _| {
                let position = Position { frame: next, noise: &baseline.situation.noise };
                sum += baseline.value.win_chance(&position, baseline.seat());
            })?;
            Ok((place, play, sum))
        },
    );
    tried.into_iter().collect()
}

/// `count` speeds (m/s) in equal steps of their logarithm over [`SPEEDS`], in an order in which
/// every part covers the range: the k-th is the fractional part of k times the golden ratio.
fn fine_speeds(count: usize) -> Vec<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let [low, high] = SPEEDS;
    let mut shares: Vec<(usize, f64)> =
        (0..count).map(|k| (k, (0.5 + GOLDEN * k as f64) % 1.0)).collect();
    shares.sort_by(|a, b| a.1.total_cmp(&b.1));
    let last = count.saturating_sub(1).max(1) as f64;
    let mut speeds = vec![0.0; count];
    for (rank, (k, _)) in shares.into_iter().enumerate() {
        speeds[k] = low * libm::pow(high / low, rank as f64 / last);
    }
    speeds
}

impl Method for CueCardSettings {
    fn name(&self) -> String {
        "cue-card".into()
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

    fn break_shot(
        &self,
        baseline: &Baseline<'_>,
        spent: &mut Spent,
    ) -> Result<Option<Play>, Error> {
        match self.break_shot {
            CueCardBreak::Searched => self.searched_break(baseline, spent),
            CueCardBreak::Usual => Ok(usual_break(baseline)),
            CueCardBreak::Given(place, strike) => {
                let prepared = Prepared::new(baseline.situation.frame, Some(place))?;
                prepared.shot().resolve_strike(&strike)?;
                let first = baseline.turn.on.first().copied().unwrap_or(baseline.turn.cue);
                let call = call_of(baseline.turn, first, None);
                Ok(Some(Play { cue_ball: Some(place), call, ..Play::new(strike) }))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CueCardSettings, SPEEDS, fine_speeds};

    #[test]
    fn fine_speeds_cover_the_range_in_equal_ratios() {
        let mut speeds = fine_speeds(20);
        assert!(speeds[..4].iter().any(|v| *v < 1.2) && speeds[..4].iter().any(|v| *v > 2.2));
        speeds.sort_by(f64::total_cmp);
        assert!((speeds[0] - SPEEDS[0]).abs() < 1e-12 && (speeds[19] - SPEEDS[1]).abs() < 1e-9);
        let ratio = speeds[1] / speeds[0];
        assert!(speeds.windows(2).all(|pair| (pair[1] / pair[0] - ratio).abs() < 1e-9));
    }

    #[test]
    fn half_of_the_strokes_are_plain_and_half_have_a_random_spin() {
        let player = CueCardSettings::default();
        let strokes = player.strokes(3);
        assert_eq!(strokes.len(), player.strokes);
        let plain = strokes.iter().filter(|stroke| stroke.side == 0.0 && stroke.height == 0.0);
        assert_eq!(plain.count(), strokes.len() / 2);
        assert_ne!(strokes, player.strokes(4), "the seed chooses the spins");
    }
}
