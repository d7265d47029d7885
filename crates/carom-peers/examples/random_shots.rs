//! Whole shots with each root finder in the event loop, as in Leckie & Greenspan 2006, section 3:
//! how many of 100 000 random shots give an impossible result.
//!
//! `cargo run --release -p carom-peers --example random_shots -- [SHOTS [FINDER]] > random_shots.json`
//!
//! FINDER is part of a finder's name, such as `carom`; all of them without it.
//!
//! Every shot is judged by a watcher that solves no polynomial: between two events it bounds the
//! distance of each pair from its middle value and the largest relative speed, and halves the time
//! until the bound decides.

use std::cell::Cell;

use carom::detect::ball_ball::ContactFinder;
use carom::event::{Event, EventKind, Recorder};
use carom::math::Vec2;
use carom::motion::Path;
use carom::resolve::cue_ball::Strike;
use carom::simulate::{SMALL, Simulation};
use carom::{BallState, Shot};
use carom_peers::finder::Finder;
use carom_peers::random::Random;
use carom_roots::Motion;

/// Balls on the table, as in eight-ball.
const BALLS: usize = 16;
/// Cap on a shot's events; ordinary ones have fewer than 300.
const MAX_EVENTS: u32 = 5000;
/// Overlap, or gap at a collision, that counts as impossible, m. Rounding is 1e-15; a micrometre
/// is what nobody could see.
const IMPOSSIBLE: f64 = 1e-6;
/// Ball's diameter, m: the `pool` preset's.
const DIAMETER: f64 = 0.05715;
const WIDTH: f64 = 1.27;
const LENGTH: f64 = 2.54;
/// How far outside the playing area a ball may rest, m: in the jaws of a pocket.
const JAWS: f64 = 0.06;

thread_local! {
    /// Calls of the finder.
    static SOLVES: Cell<u64> = const { Cell::new(0) };
}

macro_rules! in_the_loop {
    ($($name:ident => $finder:expr),+) => {$(
        #[derive(Clone, Copy, Debug)]
        struct $name;
        impl ContactFinder for $name {
            fn first_contact(path: &Motion<2>, distance: f64, horizon: f64) -> Option<f64> {
                SOLVES.set(SOLVES.get() + 1);
                $finder.first_contact(path, distance, horizon)
            }
        }
    )+};
}
in_the_loop!(
    Carom => Finder::Carom,
    Ferrari => Finder::Ferrari,
    Companion => Finder::Companion,
    Algorithm1010 => Finder::Algorithm1010
);

/// What is wrong with a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// Two balls overlap.
    Overlap,
    /// A collision of balls that do not touch.
    Invented,
    /// The cap on events was reached.
    Endless,
    /// A ball rests outside the table, or nowhere.
    Astray,
}

/// Follows a shot and looks for the impossible.
struct Watcher<'a> {
    shot: &'a Shot,
    path: Vec<Path>,
    start: Vec<f64>,
    last: f64,
    fault: Option<Fault>,
    events: u64,
    /// Pairs that the paper's algorithm would solve after each event.
    paper_pairs: u64,
}

impl<'a> Watcher<'a> {
    fn new(shot: &'a Shot) -> Self {
        let half = Vec2::new(0.5 * WIDTH, 0.5 * LENGTH);
        let paths = shot.balls().iter().map(|placed| {
            let mut state = placed.state;
            state.position.x -= half.x;
            state.position.y -= half.y;
            Self::path(shot, &state)
        });
        let path: Vec<Path> = paths.collect();
        let start = vec![0.0; path.len()];
        Self { shot, path, start, last: 0.0, fault: None, events: 0, paper_pairs: 0 }
    }

    fn path(shot: &Shot, state: &BallState) -> Path {
        let physics = shot.physics();
        Path::new(state, &physics.ball, &physics.cloth, physics.gravity)
    }

