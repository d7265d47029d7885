//! Sequential halving (Karnin, Koren & Somekh 2013) with common errors: all candidates are played
//! with the same drawn errors, in heats of equal cost, and each heat drops the worse half.

use core::ops::Range;

use carom::Error;
use carom::runner::Runner;
use carom_rules::{Frame, Request, Seat};

use super::candidate::{Candidate, PlayedVariant};
use crate::player::Situation;
use crate::value::{Position, Value};
use carom::noise::Errors;
use carom_plan::{Prepared, Sampler};

/// Samples of a candidate that one thread plays at a time: about a tenth of a millisecond of work.
const CHUNK: u64 = 8;
/// Number of the first errors that take no part in a choice. No race plays so many.
const FRESH: u64 = 1 << 40;

/// What is raced.
pub(crate) struct Race<'a> {
    pub(crate) situation: &'a Situation<'a>,
    pub(crate) value: &'a dyn Value,
    pub(crate) prepared: &'a [Prepared<'a>],
    pub(crate) seat: Seat,
    pub(crate) runner: &'a Runner,
    /// Whether all candidates have the same drawn errors.
    pub(crate) common_errors: bool,
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
            let played = self.sample(&candidates[..left], samples, first)?;
            for (k, chunk) in played {
                spent += chunk.len() as u64;
                candidates[k].samples.extend(chunk);
            }
            candidates[..left].sort_by(|a, b| b.mean().total_cmp(&a.mean()));
            left = if left > 2 { left.div_ceil(2) } else { 0 };
        }
        Ok(spent)
    }

    /// Adds `samples` fresh samples to each candidate. Returns their number.
    ///
    /// # Errors
    /// As [`Sampler::simulate_variant`].
    pub(crate) fn freshen(&self, candidates: &mut [Candidate], samples: u64) -> Result<u64, Error> {
        let first = |candidate: &Candidate| FRESH + candidate.fresh.len() as u64;
        let mut spent = 0;
        for (k, chunk) in self.sample(candidates, samples, first)? {
            spent += chunk.len() as u64;
            candidates[k].fresh.extend(chunk);
        }
        Ok(spent)
    }

    /// Plays `samples` variants of each candidate, from number `first` on. Returns chunks of them
    /// with the candidate's number, in order.
    fn sample(
        &self,
        candidates: &[Candidate],
        samples: u64,
        first: impl Fn(&Candidate) -> u64,
    ) -> Result<Vec<(usize, Vec<PlayedVariant>)>, Error> {
        let jobs = candidates.iter().enumerate().flat_map(|(k, candidate)| {
            let first = first(candidate);
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

    /// Plays variants of one candidate.
    fn play(
        &self,
        candidate: &Candidate,
        (sampler, successor): (&mut Sampler, &mut Frame),
        indices: Range<u64>,
    ) -> Result<Vec<PlayedVariant>, Error> {
        let prepared = &self.prepared[candidate.place];
        let (errors, struck) = (self.errors_of(candidate), prepared.struck_ball());
        let cue = prepared.turn().cue;
        let mut samples = Vec::with_capacity(CHUNK as usize);
        for index in indices {
            let meant = &candidate.play.strike;
            let executed = errors.noise.draw(meant, &struck, errors.seed, index);
            sampler.simulate_variant(prepared, meant, &errors, index)?;
            let ruling = sampler.rule(prepared, candidate.play.call, successor)?;
            let foul = !ruling.is_legal();
            let position = Position { frame: successor, noise: &self.situation.noise };
            let value = self.value.win_chance(&position, self.seat);
            let kept = keeps_turn(successor, self.seat);
            let end = successor.layout().place(cue);
            samples.push(PlayedVariant { index, executed, value, kept, foul, end });
        }
        Ok(samples)
    }

    /// The errors with which the player executes a candidate.
    pub(crate) fn errors_of(&self, candidate: &Candidate) -> Errors {
        let own = if self.common_errors { 0 } else { candidate.play.strike.azimuth.to_bits() };
        Errors {
            noise: self.situation.noise[self.seat],
            perception: self.situation.perception,
            seed: self.situation.seed ^ own,
        }
    }
}

/// Whether `seat` shoots next or has won.
pub(crate) fn keeps_turn(frame: &Frame, seat: Seat) -> bool {
    match frame.request() {
        Request::Shot(turn) => turn.player == seat,
        Request::Choice { .. } => false,
        Request::Over { winner, .. } => *winner == Some(seat),
    }
}
