//! A ball's path as a polyline, for pictures.

use alloc::vec::Vec;

use super::{Piece, Trace};
use crate::math::{Vec3, ceil, sqrt};
use crate::motion::Path;

/// A point of a ball's path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waypoint {
    /// The ball's centre in the file's coordinates, m.
    pub position: Vec3,
    /// Time since the strike, s.
    pub time: f64,
}

/// Largest number of chords of one curve, for any tolerance: a picture shows no more.
const MOST_CHORDS: f64 = 4096.0;

impl Trace {
    /// The path of ball `ball` (an index into the shot's balls) as points on the exact path. There
    /// is one at every event of the ball, and enough in between that the path is nowhere further
    /// than `tolerance` (m, greater than 0) from the polyline, but at most 4096 chords between two
    /// events. The polyline starts at time 0. It ends with the ball's last event, or with the shot
    /// for a ball that never rests. A ball that falls into a pocket has two points at that time:
    /// the place where it fell, and the place below the hole where it lies.
    pub fn polyline(&self, ball: usize, tolerance: f64) -> Vec<Waypoint> {
        let mut points: Vec<Waypoint> = Vec::new();
        for piece in self.pieces(ball) {
            let start = Waypoint { position: piece.state.position, time: piece.start };
            // The next piece begins where the last ended, up to rounding, except in a pocket.
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

/// Adds points after the start of `piece` up to the time `end` (s).
///
/// Between the times t₀ and t₁ the path r₀ + vt + ht² is |h × v|/|c|·(t − t₀)(t₁ − t) from its
/// chord, where c = v + h(t₀ + t₁) is the mean velocity. That is at most |h × v|/|c|·Δt²/4, and at
/// most |h|·Δt²/4 at any speed. It is also the distance from the segment, unless the ball turns
/// back; therefore the instant of least speed is a point as well. Perpendicular to h the velocity
/// is constant, |h × v|/|h|. If it moves the ball by no more than the tolerance, as on a straight
/// path, one chord is enough.
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

/// The instant of least speed on `path`, s after its start, if it is after the start.
fn slowest(path: &Path) -> Option<f64> {
    let h = path.half_acceleration;
    let time = -0.5 * path.velocity.dot(h) / h.length_squared();
    (time > 0.0).then_some(time)
}
