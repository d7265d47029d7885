//! PoolMaster: a strike that leaves the cue ball at a target.
//!
//! Dussault & Landry, *Optimization of a billiard player – tactical play*, Computers and Games
//! 2006, LNCS 4630; Landry & Dussault, *AI optimization of a billiard player*, J. Intell. Robot.
//! Syst. 50,
//! 2007. For each pot a grid rates the places of the cue ball for the next shot; a local optimiser
//! looks for the strike that pots the ball and leaves the cue ball at a good place; and the player
//! takes the pot with the best product of both probabilities. It plans one shot ahead.
//!
//! **Guess:** the optimiser. The papers minimise a smooth function of the strike with a method for
//! smooth functions; the end of a simulated shot is not smooth, so we use the pattern search of
//! Hooke & Jeeves, *"Direct search" solution of numerical and statistical problems*, 1961, over
//! the logarithm of the speed and the two tip offsets. For each strike the azimuth that pots the
//! ball is found by simulation.

use carom::Error;
use carom::math::Vec2;
use carom_rules::{Play, Request};

use super::baseline::{Baseline, first_best};
use super::planner::{Attack, Method, Planner};
use super::position_grid::PositionGrid;
use super::pot_table::EVERY_KIND;
use super::shots::{Correction, PotShot, Sight, Stroke};
use crate::line::Line;
use crate::player::Spent;
use crate::workbench::Workbench;

/// Speeds (m/s) and heights of the first strikes, from which the optimiser starts. Guess.
const SPEEDS: [f64; 5] = [1.8, 1.0, 3.0, 0.6, 4.5];
const HEIGHTS: [f64; 3] = [0.0, -0.8, 0.8];
/// Usual number of simulations that aim one strike.
const AIMING: u64 = 3;
/// Share of the budget for the first strikes; the optimiser has the rest.
const STARTING: f64 = 0.35;
/// First steps of the pattern search: a factor of 1.25 in speed, a third of the largest offset.
const FIRST_STEP: f64 = 0.32;
/// The search ends with steps of a tenth of the first ones.
const LAST_STEP: f64 = 0.1 * FIRST_STEP;
/// Slowest and fastest strike, m/s.
const RANGE: [f64; 2] = [0.3, 7.0];

/// Settings of [`PoolMaster`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoolMasterSettings {
    /// Lines that are considered, the most probable. Guess.
    pub lines: usize,
    /// Targets of the cue ball for each line. Guess: the papers choose targets by a heuristic.
    pub targets: usize,
    /// Least distance between two targets, m. Guess: about three balls.
    pub apart: f64,
    /// Strikes that the optimiser tries for one target. Guess.
    pub strikes: u32,
    /// Distance (m) from the target at which the optimiser stops: half a ball. Guess.
    pub close: f64,
    /// A safety is preferred to a shot that is less probable than this, if the safety is worth
    /// more. Guess.
    pub safety_below: f64,
}

impl Default for PoolMasterSettings {
    fn default() -> Self {
        Self { lines: 6, targets: 4, apart: 0.17, strikes: 24, close: 0.03, safety_below: 0.3 }
    }
}

/// PoolMaster.
pub type PoolMaster = Planner<PoolMasterSettings>;

/// A play, its probability, and the quality of the position that it leaves.
#[derive(Clone, Copy, Debug)]
struct Positional {
    play: Play,
    chance: f64,
    quality: f64,
}

/// A target of the optimiser, and the strike from which it starts.
struct Task<'a> {
    target: Vec2,
    quality: f64,
    start: &'a PotShot,
    grid: &'a PositionGrid,
}

