//! A second look at the finalists: what can be done after them?
//!
//! The value of a position is an estimate. For some of a finalist's successors it is replaced by
//! that of the best shot that a small search finds there, the other player's shots included. The
//! mean difference corrects the mean over all samples (a control variate): the many cheap values
//! keep the variance small, and the few searched ones remove the bias.

use carom::Error;
use carom_rules::Request;

use super::candidate::Candidate;
use super::explore::{CuePlace, Explorer};
use super::race::Race;
use super::task::ShotTask;
use crate::player::Situation;
use crate::settings::SearchSettings;
use crate::value::{Position, Value};
use crate::workbench::Workbench;
use carom_plan::Prepared;

/// Fewest and most successors of a finalist that are searched. With more, each is searched longer.
const SUCCESSORS: [u64; 2] = [4, 24];
/// Fewest finalists: one alone cannot be compared.
const LEAST_FINALISTS: u64 = 2;

/// How many successors are searched, and how long.
pub(crate) struct Replies {
    finalists: usize,
    /// Successors of each finalist.
    successors: u64,
    /// Simulations for each successor.
    each: u64,
}

impl Replies {
    /// With about `simulations` simulations; none if they are too few.
    pub(crate) fn within(simulations: u64, settings: &SearchSettings) -> Option<Self> {
        let [least, most] = SUCCESSORS;
        let nodes = simulations / settings.per_reply;
        let finalists = (nodes / least).min(settings.finalists as u64);
        if finalists < LEAST_FINALISTS {
            return None;
        }
        let successors = (nodes / finalists).clamp(least, most);
        let each = simulations / (finalists * successors);
        Some(Self { finalists: finalists as usize, successors, each })
    }

    /// The number of simulations.
    pub(crate) const fn cost(&self) -> u64 {
        self.finalists as u64 * self.successors * self.each
    }

    /// Corrects the values of the first candidates, and orders them. Returns the number of
    /// simulations.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    pub(crate) fn search(
        &self,
        race: &Race<'_>,
        candidates: &mut [Candidate],
    ) -> Result<u64, Error> {
        let finalists = self.finalists.min(candidates.len());
        let jobs: Vec<(usize, usize)> = (0..finalists)
            .flat_map(|k| {
                let count = (self.successors as usize).min(candidates[k].samples.len());
                (0..count).map(move |sample| (k, sample))
            })
            .collect();
        let racing = &*candidates;
        let replies = race.runner.map(
            jobs,
            || Workbench::new(race.shot.frame()),
            |bench, (finalist, sample)| reply(race, racing, finalist, sample, self.each, bench),
        );
        let replies = replies.into_iter().collect::<Result<Vec<Reply>, Error>>()?;
        let spent = replies.iter().map(|reply| reply.plays).sum();
        // The search finds more than the value expects, or less, in all positions of a player alike.
        // Only what differs between the finalists counts.
        let usual = [false, true].map(|own| {
            let same = replies.iter().filter(|reply| reply.is_own == Some(own));
            mean(same.map(|reply| reply.difference))
        });
        let residual = |reply: &Reply| match reply.is_own {
            Some(own) => reply.difference - usual[usize::from(own)],
            None => 0.0,
        };
        let found: Vec<Estimate> = (0..finalists)
            .map(|k| {
                let own = replies.iter().filter(|reply| reply.finalist == k);
                Estimate::of(own.map(residual))
            })
            .collect();
        // The few differences of a finalist are uncertain. How much their mean counts depends on how
        // much the finalists truly differ (empirical Bayes: Efron & Morris 1973).
        let spread = Estimate::of(found.iter().map(|estimate| estimate.mean));
        let noise = mean(found.iter().map(|estimate| estimate.error));
        let true_spread = (spread.variance - noise).max(0.0);
        for (candidate, estimate) in candidates[..finalists].iter_mut().zip(found) {
            let weight = true_spread / (true_spread + estimate.error).max(f64::MIN_POSITIVE);
            candidate.correction = weight * estimate.mean;
        }
        candidates[..finalists].sort_by(|a, b| b.mean().total_cmp(&a.mean()));
        Ok(spent)
    }
}

/// The mean; 0 of nothing.
fn mean(values: impl Iterator<Item = f64>) -> f64 {
    Estimate::of(values).mean
}

/// A mean and its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Estimate {
    mean: f64,
    /// Variance of the values.
    variance: f64,
    /// Variance of the mean.
    error: f64,
}

impl Estimate {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
        for value in values {
            (count, sum, squares) = (count + 1.0, sum + value, squares + value * value);
        }
        let mean = if count > 0.0 { sum / count } else { 0.0 };
        let variance = (squares - sum * mean).max(0.0) / (count - 1.0_f64).max(1.0);
        Self { mean, variance, error: variance / count.max(1.0) }
    }
}

/// A searched successor.
struct Reply {
    finalist: usize,
    /// Whether the player has the turn; none if the frame is over.
    is_own: Option<bool>,
    /// Searched value less estimated value.
    difference: f64,
    plays: u64,
}

/// Searches what follows a sample of a finalist.
fn reply(
    race: &Race<'_>,
    candidates: &[Candidate],
    finalist: usize,
    sample: usize,
    per_reply: u64,
    bench: &mut Workbench,
) -> Result<Reply, Error> {
    let Workbench { sampler, successor, .. } = bench;
    let candidate = &candidates[finalist];
    let prepared = &race.prepared[candidate.place];
    let played = &candidate.samples[sample];
    let errors = race.errors_of(candidate);
    sampler.simulate_executed(prepared, &played.executed, &errors, played.index)?;
    sampler.rule(prepared, candidate.play.call, successor)?;
    let estimated = played.value;
    let situation = Situation { frame: successor, ..race.shot.situation.clone() };
    let (searched, plays) = quick_value(&situation, race.shot.value, per_reply)?;
    let is_own = successor.player().map(|player| player == race.shot.seat());
    let difference = match is_own {
        Some(true) => searched - estimated,
        Some(false) => 1.0 - searched - estimated,
        None => 0.0,
    };
    Ok(Reply { finalist, is_own, difference, plays: plays + 1 })
}

/// The value of a position for the player to answer, by a search without errors of about
/// `simulations` simulations, and their number.
///
/// # Errors
/// As [`Explorer::ruled`].
pub(crate) fn quick_value(
    situation: &Situation<'_>,
    value: &dyn Value,
    simulations: u64,
) -> Result<(f64, u64), Error> {
    let frame = situation.frame;
    let position = Position { frame, noise: &situation.noise };
    let Some(player) = frame.player() else { return Ok((0.5, 0)) };
    let estimated = value.win_chance(&position, player);
    let Request::Shot(turn) = frame.request() else { return Ok((estimated, 0)) };
    let task = ShotTask { situation, turn, value };
    let place = match turn.hand {
        Some(region) => task.places(region).first().copied(),
        None => None,
    };
    if turn.hand.is_some() && place.is_none() {
        return Ok((estimated, 0));
    }
    let Ok(prepared) = Prepared::new(frame, place) else { return Ok((estimated, 0)) };
    let (mut explorer, at) = (Explorer::new(task), CuePlace { number: 0, prepared: &prepared });
    let mut lines = explorer.lines(at);
    lines.truncate(3);
    explorer.pots(&prepared, &mut lines, simulations * 2 / 3)?;
    explorer.safeties(at, simulations)?;
    // A safety's value without errors is too good: errors spoil some of them.
    let best = explorer.found.iter().map(|candidate| candidate.prior).reduce(f64::max);
    Ok((best.unwrap_or(estimated), explorer.bench.plays))
}
