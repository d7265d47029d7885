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
    /// Balls that met a rail at any time, but for one to which they were frozen.
    pub driven: Vec<BallIndex>,
    /// Whether any ball was driven to a rail after the cue ball's first contact.
    pub rail_after_contact: bool,
    /// Whether the cue ball jumped over a ball.
    pub jumped: bool,
    /// Whether it did so before it touched one.
    pub jumped_first: bool,
    /// How far up the table the cue ball came before its first contact: y of its centre, m.
    pub cue_reached: f64,
    /// How far it came at all, m.
    pub cue_farthest: f64,
}

impl Facts {
    /// From the outcome of a shot whose ball `k` is `balls[k]` of the frame. The cue ball came up to
    /// `cue_reached` before its first contact; that it came no further, and jumped, if it did, before
    /// that, is taken for granted: an outcome does not tell.
    pub fn new(outcome: &Outcome, balls: &[BallIndex], cue: BallIndex, cue_reached: f64) -> Self {
        let ball = |k: &u16| balls[usize::from(*k)];
        let touch = |t: &Touched| match t {
            Touched::Ball(k) => Touch::Ball(ball(k)),
            Touched::Rail(rail) => Touch::Rail(*rail),
        };
        let jumped = outcome.jumped.iter().any(|(over, _)| ball(over) == cue);
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
            jumped,
            jumped_first: jumped,
            cue_reached,
            cue_farthest: cue_reached,
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

    /// Object balls driven to a rail; those that left the bed of the table were (WPA 8.4).
    pub fn balls_driven(&self) -> usize {
        let gone = self.potted().chain(self.thrown_off());
        let rails = self.driven.iter().filter(|ball| **ball != self.cue);
        rails.count() + gone.filter(|ball| !self.driven.contains(ball)).count()
    }

    /// Whether the cue ball was driven to a rail after its first contact.
    pub fn is_cue_ball_driven_after_contact(&self) -> bool {
        let mut after = self.touched.iter().skip_while(|t| matches!(t, Touch::Rail(_)));
        let contact = after.next().is_some();
        contact && (self.lost_cue_ball() || after.any(|t| matches!(t, Touch::Rail(_))))
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

/// Listens to a shot for its outcome, and for what that does not tell: what came before the cue ball's first
/// contact.
pub(crate) struct Witness<'a> {
    outcome: OutcomeRecorder<'a>,
    cue: u16,
    before_contact: bool,
    jumped_first: bool,
    /// The largest y of the cue ball's centre before its first contact, and at all, in the engine's frame,
    /// m. Between two events it may have come further by the bend of its path.
    reached: f64,
    farthest: f64,
}

impl<'a> Witness<'a> {
    pub(crate) fn new(shot: &'a Shot) -> Self {
        let cue = shot.cue_ball().unwrap_or_default() as u16;
        Self {
            outcome: OutcomeRecorder::new(shot),
            cue,
            before_contact: true,
            jumped_first: false,
            reached: f64::NEG_INFINITY,
            farthest: f64::NEG_INFINITY,
        }
    }

    /// What happened, in the numbers of the frame whose ball `k` of the shot is `balls[k]`; `last` are the
    /// final states, in the engine's frame.
    pub(crate) fn finish(
        self,
        balls: &[BallIndex],
        last: &[BallState],
        middle: f64,
    ) -> (Outcome, Facts) {
        let outcome = self.outcome.finish(last);
        let cue = balls[usize::from(self.cue)];
        let facts = Facts::new(&outcome, balls, cue, self.reached + middle);
        let (jumped_first, cue_farthest) = (self.jumped_first, self.farthest + middle);
        (outcome, Facts { jumped_first, cue_farthest, ..facts })
    }
}

impl Recorder for Witness<'_> {
    fn record(&mut self, event: &Event<'_>) {
        self.outcome.record(event);
        let Some(k) = event.balls.iter().position(|ball| *ball == self.cue) else { return };
        self.farthest = self.farthest.max(event.before[k].position.y);
        if self.before_contact {
            self.reached = self.farthest;
            self.before_contact = event.kind != EventKind::BallCollision;
            let jumped = &self.outcome.so_far().jumped;
            self.jumped_first = jumped.iter().any(|(over, _)| *over == self.cue);
        }
    }
}
