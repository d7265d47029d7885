//! The event loop (Leckie & Greenspan 2006, figure 1).
//!
//! Every ball has a clock of its own: the closed-form path of its present motion state and the
//! time at which that began. An event advances only the balls that take part in it; a resting
//! ball never drifts. After it, only those balls' candidates are found anew.
//!
//! **Order of events at one instant**: motion transitions; then the slate, the holes in it and the
//! table's edge; then cushions; then ball–ball contacts; among equals the ball that stands first in
//! the shot. Balls that touch when one of them is hit are resolved together
//! (`resolve/ball_ball/network.rs`).

mod ball_set;
mod candidates;
mod cluster;
mod flight;
mod impact;
mod row;
mod support;

use core::marker::PhantomData;

use crate::detect::ball_ball::{ContactFinder, FirstContact};
use crate::detect::ball_table::TableFeature;
use crate::event::{Event, EventKind, Recorder};
use crate::limits::{MAX_BALLS, SMALL_CAPACITY};
use crate::motion::Path;
use crate::resolve::cue_ball::{self, Strike, StrikeError};
use crate::shot::Shot;
use crate::{Ball, BallState, MotionState, Physics, Table};
use ball_set::BallSet;
pub(crate) use cluster::CLOSING_TIME;
use support::Support;

/// Every capacity is a multiple of this: the doubles of the widest vector register.
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

/// What every shot ends with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Time of the last event, s.
    pub duration: f64,
    /// Number of events, the strike included.
    pub events: u32,
}

/// Simulates `shot` from the strike to rest and tells `recorder` every event.
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

/// The mutable state of a shot of at most `N` balls. Reusable: [`Simulation::load`] starts anew.
///
/// `N` is a multiple of 8, since balls are looked at in rows of vector registers, and at most
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
pub struct Simulation<const N: usize, F: ContactFinder = FirstContact> {
    n: usize,
    ball: [Ball; N],
    /// Path of the present motion state.
    path: [Path; N],
    /// The part of it that pairs are searched with.
    lanes: Lanes<N>,
    /// Next motion transition, infinite if none.
    transition: [f64; N],
    /// Next cushion or pocket, infinite if none.
    meeting: [f64; N],
    feature: [TableFeature; N],
    /// First contact with another ball, infinite if none, and with which.
    contact: [f64; N],
    partner: [u16; N],
    /// The earliest of the three, infinite where there is no ball.
    soonest: [f64; N],
    /// When each ball was last in a contact, −∞ if never.
    touched: [f64; N],
    /// Whether each ball is off the slate: in flight, on a rail's top, in a hole.
    aloft: [bool; N],
    /// First contact of every pair that may meet, symmetric.
    pair: [[f64; N]; N],
    /// With whom each ball may.
    may_meet: [BallSet; N],
    /// Whether the processor has vectors wide enough for [`row`].
    wide: bool,
    finder: PhantomData<F>,
}

/// Where every ball is and goes in the plane, laid out for vector instructions.
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
    /// Until when it holds, s: the earlier of transition and meeting for a ball that moves,
    /// infinite for one that rests, NaN where there is no ball, it is out of play, or its path is so new
    /// that its own row has not been looked at.
    leave: [f64; N],
    radius: [f64; N],
}

/// What happens next.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Next {
    Transition(usize),
    Meeting(usize, TableFeature),
    Contact(usize, usize),
}

impl Next {
    /// Events of one instant happen in this order.
    fn rank(self) -> u8 {
        match self {
            Self::Transition(_) => 0,
            Self::Meeting(_, TableFeature::Cushion(_)) => 2,
            Self::Meeting(..) => 1,
            Self::Contact(..) => 3,
        }
    }
}

