//! A shot that was played, as the judge needs it.

use carom::event::{Event, EventKind, Recorder};
use carom::outcome::{Outcome, OutcomeRecorder};
use carom::resolve::cue_ball::Strike;
use carom::table::Part;
use carom::trace::TraceEventKind;
use carom::{BallState, Error, Shot, Simulator, Trace};

/// What happened in a shot.
#[derive(Clone, Debug)]
pub struct Played {
    /// The facts of the outcome.
    pub outcome: Outcome,
    /// How often each ball met the nose of a cushion: not the jaws of a pocket.
    pub noses: Vec<u32>,
    /// Where each ball is at the end, m, in the file's coordinates.
    pub places: Vec<[f64; 2]>,
}

impl Played {
    /// Plays `shot`, with `strike` in place of its own.
    ///
    /// # Errors
    /// As [`Simulator::play_strike`].
    pub fn of(
        simulator: &mut Simulator,
        shot: &Shot,
        strike: Option<&Strike>,
    ) -> Result<Self, Error> {
        let struck = shot.strike().map(|(ball, own)| (ball, strike.copied().unwrap_or(own)));
        let noses = NoseRecorder { shot, counts: vec![0; shot.balls().len()] };
        let mut recorder = (OutcomeRecorder::new(shot), noses);
        let end = simulator.play_strike(shot, struck, &mut recorder)?.duration;
        let last: Vec<_> = simulator.states(end).collect();
        let place = |ball| {
            let [x, y, _] = simulator.file_state(ball, shot, end).position.to_array();
            [x, y]
        };
        let places = (0..shot.balls().len()).map(place).collect();
        let (outcome, noses) = recorder;
        Ok(Self { outcome: outcome.finish(&last), noses: noses.counts, places })
    }

    /// The shot of a trace.
    pub fn of_trace(trace: &Trace) -> Self {
        let mut noses = vec![0; trace.last().len()];
        for event in trace.events() {
            if let TraceEventKind::RailCollision { part: Part::Nose, .. } = event.kind {
                noses[usize::from(event.balls[0])] += 1;
            }
        }
        let place = |state: &BallState| [state.position.x, state.position.y];
        let places = trace.last().iter().map(place).collect();
        Self { outcome: trace.outcome().clone(), noses, places }
    }

    /// Whether a ball has fallen or left the table.
    #[expect(
        clippy::manual_contains,
        reason = "`contains` does not compile for WebAssembly; see carom::outcome"
    )]
    pub fn is_gone(&self, ball: usize) -> bool {
        let ball = ball as u16;
        self.outcome.pocketed.iter().any(|(fallen, _)| *fallen == ball)
            || self.outcome.off_table.iter().any(|left| *left == ball)
    }
}

struct NoseRecorder<'a> {
    shot: &'a Shot,
    counts: Vec<u32>,
}

impl Recorder for NoseRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        if let EventKind::RailCollision(part) = event.kind
            && self.shot.table().cushions[usize::from(part)].part == Part::Nose
        {
            self.counts[usize::from(event.balls[0])] += 1;
        }
    }
}
