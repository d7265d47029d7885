//! Balls that are frozen to a rail at the start, and whether they have left it.

use alloc::vec::Vec;

use super::VISIBLE_GAP;
use crate::math::Vec2;
use crate::motion::Path;
use crate::shot::Shot;
use crate::table::{CushionPart, Rail, Shape, TOUCH_TOLERANCE, arc_sides};

/// A ball that touches a cushion at the start.
#[derive(Clone, Debug)]
pub(super) struct Frozen {
    pub(super) ball: u16,
    rail: Rail,
    /// Unit vector from the cushion to the ball.
    away: Vec2,
    /// Coordinate of the ball along `away` at the start, m.
    start: f64,
    /// Whether the ball has been further than [`VISIBLE_GAP`] from the rail.
    left: bool,
}

impl Frozen {
    /// Writes the frozen balls of `shot` into `frozen`, once for each rail that they touch.
    pub(super) fn find(shot: &Shot, frozen: &mut Vec<Self>) {
        let table = shot.table();
        frozen.clear();
        for (ball, placed) in (0u16..).zip(shot.balls()) {
            let position = table.to_engine_coordinates(&placed.state).position;
            let above = position.z - table.cushion_height;
            let radius = placed.ball.radius;
            let reach = radius + TOUCH_TOLERANCE;
            // No cushion lies inside the nose lines.
            let inner = table.index.half - Vec2::new(reach, reach);
            if position.x.abs() < inner.x && position.y.abs() < inner.y {
                continue;
            }
            for cushion in &table.cushions {
                let Some((away, distance)) = across(cushion, position.xy(), reach) else {
                    continue;
                };
                let gap = crate::math::sqrt(distance * distance + above * above) - radius;
                if gap.abs() <= TOUCH_TOLERANCE {
                    let start = away.dot(placed.state.position.xy());
                    frozen.push(Self { ball, rail: cushion.rail, away, start, left: false });
                }
            }
        }
    }

    /// Whether the path of `ball` decides if this ball has left its rail.
    pub(super) fn waits_for(&self, ball: u16) -> bool {
        self.ball == ball && !self.left
    }

    /// Whether `ball` is still frozen to `rail`.
    pub(super) fn is_at(&self, ball: u16, rail: Rail) -> bool {
        !self.left && self.ball == ball && self.rail == rail
    }

    /// Follows the ball for `duration` (s) along `path`.
    pub(super) fn follow(&mut self, path: &Path, duration: f64) {
        let speed = self.away.dot(path.velocity.xy());
        let half_acceleration = self.away.dot(path.half_acceleration.xy());
        let turning = if half_acceleration < 0.0 { -0.5 * speed / half_acceleration } else { 0.0 };
        for t in [turning.clamp(0.0, duration), duration] {
            let gap = self.away.dot(path.position_at(t).xy()) - self.start;
            self.left |= gap > VISIBLE_GAP;
        }
    }
}

/// Unit vector and distance (m) from the nearest point of `cushion` to `position`, if that point is
/// not an end of the cushion and at most `reach` (m) away.
fn across(cushion: &CushionPart, position: Vec2, reach: f64) -> Option<(Vec2, f64)> {
    match cushion.shape {
        Shape::Segment { start, end, normal } => {
            let from_start = position - start;
            let distance = normal.dot(from_start);
            if distance > reach {
                return None;
            }
            let along = end - start;
            let s = along.dot(from_start);
            (s >= 0.0 && s <= along.length_squared()).then_some((normal, distance))
        }
        Shape::Arc { center, radius, start, end } => {
            let p = position - center;
            let length = p.length();
            if length > radius + reach || length == 0.0 {
                return None;
            }
            let beside = arc_sides(start, end).iter().all(|side| side.dot(p) >= 0.0);
            beside.then(|| (p * (1.0 / length), length - radius))
        }
        Shape::Hollow { .. } | Shape::Plane { .. } => None,
    }
}
