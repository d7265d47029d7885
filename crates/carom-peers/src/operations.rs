//! Counts the operations of the engine in a shot, for comparison with the operation counts of
//! Leckie & Greenspan 2006, section 3.
//!
//! Each of the engine's proofs of no contact saves a pair (or a path and the table) that the
//! paper's algorithm would solve. The finder counts its calls. A second run without the proofs has
//! the same bits, and its calls are the pairs that were considered.

use std::cell::Cell;

use carom::detect::ball_table::keeps_clear;
use carom::event::{Event, EventKind, NullRecorder, Recorder};
use carom::limits::SMALL_CAPACITY;
use carom::motion::Path;
use carom::simulate::peer::PeerFinder;
use carom::simulate::{Simulation, SimulationError, Summary};
use carom::{MotionState, Shot};
use carom_roots::Motion;

/// Time step of the integration for comparison, s: the paper's "rather coarse" one.
const STEP: f64 = 1e-3;

thread_local! {
    static CALLS: Cell<u64> = const { Cell::new(0) };
}

/// The engine's finder, with a count of its calls.
fn counting_finder(path: &Motion<2>, distance: f64, horizon: f64) -> Option<f64> {
    // A NaN horizon marks a lane without a pair: one of its balls is in a pocket.
    CALLS.set(CALLS.get() + u64::from(!horizon.is_nan()));
    carom_roots::first_contact(path, distance, horizon)
}

/// Plays `shot` and counts the finder's calls, with or without the proofs of no contact.
fn count_calls<R: Recorder>(
    shot: &Shot,
    has_proofs: bool,
    recorder: &mut R,
) -> Result<(Summary, u64), SimulationError> {
    CALLS.set(0);
    let finder = PeerFinder { first_contact: counting_finder, has_proofs };
    let summary = finder.run(|| Simulation::<SMALL_CAPACITY>::new().play(shot, recorder))?;
    Ok((summary, CALLS.get()))
}

/// The kinds of events that [`Operations::by_kind`] counts, in its order.
pub const EVENT_KINDS: [&str; 8] = [
    "cue strike",
    "collision of two balls",
    "network of balls",
    "cushion",
    "slate or lip",
    "pocket",
    "off the table",
    "motion transition",
];

/// The place of an event in [`EVENT_KINDS`].
fn place_of(event: &Event<'_>) -> usize {
    match event.kind {
        EventKind::CueStrike { .. } => 0,
        EventKind::BallCollision => 1 + usize::from(event.balls.len() > 2),
        EventKind::RailCollision(_) => 3,
        EventKind::SlateCollision => 4,
        EventKind::PocketCollision(_) => 5,
        EventKind::OffTable => 6,
        EventKind::MotionTransition { .. } => 7,
    }
}

/// Operation counts of one shot or of many.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Operations {
    /// Events.
    pub events: u64,
    /// Events by kind, in the order of [`EVENT_KINDS`].
    pub by_kind: [u64; EVENT_KINDS.len()],
    /// Balls of the networks, summed over the networks.
    pub network_balls: u64,
    /// Time from strike to rest, s.
    pub duration: f64,
    /// Number of moving balls after each event, summed over the events.
    pub moving: u64,
    /// Number of pairs with a moving ball after each event, summed: the paper solves all of them.
    pub pairs: u64,
    /// Pairs that the engine considers.
    pub looked_at: u64,
    /// Pairs that its proofs leave, whose quartics it solves.
    pub solved: u64,
    /// Balls whose state is advanced and whose next transition is predicted.
    pub advanced: u64,
    /// Paths on the cloth searched for cushions and pockets.
    pub searched: u64,
    /// Those of them that are proved to stay clear.
    pub clear: u64,
    /// Paths in the air or on a rail's top searched for all parts of the table.
    pub searched_off_bed: u64,
    /// Operations of an integration with steps of 1 ms, counted as in the paper.
    pub by_steps: f64,
}

impl Operations {
    /// The counts of `shot`.
    ///
    /// # Errors
    /// If the shot cannot be simulated.
    pub fn of(shot: &Shot) -> Result<Self, SimulationError> {
        let mut recorder = OperationsRecorder::new(shot);
        let (_, looked_at) = count_calls(shot, false, &mut recorder)?;
        let (summary, solved) = count_calls(shot, true, &mut NullRecorder)?;
        let counts = recorder.counts;
        assert_eq!(counts.events, u64::from(summary.events), "a proof changed the shot");
        Ok(Self { looked_at, solved, duration: summary.duration, ..counts })
    }

