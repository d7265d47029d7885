//! Which strikes do what is wanted: searched everywhere, refined, ranked by their chance.
//!
//! 1. **Everywhere.** Every azimuth that geometry proposes ([`crate::aim`]) with a few speeds and spins, and
//!    points spread evenly over azimuth × speed × spin (the additive recurrence R of Roberts 2018), are
//!    played; where the cue may be raised, also over its elevation. Each tells by how much it misses ([`Goal`]) and by which way ([`Way`]).
//! 2. **Refined.** Of every way the nearest are refined until they meet the goal, and turned to the middle of
//!    the azimuths that do.
//! 3. **Ranked.** What is left is played many times under noise, all with the same errors, and sorted by how
//!    often the goal is met.
//!
//! Nothing in this depends on the number of threads.

use core::f64::consts::{FRAC_PI_2, TAU};

use carom::limits::{MAX_BALLS, SMALL_CAPACITY};
use carom::math::{cos, exp, log, sin_cos, sqrt};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot};
use rayon::prelude::*;
use std::collections::HashMap;

use crate::aim::{Free, Limits, Tried, azimuths, center, refine, straight_azimuths};
use crate::errs::{Chance, Errs};
use crate::goal::{Goal, Player};
use crate::interval::Interval;
use crate::threads::Threads;
use crate::way::Way;

/// Speeds and spins that every azimuth of the geometry is tried with.
const SPINS: usize = 16;
/// Speeds and elevations that it is tried with where the cue may be raised.
const JUMPS: usize = 32;
/// Massés that are tried for every straight azimuth, half of them from either side.
const MASSES: usize = 1024;
/// Strikes of one way that are refined, the nearest, and ways that are, the simplest.
const REFINED_OF_A_WAY: usize = 6;
const REFINED_WAYS: usize = 96;
/// Misses beyond this are not refined, m: steps of a degree do not bridge it.
const TOO_FAR: f64 = 0.6;
/// Variants for the first ranking; the best then get as many as were asked for.
const FIRST_VARIANTS: u64 = 128;
/// How many times more strikes than are wanted survive it.
const SURVIVORS: usize = 3;
/// Two strikes of one way are different when they differ by this much in speed (as a share), in a tip offset
/// (ball radii), or in an angle (rad).
const DIFFERENT: f64 = 0.15;
/// No strike is farther off the middle than this share of the miscue limit.
const NEAREST_MISCUE: f64 = 0.95;
/// A raised cue is raised this much more than it must be, rad (half a degree): to be seen to be clear.
const CLEARANCE: f64 = 0.008_726_646_259_971_648;

/// What may be tried, and how hard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Least and greatest speed of the cue, m/s.
    pub speed: [f64; 2],
    /// Largest tip offset, ball radii; at most 95 % of the miscue limit.
    pub offset: f64,
    /// How far the cue may be raised, rad, for jumps and massés, which are tried besides strikes at the shot's
    /// own elevation. Without it nothing is tried but those.
    pub elevation: Option<f64>,
    /// Strikes spread over everything, besides those that geometry proposes.
    pub samples: usize,
    /// Under which the strikes are ranked, and how well their chances are to be known.
    pub errs: Errs,
    /// How many strikes are wanted.
    pub wanted: usize,
    /// How many of them by the same way.
    pub of_a_way: usize,
    /// How many threads; all cores if none.
    pub threads: Option<usize>,
}

impl Default for Search {
    fn default() -> Self {
        Self {
            speed: [0.5, 7.0],
            offset: 0.45,
            elevation: None,
            samples: 4096,
            errs: Errs::default(),
            wanted: 10,
            of_a_way: 3,
            threads: None,
        }
    }
}

/// A strike that does what is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// It meets the goal when it is hit exactly.
    pub strike: Strike,
    /// By which way.
    pub way: Way,
    /// Where it leaves the cue ball, m.
    pub cue_ball_end: [f64; 2],
    /// How likely the goal is met.
    pub chance: Chance,
    /// The interval of that.
    pub interval: Interval,
}

