//! What the levels of play make of a puzzle, and its rating.

use carom::math::{exp, log};
use carom::noise::{Noise, SKILLS, StruckBall};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot, Simulator};

use super::task::Task;
use crate::judge::judge;
use crate::played::Played;

/// The names of the levels, the weakest first.
pub const LEVELS: [&str; 5] = [SKILLS[0].0, SKILLS[1].0, SKILLS[2].0, SKILLS[3].0, SKILLS[4].0];

/// The club's place in [`LEVELS`]: the level for which ways are compared.
pub(super) const CLUB: usize = 2;

/// A way to solve a puzzle.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// The strike.
    pub strike: Strike,
    /// The chance of each of [`LEVELS`] to solve the puzzle with it.
    pub chances: [f64; 5],
}

/// The ratings of the levels. Only differences have a meaning: 400 points are odds of ten to one (Elo 1978).
/// The distance is chosen so that players from beginner to professional have ratings as in chess.
const RATINGS: [f64; 5] = [1000.0, 1300.0, 1600.0, 1900.0, 2200.0];
/// The least and the largest rating of a puzzle.
const RANGE: [f64; 2] = [400.0, 2800.0];

/// Variants that rank strikes, that compare small changes of them, and that measure a chance. Their seeds
/// differ, so that a chance is not measured with the luck that chose the strike.
const RANKING: u64 = 30;
const COMPARISON: u64 = 60;
const MEASURE: u64 = 240;

/// Ways that are measured, and changes of each that are tried.
const WAYS: usize = 4;
const CHANGES: usize = 2;

/// The rating of a puzzle with these chances of the levels: the maximum-likelihood rating under the
/// logistic law of Elo (Rasch 1960), where the expected number of levels that solve it is the sum of the chances.
pub fn rating_of(chances: &[f64; 5]) -> f64 {
    let expected = |rating: f64| -> f64 {
        let odds = |level: f64| exp(log(10.0) * (rating - level) / 400.0);
        RATINGS.iter().map(|level| 1.0 / (1.0 + odds(*level))).sum()
    };
    let solved: f64 = chances.iter().sum();
    let [mut low, mut high] = RANGE;
    // 2400 points halved 20 times: far below the precision of the chances.
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if expected(middle) > solved { low = middle } else { high = middle }
    }
    low
}

/// The angle between the directions of two strikes, rad.
pub(super) fn turned(a: &Strike, b: &Strike) -> f64 {
    let full = core::f64::consts::TAU;
    let turn = (a.azimuth - b.azimuth).rem_euclid(full);
    turn.min(full - turn)
}

/// Plays and judges strikes of a puzzle.
pub(super) struct Measure<'a> {
    pub(super) simulator: Simulator,
    pub(super) task: &'a Task,
}

impl Measure<'_> {
    /// Whether a strike solves the puzzle; a strike that cannot be played does not.
    pub(super) fn solves(&mut self, strike: &Strike) -> bool {
        let Task { shot, goal, .. } = self.task;
        Played::of(&mut self.simulator, shot, Some(strike))
            .and_then(|played| judge(shot, &played, goal, &[]))
            .is_ok_and(|verdict| verdict.fault.is_none())
    }

    /// The share of variants of a strike that solve it.
    fn chance(&mut self, strike: &Strike, noise: &Noise, seed: u64, variants: u64) -> f64 {
        let shot: &Shot = &self.task.shot;
        let Some((cue, _)) = shot.strike() else { return 0.0 };
        let struck = StruckBall::of(shot, &shot.balls()[cue].ball);
        let solved =
            (0..variants).filter(|index| self.solves(&noise.draw(strike, &struck, seed, *index)));
        solved.count() as f64 / variants as f64
    }

    /// The different ways among strikes that solve the puzzle, measured.
    pub(super) fn ways(&mut self, strikes: &[Strike]) -> Result<Vec<Way>, Error> {
        let club = &SKILLS[CLUB].1;
        let mut ranked: Vec<(f64, Strike)> = Vec::with_capacity(strikes.len());
        for strike in strikes {
            ranked.push((self.chance(strike, club, 1, RANKING), *strike));
        }
        // A stable sort, so that strikes of equal rank keep their order.
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut chosen: Vec<Strike> = Vec::new();
        for (_, strike) in ranked {
            if chosen.len() < WAYS && chosen.iter().all(|other| are_different(&strike, other)) {
                chosen.push(strike);
            }
        }
        let mut ways = Vec::new();
        for strike in chosen {
            let strike = self.improved(strike);
            let chances =
                core::array::from_fn(|level| self.chance(&strike, &SKILLS[level].1, 3, MEASURE));
            ways.push(Way { strike, chances });
        }
        Ok(ways)
    }

    /// A strike after small changes of its direction and speed that help a club player.
    fn improved(&mut self, strike: Strike) -> Strike {
        let club = &SKILLS[CLUB].1;
        let mut best = (self.chance(&strike, club, 2, COMPARISON), strike);
        for round in 0..CHANGES {
            let step = 1.0 / (1 << round) as f64;
            let center = best.1;
            for [turn, speed] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                let azimuth = center.azimuth + 0.004 * step * turn;
                let speed = center.speed * (1.0 + 0.06 * step * speed);
                let changed = Strike { azimuth, speed, ..center };
                let chance = self.chance(&changed, club, 2, COMPARISON);
                if chance > best.0 {
                    best = (chance, changed);
                }
            }
        }
        best.1
    }
}

/// Whether players would call two strikes different ways.
fn are_different(a: &Strike, b: &Strike) -> bool {
    turned(a, b) > 0.03
        || (a.speed / b.speed - 1.0).abs() > 0.3
        || (a.height - b.height).abs() > 0.25
        || (a.side - b.side).abs() > 0.25
}
