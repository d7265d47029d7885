//! Recording a shot while it is simulated.

use alloc::string::String;
use alloc::vec::Vec;

use super::{ENGINE, Log, Trace, TraceEnd, TraceEventKind};
use crate::BallState;
use crate::event::{Event, Recorder};
use crate::outcome::Collector;
use crate::shot::Shot;

/// Number of events for which memory is reserved at the start. A break has about 150 events.
const USUAL_EVENTS: usize = 64;

/// Records a [`Trace`] of a shot.
#[derive(Clone, Debug)]
pub struct TraceRecorder<'a> {
    shot: &'a Shot,
    log: Log,
}

impl<'a> TraceRecorder<'a> {
    /// A recorder for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        let log = Log {
            entries: Vec::with_capacity(USUAL_EVENTS),
            balls: Vec::with_capacity(2 * USUAL_EVENTS),
            before: Vec::with_capacity(2 * USUAL_EVENTS),
            after: Vec::with_capacity(2 * USUAL_EVENTS),
        };
        Self { shot, log }
    }

    /// The trace, once `last` are the balls' final states in the engine's coordinates and
    /// `duration` (s) is the time for which they hold.
    pub fn finish(self, last: &[BallState], duration: f64) -> Trace {
        let end = TraceEnd::of(self.shot, last);
        self.finish_with(last, duration, end)
    }

    /// As [`Self::finish`], for a simulation that ended at its cap on events.
    pub fn finish_at_cap(self, last: &[BallState], duration: f64) -> Trace {
        self.finish_with(last, duration, TraceEnd::Cap)
    }

    fn finish_with(self, last: &[BallState], duration: f64, end: TraceEnd) -> Trace {
        let to_file = |(i, s): (usize, &BallState)| self.shot.to_file_coordinates(i, s);
        let last = last.iter().enumerate().map(to_file).collect();
        let engine = String::from(ENGINE);
        Trace::assemble(self.shot.clone(), engine, duration, end, self.log, last)
    }
}

impl Trace {
    pub(crate) fn assemble(
        shot: Shot,
        engine: String,
        duration: f64,
        end: TraceEnd,
        log: Log,
        last: Vec<BallState>,
    ) -> Self {
        let mut collector = Collector::new(&shot);
        log.entries.iter().for_each(|entry| collector.add(&log.get(entry)));
        let outcome = collector.finish(&last);
        Self { shot, engine, duration, end, log, last, outcome }
    }
}

impl Recorder for TraceRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let Self { shot, log } = self;
        log.push(event.time, TraceEventKind::of(event.kind, &shot.table), event.balls);
        for (k, &ball) in event.balls.iter().enumerate() {
            let ball = usize::from(ball);
            log.before.push(shot.to_file_coordinates(ball, &event.before[k]));
            log.after.push(shot.to_file_coordinates(ball, &event.after[k]));
        }
    }
}