/// What a search is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Strikes are tried everywhere.
    Search,
    /// The nearest are refined.
    Refine,
    /// What is left is sifted by a few variants.
    Sift,
    /// The best are ranked by their chance.
    Rank,
}

/// Told a stage, how many of its strikes are done and how many there are; says whether to go on.
pub type Progress<'a> = &'a mut dyn FnMut(Stage, usize, usize) -> bool;

/// The strikes that bring about `goal`, the likeliest first; none if `progress` stopped the search.
///
/// # Errors
/// [`Error::Input`] for what [`Goal::check`] and [`Errs::check`] refuse, and for speeds or offsets out of
/// range.
pub fn solve(
    shot: &Shot,
    goal: &Goal,
    search: &Search,
    progress: Progress<'_>,
) -> Result<Vec<Solution>, Error> {
    goal.check(shot)?;
    search.check()?;
    let threads = Threads::new(search.threads);
    let found = if shot.balls().len() <= SMALL_CAPACITY {
        Solver::<SMALL_CAPACITY> { shot, goal, search, threads, progress }.run()
    } else {
        Solver::<MAX_BALLS> { shot, goal, search, threads, progress }.run()
    };
    Ok(found.unwrap_or_default())
}

impl Search {
    fn check(&self) -> Result<(), Error> {
        self.errs.check()?;
        let refuse =
            |place: &str, what: String, remedy: &str| Err(Error::input(place, what, remedy));
        let [least, most] = self.speed;
        if !(0.0 < least && least <= most && most <= 50.0) {
            let what = format!("{least:?} to {most:?} m/s is no range of speeds");
            return refuse("speed", what, "give 0 < least <= most <= 50");
        }
        if !(0.0..=1.0).contains(&self.offset) {
            let what = format!("{:?} ball radii is off the ball", self.offset);
            return refuse("offset", what, "give a number from 0 to 1");
        }
        if let Some(elevation) = self.elevation
            && !(0.0..FRAC_PI_2).contains(&elevation)
        {
            let what = format!("no cue is raised by {elevation:?} rad");
            return refuse("elevation", what, "give at least 0 and less than a right angle");
        }
        Ok(())
    }
}

struct Solver<'a, const N: usize> {
    shot: &'a Shot,
    goal: &'a Goal,
    search: &'a Search,
    threads: Threads,
    progress: Progress<'a>,
}

