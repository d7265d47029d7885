//! Candidates that score with the cue ball: the games of carom.

use core::f64::consts::TAU;

use carom::Error;
use carom::math::{asin, atan2, sin_cos, sqrt};
use carom::resolve::cue_ball::Strike;
use carom_plan::{CaromPattern, Prepared};
use carom_rules::{CaromWay, Objective};

use super::candidate::PlayKind;
use super::explore::{CuePlace, Explorer, FoundPlay, raised};
use crate::scene::Scene;
use crate::targets::call_of;

/// The additive recurrence of Roberts (2018) in five dimensions: powers of 1/φ₅, where φ₅ is the
/// real root of x⁶ = x + 1.
const STEPS: [f64; 5] = [
    0.880_737_461_877_619_6,
    0.775_698_478_770_158_5,
    0.683_186_709_165_853_8,
    0.601_708_127_851_388_4,
    0.529_946_888_950_219_6,
];
/// Share of the strikes that go to a cushion first, in any direction.
const INDIRECT: f64 = 0.25;
/// Least and greatest cue speed, m/s, where cushions are needed and where they are not.
const SPEEDS: [[f64; 2]; 2] = [[1.6, 7.0], [0.4, 4.0]];
/// Largest hit, as a share of a ball's apparent half width.
const THINNEST: f64 = 0.97;
/// Largest tip offset, as a share of the miscue limit.
const OFFSET: f64 = 0.75;
/// Estimated value, over that of a miss, of a shot that scores without errors.
const CHANCE: f64 = 0.35;

impl Explorer<'_> {
    /// The pattern of the carom of the last ruled simulation.
    pub(crate) fn carom_pattern(&self, prepared: &Prepared<'_>) -> Option<CaromPattern> {
        let cue = crate::aim::index_in_shot(prepared, self.task.turn.cue)?;
        let placed = &prepared.shot().balls()[usize::from(cue)];
        let (start, table) = (placed.state.position, prepared.shot().table());
        let outcome = self.bench.sampler.outcome();
        CaromPattern::of(&CaromWay::new(outcome, table, [start.x, start.y], placed.ball.radius))
    }

    /// Adds strikes that score without errors, among points spread evenly over direction, speed and
    /// spin.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn caroms(&mut self, at: CuePlace<'_>, until: u64) -> Result<(), Error> {
        let prepared = at.prepared;
        let scene = Scene::of(prepared);
        let Some(cue) = scene.ball(self.task.turn.cue) else { return Ok(()) };
        let objects: Vec<_> =
            self.targets.first.iter().filter_map(|ball| scene.ball(*ball)).collect();
        let Some(first) = objects.first().copied() else { return Ok(()) };
        let objective = self.task.frame().facts().objective;
        let [slowest, fastest] =
            SPEEDS[usize::from(objective == Objective::Caroms { cushions: 0 })];
        let most = OFFSET * prepared.shot().miscue_limit().min(1.0);
        let call = call_of(self.task.turn, first.index, None);
        let mut point = [0.5; 5];
        while self.bench.plays < until {
            for (x, step) in point.iter_mut().zip(STEPS) {
                *x = (*x + step) % 1.0;
            }
            let [turn, pick, pace, angle, out] = point;
            let azimuth = if pick < INDIRECT {
                TAU * turn
            } else {
                let share = (pick - INDIRECT) / (1.0 - INDIRECT) * objects.len() as f64;
                let ball = objects[(share as usize).min(objects.len() - 1)];
                let way = ball.center - cue.center;
                let half = asin(((cue.radius + ball.radius) / way.length()).min(1.0));
                atan2(way.y, way.x) + THINNEST * half * (2.0 * turn - 1.0)
            };
            let (sin, cos) = sin_cos(TAU * angle);
            let offset = most * sqrt(out);
            let speed = slowest + pace * (fastest - slowest);
            let (side, height) = (offset * cos, offset * sin);
            let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
            let strike = raised(prepared, strike);
            if self.bench.sampler.simulate(prepared, &strike).is_err() {
                self.bench.plays += 1;
                continue;
            }
            self.bench.plays += 1;
            let (value, is_legal) = self.ruled(prepared, call)?;
            let (kind, prior) = match self.keeps_turn() {
                true => (PlayKind::Carom, CHANCE * value),
                false => (PlayKind::Safety, value),
            };
            if is_legal && (kind == PlayKind::Carom || self.found.len() < 4) {
                self.keep(at, FoundPlay { strike, call, kind, line: None, prior });
            }
        }
        Ok(())
    }
}
