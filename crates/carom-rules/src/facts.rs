//! What happened in a shot, as the rules ask for it, in the frame's numbers of the balls.

use carom::event::{Event, EventKind, Recorder};
use carom::outcome::{Outcome, OutcomeRecorder, Touched};
use carom::table::{PocketName, Rail};
use carom::{BallState, Shot};

use crate::BallIndex;

/// What the cue ball touched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// A ball.
    Ball(BallIndex),
    /// A cushion.
    Rail(Rail),
}

/// What happened in a shot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// The cue ball.
    pub cue: BallIndex,
    /// Balls with their pockets, in the order in which they fell; the cue ball too.
    pub pocketed: Vec<(BallIndex, PocketName)>,
    /// Balls that left the table; the cue ball too.
    pub off_table: Vec<BallIndex>,
    /// What the cue ball touched, in order.
    pub touched: Vec<Touch>,
    /// Balls driven to a rail (WPA 8.4), at any time.
    pub driven: Vec<BallIndex>,
    /// Whether any ball was driven to a rail after the cue ball's first contact.
    pub rail_after_contact: bool,
    /// Whether the cue ball jumped over a ball.
    pub jumped: bool,
    /// How far up the table the cue ball came before its first contact: y of its centre, m.
    pub cue_reached: f64,
}

impl Facts {
    /// From the outcome of a shot whose ball `k` is `balls[k]` of the frame; the cue ball came up to
    /// `cue_reached`.
    pub fn new(outcome: &Outcome, balls: &[BallIndex], cue: BallIndex, cue_reached: f64) -> Self {
        let ball = |k: &u16| balls[usize::from(*k)];
        let touch = |t: &Touched| match t {
            Touched::Ball(k) => Touch::Ball(ball(k)),
            Touched::Rail(rail) => Touch::Rail(*rail),
        };
        let driven: Vec<BallIndex> = outcome.driven_to_rail.iter().map(ball).collect();
        let after = outcome.rails_after_first_contact.iter().map(|(k, _)| ball(k));
        Self {
            cue,
            pocketed: outcome.pocketed.iter().map(|(k, pocket)| (ball(k), *pocket)).collect(),
            off_table: outcome.off_table.iter().map(ball).collect(),
            touched: outcome.cue_ball_touched.iter().map(touch).collect(),
            // A ball pressed into the rail that it is frozen to is not driven to it.
            rail_after_contact: after.filter(|b| driven.contains(b)).count() > 0,
            driven,
            jumped: outcome.jumped.iter().any(|(over, _)| ball(over) == cue),
            cue_reached,
        }
    }

    /// The first ball that the cue ball touched.
    pub fn first_contact(&self) -> Option<BallIndex> {
        self.touched.iter().find_map(|t| match t {
            Touch::Ball(ball) => Some(*ball),
            Touch::Rail(_) => None,
        })
    }

    /// The pocket that took `ball`.
    pub fn pocket_of(&self, ball: BallIndex) -> Option<PocketName> {
        self.pocketed.iter().find(|(b, _)| *b == ball).map(|(_, pocket)| *pocket)
    }

    /// Whether the cue ball was pocketed.
    pub fn is_scratch(&self) -> bool {
        self.pocket_of(self.cue).is_some()
    }

    /// Whether the cue ball left the table, into a pocket or otherwise.
    pub fn lost_cue_ball(&self) -> bool {
        self.is_scratch() || self.off_table.contains(&self.cue)
    }

    /// The object balls that were pocketed, in order.
    pub fn potted(&self) -> impl Iterator<Item = BallIndex> + '_ {
        self.pocketed.iter().map(|(ball, _)| *ball).filter(|ball| *ball != self.cue)
    }

    /// The object balls that left the table.
    pub fn thrown_off(&self) -> impl Iterator<Item = BallIndex> + '_ {
        self.off_table.iter().copied().filter(|ball| *ball != self.cue)
    }
}

/// Listens to a shot for its outcome, and for how far the cue ball came before it touched a ball.
pub(crate) struct Witness<'a> {
    outcome: OutcomeRecorder<'a>,
    cue: u16,
    before_contact: bool,
    /// In the engine's frame, m.
    reached: f64,
}

impl<'a> Witness<'a> {
    pub(crate) fn new(shot: &'a Shot) -> Self {
        let cue = shot.cue_ball().unwrap_or_default() as u16;
        Self {
            outcome: OutcomeRecorder::new(shot),
            cue,
            before_contact: true,
            reached: f64::NEG_INFINITY,
        }
    }

    /// The outcome, and the largest y (m, in the file's frame) that the cue ball's centre came to before
    /// its first contact. Between two events it may have come further by the bend of its path.
    pub(crate) fn finish(self, shot: &Shot, last: &[BallState]) -> (Outcome, f64) {
        (self.outcome.finish(last), self.reached + 0.5 * shot.table().size.y)
    }
}

impl Recorder for Witness<'_> {
    const STATES: bool = true;

    fn record(&mut self, event: &Event<'_>) {
        if self.before_contact {
            let states = event.balls.iter().zip(event.before);
            for (_, state) in states.filter(|(ball, _)| **ball == self.cue) {
                self.reached = self.reached.max(state.position.y);
                self.before_contact = event.kind != EventKind::BallCollision;
            }
        }
        self.outcome.record(event);
    }
}
