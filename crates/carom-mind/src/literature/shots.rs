//! Shots: lines turned into strikes, and strikes played with errors.

use core::f64::consts::TAU;
use core::ops::Range;
use std::sync::Arc;

use carom::resolve::cue_ball::{Strike, squirt};
use carom::{Error, Noise};
use carom_rules::{Frame, Play, Turn};

use super::pot_table::PotTable;
use crate::aim::{AimStart, aim};
use crate::line::{self, Line, LineKind};
use crate::scene::Scene;
use crate::search::{CuePlace, largest_offset};
use crate::targets::{Targets, call_of};
use crate::workbench::Workbench;
use carom::noise::Errors;
use carom_plan::Prepared;

/// Lines that are less probable than this are not played on purpose.
const LEAST_CHANCE: f64 = 0.02;
/// Failed strikes after which a line without a successful one is given up.
const MOST_FAILURES: u32 = 3;
/// Largest correction (rad) of a line's direction that is used again for a similar strike.
const LARGEST_CORRECTION: f64 = 0.03;

/// A way to strike the cue ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stroke {
    /// The cue's speed, m/s.
    pub(crate) speed: f64,
    /// The tip's offset to the side and in height, as shares of the largest that is used, −1 to 1.
    pub(crate) side: f64,
    pub(crate) height: f64,
}

impl Stroke {
    /// A strike at the ball's centre; `speed` in m/s.
    pub(crate) const fn plain(speed: f64) -> Self {
        Self { speed, side: 0.0, height: 0.0 }
    }

    /// The tip offsets (ball radii) on a ball whose largest offset is `most`: shares outside the unit
    /// circle are moved back onto it.
    fn offsets(self, most: f64) -> [f64; 2] {
        let out = carom::math::sqrt(self.side * self.side + self.height * self.height).max(1.0);
        [most * self.side / out, most * self.height / out]
    }
}

/// What a player knows when it looks for shots of one request.
#[derive(Clone, Debug)]
pub(crate) struct Sight<'a> {
    pub(crate) turn: &'a Turn,
    pub(crate) targets: Targets,
    /// The player's potting probabilities.
    pub(crate) table: Arc<PotTable>,
    pub(crate) noise: Noise,
    /// The cue ball's radius, m.
    pub(crate) radius: f64,
}

impl<'a> Sight<'a> {
    pub(crate) fn new(frame: &Frame, turn: &'a Turn, table: Arc<PotTable>, noise: Noise) -> Self {
        let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
        Self { turn, targets: Targets::of(frame, turn), table, noise, radius }
    }

    /// The lines of these kinds with their probabilities, the most probable first.
    pub(crate) fn lines(&self, prepared: &Prepared<'_>, kinds: &[LineKind]) -> Vec<(Line, f64)> {
        let scene = Scene::of(prepared);
        let mut lines = Vec::new();
        for kind in kinds {
            match kind {
                LineKind::Direct => line::direct(&scene, &self.targets, &mut lines),
                LineKind::Bank => line::banks(&scene, &self.targets, &mut lines),
                LineKind::Kick => line::kicks(&scene, &self.targets, &mut lines),
                LineKind::Combination => line::combinations(&scene, &self.targets, &mut lines),
            }
        }
        let rated = lines.into_iter().map(|line| (line, self.table.chance(&line, self.radius)));
        let mut rated: Vec<_> = rated.filter(|(_, chance)| *chance > LEAST_CHANCE).collect();
        rated.sort_by(|a, b| b.1.total_cmp(&a.1));
        rated
    }

    /// The largest tip offset of intended strikes, ball radii. Guess: that of the searching player. The Olympiad's
    /// engine had no miscues, so the papers do not discuss it.
    pub(crate) fn largest_offset(&self, prepared: &Prepared<'_>) -> f64 {
        largest_offset(prepared.shot(), &self.noise, self.radius)
    }
}

/// A shot that pots a ball without errors.
#[derive(Clone, Debug)]
pub(crate) struct PotShot {
    pub(crate) line: Line,
    pub(crate) stroke: Stroke,
    pub(crate) play: Play,
    /// The table's probability of the pot.
    pub(crate) chance: f64,
    /// Number of the place of a cue ball in hand.
    pub(crate) place: usize,
    /// The frame after the shot without errors.
    pub(crate) successor: Frame,
}

impl Workbench {
    /// The shots along `lines` with each of `strokes` that pot their balls legally. The first stroke
    /// is tried on every line, then the second one. Ends after `most` simulations.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::rule`].
    pub(crate) fn pot_shots(
        &mut self,
        sight: &Sight<'_>,
        at: CuePlace<'_>,
        lines: &[(Line, f64)],
        strokes: &[Stroke],
        most: u64,
    ) -> Result<Vec<PotShot>, Error> {
        let end = self.plays + most;
        let mut found: Vec<PotShot> = Vec::new();
        let mut known = vec![Correction::default(); lines.len()];
        for stroke in strokes {
            for ((line, chance), known) in lines.iter().zip(&mut known) {
                if self.plays >= end {
                    return Ok(found);
                }
                if known.is_hopeless() {
                    continue;
                }
                let play = self.aimed(sight, at.prepared, line, *stroke, known)?;
                known.failures += u32::from(play.is_none());
                known.has_success |= play.is_some();
                let Some(play) = play else { continue };
                let (line, successor) = (*line, self.successor.clone());
                let (stroke, chance, place) = (*stroke, *chance, at.number);
                found.push(PotShot { line, stroke, play, chance, place, successor });
            }
        }
        Ok(found)
    }

