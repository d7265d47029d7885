//! Earliest contact of a flying ball with the table.
//!
//! A flight is a parabola: uniform motion on a straight line in plan view, and a vertical half
//! acceleration of −g/2. So a plane is a quadratic, a straight edge a quartic in the plane across
//! it, and a circle has degree 8 ([`carom_roots::first_ring_contact`]).
//!
//! Most flights are small hops in the middle of the table: if the flight down to the slate stays in
//! the playing area shrunk by the ball's radius, only the slate matters. Otherwise the planes come
//! first, because one of them ends every flight. Then only parts near the straight line of the
//! flight in plan view are searched.
//!
//! Surfaces that join tangentially overlap, so that rounding cannot open a gap at the join: the
//! tube around a lip lies below the slate, the tube around an edge below the rail's top.

use carom_roots::{Motion, first_crossing, first_ring_contact};

use super::edge::{self, below, earlier, first_touch_of_hole, keeps_below, plan, relative};
use crate::math::Vec2;
use crate::table::TableFeature;
use crate::table::{AISLE, BoundPart, Bounds, Capture, Shape, TableGeometry};

/// The surface under a ball (slate or hole, rail's top or opening) is the one below a point this
/// far ahead of the centre, m: a ball exactly above an edge moves towards one of the two. Ten
/// thousand rounding errors of a position.
const LOOK_AHEAD: f64 = 1e-12;

/// A centre at most this far above the slate's surface counts as below it, m, so that one passage
/// is reported once. Ten thousand rounding errors.
const PASSED: f64 = 1e-12;

/// Earliest feature of `table` that a flying ball meets, and when. Its radius is `radius` (m); its
/// centre moves on d + v t + h t² (in the engine's coordinates) within [0, `horizon`] (s, may be
/// infinite).
///
/// The path must be a flight: no horizontal acceleration, and a downward one. The ball meets slate,
/// lips, edges, walls and tops when it touches them and approaches. `Depth(k)`: the centre, in the
/// hole of pocket k, descends through the slate's surface; if the flight begins at or below the
/// surface, through one radius below it. `Edge`: the centre crosses the border of the rails
/// outwards. `Pocket(k)`, in the mouth-line model: the centre crosses the line no higher than on a
/// rail's top, or descends to that height behind the line.
///
/// On a table with rails, and on unbounded cloth, every flight ends, so the result is `None` only
/// if the `horizon` comes first.
pub fn first_meeting(
    table: &TableGeometry,
    radius: f64,
    path: &Motion<3>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let landing = first_crossing(path.d[2] - radius, path.v[2], path.h[2], horizon);
    let margin = if radius > table.index.clear_reach { radius } else { table.index.clear_reach };
    let half = table.index.half;
    let until = landing.unwrap_or(horizon);
    if keeps_within(half.x - margin, path.d[0], path.v[0], until)
        && keeps_within(half.y - margin, path.d[1], path.v[1], until)
    {
        return landing.map(|t| (t, TableFeature::Slate));
    }
    near_the_rails(&Flight { table, radius, path, landing }, horizon)
}

/// Whether a uniformly moving coordinate stays within ±`limit` until `t`.
#[inline(always)]
fn keeps_within(limit: f64, d: f64, v: f64, t: f64) -> bool {
    // If 0·∞ makes a NaN, the comparison is false and nothing is proved.
    d.abs() + t * v.abs() <= limit
}

/// The first contact among all parts of the table.
fn near_the_rails(flight: &Flight<'_>, horizon: f64) -> Option<(f64, TableFeature)> {
    let mut first = Earliest { found: None, last: horizon };
    flight.meet_planes(&mut first);
    // All lips use one horizon, and then all edges use one, so that a mirrored path, which meets
    // them in another order, has the same bits. Parts that cannot be first are skipped. Lips come
    // first because a hop on a lip ends there before it can meet anything else.
    if first.last < f64::INFINITY {
        let last = first.last;
        flight.meet_lips(&mut first, last);
        let last = first.last;
        flight.meet_edges(&mut first, last);
    }
    first.found
}

/// The earliest contact found so far.
struct Earliest {
    found: Option<(f64, TableFeature)>,
    /// Its time, or the horizon if there is none, s.
    last: f64,
}

