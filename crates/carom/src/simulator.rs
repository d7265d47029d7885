//! A simulator that plays shots with any number of balls.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use crate::error::{Error, EventCapError};
use crate::event::Recorder;
use crate::limits::{MAX_BALLS, SMALL_CAPACITY};
use crate::math::Vec3;
use crate::motion::never_rests;
use crate::resolve::cue_ball::Strike;
use crate::shot::PlacedBall;
use crate::simulate::{Simulation, SimulationError, Summary};
use crate::trace::TraceRecorder;
use crate::{BallState, Shot, ShotFile, Trace, shot};

/// Plays shots one after the other in the same memory. Use one simulator for a loop over shots, or
/// one for each thread of a [`Runner`](crate::runner::Runner).
///
/// Shots of up to [`SMALL_CAPACITY`] balls use a [`Simulation`] that fits into a processor's
/// level-1 data cache. A larger one is allocated when the first shot with more balls is played.
/// Playing allocates nothing else.
///
/// ```
/// # #[cfg(feature = "json")] {
/// use carom::event::NullRecorder;
/// use carom::{Shot, Simulator};
///
/// let shot = Shot::from_json(
///     r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
///         "balls": [{"id": "cue", "position": [0, 0], "velocity": [0, 1, 0]}]}"#,
/// )
/// .unwrap();
/// let mut simulator = Simulator::new();
/// let summary = simulator.play(&shot, &mut NullRecorder).unwrap();
/// assert!(simulator.file_state(0, &shot, summary.duration).position.y > 1.0);
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Simulator {
    few: Box<Simulation<SMALL_CAPACITY>>,
    many: Option<Box<Simulation<MAX_BALLS>>>,
    /// Whether the last shot was played in `many`.
    in_many: bool,
}

impl Default for Simulator {
    fn default() -> Self {
        Self::new()
    }
}

impl Simulator {
    /// A simulator that has played nothing yet.
    pub fn new() -> Self {
        Self { few: Box::new(Simulation::new()), many: None, in_many: false }
    }

    /// Plays `shot` from the strike to rest, or to its end time; `recorder` gets every event.
    ///
    /// # Errors
    /// [`Error::Input`] if the strike cannot be played, [`Error::TooManyEvents`] with the shot file
    /// if the cap on events is reached.
    pub fn play<R: Recorder>(&mut self, shot: &Shot, recorder: &mut R) -> Result<Summary, Error> {
        self.play_strike(shot, shot.strike(), recorder)
    }

    /// Plays `shot` with another strike than its own: the index of the struck ball, which is at
    /// rest, and the strike. Only the tip's offset is checked; [`Shot::resolve_strike`] checks all.
    ///
    /// # Errors
    /// As [`Self::play`].
    ///
    /// # Panics
    /// If the shot has no ball with the index of the struck ball.
    pub fn play_strike<R: Recorder>(
        &mut self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        recorder: &mut R,
    ) -> Result<Summary, Error> {
        self.play_until(shot, strike, f64::MAX, recorder)
    }

    /// As [`Self::play_strike`], but only to the time `end`, s, if the shot does not end before.
    ///
    /// # Errors
    /// As [`Self::play`].
    ///
    /// # Panics
    /// As [`Self::play_strike`].
    pub fn play_until<R: Recorder>(
        &mut self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        end: f64,
        recorder: &mut R,
    ) -> Result<Summary, Error> {
        self.in_many = shot.balls().len() > SMALL_CAPACITY;
        let played = if self.in_many {
            let many = self.many.get_or_insert_with(|| Box::new(Simulation::new()));
            play_many(many, shot, strike, end, recorder)
        } else {
            self.few.play_until(shot, strike, end, recorder)
        };
        played.map_err(|failure| self.explain(shot, strike, failure))
    }

