//! The strikes that reach a goal: searched, refined, and ranked by their probability.
//!
//! 1. **Search.** The candidates are every azimuth that geometry proposes (`aim.rs`) with some speeds
//!    and spins, and points spread evenly over azimuth × speed × spin (the additive recurrence R of
//!    Roberts 2018); also over the elevation if the cue may be raised. All are played. Each has a miss
//!    ([`Goal`]) and a route ([`Route`]).
//! 2. **Refinement.** On every route the strikes with the smallest misses are refined until they meet
//!    the goal, and turned to the middle of the azimuths that meet it.
//! 3. **Ranking.** The strikes that meet the goal are played many times under noise, all with the same
//!    errors, and sorted by how often they meet it. They are played in turn on the tables of which each
//!    may be the true one, if there are any ([`DrawnTables`]); search and refinement know the shot's own.
//!
//! The result does not depend on the number of threads.

use core::f64::consts::{FRAC_PI_2, TAU};

use carom::math::{cos, exp, log, sin_cos, sqrt};
use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Shot};
use std::collections::HashMap;

use crate::aim::{Free, Limits, TriedStrike, azimuths, center, refine, straight_azimuths};
use crate::drawn_tables::DrawnTables;
use crate::error_model::{Chance, ChanceByTable, ErrorModel};
use crate::goal::{Goal, GoalTester};
use crate::interval::Interval;
use crate::progress::Progress;
use crate::reach::Reach;
use crate::route::Route;

/// Pairs of speed and spin tried with every azimuth that geometry proposes. All azimuths together
/// cover the range of speeds and spins; fewer pairs leave gaps, more cost time.
const SPINS: usize = 16;
/// Pairs of speed and elevation tried with every such azimuth if the cue may be raised.
const JUMPS: usize = 32;
/// Massés tried for every straight azimuth, half of them on either side.
const MASSES: usize = 1024;
/// Strikes refined on each route: those with the smallest misses.
const REFINED_PER_ROUTE: usize = 6;
/// Routes refined: the shortest.
const REFINED_ROUTES: usize = 96;
/// Strikes that miss by more than this are not refined, m. The refinement's steps of a degree seldom
/// make up for a larger miss.
const TOO_FAR: f64 = 0.6;
/// Variants in the first ranking. The best strikes are then ranked with as many as were asked for.
const FIRST_VARIANTS: u64 = 128;
/// Strikes that survive the first ranking, as a multiple of those asked for.
const SURVIVORS: usize = 3;
/// Two strikes on one route are different if they differ by this much in speed (relative), in a tip
/// offset (ball radii) or in an angle (rad).
const DIFFERENT: f64 = 0.15;
/// Largest tip offset as a share of the miscue limit. Closer to the limit, a small error of the tip
/// would miscue.
const NEAREST_MISCUE: f64 = 0.95;
/// A cue raised over an obstacle is raised by this much more than necessary, rad (half a degree), so
/// that it is visibly clear.
const CLEARANCE: f64 = 0.008_726_646_259_971_648;

/// Largest number of samples and of strikes asked for. Ten million samples take minutes, and a
/// longer list of strikes is too long to read.
const MOST_SAMPLES: usize = 10_000_000;
const MOST_WANTED: usize = 10_000;
/// Items that are worked on before the empty results among them are dropped: some megabytes.
const PART: usize = 65_536;

/// The range and the effort of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// Least and greatest speed of the cue, m/s.
    pub speed: [f64; 2],
    /// Largest tip offset, ball radii; at most 95 % of the miscue limit.
    pub offset: f64,
    /// Largest elevation, rad, for jumps and massés. They are tried in addition to strikes at the
    /// shot's own elevation; if that is the default, it follows the aim. None tries only the latter.
    pub elevation: Option<f64>,
    /// What the player can reach: a limit of every strike.
    pub reach: Reach,
    /// Strikes spread over the whole range, in addition to those that geometry proposes.
    pub samples: usize,
    /// The errors under which the strikes are ranked, and the precision of the ranking.
    pub model: ErrorModel,
    /// The tables on which they are ranked.
    pub tables: DrawnTables,
    /// Largest number of strikes returned.
    pub wanted: usize,
    /// Largest number of them on the same route.
    pub per_route: usize,
    /// Number of threads; one per core if None.
    pub threads: Option<usize>,
}

