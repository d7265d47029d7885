//! The search for a break by the cross-entropy method (Rubinstein 1999; de Boer, Kroese, Mannor &
//! Rubinstein 2005).
//!
//! Breaks are drawn from a normal distribution, whose mean and spread then move towards the best of
//! them. The first generation covers the whole space evenly. Every generation breaks new racks, so that
//! no break profits from racks that suit it. The finalists are compared by sequential halving.

use carom::math::sqrt;
use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_rules::{Frame, OpeningKind};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use super::racks::{Corrections, Racks};
use super::strike_errors::largest_offset;
use crate::breaks::{BreakCounts, BreakShot};
use crate::player::Situation;
use crate::value::Value;
use carom_plan::{Prepared, two_sided_quantile};

/// Numbers of a break that are searched: those of [`BreakShot`].
const COUNT: usize = 6;
/// Generations after the first one.
const GENERATIONS: u64 = 9;
/// Share of the simulations for the comparison of the finalists.
const FINAL: f64 = 0.35;
/// Breaks of a generation, and how many times as many the first one has.
const POPULATION: u64 = 40;
const FIRST: u64 = 4;
/// Most racks of a break in a generation. More simulations give larger generations.
const MOST_RACKS: u64 = 64;
/// Share of a generation that moves the distribution.
const ELITE: f64 = 0.2;
/// Weight of the elite's mean and spread against those before it (de Boer et al. 2005, section 4.2,
/// advise 0.7 to 1).
const SMOOTHING: f64 = 0.7;
/// Smallest spread, as a share of the range.
const LEAST_SPREAD: f64 = 0.01;
/// Breaks that enter the final comparison.
const FINALISTS: usize = 12;
/// One in how many breaks has its next shot searched, and the simulations of such a search.
const EVERY: u64 = 150;
const PER_REPLY: u64 = 100;
/// Simulations of a break with its share of the searches of next shots. Measured: 7 to 9 in pool.
const PER_BREAK: u64 = 8;
/// First rack of the final comparison: far from all that the generations use.
const FINAL_RACKS: u64 = 1 << 40;

/// Largest side and height that is tried in a full break, ball radii: nearly two tips. More costs
/// speed and makes the cue ball swerve.
const BREAK_OFFSET: f64 = 0.3;

/// PCG's stream. Any constant would do.
const STREAM: u128 = 0x6361_726f_6d20_6272_6561_6b73;

/// The ranges of the numbers of [`BreakShot`], in its order.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Space {
    low: [f64; COUNT],
    high: [f64; COUNT],
    /// Largest tip offset, ball radii.
    most_offset: f64,
    /// Whether a shot and its mirror image are worth the same.
    is_symmetric: bool,
}

/// A break with what is known of it.
#[derive(Clone, Copy, Debug)]
struct Rated {
    shot: BreakShot,
    win: f64,
}

/// A search for the break that wins most frames. Its result depends on the frame's game, table,
/// physics and options, on the errors, the seed, the value and the simulations.
pub struct BreakSearch<'a> {
    racks: Racks<'a>,
    space: Space,
    random: Pcg64,
    simulations: u64,
    generation: u64,
    /// The number of the next rack.
    next_rack: u64,
    /// What searches of next shots have found so far.
    corrections: Corrections,
    mean: [f64; COUNT],
    spread: [f64; COUNT],
    /// The best of the last generation, the best first.
    elite: Vec<Rated>,
}

impl<'a> BreakSearch<'a> {
    /// A search with about this many simulations; about 40 000 find a good break of pool. The breaks
    /// of `start` are in the first generation.
    ///
    /// # Errors
    /// As [`Racks::new`].
    pub fn new(
        situation: &Situation<'a>,
        value: &'a dyn Value,
        simulations: u64,
        start: &[BreakShot],
    ) -> Result<Self, Error> {
        let racks = Racks::new(situation, value)?;
        let space = Space::of(racks.start(), racks.noise())?;
        let elite = start.iter().map(|shot| Rated { shot: space.folded(shot), win: 0.0 });
        Ok(Self {
            space,
            random: Pcg64::new(u128::from(situation.seed), STREAM),
            simulations,
            generation: 0,
            next_rack: 0,
            corrections: Corrections::default(),
            mean: [0.5; COUNT],
            spread: [0.5; COUNT],
            elite: elite.collect(),
            racks: racks.with_replies(EVERY, PER_REPLY),
        })
    }

    /// Searches to the end. Returns the best break, its counts in the final comparison and the number
    /// of simulations.
    ///
    /// # Errors
    /// As [`Self::step`] and [`Self::finish`].
    pub fn run(mut self, runner: &Runner) -> Result<(BreakShot, BreakCounts, u64), Error> {
        let mut spent = 0;
        while self.generations_left() > 0 {
            spent += self.step(runner)?;
        }
        let (shot, counts, plays) = self.finish(runner)?;
        Ok((shot, counts, spent + plays))
    }

    /// Number of generations before the final comparison.
    pub const fn generations_left(&self) -> u64 {
        (GENERATIONS + 1).saturating_sub(self.generation)
    }

