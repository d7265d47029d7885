//! Contact of a flying ball with an edge of a rail, or with a liner's wall.
//!
//! In plan view a flying ball moves uniformly on a straight line. So it is within the span of a
//! straight or round part during one interval of time, between two linear crossings. Within this
//! interval the part can be replaced by one without ends: a straight edge by a line (the quartic of
//! Leckie & Greenspan 2006, section 5, in the plane across the line), a point by a full circle
//! ([`carom_roots::first_ring_contact`], degree 8).

use carom_roots::{Motion, first_contact, first_crossing, first_ring_contact};

use crate::math::Vec2;
use crate::table::{JOIN_OVERLAP, Shape, UNDER_EDGE, arc_sides};

/// First time in [0, `last`] (s) at which a ball of `radius` (m) on the flight `path` touches
/// `shape` while approaching it. The edge is at `height` (m); `last` is finite. A rail's top has no
/// edge of its own.
pub(super) fn first_touch(
    shape: &Shape,
    height: f64,
    radius: f64,
    path: &Motion<3>,
    last: f64,
) -> Option<f64> {
    match *shape {
        Shape::Segment { start, end, normal } => {
            let line = StraightEdge { start, end, normal };
            line.first_touch(height, radius, path, last)
        }
        Shape::Arc { center, radius: ring, start, end } => {
            let round = RoundEdge { ring, start, end, path: relative(path, center, height) };
            round.first_touch_outside(radius, last)
        }
        Shape::Hollow { center, radius: ring, start, end } => {
            let round = RoundEdge { ring, start, end, path: relative(path, center, height) };
            round.first_touch_inside(radius, last)
        }
        Shape::Plane { .. } => None,
    }
}

/// `path` relative to `center` at `height`.
pub(super) fn relative(path: &Motion<3>, center: Vec2, height: f64) -> Motion<3> {
    let [x, y, z] = path.d;
    Motion { d: [x - center.x, y - center.y, z - height], ..*path }
}

/// The earlier of two times, if there is one.
pub(super) fn earlier(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b < a { b } else { a }),
        (a, b) => a.or(b),
    }
}

/// The same motion with time counted from `t`.
fn later<const N: usize>(path: &Motion<N>, t: f64) -> Motion<N> {
    if t == 0.0 { *path } else { Motion { d: path.at(t), v: path.velocity_at(t), h: path.h } }
}

/// [`first_contact`] within `span`.
fn contact_within<const N: usize>(path: &Motion<N>, distance: f64, span: Interval) -> Option<f64> {
    first_contact(&later(path, span.from), distance, span.to - span.from).map(|t| span.from + t)
}

/// An interval of time, s.
#[derive(Clone, Copy)]
struct Interval {
    from: f64,
    to: f64,
}

impl Interval {
    /// The part of the interval in which c₀ + c₁t ≥ 0.
    fn where_positive(self, c0: f64, c1: f64) -> Option<Self> {
        let Self { from, to } = self;
        let span = if c1 == 0.0 {
            (c0 >= 0.0).then_some(self)?
        } else {
            let t = -c0 / c1;
            if c1 > 0.0 {
                Self { from: if t > from { t } else { from }, to }
            } else {
                Self { from, to: if t < to { t } else { to } }
            }
        };
        (span.from <= span.to).then_some(span)
    }
}

/// The contact in [`from`, `last`] with a wall that reaches up to `top` (m). `crossing` finds the
/// contact with an infinitely high wall from a given time on. A ball that passes above the wall may
/// still meet it on the way down.
pub(super) fn below(
    path: &Motion<3>,
    top: f64,
    [from, last]: [f64; 2],
    crossing: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    let (c0, c1, c2) = (path.d[2] - top, path.v[2], path.h[2]);
    let low = |t: f64| c0 + t * (c1 + t * c2) <= 0.0;
    // A flight is lowest at one of its ends.
    if !low(from) && !low(last) {
        return None;
    }
    let t = crossing(from)?;
    if low(t) {
        return Some(t);
    }
    let descent = first_crossing(c0, c1, c2, last)?;
    if descent > from { crossing(descent) } else { None }
}

/// Whether a flight provably stays below z = 0 in [`from`, `last`]: its Bernstein coefficients do.
pub(super) fn keeps_below(path: &Motion<3>, [from, last]: [f64; 2]) -> bool {
    let z = |t: f64| path.d[2] + t * (path.v[2] + t * path.h[2]);
    let rise = 0.5 * (last - from) * (path.v[2] + 2.0 * (from * path.h[2]));
    z(from) <= 0.0 && z(from) + rise <= 0.0 && z(last) <= 0.0
}

struct StraightEdge {
    start: Vec2,
    end: Vec2,
    normal: Vec2,
}

