//! A request for a shot, and the answers that all players of the literature give in the same way.
//!
//! The papers describe how their players choose a pot in eight-ball. Everything else that a referee
//! can ask is answered here, in the same way for all of them: choices and safeties by the player's
//! own value of positions, places for a ball in hand by geometry, breaks by a fixed strike, and
//! carom games by a search over directions. **Guess:** all of this file; the papers leave it open.

use std::sync::Arc;

use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise};
use carom_rules::{Play, Seat, Turn};

use super::best_shots::BestShots;
use super::pot_table::PotTable;
use super::shots::Sight;
use crate::player::{Budget, Situation, Spent};
use crate::scene::Scene;
use crate::search::{Candidate, CuePlace, Explorer, ShotTask, cue_places, raised};
use crate::targets::call_of;
use crate::value::{Position, Value};
use crate::workbench::Workbench;
use carom::noise::Errors;
use carom_plan::Prepared;

/// Share of the budget that the search for a safety may use.
const SAFETY_SHARE: f64 = 0.3;
/// Simulations of a search for a safety: at least one round of hits, at most the whole lattice.
const SAFETY_PLAYS: [u64; 2] = [60, 1500];
/// Safeties that are played with drawn errors, and the number of errors.
const SAFETIES_SAMPLED: usize = 5;
const SAFETY_SAMPLES: u64 = 10;
/// Simulations of the search for any legal shot, when nothing else is left.
const ANYTHING_PLAYS: u64 = 540;
/// Simulations of the search for a carom, at least.
const LEAST_CAROM_PLAYS: u64 = 200;
/// Places of a cue ball in hand that are considered.
const PLACES: usize = 3;
/// Cue speed (m/s) and height (ball radii) of the usual break: a full hit, about as hard as good
/// players break. It is the same for every player that brings no break of its own.
const BREAK_SPEED: f64 = 9.0;
const BREAK_HEIGHT: f64 = 0.1;
/// Cue speed (m/s) of a shot that is played because nothing legal was found.
const HOPELESS_SPEED: f64 = 2.0;

/// A request for a shot, prepared.
pub struct Baseline<'a> {
    pub(crate) situation: &'a Situation<'a>,
    pub(crate) budget: &'a Budget<'a>,
    pub(crate) turn: &'a Turn,
    /// The player's value of positions.
    pub(crate) value: BestShots,
    /// The positions of the cue ball, the most promising first.
    pub(crate) prepared: Vec<Prepared<'a>>,
}

impl<'a> Baseline<'a> {
    pub(crate) fn new(
        situation: &'a Situation<'a>,
        budget: &'a Budget<'a>,
        turn: &'a Turn,
        value: BestShots,
    ) -> Result<Self, Error> {
        let task = ShotTask { situation, turn, value: &value };
        let places: Vec<Option<[f64; 2]>> = match turn.hand {
            None => vec![None],
            Some(region) if situation.frame.is_opening() => {
                task.opening_places(region).into_iter().map(Some).collect()
            }
            Some(region) => task.places(region).into_iter().take(PLACES).map(Some).collect(),
        };
        let prepared = places.into_iter().map(|place| Prepared::new(situation.frame, place));
        let prepared = prepared.collect::<Result<Vec<_>, _>>()?;
        Ok(Self { situation, budget, turn, value, prepared })
    }

    pub(crate) const fn seat(&self) -> Seat {
        self.turn.player
    }

    /// The errors of the player's strikes.
    pub(crate) fn noise(&self) -> Noise {
        self.situation.noise[self.turn.player].clone()
    }

    pub(crate) fn table(&self) -> Arc<PotTable> {
        Arc::clone(&self.value.tables[self.seat()])
    }

    /// The errors that the player draws for its decision.
    pub(crate) fn errors(&self) -> Errors {
        let Situation { perception, seed, .. } = self.situation;
        Errors { noise: self.noise(), perception: perception.clone(), seed: *seed }
    }

    /// What the player sees from the prepared positions.
    pub(crate) fn sight(&self) -> Sight<'a> {
        Sight::new(self.situation.frame, self.turn, self.table(), self.noise())
    }

    /// The simulations that are left, and at least `least`.
    pub(crate) fn left(&self, spent: &Spent, least: u64) -> u64 {
        self.budget.simulations.saturating_sub(spent.simulations).max(least)
    }

    /// The shot, judged by the player's value.
    pub(crate) fn task(&self) -> ShotTask<'_> {
        ShotTask { situation: self.situation, turn: self.turn, value: &self.value }
    }

    /// The prepared positions with their numbers.
    pub(crate) fn places(&self) -> impl Iterator<Item = CuePlace<'_>> {
        cue_places(&self.prepared)
    }

    /// The most promising one.
    fn first_place(&self) -> CuePlace<'_> {
        CuePlace { number: 0, prepared: &self.prepared[0] }
    }
}