impl Default for Search {
    fn default() -> Self {
        Self {
            speed: [0.5, 7.0],
            offset: 0.45,
            elevation: None,
            reach: Reach::default(),
            samples: 4096,
            model: ErrorModel::default(),
            tables: DrawnTables::default(),
            wanted: 10,
            per_route: 3,
            threads: None,
        }
    }
}

/// A strike that reaches the goal.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The strike to intend. It meets the goal when it is hit exactly; under a noise with a mean error,
    /// when it has that error alone.
    pub strike: Strike,
    /// Its route.
    pub route: Route,
    /// Where the cue ball ends, m.
    pub cue_ball_end: [f64; 2],
    /// The probability that the goal is met under the errors.
    pub chance: Chance,
    /// Its confidence interval.
    pub interval: Interval,
    /// The probability on each drawn table; one if there are none.
    pub by_table: ChanceByTable,
}

/// The stages of a search, in order: what [`Progress::read`] counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Candidates are played.
    Search,
    /// The best of them are refined.
    Refine,
    /// The strikes that meet the goal are ranked with a few variants.
    Sift,
    /// The best are ranked with all variants.
    Rank,
}

impl Stage {
    /// All stages in order; a reading's `stage` is an index into it.
    pub const ALL: [Self; 4] = [Self::Search, Self::Refine, Self::Sift, Self::Rank];
}

/// The strikes that reach `goal`, the most probable first; none if `progress` was stopped.
///
/// # Errors
/// [`Error::Input`] for what [`Goal::check`], [`ErrorModel::check`] and [`DrawnTables::check`] reject, and
/// for speeds, offsets, elevations or counts out of range.
pub fn solve(
    shot: &Shot,
    goal: &Goal,
    search: &Search,
    progress: &Progress,
) -> Result<Vec<Solution>, Error> {
    goal.check(shot)?;
    search.check()?;
    search.tables.check(shot)?;
    let runner = Runner::new(search.threads)?;
    Ok(Solver { shot, goal, search, runner, progress }.run().unwrap_or_default())
}

impl Search {
    fn check(&self) -> Result<(), Error> {
        self.model.check()?;
        self.reach.check()?;
        let refuse = |place: &str, what: String, remedy: &str| {
            Err(ErrorKind::OutOfRange.at(place, what, remedy))
        };
        let [least, most] = self.speed;
        if !(0.0 < least && least <= most && most <= 50.0) {
            let what = format!("{least:?} to {most:?} m/s is not a range of speeds");
            return refuse("speed", what, "give 0 < least <= most <= 50");
        }
        if !(0.0..=1.0).contains(&self.offset) {
            let what = format!("{:?} ball radii is out of range", self.offset);
            return refuse("offset", what, "give a number from 0 to 1");
        }
        if let Some(elevation) = self.elevation
            && !(0.0..FRAC_PI_2).contains(&elevation)
        {
            let what = format!("{elevation:?} rad is out of range");
            return refuse("elevation", what, "give at least 0 and less than a right angle");
        }
        let counts = [
            ("samples", self.samples, 0, MOST_SAMPLES),
            ("wanted", self.wanted, 1, MOST_WANTED),
            ("per_route", self.per_route, 1, MOST_WANTED),
        ];
        for (place, count, least, most) in counts {
            if !(least..=most).contains(&count) {
                let what = format!("{count} is out of range");
                return refuse(place, what, &format!("give a whole number from {least} to {most}"));
            }
        }
        Ok(())
    }
}

/// The inputs of one search.
struct Solver<'a> {
    shot: &'a Shot,
    goal: &'a Goal,
    search: &'a Search,
    runner: Runner,
    progress: &'a Progress,
}

