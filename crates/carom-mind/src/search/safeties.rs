//! Candidates that do not pot: safeties, escapes, and shots in all directions.

use core::f64::consts::TAU;

use carom::Error;
use carom::math::{Vec2, asin, atan2, exp, log, sin_cos, sqrt};
use carom::resolve::cue_ball::Strike;
use carom_rules::{BallIndex, Call};

use super::candidate::PlayKind;
use super::explore::{CuePlace, Explorer, FoundPlay, cue_places, raised};
use super::pots::sequence_point;
use super::windows::MeantPot;
use crate::scene::{Scene, SceneBall, ghost};
use crate::targets::call_of;
use carom_plan::Prepared;

/// Cue speeds, m/s, and heights (ball radii) of safeties.
const SPEEDS: [f64; 6] = [0.45, 0.7, 1.1, 1.7, 2.6, 4.0];
const HEIGHTS: [f64; 3] = [0.0, -0.35, 0.35];
/// Where a ball is hit, as shares of its apparent half width.
const HITS: [f64; 9] = [0.0, -0.3, 0.3, -0.55, 0.55, -0.75, 0.75, -0.9, 0.9];
/// Greatest cue speed of a hit, m/s.
const FASTEST: f64 = 6.0;
/// Estimated value, over that without errors, of a hit that scores without a line.
const LUCK: f64 = 0.5;
/// Number of directions of a search around the whole table.
const DIRECTIONS: u32 = 180;

