//! The events of a shot, as owned values.

use carom::event::{Event, EventKind, Recorder};
use carom::{BallState, Shot};

/// One event; states in the engine coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OwnedEvent {
    pub(crate) time: f64,
    pub(crate) kind: EventKind,
    pub(crate) balls: Vec<u16>,
    pub(crate) before: Vec<BallState>,
    pub(crate) after: Vec<BallState>,
}

impl OwnedEvent {
    pub(crate) fn event(&self) -> Event<'_> {
        let Self { time, kind, balls, before, after } = self;
        Event { time: *time, kind: *kind, balls, before, after }
    }
}

/// Records all events.
#[derive(Debug, Default)]
struct EventRecorder(Vec<OwnedEvent>);

impl Recorder for EventRecorder {
    fn record(&mut self, e: &Event<'_>) {
        self.0.push(OwnedEvent {
            time: e.time,
            kind: e.kind,
            balls: e.balls.to_vec(),
            before: e.before.to_vec(),
            after: e.after.to_vec(),
        });
    }
}

/// All events of `shot`.
pub(crate) fn events(shot: &Shot) -> Vec<OwnedEvent> {
    let mut recorder = EventRecorder::default();
    carom::simulate(shot, &mut recorder).unwrap_or_else(|e| panic!("{e:?}\n{}", shot.to_json()));
    recorder.0
}
