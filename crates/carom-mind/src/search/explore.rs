//! Finding candidates without errors.

use carom::Error;
use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{BallIndex, Call, Frame, Play, Seat, Turn};

use super::candidate::{Candidate, PlayKind};
use crate::breaks::speeds;
use crate::line::Line;
use crate::player::Situation;
use crate::targets::Targets;
use crate::value::{Position, Value};
use carom_plan::{Prepared, Sampler};

/// A pot on a direct line, and its azimuth.
pub(crate) type DirectPot = ((BallIndex, PocketName), f64);

/// The speeds of other shots than the opening one: anything above 0.
const ANY_SPEED: [f64; 2] = [f64::MIN_POSITIVE, f64::INFINITY];

/// Finds candidates for one request.
pub(crate) struct Explorer<'a> {
    pub(crate) situation: &'a Situation<'a>,
    pub(crate) value: &'a dyn Value,
    pub(crate) turn: &'a Turn,
    pub(crate) targets: Targets,
    pub(crate) sampler: Sampler,
    /// The successor of the last ruled simulation.
    pub(crate) successor: Frame,
    /// Number of simulations so far.
    pub(crate) plays: u64,
    /// Most simulations.
    pub(crate) most: u64,
    /// Least and greatest speed of the cue near the best plays, m/s.
    pub(crate) speeds: [f64; 2],
    pub(crate) found: Vec<Candidate>,
    /// Whether all lines are tried for a list of plays, also those that are much less probable than the best.
    pub(crate) lists: bool,
    /// Whether the windows of pots are measured, which takes about ten simulations of each.
    pub(crate) measures_windows: bool,
    /// The pots of direct lines, which no other strike needs to make.
    pub(crate) direct_pots: Vec<DirectPot>,
}

impl<'a> Explorer<'a> {
    pub(crate) fn new(
        situation: &'a Situation<'a>,
        value: &'a dyn Value,
        turn: &'a Turn,
        most: u64,
    ) -> Self {
        let frame = situation.frame;
        Self {
            situation,
            value,
            turn,
            targets: Targets::of(frame, turn),
            sampler: Sampler::new(),
            successor: frame.clone(),
            plays: 0,
            most,
            speeds: if frame.is_opening() { speeds(frame.rules()) } else { ANY_SPEED },
            found: Vec::new(),
            lists: false,
            measures_windows: false,
            direct_pots: Vec::new(),
        }
    }

    pub(crate) const fn seat(&self) -> Seat {
        self.turn.player
    }

    pub(crate) const fn is_spent(&self) -> bool {
        self.plays >= self.most
    }

    /// The value of the last ruled simulation for the player.
    pub(crate) fn value_of_successor(&self) -> f64 {
        let position = Position { frame: &self.successor, noise: &self.situation.noise };
        self.value.win_chance(&position, self.seat())
    }

    /// Rules on the last simulation under `call`, and returns its value for the player and whether
    /// it was legal.
    ///
    /// # Errors
    /// As [`Sampler::rule`].
    pub(crate) fn ruled(
        &mut self,
        prepared: &Prepared<'_>,
        call: Call,
    ) -> Result<(f64, bool), Error> {
        let is_legal = self.sampler.rule(prepared, call, &mut self.successor)?.is_legal();
        Ok((self.value_of_successor(), is_legal))
    }

    /// The first of the balls that the player may pot that fell in the last simulation, and its pocket.
    pub(crate) fn potted(&self) -> Option<(BallIndex, PocketName)> {
        let fallen = self.sampler.outcome().pocketed.iter().copied();
        fallen.into_iter().find(|(ball, _)| self.targets.objects.contains(ball))
    }

    /// Keeps a play as a candidate; the last ruled simulation is that of the play.
    pub(crate) fn keep(
        &mut self,
        strike: Strike,
        call: Call,
        (kind, line, prior): (PlayKind, Option<Line>, f64),
        (place, prepared): (usize, &Prepared<'_>),
    ) {
        let pot = match kind {
            PlayKind::Indirect => self.potted(),
            _ => line.map(|line| line.pot(prepared.shot().table())),
        };
        // The strike was simulated as it is executed; a player with a bias means another one.
        let noise = &self.situation.noise[self.seat()];
        let strike = noise.aim_for(&strike, &prepared.struck_ball());
        self.found.push(Candidate {
            play: Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) },
            kind,
            line,
            pot,
            legs: Vec::new(),
            place,
            prior,
            end: self.successor.layout().place(self.turn.cue),
            samples: Vec::new(),
            fresh: Vec::new(),
            correction: 0.0,
        });
    }

    /// The strike at its default elevation.
    pub(crate) fn raised(prepared: &Prepared<'_>, strike: Strike) -> Strike {
        Strike { elevation: prepared.shot().default_elevation(&strike), ..strike }
    }
}
