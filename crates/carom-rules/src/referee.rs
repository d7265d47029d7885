//! Records what a referee needs from a shot.

use carom::Shot;
use carom::event::{Event, EventKind, Recorder};
use carom::outcome::{Outcome, OutcomeMemory, Touched};

use crate::layout::{BallIndex, FROZEN};

/// A ball was only grazed if it leaves with less than this share of the cue ball's speed. For
/// equal balls that is a cut of 79° or more, where the cue ball overlaps 2 % of the object ball: 1
/// mm in pool. With a larger share, visible pushes would be legal; with a smaller one, hits that a
/// referee accepts as thin would be fouls.
const GRAZE: f64 = 0.2;

/// Facts about the cue ball's path and first hit that some rules need and an [`Outcome`] does not
/// hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CueBallTravel {
    /// Whether the cue ball jumped over a ball before its first contact with one.
    pub(crate) jumped_before_contact: bool,
    /// The largest y of the cue ball's centre up to its first contact (file coordinates, m).
    pub(crate) reached_before_contact: f64,
    /// The largest y of the cue ball's centre in the whole shot (file coordinates, m).
    pub(crate) reached: f64,
    /// The fullest hit of a near ball during the strike.
    pub(crate) near_hit: NearHit,
}

/// How full the cue ball hit, during the strike, a ball that it did not touch before. A ball with a
/// gap of at most [`FROZEN`] counts as touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum NearHit {
    /// It hit none.
    #[default]
    Nothing,
    /// It only grazed one ([`GRAZE`]).
    Grazed,
    /// It hit one more fully.
    Full,
}

impl NearHit {
    /// The fullest hit in the strike `event` of `shot` among the balls `met`. The cue ball is ball
    /// `own` of the event.
    fn of(event: &Event<'_>, own: usize, met: &[u16], shot: &Shot) -> Self {
        let radius = |k: usize| shot.balls()[usize::from(event.balls[k])].ball.radius;
        let place = |k: usize| event.before[k].position;
        let speed = |k: usize| event.after[k].velocity.length();
        let apart = |k: usize| (place(k) - place(own)).length() - radius(k) - radius(own);
        let near =
            (0..event.balls.len()).filter(|k| met.contains(&event.balls[*k]) && apart(*k) > FROZEN);
        let hit = |k| if speed(k) < GRAZE * speed(own) { Self::Grazed } else { Self::Full };
        near.map(hit).max().unwrap_or_default()
    }
}

/// Gives `outcome`, of a shot whose ball `k` is ball `balls[k]` of the frame, the frame's ball
/// indices.
pub(crate) fn renumber(outcome: &mut Outcome, balls: &[BallIndex]) {
    // The indices ascend, so they are equal if the last ones are.
    if balls.last().is_none_or(|last| usize::from(*last) + 1 == balls.len()) {
        return;
    }
    let renumber = |k: &mut u16| *k = balls[usize::from(*k)];
    outcome.cue_ball.iter_mut().for_each(renumber);
    outcome.first_contact.iter_mut().for_each(renumber);
    outcome.pocketed.iter_mut().for_each(|(k, _)| renumber(k));
    outcome.off_table.iter_mut().for_each(renumber);
    outcome.hanging.iter_mut().for_each(|(k, _)| renumber(k));
    for (over, under) in &mut outcome.jumped {
        renumber(over);
        renumber(under);
    }
    outcome.rails_after_first_contact.iter_mut().for_each(|(k, _)| renumber(k));
    outcome.driven_to_rail.iter_mut().for_each(renumber);
    for touched in &mut outcome.cue_ball_touched {
        if let Touched::Ball(k) = touched {
            renumber(k);
        }
    }
    outcome.met_during_strike.iter_mut().for_each(renumber);
    outcome.never_resting.iter_mut().for_each(renumber);
}

/// Records the outcome of a shot and the travel of its cue ball.
pub(crate) struct RefereeRecorder<'a> {
    shot: &'a Shot,
    outcome: &'a mut OutcomeMemory,
    cue: u16,
    before_contact: bool,
    jumped_before_contact: bool,
    /// The largest y of the cue ball's centre at an event (engine coordinates, m): up to the first
    /// contact, and in the whole shot. A path that bends between two events may reach farther.
    reached_before_contact: f64,
    reached: f64,
    near_hit: NearHit,
}

impl<'a> RefereeRecorder<'a> {
    /// A recorder for one simulation of `shot`. The outcome is collected in `memory`.
    pub(crate) fn new(shot: &'a Shot, memory: &'a mut OutcomeMemory) -> Self {
        memory.restart(shot);
        Self {
            shot,
            outcome: memory,
            cue: shot.cue_ball().unwrap_or_default() as u16,
            before_contact: true,
            jumped_before_contact: false,
            reached_before_contact: f64::NEG_INFINITY,
            reached: f64::NEG_INFINITY,
            near_hit: NearHit::Nothing,
        }
    }

    /// The travel of the cue ball. `middle` is half the table's length, m.
    pub(crate) fn travel(&self, middle: f64) -> CueBallTravel {
        CueBallTravel {
            jumped_before_contact: self.jumped_before_contact,
            reached_before_contact: self.reached_before_contact + middle,
            reached: self.reached + middle,
            near_hit: self.near_hit,
        }
    }
}

impl Recorder for RefereeRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        self.outcome.record(self.shot, event);
        let Some(k) = event.balls.iter().position(|ball| *ball == self.cue) else { return };
        self.reached = self.reached.max(event.before[k].position.y);
        if self.before_contact {
            self.reached_before_contact = self.reached;
            let so_far = self.outcome.outcome();
            self.before_contact = so_far.first_contact.is_none();
            self.jumped_before_contact = so_far.jumped.iter().any(|(over, _)| *over == self.cue);
        }
        if let EventKind::CueStrike { .. } = event.kind {
            let met = &self.outcome.outcome().met_during_strike;
            self.near_hit = NearHit::of(event, k, met, self.shot);
        }
    }
}