    /// Plays `shot` and records everything.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn record(&mut self, shot: &Shot) -> Result<Trace, Error> {
        match self.record_to_cap(shot)? {
            (trace, None) => Ok(trace),
            (_, Some(cap)) => Err(Error::TooManyEvents(cap)),
        }
    }

    /// As [`Self::record`]; a shot that reaches its cap on events gives the trace so far, and the
    /// error.
    ///
    /// # Errors
    /// [`Error::Input`] if the strike cannot be played.
    pub fn record_to_cap(
        &mut self,
        shot: &Shot,
    ) -> Result<(Trace, Option<Box<EventCapError>>), Error> {
        let mut recorder = TraceRecorder::new(shot);
        match self.play(shot, &mut recorder) {
            Ok(Summary { duration, .. }) => {
                let last: Vec<BallState> = self.states(duration).collect();
                Ok((recorder.finish(&last, duration), None))
            }
            Err(Error::TooManyEvents(cap)) => {
                let last: Vec<BallState> = self.states(cap.time).collect();
                Ok((recorder.finish_at_cap(&last, cap.time), Some(cap)))
            }
            Err(other) => Err(other),
        }
    }

    /// The error, in the user's terms, of `shot` played with `strike`.
    #[cold]
    fn explain(
        &self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        failure: SimulationError,
    ) -> Error {
        match (failure, strike) {
            (SimulationError::Strike(e), Some((_, strike))) => shot::explain("strike", &strike, e),
            (SimulationError::Strike(e), None) => e.kind().at("strike", e.fault(), e.remedy()),
            (SimulationError::TooManyEvents { max_events, time }, _) => {
                let mut played = shot.clone();
                played.strike = strike;
                Error::TooManyEvents(Box::new(EventCapError {
                    cap: max_events,
                    time,
                    never_resting: self.never_resting(shot, time),
                    shot: played.to_json(),
                }))
            }
        }
    }

    /// The id of a ball whose centre moves for ever between the rails, if there is one.
    fn never_resting(&self, shot: &Shot, time: f64) -> Option<String> {
        let physics = shot.physics();
        let moves = |(placed, state): &(&PlacedBall, BallState)| {
            state.velocity != Vec3::ZERO
                && never_rests(state, &placed.ball, &physics.cloth, physics.gravity)
        };
        let has_rails = !shot.table().cushions.is_empty();
        let mut balls = shot.balls().iter().zip(self.states(time));
        balls.find(moves).filter(|_| has_rails).map(|(placed, _)| placed.id.clone())
    }

    /// Number of balls of the last shot.
    pub fn len(&self) -> usize {
        match &self.many {
            Some(many) if self.in_many => many.len(),
            _ => self.few.len(),
        }
    }

    /// Whether the last shot had no balls, or none has been played yet.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// State of ball `i` of the last shot at `time` (s), not before its last event, in the engine's
    /// frame.
    #[inline]
    pub fn state(&self, i: usize, time: f64) -> BallState {
        match &self.many {
            Some(many) if self.in_many => many.state(i, time),
            _ => self.few.state(i, time),
        }
    }

    /// The same in the file's coordinates; `shot` is the last shot. A ball that never moved has
    /// the bits of the file.
    pub fn file_state(&self, i: usize, shot: &Shot, time: f64) -> BallState {
        shot.to_file_coordinates(i, &self.state(i, time))
    }

    /// The states of all balls of the last shot at `time` (s), not before the last event, in the
    /// engine's coordinates.
    pub fn states(&self, time: f64) -> impl ExactSizeIterator<Item = BallState> + '_ {
        (0..self.len()).map(move |i| self.state(i, time))
    }
}

/// Plays a shot with many balls. All recorders share this one event loop, called through a pointer:
/// a second loop for each type of recorder doubles the time to compile and the size of programs.
fn play_many(
    simulation: &mut Simulation<MAX_BALLS>,
    shot: &Shot,
    strike: Option<(usize, Strike)>,
    end: f64,
    mut recorder: &mut dyn Recorder,
) -> Result<Summary, SimulationError> {
    simulation.play_until(shot, strike, end, &mut recorder)
}

impl Shot {
    /// Simulates the shot and records everything. For many shots: [`Simulator::record`].
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if the cap is reached.
    pub fn simulate(&self) -> Result<Trace, Error> {
        Simulator::new().record(self)
    }

    /// As [`Self::simulate`]; a shot that reaches its cap on events gives the trace so far, and the
    /// error.
    ///
    /// # Errors
    /// [`Error::Input`] if the strike cannot be played.
    pub fn simulate_to_cap(&self) -> Result<(Trace, Option<Box<EventCapError>>), Error> {
        Simulator::new().record_to_cap(self)
    }
}

impl ShotFile {
    /// Simulates the shot and records everything. An error carries the file as it was read.
    ///
    /// # Errors
    /// As [`Shot::simulate`].
    pub fn simulate(&self) -> Result<Trace, Error> {
        self.shot().simulate().map_err(|error| match error {
            Error::TooManyEvents(mut error) => {
                error.shot = self.to_json();
                Error::TooManyEvents(error)
            }
            other => other,
        })
    }
}
