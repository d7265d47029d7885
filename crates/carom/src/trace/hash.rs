//! The hash of a trace: 64 bits over the exact bits of all events and final states.
//!
//! The input is a sequence of 64-bit words ([`WordHasher`]) in the order below.
//!
//! Per event: the time; the type's number; two details (contacts of the tip − 1 and pushed, rail
//! and part, pocket and 0, from and to, or 0 and 0); the number of balls; per ball its index, its state before, its state after. Then
//! per ball its final state. A state is position, velocity, angular velocity (nine numbers) and the
//! number of its motion state. Rails, parts, pockets and motion states have the numbers of their
//! declaration, from 0. The algorithm belongs to `carom-trace/1` and changes only with that
//! version.

use super::{Trace, TraceEventKind};
use crate::event::{Event, Recorder};
use crate::hash::WordHasher;
use crate::{BallState, Shot};

fn state(hasher: &mut WordHasher, s: &BallState) {
    for v in [s.position, s.velocity, s.angular_velocity] {
        v.to_array().iter().for_each(|x| hasher.word(x.to_bits()));
    }
    hasher.word(s.motion as u64);
}

const fn numbers(kind: TraceEventKind) -> [u64; 3] {
    match kind {
        TraceEventKind::CueStrike { tip_contacts, pushed } => {
            [0, tip_contacts as u64 - 1, pushed as u64]
        }
        TraceEventKind::BallCollision => [1, 0, 0],
        TraceEventKind::RailCollision { rail, part } => [2, rail as u64, part as u64],
        TraceEventKind::PocketCollision(pocket) => [3, pocket as u64, 0],
        TraceEventKind::MotionTransition { from, to } => [4, from as u64, to as u64],
        TraceEventKind::SlateCollision => [5, 0, 0],
        TraceEventKind::OffTable => [6, 0, 0],
    }
}

/// Hashes a shot while it is simulated, to the [`Trace::hash`] of its trace, which is not kept.
///
/// ```
/// use carom::rack::{Break, Game, break_shot};
/// use carom::trace::TraceHashRecorder;
/// use carom::Simulator;
///
/// # fn main() -> Result<(), carom::Error> {
/// let shot = break_shot(&Break::new(Game::NineBall, 7))?;
/// let mut simulator = Simulator::new();
/// let mut recorder = TraceHashRecorder::new(&shot);
/// let summary = simulator.play(&shot, &mut recorder)?;
/// let states = simulator.states(summary.duration).enumerate();
/// let last: Vec<_> = states.map(|(i, state)| shot.to_file_coordinates(i, &state)).collect();
/// assert_eq!(recorder.finish(&last), simulator.record(&shot)?.hash());
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct TraceHashRecorder<'a> {
    shot: &'a Shot,
    hasher: WordHasher,
}

impl<'a> TraceHashRecorder<'a> {
    /// A recorder for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        Self { shot, hasher: WordHasher::default() }
    }

    /// The hash, once `last` are the balls' final states in the file's coordinates.
    pub fn finish(mut self, last: &[BallState]) -> u64 {
        last.iter().for_each(|s| state(&mut self.hasher, s));
        self.hasher.value()
    }
}

impl Recorder for TraceHashRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let Self { shot, hasher } = self;
        head(hasher, event.time, TraceEventKind::of(event.kind, &shot.table), event.balls.len());
        for (i, &ball) in event.balls.iter().enumerate() {
            hasher.word(u64::from(ball));
            for s in [&event.before[i], &event.after[i]] {
                state(hasher, &shot.to_file_coordinates(ball.into(), s));
            }
        }
    }
}

/// What comes before the balls of an event.
fn head(hasher: &mut WordHasher, time: f64, kind: TraceEventKind, balls: usize) {
    hasher.word(time.to_bits());
    numbers(kind).into_iter().for_each(|n| hasher.word(n));
    hasher.word(balls as u64);
}

impl Trace {
    /// 64 bits over the exact bits of all events and final states.
    pub fn hash(&self) -> u64 {
        let mut hasher = WordHasher::default();
        for event in self.events() {
            head(&mut hasher, event.time, event.kind, event.balls.len());
            for (i, &ball) in event.balls.iter().enumerate() {
                hasher.word(u64::from(ball));
                state(&mut hasher, &event.before[i]);
                state(&mut hasher, &event.after[i]);
            }
        }
        self.last.iter().for_each(|s| state(&mut hasher, s));
        hasher.value()
    }
}