impl Explorer<'_> {
    /// Adds shots that hit a ball on without potting it.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn safeties(&mut self, at: CuePlace<'_>, until: u64) -> Result<(), Error> {
        let scene = Scene::of(at.prepared);
        let Some(cue) = scene.ball(self.task.turn.cue) else { return Ok(()) };
        let mut azimuths = self.direct_hits(&scene, cue);
        if azimuths.is_empty() {
            azimuths = self.kick_hits(&scene, cue);
        }
        // The plain hits of all balls first, so that a small budget tries each of them.
        for speed in SPEEDS {
            for height in HEIGHTS {
                for (azimuth, first) in &azimuths {
                    if self.bench.plays < until {
                        self.try_hit(at, level_strike(speed, *azimuth, height), *first)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Adds shots that hit a ball on anywhere, with any speed and spin. `first` is the number of the
    /// first strike; returns that of the next.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn more_hits(
        &mut self,
        prepared: &[Prepared<'_>],
        first: u64,
        until: u64,
    ) -> Result<u64, Error> {
        let Some(at) = cue_places(prepared).next() else { return Ok(first) };
        let scene = Scene::of(at.prepared);
        let Some(cue) = scene.ball(self.task.turn.cue) else { return Ok(first) };
        let balls: Vec<SceneBall> =
            self.targets.first.iter().filter_map(|ball| scene.ball(*ball)).collect();
        let most = self.largest_offset(at.prepared);
        let mut index = first;
        while self.bench.plays < until && !balls.is_empty() {
            index += 1;
            let ball = balls[index as usize % balls.len()];
            let [share, pace, angle, out] = sequence_point(index);
            let before = self.bench.plays;
            if let Some(azimuth) = hit_at(&scene, cue, ball, 2.0 * share - 1.0) {
                let (sin, cos) = sin_cos(TAU * angle);
                let offset = most * sqrt(out);
                let speed = SPEEDS[0] * exp(pace * log(FASTEST / SPEEDS[0]));
                let (side, height) = (offset * cos, offset * sin);
                let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
                self.try_hit(at, strike, ball.index)?;
            }
            // A hit that cannot be played costs nothing, but the loop has to end.
            self.bench.plays = self.bench.plays.max(before + 1);
        }
        Ok(index)
    }

    /// Adds legal shots in any direction.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn anything(&mut self, at: CuePlace<'_>, until: u64) -> Result<(), Error> {
        let first = self.targets.first.first().copied().unwrap_or_default();
        for speed in [2.5, 1.2, 5.0] {
            for k in 0..DIRECTIONS {
                let azimuth = TAU * f64::from(k) / f64::from(DIRECTIONS);
                if self.bench.plays < until {
                    self.try_hit(at, level_strike(speed, azimuth, 0.0), first)?;
                }
            }
        }
        if self.found.is_empty() {
            // No shot is legal: the foul that leaves the least.
            let strike = raised(at.prepared, level_strike(2.5, 0.0, 0.0));
            self.bench.sampler.simulate(at.prepared, &strike)?;
            self.bench.plays += 1;
            let call = call_of(self.task.turn, first, None);
            let (prior, _) = self.ruled(at.prepared, call)?;
            self.keep(at, FoundPlay { strike, call, kind: PlayKind::Safety, line: None, prior });
        }
        Ok(())
    }

    /// Adds push-outs: soft shots in all directions, after which the other player may pass the turn
    /// back.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn push_outs(&mut self, at: CuePlace<'_>, until: u64) -> Result<(), Error> {
        for speed in [0.6, 1.2, 2.0] {
            for k in 0..DIRECTIONS / 3 {
                let azimuth = TAU * f64::from(k) / f64::from(DIRECTIONS / 3);
                let strike = raised(at.prepared, level_strike(speed, azimuth, 0.0));
                let is_spent = self.bench.plays >= until;
                if is_spent || self.bench.sampler.simulate(at.prepared, &strike).is_err() {
                    continue;
                }
                self.bench.plays += 1;
                let (call, kind) = (Call::PushOut, PlayKind::PushOut);
                let (prior, is_legal) = self.ruled(at.prepared, call)?;
                if is_legal {
                    self.keep(at, FoundPlay { strike, call, kind, line: None, prior });
                }
            }
        }
        Ok(())
    }

    /// The azimuths that hit the balls on directly, with the balls.
    fn direct_hits(&self, scene: &Scene<'_>, cue: SceneBall) -> Vec<(f64, BallIndex)> {
        let mut azimuths = Vec::new();
        for hit in HITS {
            for ball in self.targets.first.iter().filter_map(|ball| scene.ball(*ball)) {
                azimuths.extend(hit_at(scene, cue, ball, hit).map(|azimuth| (azimuth, ball.index)));
            }
        }
        azimuths
    }

    /// The azimuths that lead the cue ball to the balls on off one or two cushions, by mirror
    /// images.
    fn kick_hits(&self, scene: &Scene<'_>, cue: SceneBall) -> Vec<(f64, BallIndex)> {
        let half = scene.half_area(cue.radius);
        let mut azimuths = Vec::new();
        let balls = self.targets.first.iter().filter_map(|ball| scene.ball(*ball));
        for ball in balls {
            for i in -2_i32..=2 {
                for j in -2_i32..=2 {
                    let bounces = i.abs() + j.abs();
                    if bounces == 0 || bounces > 2 {
                        continue;
                    }
                    let image = Vec2::new(
                        image_of(ball.center.x, i, half.x),
                        image_of(ball.center.y, j, half.y),
                    );
                    let way = image - cue.center;
                    let middle = atan2(way.y, way.x);
                    let reach = (ball.radius + cue.radius) / way.length();
                    for share in [0.0, -0.6, 0.6] {
                        azimuths.push((middle + share * asin(reach.min(1.0)), ball.index));
                    }
                }
            }
        }
        azimuths
    }

    /// Keeps a strike that is to hit `first`, if it is legal. A ball that falls is called where calls are made.
    fn try_hit(&mut self, at: CuePlace<'_>, strike: Strike, first: BallIndex) -> Result<(), Error> {
        let prepared = at.prepared;
        let strike = raised(prepared, strike);
        if self.bench.sampler.simulate(prepared, &strike).is_err() {
            return Ok(());
        }
        self.bench.plays += 1;
        let pot = self.potted();
        let call = call_of(self.task.turn, first, pot);
        let (value, is_legal) = self.ruled(prepared, call)?;
        if is_legal {
            let scores = self.keeps_turn();
            let prior = if scores { LUCK * value } else { value };
            let kind = if !scores {
                PlayKind::Safety
            } else if self.task.frame().facts().is_carom() {
                PlayKind::Carom
            } else {
                PlayKind::Indirect
            };
            let without_line = pot.filter(|_| self.measures_windows);
            match (kind, without_line) {
                (PlayKind::Indirect, Some(pot)) => {
                    let meant = MeantPot { pot, call, kind, line: None };
                    let error = self.direction_error(prepared);
                    self.center(at, strike, meant, error)?;
                }
                _ => self.keep(at, FoundPlay { strike, call, kind, line: None, prior }),
            }
        }
        Ok(())
    }
}

/// A strike with a level cue and no side. `speed` in m/s, `azimuth` in rad, `height` in ball radii.
const fn level_strike(speed: f64, azimuth: f64, height: f64) -> Strike {
    Strike { speed, azimuth, elevation: 0.0, side: 0.0, height }
}

/// The mirror image number `k` of the coordinate `x` between cushions at ±`half`.
fn image_of(x: f64, k: i32, half: f64) -> f64 {
    let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
    2.0 * half * f64::from(k) + sign * x
}

/// The azimuth that hits `ball` at `share` of its apparent half width; none if another ball is in
/// the way.
fn hit_at(scene: &Scene<'_>, cue: SceneBall, ball: SceneBall, share: f64) -> Option<f64> {
    let way = ball.center - cue.center;
    let distance = way.length();
    let reach = cue.radius + ball.radius;
    let middle = atan2(way.y, way.x);
    let angle = share * asin((reach / distance).min(1.0));
    let unit = way * (1.0 / distance);
    // The ghost ball of this hit: the line of centres is turned by the cut.
    let cut = asin((share * share.signum() * share.signum()).clamp(-1.0, 1.0));
    let (sin, cos) = carom::math::sin_cos(-cut);
    let line = unit * cos + unit.perp() * sin;
    let place = ghost(ball.center, line, reach);
    let except = [cue.index, ball.index];
    scene.is_clear(cue.center, place, cue.radius, &except).then_some(middle + angle)
}
