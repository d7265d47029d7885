//! The context of one step of the event loop.

use super::Surroundings;
use crate::event::{Event, EventKind, Recorder};
use crate::physics::{BallBall, SlipFriction};
use crate::shot::Cling;
use crate::table::TableGeometry;
use crate::{BallState, Physics};

/// What event handlers share: the surroundings of the shot, its recorder, and its progress.
pub(super) struct StepContext<'a, R> {
    pub(super) table: &'a TableGeometry,
    pub(super) physics: &'a Physics,
    /// Time of the current event, s.
    pub(super) time: f64,
    /// Events recorded so far, the strike included.
    pub(super) events: u32,
    /// The contacts of two balls that cling; `None` in a shot without any.
    cling: Option<&'a Cling>,
    /// Contacts of two balls so far; counted only if some cling.
    pair_contacts: u32,
    recorder: &'a mut R,
}

impl<'a, R: Recorder> StepContext<'a, R> {
    /// The context at time 0, before any event.
    pub(super) fn new(surroundings: &Surroundings<'a>, recorder: &'a mut R) -> Self {
        let Surroundings { table, physics, cling, .. } = *surroundings;
        let cling = Some(cling).filter(|cling| !cling.is_empty());
        Self { table, physics, time: 0.0, events: 0, cling, pair_contacts: 0, recorder }
    }

    /// The law of the next contact of two balls, if it clings. Counts this contact.
    #[inline(always)]
    pub(super) fn next_cling(&mut self) -> Option<BallBall> {
        let cling = self.cling?;
        let contact = self.pair_contacts;
        self.pair_contacts += 1;
        let friction = SlipFriction::constant(cling.friction());
        cling.contains(contact).then_some(BallBall { friction, ..self.physics.ball_ball })
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
