//! Places for a cue ball in hand.

use carom::math::{Vec2, sin_cos};
use carom_rules::Region;

use super::explore::Explorer;
use crate::line::straight_to_pocket;
use crate::scene::{Scene, SceneBall};

/// Distances behind the object ball, in ball radii, and cut angles (rad; 0, ±15°, ±30°, ±45°).
const BEHIND: [f64; 4] = [5.0, 9.0, 15.0, 24.0];
const CUTS: [f64; 7] = [0.0, 0.26, -0.26, 0.52, -0.52, 0.79, -0.79];
/// Number of places that are searched.
const MOST: usize = 10;
/// Places nearer to each other than this, m, count as one.
const APART: f64 = 0.12;

impl Explorer<'_> {
    /// Places from which a ball on can be potted, the best first, and at least one place in the
    /// region. File frame, m.
    pub(crate) fn places(&self, region: Region) -> Vec<[f64; 2]> {
        let frame = self.situation.frame;
        let scene = Scene::new(frame);
        let noise = &self.situation.noise[self.seat()];
        let radius = frame.layout().balls()[usize::from(self.turn.cue)].ball.radius;
        let middle = scene.table.center();
        let mut rated: Vec<(f64, [f64; 2])> = Vec::new();
        let objects = self.targets.first.iter().filter_map(|ball| scene.ball(*ball));
        for object in objects {
            for pocket in 0..scene.table.pockets.len() {
                let Some(window) = scene.window(object.center, object.radius, pocket) else {
                    continue;
                };
                for distance in BEHIND {
                    for cut in CUTS {
                        let (sin, cos) = sin_cos(cut);
                        let way = window.way * cos + window.way.perp() * sin;
                        let center = object.center - way * (distance * object.radius);
                        let place = [center.x + middle.x, center.y + middle.y];
                        if !self.may_stand(&scene, region, (center, place), radius) {
                            continue;
                        }
                        let cue = SceneBall { index: self.turn.cue, center, radius };
                        let line = straight_to_pocket(&scene, cue, object, pocket);
                        if let Some(line) = line {
                            rated.push((line.chance(noise, radius), place));
                        }
                    }
                }
            }
        }
        rated.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut places: Vec<[f64; 2]> = Vec::new();
        for (_, place) in rated {
            let near = |other: &[f64; 2]| {
                Vec2::new(other[0] - place[0], other[1] - place[1]).length() < APART
            };
            if !places.iter().any(near) {
                places.push(place);
            }
            if places.len() == MOST {
                break;
            }
        }
        if places.is_empty() {
            places.extend(self.any_place(&scene, region, radius));
        }
        places
    }

    /// Free places of the region on a grid, one near its middle first.
    fn any_place(&self, scene: &Scene<'_>, region: Region, radius: f64) -> Option<[f64; 2]> {
        const STEPS: i32 = 24;
        let [low, high] = region.bounds(scene.table);
        let middle = scene.table.center();
        let at = |k: i32, axis: usize| {
            let share = f64::from(k) / f64::from(STEPS);
            low[axis] + share * (high[axis] - low[axis])
        };
        let mut grid: Vec<(i32, i32)> =
            (0..=STEPS).flat_map(|i| (0..=STEPS).map(move |j| (i, j))).collect();
        grid.sort_by_key(|(i, j)| (2 * i - STEPS).abs() + (2 * j - STEPS).abs());
        grid.into_iter().map(|(i, j)| [at(i, 0), at(j, 1)]).find(|place| {
            let center = Vec2::new(place[0], place[1]) - middle;
            self.may_stand(scene, region, (center, *place), radius)
        })
    }

    /// Whether the cue ball may be placed at `center` (engine's frame), which is `place` in the
    /// file's frame.
    fn may_stand(
        &self,
        scene: &Scene<'_>,
        region: Region,
        (center, place): (Vec2, [f64; 2]),
        radius: f64,
    ) -> bool {
        let half = scene.half_area(radius);
        center.x.abs() < half.x
            && center.y.abs() < half.y
            && region.holds(scene.table, place)
            && scene.is_clear(center, center + Vec2::new(1e-6, 0.0), radius, &[self.turn.cue])
    }
}
