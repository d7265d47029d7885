//! Finer steps around the best candidates: other speeds and tip offsets, on the same line or in the
//! same direction.

use carom::Error;
use carom::resolve::cue_ball::Strike;
use carom_plan::Prepared;

use super::candidate::{Candidate, PlayKind};
use super::explore::{CuePlace, Explorer, FoundPlay, raised};
use super::pots::KnownLine;
use super::strike_errors::largest_offset;
use super::windows::MeantPot;

/// Steps of the first refinement: factor of the speed, and change of the tip offset (ball radii).
/// Every second further refinement halves them.
const FASTER: f64 = 0.16;
const OFFSET: f64 = 0.14;
/// Change of the azimuth of a play without a line, rad.
const TURN: f64 = 0.02;
/// Directions in which a candidate is changed: speed, height, side.
const DIRECTIONS: [[f64; 3]; 8] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
    [1.0, 1.0, 0.0],
    [-1.0, -1.0, 0.0],
];

impl Explorer<'_> {
    /// Adds neighbours of `candidates`, the best first, while simulations are left. `round` counts
    /// the refinements before.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn refine(
        &mut self,
        prepared: &[Prepared<'_>],
        lines: &mut [KnownLine],
        candidates: &[Candidate],
        round: u32,
        until: u64,
    ) -> Result<(), Error> {
        let scale = 1.0 / f64::from(1_u32 << (round / 2).min(16));
        for candidate in candidates {
            let position = &prepared[candidate.place];
            let mut line = lines
                .iter_mut()
                .find(|known| known.place == candidate.place && Some(known.line) == candidate.line);
            for direction in DIRECTIONS {
                if self.bench.plays >= until {
                    return Ok(());
                }
                let step = direction.map(|share| scale * share);
                self.neighbour(position, line.as_deref_mut(), candidate, step)?;
            }
        }
        Ok(())
    }

    /// Adds the neighbour of `candidate` that is `step` away, if it does what it is meant to do.
    fn neighbour(
        &mut self,
        prepared: &Prepared<'_>,
        line: Option<&mut KnownLine>,
        candidate: &Candidate,
        [faster, higher, aside]: [f64; 3],
    ) -> Result<(), Error> {
        let meant = candidate.play.strike;
        let shot = prepared.shot();
        let ball = shot.strike().map_or(0, |(ball, _)| ball);
        let ball = &shot.balls()[ball].ball;
        let noise = self.task.noise();
        let most = largest_offset(shot, noise, ball.radius);
        let side = meant.side + OFFSET * aside;
        let height = meant.height + OFFSET * higher;
        let strike = Strike { speed: meant.speed * (1.0 + FASTER * faster), side, height, ..meant };
        let [slowest, fastest] = self.speeds();
        let is_in_range = (slowest..=fastest).contains(&strike.speed);
        if !is_in_range || strike.offset() > most.max(meant.offset()) {
            return Ok(());
        }
        let at = CuePlace { number: candidate.place, prepared };
        match (candidate.kind, line) {
            (PlayKind::Pot(_), Some(known)) => {
                self.pot(prepared, known, strike.speed, [side, height])
            }
            (PlayKind::Pot(_) | PlayKind::PushOut, _) => Ok(()),
            (PlayKind::Indirect, _) => {
                let Some(meant) = MeantPot::of(candidate) else { return Ok(()) };
                self.find_again(at, raised(prepared, strike), meant)
            }
            _ => {
                let azimuth = meant.azimuth + TURN * aside;
                let strike = Strike { azimuth, side: meant.side, ..strike };
                self.again(at, candidate, raised(prepared, strike))
            }
        }
    }

    /// Adds a play that is like `candidate`, if it is legal.
    fn again(
        &mut self,
        at: CuePlace<'_>,
        candidate: &Candidate,
        strike: Strike,
    ) -> Result<(), Error> {
        let call = candidate.play.call;
        self.bench.plays += 1;
        if self.bench.sampler.simulate(at.prepared, &strike).is_err() {
            return Ok(());
        }
        let (value, is_legal) = self.ruled(at.prepared, call)?;
        if is_legal {
            let prior = value.min(candidate.mean());
            let Candidate { kind, line, .. } = *candidate;
            self.keep(at, FoundPlay { strike, call, kind, line, prior });
        }
        Ok(())
    }
}