    /// About how many simulations a generation takes.
    pub const fn step_cost(&self) -> u64 {
        ((1.0 - FINAL) * self.simulations as f64) as u64 / (GENERATIONS + 1)
    }

    /// The best breaks of the last generation, the best first; before the first one those of the start.
    pub fn best(&self) -> impl Iterator<Item = BreakShot> + '_ {
        self.elite.iter().map(|rated| rated.shot)
    }

    /// Plays one generation. Returns the number of simulations.
    ///
    /// # Errors
    /// As [`Racks::count`].
    pub fn step(&mut self, runner: &Runner) -> Result<u64, Error> {
        let is_first = self.generation == 0;
        let breaks = self.step_cost() / PER_BREAK;
        let racks = (breaks / POPULATION).clamp(1, MOST_RACKS);
        let racks = if is_first { racks.div_ceil(FIRST) } else { racks };
        let size = (breaks / racks).max(1) as usize;
        // The elite is played again: on new racks it has no advantage of luck.
        let mut shots: Vec<BreakShot> = self.best().take(size / 4 + 1).collect();
        while shots.len() < size {
            shots.push(if is_first { self.uniform() } else { self.normal() });
        }
        let corrections = &mut self.corrections;
        let (counts, plays) =
            self.racks.count_with(corrections, &shots, self.next_rack, racks, runner)?;
        self.next_rack += racks;
        self.generation += 1;
        let mut rated = rated(shots, &counts);
        rated.truncate(((ELITE * size as f64) as usize).max(2));
        self.fit(&rated, if is_first { 1.0 } else { SMOOTHING });
        if !rated.is_empty() {
            // The best of a generation are a little too lucky, but so are those of the next one.
            let wins: f64 = rated.iter().map(|one| one.win).sum();
            self.racks.rebreak = wins / rated.len() as f64;
        }
        self.elite = rated;
        Ok(plays)
    }

    /// Compares the mean of the distribution and the best breaks by sequential halving. Returns the
    /// winner, its counts in the last comparison and the number of simulations.
    ///
    /// # Errors
    /// As [`Racks::count`], and [`Error::Input`] at `frame` if no break can be played.
    pub fn finish(mut self, runner: &Runner) -> Result<(BreakShot, BreakCounts, u64), Error> {
        let mut shots = vec![self.shot_at(self.mean)];
        shots.extend(self.best().take(FINALISTS - 1));
        let most = (FINAL * self.simulations as f64) as u64 / PER_BREAK;
        let heats = u64::from(usize::BITS - shots.len().leading_zeros());
        let (mut first, mut spent) = (FINAL_RACKS, 0);
        loop {
            let count = (most / heats / shots.len() as u64).max(1);
            let corrections = &mut self.corrections;
            let (counts, plays) =
                self.racks.count_with(corrections, &shots, first, count, runner)?;
            (first, spent) = (first + count, spent + plays);
            let best = rated(shots.clone(), &counts);
            let winner = best.first().ok_or_else(unplayable)?;
            if shots.len() <= 2 {
                let of_winner = shots.iter().zip(counts).find(|(shot, _)| **shot == winner.shot);
                let counts = of_winner.map(|(_, counts)| counts).unwrap_or_default();
                return Ok((winner.shot, counts, spent));
            }
            let keep = shots.len().div_ceil(2);
            shots = best.iter().take(keep).map(|rated| rated.shot).collect();
        }
    }

    /// Moves the distribution towards the elite.
    fn fit(&mut self, elite: &[Rated], weight: f64) {
        if elite.is_empty() {
            return;
        }
        let points: Vec<[f64; COUNT]> =
            elite.iter().map(|one| self.space.shares(&one.shot)).collect();
        let n = points.len() as f64;
        for k in 0..COUNT {
            let mean = points.iter().map(|p| p[k]).sum::<f64>() / n;
            let squares: f64 = points.iter().map(|p| (p[k] - mean) * (p[k] - mean)).sum();
            let spread = sqrt(squares / n);
            self.mean[k] += weight * (mean - self.mean[k]);
            let moved = self.spread[k] + weight * (spread - self.spread[k]);
            self.spread[k] = moved.max(LEAST_SPREAD);
        }
    }

    fn uniform(&mut self) -> BreakShot {
        let shares = core::array::from_fn(|_| unit(&mut self.random));
        self.shot_at(shares)
    }

    fn normal(&mut self) -> BreakShot {
        let shares =
            core::array::from_fn(|k| self.mean[k] + self.spread[k] * deviate(&mut self.random));
        self.shot_at(shares)
    }

    fn shot_at(&self, shares: [f64; COUNT]) -> BreakShot {
        self.space.folded(&self.space.shot(shares))
    }
}

