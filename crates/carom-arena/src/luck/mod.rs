//! The luck of shots: what the errors of a strike have changed.
//!
//! The referee knows every intended strike. So it can draw other errors of the same strike, and
//! compare what came out with what comes out in the mean. With the value V of a position, the
//! chance of the seat that strikes,
//!
//!   luck = V(position that was left) − mean of V over the positions that n fresh errors leave.
//!
//! The executed strike is drawn as the fresh ones are, so the luck has the mean 0 for every V, even
//! a wrong one. Therefore points minus the luck of all shots have the mean of the points alone, and
//! the better V is, the smaller is their variance (Burch, Schmid, Moravčík, Morrill & Bowling 2018,
//! *AIVAT*). [`crate::AdjustedPairs`] is the statistics of it.
//!
//! The fresh errors have streams of their own, which derive from the secret of the match. Players
//! see nothing of them.

mod value;

use carom::{Error, ErrorKind, Noise};
use carom_mind::value::Position;
use carom_rules::{
    ErrorDraw, Frame, FrameSimulator, Play, Prepared, Seat, execute, through_degrees,
};

pub use value::LuckValue;

/// The usual number of fresh errors of a shot.
const DRAWS: u32 = 256;
/// The largest number. With it a shot costs as much as a thousand usual ones.
const MOST_DRAWS: u32 = 1 << 18;

/// How the luck of the shots of a match is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LuckSettings {
    /// Number of fresh errors of each shot, 1 to 2¹⁸. The mean over n of them adds 1/n of the
    /// variance of a shot's luck.
    pub draws: u32,
    /// The value of positions.
    pub value: LuckValue,
}

impl Default for LuckSettings {
    fn default() -> Self {
        Self { draws: DRAWS, value: LuckValue::default() }
    }
}

impl LuckSettings {
    /// Rejects a number of fresh errors out of range.
    ///
    /// # Errors
    /// [`Error::Input`] at `luck.draws`.
    pub fn check(&self) -> Result<(), Error> {
        if (1..=MOST_DRAWS).contains(&self.draws) {
            return Ok(());
        }
        let what = format!("{} is out of range", self.draws);
        Err(ErrorKind::OutOfRange.at("luck.draws", what, format!("write 1 to {MOST_DRAWS}")))
    }
}

/// The chances of the seat that strikes to win the frame, by the value of positions.
///
/// `expected` − `before` is what the decision has changed, and `after` − `expected` is the luck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShotLuck {
    /// In the position before the shot.
    pub before: f64,
    /// After the intended strike: the mean over its fresh errors.
    pub expected: f64,
    /// In the position that the executed strike left.
    pub after: f64,
}

impl ShotLuck {
    /// The luck of the seat that strikes.
    pub fn luck(&self) -> f64 {
        self.after - self.expected
    }
}

/// Measures the luck of shots.
pub(crate) struct LuckMeter {
    pub(crate) settings: LuckSettings,
    /// The errors of seat 0 and seat 1.
    pub(crate) noise: [Noise; 2],
}

/// What is expected of a shot, for the seat that strikes: see [`ShotLuck`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forecast {
    pub(crate) before: f64,
    pub(crate) expected: f64,
}

impl LuckMeter {
    /// The value of `frame` for `seat`.
    pub(crate) fn value(&self, frame: &Frame, seat: Seat) -> f64 {
        self.settings.value.get().win_chance(&Position { frame, noise: &self.noise }, seat)
    }

    /// The values before and after `play`, which `frame` accepts; after it the mean over the fresh
    /// errors with this `seed`. Shots that reach their cap of events are left out, as frames with
    /// such a shot are; `None` if all of them do.
    ///
    /// # Errors
    /// As [`Frame::shot`].
    pub(crate) fn forecast(
        &self,
        simulator: &mut FrameSimulator,
        frame: &Frame,
        play: &Play,
        seed: u64,
    ) -> Result<Option<Forecast>, Error> {
        let shot = frame.shot(play)?;
        let prepared = Prepared::with_shot(frame, play.cue_ball, &shot)?;
        let seat = prepared.turn().player;
        let mut successor = frame.clone();
        let (mut sum, mut count) = (0.0, 0_u32);
        for index in 0..u64::from(self.settings.draws) {
            let (strike, cling) = execute(&self.noise[seat], &shot, ErrorDraw { seed, index })?;
            let strike = through_degrees(&strike);
            let simulated = if cling.is_empty() {
                simulator.simulate(&prepared, &strike)
            } else {
                let clinging = shot.with_cling(cling);
                simulator.simulate_shot(&prepared, &clinging, &strike).map(drop)
            };
            match simulated {
                Ok(()) => {
                    simulator.rule(&prepared, play.call, &mut successor)?;
                    sum += self.value(&successor, seat);
                    count += 1;
                }
                Err(Error::TooManyEvents(_)) => {}
                Err(other) => return Err(other),
            }
        }
        let before = self.value(frame, seat);
        Ok((count > 0).then(|| Forecast { before, expected: sum / f64::from(count) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::resolve::cue_ball::Strike;
    use carom_rules::{ErrorSeeds, Game, Options};

    /// The fresh errors are those that the referee draws: with its seed they leave the position that
    /// it leaves.
    #[test]
    fn a_fresh_error_leaves_what_the_same_executed_error_leaves() {
        let frame = Frame::new(Game::NineBall, Options::default(), None, None, 3).unwrap();
        let noise = Noise { cling_probability: 0.5, ..Noise::olympiad(4.0) };
        let strike = Strike { speed: 7.0, azimuth: 1.57, elevation: 0.05, side: 0.1, height: 0.1 };
        let play = Play::new(strike).from([0.7, 0.6]);
        let settings = LuckSettings { draws: 1, value: LuckValue::Noise };
        let meter = LuckMeter { settings, noise: [noise.clone(), noise.clone()] };
        let mut simulator = FrameSimulator::new();
        for seed in 0..20 {
            let forecast = meter.forecast(&mut simulator, &frame, &play, seed).unwrap().unwrap();
            let mut left = frame.clone();
            let drawn = frame.draw_play(&play, &noise, ErrorSeeds::Frame(seed)).unwrap();
            left.play(&drawn).unwrap();
            assert_eq!(forecast.expected, meter.value(&left, 0), "seed {seed}");
            assert_eq!(forecast.before, meter.value(&frame, 0));
        }
    }

    #[test]
    fn shots_that_all_reach_their_cap_of_events_have_no_luck() {
        let frame = Frame::new(Game::NineBall, Options::default(), None, None, 3).unwrap();
        let capped = frame.with_max_events(5);
        let strike = Strike { speed: 7.0, azimuth: 1.57, elevation: 0.05, side: 0.0, height: 0.0 };
        let play = Play::new(strike).from([0.7, 0.6]);
        let noise = [const { Noise::olympiad(1.0) }; 2];
        let meter = LuckMeter { settings: LuckSettings { draws: 2, ..Default::default() }, noise };
        let found = meter.forecast(&mut FrameSimulator::new(), &capped, &play, 1).unwrap();
        assert!(found.is_none());
    }
}
