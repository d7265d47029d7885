//! Whole shots with each finder in the event loop, checked: the 100 000 random shots of Leckie &
//! Greenspan 2006, section 3.
//!
//! The other finders solve every pair, as in the paper, so that the results are their own: the
//! engine's proofs of no contact are off for them. The engine's own finder runs with its proofs. So
//! the times of [`Contestant::seconds_per_shot`] compare the engine with proofs to the others
//! without.

use core::f64::consts::{FRAC_PI_2, TAU};
use core::ops::Range;
use std::time::Instant;

use carom::Shot;
use carom::event::{Event, NullRecorder, Recorder};
use carom::limits::SMALL_CAPACITY;
use carom::rack::{Game, USUAL_GAP, rack};
use carom::resolve::cue_ball::Strike;
use carom::simulate::peer::PeerFinder;
use carom::simulate::{Simulation, SimulationError, Summary};
use carom_check::random_shots::{self, ShotFamily};
use carom_check::{CheckRecorder, FaultKind, Tolerances};
use carom_roots::Motion;
use rayon::prelude::*;

use crate::families::BALL_DIAMETER;
use crate::harvest::{MAX_EVENTS, places, shot_file};
use crate::quartic::{Quartic, Roots, real_roots, smallest_approaching_root};
use crate::random::Random;
use crate::{algorithm_1010, companion, ferrari};

/// Every tenth shot is a break.
const BREAK_EVERY: u64 = 10;

/// Tolerances above which a shot counts as impossible, the smallest first. The same value limits
/// overlaps and gaps at contacts.
pub const TOLERANCES: [(&str, Tolerances); 3] = [
    ("promised", Tolerances::PROMISED),
    ("micrometre", Tolerances { depth: 1e-6, gap: 1e-6 }),
    ("millimetre", Tolerances { depth: 1e-3, gap: 1e-3 }),
];

/// A finder of the first contact: path, distance (m) and horizon (s).
type FindContact = fn(&Motion<2>, f64, f64) -> Option<f64>;

/// The paper's rule: "the smallest positive real root".
fn smallest_root(
    path: &Motion<2>,
    distance: f64,
    horizon: f64,
    solve: fn(&Quartic) -> Roots,
) -> Option<f64> {
    let roots = real_roots(&Quartic::of_gap(path, distance), solve);
    let within = |t: &f64| *t > 0.0 && *t <= horizon;
    roots.as_slice().iter().copied().filter(within).min_by(f64::total_cmp)
}

/// The smallest positive real root at which the balls approach.
fn approaching_root(
    path: &Motion<2>,
    distance: f64,
    horizon: f64,
    solve: fn(&Quartic) -> Roots,
) -> Option<f64> {
    let quartic = Quartic::of_gap(path, distance);
    let roots = real_roots(&quartic, solve);
    let within = |t: &f64| *t > 0.0 && *t <= horizon && quartic.rate(*t) < 0.0;
    roots.as_slice().iter().copied().filter(within).min_by(f64::total_cmp)
}

/// A shot, and its strike if the file does not hold it.
pub type PlayableShot = (Shot, Option<Strike>);

/// The rule that selects the contact among the roots of a quartic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootRule {
    /// The paper's: "the smallest positive real root".
    Smallest,
    /// The smallest positive real root at which the balls approach, so that two balls that have just
    /// collided do not collide again.
    Approaching,
    /// As [`RootRule::Approaching`], and balls that touch and approach at the start collide at once.
    FromTheStart,
    /// The definition of carom-roots, which includes touching balls that friction turns back.
    FirstContact,
}

impl RootRule {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            RootRule::Smallest => "smallest positive root",
            RootRule::Approaching => "at which they approach",
            RootRule::FromTheStart => "or touching at the start",
            RootRule::FirstContact => "first contact",
        }
    }
}

/// Where the shots come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShotSource {
    /// 2 to 16 balls at random places on a 9-ft table with an ordinary strike in any direction;
    /// every tenth shot is an eight-ball break with a random rack and strike.
    Ordinary,
    /// [`ShotFamily::Frozen`]: balls that touch each other and the rails.
    Frozen,
}

impl ShotSource {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            ShotSource::Ordinary => "ordinary",
            ShotSource::Frozen => "frozen",
        }
    }

    /// Shot number `index`, and its strike if the file does not hold it.
    pub fn shot(self, index: u64) -> PlayableShot {
        match self {
            ShotSource::Ordinary => ordinary_shot(index),
            ShotSource::Frozen => (frozen_shot(index), None),
        }
    }
}