impl StraightEdge {
    fn first_touch(&self, height: f64, radius: f64, path: &Motion<3>, last: f64) -> Option<f64> {
        let from_start = Vec2::new(path.d[0], path.d[1]) - self.start;
        let velocity = Vec2::new(path.v[0], path.v[1]);
        // The direction is chosen so that exchanging the part's ends changes no bit.
        let tangent = self.normal.perp();
        let forwards = tangent.dot(self.end - self.start) > 0.0;
        let tangent = if forwards { tangent } else { -tangent };
        let rate = tangent.dot(velocity);
        let to_end = self.end - Vec2::new(path.d[0], path.d[1]);
        let span = Interval { from: 0.0, to: last }
            .where_positive(tangent.dot(from_start) + JOIN_OVERLAP, rate)?
            .where_positive(tangent.dot(to_end) + JOIN_OVERLAP, -rate)?;
        // In the plane across the edge: the distance in front of it and the height above it.
        let across = Motion {
            d: [self.normal.dot(from_start), path.d[2] - height],
            v: [self.normal.dot(velocity), path.v[2]],
            h: [0.0, path.h[2]],
        };
        let edge = contact_within(&across, radius, span);
        let under = below(path, height - radius - UNDER_EDGE, [span.from, span.to], |from| {
            let at = later(&across, from);
            // A ball whose centre is far behind the line is somewhere else on the table, not at
            // this part.
            let t = first_crossing(at.d[0], at.v[0], 0.0, span.to - from)?;
            (at.d[0] >= -radius).then_some(from + t)
        });
        earlier(edge, under)
    }
}

struct RoundEdge {
    ring: f64,
    start: Vec2,
    end: Vec2,
    /// The path relative to the ring's centre.
    path: Motion<3>,
}

impl RoundEdge {
    /// Contact with a point: an edge that is convex towards the ball.
    fn first_touch_outside(&self, radius: f64, last: f64) -> Option<f64> {
        let span = self.span(last)?;
        if self.ring == 0.0 {
            return contact_within(&self.path, radius, span);
        }
        let edge = first_ring_contact(&self.path, self.ring, radius, span.from, span.to);
        let plan = self.plan();
        let under = below(&self.path, -radius - UNDER_EDGE, [span.from, span.to], |from| {
            contact_within(&plan, self.ring, Interval { from, ..span })
        });
        earlier(edge, under)
    }

    /// Contact with a liner's wall from inside: with the wall up to its rim, with the rim, or with
    /// the upright end of the wall.
    fn first_touch_inside(&self, radius: f64, last: f64) -> Option<f64> {
        let plan = self.plan();
        let end = Vec2::new(plan.d[0], plan.d[1]) - self.start * self.ring;
        let from_end = Motion { d: [end.x, end.y], ..plan };
        let post = below(&self.path, 0.0, [0.0, last], |from| {
            contact_within(&from_end, radius, Interval { from, to: last })
        });
        let Some(span) = self.span(last) else { return post };
        let wall = below(&self.path, 0.0, [span.from, span.to], |from| {
            first_touch_of_hole(&plan, self.ring - radius, from, span.to)
        });
        // Below the rim a ball touches the wall first.
        let rim = if keeps_below(&self.path, [span.from, span.to]) {
            None
        } else {
            first_ring_contact(&self.path, self.ring, radius, span.from, span.to)
        };
        earlier(earlier(wall, rim), post)
    }

    fn plan(&self) -> Motion<2> {
        plan(&self.path)
    }

    /// The interval in which the ball is between the directions of the part's ends.
    fn span(&self, last: f64) -> Option<Interval> {
        let (p, v) = (self.path.d, self.path.v);
        let (p, v) = (Vec2::new(p[0], p[1]), Vec2::new(v[0], v[1]));
        let [a, b] = arc_sides(self.start, self.end);
        Interval { from: 0.0, to: last }
            .where_positive(a.dot(p), a.dot(v))?
            .where_positive(b.dot(p), b.dot(v))
    }
}

/// `path` seen from above.
pub(super) fn plan(path: &Motion<3>) -> Motion<2> {
    let first = |[x, y, _]: [f64; 3]| [x, y];
    Motion { d: first(path.d), v: first(path.v), h: first(path.h) }
}

/// First time in [`from`, `last`] (s) at which a centre on the uniform motion `plan` moves outwards
/// at a distance of `room` (m) or more from the origin: the contact of a ball inside an upright
/// cylinder that leaves its centre this much room.
pub(super) fn first_touch_of_hole(
    plan: &Motion<2>,
    room: f64,
    from: f64,
    last: f64,
) -> Option<f64> {
    if room <= 0.0 || from > last {
        return None;
    }
    let Motion { d: [x, y], v: [vx, vy], .. } = later(plan, from);
    let gap = room * room - (x * x + y * y);
    let rate = -2.0 * (x * vx + y * vy);
    first_crossing(gap, rate, -(vx * vx + vy * vy), last - from).map(|t| from + t)
}
