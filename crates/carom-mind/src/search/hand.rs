//! Places for a cue ball in hand.

use carom::math::{Vec2, sin_cos};
use carom_rules::Region;

use super::task::ShotTask;
use crate::line::straight_to_pocket;
use crate::scene::{Scene, SceneBall};
use crate::targets::Targets;

/// Distances behind the object ball, in ball radii, and cut angles (rad; 0, ±15°, ±30°, ±45°).
const BEHIND: [f64; 4] = [5.0, 9.0, 15.0, 24.0];
const CUTS: [f64; 7] = [0.0, 0.26, -0.26, 0.52, -0.52, 0.79, -0.79];
/// Number of places that are searched.
const MOST: usize = 10;
/// Places nearer to each other than this, m, count as one.
const APART: f64 = 0.12;

impl ShotTask<'_> {
    /// Places from which a ball on can be potted, the best first, and at least one place in the
    /// region. File coordinates, m.
    pub(crate) fn places(&self, region: Region) -> Vec<[f64; 2]> {
        let scene = Scene::new(self.frame());
        let (noise, radius) = (self.noise(), self.cue_radius());
        let targets = Targets::of(self.frame(), self.turn);
        let middle = scene.table.center();
        let mut rated: Vec<(f64, [f64; 2])> = Vec::new();
        let objects = targets.first.iter().filter_map(|ball| scene.ball(*ball));
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
                        if !self.may_stand(&scene, region, center, place) {
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
            places.extend(self.any_place(&scene, region));
        }
        places
    }

    /// Free places of the region on a grid, one near its middle first.
    fn any_place(&self, scene: &Scene<'_>, region: Region) -> Option<[f64; 2]> {
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
            self.may_stand(scene, region, center, *place)
        })
    }

    /// Whether the cue ball may be placed at `center` (engine's coordinates), which is `place` in
    /// the file's coordinates.
    fn may_stand(&self, scene: &Scene<'_>, region: Region, center: Vec2, place: [f64; 2]) -> bool {
        let radius = self.cue_radius();
        scene.table.place_check(center, radius).is_inside()
            && region.holds(scene.table, place)
            && scene.is_clear_place(center, radius, &[self.turn.cue])
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom::format::Node;
    use carom::resolve::cue_ball::Strike;
    use carom_plan::Prepared;
    use carom_rules::{Call, Frame, FrameSimulator, Game, Options, Play};

    use super::*;
    use crate::player::Situation;
    use crate::value::Markov;

    /// Seen: a player placed the cue ball over a corner pocket of `poolfiz`, and lost the frame.
    #[test]
    fn the_cue_ball_may_stand_only_where_the_table_lets_it() {
        let table = Some(Node::from("poolfiz"));
        let mut frame =
            Frame::new(Game::EightBall, Options::default(), table, None, 1).expect("a frame");
        let mut balls = vec![None; frame.layout().len()];
        (balls[0], balls[8]) = (Some([0.3, 1.8]), Some([0.5, 1.6]));
        frame.resume_at(&balls, 0).expect("a layout");
        // The cue ball touches nothing, so the other player has it in hand.
        let azimuth = core::f64::consts::PI;
        let strike = Strike { speed: 0.1, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
        let foul = Play { call: Call::Safety, ..Play::new(strike) };
        frame.play_in(&mut FrameSimulator::new(), &foul).expect("a shot");
        let situation = Situation::new(&frame, Noise::olympiad(1.0), 1);
        let value = Markov::default();
        let task = ShotTask::new(&situation, &value).expect("a shot");
        let region = task.turn.hand.expect("a ball in hand");
        let scene = Scene::new(&frame);
        let middle = scene.table.center();
        let mut count = 0;
        for k in 0..4000 {
            // Millimetres near the pocket at the bottom right.
            let place = [1.05 + 0.001 * f64::from(k % 60), 0.001 * f64::from(k / 60)];
            let center = Vec2::new(place[0], place[1]) - middle;
            if task.may_stand(&scene, region, center, place) {
                Prepared::new(&frame, Some(place)).expect("a place on the cloth");
                count += 1;
            }
        }
        assert!(count > 500, "{count} places");
    }
}
