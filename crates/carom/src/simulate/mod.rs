//! The event loop (Leckie & Greenspan 2006, figure 1).
//!
//! Each ball stores the closed-form path of its current motion state and the time at which that
//! path began. An event advances only the balls that take part in it, so a resting ball never
//! drifts. After the event only these balls' candidate events are computed again.
//!
//! **Order of events at one instant**: motion transitions; then the slate, its holes and the
//! table's edge; then cushions; then ball–ball contacts. Within one of these groups the ball that
//! comes first in the shot goes first. Balls that touch when one of them is hit are resolved
//! together (`resolve/network/mod.rs`).

mod ball_set;
mod candidates;
mod cluster;
mod edge;
mod impact;
mod jam;
mod off_bed;
#[cfg(feature = "peers")]
pub mod peer;
mod persistent_contact;
mod row;
mod step;
mod support;
mod surroundings;

use core::fmt;

use crate::event::{EventKind, Recorder};
use crate::limits::{MAX_BALLS, SMALL_CAPACITY};
use crate::motion::Path;
use crate::physics::StrikeModel;
use crate::resolve::cue_ball::{self, Strike, StrikeError};
use crate::resolve::network::NetworkScratch;
use crate::shot::Shot;
use crate::table::TableFeature;
use crate::{Ball, BallState, MotionState, Physics};
pub(crate) use ball_set::BallSet;
pub(crate) use cluster::CLOSING_TIME;
use jam::Jam;
use persistent_contact::Push;
use step::StepContext;
use support::Support;
pub use surroundings::Surroundings;

/// Every capacity is a multiple of this number of balls, the number of doubles in the widest vector
/// register.
const CAPACITY_STEP: usize = 8;

/// Why a simulation has no result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SimulationError {
    /// The strike cannot be played.
    Strike(StrikeError),
    /// The cap on events was reached.
    TooManyEvents {
        /// The cap.
        max_events: u32,
        /// Time of the last event, s.
        time: f64,
    },
}

impl fmt::Display for SimulationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Strike(error) => write!(f, "strike: {error}"),
            Self::TooManyEvents { max_events, time } => write!(
                f,
                "max_events: the shot was stopped at its cap of {max_events} events, at {time} s; \
                 raise the cap"
            ),
        }
    }
}

impl core::error::Error for SimulationError {}

/// Duration and number of events of a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Time of the last event, s; the shot's end time if a ball still moves then.
    pub duration: f64,
    /// Number of events, the strike included.
    pub events: u32,
}

/// Simulates `shot` from the strike to rest, or to its end time, and passes every event to
/// `recorder`.
///
/// # Errors
/// [`SimulationError`] if the strike cannot be played or the cap on events is reached.
pub fn simulate<R: Recorder>(shot: &Shot, recorder: &mut R) -> Result<Summary, SimulationError> {
    if shot.balls.len() <= SMALL_CAPACITY {
        Simulation::<SMALL_CAPACITY>::new().play(shot, recorder)
    } else {
        let mut simulation = alloc::boxed::Box::new(Simulation::<MAX_BALLS>::new());
        simulation.play(shot, recorder)
    }
}

