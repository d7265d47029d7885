//! Windows: the ranges of azimuths around a strike that pot a ball, measured by simulation.
//!
//! Geometry does not know how wide a pocket is for a ball that comes off two cushions, off another ball,
//! or fast along a rail. A strike that pots a ball is moved to the middle of its window, and the window's
//! width over the player's error gives the chance of the pot.

use core::f64::consts::SQRT_2;

use carom::Error;
use carom::math::sqrt;
use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{BallIndex, Call};

use super::candidate::{Candidate, PlayKind};
use super::explore::{CuePlace, Explorer, FoundPlay};
use super::strike_errors::{ErrorScale, moved};
use crate::aim::{Aimed, LineMiss, LineRecorder};
use crate::line::{Line, direction_error};
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
/// The turn, rad, that counts for an error with which the balls leave the line, and the largest one.
const LOST: f64 = 0.05;
/// A pot that a play is meant to make.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeantPot {
    pub(crate) pot: (BallIndex, PocketName),
    pub(crate) call: Call,
    pub(crate) kind: PlayKind,
    pub(crate) line: Option<Line>,
}

impl MeantPot {
    /// What a candidate is meant to pot; none if that is nothing.
    pub(crate) fn of(candidate: &Candidate) -> Option<Self> {
        let Candidate { play, kind, line, pot, .. } = *candidate;
        pot.map(|pot| Self { pot, call: play.call, kind, line })
    }
}

