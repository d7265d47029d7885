//! Judges whole shots: listens to the engine as a [`Recorder`] and verifies, by means that share
//! nothing with the engine's own, that between all consecutive events no ball came into another,
//! into a cushion or over a hole, and that every event is one.
//!
//! Tests of single functions are not enough: an early exit on an unconverged time once let balls
//! through each other in 2 of a million shots and passed every test of the root finder.

mod bernstein;
mod closest;
mod ledger;
pub mod scenes;
mod tally;

use std::fmt;

use carom::event::{Event, EventKind, Recorder};
use carom::shot::Shot;
use carom::simulate::{SimulationError, Summary};
use carom::{BallState, MotionState};

use closest::{Curve, Feature, Intrusion};

pub use ledger::LENT;
pub use tally::Tally;

/// Deepest overlap that is let pass, m. Law 6 of ARCHITECTURE.md; an atom is 1e-10 m.
pub const DEPTH: f64 = 1e-12;

/// How far the gap at a contact may be from 0, m.
pub const CONTACT_GAP: f64 = 1e-14;

/// What is let pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Deepest overlap, m.
    pub depth: f64,
    /// Largest |gap| at a contact, m.
    pub gap: f64,
}

impl Limits {
    /// What the engine promises: [`DEPTH`] and [`CONTACT_GAP`].
    pub const PROMISED: Self = Self { depth: DEPTH, gap: CONTACT_GAP };
}

/// Kinds of [`Fault`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// A ball is in another one, in a cushion or over a hole.
    Overlap,
    /// Balls collide that do not touch.
    Apart,
    /// A ball is not where its path leads, or time goes back.
    Astray,
    /// An event raises the energy, or changes a momentum.
    Ledger,
    /// The shot does not end, or not at rest.
    Endless,
}

/// Something that must not be.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// When, s.
    pub time: f64,
    /// Of which kind.
    pub kind: FaultKind,
    /// What.
    pub what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t = {} s: {}", self.time, self.what)
    }
}

/// The judge of one shot.
#[derive(Debug)]
pub struct Checker<'a> {
    shot: &'a Shot,
    limits: Limits,
    time: f64,
    curves: Vec<Curve>,
    states: Vec<BallState>,
    since: Vec<f64>,
    /// Everything found wrong.
    pub faults: Vec<Fault>,
    /// No overlap was deeper at any time, m: a bound, [`Limits::depth`] where proving less was not
    /// tried.
    pub deepest: f64,
    /// |Gap| at each ball–ball contact, m.
    pub gaps: Vec<f64>,
    /// Number of events.
    pub events: u64,
}

impl<'a> Checker<'a> {
    /// Before the shot.
    pub fn new(shot: &'a Shot) -> Self {
        Self::with_limits(shot, Limits::PROMISED)
    }

    /// A judge who lets more pass, or less.
    pub fn with_limits(shot: &'a Shot, limits: Limits) -> Self {
        let states: Vec<BallState> =
            shot.balls().iter().map(|b| shot.table().to_engine_frame(&b.state)).collect();
        let curves = (0..states.len()).map(|i| Curve::new(shot, i, &states[i])).collect();
        Self {
            shot,
            limits,
            time: 0.0,
            since: vec![0.0; states.len()],
            curves,
            states,
            faults: Vec::new(),
            deepest: f64::NEG_INFINITY,
            gaps: Vec::new(),
            events: 0,
        }
    }

    /// Simulates `shot` and judges it.
    pub fn run(shot: &'a Shot) -> Self {
        let mut checker = Self::new(shot);
        let result = carom::simulate(shot, &mut checker);
        checker.finish(result);
        checker
    }

    /// After the shot: it has ended, and at rest.
    pub fn finish(&mut self, result: Result<Summary, SimulationError>) {
        match result {
            Ok(_) => self.at_rest(),
            Err(error) => self.fault(FaultKind::Endless, format!("not finished: {error:?}")),
        }
    }

    fn fault(&mut self, kind: FaultKind, what: String) {
        self.faults.push(Fault { time: self.time, kind, what });
    }