impl Earliest {
    /// Takes `t` if it is the earliest so far. Returns whether it is.
    #[inline(always)]
    fn offer(&mut self, t: Option<f64>, feature: TableFeature) -> bool {
        match t {
            Some(t) if t < self.last || (self.found.is_none() && t <= self.last) => {
                *self = Self { found: Some((t, feature)), last: t };
                true
            }
            _ => false,
        }
    }
}

struct Flight<'a> {
    table: &'a TableGeometry,
    radius: f64,
    path: &'a Motion<3>,
    /// Time at which the ball comes down to the slate, if within the horizon, s.
    landing: Option<f64>,
}

impl Flight<'_> {
    /// The centre in plan view at `t`, moved ahead by [`LOOK_AHEAD`].
    fn place_ahead(&self, t: f64) -> Vec2 {
        let [x, y, _] = self.path.at(t);
        let v = Vec2::new(self.path.v[0], self.path.v[1]);
        let speed = v.length();
        let ahead = if speed > 0.0 { v * (LOOK_AHEAD / speed) } else { Vec2::ZERO };
        Vec2::new(x, y) + ahead
    }

    /// The next time at which the centre descends through the height `z` (m).
    fn descent_through(&self, z: f64) -> Option<f64> {
        let Motion { d, v, h } = self.path;
        first_crossing(d[2] - z, v[2], h[2], f64::INFINITY)
    }

    fn meet_planes(&self, first: &mut Earliest) {
        let (table, path) = (self.table, self.path);
        let ground = self.landing.map(|t| match table.hole_at(self.place_ahead(t)) {
            None => (self.landing, TableFeature::Slate),
            Some(hole) => {
                let depth = if path.d[2] > PASSED { 0.0 } else { -self.radius };
                (self.descent_through(depth), TableFeature::Depth(hole))
            }
        });
        let until = ground.and_then(|(t, _)| t).unwrap_or(first.last);
        let border = table.index.border;
        for (d, v, border) in [(path.d[0], path.v[0], border.x), (path.d[1], path.v[1], border.y)] {
            if !keeps_within(border, d, v, until) {
                let t = first_crossing(border - d * v.signum(), -v.abs(), 0.0, first.last);
                first.offer(t, TableFeature::Border);
            }
        }
        if !self.keeps_under(table.cushion_height)
            && let Some(t) = self.descent_through(table.cushion_height + self.radius)
        {
            self.meet_tops(first, t);
        }
        self.cross_mouth_lines(first);
        if let Some((t, feature)) = ground {
            first.offer(t, feature);
        }
    }

    /// Whether the centre stays below the height `z` (m).
    fn keeps_under(&self, z: f64) -> bool {
        let (room, rise, fall) = (z - self.path.d[2], self.path.v[2], -self.path.h[2]);
        room > 0.0 && (rise <= 0.0 || rise * rise < 4.0 * (room * fall))
    }

    /// Contact with a rail's top, or capture behind a mouth line, at the time `t` at which the ball
    /// descends to the height of the tops.
    fn meet_tops(&self, first: &mut Earliest, t: f64) {
        let (table, place) = (self.table, self.place_ahead(t));
        // A ball that never rose to this height cannot come down on a top.
        if self.path.at(t)[2] <= table.cushion_height {
            return;
        }
        if let Some(top) = table.top_at(place) {
            first.offer(Some(t), TableFeature::Cushion(top));
        } else if let Some(pocket) = table.beyond_mouth_line(place) {
            first.offer(Some(t), TableFeature::Pocket(pocket));
        }
    }

    /// Whether the pockets capture by the mouth-line model. All pockets of a table have the same
    /// model.
    fn has_mouth_lines(&self) -> bool {
        let first = self.table.pockets.first();
        first.is_some_and(|pocket| matches!(pocket.capture, Capture::MouthLine { .. }))
    }

    /// Crossings of the lines from tip to tip, no higher than on a rail's top.
    fn cross_mouth_lines(&self, first: &mut Earliest) {
        if !self.has_mouth_lines() {
            return;
        }
        let (table, plan) = (self.table, plan(self.path));
        let top = table.cushion_height + self.radius;
        for (k, (pocket, mouth)) in table.pockets.iter().zip(&table.index.mouths).enumerate() {
            let t = super::ball_pocket::through_gate(pocket, &mouth.gate, 0.0, &plan, first.last);
            let low = |t: &f64| self.path.at(*t)[2] <= top;
            first.offer(t.filter(low), TableFeature::Pocket(k as u8));
        }
    }

    fn meet_edges(&self, first: &mut Earliest, last: f64) {
        let (height, radius) = (self.table.cushion_height, self.radius);
        // A ball higher than this touches no edge before it comes down.
        if self.path.d[2] > height + radius
            && self.descent_through(height + radius).is_none_or(|t| t > first.last)
        {
            return;
        }
        let TableGeometry { index, pockets, .. } = self.table;
        let mut track = PlanLine::new(self.path, first.last);
        if let Some((_, TableFeature::Lip(k))) = first.found
            && self.keeps_to_middle(usize::from(k), &track)
        {
            return;
        }
        let field = track.bounds().grown(radius);
        if pockets.is_empty() {
            for (i, place) in index.bounds[..index.on_cloth].iter().enumerate() {
                if !field.is_clear_of(place) {
                    self.meet_part(i, first, &mut track, last);
                }
            }
            return;
        }
        for &nose in index.nose_quadrants.near(&field) {
            let nose = usize::from(nose);
            if !field.is_clear_of(&index.bounds[nose]) {
                self.meet_part(nose, first, &mut track, last);
            }
        }
        for &k in index.mouth_quadrants.near(&field) {
            let mouth = &index.mouths[usize::from(k)];
            if field.is_clear_of(&mouth.bounds) {
                continue;
            }
            for BoundPart { part, bounds } in &mouth.all {
                if !field.is_clear_of(bounds) {
                    self.meet_part(usize::from(*part), first, &mut track, last);
                }
            }
        }
    }

    /// Whether the ball provably stays in the middle of the mouth of pocket `k`, where it touches
    /// no edge or wall. Most hops on a lip do.
    fn keeps_to_middle(&self, k: usize, track: &PlanLine) -> bool {
        let (pocket, mouth) = (&self.table.pockets[k], &self.table.index.mouths[k]);
        let is_there = |place: Vec2| {
            let from_center = place - pocket.center;
            let along = pocket.axis.dot(from_center);
            let across = pocket.axis.cross(from_center);
            (-AISLE * pocket.radius..=0.0).contains(&along)
                && across.abs() + self.radius < mouth.aisle
        };
        is_there(track.from) && is_there(track.to)
    }

    /// Searches one edge or wall. `track` covers the path until the earliest contact so far.
    #[inline(always)]
    fn meet_part(&self, i: usize, first: &mut Earliest, track: &mut PlanLine, last: f64) {
        let shape = &self.table.cushions[i].shape;
        if track.is_clear_of(shape, self.radius) {
            return;
        }
        let height = self.table.cushion_height;
        let t = edge::first_touch(shape, height, self.radius, self.path, last);
        if first.offer(t, TableFeature::Cushion(i as u16)) {
            *track = PlanLine::new(self.path, first.last);
        }
    }

    /// Searches the lips of the holes and, below the slate's surface, their walls.
    fn meet_lips(&self, first: &mut Earliest, last: f64) {
        let (path, radius) = (self.path, self.radius);
        if self.has_mouth_lines() {
            return;
        }
        // A ball above the slate can meet only its plane.
        let from = if path.d[2] > radius { self.landing } else { Some(0.0) };
        let Some(from) = from.filter(|t| *t < first.last) else { return };
        let track = PlanLine::new(path, first.last);
        let field = track.bounds().grown(radius);
        for &k in self.table.index.mouth_quadrants.near(&field) {
            let k = usize::from(k);
            let pocket = &self.table.pockets[k];
            if field.is_clear_of(&self.table.index.mouths[k].bounds)
                || track.is_clear_of_disc(pocket.center, pocket.radius + radius)
                || track.is_within_disc(pocket.center, pocket.radius - radius)
            {
                continue;
            }
            first.offer(self.first_touch_of_lip(k, [from, last]), TableFeature::Lip(k as u8));
        }
    }

    /// Contact with the lip or the wall of the hole of pocket `k`. From `from` on the ball's centre
    /// is at most one radius above the slate.
    fn first_touch_of_lip(&self, k: usize, [from, last]: [f64; 2]) -> Option<f64> {
        let (pocket, radius) = (&self.table.pockets[k], self.radius);
        let around = relative(self.path, pocket.center, 0.0);
        let plan = plan(&around);
        let outwards = |from| first_touch_of_hole(&plan, pocket.radius - radius, from, last);
        let first = outwards(from);
        // Where a liner stands on the wall, the ball touches the liner and cannot pass through it.
        let is_lined = |t: f64| self.is_at_liner(k, &around, t);
        let until = match first {
            Some(t) if is_lined(t) && around.at(t)[2] <= self.table.cushion_height => t,
            _ => last,
        };
        let again = |t| if t == from { first } else { outwards(t) };
        let wall = below(&around, 0.0, [from, last], again).filter(|t| !is_lined(*t));
        // Below the slate's surface a ball touches the wall before the lip.
        if keeps_below(&around, [from, until]) {
            return wall;
        }
        earlier(first_ring_contact(&around, pocket.radius, radius, from, until), wall)
    }

    /// Whether the centre is in the angle of the round wall of pocket `k`'s liner, seen from the
    /// pocket's centre.
    fn is_at_liner(&self, k: usize, around: &Motion<3>, t: f64) -> bool {
        let [x, y, _] = around.at(t);
        let from_center = Vec2::new(x, y);
        let along = self.table.index.mouths[k].liner_from * from_center.length();
        self.table.pockets[k].axis.dot(from_center) > along
    }
}

