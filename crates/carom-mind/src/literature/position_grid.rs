//! PoolMaster's grid of targets: how good each place of the cue ball is for the next shot.
//!
//! Landry & Dussault, *AI optimization of a billiard player*, J. Intell. Robot. Syst. 50, 2007,
//! lay 50 × 100 points over the table. **Guess:** a point's quality is the probability of the best
//! direct shot from there, averaged with the eight points around it, so that a good point needs
//! good neighbours.

use carom::math::Vec2;
use carom_rules::Frame;

use super::shots::Sight;
use crate::scene::{Scene, SceneBall, ghost, towards};

/// Points across the width and along the length (Landry & Dussault 2007).
pub(crate) const POINTS: [usize; 2] = [50, 100];
/// Cosine of the largest cut angle of a shot: 82°, as for all lines.
const THINNEST: f64 = 0.139;

/// The quality of each place of the cue ball, 0 to 1.
#[derive(Clone, Debug)]
pub(crate) struct PositionGrid {
    /// Half of the area in which the cue ball's centre can lie, m.
    half: Vec2,
    values: Vec<f64>,
}

/// A way of a ball into a pocket that no other ball blocks.
struct Lane {
    object: SceneBall,
    way: Vec2,
    half_width: f64,
}

impl PositionGrid {
    /// The grid for the next shot of `frame`, which `sight` looks at. The cue ball is taken away.
    pub(crate) fn new(frame: &Frame, sight: &Sight<'_>) -> Self {
        let scene = Scene::new(frame);
        let half = scene.half_area(sight.radius);
        let lanes = lanes(&scene, sight);
        let grid = Self { half, values: Vec::new() };
        let [across, along] = POINTS;
        let points = (0..along).flat_map(|j| (0..across).map(move |i| [i, j]));
        let raw: Vec<f64> =
            points.map(|cell| quality(&scene, sight, &lanes, grid.center(cell))).collect();
        let smooth = (0..along).flat_map(|j| (0..across).map(move |i| [i, j]));
        let values = smooth.map(|cell| mean_around(&raw, cell)).collect();
        Self { values, ..grid }
    }

    /// The quality of a cue ball at `place`, m, engine's coordinates: that of the point next to it.
    pub(crate) fn at(&self, place: Vec2) -> f64 {
        let index = |x: f64, half: f64, count: usize| {
            let share = (0.5 * (x / half + 1.0)).clamp(0.0, 1.0);
            ((share * count as f64) as usize).min(count - 1)
        };
        let i = index(place.x, self.half.x, POINTS[0]);
        let j = index(place.y, self.half.y, POINTS[1]);
        self.values[j * POINTS[0] + i]
    }

    /// The best points, the best first, each at least `apart` (m) from the better ones.
    pub(crate) fn best(&self, count: usize, apart: f64) -> Vec<(Vec2, f64)> {
        let mut order: Vec<usize> = (0..self.values.len()).collect();
        order.sort_by(|a, b| self.values[*b].total_cmp(&self.values[*a]));
        let mut best: Vec<(Vec2, f64)> = Vec::new();
        for k in order {
            let place = self.center([k % POINTS[0], k / POINTS[0]]);
            let is_near = |(other, _): &(Vec2, f64)| (*other - place).length() < apart;
            if best.len() == count || self.values[k] <= 0.0 {
                break;
            }
            if !best.iter().any(is_near) {
                best.push((place, self.values[k]));
            }
        }
        best
    }

    /// The centre of a cell, m, engine's coordinates.
    fn center(&self, [i, j]: [usize; 2]) -> Vec2 {
        let at = |k: usize, count: usize| (2 * k + 1) as f64 / count as f64 - 1.0;
        Vec2::new(self.half.x * at(i, POINTS[0]), self.half.y * at(j, POINTS[1]))
    }
}

/// The mean of a point and those around it.
fn mean_around(values: &[f64], [i, j]: [usize; 2]) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for y in j.saturating_sub(1)..=(j + 1).min(POINTS[1] - 1) {
        for x in i.saturating_sub(1)..=(i + 1).min(POINTS[0] - 1) {
            sum += values[y * POINTS[0] + x];
            count += 1.0;
        }
    }
    sum / count
}

/// The open ways of the balls on into the pockets.
fn lanes(scene: &Scene<'_>, sight: &Sight<'_>) -> Vec<Lane> {
    let balls = sight.targets.first.iter().filter_map(|ball| scene.ball(*ball));
    let mut lanes = Vec::new();
    for object in balls {
        for pocket in 0..scene.table.pockets.len() {
            let Some(window) = scene.window(object.center, object.radius, pocket) else { continue };
            let target = object.center + window.way * window.distance;
            let except = [sight.turn.cue, object.index];
            if scene.is_clear(object.center, target, object.radius, &except) {
                lanes.push(Lane { object, way: window.way, half_width: window.half_width });
            }
        }
    }
    lanes
}

/// The probability of the best direct shot with the cue ball at `place`; 0 on another ball.
fn quality(scene: &Scene<'_>, sight: &Sight<'_>, lanes: &[Lane], place: Vec2) -> f64 {
    let cue = sight.turn.cue;
    if !scene.is_clear_place(place, sight.radius, &[cue]) {
        return 0.0;
    }
    let mut best: f64 = 0.0;
    for lane in lanes {
        let reach = sight.radius + lane.object.radius;
        let target = ghost(lane.object.center, lane.way, reach);
        let Some((way, distance)) = towards(place, target) else { continue };
        let fullness = way.dot(lane.way);
        if fullness <= THINNEST {
            continue;
        }
        let turn = (distance / (reach * fullness)).max(1.0);
        let chance = sight.table.of_direction(lane.half_width / turn, fullness, sight.radius);
        let except = [cue, lane.object.index];
        if chance > best && scene.is_clear(place, target, sight.radius, &except) {
            best = chance;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::{PositionGrid, Sight};
    use crate::literature::pot_table::PotTable;
    use carom::Noise;
    use carom::math::Vec2;
    use carom_rules::{Frame, Game, Options};
    use std::sync::Arc;

    #[test]
    fn places_behind_the_ball_are_good_and_one_on_the_ball_is_worthless() {
        let mut frame =
            Frame::new(Game::NineBall, Options::default(), None, None, 1).expect("a frame");
        let mut places = vec![None; frame.layout().len()];
        // The 1 near the top left pocket; the 9 far away.
        places[0] = Some([0.9, 0.3]);
        places[1] = Some([0.2, 2.34]);
        places[9] = Some([1.1, 0.2]);
        frame.resume_at(&places, 0).expect("a layout");
        let noise = Noise::olympiad(1.0);
        let turn = frame.turn().expect("a shot");
        let sight = Sight::new(&frame, turn, Arc::new(PotTable::geometric(noise.clone())), noise);
        let grid = PositionGrid::new(&frame, &sight);
        let middle = frame.base().table().center();
        let at = |x: f64, y: f64| grid.at(Vec2::new(x, y) - middle);
        assert!(at(0.45, 2.09) > 0.95, "{}", at(0.45, 2.09));
        assert!(at(0.2, 2.34) < 1e-12, "{}", at(0.2, 2.34));
        // From the bottom right corner the 1 is far away, and the 9 is in the way.
        assert!(at(1.22, 0.05) < at(0.45, 2.09) - 0.2, "{}", at(1.22, 0.05));
        let best = grid.best(3, 0.3);
        assert_eq!(best.len(), 3);
        assert!(best[0].1 >= best[1].1 && (best[0].0 - best[1].0).length() >= 0.3);
    }
}