/// A finder in the event loop.
#[derive(Clone, Copy, Debug)]
pub struct Contestant {
    /// The method that solves quartics.
    pub method: &'static str,
    /// The rule that selects the contact among their roots.
    pub rule: RootRule,
    /// The finder in the event loop; `None` for the engine's own.
    peer: Option<PeerFinder>,
}

impl Contestant {
    const fn new(method: &'static str, rule: RootRule, first_contact: FindContact) -> Self {
        Self { method, rule, peer: Some(PeerFinder { first_contact, has_proofs: false }) }
    }

    /// All of them, the engine's own last.
    pub const ALL: [Self; 10] = {
        use RootRule::{Approaching, FirstContact, FromTheStart, Smallest};
        [
            Self::new(FERRARI, Smallest, |p, d, h| smallest_root(p, d, h, ferrari::real_roots)),
            Self::new(COMPANION, Smallest, |p, d, h| smallest_root(p, d, h, companion::real_roots)),
            Self::new(ALGORITHM_1010, Smallest, |p, d, h| {
                smallest_root(p, d, h, algorithm_1010::real_roots)
            }),
            Self::new(FERRARI, Approaching, |p, d, h| {
                approaching_root(p, d, h, ferrari::real_roots)
            }),
            Self::new(COMPANION, Approaching, |p, d, h| {
                approaching_root(p, d, h, companion::real_roots)
            }),
            Self::new(ALGORITHM_1010, Approaching, |p, d, h| {
                approaching_root(p, d, h, algorithm_1010::real_roots)
            }),
            Self::new(FERRARI, FromTheStart, |p, d, h| {
                smallest_approaching_root(p, d, h, ferrari::real_roots)
            }),
            Self::new(COMPANION, FromTheStart, |p, d, h| {
                smallest_approaching_root(p, d, h, companion::real_roots)
            }),
            Self::new(ALGORITHM_1010, FromTheStart, |p, d, h| {
                smallest_approaching_root(p, d, h, algorithm_1010::real_roots)
            }),
            Self { method: "carom", rule: FirstContact, peer: None },
        ]
    };

    /// Whether the engine's proofs of no contact are on: for the engine's own finder only.
    pub fn has_proofs(&self) -> bool {
        self.peer.is_none_or(|peer| peer.has_proofs)
    }

    /// Runs `job` with this finder in the event loop.
    fn run<T>(&self, job: impl FnOnce() -> T) -> T {
        match self.peer {
            Some(peer) => peer.run(job),
            None => job(),
        }
    }

    /// Checks the shots of a source with the numbers in `shots`, on all cores.
    pub fn check(&self, source: ShotSource, shots: Range<u64>) -> FaultCounts {
        shots
            .into_par_iter()
            .map(|index| FaultCounts::of(&self.run(|| first_faults(source, index))))
            .reduce(FaultCounts::default, FaultCounts::with)
    }

    /// Mean time per shot of the shots 0 to `shots` − 1, s, on one core and without checks: the
    /// smallest of some passes. The engine's own finder runs with its proofs of no contact, the
    /// others without.
    pub fn seconds_per_shot(&self, source: ShotSource, shots: u64) -> f64 {
        let shots: Vec<_> = (0..shots).map(|index| source.shot(index)).collect();
        (0..PASSES).map(|_| self.run(|| seconds(&shots))).fold(f64::INFINITY, f64::min)
    }
}

const FERRARI: &str = "textbook closed form";
const COMPANION: &str = "companion matrix";
const ALGORITHM_1010: &str = "Algorithm 1010";

/// Number of timed passes.
const PASSES: u32 = 5;

/// The first fault of one shot at each of [`TOLERANCES`], if there is one.
type FirstFaults = [Option<FaultKind>; TOLERANCES.len()];

fn first_faults(source: ShotSource, index: u64) -> FirstFaults {
    let (shot, strike) = source.shot(index);
    let mut simulation = Simulation::<SMALL_CAPACITY>::new();
    let mut judged = [None; TOLERANCES.len()];
    for (fault, (_, tolerances)) in judged.iter_mut().zip(TOLERANCES) {
        let mut recorder = FirstFaultRecorder(CheckRecorder::with_tolerances(&shot, tolerances));
        let result = play(&mut simulation, &shot, strike, &mut recorder);
        *fault = recorder.first_fault(result);
        if fault.is_none() {
            // Larger tolerances allow whatever smaller ones do.
            break;
        }
    }
    judged
}

/// Checks a shot up to its first fault.
struct FirstFaultRecorder<'a>(CheckRecorder<'a>);

impl FirstFaultRecorder<'_> {
    fn first_fault(mut self, result: Result<Summary, SimulationError>) -> Option<FaultKind> {
        if self.0.faults.is_empty() || result.is_err() {
            self.0.faults.clear();
            self.0.finish(result);
        }
        self.0.faults.first().map(|fault| fault.kind)
    }
}