    /// Centres' difference of two balls at `time`, and its rate.
    fn between(&self, i: usize, j: usize, time: f64) -> (Vec2, Vec2) {
        let (a, b) = (time - self.start[i], time - self.start[j]);
        let (p, q) = (&self.path[i], &self.path[j]);
        ((q.position_at(b) - p.position_at(a)).xy(), (q.velocity_at(b) - p.velocity_at(a)).xy())
    }

    /// Whether the two overlap somewhere in `from..to`, deeper than [`IMPOSSIBLE`].
    fn overlap(&self, i: usize, j: usize, from: f64, to: f64) -> bool {
        let reach = DIAMETER - IMPOSSIBLE;
        let middle = 0.5 * (from + to);
        let distance = self.between(i, j, middle).0.length();
        // The relative velocity is linear in time, so it is largest at an end.
        let at_ends = [from, to].map(|t| self.between(i, j, t).1.length());
        let speed = at_ends[0].max(at_ends[1]);
        if distance < reach {
            return true;
        }
        if distance - 0.5 * (to - from) * speed >= reach {
            return false;
        }
        // Both halves are shorter; a touching pair is decided when they are short enough to hold
        // less than the micrometre.
        self.overlap(i, j, from, middle) || self.overlap(i, j, middle, to)
    }

    fn look(&mut self, until: f64) {
        let n = self.path.len();
        let in_play = |p: &Path| p.motion.in_play();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let overlapping = pairs
            .filter(|&(i, j)| in_play(&self.path[i]) && in_play(&self.path[j]))
            .filter(|&(i, j)| self.path[i].moves() || self.path[j].moves())
            .any(|(i, j)| self.overlap(i, j, self.last, until));
        if overlapping {
            self.fault = Some(Fault::Overlap);
        }
    }

    fn count(&mut self) {
        let playing = self.path.iter().filter(|p| p.motion.in_play()).count() as u64;
        let moving = self.path.iter().filter(|p| p.moves()).count() as u64;
        self.events += 1;
        self.paper_pairs += moving * moving.saturating_sub(1) / 2 + moving * (playing - moving);
    }
}

impl Recorder for Watcher<'_> {
    const STATES: bool = true;

    fn record(&mut self, event: &Event<'_>) {
        if self.fault.is_none() {
            self.look(event.time);
        }
        if event.kind == EventKind::BallCollision {
            let gap = |i: usize| {
                let others = (0..event.balls.len()).filter(|&j| j != i);
                let apart =
                    |j: usize| (event.before[i].position - event.before[j].position).length();
                others.map(apart).fold(f64::INFINITY, f64::min) - DIAMETER
            };
            if (0..event.balls.len()).any(|i| gap(i) > IMPOSSIBLE) {
                self.fault = self.fault.or(Some(Fault::Invented));
            }
        }
        for (&i, after) in event.balls.iter().zip(event.after) {
            self.path[usize::from(i)] = Self::path(self.shot, after);
            self.start[usize::from(i)] = event.time;
        }
        self.last = event.time;
        self.count();
    }
}

/// What a finder did.
#[derive(Default)]
struct Tally {
    overlaps: u64,
    invented: u64,
    endless: u64,
    astray: u64,
    solves: u64,
    events: u64,
    paper_pairs: u64,
}

impl Tally {
    fn impossible(&self) -> u64 {
        self.overlaps + self.invented + self.endless + self.astray
    }
}

/// Plays so many shots of a seed.
type Play = fn(u64, u64) -> Tally;

fn astray(state: &BallState) -> bool {
    let p = state.position;
    let inside = p.x.abs() < 0.5 * WIDTH + JAWS && p.y.abs() < 0.5 * LENGTH + JAWS;
    // A NaN is not inside.
    state.motion.in_play() && !inside
}

