//! Candidates for the opening shot of a rack: known breaks and their variants, found ones where
//! none is known, and a lattice.

use carom::Error;
use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom_rules::{OpeningKind, Play, Region};

use super::break_search::{BreakSearch, variants};
use super::candidate::PlayKind;
use super::explore::{CuePlace, Explorer, FoundPlay, cue_places, raised};
use super::task::{SearchTask, ShotTask};
use crate::breaks::{BreakShot, Fit, found};
use crate::player::Spent;
use crate::scene::Scene;
use crate::targets::call_of;
use carom_plan::Prepared;

/// A break is searched if a decision has at least this many simulations; with fewer the best known
/// one of a similar table is better.
const LEAST_TO_SEARCH: u64 = 4000;
/// Share of a decision's simulations that search a break, and their largest number: some seconds.
const SEARCHING: f64 = 0.5;
const MOST_TO_SEARCH: u64 = 40_000;
/// Breaks of a search that enter the race.
const FROM_SEARCH: usize = 3;
/// Simulations of the first round for each break, those for all of them, and the most breaks.
const PER_BREAK: u64 = 100;
const RACED: u64 = 1500;
const MOST_BREAKS: u64 = 16;
/// Standard deviations of the variants of a break, as a share of the ranges that are searched: of
/// one that was searched on this table, and of one of a similar table.
const NEAR: f64 = 0.03;
const FAR: f64 = 0.08;
/// Difference of the priors of one opening shot and the next: only their order matters.
const PRIOR_STEP: f64 = 1e-3;

/// The opening shots that a decision compares, the most promising first: the known break, its
/// mirror image, and variants of both. The rack is known, so a variant can be better than the
/// break that is the best one on average. Where no break is known for the table, generations of a
/// [`BreakSearch`] are rounds of the decision.
///
/// # Errors
/// As [`BreakSearch::step`], and [`Error::Input`] for a given break that cannot be played.
pub(crate) fn opening_shots(
    task: &SearchTask<'_>,
    spent: &mut Spent,
) -> Result<Vec<BreakShot>, Error> {
    let SearchTask { shot: ShotTask { situation, turn, value }, settings, budget } = *task;
    let frame = situation.frame;
    if let Some(shot) = settings.break_shot.fixed(frame) {
        let played = shot.play(frame);
        return played.map(|_| vec![shot]).map_err(|error| error.inside("settings.break_shot"));
    }
    let known = found(frame, &situation.noise[turn.player]);
    let usual = BreakShot::usual(frame);
    let mut shots = vec![known.map_or(usual, |(entry, _)| entry.shot)];
    let is_known = known.is_some_and(|(_, fit)| fit == Fit::Same);
    if !is_known && budget.simulations >= LEAST_TO_SEARCH {
        let share = (SEARCHING * budget.simulations as f64) as u64;
        let mut search = BreakSearch::new(situation, value, share.min(MOST_TO_SEARCH), &shots)?;
        // The race is the last round, so that the number of rounds repeats the decision.
        let is_allowed = |spent: Spent| budget.rounds.is_none_or(|most| spent.rounds + 1 < most);
        while search.generations_left() > 0
            && is_allowed(*spent)
            && budget.allows(*spent, search.step_cost())
        {
            spent.simulations += search.step(&budget.runner)?;
            spent.rounds += 1;
        }
        // A short search may not find a better break than the one with which it began.
        shots.extend(search.best().take(FROM_SEARCH));
    }
    let size = RACED.min(budget.simulations);
    let count = (size / PER_BREAK).clamp(1, MOST_BREAKS) as usize;
    variants(situation, &shots, if is_known { NEAR } else { FAR }, count)
}

/// Places of the cue ball across the region, as shares of its width, and depths behind its far
/// edge, as shares of the region's depth.
const ACROSS: [f64; 5] = [0.5, 0.3, 0.7, 0.08, 0.92];
const BEHIND: [f64; 2] = [0.04, 0.3];
/// Cue speeds, m/s, heights (ball radii), and hits of the first ball as shares of its width.
const SPEEDS: [f64; 3] = [8.0, 6.5, 9.5];
const HEIGHTS: [f64; 3] = [0.1, -0.1, 0.25];
const HITS: [f64; 3] = [0.0, 0.12, -0.12];

impl ShotTask<'_> {
    /// Places of the cue ball for an opening shot, file coordinates, m.
    pub(crate) fn opening_places(&self, region: Region) -> Vec<[f64; 2]> {
        let table = self.frame().base().table();
        let [low, high] = region.bounds(table);
        let mut places = Vec::new();
        for behind in BEHIND {
            for across in ACROSS {
                let x = low[0] + across * (high[0] - low[0]);
                let y = high[1] - behind * (high[1] - low[1]);
                let is_free = Prepared::new(self.frame(), Some([x, y])).is_ok();
                if region.holds(table, [x, y]) && is_free {
                    places.push([x, y]);
                }
            }
        }
        places
    }

    /// Whether the opening shot of this game spreads the balls.
    pub(crate) fn breaks_hard(&self) -> bool {
        self.frame().facts().opening.kind == OpeningKind::Break
    }
}

impl Explorer<'_> {
    /// Adds opening shots, each from its own place. Their order is the order of their priors.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn openings(
        &mut self,
        shots: &[BreakShot],
        prepared: &[Prepared<'_>],
    ) -> Result<(), Error> {
        let kind = match self.task.frame().facts().opening.kind {
            OpeningKind::Break => PlayKind::Break,
            OpeningKind::Safety => PlayKind::Safety,
            OpeningKind::Carom => PlayKind::Carom,
        };
        for (shot, at) in shots.iter().zip(cue_places(prepared)) {
            let Play { strike, call, .. } = shot.play_of(at.prepared)?;
            if self.bench.sampler.simulate(at.prepared, &strike).is_err() {
                continue;
            }
            self.bench.plays += 1;
            self.ruled(at.prepared, call)?;
            let prior = 1.0 - PRIOR_STEP * at.number as f64;
            self.keep(at, FoundPlay { strike, call, kind, line: None, prior });
        }
        Ok(())
    }

    /// Adds hard breaks from one place. All have the same prior: the race decides.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn breaks(&mut self, at: CuePlace<'_>, until: u64) -> Result<(), Error> {
        let prepared = at.prepared;
        let scene = Scene::of(prepared);
        let Some(cue) = scene.ball(self.task.turn.cue) else { return Ok(()) };
        let nearest = |ball: &&crate::scene::SceneBall| {
            let way: Vec2 = ball.center - cue.center;
            (way.length_squared() * 1e9) as u64
        };
        let objects = scene.balls().iter().filter(|ball| ball.index != cue.index);
        let Some(head) = objects.min_by_key(nearest) else { return Ok(()) };
        let way = head.center - cue.center;
        let (middle, distance) = (atan2(way.y, way.x), way.length());
        for speed in SPEEDS {
            for height in HEIGHTS {
                for hit in HITS {
                    let azimuth = middle + hit * (head.radius + cue.radius) / distance;
                    let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height };
                    let strike = raised(prepared, strike);
                    let is_spent = self.bench.plays >= until;
                    if is_spent || self.bench.sampler.simulate(prepared, &strike).is_err() {
                        continue;
                    }
                    self.bench.plays += 1;
                    let call = call_of(self.task.turn, head.index, None);
                    let (prior, _) = self.ruled(prepared, call)?;
                    let kind = PlayKind::Break;
                    self.keep(at, FoundPlay { strike, call, kind, line: None, prior });
                }
            }
        }
        Ok(())
    }
}