    /// In the end nothing moves.
    fn at_rest(&mut self) {
        for i in 0..self.states.len() {
            let s = self.states[i];
            if s.motion.in_play() && s.motion != MotionState::Stationary {
                self.fault(
                    FaultKind::Endless,
                    format!("ball {i} still {} in the end", s.motion.name()),
                );
            }
        }
    }

    /// Nothing may have met anything since the last event.
    fn interval(&mut self, until: f64) {
        let length = until - self.time;
        if length <= 0.0 {
            return;
        }
        let now = self.time;
        let curves: Vec<(usize, Curve)> = (0..self.curves.len())
            .filter(|&i| self.states[i].motion.in_play())
            .map(|i| (i, self.curves[i].from(now - self.since[i])))
            .collect();
        for (k, (i, curve)) in curves.iter().enumerate() {
            for (j, other) in &curves[..k] {
                let found = closest::pair(curve, other, length, self.limits.depth);
                self.judge(found, || format!("balls {j} and {i}"));
            }
            if curve.moves() {
                let shot = self.shot;
                closest::table(shot, curve, length, self.limits.depth, |found, feature| {
                    self.judge(found, || match feature {
                        Feature::Cushion(k) => {
                            let part = shot.table().cushions[k];
                            format!("ball {i} and the {} of {}", part.part.name(), part.rail.name())
                        }
                        Feature::Hole(k) => {
                            format!("ball {i} and the hole {}", shot.table().pockets[k].name.name())
                        }
                    });
                });
            }
        }
    }

    fn judge(&mut self, found: Intrusion, who: impl FnOnce() -> String) {
        self.deepest = self.deepest.max(found.depth);
        if found.depth > self.limits.depth {
            let (time, depth) = (self.time + found.after, found.depth);
            let what = format!("{} overlap by {depth:e} m", who());
            self.faults.push(Fault { time, kind: FaultKind::Overlap, what });
        }
    }

    /// The balls must be where their paths have led them.
    fn arrivals(&mut self, event: &Event<'_>) {
        for (&ball, before) in event.balls.iter().zip(event.before) {
            let i = usize::from(ball);
            let (place, velocity) = self.curves[i].at(event.time - self.since[i]);
            let off = (before.position.xy() - place).length();
            let speed = self.states[i].velocity.length();
            if off > 1e-12 * (1.0 + speed) || (before.velocity.xy() - velocity).length() > 1e-11 {
                self.fault(FaultKind::Astray, format!("ball {i} is {off:e} m from its path"));
            }
        }
    }

    fn contacts(&mut self, event: &Event<'_>) {
        let reach = |i: u16| self.shot.balls()[usize::from(i)].ball.radius;
        if let EventKind::BallCollision = event.kind {
            let mut closest = f64::INFINITY;
            for p in 0..event.balls.len() {
                for q in p + 1..event.balls.len() {
                    let d = event.before[q].position - event.before[p].position;
                    let gap = d.length() - (reach(event.balls[p]) + reach(event.balls[q]));
                    closest = closest.min(gap.abs());
                }
            }
            if closest > self.limits.gap && !self.starts_within(event, closest) {
                let what = format!("balls {:?} collide {closest:e} m apart", event.balls);
                self.fault(FaultKind::Apart, what);
            }
            self.gaps.push(closest);
        }
    }

    /// Balls that the shot itself places a little into each other, which is let pass as touching.
    fn starts_within(&self, event: &Event<'_>, gap: f64) -> bool {
        event.time == 0.0 && gap < carom::table::TOUCH_TOLERANCE
    }
}

impl Recorder for Checker<'_> {
    const STATES: bool = true;

    fn record(&mut self, event: &Event<'_>) {
        if event.time < self.time {
            self.fault(FaultKind::Astray, format!("time goes back from {}", self.time));
        }
        self.events += 1;
        self.interval(event.time);
        self.time = event.time;
        self.arrivals(event);
        self.contacts(event);
        if let Some(fault) = ledger::audit(self.shot, event) {
            self.fault(FaultKind::Ledger, fault);
        }
        for (k, &ball) in event.balls.iter().enumerate() {
            let i = usize::from(ball);
            self.states[i] = event.after[k];
            self.since[i] = event.time;
            self.curves[i] = Curve::new(self.shot, i, &event.after[k]);
        }
    }
}