impl Recorder for FirstFaultRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        if self.0.faults.is_empty() {
            self.0.record(event);
        }
    }
}

fn play<R: Recorder>(
    simulation: &mut Simulation<SMALL_CAPACITY>,
    shot: &Shot,
    strike: Option<Strike>,
    recorder: &mut R,
) -> Result<Summary, SimulationError> {
    match strike {
        Some(strike) => simulation.play_strike(shot, Some((0, strike)), recorder),
        None => simulation.play(shot, recorder),
    }
}

fn seconds(shots: &[PlayableShot]) -> f64 {
    let mut simulation = Simulation::<SMALL_CAPACITY>::new();
    let start = Instant::now();
    for (shot, strike) in shots {
        // Shots stopped at the limit of events count with their time.
        let _ = play(&mut simulation, shot, *strike, &mut NullRecorder);
    }
    start.elapsed().as_secs_f64() / shots.len() as f64
}

/// Numbers of faulty shots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FaultCounts {
    /// Shots played.
    pub shots: u64,
    /// Shots with an impossible result, at each of [`TOLERANCES`], by the kind of their first fault
    /// in the order of [`FaultKind::ALL`]. Later faults of a shot may follow from the first, so they
    /// are not counted.
    pub first_faults: [[u64; FaultKind::ALL.len()]; TOLERANCES.len()],
}

impl FaultCounts {
    fn of(judged: &FirstFaults) -> Self {
        let count =
            |found: Option<FaultKind>| FaultKind::ALL.map(|kind| u64::from(found == Some(kind)));
        Self { shots: 1, first_faults: judged.map(count) }
    }

    /// Shots with an impossible result at each of [`TOLERANCES`].
    pub fn impossible(&self) -> [u64; TOLERANCES.len()] {
        self.first_faults.map(|kinds| kinds.iter().sum())
    }

    /// Shots whose first fault at a place of [`TOLERANCES`] is of this kind.
    pub fn of_kind(&self, tolerance: usize, kind: FaultKind) -> u64 {
        self.first_faults[tolerance][kind as usize]
    }

    fn with(self, other: Self) -> Self {
        let sum = |t: usize, k: usize| self.first_faults[t][k] + other.first_faults[t][k];
        Self {
            shots: self.shots + other.shots,
            first_faults: core::array::from_fn(|t| core::array::from_fn(|k| sum(t, k))),
        }
    }
}

fn ordinary_shot(index: u64) -> PlayableShot {
    let mut random = Random::new(index.wrapping_mul(0x2006_0000_0001));
    loop {
        let (places, strike) = if index.is_multiple_of(BREAK_EVERY) {
            eight_ball_break(&mut random)
        } else {
            position(&mut random)
        };
        // A ball may be over a hole; then another layout is drawn.
        if let Ok(shot) = Shot::from_json(&shot_file(&places)) {
            return (shot, Some(strike));
        }
    }
}

fn frozen_shot(index: u64) -> Shot {
    let format = r#""format": "carom-shot/1","#;
    let capped = format!(r#"{format} "max_events": {MAX_EVENTS},"#);
    // A ball may be in a jaw; then the next layout of this index is drawn.
    (0..u64::MAX)
        .map(|attempt| random_shots::shot_file(ShotFamily::Frozen, index + (attempt << 32)))
        .find_map(|file| Shot::from_json(&file.replace(format, &capped)).ok())
        .expect("a layout that fits")
}

fn position(random: &mut Random) -> (Vec<[f64; 2]>, Strike) {
    let balls = 2 + (15.0 * random.unit()) as usize;
    let strike = Strike {
        speed: random.between(0.5, 6.0),
        azimuth: random.between(0.0, TAU),
        elevation: 0.0,
        side: random.between(-0.3, 0.3),
        height: random.between(-0.3, 0.3),
    };
    (places(random, balls), strike)
}

fn eight_ball_break(random: &mut Random) -> (Vec<[f64; 2]>, Strike) {
    let table = carom::Table::preset(Game::EightBall.table()).expect("a preset");
    let seed = random.bits();
    let balls = rack(Game::EightBall, &table, 0.5 * BALL_DIAMETER, seed, USUAL_GAP);
    let strike = Strike {
        speed: random.between(6.0, 10.0),
        azimuth: FRAC_PI_2 + random.between(-0.01, 0.01),
        elevation: 0.0,
        side: random.between(-0.1, 0.1),
        height: random.between(-0.2, 0.3),
    };
    (balls.expect("a rack").into_iter().map(|(_, place)| place).collect(), strike)
}
