//! Checks whole shots. A [`CheckRecorder`] receives the events of a shot and verifies them: between
//! consecutive events no ball may overlap another ball or the table, leave the table unnoticed, or
//! roll where there is no ground; each event must happen where it can, and must conserve what
//! mechanics conserves.
//!
//! The checker has its own equations of motion, its own search for the closest approach (Bernstein
//! polynomials and distance bounds, where the engine uses Newton's and Halley's methods), and its
//! own tables, constructed from the figures of the rule books as solid pieces. It shares with the
//! engine: the shot file's reader, the initial states, the physics' numbers, and the dimensions of
//! tables that are not published. An error in these is not detected here.
//!
//! These are not checked: the law of two balls alone where they meet more slowly than 1.1 mm/s, or
//! than 50 mm/s if one is in the air; the impulses of the ball–ball model `mathavan-2014` between
//! balls on the cloth; how much energy a collision of several balls loses. Balls that still approach
//! after such a collision are counted ([`CheckRecorder::left_approaching`]) and do not make a shot
//! faulty.
//!
//! Tests of single functions are not enough: an early exit on an unconverged time once let balls
//! pass through each other in 2 of a million shots and passed every test of the root finder.

mod bernstein;
mod clearance;
mod closest;
mod conservation;
mod curve;
mod motion_states;
mod places;
mod pushes;
mod rail_laws;
pub mod random;
pub mod random_shots;
mod rolling;
mod sampled;
mod solid;
mod table;
mod table_contact;
mod tally;

use std::fmt;
use std::rc::Rc;

use carom::event::{Event, EventKind, Recorder};
use carom::physics::{BallBall, SlipFriction};
use carom::shot::Shot;
use carom::simulate::{SimulationError, Summary};
use carom::{BallState, MotionState};

use closest::Intrusion;
use conservation::Circumstances;
use curve::{Curve, Turning};
use places::{Ground, ground};
use pushes::Pushes;
use solid::Solid;

pub use conservation::PUSH_ENERGY;
pub use places::TABLE_GAP;
pub use sampled::{SAMPLED_DEPTH, check_samples};
pub use tally::{LEFT_APPROACHING, Tally};

/// Largest allowed overlap, m (law 6 of ARCHITECTURE.md). An atom is 1e-10 m.
pub const DEPTH: f64 = 1e-12;

/// Largest allowed |gap| at a contact, m.
pub const CONTACT_GAP: f64 = 1e-14;

/// Fraction of the time to an event, just below 1. After this fraction of one second a ball at
/// 10 m/s is a nanometre before the place of the event.
const BEFORE_THE_END: f64 = 1.0 - 1e-10;

/// Allowed errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Largest overlap, m.
    pub depth: f64,
    /// Largest |gap| at a contact, m.
    pub gap: f64,
}

impl Tolerances {
    /// The engine's guarantee: [`DEPTH`] and [`CONTACT_GAP`].
    pub const PROMISED: Self = Self { depth: DEPTH, gap: CONTACT_GAP };
}

/// Kinds of [`Fault`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// A ball overlaps another ball or the table, is beyond the table's border, or rolls where
    /// there is no ground.
    Overlap,
    /// A collision happens between balls that do not touch.
    Apart,
    /// An event happens at a place, or to a ball, where it cannot.
    Misplaced,
    /// A ball is not on its path, or time runs backwards.
    OffPath,
    /// A ball does not move as its motion state says, or its spin jumps where a state ends.
    Motion,
    /// An event raises the energy, or does not conserve a momentum.
    Conservation,
    /// A table with the name of a rule book's has another dimension.
    Dimensions,
    /// The shot does not end, or balls move after its end.
    NotAtRest,
}

impl FaultKind {
    /// All of them, in the order of declaration.
    pub const ALL: [Self; 8] = [
        Self::Overlap,
        Self::Apart,
        Self::Misplaced,
        Self::OffPath,
        Self::Motion,
        Self::Conservation,
        Self::Dimensions,
        Self::NotAtRest,
    ];

    /// The name in tables and stored results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Overlap => "overlap",
            Self::Apart => "apart",
            Self::Misplaced => "misplaced",
            Self::OffPath => "off-path",
            Self::Motion => "motion",
            Self::Conservation => "conservation",
            Self::Dimensions => "dimensions",
            Self::NotAtRest => "not-at-rest",
        }
    }
}

/// An error in a shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Time, s.
    pub time: f64,
    /// Kind.
    pub kind: FaultKind,
    /// Description.
    pub what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t = {} s: {}", self.time, self.what)
    }
}

