//! Candidates that pot a ball: a lattice of speed × height × side on every line.

use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise, Shot};

use super::candidate::PlayKind;
use super::explore::Explorer;
use crate::aim::aim;
use crate::line::{self, Line, LineKind};
use crate::scene::Scene;
use crate::targets::call_of;
use carom_plan::Prepared;

/// Cue speeds, m/s, from a ball that hangs in the pocket to a stroke along the table and back.
const SPEEDS: [f64; 9] = [0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6];
/// Heights and sides of the tip, as shares of the largest offset that is used. Draw and follow
/// change most of the cue ball's way; side changes it after a cushion.
const HEIGHTS: [f64; 5] = [0.0, -0.85, 0.85, -0.45, 0.45];
const SIDES: [f64; 3] = [0.0, -0.7, 0.7];
/// Largest offset of the tip as a share of the miscue limit, without errors. Near the limit a small
/// error of the tip would slip off.
const OFFSET_USED: f64 = 0.75;
/// Number of standard deviations of the tip's errors by which a play keeps away from the miscue
/// limit. Drawn strikes beyond it are moved back, so they must not look attractive.
const AWAY: f64 = 2.5;
/// Lines that are less probable than this are not tried.
const LEAST_CHANCE: f64 = 0.02;
/// Number of lines that are tried, the most probable.
const MOST_LINES: usize = 14;
/// Share of the tolerance by which a missed shot is turned to value what it leaves.
const MISS: f64 = 1.6;

impl Explorer<'_> {
    /// The lines of a prepared position with their chances, the most probable first.
    pub(crate) fn lines(&self, prepared: &Prepared<'_>) -> Vec<(Line, f64)> {
        let scene = Scene::of(prepared);
        let mut lines = Vec::new();
        line::direct(&scene, &self.targets, &mut lines);
        line::combinations(&scene, &self.targets, &mut lines);
        line::banks(&scene, &self.targets, &mut lines);
        line::kicks(&scene, &self.targets, &mut lines);
        let noise = &self.situation.noise[self.seat()];
        let radius = scene.ball(self.turn.cue).map_or(0.03, |ball| ball.radius);
        let mut rated: Vec<(Line, f64)> = lines
            .into_iter()
            .map(|line| (line, line.chance(noise, radius)))
            .filter(|(_, chance)| *chance > LEAST_CHANCE)
            .collect();
        rated.sort_by(|a, b| b.1.total_cmp(&a.1));
        rated.truncate(MOST_LINES);
        rated
    }

    /// Adds the strikes that pot a ball: first a coarse lattice on every line, then the rest of it
    /// while simulations are left.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn pots(
        &mut self,
        prepared: &Prepared<'_>,
        place: usize,
        lines: &[(Line, f64)],
    ) -> Result<(), Error> {
        let noise = &self.situation.noise[self.seat()];
        let radius = self.situation.frame.layout().balls()[usize::from(self.turn.cue)].ball.radius;
        let most = largest_offset(prepared.shot(), noise, radius);
        let mut missed: Vec<Option<f64>> = vec![None; lines.len()];
        let mut slopes: Vec<Option<(f64, f64)>> = vec![None; lines.len()];
        // Coarse first: every second speed, heights of the ends and the middle, no side.
        let coarse = |s: usize, h: usize, x: usize| s % 2 == 1 && h < 3 && x == 0;
        for pass in [true, false] {
            for (k, (line, chance)) in lines.iter().enumerate() {
                if !pass && missed[k].is_none() {
                    continue;
                }
                for (s, speed) in SPEEDS.iter().enumerate() {
                    for (h, height) in HEIGHTS.iter().enumerate() {
                        for (x, side) in SIDES.iter().enumerate() {
                            if coarse(s, h, x) != pass || self.is_spent() {
                                continue;
                            }
                            let out = (height * height + side * side).sqrt().max(1.0);
                            let offsets = [most * side / out, most * height / out];
                            let known = slopes[k];
                            let start = start(prepared, line, (*speed, offsets), known);
                            let rated = (line, *chance);
                            let found =
                                self.pot(prepared, place, rated, (start, &mut missed[k]))?;
                            if let Some(found) = found {
                                slopes[k] = Some(found);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Aims one strike along a line and keeps it if it pots the ball legally. Returns the azimuth,
    /// less squirt, and the slope of the miss.
    pub(crate) fn pot(
        &mut self,
        prepared: &Prepared<'_>,
        place: usize,
        (line, chance): (&Line, f64),
        (start, missed): ((Strike, f64), &mut Option<f64>),
    ) -> Result<Option<(f64, f64)>, Error> {
        let mut plays = 0;
        let aimed = aim(&mut self.sampler, prepared, line, start, &mut plays);
        self.plays += plays;
        let Some(aimed) = aimed? else { return Ok(None) };
        let turned = aimed.strike.azimuth - start.0.azimuth;
        if !aimed.is_potted {
            return Ok(None);
        }
        let pocket = prepared.shot().table().pockets[line.pocket].name;
        let call = call_of(self.turn, line.first, Some((line.object, pocket)));
        let (value, is_legal) = self.ruled(prepared, call)?;
        if !is_legal {
            return Ok(Some((turned, aimed.slope)));
        }
        let kind = PlayKind::Pot(line.kind);
        // What a miss leaves hardly depends on the cue ball's way, so it is tried once.
        let miss = match *missed {
            Some(miss) => miss,
            None => {
                let end = self.successor.clone();
                let azimuth = aimed.strike.azimuth + MISS * line.tolerance;
                self.sampler.simulate(prepared, &Strike { azimuth, ..aimed.strike })?;
                self.plays += 1;
                let (value, _) = self.ruled(prepared, call)?;
                self.successor = end;
                *missed.insert(value)
            }
        };
        let prior = chance * value + (1.0 - chance) * miss.min(value);
        self.keep(aimed.strike, call, (kind, prior), (place, prepared));
        if let Some(found) = self.found.last_mut() {
            (found.line, found.missed) = (Some(*line), Some(miss));
        }
        Ok(Some((turned, aimed.slope)))
    }
}

/// The largest tip offset of intended strikes, ball radii. `radius` is the cue ball's, m.
pub(crate) fn largest_offset(shot: &Shot, noise: &Noise, radius: f64) -> f64 {
    let limit = shot.miscue_limit().min(1.0);
    let error = noise.side_m.max(noise.height_m) / radius;
    (limit - AWAY * error).clamp(0.0, OFFSET_USED * limit)
}

/// The strike with which the aiming along `line` starts, and the slope of the miss.
fn start(
    prepared: &Prepared<'_>,
    line: &Line,
    (speed, [side, height]): (f64, [f64; 2]),
    known: Option<(f64, f64)>,
) -> (Strike, f64) {
    let shot = prepared.shot();
    let ball = shot.strike().map_or(0, |(ball, _)| ball);
    let squirt =
        carom::resolve::cue_ball::squirt(&shot.physics().cue, &shot.balls()[ball].ball, side);
    // The throw and the bend of a similar strike are a better start than none.
    let (turned, slope) = known.unwrap_or((0.0, line.slope));
    let turned = if line.kind == LineKind::Direct { turned } else { 0.0 };
    let azimuth = line.azimuth - squirt + turned.clamp(-0.03, 0.03);
    let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
    (Explorer::raised(prepared, strike), slope)
}
