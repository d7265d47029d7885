//! Recording a shot while it is simulated.

use alloc::string::String;
use alloc::vec::Vec;

use super::{ENGINE, Log, Trace, What};
use crate::event::{Event, Recorder};
use crate::math::Vec2;
use crate::outcome::Collector;
use crate::shot::Shot;
use crate::{BallState, Table};

/// Room that is reserved at the start: a break has about a hundred and fifty events.
const USUAL_EVENTS: usize = 64;

/// Listens to a shot and makes a [`Trace`] of it.
#[derive(Clone, Debug)]
pub struct TraceRecorder<'a> {
    shot: &'a Shot,
    frame: Frame<'a>,
    log: Log,
}

/// From the engine's frame to the file's. A coordinate that has not changed since the start keeps
/// exactly what the file said, which shifting to and fro would round.
#[derive(Clone, Debug)]
struct Frame<'a> {
    shot: &'a Shot,
    table: &'a Table,
    start: Vec<Vec2>,
}

impl Frame<'_> {
    fn to_file(&self, ball: usize, state: &BallState) -> BallState {
        let mut out = self.table.to_file_frame(state);
        let written = &self.shot.balls[ball].state.position;
        if state.position.x == self.start[ball].x {
            out.position.x = written.x;
        }
        if state.position.y == self.start[ball].y {
            out.position.y = written.y;
        }
        out
    }
}

impl<'a> TraceRecorder<'a> {
    /// A recorder for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        let table = &*shot.table;
        let start = |b: &crate::shot::PlacedBall| table.to_engine_frame(&b.state).position.xy();
        let log = Log {
            entries: Vec::with_capacity(USUAL_EVENTS),
            balls: Vec::with_capacity(2 * USUAL_EVENTS),
            before: Vec::with_capacity(2 * USUAL_EVENTS),
            after: Vec::with_capacity(2 * USUAL_EVENTS),
        };
        let frame = Frame { shot, table, start: shot.balls.iter().map(start).collect() };
        Self { shot, frame, log }
    }

    /// The trace, once `last` are the balls' final states in the engine's frame and `duration`
    /// (s) is the time of the last event.
    pub fn finish(self, last: &[BallState], duration: f64) -> Trace {
        let last = last.iter().enumerate().map(|(i, s)| self.frame.to_file(i, s)).collect();
        Trace::assemble(self.shot.clone(), String::from(ENGINE), duration, self.log, last)
    }
}

impl Trace {
    pub(super) fn assemble(
        shot: Shot,
        engine: String,
        duration: f64,
        log: Log,
        last: Vec<BallState>,
    ) -> Self {
        let cue_ball = shot.cue_ball().and_then(|i| u16::try_from(i).ok());
        let mut collector = Collector::new(cue_ball);
        for entry in &log.entries {
            collector.add(entry.what, &log.balls[entry.start..entry.end]);
        }
        let mut outcome = collector.finish(&last);
        outcome.miscue = shot.is_miscue();
        Self { shot, engine, duration, log, last, outcome }
    }
}

impl Recorder for TraceRecorder<'_> {
    const STATES: bool = true;

    fn record(&mut self, event: &Event<'_>) {
        let Self { frame, log, .. } = self;
        log.push(event.time, What::of(event.kind, frame.table), event.balls);
        for (k, &ball) in event.balls.iter().enumerate() {
            log.before.push(frame.to_file(usize::from(ball), &event.before[k]));
            log.after.push(frame.to_file(usize::from(ball), &event.after[k]));
        }
    }
}