/// The mutable state of a shot of at most `N` balls. Each call of [`Simulation::play`] starts
/// again, so one value serves many shots.
///
/// `N` is a multiple of 8, because balls are searched in rows of vector registers, and at most
/// [`MAX_BALLS`]; other numbers do not compile. [`SMALL_CAPACITY`] is the usual one.
///
/// ```
/// # use carom::simulate::Simulation;
/// let pair: Simulation<8> = Simulation::new();
/// ```
///
/// ```compile_fail
/// # use carom::simulate::Simulation;
/// let odd: Simulation<7> = Simulation::new();
/// ```
#[derive(Clone, Debug)]
pub struct Simulation<const N: usize> {
    n: usize,
    ball: [Ball; N],
    /// Path of the current motion state.
    path: [Path; N],
    /// The horizontal part of the paths, in the layout of the search for contacts of pairs.
    lanes: Lanes<N>,
    /// Time of the next motion transition, s, infinite if none.
    transition: [f64; N],
    /// Time of the first contact with a table feature, s, infinite if none.
    feature_time: [f64; N],
    feature: [TableFeature; N],
    /// Time of the first contact with another ball, s, infinite if none, and that ball.
    contact: [f64; N],
    partner: [u16; N],
    /// The earliest of the three times, infinite where there is no ball.
    earliest: [f64; N],
    /// Each ball's latest contacts.
    push: [Push; N],
    /// Whether each ball is off the bed: in flight, on a rail's top or in a hole.
    off_bed: [bool; N],
    /// Each ball's recent contacts off the bed.
    jam: [Jam; N],
    /// Time of the first contact of every pair that has one, s; symmetric.
    pair: [[f64; N]; N],
    /// The balls for which a ball's row of `pair` holds a time.
    partners: [BallSet; N],
    /// Whether the processor has vectors wide enough for [`row`].
    wide: bool,
    /// Memory for impacts of many balls.
    network: NetworkScratch,
}

/// Every ball's motion in the table plane, laid out for vector instructions. At the time t after
/// its start a path is at x + vx t + hx t², and likewise for y.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Lanes<const N: usize> {
    x: [f64; N],
    y: [f64; N],
    vx: [f64; N],
    vy: [f64; N],
    hx: [f64; N],
    hy: [f64; N],
    /// When the path began, s.
    start: [f64; N],
    /// How long the path is valid, s: until the earlier of transition and table contact for a
    /// moving ball, for ever (infinite) for a resting ball. NaN excludes a ball from other balls'
    /// searches: there is no ball, it is out of play, or its own search has not run yet.
    valid_until: [f64; N],
    radius: [f64; N],
}

/// The event that comes next.
#[derive(Clone, Copy, Debug, PartialEq)]
enum NextEvent {
    Transition(usize),
    TableContact(usize, TableFeature),
    BallContact(usize, usize),
}

impl NextEvent {
    /// Events of one instant happen in ascending order of rank.
    fn rank(self) -> u8 {
        match self {
            Self::Transition(_) => 0,
            Self::TableContact(_, TableFeature::Cushion(_)) => 2,
            Self::TableContact(..) => 1,
            Self::BallContact(..) => 3,
        }
    }
}

impl<const N: usize> Default for Simulation<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Simulation<N> {
    /// The most balls that fit.
    pub const CAPACITY: usize = N;

    /// A simulation without balls.
    pub fn new() -> Self {
        const {
            assert!(
                N > 0 && N.is_multiple_of(CAPACITY_STEP) && N <= MAX_BALLS,
                "Simulation<N>: N must be a multiple of 8 from 8 to MAX_BALLS; SMALL_CAPACITY is the usual one"
            );
        }
        Self {
            n: 0,
            ball: [Ball { mass: 0.0, radius: 0.0 }; N],
            path: [Path::default(); N],
            lanes: Lanes {
                x: [0.0; N],
                y: [0.0; N],
                vx: [0.0; N],
                vy: [0.0; N],
                hx: [0.0; N],
                hy: [0.0; N],
                start: [0.0; N],
                valid_until: [f64::NAN; N],
                radius: [0.0; N],
            },
            transition: [f64::INFINITY; N],
            feature_time: [f64::INFINITY; N],
            feature: [TableFeature::Cushion(0); N],
            contact: [f64::INFINITY; N],
            partner: [0; N],
            earliest: [f64::INFINITY; N],
            push: [Push::NONE; N],
            off_bed: [false; N],
            jam: [Jam::NONE; N],
            wide: crate::math::has_wide_vectors(),
            pair: [[f64::INFINITY; N]; N],
            partners: [BallSet::EMPTY; N],
            network: NetworkScratch::default(),
        }
    }

    /// Plays a whole shot.
    ///
    /// # Errors
    /// See [`simulate`].
    ///
    /// # Panics
    /// If the shot has more than `N` balls.
    pub fn play<R: Recorder>(
        &mut self,
        shot: &Shot,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        self.play_strike(shot, shot.strike, recorder)
    }

