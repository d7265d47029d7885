//! The race between candidates with common errors: all are played with the same errors, which are
//! spread evenly.
//!
//! It is sequential halving (Karnin, Koren & Somekh 2013): heats of equal cost, each of which drops the worse
//! half.

use core::ops::Range;

use carom::Error;
use carom::runner::Runner;

use super::candidate::{Candidate, PlayedVariant};
use super::even_errors::EvenErrors;
use super::task::{SearchTask, ShotTask};
use crate::player::Situation;
use crate::value::Position;
use crate::workbench::Workbench;
use carom::noise::Errors;
use carom_plan::Prepared;

/// Samples of a candidate that one thread plays at a time: about a tenth of a millisecond of work.
const CHUNK: u64 = 8;
/// Number of the first errors that take no part in a choice. No race plays so many.
const FRESH: u64 = 1 << 40;

/// What is raced.
#[derive(Clone, Copy)]
pub(crate) struct Race<'a> {
    pub(crate) shot: ShotTask<'a>,
    pub(crate) prepared: &'a [Prepared<'a>],
    pub(crate) runner: &'a Runner,
    /// Whether all candidates have the same errors.
    pub(crate) common_errors: bool,
    /// What is added to the value of a foul.
    pub(crate) foul_correction: f64,
}

impl<'a> SearchTask<'a> {
    /// The race between plays from these positions; `foul_correction` is added to the value of a foul.
    pub(crate) fn race(&self, prepared: &'a [Prepared<'a>], foul_correction: f64) -> Race<'a> {
        let (shot, runner) = (self.shot, &self.budget.runner);
        Race { shot, prepared, runner, common_errors: self.settings.common_errors, foul_correction }
    }
}

impl Race<'_> {
    /// Orders `candidates` by their values, the best first, with at most `simulations` samples.
    /// Returns their number.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    pub(crate) fn run(&self, candidates: &mut [Candidate], simulations: u64) -> Result<u64, Error> {
        let mut left = candidates.len();
        let mut spent = 0;
        // The number of times that `left` is halved, rounded up, until one is left.
        let heats = u64::from(usize::BITS - left.saturating_sub(1).leading_zeros()).max(1);
        while left > 0 {
            let samples = simulations / heats / left as u64;
            if samples == 0 && left > 1 {
                // Too few for all: the priors decide who is played at all.
                left = left.div_ceil(2);
                continue;
            }
            let samples = samples.max(1);
            let first = |candidate: &Candidate| candidate.samples.len() as u64;
            let jobs = candidates[..left].iter().enumerate();
            let jobs = jobs.map(|(k, candidate)| (k, first(candidate), samples)).collect();
            let played = self.sample(candidates, jobs)?;
            for (k, chunk) in played {
                spent += chunk.len() as u64;
                candidates[k].samples.extend(chunk);
            }
            candidates[..left].sort_by(|a, b| b.mean().total_cmp(&a.mean()));
            left = if left > 2 { left.div_ceil(2) } else { 0 };
        }
        Ok(spent)
    }

    /// Adds samples to the candidates that have fewer than `least`. Returns their number.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    pub(crate) fn fill(&self, candidates: &mut [Candidate], least: u64) -> Result<u64, Error> {
        let have = |candidate: &Candidate| candidate.samples.len() as u64;
        let few = candidates.iter().enumerate().filter(|(_, candidate)| have(candidate) < least);
        let jobs =
            few.map(|(k, candidate)| (k, have(candidate), least - have(candidate))).collect();
        let mut spent = 0;
        for (k, chunk) in self.sample(candidates, jobs)? {
            spent += chunk.len() as u64;
            candidates[k].samples.extend(chunk);
        }
        Ok(spent)
    }

    /// Adds `samples` fresh samples to each candidate. Returns their number.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    pub(crate) fn freshen(&self, candidates: &mut [Candidate], samples: u64) -> Result<u64, Error> {
        let first = |candidate: &Candidate| FRESH + candidate.fresh.len() as u64;
        let jobs = candidates.iter().enumerate();
        let jobs = jobs.map(|(k, candidate)| (k, first(candidate), samples)).collect();
        let mut spent = 0;
        for (k, chunk) in self.sample(candidates, jobs)? {
            spent += chunk.len() as u64;
            candidates[k].fresh.extend(chunk);
        }
        Ok(spent)
    }

    /// Plays variants of candidates: of each its number, the number of the first variant, and how
    /// many. Returns chunks of them with the candidate's number, in order.
    fn sample(
        &self,
        candidates: &[Candidate],
        wanted: Vec<(usize, u64, u64)>,
    ) -> Result<Vec<(usize, Vec<PlayedVariant>)>, Error> {
        let jobs = wanted.into_iter().flat_map(|(k, first, samples)| {
            let end = first + samples;
            let starts = (first..end).step_by(CHUNK as usize);
            starts.map(move |from| (k, from..(from + CHUNK).min(end)))
        });
        let played = self.runner.map(
            jobs,
            || Workbench::new(self.shot.frame()),
            |bench, (k, indices)| Ok((k, self.play(&candidates[k], bench, indices)?)),
        );
        played.into_iter().collect()
    }

    /// Plays variants of one candidate.
    fn play(
        &self,
        candidate: &Candidate,
        bench: &mut Workbench,
        indices: Range<u64>,
    ) -> Result<Vec<PlayedVariant>, Error> {
        let Workbench { sampler, successor, .. } = bench;
        let prepared = &self.prepared[candidate.place];
        let (errors, struck) = (self.errors_of(candidate), prepared.struck_ball());
        let (cue, even) = (prepared.turn().cue, EvenErrors::new(errors.seed));
        let mut samples = Vec::with_capacity(CHUNK as usize);
        for index in indices {
            let meant = &candidate.play.strike;
            // Stated chances are counted with drawn errors.
            let executed = if index < FRESH {
                errors.noise.apply(meant, &struck, even.deviates(index))
            } else {
                errors.noise.draw(meant, &struck, errors.seed, index)
            };
            sampler.simulate_executed(prepared, &executed, &errors, index)?;
            let ruling = sampler.rule(prepared, candidate.play.call, successor)?;
            let foul = !ruling.is_legal();
            let position = Position { frame: successor, noise: &self.shot.situation.noise };
            let value = self.shot.value.win_chance(&position, self.shot.seat());
            let value = if foul { (value + self.foul_correction).clamp(0.0, 1.0) } else { value };
            let kept = successor.keeps_turn(self.shot.seat());
            let end = successor.layout().place(cue);
            samples.push(PlayedVariant { index, executed, value, kept, foul, end });
        }
        Ok(samples)
    }

    /// The errors with which the player executes a candidate.
    pub(crate) fn errors_of(&self, candidate: &Candidate) -> Errors {
        let own = if self.common_errors { 0 } else { candidate.play.strike.azimuth.to_bits() };
        let Situation { perception, seed, .. } = self.shot.situation;
        let (noise, perception) = (self.shot.noise().clone(), perception.clone());
        Errors { noise, perception, seed: seed ^ own }
    }
}