impl<const N: usize, F: ContactFinder> Default for Simulation<N, F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Most balls that fit.
    pub const CAPACITY: usize = N;

    /// An empty table.
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
                leave: [f64::NAN; N],
                radius: [0.0; N],
            },
            transition: [f64::INFINITY; N],
            meeting: [f64::INFINITY; N],
            feature: [TableFeature::Cushion(0); N],
            contact: [f64::INFINITY; N],
            partner: [0; N],
            soonest: [f64::INFINITY; N],
            touched: [f64::NEG_INFINITY; N],
            aloft: [false; N],
            wide: row::has_wide_vectors(),
            pair: [[f64::INFINITY; N]; N],
            may_meet: [BallSet::EMPTY; N],
            finder: PhantomData,
        }
    }

    /// Plays a whole shot: [`load`](Self::load), [`strike`](Self::strike), [`run`](Self::run).
    ///
    /// # Errors
    /// See [`simulate`].
    pub fn play<R: Recorder>(
        &mut self,
        shot: &Shot,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        self.play_strike(shot, shot.strike, recorder)
    }

    /// Plays `shot` with another strike, on the ball with the given index, than its own.
    ///
    /// # Errors
    /// See [`simulate`].
    pub fn play_strike<R: Recorder>(
        &mut self,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        self.load(shot);
        let mut events = 0;
        if let Some((struck, strike)) = &strike {
            self.strike(*struck, strike, &shot.physics, recorder)?;
            events = 1;
        }
        self.run(&shot.table, &shot.physics, shot.max_events, events, recorder)
    }

    /// Puts the shot's balls on the table, at time 0, before the strike.
    ///
    /// # Panics
    /// If the shot has more than `N` balls.
    pub fn load(&mut self, shot: &Shot) {
        let Physics { cloth, gravity, .. } = &*shot.physics;
        self.n = shot.balls.len();
        for (i, placed) in shot.balls.iter().enumerate() {
            let state = shot.table.to_engine_frame(&placed.state);
            self.ball[i] = placed.ball;
            self.lanes.radius[i] = placed.ball.radius;
            self.set(i, Path::new(&state, &placed.ball, cloth, *gravity), 0.0);
            self.contact[i] = f64::INFINITY;
            self.touched[i] = f64::NEG_INFINITY;
            self.may_meet[i] = BallSet::EMPTY;
        }
        self.lanes.leave[self.n..].fill(f64::NAN);
        self.soonest[self.n..].fill(f64::INFINITY);
    }

    /// Strikes the resting ball `struck` at time 0.
    ///
    /// # Errors
    /// If the strike cannot be played.
    pub fn strike<R: Recorder>(
        &mut self,
        struck: usize,
        strike: &Strike,
        physics: &Physics,
        recorder: &mut R,
    ) -> Result<(), SimulationError> {
        let before = self.path[struck].at(0.0);
        let ball = self.ball[struck];
        let (velocity, angular_velocity) =
            cue_ball::resolve(&physics.cue, &ball, strike).map_err(SimulationError::Strike)?;
        let support = Support::under(&before);
        let after = support.settled(&before, velocity, angular_velocity, &ball, physics);
        self.begin(struck, &after, 0.0, physics);
        recorder.record(&Event {
            time: 0.0,
            kind: EventKind::CueStrike,
            balls: &[struck as u16],
            before: &[before],
            after: &[after],
        });
        Ok(())
    }

    /// Runs from time 0 until nothing moves, or until nothing more can happen.
    ///
    /// # Errors
    /// If there are more than `max_events` events; `events` have happened already.
    pub fn run<R: Recorder>(
        &mut self,
        table: &Table,
        physics: &Physics,
        max_events: u32,
        mut events: u32,
        recorder: &mut R,
    ) -> Result<Summary, SimulationError> {
        let mut time = 0.0;
        self.find_all(table);
        while let Some((at, next)) = self.next() {
            if events >= max_events {
                return Err(SimulationError::TooManyEvents { max_events, time });
            }
            // A candidate is found relative to its own instant and then rounded: never go back.
            time = if at > time { at } else { time };
            events += match next {
                Next::Transition(i) => self.transit(i, time, table, physics, recorder),
                Next::Meeting(i, TableFeature::Cushion(k)) => {
                    self.rebound(i, k, time, table, physics, recorder)
                }
                Next::Meeting(i, feature) => self.leave(i, feature, time, table, physics, recorder),
                Next::Contact(i, j) => self.collide(i, j, time, table, physics, recorder),
            };
        }
        Ok(Summary { duration: time, events })
    }

    /// Number of balls.
    pub fn len(&self) -> usize {
        self.n
    }

    /// Whether there is no ball.
    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// State of ball `i` at `time` (s), which must not lie before its last event.
    #[inline(always)]
    pub fn state(&self, i: usize, time: f64) -> BallState {
        self.path[i].at(time - self.lanes.start[i])
    }

    /// State of ball `i` of `shot` at `time`, in the file's frame; a ball that never moved has the
    /// very bits of the file.
    pub fn file_state(&self, i: usize, shot: &Shot, time: f64) -> BallState {
        shot.to_file_frame(i, &self.state(i, time))
    }

    /// The earliest candidate in the total order of events.
    #[inline(always)]
    fn next(&self) -> Option<(f64, Next)> {
        let time = row::least(&self.soonest, self.n);
        if time == f64::INFINITY {
            return None;
        }
        let mut next: Option<Next> = None;
        row::each_equal(&self.soonest, self.n, time, |i| {
            let other = self.candidate(i, time);
            if next.is_none_or(|next| other.rank() < next.rank()) {
                next = Some(other);
            }
        });
        next.map(|next| (time, next))
    }

    /// What ball `i` does at `time`, the time of its soonest candidate.
    #[inline(always)]
    fn candidate(&self, i: usize, time: f64) -> Next {
        if self.transition[i] == time {
            Next::Transition(i)
        } else if self.meeting[i] == time {
            Next::Meeting(i, self.feature[i])
        } else {
            Next::Contact(i, usize::from(self.partner[i]))
        }
    }

    /// A motion state ends by the passage of time. Returns the number of events.
    fn transit<R: Recorder>(
        &mut self,
        i: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let path = &self.path[i];
        let before = path.at(path.duration);
        let after = path.successor();
        let moved = path.moves();
        recorder.record(&Event {
            time,
            kind: EventKind::MotionTransition { from: before.motion, to: after.motion },
            balls: &[i as u16],
            before: &[before],
            after: &[after],
        });
        if self.aloft[i] && after.motion == MotionState::Stationary {
            return 1 + self.retire(i, &after, time, table, physics, recorder);
        }
        self.begin(i, &after, time, physics);
        if moved {
            self.find(&[i as u16], time, table);
        } else {
            self.find_self(i, time, table);
            self.enter_lanes(i);
        }
        1
    }

    /// Gives ball `i` the path that starts at `time` in `state`.
    #[inline(always)]
    fn begin(&mut self, i: usize, state: &BallState, time: f64, physics: &Physics) {
        self.set(i, Path::new(state, &self.ball[i], &physics.cloth, physics.gravity), time);
    }

    /// Gives ball `i` the path that starts at `time`.
    #[inline(always)]
    fn set(&mut self, i: usize, path: Path, time: f64) {
        self.lanes.x[i] = path.position.x;
        self.lanes.y[i] = path.position.y;
        self.lanes.vx[i] = path.velocity.x;
        self.lanes.vy[i] = path.velocity.y;
        self.lanes.hx[i] = path.half_acceleration.x;
        self.lanes.hy[i] = path.half_acceleration.y;
        self.lanes.start[i] = time;
        self.lanes.leave[i] = f64::NAN;
        self.aloft[i] = path.motion == MotionState::Airborne || path.position.z != path.radius;
        self.path[i] = path;
    }
}

/// The smaller of two times that are not NaN: one instruction, where `f64::min` takes several.
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