    /// Plays `shot` with another strike than its own: the index of the struck ball, which is at
    /// rest, and the strike. Only the tip's offset is checked; [`Shot::resolve_strike`] checks all.
    ///
    /// # Errors
    /// See [`simulate`].
    ///
    /// # Panics
    /// If the shot has more than `N` balls, or no ball with the index of the struck ball.
    pub fn play_strike<R: Recorder>(
        &mut self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        self.play_until(shot, strike, f64::MAX, recorder)
    }

    /// As [`Self::play_strike`], but only to the time `end`, s, if the shot does not end before.
    ///
    /// # Errors
    /// See [`simulate`].
    ///
    /// # Panics
    /// As [`Self::play_strike`].
    pub fn play_until<R: Recorder>(
        &mut self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        end: f64,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        let balls = shot.balls.iter().map(|placed| (&placed.ball, &placed.state));
        self.play_among(&Surroundings::of(shot), balls, strike, end, recorder)
    }

    /// As [`Self::play_until`], with the parts of a shot: its surroundings, its balls with their states
    /// in the file's coordinates, and a strike.
    ///
    /// # Errors
    /// See [`simulate`].
    ///
    /// # Panics
    /// As [`Self::play_strike`].
    pub fn play_among<'b, R: Recorder>(
        &mut self,
        surroundings: &Surroundings<'_>,
        balls: impl Iterator<Item = (&'b Ball, &'b BallState)>,
        strike: Option<(usize, Strike)>,
        end: f64,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        self.load(surroundings, balls);
        let mut step = StepContext::new(surroundings, recorder);
        if let Some((struck, strike)) = &strike {
            assert!(*struck < self.n, "there is no ball {struck} in a shot of {} balls", self.n);
            self.on_cue_strike(*struck, strike, &mut step)?;
        }
        self.run(surroundings, end, &mut step)
    }

    /// Puts the shot's balls on the table, at time 0, before the strike.
    fn load<'b>(
        &mut self,
        surroundings: &Surroundings<'_>,
        balls: impl Iterator<Item = (&'b Ball, &'b BallState)>,
    ) {
        let Physics { cloth, gravity, .. } = surroundings.physics;
        self.n = 0;
        for (i, (ball, state)) in balls.enumerate() {
            let state = surroundings.table.to_engine_coordinates(state);
            self.n = i + 1;
            self.ball[i] = *ball;
            self.lanes.radius[i] = ball.radius;
            self.set_path(i, Path::new(&state, ball, cloth, *gravity), 0.0);
            self.contact[i] = f64::INFINITY;
            self.push[i] = Push::NONE;
            self.jam[i].forget();
            self.partners[i] = BallSet::EMPTY;
        }
        self.lanes.valid_until[self.n..].fill(f64::NAN);
        self.earliest[self.n..].fill(f64::INFINITY);
    }

    /// Runs from time 0 until no event is left, to the end time of the shot, or to `end`, s.
    fn run<R: Recorder>(
        &mut self,
        surroundings: &Surroundings<'_>,
        end: f64,
        step: &mut StepContext<'_, R>,
    ) -> Result<Summary, SimulationError> {
        let max_events = surroundings.max_events;
        let last = earlier(surroundings.until, end);
        self.find_all_candidates(step.table);
        while let Some((time, next)) = self.next(last) {
            if step.events >= max_events {
                return Err(SimulationError::TooManyEvents { max_events, time: step.time });
            }
            // Rounding can put a candidate before the event at which it was computed.
            step.time = if time > step.time { time } else { step.time };
            match next {
                NextEvent::Transition(i) => self.on_motion_transition(i, step),
                NextEvent::TableContact(i, feature) => self.on_table_contact(i, feature, step),
                NextEvent::BallContact(i, j) => self.on_ball_contact(i, j, step),
            }
        }
        let duration = if last < f64::MAX && self.any_moves() { last } else { step.time };
        Ok(Summary { duration, events: step.events })
    }

    /// Whether a ball is not at rest.
    fn any_moves(&self) -> bool {
        self.path[..self.n].iter().any(|path| !path.motion.is_at_rest())
    }

    /// Number of balls.
    pub fn len(&self) -> usize {
        self.n
    }

    /// Whether there is no ball.
    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// State of ball `i` at `time` (s), in the engine's coordinates. `time` must not be earlier
    /// than the ball's last event.
    #[inline(always)]
    pub fn state(&self, i: usize, time: f64) -> BallState {
        self.path[i].at(time - self.lanes.start[i])
    }

    /// State of ball `i` of `shot` at `time` (s), in the file's coordinates. A ball that never
    /// moved has exactly the bits of the file.
    pub fn file_state(&self, i: usize, shot: &Shot, time: f64) -> BallState {
        shot.to_file_coordinates(i, &self.state(i, time))
    }

    /// The earliest candidate in the total order of events, not later than `last`, s.
    #[inline(always)]
    fn next(&self, last: f64) -> Option<(f64, NextEvent)> {
        let time = row::least(&self.earliest, self.n);
        if time > last {
            return None;
        }
        let mut next: Option<NextEvent> = None;
        row::each_equal(&self.earliest, self.n, time, |i| {
            let other = self.candidate(i, time);
            if next.is_none_or(|next| other.rank() < next.rank()) {
                next = Some(other);
            }
        });
        next.map(|next| (time, next))
    }

    /// The event of ball `i` at `time`, which is its earliest candidate's time.
    #[inline(always)]
    fn candidate(&self, i: usize, time: f64) -> NextEvent {
        if self.transition[i] == time {
            NextEvent::Transition(i)
        } else if self.feature_time[i] == time {
            NextEvent::TableContact(i, self.feature[i])
        } else {
            NextEvent::BallContact(i, usize::from(self.partner[i]))
        }
    }

    /// The cue strikes the resting ball `struck`.
    fn on_cue_strike<R: Recorder>(
        &mut self,
        struck: usize,
        strike: &Strike,
        step: &mut StepContext<'_, R>,
    ) -> Result<(), SimulationError> {
        let before = self.path[struck].at(step.time);
        let ball = self.ball[struck];
        let (velocity, angular_velocity) =
            cue_ball::resolve(&step.physics.cue, &ball, strike).map_err(SimulationError::Strike)?;
        if step.physics.cue.model == StrikeModel::Network
            && self.on_network_strike(struck, strike, velocity, step)?
        {
            return Ok(());
        }
        let support = Support::under(&before);
        let after = support.settled(&before, velocity, angular_velocity, &ball, step.physics);
        self.begin_path(struck, &after, step);
        let kind = EventKind::CueStrike { tip_contacts: 1, pushed: false };
        step.record(kind, &[struck as u16], &[before], &[after]);
        Ok(())
    }

    /// A motion state ends by the passage of time.
    fn on_motion_transition<R: Recorder>(&mut self, i: usize, step: &mut StepContext<'_, R>) {
        let path = &self.path[i];
        if let Some(after) = path.band_end(&step.physics.cloth) {
            return self.on_band_end(i, &after, step);
        }
        let before = path.at(path.duration);
        let after = path.successor();
        let moved = path.moves();
        let kind = EventKind::MotionTransition { from: before.motion, to: after.motion };
        step.record(kind, &[i as u16], &[before], &[after]);
        if self.off_bed[i] && after.motion == MotionState::Stationary {
            return self.on_off_table(i, &after, step);
        }
        self.begin_path(i, &after, step);
        if moved {
            self.find_candidates(&[i as u16], step.time, step.table);
        } else {
            self.find_own_candidates(i, step.time, step.table);
            self.make_visible(i);
        }
    }

    /// A rolling ball comes to the end of its band of rolling resistance and rolls on in `after`.
    #[cold]
    fn on_band_end<R: Recorder>(
        &mut self,
        i: usize,
        after: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        let before = self.path[i].at(self.path[i].duration);
        let kind = EventKind::MotionTransition { from: before.motion, to: after.motion };
        self.emit(i, kind, [before, *after], step);
    }

    /// A ball meets a feature of the table.
    // Inlined, these handlers would cost the event loop a few instructions per event.
    #[inline(never)]
    fn on_table_contact<R: Recorder>(
        &mut self,
        i: usize,
        feature: TableFeature,
        step: &mut StepContext<'_, R>,
    ) {
        match feature {
            TableFeature::Cushion(part) => self.on_cushion_contact(i, part, step),
            TableFeature::Pocket(pocket) => self.on_hole(i, pocket, step),
            TableFeature::Slate => self.on_slate_contact(i, step),
            TableFeature::Lip(pocket) => self.on_lip_contact(i, pocket, step),
            TableFeature::Depth(pocket) => self.on_pocket_depth(i, pocket, step),
            TableFeature::Brink => self.on_lost_support(i, step),
            TableFeature::Border => {
                let state = self.state(i, step.time);
                self.on_off_table(i, &state, step);
            }
        }
    }

    /// Records an event of ball `i` alone, gives the ball its new path and finds its candidates.
    #[inline(always)]
    fn emit<R: Recorder>(
        &mut self,
        i: usize,
        kind: EventKind,
        [before, after]: [BallState; 2],
        step: &mut StepContext<'_, R>,
    ) {
        step.record(kind, &[i as u16], &[before], &[after]);
        self.begin_path(i, &after, step);
        self.find_candidates(&[i as u16], step.time, step.table);
    }

    /// Gives ball `i` the path that starts now in `state`.
    #[inline(always)]
    fn begin_path<R>(&mut self, i: usize, state: &BallState, step: &StepContext<'_, R>) {
        let Physics { cloth, gravity, .. } = step.physics;
        self.set_path(i, Path::new(state, &self.ball[i], cloth, *gravity), step.time);
    }

    /// Gives ball `i` the path that starts at `time`, s.
    #[inline(always)]
    fn set_path(&mut self, i: usize, path: Path, time: f64) {
        self.lanes.x[i] = path.position.x;
        self.lanes.y[i] = path.position.y;
        self.lanes.vx[i] = path.velocity.x;
        self.lanes.vy[i] = path.velocity.y;
        self.lanes.hx[i] = path.half_acceleration.x;
        self.lanes.hy[i] = path.half_acceleration.y;
        self.lanes.start[i] = time;
        self.lanes.valid_until[i] = f64::NAN;
        self.off_bed[i] = path.motion == MotionState::Airborne || path.position.z != path.radius;
        self.path[i] = path;
    }
}

