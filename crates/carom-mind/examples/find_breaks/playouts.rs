//! Frames that are played to their end after a break.

use carom::noise::{Errors, Perception};
use carom::runner::Runner;
use carom::{Error, Noise};
use carom_mind::breaks::BreakShot;
use carom_mind::value::Logistic;
use carom_mind::{Answer, Budget, Player, SearchSettings, Searcher, Situation};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Frame, Request, Seat};

/// The breaker's seat.
const BREAKER: Seat = 0;
/// Shots after which a frame counts as half a win.
const MOST_SHOTS: u64 = 200;
/// Factor of the seeds of the decisions, so that those of two frames differ.
const DECISIONS: u64 = 1 << 16;

/// Frames between two equal searching players, from the break on.
pub(crate) struct Playouts<'a> {
    /// A frame before its break.
    pub(crate) start: &'a Frame,
    /// The errors of both players.
    pub(crate) noise: Noise,
    /// Simulations of a decision.
    pub(crate) simulations: u64,
}

impl Playouts<'_> {
    /// The share of the frames with these numbers that the breaker wins with `shot`. Frame k has the
    /// same rack and the same errors for all breaks.
    ///
    /// # Errors
    /// The first error of a frame.
    pub(crate) fn share(
        &self,
        shot: &BreakShot,
        numbers: core::ops::Range<u64>,
        runner: &Runner,
    ) -> Result<f64, Error> {
        let count = numbers.end - numbers.start;
        let worker = || (Sampler::new(), self.start.clone());
        let points = runner.map(numbers, worker, |worker, number| self.play(shot, number, worker));
        Ok(points.into_iter().sum::<Result<f64, Error>>()? / count as f64)
    }

    /// The breaker's points in frame `number`: 1 for a win, 0.5 for a frame without a winner.
    fn play(
        &self,
        shot: &BreakShot,
        number: u64,
        (sampler, successor): &mut (Sampler, Frame),
    ) -> Result<f64, Error> {
        let settings = SearchSettings::default();
        let mut player = Searcher::new("carom", Box::new(Logistic), settings)?;
        let errors = Errors { noise: self.noise, perception: Perception::default(), seed: number };
        let mut frame = self.start.with_seed(number)?;
        for index in 0..MOST_SHOTS {
            let play = loop {
                if let Request::Over { winner, .. } = frame.request() {
                    return Ok(winner.map_or(0.5, |seat| f64::from(u8::from(seat == BREAKER))));
                }
                if frame.is_opening() {
                    break shot.play(&frame)?;
                }
                let seed = number.wrapping_mul(DECISIONS) + index;
                let situation = Situation::new(&frame, self.noise, seed);
                let decision = player.decide(&situation, &Budget::simulations(self.simulations))?;
                match decision.answer {
                    Answer::Play(play) => break play,
                    Answer::Choice(choice) => {
                        frame.choose(choice)?;
                    }
                    Answer::Concede => {
                        return Ok(f64::from(u8::from(frame.player() != Some(BREAKER))));
                    }
                }
            };
            let prepared = Prepared::new(&frame, play.cue_ball)?;
            sampler.simulate_variant(&prepared, &play.strike, &errors, index)?;
            sampler.rule(&prepared, play.call, successor)?;
            drop(prepared);
            core::mem::swap(&mut frame, successor);
        }
        Ok(0.5)
    }
}
