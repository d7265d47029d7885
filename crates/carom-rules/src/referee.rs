//! Records what a referee needs from a shot.

use carom::event::{Event, EventKind, Recorder};
use carom::outcome::{Outcome, OutcomeRecorder, Touched};
use carom::{BallState, Shot};

use crate::layout::BallIndex;

/// Facts about the cue ball's path that some rules need and an [`Outcome`] does not hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CueBallTravel {
    /// Whether the cue ball jumped over a ball before its first contact with one.
    pub(crate) jumped_before_contact: bool,
    /// The largest y of the cue ball's centre up to its first contact (file frame, m).
    pub(crate) reached_before_contact: f64,
    /// The largest y of the cue ball's centre in the whole shot (file frame, m).
    pub(crate) reached: f64,
}

/// `outcome` of a shot whose ball `k` is ball `balls[k]` of the frame, with the frame's ball
/// indices.
pub(crate) fn renumbered(outcome: &Outcome, balls: &[BallIndex]) -> Outcome {
    let mut out = outcome.clone();
    let renumber = |k: &mut u16| *k = balls[usize::from(*k)];
    out.cue_ball.iter_mut().for_each(renumber);
    out.first_contact.iter_mut().for_each(renumber);
    out.pocketed.iter_mut().for_each(|(k, _)| renumber(k));
    out.off_table.iter_mut().for_each(renumber);
    out.hanging.iter_mut().for_each(|(k, _)| renumber(k));
    for (over, under) in &mut out.jumped {
        renumber(over);
        renumber(under);
    }
    out.rails_after_first_contact.iter_mut().for_each(|(k, _)| renumber(k));
    out.driven_to_rail.iter_mut().for_each(renumber);
    for touched in &mut out.cue_ball_touched {
        if let Touched::Ball(k) = touched {
            renumber(k);
        }
    }
    out.never_resting.iter_mut().for_each(renumber);
    out
}

/// Records the outcome of a shot and the travel of its cue ball.
pub(crate) struct RefereeRecorder<'a> {
    outcome: OutcomeRecorder<'a>,
    cue: u16,
    before_contact: bool,
    jumped_before_contact: bool,
    /// The largest y of the cue ball's centre at an event (engine frame, m): up to the first
    /// contact, and in the whole shot. A path that bends between two events may reach farther.
    reached_before_contact: f64,
    reached: f64,
}

impl<'a> RefereeRecorder<'a> {
    pub(crate) fn new(shot: &'a Shot) -> Self {
        Self {
            outcome: OutcomeRecorder::new(shot),
            cue: shot.cue_ball().unwrap_or_default() as u16,
            before_contact: true,
            jumped_before_contact: false,
            reached_before_contact: f64::NEG_INFINITY,
            reached: f64::NEG_INFINITY,
        }
    }

    /// The outcome, with the ball indices of the shot. `last` are the final states (engine frame);
    /// `middle` is half the table's length, m.
    pub(crate) fn finish(self, last: &[BallState], middle: f64) -> (Outcome, CueBallTravel) {
        let travel = CueBallTravel {
            jumped_before_contact: self.jumped_before_contact,
            reached_before_contact: self.reached_before_contact + middle,
            reached: self.reached + middle,
        };
        (self.outcome.finish(last), travel)
    }
}

impl Recorder for RefereeRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        self.outcome.record(event);
        let Some(k) = event.balls.iter().position(|ball| *ball == self.cue) else { return };
        self.reached = self.reached.max(event.before[k].position.y);
        if self.before_contact {
            self.reached_before_contact = self.reached;
            self.before_contact = event.kind != EventKind::BallCollision;
            let jumped = &self.outcome.so_far().jumped;
            self.jumped_before_contact = jumped.iter().any(|(over, _)| *over == self.cue);
        }
    }
}
