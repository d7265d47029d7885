//! Windows: the ranges of azimuths around a strike that pot a ball, measured by simulation.
//!
//! Geometry does not know how wide a pocket is for a ball that comes off two cushions, off another ball,
//! or fast along a rail. A strike that pots a ball is moved to the middle of its window, and the window's
//! width over the player's error gives the chance of the pot.

use core::f64::consts::SQRT_2;

use carom::Error;
use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{BallIndex, Call};

use super::candidate::{Candidate, PlayKind};
use super::explore::Explorer;
use super::race::keeps_turn;
use crate::line::{Line, LineKind, direction_error};
use carom_plan::Prepared;

/// Step of the azimuth, as a share of the error of direction. The chance of a pot changes little within it.
const STEP: f64 = 0.5;
/// Most steps to either side: a wider window is certain.
const MOST_STEPS: u32 = 5;
/// Steps to either side within which a changed strike looks for the pot.
const LOST_STEPS: u32 = 4;
/// Share of the balls that fall in the middle of a wide window: the errors of speed and spin make others
/// miss. Estimated.
const FALLS: f64 = 0.9;
/// Two strikes on one ball whose azimuths differ by less than this, rad, are on the same direct line.
const SAME_LINE: f64 = 0.03;

/// A pot that a play is meant to make.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    pub(crate) pot: (BallIndex, PocketName),
    pub(crate) call: Call,
    pub(crate) kind: PlayKind,
    pub(crate) line: Option<Line>,
}

impl Aim {
    /// The aim of a candidate that is to pot a ball.
    pub(crate) fn of(candidate: &Candidate) -> Option<Self> {
        let Candidate { play, kind, line, pot, .. } = *candidate;
        pot.map(|pot| Self { pot, call: play.call, kind, line })
    }
}

/// A pot on a direct line, and its azimuth.
pub(crate) type DirectPot = ((BallIndex, PocketName), f64);

impl Explorer<'_> {
    /// Moves a strike that makes its pot to the middle of its window, and keeps it. Returns its
    /// estimated value; none if the middle misses.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn center(
        &mut self,
        (prepared, place): (&Prepared<'_>, usize),
        strike: Strike,
        aim: Aim,
    ) -> Result<Option<f64>, Error> {
        let error = self.direction_error(prepared);
        let step = STEP * error;
        let mut reach = [0_u32; 2];
        let mut missed = [0.0; 2];
        for (k, way) in [-1.0, 1.0].into_iter().enumerate() {
            for count in 1..=MOST_STEPS {
                let azimuth = strike.azimuth + way * step * f64::from(count);
                let (falls, value) = self.makes(prepared, &Strike { azimuth, ..strike }, &aim)?;
                missed[k] = value;
                if !falls {
                    break;
                }
                reach[k] = count;
            }
        }
        let turn = 0.5 * (f64::from(reach[1]) - f64::from(reach[0])) * step;
        let middle = Strike { azimuth: strike.azimuth + turn, ..strike };
        let (falls, value) = self.makes(prepared, &middle, &aim)?;
        if !falls {
            return Ok(None);
        }
        let half = 0.5 * step * f64::from(reach[0] + reach[1] + 1);
        let chance = FALLS * libm::erf(half / (SQRT_2 * error));
        let missed = 0.5 * (missed[0] + missed[1]);
        let prior = chance * value + (1.0 - chance) * missed.min(value);
        self.keep(middle, aim.call, (aim.kind, aim.line, prior), (place, prepared));
        Ok(Some(prior))
    }

    /// As [`Self::center`], for a strike near one that makes the pot: looks for the window first.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn find_again(
        &mut self,
        (prepared, place): (&Prepared<'_>, usize),
        strike: Strike,
        aim: Aim,
    ) -> Result<(), Error> {
        let step = STEP * self.direction_error(prepared);
        for count in 0..=2 * LOST_STEPS {
            let side = if count % 2 == 0 { 1.0 } else { -1.0 };
            let azimuth = strike.azimuth + side * step * f64::from(count.div_ceil(2));
            let strike = Strike { azimuth, ..strike };
            if self.makes(prepared, &strike, &aim)?.0 {
                self.center((prepared, place), strike, aim)?;
                break;
            }
        }
        Ok(())
    }

    /// Whether a direct line makes this pot in about this direction.
    pub(crate) fn has_direct_line(&self, pot: (BallIndex, PocketName), azimuth: f64) -> bool {
        self.direct_pots.iter().any(|(other, way)| {
            let turn = carom::math::sin_cos(azimuth - way).0;
            *other == pot && turn.abs() < SAME_LINE
        })
    }

    /// The standard deviation of the cue ball's direction, rad.
    fn direction_error(&self, prepared: &Prepared<'_>) -> f64 {
        direction_error(&self.situation.noise[self.seat()], prepared.struck_ball().radius)
    }

    /// Plays `strike`: whether it makes the pot and keeps the turn, and its value. Where no pocket is
    /// called, any ball that keeps the turn will do.
    fn makes(
        &mut self,
        prepared: &Prepared<'_>,
        strike: &Strike,
        aim: &Aim,
    ) -> Result<(bool, f64), Error> {
        self.plays += 1;
        if self.sampler.simulate(prepared, strike).is_err() {
            return Ok((false, 0.0));
        }
        let is_called = matches!(aim.call, Call::Pocket(..));
        let falls = !is_called || self.sampler.outcome().pocketed.contains(&aim.pot);
        let (value, is_legal) = self.ruled(prepared, aim.call)?;
        Ok((falls && is_legal && keeps_turn(&self.successor, self.seat()), value))
    }
}

/// The pots of the direct lines of `lines`.
pub(crate) fn direct_pots<'a>(
    lines: impl Iterator<Item = &'a Line>,
    prepared: &Prepared<'_>,
) -> Vec<DirectPot> {
    let pockets = &prepared.shot().table().pockets;
    let direct = lines.filter(|line| line.kind == LineKind::Direct);
    direct.map(|line| ((line.object, pockets[line.pocket].name), line.azimuth)).collect()
}
