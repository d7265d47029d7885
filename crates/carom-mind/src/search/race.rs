//! The race between candidates with common errors: all are played with the same errors, which are
//! spread evenly.
//!
//! It is sequential halving (Karnin, Koren & Somekh 2013): heats of equal cost, each of which drops the worse
//! half.

use core::ops::Range;

use carom::Error;
use carom::runner::Runner;
use carom_rules::{Frame, Seat};

use super::candidate::{Candidate, PlayedVariant};
use super::even_errors::EvenErrors;
use crate::player::Situation;
use crate::value::{Position, Value};
use carom::noise::Errors;
use carom_plan::{Prepared, Sampler};

/// Samples of a candidate that one thread plays at a time: about a tenth of a millisecond of work.
const CHUNK: u64 = 8;
/// Number of the first errors that take no part in a choice. No race plays so many.
const FRESH: u64 = 1 << 40;

/// What is raced.
#[derive(Clone, Copy)]
pub(crate) struct Race<'a> {
    pub(crate) situation: &'a Situation<'a>,
    pub(crate) value: &'a dyn Value,
    pub(crate) prepared: &'a [Prepared<'a>],
    pub(crate) seat: Seat,
    pub(crate) runner: &'a Runner,
    /// Whether all candidates have the same errors.
    pub(crate) common_errors: bool,
    /// What is added to the value of a foul.
    pub(crate) foul_correction: f64,
}

impl Race<'_> {
    /// Orders `candidates` by their values, the best first, with at most `simulations` samples.
    /// Returns their number.
    ///
    /// # Errors
    /// As [`Sampler::simulate_variant`].
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
    /// As [`Sampler::simulate_variant`].
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
    /// As [`Sampler::simulate_variant`].
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
            || (Sampler::new(), self.situation.frame.clone()),
            |(sampler, successor), (k, indices)| {
                let chunk = self.play(&candidates[k], (sampler, successor), indices)?;
                Ok((k, chunk))
            },
        );
        played.into_iter().collect()
    }

    /// Plays variants of one candidate. The last successor stays in `successor`.
    pub(crate) fn play(
        &self,
        candidate: &Candidate,
        (sampler, successor): (&mut Sampler, &mut Frame),
        indices: Range<u64>,
    ) -> Result<Vec<PlayedVariant>, Error> {
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
            let position = Position { frame: successor, noise: &self.situation.noise };
            let value = self.value.win_chance(&position, self.seat);
            let value = if foul { (value + self.foul_correction).clamp(0.0, 1.0) } else { value };
            let kept = successor.keeps_turn(self.seat);
            let end = successor.layout().place(cue);
            samples.push(PlayedVariant { index, executed, value, kept, foul, end });
        }
        Ok(samples)
    }

    /// The errors with which the player executes a candidate.
    pub(crate) fn errors_of(&self, candidate: &Candidate) -> Errors {
        let own = if self.common_errors { 0 } else { candidate.play.strike.azimuth.to_bits() };
        Errors {
            noise: self.situation.noise[self.seat].clone(),
            perception: self.situation.perception.clone(),
            seed: self.situation.seed ^ own,
        }
    }
}