/// Checks one shot while it is simulated.
#[derive(Debug)]
pub struct CheckRecorder<'a> {
    shot: &'a Shot,
    tolerances: Tolerances,
    time: f64,
    solid: Rc<Solid>,
    curves: Vec<Curve>,
    turnings: Vec<Turning>,
    states: Vec<BallState>,
    since: Vec<f64>,
    pushes: Pushes,
    /// Collisions of exactly two balls so far.
    pair_contacts: u32,
    /// All errors found.
    pub faults: Vec<Fault>,
    /// Upper bound of the overlaps at all times, m. It is [`Tolerances::depth`] where no smaller
    /// bound was proved.
    pub deepest: f64,
    /// |Gap| at each ball–ball contact, m.
    pub gaps: Vec<f64>,
    /// Number of events.
    pub events: u64,
    /// The largest approach that a collision of more than two balls has left between two touching
    /// balls, as a fraction of the fastest approach before it. They meet again at the same instant.
    pub left_approaching: f64,
}

impl<'a> CheckRecorder<'a> {
    /// For one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        Self::with_tolerances(shot, Tolerances::PROMISED)
    }

    /// For one simulation of `shot`, with other tolerances.
    pub fn with_tolerances(shot: &'a Shot, tolerances: Tolerances) -> Self {
        let solid = Rc::new(Solid::of(shot.table()));
        let origin = solid.plan.center().with_z(0.0);
        let placed = |s: &BallState| BallState { position: s.position - origin, ..*s };
        let states: Vec<BallState> = shot.balls().iter().map(|b| placed(&b.state)).collect();
        let each = || 0..states.len();
        let unlike = |key: &String| Fault {
            time: 0.0,
            kind: FaultKind::Dimensions,
            what: format!("{key} is not the published one"),
        };
        Self {
            shot,
            tolerances,
            time: 0.0,
            since: vec![0.0; states.len()],
            pushes: Pushes::new(states.len()),
            pair_contacts: 0,
            faults: solid.plan.unlike.iter().map(unlike).collect(),
            solid,
            curves: each().map(|i| Curve::new(shot, i, &states[i])).collect(),
            turnings: each().map(|i| Turning::new(shot, i, &states[i])).collect(),
            states,
            deepest: f64::NEG_INFINITY,
            gaps: Vec::new(),
            events: 0,
            left_approaching: 0.0,
        }
    }

    /// Simulates and checks `shot`.
    pub fn run(shot: &'a Shot) -> Self {
        let mut checker = Self::new(shot);
        let result = carom::simulate(shot, &mut checker);
        checker.finish(result);
        checker
    }

    /// Completes the check with the result of the simulation: the shot must have ended, with all
    /// balls at rest.
    pub fn finish(&mut self, result: Result<Summary, SimulationError>) {
        match result {
            Ok(_) => self.check_rest(),
            Err(error) => self.fault(FaultKind::NotAtRest, format!("not finished: {error:?}")),
        }
    }

    /// The law of two balls in an event: that of the physics, or with the friction of a cling.
    /// Counts the contacts of two balls.
    fn law_of(&mut self, event: &Event<'_>) -> BallBall {
        let law = self.shot.physics().ball_ball;
        if event.kind != EventKind::BallCollision || event.balls.len() != 2 {
            return law;
        }
        let contact = self.pair_contacts;
        self.pair_contacts += 1;
        let cling = self.shot.cling();
        if !cling.contacts().any(|clung| clung == contact) {
            return law;
        }
        BallBall { friction: SlipFriction { a: cling.friction(), b: 0.0, c: 0.0 }, ..law }
    }

    fn fault(&mut self, kind: FaultKind, what: String) {
        self.faults.push(Fault { time: self.time, kind, what });
    }

    /// After the shot all balls in play must be at rest on the bed.
    fn check_rest(&mut self) {
        for i in 0..self.states.len() {
            let s = self.states[i];
            if !s.motion.in_play() {
                continue;
            }
            let on_bed = ground(&self.solid, &s, self.curves[i].radius) == Some(Ground::Bed);
            if s.motion != MotionState::Stationary || !on_bed {
                let (motion, z) = (s.motion.name(), s.position.z);
                let what = format!("ball {i} still {motion} in the end, at z = {z:e} m");
                self.fault(FaultKind::NotAtRest, what);
            }
        }
    }

    /// Checks that nothing has touched since the last event.
    fn check_interval(&mut self, until: f64) {
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
                let found = closest::pair(curve, other, length, self.tolerances.depth);
                self.report_overlap(found, || format!("balls {j} and {i}"));
            }
            if curve.moves() {
                self.check_table(*i, curve, length);
            }
        }
    }

    /// Checks that a moving ball stays clear of the table, inside its border and, unless it flies,
    /// on the ground.
    fn check_table(&mut self, i: usize, curve: &Curve, length: f64) {
        let solid = Rc::clone(&self.solid);
        let tolerance = self.tolerances.depth;
        clearance::table(&solid, curve, length, tolerance, |found, name| {
            self.report_overlap(found, || format!("ball {i} and {name}"));
        });
        if !clearance::over_cloth(&solid, curve, length) {
            let found = clearance::border(&solid, curve, length);
            self.report_overlap(found, || format!("ball {i} and the border"));
        }
        if self.states[i].motion == MotionState::Airborne {
            return;
        }
        if solid.is_on_top(curve.p.z, curve.radius) {
            // Within one motion state a ball does not leave a top and return to it, so two times
            // suffice.
            let beside = |t: f64| solid.beside_tops(curve.place(t).xy());
            // At the end itself it may be on either side of the edge by rounding.
            let depth = beside(0.5 * length).max(beside(length * BEFORE_THE_END));
            let found = Intrusion { depth, after: length };
            self.report_overlap(found, || format!("ball {i} and the edge of the top under it"));
        } else {
            // A ball that hangs over a lip may roll back, but no farther over it.
            let hung = places::overhang(&solid, curve.p.xy(), curve.radius);
            for &(center, radius) in &solid.holes {
                let mut found = closest::hole(curve, center, radius, length, tolerance);
                found.depth -= hung;
                self.report_overlap(found, || format!("ball {i} and the hole under it"));
            }
        }
    }

    fn report_overlap(&mut self, found: Intrusion, who: impl FnOnce() -> String) {
        self.deepest = self.deepest.max(found.depth);
        if found.depth.is_nan() {
            let what = format!("{} are not proved to be clear of each other", who());
            self.faults.push(Fault { time: self.time, kind: FaultKind::Overlap, what });
        } else if found.depth > self.tolerances.depth {
            let (time, depth) = (self.time + found.after, found.depth);
            let what = format!("{} overlap by {depth:e} m", who());
            self.faults.push(Fault { time, kind: FaultKind::Overlap, what });
        }
    }

    /// Checks that the balls of an event are on their paths.
    fn check_paths(&mut self, event: &Event<'_>) {
        for (&ball, before) in event.balls.iter().zip(event.before) {
            let i = usize::from(ball);
            let since = event.time - self.since[i];
            let velocity = self.curves[i].velocity(since);
            let spin = self.turnings[i].at(since, velocity);
            let off = (before.position - self.curves[i].place(since)).length();
            let speed = self.states[i].velocity.length();
            let faster = (before.velocity - velocity).length();
            let turns = (before.angular_velocity - spin).length() * self.curves[i].radius;
            let surface = self.curves[i].radius * spin.length();
            if off > 1e-12 * (1.0 + speed) || faster > 1e-11 || turns > 1e-11 * (1.0 + surface) {
                let what = format!(
                    "ball {i} is {off:e} m from its path, {faster:e} m/s off, and {turns:e} m/s at its surface"
                );
                self.fault(FaultKind::OffPath, what);
            }
            if let Some(fault) = motion_states::overrun(self.shot, i, &self.states[i], since) {
                self.fault(FaultKind::OffPath, fault);
            }
        }
    }

    fn check_contact(&mut self, event: &Event<'_>) {
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
            if closest > self.tolerances.gap && !self.overlaps_at_start(event, closest) {
                let what = format!("balls {:?} collide {closest:e} m apart", event.balls);
                self.fault(FaultKind::Apart, what);
            }
            self.gaps.push(closest);
            if event.balls.len() > 2 {
                let left = conservation::still_approaching(self.shot, event);
                self.left_approaching = self.left_approaching.max(left);
            }
        }
    }

    /// Whether the shot file itself lets these balls overlap within the tolerance for touching.
    fn overlaps_at_start(&self, event: &Event<'_>, gap: f64) -> bool {
        event.time == 0.0 && gap < carom::table::TOUCH_TOLERANCE
    }
}

impl Recorder for CheckRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        if event.time < self.time {
            self.fault(FaultKind::OffPath, format!("time runs backwards from {}", self.time));
        }
        self.events += 1;
        self.check_interval(event.time);
        self.time = event.time;
        self.check_paths(event);
        self.check_contact(event);
        if let Some(fault) = places::audit(self.shot, &self.solid, event) {
            self.fault(FaultKind::Misplaced, fault);
        }
        if let Some(fault) = motion_states::audit(self.shot, event) {
            self.fault(FaultKind::Motion, fault);
        }
        let law = self.law_of(event);
        let given = Circumstances {
            shot: self.shot,
            solid: &self.solid,
            law: &law,
            gap: self.tolerances.gap,
            hop: self.pushes.touch(event, self.shot),
        };
        if let Some(fault) = conservation::audit(&given, event) {
            self.fault(FaultKind::Conservation, fault);
        }
        for (k, &ball) in event.balls.iter().enumerate() {
            let i = usize::from(ball);
            self.states[i] = event.after[k];
            self.since[i] = event.time;
            self.curves[i] = Curve::new(self.shot, i, &event.after[k]);
            self.turnings[i] = Turning::new(self.shot, i, &event.after[k]);
        }
    }
}