impl Solver<'_> {
    /// The solutions; None if the search was stopped.
    fn run(&self) -> Option<Vec<Solution>> {
        let tried = self.each(Stage::Search, self.candidates(), |tester, strike| {
            let attempt = tester.play(&strike).filter(|a| a.miss < TOO_FAR)?;
            Some(TriedStrike { strike, attempt })
        })?;
        let (shot, free) = (self.shot, Free::Within(self.limits()));
        let refined = self.each(Stage::Refine, nearest(tried), |tester, tried| {
            let tried = refine(tester, tried, Free::Azimuth);
            let tried = refine(tester, tried, free);
            if !tried.attempt.is_met() {
                return None;
            }
            let strike = with_the_cue_clear(shot, tried.strike)?;
            let attempt = tester.play(&strike).filter(|a| a.is_met())?;
            Some(center(tester, TriedStrike { strike, attempt }))
        })?;
        self.rank(refined)
    }

    /// The values that `work` returns for `items`, in their order and without the Nones; None if the
    /// search was stopped.
    fn each<A: Send, B: Send>(
        &self,
        stage: Stage,
        items: Vec<A>,
        work: impl Fn(&mut GoalTester<'_>, A) -> Option<B> + Sync + Send,
    ) -> Option<Vec<B>> {
        let (shot, goal, progress) = (self.shot, *self.goal, self.progress);
        let reach = self.search.reach;
        progress.begin(stage as u64, items.len());
        let mut all = Vec::new();
        let mut items = items.into_iter();
        // In parts, because most items return nothing and the results of a part are then dropped.
        while items.len() > 0 && !progress.is_stopped() {
            let part: Vec<A> = items.by_ref().take(PART).collect();
            let found = self.runner.map(
                part,
                || GoalTester::new(shot, goal).within(reach),
                |tester, item| {
                    if progress.is_stopped() {
                        return None;
                    }
                    let made = work(tester, item);
                    progress.add(1);
                    made
                },
            );
            all.extend(found.into_iter().flatten());
        }
        (!progress.is_stopped()).then_some(all)
    }

    fn limits(&self) -> Limits {
        let offset = self.search.offset.min(NEAREST_MISCUE * self.shot.miscue_limit());
        let own = self.shot.strike().map_or(0.0, |(_, strike)| strike.elevation);
        // A default elevation differs from strike to strike; a real stroke's is the least of them.
        let is_default = self.shot.has_default_elevation();
        let least = if is_default { self.shot.physics().cue.stroke_elevation } else { own };
        let elevation = self.search.elevation.map(|most| [least, most]);
        // A reach above the shot's own elevation raises every strike to it.
        let reach = self.search.reach.elevation.unwrap_or([0.0, FRAC_PI_2]);
        let elevation = elevation.map(|[a, b]| [a.max(reach[0]), b.min(reach[1])]);
        Limits { speed: self.search.speed, offset, elevation: elevation.filter(|[a, b]| a < b) }
    }

    fn candidates(&self) -> Vec<Strike> {
        let geometric = azimuths(self.shot, self.goal);
        let (in_three, in_four) = (recurrence::<3>(), recurrence::<4>());
        let aimed = geometric.iter().enumerate().flat_map(|(k, azimuth)| {
            // Every azimuth gets different spins; together they cover the range.
            (0..SPINS).map(move |i| self.at_own_elevation(*azimuth, in_three(k * SPINS + i)))
        });
        let spread = (0..self.search.samples).map(|i| {
            let [turn, rest @ ..] = in_four(i);
            self.at_own_elevation(self.search.reach.azimuth_at(turn), rest)
        });
        let mut all: Vec<Strike> = aimed.chain(spread).collect();
        if let Some(range) = self.limits().elevation {
            all.extend(self.raised(&geometric, range));
        }
        all
    }

    /// Jumps, massés and strikes spread over the range, with the cue raised above the shot's own
    /// elevation.
    fn raised(&self, geometric: &[f64], [least, most]: [f64; 2]) -> Vec<Strike> {
        // The samples of a shot without an elevation are those of a level one, raised to a real stroke.
        let from = if self.shot.has_default_elevation() { 0.0 } else { least };
        let elevation = |share: f64| (from + (most - from) * share).max(least);
        let (in_two, in_five) = (recurrence::<2>(), recurrence::<5>());
        // A jump is struck without side, so that the ball keeps its line.
        let jumps = geometric.iter().enumerate().flat_map(|(k, azimuth)| {
            (0..JUMPS).map(move |i| {
                let [speed, share] = in_two(k * JUMPS + i);
                self.strike(*azimuth, [speed, 0.0, 0.0], elevation(share))
            })
        });
        // A ball struck low on the right starts to the left, by an angle below the elevation, and then
        // curves to the right.
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
            self.strike(self.search.reach.azimuth_at(turn), rest, elevation(share))
        });
        jumps.chain(masses).chain(spread).collect()
    }

    /// As [`Self::strike`], at the elevation that the shot gives it.
    fn at_own_elevation(&self, azimuth: f64, point: [f64; 3]) -> Strike {
        let strike = self.shot.at_own_elevation(&self.strike(azimuth, point, 0.0));
        self.search.reach.raised(strike)
    }

    /// The strike at a point of the unit cube, whose coordinates stand for the speed and for the squared
    /// radius and the angle of the tip offset.
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

    fn rank(&self, refined: Vec<TriedStrike>) -> Option<Vec<Solution>> {
        let model = &self.search.model;
        let few = ErrorModel {
            variants: FIRST_VARIANTS.min(model.variants),
            half_width: None,
            ..model.clone()
        };
        let first = self.counted(Stage::Sift, refined, &few)?;
        let mut kept: Vec<TriedStrike> = Vec::new();
        let mut on_route: HashMap<Route, usize> = HashMap::new();
        for (_, tried) in first {
            let same_route = |other: &&TriedStrike| other.attempt.route == tried.attempt.route;
            let known =
                kept.iter().filter(same_route).any(|other| are_alike(&other.strike, &tried.strike));
            let count = on_route.entry(tried.attempt.route.clone()).or_default();
            if !known
                && *count < self.search.per_route
                && kept.len() < SURVIVORS * self.search.wanted
            {
                *count += 1;
                kept.push(tried);
            }
        }
        let mut ranked = self.counted(Stage::Rank, kept, model)?;
        ranked.truncate(self.search.wanted);
        let solution = |(by_table, tried): (ChanceByTable, TriedStrike)| Solution {
            strike: self.intended(&tried.strike),
            cue_ball_end: tried.attempt.cue_ball_end,
            route: tried.attempt.route,
            chance: by_table.total(),
            interval: by_table.interval(model.level),
            by_table,
        };
        Some(ranked.into_iter().map(solution).collect())
    }

    /// What to intend, so that `strike` is executed under the mean error.
    fn intended(&self, strike: &Strike) -> Strike {
        let Some((ball, _)) = self.shot.strike() else { return *strike };
        let struck = StruckBall::of(self.shot, &self.shot.balls()[ball].ball);
        let strike = self.search.model.noise.aim_for(strike, &struck);
        // A refinement near 0 may end beyond a full turn.
        let is_wound = strike.azimuth.abs() > TAU;
        let azimuth = if is_wound { strike.azimuth.rem_euclid(TAU) } else { strike.azimuth };
        Strike { azimuth, ..strike }
    }

    /// The strikes with their chances, the greatest first.
    fn counted(
        &self,
        stage: Stage,
        list: Vec<TriedStrike>,
        model: &ErrorModel,
    ) -> Option<Vec<(ChanceByTable, TriedStrike)>> {
        let tables = &self.search.tables;
        let mut counted = self.each(stage, list, |tester, tried| {
            let meant = self.intended(&tried.strike);
            Some((tester.chance(&meant, model, tables, self.progress), tried))
        })?;
        counted.sort_by(|(a, _), (b, _)| b.total().compare(a.total()));
        Some(counted)
    }
}