fn play<F: ContactFinder>(shots: u64, seed: u64) -> Tally {
    let mut random = Random::new(seed);
    let mut simulation = Simulation::<SMALL, F>::new();
    let mut tally = Tally::default();
    SOLVES.set(0);
    for _ in 0..shots {
        let (shot, strike) = random_shot(&mut random);
        let mut watcher = Watcher::new(&shot);
        let result = simulation.play_strike(&shot, Some((0, strike)), &mut watcher);
        let lost = watcher.path.iter().any(|p| astray(&p.at(0.0)));
        let fault = match (watcher.fault, result.is_err()) {
            (Some(fault), _) => Some(fault),
            (None, true) => Some(Fault::Endless),
            (None, false) => lost.then_some(Fault::Astray),
        };
        match fault {
            Some(Fault::Overlap) => tally.overlaps += 1,
            Some(Fault::Invented) => tally.invented += 1,
            Some(Fault::Endless) => tally.endless += 1,
            Some(Fault::Astray) => tally.astray += 1,
            None => {}
        }
        tally.events += watcher.events;
        tally.paper_pairs += watcher.paper_pairs;
    }
    tally.solves = SOLVES.get();
    tally
}

/// Sixteen balls anywhere on a 9-ft table, and a strike of the first.
fn random_shot(random: &mut Random) -> (Shot, Strike) {
    let mut places: Vec<[f64; 2]> = Vec::new();
    while places.len() < BALLS {
        let place = [random.between(0.03, WIDTH - 0.03), random.between(0.03, LENGTH - 0.03)];
        let apart = |o: &[f64; 2]| (o[0] - place[0]).hypot(o[1] - place[1]) > 1.0001 * DIAMETER;
        if places.iter().all(apart) {
            places.push(place);
        }
    }
    let balls: Vec<String> = places
        .iter()
        .enumerate()
        .map(|(i, [x, y])| format!(r#"{{"id": "{i}", "position": [{x}, {y}]}}"#))
        .collect();
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "max_events": {MAX_EVENTS},
            "balls": [{}]}}"#,
        balls.join(", ")
    );
    let strike = Strike {
        speed: random.between(0.5, 8.0),
        azimuth: random.between(0.0, core::f64::consts::TAU),
        elevation: 0.0,
        side: random.between(-0.35, 0.35),
        height: random.between(-0.35, 0.35),
    };
    (Shot::from_json(&file).expect("balls that do not overlap"), strike)
}

fn main() {
    let shots = std::env::args().nth(1).map_or(100_000, |n| n.parse().expect("a number of shots"));
    let only = std::env::args().nth(2).unwrap_or_default();
    let seed = 2006;
    let runs: [(Finder, Play); 4] = [
        (Finder::Ferrari, play::<Ferrari>),
        (Finder::Companion, play::<Companion>),
        (Finder::Algorithm1010, play::<Algorithm1010>),
        (Finder::Carom, play::<Carom>),
    ];
    let lines: Vec<String> = runs
        .iter()
        .filter(|(finder, _)| finder.name().contains(&only))
        .map(|(finder, run)| {
            let t = run(shots, seed);
            eprintln!("{}: {} impossible of {shots}", finder.name(), t.impossible());
            format!(
                r#"  {{"finder": "{}", "impossible": {}, "overlaps": {}, "invented": {}, "endless": {}, "astray": {}, "events": {}, "solves": {}, "pairs_of_the_paper": {}}}"#,
                finder.name(),
                t.impossible(),
                t.overlaps,
                t.invented,
                t.endless,
                t.astray,
                t.events,
                t.solves,
                t.paper_pairs,
            )
        })
        .collect();
    println!("{{");
    println!(
        r#" "command": "cargo run --release -p carom-peers --example random_shots -- {shots}","#
    );
    println!(r#" "shots": {shots}, "balls": {BALLS}, "seed": {seed}, "table": "wpa-9ft","#);
    println!(" \"finders\": [\n{}\n ]\n}}", lines.join(",\n"));
}
