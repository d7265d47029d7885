//! Contact of a ball on the cloth with one part of a cushion.
//!
//! A sphere touches the nose line, at height h, when the horizontal distance of its centre from the
//! line is the reach δ = √(R² − (h − R)²) ([`Table::reach`]). So the centre meets a straight part
//! that is shifted by δ along its normal, and a round part whose radius r is increased to r + δ.
//! Parts that join tangentially still do so when they are shifted.
//!
//! Where two parts join, a rounding error must not open a gap, and the point at the end of a nose
//! must not stop a ball that rolls along the nose. So straight parts are lengthened by
//! [`JOIN_OVERLAP`], and round parts are not. A ball that enters the span of a part from the side
//! also meets the part.
//!
//! [`Table::reach`]: crate::table::TableGeometry::reach

use carom_roots::{Motion, first_contact, first_crossing};

use crate::math::Vec2;
use crate::table::{JOIN_OVERLAP, Shape, arc_sides};

/// First time in [0, `horizon`] (s) at which a ball of `reach` δ (m) on `path` touches `shape`
/// while approaching it.
pub fn first_touch(shape: &Shape, reach: f64, path: &Motion<2>, horizon: f64) -> Option<f64> {
    match *shape {
        Shape::Segment { start, end, normal } => {
            let line = StraightPart { start, end, normal, reach };
            line.first_touch(path, horizon)
        }
        Shape::Arc { center, radius, start, end } => {
            let arc = RoundPart { center, start, end, distance: radius + reach };
            arc.first_touch(path, horizon)
        }
        // A liner is behind the hole; a rail's top is above the ball.
        Shape::Hollow { .. } | Shape::Plane { .. } => None,
    }
}

struct StraightPart {
    start: Vec2,
    end: Vec2,
    normal: Vec2,
    reach: f64,
}

impl StraightPart {
    fn first_touch(&self, path: &Motion<2>, horizon: f64) -> Option<f64> {
        let from_start = Vec2::new(path.d[0], path.d[1]) - self.start;
        let velocity = Vec2::new(path.v[0], path.v[1]);
        let half_acceleration = Vec2::new(path.h[0], path.h[1]);
        // The gap, as c₀ + c₁t + c₂t².
        let c0 = self.normal.dot(from_start) - self.reach;
        let c1 = self.normal.dot(velocity);
        let c2 = self.normal.dot(half_acceleration);
        let t = first_crossing(c0, c1, c2, horizon)?;

        let tangent = self.normal.perp();
        let length = tangent.dot(self.end - self.start);
        let low = length.min(0.0) - JOIN_OVERLAP;
        let high = length.max(0.0) + JOIN_OVERLAP;
        let s0 = tangent.dot(from_start);
        let s1 = tangent.dot(velocity);
        let s2 = tangent.dot(half_acceleration);
        let s = s0 + t * (s1 + t * s2);
        if s >= low && s <= high {
            return Some(t);
        }
        // The ball enters the span from the side, after passing a neighbour by a rounding error. A
        // ball whose centre is behind the nose line is somewhere else on the table, not at this
        // part.
        let rate = s1 + 2.0 * (t * s2);
        let entry = if s < low {
            first_crossing(low - s, -rate, -s2, horizon - t)?
        } else {
            first_crossing(s - high, rate, s2, horizon - t)?
        };
        let t = t + entry;
        let gap = c0 + t * (c1 + t * c2);
        let approaching = c1 + 2.0 * (t * c2) < 0.0;
        (approaching && gap <= 0.0 && gap >= -self.reach).then_some(t)
    }
}

struct RoundPart {
    center: Vec2,
    start: Vec2,
    end: Vec2,
    /// The part's radius plus the reach, m.
    distance: f64,
}

impl RoundPart {
    fn first_touch(&self, path: &Motion<2>, horizon: f64) -> Option<f64> {
        let mut rest = *path;
        rest.d = [path.d[0] - self.center.x, path.d[1] - self.center.y];
        let t = first_contact(&rest, self.distance, horizon)?;
        if self.spans(rest.at(t), 0.0) { Some(t) } else { self.later_touch(&rest, t, horizon) }
    }

    /// Whether the direction `p` (from the centre) is between the two ends, or outside by at most
    /// `slack` (m).
    fn spans(&self, p: [f64; 2], slack: f64) -> bool {
        self.sides().iter().all(|side| side.dot(Vec2::new(p[0], p[1])) >= -slack)
    }

    fn sides(&self) -> [Vec2; 2] {
        arc_sides(self.start, self.end)
    }

    /// The contact of a ball that touches the full circle outside the span at `t`: when it enters
    /// the span, or later.
    fn later_touch(&self, rest: &Motion<2>, t: f64, horizon: f64) -> Option<f64> {
        let mut t = t;
        // A quadratic path enters a half-plane at most once.
        for _ in self.sides() {
            t = self.next_entry(rest, t, horizon)?;
            let moved = Motion { d: rest.at(t), v: rest.velocity_at(t), h: rest.h };
            t += first_contact(&moved, self.distance, horizon - t)?;
            if self.spans(rest.at(t), JOIN_OVERLAP) {
                return Some(t);
            }
        }
        None
    }

    /// The first time after `t` at which the ball enters one of the half-planes of [`Self::sides`].
    fn next_entry(&self, rest: &Motion<2>, t: f64, horizon: f64) -> Option<f64> {
        let mut next: Option<f64> = None;
        for side in self.sides() {
            let c = |p: [f64; 2]| -side.dot(Vec2::new(p[0], p[1]));
            let (c0, c1, c2) = (c(rest.at(t)), c(rest.velocity_at(t)), c(rest.h));
            // A ball inside the half-plane does not enter it.
            if c0 > 0.0
                && let Some(entry) = first_crossing(c0, c1, c2, horizon - t)
            {
                next = Some(next.map_or(t + entry, |n: f64| n.min(t + entry)));
            }
        }
        next
    }
}