    /// The play that pots the ball of `line` with `stroke`; none if none does legally. Afterwards
    /// [`Self::successor`] is the frame after that play.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::rule`].
    pub(crate) fn aimed(
        &mut self,
        sight: &Sight<'_>,
        prepared: &Prepared<'_>,
        line: &Line,
        stroke: Stroke,
        known: &mut Correction,
    ) -> Result<Option<Play>, Error> {
        let strike = known.start(sight, prepared, line, stroke);
        let start = AimStart { strike, slope: known.slope.unwrap_or(line.slope) };
        let aimed = aim(&mut self.sampler, prepared, line, start, &mut self.plays)?;
        let Some(aimed) = aimed.filter(|aimed| aimed.is_potted) else { return Ok(None) };
        if line.kind == LineKind::Direct {
            let turned = known.turned + aimed.strike.azimuth - strike.azimuth;
            known.turned = turned.clamp(-LARGEST_CORRECTION, LARGEST_CORRECTION);
        }
        known.slope = Some(aimed.slope);
        let pot = line.pot(prepared.shot().table());
        let call = call_of(sight.turn, line.first, Some(pot));
        let is_legal = self.sampler.rule(prepared, call, &mut self.successor)?.is_legal();
        let play = Play { cue_ball: prepared.cue_ball(), call, ..Play::new(aimed.strike) };
        Ok(is_legal.then_some(play))
    }

    /// Plays `play` with the errors of `indices` and passes each successor, and whether the player
    /// keeps the turn or wins, to `each`.
    ///
    /// # Errors
    /// As [`carom_plan::Sampler::simulate_variant`].
    pub(crate) fn sample(
        &mut self,
        prepared: &Prepared<'_>,
        play: &Play,
        errors: &Errors,
        indices: Range<u64>,
        mut each: impl FnMut(&Frame, bool),
    ) -> Result<(), Error> {
        let seat = prepared.frame().player().unwrap_or_default();
        for index in indices {
            self.sampler.simulate_variant(prepared, &play.strike, errors, index)?;
            self.sampler.rule(prepared, play.call, &mut self.successor)?;
            self.plays += 1;
            each(&self.successor, self.successor.keeps_turn(seat));
        }
        Ok(())
    }
}

/// What the strikes along a line so far have shown.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Correction {
    /// Azimuth of the last success minus that of geometry, rad.
    turned: f64,
    /// Change of the miss per azimuth, m per rad.
    slope: Option<f64>,
    failures: u32,
    has_success: bool,
}

impl Correction {
    const fn is_hopeless(&self) -> bool {
        !self.has_success && self.failures >= MOST_FAILURES
    }

    /// The strike with which the aiming starts: the azimuth of geometry, corrected for squirt and by
    /// the last success.
    fn start(
        &self,
        sight: &Sight<'_>,
        prepared: &Prepared<'_>,
        line: &Line,
        stroke: Stroke,
    ) -> Strike {
        let shot = prepared.shot();
        let [side, height] = stroke.offsets(sight.largest_offset(prepared));
        let ball = shot.strike().map_or(0, |(ball, _)| ball);
        let squirt = squirt(&shot.physics().cue, &shot.balls()[ball].ball, side);
        let azimuth = line.azimuth - squirt + self.turned;
        let strike = Strike { speed: stroke.speed, azimuth, elevation: 0.0, side, height };
        Strike { elevation: shot.default_elevation(&strike), ..strike }
    }
}

/// The strike along a line by geometry alone, without correction for throw.
pub(crate) fn geometric(
    sight: &Sight<'_>,
    prepared: &Prepared<'_>,
    line: &Line,
    speed: f64,
) -> Play {
    let strike = Correction::default().start(sight, prepared, line, Stroke::plain(speed));
    let pot = line.pot(prepared.shot().table());
    let call = call_of(sight.turn, line.first, Some(pot));
    Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) }
}

/// Strokes spread evenly over speeds from `low` to `high` (m/s, evenly on a logarithmic scale) and over
/// the disc of tip offsets: the additive recurrence of Roberts (2018) with the powers of 1/φ₃, where φ₃
/// is the real root of x⁴ = x + 1. `first` chooses the part of the sequence.
pub(crate) fn sampled_strokes(first: u64, [low, high]: [f64; 2]) -> impl Iterator<Item = Stroke> {
    const STEPS: [f64; 3] =
        [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_2];
    (first + 1..).map(move |k| {
        let [pace, turn, out] = STEPS.map(|step| (0.5 + step * k as f64) % 1.0);
        let (sin, cos) = carom::math::sin_cos(TAU * turn);
        let out = carom::math::sqrt(out);
        let speed = low * libm::pow(high / low, pace);
        Stroke { speed, side: out * cos, height: out * sin }
    })
}
