//! Finding candidates without errors.
//!
//! The kinds of plays have a file each, with methods of [`Explorer`]: `pots`, `windows`, `safeties`, `caroms`,
//! `openings`. `refine` has the neighbours of known plays, and `naming` says what a play does.
//!
//! A method that takes `until` ends when that many simulations have been played in all.

use carom::Error;
use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{BallIndex, Call, Play};

use super::candidate::{Candidate, PlayKind};
use super::task::ShotTask;
use crate::line::Line;
use crate::targets::Targets;
use crate::value::Position;
use crate::workbench::Workbench;
use carom_plan::Prepared;

/// A prepared position, one for each place of a cue ball in hand.
#[derive(Clone, Copy)]
pub(crate) struct CuePlace<'a> {
    /// Its number among the prepared positions.
    pub(crate) number: usize,
    pub(crate) prepared: &'a Prepared<'a>,
}

/// The prepared positions with their numbers.
pub(crate) fn cue_places<'a>(prepared: &'a [Prepared<'a>]) -> impl Iterator<Item = CuePlace<'a>> {
    prepared.iter().enumerate().map(|(number, prepared)| CuePlace { number, prepared })
}

/// A play that an exploration has found.
pub(crate) struct FoundPlay {
    /// The strike as it was simulated.
    pub(crate) strike: Strike,
    pub(crate) call: Call,
    pub(crate) kind: PlayKind,
    /// The line of a pot.
    pub(crate) line: Option<Line>,
    /// Its estimated value.
    pub(crate) prior: f64,
}

/// The speeds of other shots than the opening one: anything above 0.
const ANY_SPEED: [f64; 2] = [f64::MIN_POSITIVE, f64::INFINITY];

/// Finds candidates for one shot.
pub(crate) struct Explorer<'a> {
    pub(crate) task: ShotTask<'a>,
    pub(crate) targets: Targets,
    pub(crate) bench: Workbench,
    pub(crate) found: Vec<Candidate>,
    /// Whether all lines are tried for a list of plays, also those that are much less probable than the best.
    pub(crate) is_list: bool,
    /// Whether the windows of pots are measured, with about ten simulations of each. The first round has too few.
    pub(crate) measures_windows: bool,
}

impl<'a> Explorer<'a> {
    pub(crate) fn new(task: ShotTask<'a>) -> Self {
        let targets = Targets::of(task.frame(), task.turn);
        let bench = Workbench::new(task.frame());
        Self { task, targets, bench, found: Vec::new(), is_list: false, measures_windows: false }
    }

    /// Least and greatest speed of the cue near the best plays, m/s.
    pub(crate) fn speeds(&self) -> [f64; 2] {
        let frame = self.task.frame();
        if frame.is_opening() { frame.facts().opening.speeds } else { ANY_SPEED }
    }

    /// The value of the last ruled simulation for the player.
    pub(crate) fn value_of_successor(&self) -> f64 {
        let position = Position { frame: &self.bench.successor, noise: &self.task.situation.noise };
        self.task.value.win_chance(&position, self.task.seat())
    }

    /// Whether the player has the turn, or has won, after the last ruled simulation.
    pub(crate) fn keeps_turn(&self) -> bool {
        self.bench.successor.keeps_turn(self.task.seat())
    }

    /// Rules on the last simulation under `call`, and returns its value for the player and whether
    /// it was legal.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::rule`].
    pub(crate) fn ruled(
        &mut self,
        prepared: &Prepared<'_>,
        call: Call,
    ) -> Result<(f64, bool), Error> {
        let Workbench { sampler, successor, .. } = &mut self.bench;
        let is_legal = sampler.rule(prepared, call, successor)?.is_legal();
        Ok((self.value_of_successor(), is_legal))
    }

    /// The first of the balls that the player may pot that fell in the last simulation, and its pocket.
    pub(crate) fn potted(&self) -> Option<(BallIndex, PocketName)> {
        let fallen = self.bench.sampler.outcome().pocketed.iter().copied();
        fallen.into_iter().find(|(ball, _)| self.targets.objects.contains(ball))
    }

    /// Keeps a play as a candidate; the last ruled simulation is that of the play.
    pub(crate) fn keep(&mut self, at: CuePlace<'_>, found: FoundPlay) {
        let FoundPlay { strike, call, kind, line, prior } = found;
        let CuePlace { number: place, prepared } = at;
        let pot = match kind {
            PlayKind::Indirect => self.potted(),
            _ => line.map(|line| line.pot(prepared.shot().table())),
        };
        // The strike was simulated as it is executed; a player with a bias means another one.
        let strike = self.task.noise().aim_for(&strike, &prepared.struck_ball());
        self.found.push(Candidate {
            play: Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) },
            kind,
            line,
            pot,
            legs: Vec::new(),
            pattern: if kind == PlayKind::Carom { self.carom_pattern(prepared) } else { None },
            route: None,
            place,
            prior,
            end: self.bench.successor.layout().place(self.task.turn.cue),
            samples: Vec::new(),
            fresh: Vec::new(),
            correction: 0.0,
        });
    }
}

/// The strike at its default elevation.
pub(crate) fn raised(prepared: &Prepared<'_>, strike: Strike) -> Strike {
    Strike { elevation: prepared.shot().default_elevation(&strike), ..strike }
}
