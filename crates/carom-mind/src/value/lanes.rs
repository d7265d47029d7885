//! The best pots of a position, by geometry.

use carom::Noise;
use carom_rules::{BallIndex, Frame, Turn};

use super::Position;
use crate::line::{Line, chance_within, direction_error, straight_to_pocket};
use crate::scene::{Scene, SceneBall};
use crate::targets::Targets;

/// Number of balls whose best pots are kept.
pub(crate) const KEPT: usize = 3;

/// The chances of the best direct pots of different balls, the best first; 0 where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lanes {
    /// The chances.
    pub chances: [f64; KEPT],
    /// The ball of the best one.
    pub best: Option<BallIndex>,
}

impl Lanes {
    /// The best pots of `turn`, with the cue ball where it lies; with the cue ball in hand, for each
    /// ball the best of the pockets from straight behind the ball.
    pub fn of(frame: &Frame, turn: &Turn, noise: &Noise) -> Self {
        if turn.hand.is_some() {
            return Self::in_hand(frame, turn, noise);
        }
        let scene = Scene::new(frame);
        let targets = Targets::of(frame, turn);
        let mut lanes = Self::default();
        let Some(cue) = scene.ball(turn.cue) else { return lanes };
        for object in targets.first.iter().filter_map(|ball| scene.ball(*ball)) {
            let chance = best_of(&scene, cue, object, noise);
            lanes.insert(object.index, chance);
        }
        lanes
    }

    /// The best pots with the cue ball in hand.
    fn in_hand(frame: &Frame, turn: &Turn, noise: &Noise) -> Self {
        let scene = Scene::new(frame);
        let targets = Targets::of(frame, turn);
        let mut lanes = Self::default();
        let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
        for object in targets.first.iter().filter_map(|ball| scene.ball(*ball)) {
            let mut best: f64 = 0.0;
            for pocket in 0..scene.table.pockets.len() {
                let Some(window) = scene.window(object.center, object.radius, pocket) else {
                    continue;
                };
                // Four radii behind the ball: near, but with room for the cue.
                let behind = object.center - window.way * (4.0 * object.radius);
                let half = scene.half_area(radius);
                if behind.x.abs() > half.x || behind.y.abs() > half.y {
                    continue;
                }
                let cue = SceneBall { index: turn.cue, center: behind, radius };
                if !scene.is_clear_place(behind, radius, &[turn.cue]) {
                    continue;
                }
                let line = straight_to_pocket(&scene, cue, object, pocket);
                best = best.max(line.map_or(0.0, |line| line.chance(noise, radius)));
            }
            lanes.insert(object.index, best);
        }
        lanes
    }

    fn insert(&mut self, ball: BallIndex, chance: f64) {
        let Some(place) = self.chances.iter().position(|kept| chance > *kept) else { return };
        if place == 0 {
            self.best = Some(ball);
        }
        self.chances[place..].rotate_right(1);
        self.chances[place] = chance;
    }
}

/// The chance of the best direct pot of `object`.
fn best_of(scene: &Scene<'_>, cue: SceneBall, object: SceneBall, noise: &Noise) -> f64 {
    let lines = (0..scene.table.pockets.len())
        .filter_map(|pocket| straight_to_pocket(scene, cue, object, pocket));
    lines.map(|line: Line| line.chance(noise, cue.radius)).fold(0.0, f64::max)
}

/// A pot of usual difficulty on a frame's table: the measure of a player's chances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Its chance.
    pub chance: f64,
}

impl Reference {
    /// Distances of the cue ball to the object ball and of that to the pocket, as shares of the
    /// table's width, and the cosine of the cut angle (35°). Estimated.
    const NEAR: f64 = 0.45;
    const FAR: f64 = 0.55;
    const FULLNESS: f64 = 0.82;

    /// The chances of the usual pot for the two seats.
    pub(crate) fn chances(position: &Position<'_>) -> [f64; 2] {
        position.noise.each_ref().map(|noise| Self::of(position.frame, noise).chance)
    }

    /// The usual pot of a player with these errors on the frame's table.
    pub fn of(frame: &Frame, noise: &Noise) -> Self {
        let scene = Scene::new(frame);
        let Some(pocket) = scene.table.pockets.first() else { return Self { chance: 0.3 } };
        let Some(ball) = frame.layout().balls().first() else { return Self { chance: 0.3 } };
        let (radius, width) = (ball.ball.radius, scene.table.size.x);
        let [a, b] = pocket.mouth;
        let from = (a + b) * 0.5 - pocket.axis * (Self::FAR * width);
        let half = scene.window(from, radius, 0).map_or(0.0, |window| window.half_width);
        let tolerance = usual_tolerance(half, radius, width);
        Self { chance: chance_within(tolerance, direction_error(noise, radius)) }
    }
}

/// Half of the width (rad) within which the cue ball's direction must lie for a usual pot into a window of
/// half the width `half` (rad). `radius` is a ball's and `width` the table's, m.
pub(super) fn usual_tolerance(half: f64, radius: f64, width: f64) -> f64 {
    half / (Reference::NEAR * width / (2.0 * radius * Reference::FULLNESS)).max(1.0)
}