impl Explorer<'_> {
    /// Moves a strike that makes its pot to the middle of its window, and keeps it. Returns its
    /// estimated value; none if the middle misses.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn center(
        &mut self,
        at: CuePlace<'_>,
        strike: Strike,
        meant: MeantPot,
        error: f64,
    ) -> Result<Option<f64>, Error> {
        let (step, prepared) = (STEP * error, at.prepared);
        let mut reach = [0_u32; 2];
        // What a miss to either side leaves. A side on which no strike misses loses nothing.
        let mut missed = [0.0; 2];
        for (k, way) in [-1.0, 1.0].into_iter().enumerate() {
            for count in 1..=MOST_STEPS {
                let azimuth = strike.azimuth + way * step * f64::from(count);
                let (falls, value) = self.makes(prepared, &Strike { azimuth, ..strike }, &meant)?;
                missed[k] = value;
                if !falls {
                    break;
                }
                reach[k] = count;
            }
        }
        let turn = 0.5 * (f64::from(reach[1]) - f64::from(reach[0])) * step;
        let middle = Strike { azimuth: strike.azimuth + turn, ..strike };
        let (falls, value) = self.makes(prepared, &middle, &meant)?;
        if !falls {
            return Ok(None);
        }
        let half = 0.5 * step * f64::from(reach[0] + reach[1] + 1);
        let chance = FALLS * libm::erf(half / (SQRT_2 * error));
        let missed = 0.5 * (missed[0] + missed[1]);
        let prior = chance * value + (1.0 - chance) * missed.min(value);
        let MeantPot { call, kind, line, .. } = meant;
        self.keep(at, FoundPlay { strike: middle, call, kind, line, prior });
        Ok(Some(prior))
    }

    /// As [`Self::center`], for a strike near one that makes the pot: looks for the window first.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn find_again(
        &mut self,
        at: CuePlace<'_>,
        strike: Strike,
        meant: MeantPot,
    ) -> Result<(), Error> {
        let error = self.direction_error(at.prepared);
        let step = STEP * error;
        for count in 0..=2 * LOST_STEPS {
            let side = if count % 2 == 0 { 1.0 } else { -1.0 };
            let azimuth = strike.azimuth + side * step * f64::from(count.div_ceil(2));
            let strike = Strike { azimuth, ..strike };
            if self.makes(at.prepared, &strike, &meant)?.0 {
                self.center(at, strike, meant, error)?;
                break;
            }
        }
        Ok(())
    }

    /// The standard deviation of the azimuth by which a strike on a line passes its pocket, rad: that of the
    /// azimuth itself, and what the errors of the speed and of the tip change. Takes one simulation for each
    /// of these errors.
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if a shot does not end.
    pub(crate) fn line_error(
        &mut self,
        prepared: &Prepared<'_>,
        line: &Line,
        aimed: &Aimed,
    ) -> Result<f64, Error> {
        let noise = self.task.noise();
        let radius = prepared.struck_ball().radius;
        let deviations = ErrorScale::of(noise, aimed.strike.speed, radius).deviation;
        let mut sum = deviations[0] * deviations[0];
        for k in (1..4).filter(|k| deviations[*k] > 0.0) {
            let mut steps = [0.0; 4];
            steps[k] = 1.0;
            let strike = moved(&aimed.strike, &deviations, &steps);
            let Some(mut recorder) = LineRecorder::new(line, prepared) else { continue };
            self.bench.plays += 1;
            match self.bench.sampler.simulate_recorded(prepared, &strike, &mut recorder) {
                Ok(()) => {}
                Err(Error::Input(_)) => continue,
                Err(error) => return Err(error),
            }
            let last = line.legs().len() - 1;
            let turn = match recorder.line_miss() {
                Some(LineMiss { leg, miss }) if leg == last => {
                    ((miss - aimed.miss) / aimed.slope).clamp(-LOST, LOST)
                }
                _ => LOST,
            };
            sum += turn * turn;
        }
        Ok(sqrt(sum))
    }

    /// The standard deviation of the cue ball's direction, rad.
    pub(crate) fn direction_error(&self, prepared: &Prepared<'_>) -> f64 {
        direction_error(self.task.noise(), prepared.struck_ball().radius)
    }

    /// Plays `strike`: whether it makes the pot and keeps the turn, and its value. Where no pocket is
    /// called, any ball that keeps the turn will do.
    fn makes(
        &mut self,
        prepared: &Prepared<'_>,
        strike: &Strike,
        meant: &MeantPot,
    ) -> Result<(bool, f64), Error> {
        self.bench.plays += 1;
        if self.bench.sampler.simulate(prepared, strike).is_err() {
            return Ok((false, 0.0));
        }
        let is_called = matches!(meant.call, Call::Pocket(..));
        let falls = !is_called || self.bench.sampler.outcome().pocketed.contains(&meant.pot);
        let (value, is_legal) = self.ruled(prepared, meant.call)?;
        Ok((falls && is_legal && self.keeps_turn(), value))
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom::table::PocketName;
    use carom_rules::{Frame, Game, Options};

    use super::*;
    use crate::player::Situation;
    use crate::search::explore::raised;
    use crate::search::task::ShotTask;
    use crate::value::Markov;

    /// A frame of nine-ball with these places of the cue ball and the nine.
    fn lone_nine(cue: [f64; 2], nine: [f64; 2]) -> Frame {
        let mut frame =
            Frame::new(Game::NineBall, Options::default(), None, None, 0).expect("a frame");
        let mut balls = vec![None; frame.layout().len()];
        (balls[0], balls[9]) = (Some(cue), Some(nine));
        frame.resume_at(&balls, 0).expect("a layout");
        frame
    }

    /// The candidates that `find` adds for a frame.
    fn found(frame: &Frame, find: impl FnOnce(&mut Explorer<'_>, CuePlace<'_>)) -> Vec<Candidate> {
        let situation = Situation::new(frame, Noise::olympiad(1.0), 1);
        let value = Markov::default();
        let task = ShotTask::new(&situation, &value).expect("a shot");
        let mut explorer = Explorer::new(task);
        let prepared = Prepared::new(frame, None).expect("a position");
        find(&mut explorer, CuePlace { number: 0, prepared: &prepared });
        explorer.found
    }

    const AIM: MeantPot = MeantPot {
        pot: (9, PocketName::TopRight),
        call: Call::Nothing,
        kind: PlayKind::Indirect,
        line: None,
    };

    /// A straight draw shot: the nine lies on the line from the cue ball to the corner.
    fn straight(turn: f64) -> (Frame, Strike) {
        let frame = lone_nine([0.27, 1.54], [0.97, 2.24]);
        let azimuth = core::f64::consts::FRAC_PI_4 + turn;
        (frame, Strike { speed: 3.0, azimuth, elevation: 0.0, side: 0.0, height: -0.3 })
    }

    #[test]
    fn a_strike_at_the_edge_moves_to_the_middle_of_its_window() {
        let middles: Vec<Candidate> = [-0.003, 0.0, 0.003]
            .into_iter()
            .flat_map(|turn| {
                let (frame, strike) = straight(turn);
                found(&frame, |explorer, at| {
                    let strike = raised(at.prepared, strike);
                    explorer.center(at, strike, AIM, 0.0025).expect("simulations");
                })
            })
            .collect();
        assert_eq!(middles.len(), 3);
        for middle in &middles {
            let off = middle.play.strike.azimuth - middles[1].play.strike.azimuth;
            assert!(off.abs() < 0.002, "{off}");
            // Most balls fall, and the game is won then.
            assert!(middle.prior > 0.7 && middle.prior <= 1.0, "{}", middle.prior);
        }
    }

    #[test]
    fn a_strike_beside_its_window_finds_it_again() {
        let (frame, strike) = straight(0.009);
        let all = found(&frame, |explorer, at| {
            let strike = raised(at.prepared, strike);
            assert!(!explorer.makes(at.prepared, &strike, &AIM).expect("a simulation").0);
            explorer.find_again(at, strike, AIM).expect("simulations");
        });
        assert_eq!(all.len(), 1);
        assert!(all[0].play.strike.azimuth < strike.azimuth - 0.001);
    }
}