/// The usual break: a full and hard hit of the nearest ball from the first place.
pub(crate) fn usual_break(baseline: &Baseline<'_>) -> Option<Play> {
    let prepared = baseline.prepared.first()?;
    let toward = toward_nearest(baseline, prepared, BREAK_SPEED, BREAK_HEIGHT)?;
    prepared.shot().resolve_strike(&toward.strike).is_ok().then_some(toward)
}

/// A full hit of the nearest ball that may be hit; `speed` in m/s, `height` in ball radii.
fn toward_nearest(
    baseline: &Baseline<'_>,
    prepared: &Prepared<'_>,
    speed: f64,
    height: f64,
) -> Option<Play> {
    let scene = Scene::of(prepared);
    let cue = scene.ball(baseline.turn.cue)?;
    let sight = baseline.sight();
    let balls = sight.targets.first.iter().filter_map(|ball| scene.ball(*ball));
    let gap = |center: Vec2| (center - cue.center).length_squared();
    let head = balls.min_by(|a, b| gap(a.center).total_cmp(&gap(b.center)))?;
    let way = head.center - cue.center;
    let azimuth = atan2(way.y, way.x);
    let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height };
    let strike = raised(prepared, strike);
    let call = call_of(baseline.turn, head.index, None);
    Some(Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) })
}

/// The safety that leaves the other player least, and its value for the player, 0 to 1; none if no
/// legal shot was found.
pub(crate) fn safety(
    baseline: &Baseline<'_>,
    spent: &mut Spent,
) -> Result<Option<(Play, f64)>, Error> {
    let share = (SAFETY_SHARE * baseline.budget.simulations as f64) as u64;
    let most = share.clamp(SAFETY_PLAYS[0], SAFETY_PLAYS[1]);
    let mut explorer = Explorer::new(baseline.task());
    explorer.safeties(baseline.first_place(), most)?;
    spent.simulations += explorer.bench.plays;
    let mut found: Vec<Candidate> = explorer.found;
    found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
    found.truncate(SAFETIES_SAMPLED);
    let errors = baseline.errors();
    let rated = baseline.budget.runner.map(
        found.iter(),
        || Workbench::new(baseline.situation.frame),
        |bench, candidate| {
            let mut sum = 0.0;
            let (prepared, samples) = (&baseline.prepared[0], 0..SAFETY_SAMPLES);
            bench.sample(prepared, &candidate.play, &errors, samples, |next, _| {
                let position = Position { frame: next, noise: &baseline.situation.noise };
                sum += baseline.value.win_chance(&position, baseline.seat());
            })?;
            Ok((candidate.play, sum / SAFETY_SAMPLES as f64))
        },
    );
    spent.simulations += SAFETY_SAMPLES * rated.len() as u64;
    let rated = rated.into_iter().collect::<Result<Vec<_>, Error>>()?;
    Ok(first_best(rated, |(_, value)| *value))
}

/// A legal shot in any direction; if there is none, a full hit of the nearest ball.
pub(crate) fn anything(baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Play, Error> {
    let prepared = &baseline.prepared[0];
    let mut explorer = Explorer::new(baseline.task());
    explorer.anything(baseline.first_place(), ANYTHING_PLAYS)?;
    spent.simulations += explorer.bench.plays;
    if let Some(best) = first_best(explorer.found, |candidate| candidate.prior) {
        return Ok(best.play);
    }
    let hopeless = || {
        let strike =
            Strike { speed: HOPELESS_SPEED, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };
        let first = baseline.turn.on.first().copied().unwrap_or(baseline.turn.cue);
        let call = call_of(baseline.turn, first, None);
        let strike = raised(prepared, strike);
        Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) }
    };
    Ok(toward_nearest(baseline, prepared, HOPELESS_SPEED, 0.0).unwrap_or_else(hopeless))
}

/// The most promising carom.
pub(crate) fn carom(baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Play, Error> {
    let most = baseline.budget.simulations.max(LEAST_CAROM_PLAYS);
    let mut explorer = Explorer::new(baseline.task());
    explorer.caroms(baseline.first_place(), most)?;
    spent.simulations += explorer.bench.plays;
    match first_best(explorer.found, |candidate| candidate.prior) {
        Some(best) => Ok(best.play),
        None => anything(baseline, spent),
    }
}

/// The item with the largest value; the first of equals.
pub(crate) fn first_best<T>(
    items: impl IntoIterator<Item = T>,
    value: impl Fn(&T) -> f64,
) -> Option<T> {
    items.into_iter().reduce(|best, item| if value(&item) > value(&best) { item } else { best })
}
