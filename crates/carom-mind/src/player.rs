//! The interface of players: their situation, their budget, and their answer.

use carom::noise::Perception;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Noise};
use carom_rules::{Choice, Frame, Play, Request, Seat};

/// What a player knows before a decision.
#[derive(Clone, Debug)]
pub struct Situation<'a> {
    /// The frame. It must not be over.
    pub frame: &'a Frame,
    /// The errors of the strikes of seat 0 and seat 1.
    pub noise: [Noise; 2],
    /// The errors with which the player sees the balls. The layout of `frame` is the perceived one.
    pub perception: Perception,
    /// Seed of the random numbers of the decision.
    pub seed: u64,
}

impl<'a> Situation<'a> {
    /// A situation in which both players have the same errors and see the balls exactly.
    pub fn new(frame: &'a Frame, noise: Noise, seed: u64) -> Self {
        Self { frame, noise: [noise.clone(), noise], perception: Perception::default(), seed }
    }

    /// The seat that has to answer, and its request.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over, and for a noise or a perception out of range.
    pub fn asked(&self) -> Result<(Seat, &'a Request), Error> {
        for noise in &self.noise {
            noise.check()?;
        }
        self.perception.check()?;
        let seat = self.frame.player().ok_or_else(|| {
            ErrorKind::FrameOver.at(
                "frame",
                "it is over, so there is nothing to choose",
                "begin a new frame",
            )
        })?;
        Ok((seat, self.frame.request()))
    }
}

/// What a decision has spent so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// Number of simulated shots.
    pub simulations: u64,
    /// Number of completed rounds of the search.
    pub rounds: u32,
}

/// How much a player may spend on a decision.
pub struct Budget<'a> {
    /// Largest number of simulated shots. A round that would exceed it is not begun, except for the
    /// first round of a search: every decision costs at least that.
    pub simulations: u64,
    /// Largest number of rounds; `None` if only the simulations limit them. With the number of
    /// rounds of an earlier decision the decision is repeated, even if a clock ended the earlier one.
    pub rounds: Option<u32>,
    /// Asked after every round: whether to end the search now. A wall clock or Ctrl-C.
    pub is_over: &'a (dyn Fn(Spent) -> bool + Sync),
    /// The threads that work. The decision does not depend on their number.
    pub runner: Runner,
}

impl Budget<'_> {
    /// At most this many simulated shots, on the calling thread.
    pub fn simulations(simulations: u64) -> Self {
        let runner = Runner::new(Some(1)).unwrap_or_default();
        Self { simulations, rounds: None, is_over: &|_| false, runner }
    }

    /// Whether another round of `cost` simulations may begin.
    pub fn allows(&self, spent: Spent, cost: u64) -> bool {
        let in_rounds = self.rounds.is_none_or(|rounds| spent.rounds < rounds);
        let in_simulations = spent.simulations.saturating_add(cost) <= self.simulations;
        spent.rounds == 0 || (in_rounds && in_simulations && !(self.is_over)(spent))
    }
}

/// The answer to a request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// A shot, as it is intended.
    Play(Play),
    /// A choice.
    Choice(Choice),
    /// The frame is given up.
    Concede,
}

/// A player's decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The answer to the request.
    pub answer: Answer,
    /// The probability with which the player expects to win the frame, 0 to 1; `None` for players
    /// that do not estimate it.
    pub win_chance: Option<f64>,
    /// What the decision cost.
    pub spent: Spent,
}

/// A program that answers the requests of a frame.
pub trait Player: Send {
    /// The player's name in tables and records.
    fn name(&self) -> &str;

    /// The answer to the request of the situation's frame.
    ///
    /// # Errors
    /// As [`Situation::asked`].
    fn decide(&mut self, situation: &Situation<'_>, budget: &Budget<'_>)
    -> Result<Decision, Error>;
}
