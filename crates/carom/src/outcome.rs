//! What a referee needs to know of a shot, collected while it is simulated.

use alloc::vec::Vec;

use crate::event::{Event, Recorder};
use crate::shot::{Node, PlacedBall};
use crate::table::{PocketName, Rail};
use crate::trace::What;
use crate::{BallState, MotionState, Table};

/// What the cue ball touched.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Touched {
    /// Another ball, by index.
    Ball(u16),
    /// A cushion of this rail.
    Rail(Rail),
}

/// What happened in a shot, as rules ask for it. Balls are indices into the shot's balls.
///
/// The cue ball is the struck ball; without a strike, the ball with the id `cue`; else there is
/// none, and what speaks of it stays empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The cue ball.
    pub cue_ball: Option<u16>,
    /// The first ball that the cue ball touched.
    pub first_contact: Option<u16>,
    /// Balls in the order in which they fell, with their pockets.
    pub pocketed: Vec<(u16, PocketName)>,
    /// Every touch of a ball with a cushion after the first contact, in order; after the first
    /// collision of any two balls where there is no cue ball.
    pub rails_after_first_contact: Vec<(u16, Rail)>,
    /// Balls driven to a rail at any time in the shot, in the order of their first touch; a ball
    /// frozen to a rail counts only when it comes back to one.
    pub driven_to_rail: Vec<u16>,
    /// What the cue ball touched, in order.
    pub cue_ball_touched: Vec<Touched>,
    /// Balls that never come to rest, because friction is zero.
    pub never_resting: Vec<u16>,
    /// Whether the tip slipped off; only on request, else a miscue is an error.
    pub miscue: bool,
    /// The ball or rail that the cue would have passed through.
    pub cue_obstructed: Option<Touched>,
    /// Number of events.
    pub events: u32,
}

impl Outcome {
    /// Whether the cue ball was pocketed.
    pub fn cue_ball_scratched(&self) -> bool {
        self.cue_ball.is_some_and(|cue| self.pocketed.iter().any(|(ball, _)| *ball == cue))
    }

    /// Cushions that the cue ball touched before its first contact.
    pub fn rails_before_first_contact(&self) -> impl Iterator<Item = Rail> + '_ {
        self.cue_ball_touched.iter().map_while(|t| match t {
            Touched::Rail(rail) => Some(*rail),
            Touched::Ball(_) => None,
        })
    }

    /// The outcome as a trace shows it, with the balls' ids.
    pub fn to_node(&self, balls: &[PlacedBall]) -> Node {
        let id = |i: u16| Node::from(&balls[usize::from(i)].id);
        let ids = |list: &[u16]| Node::list(list.iter().map(|&i| id(i)));
        let touched = |t: &Touched| match *t {
            Touched::Ball(i) => Node::object([("ball", id(i))]),
            Touched::Rail(rail) => Node::object([("rail", rail.name().into())]),
        };
        let name = |t: &Touched| match *t {
            Touched::Ball(i) => id(i),
            Touched::Rail(rail) => rail.name().into(),
        };
        let mut after = Vec::new();
        for (i, ball) in balls.iter().enumerate() {
            let mine =
                |(b, rail): &(u16, Rail)| (usize::from(*b) == i).then(|| Node::from(rail.name()));
            let rails: Vec<Node> = self.rails_after_first_contact.iter().filter_map(mine).collect();
            if !rails.is_empty() {
                after.push((ball.id.clone(), Node::List(rails)));
            }
        }
        let pocketed =
            self.pocketed.iter().map(|&(i, p)| Node::List([id(i), p.name().into()].into()));
        Node::object([
            ("cue_ball", self.cue_ball.map(id).into()),
            ("first_contact", self.first_contact.map(id).into()),
            ("pocketed", Node::list(pocketed)),
            ("cue_ball_scratched", self.cue_ball_scratched().into()),
            (
                "rails_before_first_contact",
                Node::list(self.rails_before_first_contact().map(Rail::name)),
            ),
            ("rails_after_first_contact", Node::Object(after)),
            ("driven_to_rail", ids(&self.driven_to_rail)),
            ("cue_ball_touched", Node::list(self.cue_ball_touched.iter().map(touched))),
            ("never_resting", ids(&self.never_resting)),
            ("miscue", self.miscue.into()),
            ("cue_obstructed", self.cue_obstructed.as_ref().map(name).into()),
            ("events", self.events.into()),
        ])
    }
}

/// Collects an [`Outcome`] event by event.
#[derive(Clone, Debug)]
pub struct Collector {
    outcome: Outcome,
    contact: bool,
}

impl Collector {
    /// For a shot with this cue ball.
    pub fn new(cue_ball: Option<u16>) -> Self {
        Self { outcome: Outcome { cue_ball, ..Outcome::default() }, contact: false }
    }

    /// Takes the next event.
    pub fn add(&mut self, what: What, balls: &[u16]) {
        self.outcome.events += 1;
        match what {
            What::BallCollision => self.balls_collide(balls),
            What::RailCollision { rail, .. } => {
                balls.iter().for_each(|&ball| self.ball_meets_rail(ball, rail));
            }
            What::PocketCollision(pocket) => {
                self.outcome.pocketed.extend(balls.iter().map(|&ball| (ball, pocket)));
            }
            What::CueStrike
            | What::SlateCollision
            | What::OffTable
            | What::MotionTransition { .. } => {}
        }
    }

    /// The outcome, once `last` are the balls' final states.
    pub fn finish(mut self, last: &[BallState]) -> Outcome {
        let at_rest = |s: &BallState| s.motion == MotionState::Stationary || !s.motion.in_play();
        let restless = (0u16..).zip(last).filter(|(_, s)| !at_rest(s)).map(|(i, _)| i);
        self.outcome.never_resting.extend(restless);
        self.outcome
    }

    fn balls_collide(&mut self, balls: &[u16]) {
        let outcome = &mut self.outcome;
        let Some(cue) = outcome.cue_ball else {
            self.contact = true;
            return;
        };
        if !balls.contains(&cue) {
            return;
        }
        for &other in balls.iter().filter(|&&b| b != cue) {
            outcome.first_contact = outcome.first_contact.or(Some(other));
            outcome.cue_ball_touched.push(Touched::Ball(other));
        }
        self.contact = true;
    }

    fn ball_meets_rail(&mut self, ball: u16, rail: Rail) {
        let outcome = &mut self.outcome;
        if self.contact {
            outcome.rails_after_first_contact.push((ball, rail));
        }
        if !outcome.driven_to_rail.contains(&ball) {
            outcome.driven_to_rail.push(ball);
        }
        if outcome.cue_ball == Some(ball) {
            outcome.cue_ball_touched.push(Touched::Rail(rail));
        }
    }
}

/// Listens to a shot and collects its [`Outcome`]; wants no states, so it suits batches.
#[derive(Clone, Debug)]
pub struct OutcomeRecorder<'a> {
    table: &'a Table,
    collector: Collector,
}

impl<'a> OutcomeRecorder<'a> {
    /// For a shot on `table` with this cue ball.
    pub fn new(table: &'a Table, cue_ball: Option<u16>) -> Self {
        Self { table, collector: Collector::new(cue_ball) }
    }

    /// The outcome, once `last` are the balls' final states.
    pub fn finish(self, last: &[BallState]) -> Outcome {
        self.collector.finish(last)
    }
}

impl Recorder for OutcomeRecorder<'_> {
    const STATES: bool = false;

    fn record(&mut self, event: &Event<'_>) {
        self.collector.add(What::of(event.kind, self.table), event.balls);
    }
}