/// At most `count` opening shots that the situation's frame allows: `shots`, their mirror images, and
/// variants of both with these standard deviations (shares of the ranges that are searched).
///
/// # Errors
/// [`Error::Input`] at `frame` if none can be played.
pub(crate) fn variants(
    situation: &Situation<'_>,
    shots: &[BreakShot],
    spread: f64,
    count: usize,
) -> Result<Vec<BreakShot>, Error> {
    let frame = situation.frame;
    let (seat, _) = situation.asked()?;
    let space = Space::of(frame, &situation.noise[seat])?;
    let mirrored = shots.iter().filter(|_| space.is_symmetric).map(BreakShot::mirrored);
    let bases: Vec<BreakShot> = shots.iter().copied().chain(mirrored).collect();
    let mut random = Pcg64::new(u128::from(situation.seed), STREAM);
    let varied = (0..count.saturating_sub(bases.len())).map(|k| {
        let base = bases[k % bases.len()];
        let mean = space.shares(&space.folded(&base));
        let shares = mean.map(|share| share + spread * deviate(&mut random));
        let shot = space.folded(&space.shot(shares));
        if base.across < 0.0 { shot.mirrored() } else { shot }
    });
    let all = bases.iter().copied().chain(varied);
    let kept: Vec<BreakShot> = all.filter(|shot| shot.play(frame).is_ok()).take(count).collect();
    if kept.is_empty() {
        return Err(unplayable());
    }
    Ok(kept)
}

fn unplayable() -> Error {
    let what = "no break can be played on this table";
    ErrorKind::NoPlay.at("frame", what, "look at the places of the balls")
}

/// Uniform in (0, 1).
fn unit(random: &mut Pcg64) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
    ((random.next_u64() >> 11) as f64 + 0.5) * STEP
}

/// Normal, of mean 0 and variance 1.
fn deviate(random: &mut Pcg64) -> f64 {
    let u = 2.0 * unit(random) - 1.0;
    two_sided_quantile(u.abs()) * u.signum()
}

/// The shots that can be played with their win chances, the best first by [`BreakCounts::compare`].
fn rated(shots: Vec<BreakShot>, counts: &[BreakCounts]) -> Vec<Rated> {
    let played = shots.into_iter().zip(counts).filter(|(_, counts)| counts.breaks > 0);
    let mut played: Vec<(BreakShot, &BreakCounts)> = played.collect();
    played.sort_by(|(_, a), (_, b)| b.compare(a));
    played.into_iter().map(|(shot, counts)| Rated { shot, win: counts.win }).collect()
}

impl Space {
    /// The ranges for the opening shot of `frame` by a player with this noise.
    fn of(frame: &Frame, noise: &carom::Noise) -> Result<Self, Error> {
        let center = BreakShot::center(1.0);
        let place = frame.turn().and_then(|turn| center.cue_ball(frame, turn));
        let prepared = Prepared::new(frame, place);
        let shot = match &prepared {
            Ok(prepared) => prepared.shot(),
            // Another ball is there, as the brown in snooker.
            Err(_) => frame.base(),
        };
        let cue = frame.turn().map_or(0, |turn| usize::from(turn.cue));
        let radius = frame.layout().balls()[cue].ball.radius;
        let most_offset = largest_offset(shot, noise, radius);
        let offset = most_offset.min(BREAK_OFFSET);
        let facts = frame.facts();
        let speed = facts.opening.speeds;
        // A rack of fifteen is ten radii wide; its corner ball is hit thinly at about ±6.
        let (aim, offset) = match facts.opening.kind {
            OpeningKind::Break => (2.0, offset),
            OpeningKind::Safety => (7.0, offset),
            OpeningKind::Carom => (2.0, most_offset),
        };
        let is_symmetric = frame.turn().is_some_and(|turn| turn.hand.is_some());
        Ok(Self {
            low: [if is_symmetric { 0.0 } else { -1.0 }, 0.0, -aim, speed[0], -offset, -offset],
            high: [1.0, 1.0, aim, speed[1], offset, offset],
            most_offset,
            is_symmetric,
        })
    }

    fn shot(&self, shares: [f64; COUNT]) -> BreakShot {
        let at = |k: usize| self.low[k] + shares[k] * (self.high[k] - self.low[k]);
        let [across, behind, aim, speed, side, height] = core::array::from_fn(at);
        BreakShot { across, behind, aim, speed, side, height }
    }

    fn shares(&self, shot: &BreakShot) -> [f64; COUNT] {
        let BreakShot { across, behind, aim, speed, side, height } = *shot;
        let numbers = [across, behind, aim, speed, side, height];
        core::array::from_fn(|k| (numbers[k] - self.low[k]) / (self.high[k] - self.low[k]))
    }

    /// The shot within the ranges, on the right half where that makes no difference.
    fn folded(&self, shot: &BreakShot) -> BreakShot {
        let shot = if self.is_symmetric && shot.across < 0.0 { shot.mirrored() } else { *shot };
        let shares = self.shares(&shot).map(|share| share.clamp(0.0, 1.0));
        let shot = self.shot(shares);
        let offset = sqrt(shot.side * shot.side + shot.height * shot.height);
        let shrink = (self.most_offset / offset.max(1e-9)).min(1.0);
        BreakShot { side: shot.side * shrink, height: shot.height * shrink, ..shot }
    }
}