impl PoolMasterSettings {
    /// The first strikes along the best lines of every place, and the number of simulations.
    fn starts(&self, baseline: &Baseline<'_>, most: u64) -> Result<(Vec<PotShot>, u64), Error> {
        let sight = baseline.sight();
        let with = |height: f64| SPEEDS.map(|speed| Stroke { speed, side: 0.0, height });
        let strokes: Vec<Stroke> = HEIGHTS.into_iter().flat_map(with).collect();
        let mut bench = Workbench::new(baseline.situation.frame);
        let own = most / baseline.prepared.len().max(1) as u64;
        let mut shots = Vec::new();
        for at in baseline.places() {
            let mut lines = sight.lines(at.prepared, &EVERY_KIND);
            lines.truncate(self.lines);
            let found = bench.pot_shots(&sight, at, &lines, &strokes, own)?;
            // The strikes of a line follow each other, the most probable line first.
            for (line, _) in &lines {
                shots.extend(found.iter().filter(|shot| shot.line == *line).cloned());
            }
        }
        Ok((shots, bench.plays))
    }

    /// The strikes that the optimiser finds, and those from which it starts.
    fn positional(
        &self,
        baseline: &Baseline<'_>,
        spent: &mut Spent,
    ) -> Result<Vec<Positional>, Error> {
        let budget = baseline.left(spent, 1);
        let (starts, plays) = self.starts(baseline, (STARTING * budget as f64) as u64)?;
        spent.simulations += plays;
        let firsts = firsts(&starts);
        let grids: Vec<Option<PositionGrid>> = baseline.budget.runner.map(
            firsts.iter().map(|group| &starts[group.0]),
            || (),
            |(), shot| grid_after(baseline, shot),
        );
        let mut found: Vec<Positional> = Vec::new();
        let mut tasks: Vec<Task<'_>> = Vec::new();
        for ((first, end), grid) in firsts.into_iter().zip(&grids) {
            let group = &starts[first..end];
            found.extend(group.iter().map(|shot| positional(baseline, shot, grid.as_ref())));
            let Some(grid) = grid else { continue };
            for (target, quality) in grid.best(self.targets, self.apart) {
                let gap = |shot: &PotShot| end_gap(baseline, shot, target);
                let nearest = group.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
                tasks.extend(nearest.map(|start| Task { target, quality, start, grid }));
            }
        }
        let promise = |task: &Task<'_>| task.start.chance * task.quality;
        tasks.sort_by(|a, b| promise(b).total_cmp(&promise(a)));
        let cost = AIMING * u64::from(self.strikes.max(1));
        tasks.truncate((baseline.left(spent, 0) / cost) as usize);
        let optimised = baseline.budget.runner.map(
            tasks,
            || Workbench::new(baseline.situation.frame),
            |bench, task| {
                let before = bench.plays;
                let best = self.optimise(baseline, bench, &task, cost)?;
                Ok((best, bench.plays - before))
            },
        );
        for best in optimised {
            let (best, plays) = best.map_err(|error: Error| error)?;
            found.push(best);
            spent.simulations += plays;
        }
        Ok(found)
    }

    /// Moves the cue ball's end towards the target by changes of speed and spin, within `most`
    /// simulations.
    fn optimise(
        &self,
        baseline: &Baseline<'_>,
        bench: &mut Workbench,
        task: &Task<'_>,
        most: u64,
    ) -> Result<Positional, Error> {
        let sight = baseline.sight();
        let shot = task.start;
        let prepared = &baseline.prepared[shot.place];
        let mut known = Correction::default();
        let mut best = (end_gap(baseline, shot, task.target), shot.clone());
        let mut step = FIRST_STEP;
        let end = bench.plays + most;
        while step >= LAST_STEP && best.0 > self.close {
            let mut is_better = false;
            for changed in neighbours(best.1.stroke, step) {
                if bench.plays >= end {
                    break;
                }
                let aimed = bench.aimed(&sight, prepared, &shot.line, changed, &mut known)?;
                let Some(play) = aimed else { continue };
                let successor = bench.successor.clone();
                let tried = PotShot { stroke: changed, play, successor, ..shot.clone() };
                let gap = end_gap(baseline, &tried, task.target);
                if gap < best.0 {
                    best = (gap, tried);
                    is_better = true;
                    break;
                }
            }
            if !is_better {
                step *= 0.5;
            }
        }
        Ok(positional(baseline, &best.1, Some(task.grid)))
    }
}

