//! Candidates for the opening shot of a rack: breaks.

use carom::Error;
use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom_rules::{Region, Rules};

use super::candidate::PlayKind;
use super::explore::Explorer;
use crate::scene::Scene;
use crate::targets::call_of;
use carom_plan::Prepared;

/// Places of the cue ball across the region, as shares of its width, and depths behind its far
/// edge, as shares of the region's depth.
const ACROSS: [f64; 5] = [0.5, 0.3, 0.7, 0.08, 0.92];
const BEHIND: [f64; 2] = [0.04, 0.3];
/// Cue speeds, m/s, heights (ball radii), and hits of the first ball as shares of its width.
const SPEEDS: [f64; 3] = [8.0, 6.5, 9.5];
const HEIGHTS: [f64; 3] = [0.1, -0.1, 0.25];
const HITS: [f64; 3] = [0.0, 0.12, -0.12];

impl Explorer<'_> {
    /// Places of the cue ball for an opening shot, file frame, m.
    pub(crate) fn opening_places(&self, region: Region) -> Vec<[f64; 2]> {
        let table = self.situation.frame.base().table();
        let [low, high] = region.bounds(table);
        let mut places = Vec::new();
        for behind in BEHIND {
            for across in ACROSS {
                let x = low[0] + across * (high[0] - low[0]);
                let y = high[1] - behind * (high[1] - low[1]);
                let is_free = Prepared::new(self.situation.frame, Some([x, y])).is_ok();
                if region.holds(table, [x, y]) && is_free {
                    places.push([x, y]);
                }
            }
        }
        places
    }

    /// Whether the opening shot of this game spreads the balls.
    pub(crate) fn breaks_hard(&self) -> bool {
        matches!(
            self.situation.frame.rules(),
            Rules::EightBall | Rules::NineBall | Rules::TenBall | Rules::Practice
        )
    }

    /// Adds hard breaks from one place. All have the same prior: the race decides.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn breaks(&mut self, prepared: &Prepared<'_>, place: usize) -> Result<(), Error> {
        let scene = Scene::of(prepared);
        let Some(cue) = scene.ball(self.turn.cue) else { return Ok(()) };
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
                    let strike = Self::raised(prepared, strike);
                    if self.is_spent() || self.sampler.simulate(prepared, &strike).is_err() {
                        continue;
                    }
                    self.plays += 1;
                    let call = call_of(self.turn, head.index, None);
                    let (value, _) = self.ruled(prepared, call)?;
                    let kind = (PlayKind::Break, None, value);
                    self.keep(strike, call, kind, (place, prepared));
                }
            }
        }
        Ok(())
    }
}
