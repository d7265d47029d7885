//! A ball's way as a line of points, for pictures.

use alloc::vec::Vec;

use super::{Piece, Trace};
use crate::math::{Vec3, ceil, sqrt};
use crate::motion::Path;

/// A point of a ball's way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waypoint {
    /// The ball's centre in the file's frame, m.
    pub position: Vec3,
    /// Time since the strike, s.
    pub time: f64,
}

/// No path is cut into more chords, however small the tolerance: no picture shows more.
const MOST_CHORDS: f64 = 4096.0;

impl Trace {
    /// The way of ball `ball` (an index into the shot's balls): points on its exact path, one at every
    /// event of the ball, and so many between that the path is nowhere further than `tolerance` (m,
    /// greater than 0) from the line through them. It starts at time 0 and ends with the ball's last
    /// event, or with the shot for a ball that never rests. Where a ball falls into a pocket there are
    /// two points at one time: where it fell, and where it lies below the hole.
    pub fn polyline(&self, ball: usize, tolerance: f64) -> Vec<Waypoint> {
        let mut points: Vec<Waypoint> = Vec::new();
        for piece in self.pieces(ball) {
            let start = Waypoint { position: piece.state.position, time: piece.start };
            // Where a piece ends the next begins, but for rounding, or in a pocket.
            points.pop_if(|last| {
                last.time == start.time && (last.position - start.position).length() <= tolerance
            });
            points.push(start);
            let end = piece.end.min(self.duration);
            if piece.path.moves() && end > start.time {
                follow(&mut points, &piece, end, tolerance);
            }
        }
        points
    }
}

/// Adds points from the start of `piece`, without it, to the time `end`.
///
/// Between the times t₀ and t₁ the path r₀ + vt + ht² is |h × v|/|c|·(t − t₀)(t₁ − t) from its chord,
/// c = v + h(t₀ + t₁) being the mean velocity; at most |h × v|/c·Δt²/4, and at most |h|·Δt²/4 however
/// slow the ball. That is its distance from the segment too unless the ball turns back, so the instant
/// of least speed is a point as well. Across h the ball moves evenly, with |h × v|/|h|: where that leads
/// it no further than the tolerance, as when it rolls out straight, one chord will do.
fn follow(points: &mut Vec<Waypoint>, piece: &Piece, end: f64, tolerance: f64) {
    let path = &piece.path;
    let length = end - piece.start;
    let slowest = slowest(path);
    let curve = path.half_acceleration.length();
    let bend = path.half_acceleration.cross(path.velocity).length();
    let cuts = [slowest.filter(|t| piece.start + t < end), Some(length)];
    let mut from = 0.0;
    for to in cuts.into_iter().flatten() {
        let nearest = slowest.map_or(0.0, |t| t.clamp(from, to));
        let speed = path.velocity_at(nearest).length();
        let chords = if bend * (to - from) > tolerance * curve {
            let longest = 2.0 * sqrt(tolerance * (speed / bend).max(1.0 / curve));
            ceil((to - from) / longest).clamp(1.0, MOST_CHORDS)
        } else {
            1.0
        };
        let mut k = 1.0;
        while k < chords {
            let t = from + (to - from) * (k / chords);
            points.push(Waypoint { position: path.position_at(t), time: piece.start + t });
            k += 1.0;
        }
        let time = if to == length { end } else { piece.start + to };
        points.push(Waypoint { position: path.position_at(to.min(path.duration)), time });
        from = to;
    }
}

/// When on `path` the speed is least, s after its start, if that is later.
fn slowest(path: &Path) -> Option<f64> {
    let h = path.half_acceleration;
    let time = -0.5 * path.velocity.dot(h) / h.length_squared();
    (time > 0.0).then_some(time)
}