    /// The sum of two counts.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            events: self.events + other.events,
            by_kind: core::array::from_fn(|k| self.by_kind[k] + other.by_kind[k]),
            network_balls: self.network_balls + other.network_balls,
            duration: self.duration + other.duration,
            moving: self.moving + other.moving,
            pairs: self.pairs + other.pairs,
            looked_at: self.looked_at + other.looked_at,
            solved: self.solved + other.solved,
            advanced: self.advanced + other.advanced,
            searched: self.searched + other.searched,
            clear: self.clear + other.clear,
            searched_off_bed: self.searched_off_bed + other.searched_off_bed,
            by_steps: self.by_steps + other.by_steps,
        }
    }

    /// Operations of the paper's event-based method for the same events: for each moving ball 1 to
    /// predict its transition, 24 for rails and pockets and 3 to advance it, for each pair 19.
    pub fn of_the_paper(&self) -> u64 {
        28 * self.moving + 19 * self.pairs
    }

    /// Operations of the engine, counted in the same way. A proof is one operation, like the
    /// paper's test of two balls for overlap; for the table, four quadratics remain of the paper's
    /// twelve on the cloth. Off the bed, which the paper does not have, all twelve count.
    pub fn of_the_engine(&self) -> u64 {
        let table = self.searched + 8 * (self.searched - self.clear) + 24 * self.searched_off_bed;
        4 * self.advanced + self.looked_at + 19 * self.solved + table
    }
}

/// Records the counts that follow from the events: which balls and pairs move.
struct OperationsRecorder<'a> {
    shot: &'a Shot,
    moves: Vec<bool>,
    plays: Vec<bool>,
    time: f64,
    counts: Operations,
}

impl<'a> OperationsRecorder<'a> {
    fn new(shot: &'a Shot) -> Self {
        let states = shot.balls().iter().map(|b| b.state.motion);
        Self {
            shot,
            moves: vec![false; shot.balls().len()],
            plays: states.map(carom::MotionState::in_play).collect(),
            time: 0.0,
            counts: Operations::default(),
        }
    }

    /// Number of moving balls, and of pairs with a moving ball.
    fn busy(&self) -> (u64, u64) {
        let count = |flags: &[bool]| flags.iter().filter(|&&f| f).count() as u64;
        let (moving, playing) = (count(&self.moves), count(&self.plays));
        (moving, moving * moving.saturating_sub(1) / 2 + moving * (playing - moving))
    }
}

impl Recorder for OperationsRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let steps = (event.time - self.time) / STEP;
        let (moving, pairs) = self.busy();
        self.counts.by_steps += steps * (15 * moving + pairs) as f64;
        self.time = event.time;

        let (physics, table) = (self.shot.physics(), self.shot.table());
        for (&i, after) in event.balls.iter().zip(event.after) {
            let i = usize::from(i);
            let ball = &self.shot.balls()[i].ball;
            let path = Path::new(after, ball, &physics.cloth, physics.gravity);
            self.moves[i] = path.moves();
            self.plays[i] = path.motion.in_play();
            self.counts.advanced += 1;
            let is_off_bed = path.motion == MotionState::Airborne || path.position.z != ball.radius;
            if path.moves() && is_off_bed {
                self.counts.searched_off_bed += 1;
            } else if path.moves() {
                let motion = Motion {
                    d: [path.position.x, path.position.y],
                    v: [path.velocity.x, path.velocity.y],
                    h: [path.half_acceleration.x, path.half_acceleration.y],
                };
                let reach = table.reach(ball.radius);
                self.counts.searched += 1;
                self.counts.clear += u64::from(keeps_clear(table, reach, &motion, path.duration));
            }
        }
        let (moving, pairs) = self.busy();
        self.counts.events += 1;
        let place = place_of(event);
        self.counts.by_kind[place] += 1;
        if EVENT_KINDS[place] == "network of balls" {
            self.counts.network_balls += event.balls.len() as u64;
        }
        self.counts.moving += moving;
        self.counts.pairs += pairs;
    }
}
