//! Simulating the shots of frames, and ruling on them.

use carom::event::{NullRecorder, Recorder};
use carom::outcome::{Outcome, OutcomeMemory};
use carom::resolve::cue_ball::Strike;
use carom::{BallState, Error, MotionState, Shot, Simulator, Summary};

use super::{Frame, Prepared};
use crate::layout::BallList;
use crate::play::Call;
use crate::referee::{CueBallTravel, RefereeRecorder, renumber};
use crate::ruling::Ruling;

/// Simulates shots of frames and rules on them, one after the other in the same memory. After the
/// first shots it allocates nothing, except for a new rack.
///
/// A shot is simulated once and can be ruled on many times, since a call changes the ruling and not
/// the motion:
///
/// ```
/// use carom::resolve::cue_ball::Strike;
/// use carom_rules::{Call, Frame, FrameSimulator, Options, Prepared, Game};
///
/// # fn main() -> Result<(), carom::Error> {
/// let frame = Frame::new(Game::NineBall, Options::default(), None, None, 7)?;
/// let prepared = Prepared::new(&frame, Some([0.635, 0.6]))?;
/// let strike = Strike { speed: 8.0, azimuth: 1.57, elevation: 0.0, side: 0.0, height: 0.0 };
/// let mut simulator = FrameSimulator::new();
/// simulator.simulate(&prepared, &strike)?;
/// let mut successor = frame.clone();
/// let ruling = simulator.rule(&prepared, Call::Nothing, &mut successor)?;
/// assert!(ruling.is_legal() || successor.player() == Some(1));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default)]
pub struct FrameSimulator {
    simulator: Simulator,
    /// The outcome of the last simulation, in the frame's ball indices.
    outcome: OutcomeMemory,
    travel: CueBallTravel,
    /// The final states of the last simulation (file coordinates).
    last: Vec<BallState>,
    /// The balls of the last simulation; empty if it failed.
    balls: BallList,
}

impl FrameSimulator {
    /// A simulator that has simulated nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Simulates `strike`, exactly as it is given. The result stays here until the next simulation.
    ///
    /// # Errors
    /// [`Error::Input`] if the strike cannot be played, and [`Error::TooManyEvents`] if the shot
    /// reaches its cap on events.
    pub fn simulate(&mut self, prepared: &Prepared<'_>, strike: &Strike) -> Result<(), Error> {
        self.simulate_shot(prepared, prepared.shot(), strike).map(drop)
    }

    /// As [`Self::simulate`]; `recorder` gets every event too.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_recorded(
        &mut self,
        prepared: &Prepared<'_>,
        strike: &Strike,
        recorder: &mut dyn Recorder,
    ) -> Result<(), Error> {
        self.simulate_shot_recorded(prepared, prepared.shot(), strike, recorder).map(drop)
    }

    /// As [`Self::simulate`], with a variant of the prepared `shot` in which the balls are displaced
    /// a little or other contacts cling.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_shot(
        &mut self,
        prepared: &Prepared<'_>,
        shot: &Shot,
        strike: &Strike,
    ) -> Result<Summary, Error> {
        self.run(prepared, shot, strike, &mut NullRecorder)
    }

    /// As [`Self::simulate_shot`]; `recorder` gets every event too.
    ///
    /// # Errors
    /// As [`Self::simulate`].
    pub fn simulate_shot_recorded(
        &mut self,
        prepared: &Prepared<'_>,
        shot: &Shot,
        strike: &Strike,
        mut recorder: &mut dyn Recorder,
    ) -> Result<Summary, Error> {
        self.run(prepared, shot, strike, &mut recorder)
    }

    /// Each type of recorder compiles the whole event loop again, about 1 % of the Python package.
    /// So this is private, and has two: none, and any other through a call for each event.
    fn run<R: Recorder>(
        &mut self,
        prepared: &Prepared<'_>,
        shot: &Shot,
        strike: &Strike,
        recorder: &mut R,
    ) -> Result<Summary, Error> {
        self.balls.clear();
        self.last.clear();
        shot.check_strike(strike)?;
        let strike = shot.strike().map(|(ball, _)| (ball, *strike));
        let mut both = (RefereeRecorder::new(shot, &mut self.outcome), recorder);
        let summary = self.simulator.play_strike(shot, strike, &mut both)?;
        self.travel = both.0.travel(0.5 * shot.table().size.y);
        let states = self.simulator.states(summary.duration).enumerate();
        self.last.extend(states.map(|(i, state)| shot.to_file_coordinates(i, &state)));
        self.outcome.finish(shot, &self.last);
        renumber(self.outcome.outcome_mut(), prepared.balls());
        self.balls.extend(prepared.balls().iter().copied());
        Ok(summary)
    }

    /// Rules on the last simulation, which was one of `prepared`, as if `call` had been announced.
    /// `successor` becomes the frame after the shot. Can be called again with other calls.
    ///
    /// # Errors
    /// [`Error::Input`] if the call is missing or not allowed. `successor` is unchanged then.
    ///
    /// # Panics
    /// If the last simulation failed, or had other balls than `prepared`.
    pub fn rule(
        &self,
        prepared: &Prepared<'_>,
        call: Call,
        successor: &mut Frame,
    ) -> Result<Ruling, Error> {
        prepared.frame().check_call(prepared.turn(), call)?;
        successor.clone_from(prepared.frame());
        Ok(self.rule_on(prepared, call, successor))
    }

    /// As [`Self::rule`], for a call that was checked and a `successor` that is the frame before the
    /// shot.
    pub(super) fn rule_on(
        &self,
        prepared: &Prepared<'_>,
        call: Call,
        successor: &mut Frame,
    ) -> Ruling {
        assert!(*self.balls == *prepared.balls(), "the last simulation was not of this shot");
        let layout = &mut successor.state.layout;
        for (&ball, state) in self.balls.iter().zip(&self.last) {
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            layout.put(ball, (!gone).then_some([state.position.x, state.position.y]));
        }
        let (turn, before) = (prepared.turn(), prepared.before());
        successor.decide(turn, call, self.outcome.outcome(), &self.travel, before)
    }

    /// The outcome of the last simulation. Balls are indices of the frame.
    pub const fn outcome(&self) -> &Outcome {
        self.outcome.outcome()
    }

    /// The final states of the last simulation (file coordinates), before any ball was spotted, in
    /// the order of the shot's balls; empty if it failed.
    pub fn last(&self) -> &[BallState] {
        &self.last
    }

    /// The simulator, for shots that are not ruled on. The result of the last simulation stays.
    pub const fn simulator_mut(&mut self) -> &mut Simulator {
        &mut self.simulator
    }
}