/// A flight in plan view: a straight line.
struct PlanLine {
    from: Vec2,
    to: Vec2,
}

impl PlanLine {
    fn new(path: &Motion<3>, until: f64) -> Self {
        let plan = plan(path);
        let vec = |[x, y]: [f64; 2]| Vec2::new(x, y);
        Self { from: vec(plan.d), to: vec(plan.at(until)) }
    }

    fn bounds(&self) -> Bounds {
        Bounds::of([self.from, self.to])
    }

    /// Whether the centre provably stays further than `radius` (m) from the edge `shape`.
    fn is_clear_of(&self, shape: &Shape, radius: f64) -> bool {
        match *shape {
            Shape::Segment { start, end, normal } => {
                let beyond = |axis: Vec2, point: Vec2| {
                    let (a, b) = (axis.dot(self.from - point), axis.dot(self.to - point));
                    (if a < b { a } else { b }) > radius
                };
                let length = end - start;
                let along = normal.perp();
                let along = if along.dot(length) > 0.0 { along } else { -along };
                beyond(normal, start) || beyond(along, end) || beyond(-along, start)
            }
            Shape::Arc { center, radius: ring, .. } => self.is_clear_of_disc(center, ring + radius),
            Shape::Hollow { center, radius: ring, start, end } => {
                // The whole wall is beyond a line through its beginning.
                let along = |p: Vec2| end.dot(p - center);
                let (a, b) = (along(self.from), along(self.to));
                (if a > b { a } else { b }) + radius < ring * end.dot(start)
                    || self.is_within_disc(center, ring - radius)
            }
            Shape::Plane { .. } => true,
        }
    }

    /// Whether the line stays closer than `distance` (m) to `center`, which it does if both ends
    /// do.
    fn is_within_disc(&self, center: Vec2, distance: f64) -> bool {
        let nearer = |p: Vec2| (p - center).length_squared() < distance * distance;
        distance > 0.0 && nearer(self.from) && nearer(self.to)
    }

    /// Whether the line stays further than `distance` (m) from `center`: it passes at one side,
    /// ends before `center`, or begins after it.
    fn is_clear_of_disc(&self, center: Vec2, distance: f64) -> bool {
        let line = self.to - self.from;
        let (from, to) = (self.from - center, self.to - center);
        let squared = distance * distance;
        let beside = line.cross(from);
        beside * beside > squared * line.length_squared()
            || (to.length_squared() > squared && line.dot(to) < 0.0)
            || (from.length_squared() > squared && line.dot(from) > 0.0)
    }
}