/// The strike with the cue raised over an obstacle, if there is one; None if no elevation is clear.
fn with_the_cue_clear(shot: &Shot, strike: Strike) -> Option<Strike> {
    let shot = shot.with_strike(&strike).ok()?;
    if shot.cue_obstruction().is_none() {
        return Some(strike);
    }
    let least = shot.least_elevation()?;
    Some(Strike { elevation: least + CLEARANCE, ..strike })
}

/// The strikes with the smallest misses on each route. Short routes come first, because many long ones are
/// found by luck.
fn nearest(mut tried: Vec<TriedStrike>) -> Vec<TriedStrike> {
    tried.sort_by(|a, b| {
        let legs = |t: &TriedStrike| t.attempt.route.legs.len();
        legs(a).cmp(&legs(b)).then(a.attempt.miss.total_cmp(&b.attempt.miss))
    });
    let mut on_route: HashMap<Route, usize> = HashMap::new();
    tried.retain(|t| {
        let known = on_route.contains_key(&t.attempt.route);
        if !known && on_route.len() >= REFINED_ROUTES {
            return false;
        }
        let count = on_route.entry(t.attempt.route.clone()).or_default();
        *count += 1;
        *count <= REFINED_PER_ROUTE
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

/// The points of the additive recurrence of Roberts (2018) by their index: multiples of 1/φ, 1/φ², …
/// modulo 1, with φ^(D+1) = φ + 1.
fn recurrence<const D: usize>() -> impl Fn(usize) -> [f64; D] + Copy {
    let mut phi = 2.0;
    // The iteration converges to the root: every step at least halves the error.
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
