//! Helpers of the whole-shot tests.

use carom::event::{Event, EventKind, Recorder};
use carom::{BallState, Shot, Summary};

/// A copy of one event.
#[derive(Clone, Debug)]
pub(crate) struct RecordedEvent {
    pub(crate) time: f64,
    pub(crate) kind: EventKind,
    pub(crate) balls: Vec<usize>,
    pub(crate) before: Vec<BallState>,
    pub(crate) after: Vec<BallState>,
}

/// Keeps every event.
#[derive(Debug, Default)]
pub(crate) struct LogRecorder {
    pub(crate) events: Vec<RecordedEvent>,
}

impl Recorder for LogRecorder {
    fn record(&mut self, event: &Event<'_>) {
        self.events.push(RecordedEvent {
            time: event.time,
            kind: event.kind,
            balls: event.balls.iter().map(|&i| usize::from(i)).collect(),
            before: event.before.to_vec(),
            after: event.after.to_vec(),
        });
    }
}

impl LogRecorder {
    pub(crate) fn of(&self, wanted: impl Fn(&EventKind) -> bool) -> Vec<&RecordedEvent> {
        self.events.iter().filter(|e| wanted(&e.kind)).collect()
    }
    pub(crate) fn ball_collisions(&self) -> Vec<&RecordedEvent> {
        self.of(|k| matches!(k, EventKind::BallCollision))
    }
    pub(crate) fn rail_collisions(&self) -> Vec<&RecordedEvent> {
        self.of(|k| matches!(k, EventKind::RailCollision(_)))
    }
    /// The last state of ball `i`, or its state before the shot in the engine's coordinates.
    pub(crate) fn last(&self, shot: &Shot, i: usize) -> BallState {
        let found = self.events.iter().rev().find_map(|e| {
            let k = e.balls.iter().position(|&b| b == i)?;
            Some(e.after[k])
        });
        found.unwrap_or_else(|| shot.table().to_engine_coordinates(&shot.balls()[i].state))
    }
}

/// Reads a shot file; the text leaves out `format`.
pub(crate) fn shot(body: &str) -> Shot {
    let text = format!("{{\"format\": \"carom-shot/1\", {body}}}");
    Shot::from_json(&text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Simulates and keeps every event.
pub(crate) fn play(shot: &Shot) -> (LogRecorder, Summary) {
    let mut log = LogRecorder::default();
    let summary = carom::simulate(shot, &mut log).expect("the shot ends");
    (log, summary)
}

/// Kinetic energy of the balls of an event, J.
pub(crate) fn energy(shot: &Shot, balls: &[usize], states: &[BallState]) -> f64 {
    balls.iter().zip(states).map(|(&i, s)| shot.balls()[i].ball.kinetic_energy(s)).sum()
}