/// The strikes of each line in `shots`, from the first to before the last.
fn firsts(shots: &[PotShot]) -> Vec<(usize, usize)> {
    let mut groups: Vec<(usize, usize)> = Vec::new();
    for (k, shot) in shots.iter().enumerate() {
        match groups.last_mut() {
            Some(last) if is_same(&shots[last.0], shot) => last.1 = k + 1,
            _ => groups.push((k, k + 1)),
        }
    }
    groups
}

fn is_same(a: &PotShot, b: &PotShot) -> bool {
    let of = |line: &Line| (line.kind, line.first, line.object, line.pocket);
    a.place == b.place && of(&a.line) == of(&b.line)
}

/// The six strokes around `stroke`, within range.
fn neighbours(stroke: Stroke, step: f64) -> impl Iterator<Item = Stroke> {
    let change = libm::exp2(step);
    let Stroke { speed, side, height } = stroke;
    let faster = Stroke { speed: (speed * change).min(RANGE[1]), ..stroke };
    let slower = Stroke { speed: (speed / change).max(RANGE[0]), ..stroke };
    let at = move |side: f64, height: f64| Stroke {
        side: side.clamp(-1.0, 1.0),
        height: height.clamp(-1.0, 1.0),
        ..stroke
    };
    [
        faster,
        slower,
        at(side, height + step),
        at(side, height - step),
        at(side + step, height),
        at(side - step, height),
    ]
    .into_iter()
    .filter(move |changed| *changed != stroke)
}

/// The grid for the next shot after `shot`; none if the player does not shoot next from where the
/// cue ball lies.
fn grid_after(baseline: &Baseline<'_>, shot: &PotShot) -> Option<PositionGrid> {
    let frame = &shot.successor;
    let turn = frame.turn().filter(|turn| turn.player == baseline.seat() && turn.hand.is_none())?;
    let sight = Sight::new(frame, turn, baseline.table(), baseline.noise());
    Some(PositionGrid::new(frame, &sight))
}

/// Where the cue ball ends, m, engine's coordinates; none if it is down.
fn end_of(baseline: &Baseline<'_>, shot: &PotShot) -> Option<Vec2> {
    let [x, y] = shot.successor.layout().place(baseline.turn.cue)?;
    Some(Vec2::new(x, y) - shot.successor.base().table().center())
}

/// Distance of the cue ball's end from `target`, m; infinite if the player does not shoot next.
fn end_gap(baseline: &Baseline<'_>, shot: &PotShot, target: Vec2) -> f64 {
    let is_own = shot.successor.turn().is_some_and(|turn| turn.player == baseline.seat());
    let end = end_of(baseline, shot).filter(|_| is_own);
    end.map_or(f64::INFINITY, |end| (end - target).length())
}

/// The play of `shot` with the quality of what it leaves: 1 for a won frame, 0 for a lost turn.
fn positional(baseline: &Baseline<'_>, shot: &PotShot, grid: Option<&PositionGrid>) -> Positional {
    let seat = baseline.seat();
    let quality = match (shot.successor.request(), end_of(baseline, shot), grid) {
        (Request::Over { winner, .. }, ..) => f64::from(u8::from(*winner == Some(seat))),
        (Request::Shot(turn), Some(end), Some(grid)) if turn.player == seat => grid.at(end),
        // A ball in hand is as good as the best place.
        (Request::Shot(turn), ..) if turn.player == seat && turn.hand.is_some() => 1.0,
        _ => 0.0,
    };
    Positional { play: shot.play, chance: shot.chance, quality }
}

impl Method for PoolMasterSettings {
    fn name(&self) -> String {
        "pool-master".into()
    }

    fn safety_below(&self) -> f64 {
        self.safety_below
    }

    /// The pot with the best product of its own probability and that of the next one. A pot that
    /// leaves nothing still counts a little, so that the most probable one is played.
    fn attack(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Attack>, Error> {
        /// What a pot without a next shot is worth. Guess.
        const ALONE: f64 = 0.1;
        let found = self.positional(baseline, spent)?;
        let best = first_best(found, |found| found.chance * (ALONE + found.quality));
        Ok(best.map(|Positional { play, chance, .. }| Attack { play, chance }))
    }
}