impl<const N: usize> Solver<'_, N> {
    /// None if it was stopped.
    fn run(&mut self) -> Option<Vec<Solution>> {
        let tried = self.each(Stage::Search, self.candidates(), |player, strike| {
            let attempt = player.play(&strike)?;
            Some(Tried { strike, attempt })
        })?;
        let (shot, free) = (self.shot, Free::Within(self.limits()));
        let refined = self.each(Stage::Refine, nearest(tried), |player, tried| {
            let tried = refine(player, tried, Free::Azimuth);
            let tried = refine(player, tried, free);
            if !tried.attempt.is_met() {
                return None;
            }
            let strike = with_the_cue_clear(shot, tried.strike)?;
            let attempt = player.play(&strike).filter(|a| a.is_met())?;
            let centered = center(player, Tried { strike, attempt });
            // What is judged is what a shot's file can hold, so that whoever plays it sees the same.
            let (_, strike) = shot.with_strike(&centered.strike).ok()?.strike()?;
            let attempt = player.play(&strike).filter(|a| a.is_met())?;
            Some(Tried { strike, attempt })
        })?;
        self.rank(refined)
    }

    /// What `work` makes of each of `items`, in their order; none if it was stopped.
    fn each<A: Send + Sync + Clone, B: Send>(
        &mut self,
        stage: Stage,
        items: Vec<A>,
        work: impl Fn(&mut Player<'_, N>, A) -> Option<B> + Sync,
    ) -> Option<Vec<B>> {
        let (shot, goal) = (self.shot, *self.goal);
        let mut all = Vec::new();
        let mut done = 0;
        for some in items.chunks(stage.at_once() * self.threads.count()) {
            let made: Vec<Option<B>> = self.threads.run(|| {
                some.par_iter()
                    .map_init(|| Player::<N>::new(shot, goal), |player, a| work(player, a.clone()))
                    .collect()
            });
            all.extend(made.into_iter().flatten());
            done += some.len();
            if !(self.progress)(stage, done, items.len()) {
                return None;
            }
        }
        Some(all)
    }

    fn limits(&self) -> Limits {
        let offset = self.search.offset.min(NEAREST_MISCUE * self.shot.miscue_limit());
        let own = self.shot.strike().map_or(0.0, |(_, strike)| strike.elevation);
        let most = self.search.elevation.map_or(own, |most| most.max(own));
        Limits { speed: self.search.speed, offset, elevation: [own, most] }
    }

    fn candidates(&self) -> Vec<Strike> {
        let [elevation, most] = self.limits().elevation;
        let geometric = azimuths(self.shot, self.goal);
        let (in_three, in_four) = (recurrence::<3>(), recurrence::<4>());
        let aimed = geometric.iter().enumerate().flat_map(|(k, azimuth)| {
            // Other spins for every azimuth, so that together they leave no gap.
            (0..SPINS).map(move |i| self.strike(*azimuth, in_three(k * SPINS + i), elevation))
        });
        let spread = (0..self.search.samples).map(|i| {
            let [turn, rest @ ..] = in_four(i);
            self.strike(TAU * turn, rest, elevation)
        });
        let mut all: Vec<Strike> = aimed.chain(spread).collect();
        if most > elevation {
            all.extend(self.raised(&geometric));
        }
        all
    }

    /// Jumps, massés, and strikes spread over everything, with the cue raised above the shot's own elevation.
    fn raised(&self, geometric: &[f64]) -> Vec<Strike> {
        let [least, most] = self.limits().elevation;
        let elevation = |share: f64| least + (most - least) * share;
        let (in_two, in_five) = (recurrence::<2>(), recurrence::<5>());
        // A ball that is struck in the middle keeps its line.
        let jumps = geometric.iter().enumerate().flat_map(|(k, azimuth)| {
            (0..JUMPS).map(move |i| {
                let [speed, share] = in_two(k * JUMPS + i);
                self.strike(*azimuth, [speed, 0.0, 0.0], elevation(share))
            })
        });
        // One that is struck low on the right goes left first, by less than the cue is raised, and then curves
        // to the right.
        let masses = straight_azimuths(self.shot, self.goal).into_iter().flat_map(|azimuth| {
            (0..MASSES).map(move |i| {
                let [speed, share, out, low, away] = in_five(i);
                let elevation = elevation(share);
                let (turn, low) = (elevation * away, 0.25 * low);
                if i % 2 == 0 {
                    self.strike(azimuth + turn, [speed, out, 1.0 - low], elevation)
                } else {
                    self.strike(azimuth - turn, [speed, out, 0.5 + low], elevation)
                }
            })
        });
        let spread = (0..self.search.samples).map(|i| {
            let [turn, share, rest @ ..] = in_five(i);
            self.strike(TAU * turn, rest, elevation(share))
        });
        jumps.chain(masses).chain(spread).collect()
    }

    /// The strike at a point of the unit cube: speed, then radius² and angle of the tip offset.
    fn strike(&self, azimuth: f64, [speed, out, turn]: [f64; 3], elevation: f64) -> Strike {
        let Limits { speed: [least, most], offset: largest, .. } = self.limits();
        let (sin, cos) = sin_cos(TAU * turn);
        let offset = largest * sqrt(out);
        Strike {
            speed: least * exp(log(most / least) * speed),
            azimuth,
            elevation,
            side: offset * cos,
            height: offset * sin,
        }
    }

    fn rank(&mut self, refined: Vec<Tried>) -> Option<Vec<Solution>> {
        let errs = self.search.errs;
        let few = Errs { variants: FIRST_VARIANTS.min(errs.variants), half_width: None, ..errs };
        let first = self.counted(Stage::Sift, refined, &few)?;
        let mut kept: Vec<Tried> = Vec::new();
        let mut of_way: HashMap<Way, usize> = HashMap::new();
        for (_, tried) in first {
            let same_way = |other: &&Tried| other.attempt.way == tried.attempt.way;
            let known =
                kept.iter().filter(same_way).any(|other| are_alike(&other.strike, &tried.strike));
            let count = of_way.entry(tried.attempt.way.clone()).or_default();
            if !known
                && *count < self.search.of_a_way
                && kept.len() < SURVIVORS * self.search.wanted
            {
                *count += 1;
                kept.push(tried);
            }
        }
        let mut ranked = self.counted(Stage::Rank, kept, &errs)?;
        ranked.truncate(self.search.wanted);
        let solution = |(chance, tried): (Chance, Tried)| Solution {
            strike: tried.strike,
            cue_ball_end: tried.attempt.cue_ball_end,
            way: tried.attempt.way,
            chance,
            interval: chance.interval(errs.level),
        };
        Some(ranked.into_iter().map(solution).collect())
    }

    /// The chances of all, the greatest first.
    fn counted(
        &mut self,
        stage: Stage,
        list: Vec<Tried>,
        errs: &Errs,
    ) -> Option<Vec<(Chance, Tried)>> {
        let mut counted = self
            .each(stage, list, |player, tried| Some((player.chance(&tried.strike, errs), tried)))?;
        counted.sort_by(|(a, _), (b, _)| b.compare(*a));
        Some(counted)
    }
}

