//! The context of one step of the event loop.

use crate::event::{Event, EventKind, Recorder};
use crate::{BallState, Physics, Table};

/// What event handlers share: the surroundings of the shot, its recorder, and its progress.
pub(super) struct StepContext<'a, R> {
    pub(super) table: &'a Table,
    pub(super) physics: &'a Physics,
    /// Time of the current event, s.
    pub(super) time: f64,
    /// Events recorded so far, the strike included.
    pub(super) events: u32,
    recorder: &'a mut R,
}

impl<'a, R: Recorder> StepContext<'a, R> {
    /// The context at time 0, before any event.
    pub(super) fn new(table: &'a Table, physics: &'a Physics, recorder: &'a mut R) -> Self {
        Self { table, physics, time: 0.0, events: 0, recorder }
    }

    /// Counts an event at the current time and passes it to the recorder.
    #[inline(always)]
    pub(super) fn record(
        &mut self,
        kind: EventKind,
        balls: &[u16],
        before: &[BallState],
        after: &[BallState],
    ) {
        self.events += 1;
        self.recorder.record(&Event { time: self.time, kind, balls, before, after });
    }
}