/// The smaller of two times, neither of which is NaN. One instruction; `f64::min` takes several.
#[inline(always)]
fn earlier(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[cfg(all(test, feature = "json"))]
mod tests {
    use super::Simulation;
    use crate::event::NullRecorder;
    use crate::limits::SMALL_CAPACITY;
    use crate::{BallState, Shot};

    /// Final states and duration of every example shot.
    fn results(wide: bool) -> std::vec::Vec<(f64, std::vec::Vec<BallState>)> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shots");
        let mut files: std::vec::Vec<_> =
            std::fs::read_dir(folder).expect("shots/").map(|f| f.expect("a file").path()).collect();
        files.sort();
        let play = |file: &std::path::PathBuf| {
            let text = std::fs::read_to_string(file).expect("a shot file");
            let shot = Shot::from_json(&text).expect("a shot");
            let mut simulation = Simulation::<SMALL_CAPACITY>::new();
            simulation.wide &= wide;
            let summary = simulation.play(&shot, &mut NullRecorder).expect("an end");
            let states = (0..simulation.len()).map(|i| simulation.state(i, summary.duration));
            (summary.duration, states.collect())
        };
        files.iter().map(play).collect()
    }

    #[test]
    fn wide_vectors_give_the_same_bits() {
        assert_eq!(results(true), results(false));
    }
}