impl Stage {
    /// How many strikes a thread gets between two tellings: some milliseconds of work.
    const fn at_once(self) -> usize {
        match self {
            Self::Search => 512,
            Self::Refine | Self::Sift => 16,
            Self::Rank => 4,
        }
    }
}

/// The same strike with the cue raised over what is in its way; none if nothing helps.
fn with_the_cue_clear(shot: &Shot, strike: Strike) -> Option<Strike> {
    let shot = shot.with_strike(&strike).ok()?;
    if shot.cue_obstruction().is_none() {
        return Some(strike);
    }
    let least = shot.least_elevation()?;
    Some(Strike { elevation: least + CLEARANCE, ..strike })
}

/// Of every way the strikes that miss least; simple ways come first, since luck finds many of the others.
fn nearest(mut tried: Vec<Tried>) -> Vec<Tried> {
    tried.retain(|t| t.attempt.miss < TOO_FAR);
    tried.sort_by(|a, b| {
        let steps = |t: &Tried| t.attempt.way.steps.len();
        steps(a).cmp(&steps(b)).then(a.attempt.miss.total_cmp(&b.attempt.miss))
    });
    let mut of_way: HashMap<Way, usize> = HashMap::new();
    tried.retain(|t| {
        let ways = of_way.len();
        let known = of_way.contains_key(&t.attempt.way);
        if !known && ways >= REFINED_WAYS {
            return false;
        }
        let count = of_way.entry(t.attempt.way.clone()).or_default();
        *count += 1;
        *count <= REFINED_OF_A_WAY
    });
    tried
}

fn are_alike(a: &Strike, b: &Strike) -> bool {
    (a.speed - b.speed).abs() < DIFFERENT * a.speed
        && (a.side - b.side).abs() < DIFFERENT
        && (a.height - b.height).abs() < DIFFERENT
        && (a.elevation - b.elevation).abs() < DIFFERENT
        && 1.0 - cos(a.azimuth - b.azimuth) < 0.5 * DIFFERENT * DIFFERENT
}

/// The points of the additive recurrence of Roberts (2018), by their index: multiples of 1/φ, 1/φ², … with
/// φ^(D+1) = φ + 1, modulo 1.
fn recurrence<const D: usize>() -> impl Fn(usize) -> [f64; D] + Copy {
    let mut phi = 2.0;
    // The root is a fixed point that attracts: every step halves the error, and more.
    for _ in 0..64 {
        phi = carom::math::pow(1.0 + phi, 1.0 / (D as f64 + 1.0));
    }
    let mut factor = 1.0;
    let steps: [f64; D] = core::array::from_fn(|_| {
        factor /= phi;
        factor
    });
    move |index| {
        steps.map(|step| {
            let x = 0.5 + step * (index as f64 + 1.0);
            x - x.floor()
        })
    }
}
