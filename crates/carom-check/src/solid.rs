//! The solid parts of a table, as a set of pieces with closed-form distances from a point. They are
//! built from the judge's own plan of the edges ([`crate::table`]).
//!
//! * **Bed**: everything at or below z = 0, except the holes.
//! * **Plates**: cushion and rail have a flat top at the height of the nose. The rubber is
//!   undercut, so nothing below that edge can be touched, and a rail is a plate without thickness:
//!   a convex polygon behind its nose and its facings, and a slice of a disc for each rounded
//!   point.
//! * **Liners**: everything behind the far arc of a hole, up to the height of the nose.
//!
//! A ball is clear of a piece if its centre is at least its radius away. A ball that is clear at
//! all times cannot pass through a plate, however thin the plate is.

use carom::Table;
use carom::math::{Vec2, Vec3};

use crate::table::{EdgeLine, Hole, RailPlan, TablePlan};

/// One piece of a table.
#[derive(Clone, Debug)]
pub(crate) enum SolidPiece {
    /// A convex polygon, counter-clockwise, at the height of the nose.
    Plate { corners: Vec<Vec2>, height: f64 },
    /// A slice of less than half a disc at that height, between two unit vectors from its centre.
    Slice { center: Vec2, radius: f64, from: Vec2, to: Vec2, height: f64 },
    /// Everything up to that height outside a circle, between two unit vectors from its centre; the
    /// second is up to a quarter turn counter-clockwise from the first.
    Liner { center: Vec2, radius: f64, from: Vec2, to: Vec2, height: f64 },
    /// The bed with its holes, by centre and radius.
    Bed { holes: Vec<(Vec2, f64)> },
}

/// The distance of a point from a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    /// Metres; 0 inside.
    pub(crate) value: f64,
    /// The gradient of the distance: the unit vector away from the piece.
    pub(crate) away: Vec3,
    /// Radius of curvature in plan of a concave piece, an upright cylinder, as seen from the point,
    /// m; infinite for a convex one. The distance at a point displaced by δ is at least `value` +
    /// `away`·δ − |δ′|²/2ρ with the horizontal part δ′ of δ and ρ = `hollow` − |δ′|. (In plan the
    /// distance from the cylinder falls by no more than that, and the distance in space is a convex
    /// and rising function of this one and of the height above the piece.)
    pub(crate) hollow: f64,
    /// Largest |δ′| for which that holds, m.
    pub(crate) valid: f64,
}

impl Distance {
    /// The distance from its part in plan, with that part's gradient, and the height above the
    /// piece.
    fn combine(level: f64, gradient: Vec2, rise: f64, hollow: f64, valid: f64) -> Self {
        let value = (level * level + rise * rise).sqrt();
        let away = if value > 0.0 {
            (gradient * (level / value)).with_z(rise / value)
        } else {
            Vec3::ZERO
        };
        Self { value, away, hollow, valid }
    }
}

/// Distance of `p` from the nearer of two points, and the unit vector from it.
fn from_point(p: Vec2, q: Vec2) -> (f64, Vec2) {
    let d = p - q;
    let length = d.length();
    (length, if length > 0.0 { d * (1.0 / length) } else { Vec2::ZERO })
}

fn nearer(a: (f64, Vec2), b: (f64, Vec2)) -> (f64, Vec2) {
    if b.0 < a.0 { b } else { a }
}

/// Distance from the straight line between two points.
fn from_segment(p: Vec2, start: Vec2, end: Vec2) -> (f64, Vec2) {
    let along = end - start;
    let s = (p - start).dot(along) / along.length_squared();
    from_point(p, start + along * s.clamp(0.0, 1.0))
}

/// Distance from a convex polygon.
fn from_polygon(p: Vec2, corners: &[Vec2]) -> (f64, Vec2) {
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    if edges().all(|(&start, &end)| (end - start).cross(p - start) >= 0.0) {
        return (0.0, Vec2::ZERO);
    }
    // All edges, including those with the point on their inner side: if two edges are in one line,
    // rounding may put the point outside of the farther edge only.
    let from_edges = edges().map(|(&start, &end)| from_segment(p, start, end));
    from_edges.fold((f64::INFINITY, Vec2::ZERO), nearer)
}

/// Whether `q` lies in the cone from `from` counter-clockwise to `to`.
fn in_cone(q: Vec2, from: Vec2, to: Vec2) -> bool {
    from.cross(q) >= 0.0 && q.cross(to) >= 0.0
}

impl SolidPiece {
    /// The distance of the point `c` from this piece.
    pub(crate) fn distance(&self, c: Vec3) -> Distance {
        let p = c.xy();
        match self {
            Self::Plate { corners, height } => {
                let (level, away) = from_polygon(p, corners);
                Distance::combine(level, away, c.z - height, f64::INFINITY, f64::INFINITY)
            }
            Self::Slice { center, radius, from, to, height } => {
                let q = p - *center;
                let (level, away) = if in_cone(q, *from, *to) {
                    let (rho, out) = from_point(p, *center);
                    ((rho - radius).max(0.0), out)
                } else {
                    let side = |u: Vec2| from_point(p, *center + u * q.dot(u).clamp(0.0, *radius));
                    nearer(side(*from), side(*to))
                };
                Distance::combine(level, away, c.z - height, f64::INFINITY, f64::INFINITY)
            }
            Self::Liner { center, radius, from, to, height } => {
                let q = p - *center;
                let rho = q.length();
                let (level, away) = if in_cone(q, *from, *to) {
                    let (_, out) = from_point(p, *center);
                    ((radius - rho).max(0.0), -out)
                } else {
                    let side = |u: Vec2| from_point(p, *center + u * q.dot(u).max(*radius));
                    nearer(side(*from), side(*to))
                };
                let rise = (c.z - height).max(0.0);
                // Where rounding could select the wrong end, the piece is a radius away.
                Distance::combine(level, away, rise, rho, 0.5 * (radius - level).max(0.0))
            }
            Self::Bed { holes } => {
                let over = holes.iter().find(|(center, r)| (p - *center).length() < *r);
                let (level, away, hollow) =
                    over.map_or((0.0, Vec2::ZERO, f64::INFINITY), |(center, r)| {
                        let (rho, out) = from_point(p, *center);
                        (r - rho, -out, rho)
                    });
                Distance::combine(level, away, c.z.max(0.0), hollow, f64::INFINITY)
            }
        }
    }

    /// The bounding rectangle of the piece in plan: two opposite corners.
    fn extent(&self) -> [Vec2; 2] {
        let around = |points: &[Vec2]| {
            let fold = |f: fn(f64, f64) -> f64, x: f64| {
                points.iter().fold(Vec2::new(x, x), |m, p| Vec2::new(f(m.x, p.x), f(m.y, p.y)))
            };
            [fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY)]
        };
        match self {
            Self::Plate { corners, .. } => around(corners),
            Self::Slice { center, radius, .. } => {
                let reach = Vec2::new(*radius, *radius);
                [*center - reach, *center + reach]
            }
            Self::Liner { .. } | Self::Bed { .. } => {
                let all = Vec2::new(f64::INFINITY, f64::INFINITY);
                [-all, all]
            }
        }
    }
}

/// A piece with its name and its bounding rectangle.
#[derive(Clone, Debug)]
pub(crate) struct NamedPiece {
    pub(crate) piece: SolidPiece,
    pub(crate) name: String,
    extent: [Vec2; 2],
}

impl NamedPiece {
    fn new(piece: SolidPiece, name: String) -> Self {
        let extent = piece.extent();
        Self { piece, name, extent }
    }

    /// Lower bound of the distance between `p` and the piece, m: that of its bounding rectangle
    /// along one axis.
    pub(crate) fn at_least(&self, p: Vec2) -> f64 {
        let [low, high] = self.extent;
        (low.x - p.x).max(p.x - high.x).max((low.y - p.y).max(p.y - high.y))
    }
}

/// All solid parts of a table.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    /// The edges from which it is built.
    pub(crate) plan: TablePlan,
    /// The bed.
    pub(crate) bed: NamedPiece,
    /// The rails and liners, none of which reaches over the playing area.
    pub(crate) rails: Vec<NamedPiece>,
    /// Half the playing area, m.
    pub(crate) half: Vec2,
    /// Half the table with its rails, m.
    pub(crate) border: Vec2,
    /// Height of the rails' tops, m.
    pub(crate) height: f64,
    /// Centres and radii of the holes, m.
    pub(crate) holes: Vec<(Vec2, f64)>,
}

/// Plates extend to this many times the rails' width.
const BEYOND: f64 = 4.0;

/// The rails and liners of a [`Solid`] under construction.
struct SolidRails {
    height: f64,
    pieces: Vec<NamedPiece>,
}

impl SolidRails {
    /// Adds the plate behind a rail's edges, and the slices of its points.
    fn add_rail(&mut self, rail: &RailPlan, reach: Vec2) {
        let (height, name) = (self.height, rail.name);
        let mut plate = vec![
            Vec2::new(-reach.x, -reach.y),
            Vec2::new(reach.x, -reach.y),
            Vec2::new(reach.x, reach.y),
            Vec2::new(-reach.x, reach.y),
        ];
        for (_, line) in &rail.edges {
            match *line {
                EdgeLine::Straight { start, normal, .. } => cut(&mut plate, start, normal),
                EdgeLine::Round { center, radius, from, to } => {
                    // The plate ends at the chord.
                    if radius > 0.0 {
                        cut(&mut plate, center + from * radius, from + to);
                    }
                    let (from, to) = if from.cross(to) >= 0.0 { (from, to) } else { (to, from) };
                    let slice = SolidPiece::Slice { center, radius, from, to, height };
                    self.pieces.push(NamedPiece::new(slice, format!("a point of the {name} rail")));
                }
                EdgeLine::Wall { .. } | EdgeLine::Flat => {}
            }
        }
        for end in &rail.ends {
            cut(&mut plate, end.deep, end.normal);
        }
        let plate = SolidPiece::Plate { corners: plate, height };
        self.pieces.push(NamedPiece::new(plate, format!("the {name} rail")));
    }

    /// Adds the liner of pocket `k`, between the extended lines of its two jaws.
    fn add_liner(&mut self, k: usize, pocket: &Hole, rails: &[RailPlan], far: f64) {
        let Hole { name, center, radius, axis, .. } = *pocket;
        let height = self.height;
        let mut ends: Vec<Vec2> = Vec::new();
        for jaw in rails.iter().flat_map(|rail| &rail.ends).filter(|jaw| jaw.pocket == k) {
            let Some(end) = jaw.leaves(center, radius) else { continue };
            let out = (end - center) * (1.0 / radius);
            ends.push(out);
            // The region between the extended line and the liner is solid too.
            if out.dot(jaw.normal) > 0.0 {
                let (a, b) = (end + out * far, end + jaw.along * far);
                let turn = (a - end).cross(b - end);
                let corners = if turn > 0.0 { vec![end, a, b] } else { vec![end, b, a] };
                let wedge = SolidPiece::Plate { corners, height };
                self.pieces
                    .push(NamedPiece::new(wedge, format!("the top behind the {name} pocket")));
            }
        }
        let [a, b] = ends[..] else { return };
        let (a, b) = if a.cross(axis) >= 0.0 { (a, b) } else { (b, a) };
        let between = |a: Vec2, b: Vec2| (a + b) * (1.0 / (a + b).length());
        let turns = [a, between(a, axis), axis, between(axis, b), b];
        for (&from, &to) in turns.iter().zip(&turns[1..]) {
            let liner = SolidPiece::Liner { center, radius, from, to, height };
            self.pieces.push(NamedPiece::new(liner, format!("the liner of the {name} pocket")));
        }
    }
}

impl Solid {
    pub(crate) fn of(table: &Table) -> Self {
        let plan = TablePlan::of(table);
        let TablePlan { half, rail_width, height, .. } = plan;
        // A ball is captured at a mouth line, before it comes to a hole.
        let pockets: &[Hole] = if plan.has_mouth_lines { &[] } else { &plan.pockets };
        let holes: Vec<_> = pockets.iter().map(|p| (p.center, p.radius)).collect();
        let bed = NamedPiece::new(SolidPiece::Bed { holes: holes.clone() }, "the slate".into());
        let border = half + Vec2::new(rail_width, rail_width);
        let mut rails = SolidRails { height, pieces: Vec::new() };
        let reach = half + Vec2::new(rail_width, rail_width) * BEYOND;
        for rail in &plan.rails {
            rails.add_rail(rail, reach);
        }
        for (k, pocket) in pockets.iter().enumerate() {
            rails.add_liner(k, pocket, &plan.rails, BEYOND * rail_width);
        }
        Self { bed, rails: rails.pieces, half, border, height, holes, plan }
    }

    /// The largest overlap of the table and a ball of radius `radius` (m) with its centre at `c`,
    /// m, and the name of the piece; negative if the ball is clear.
    pub(crate) fn depth(&self, c: Vec3, radius: f64) -> (f64, &str) {
        self.rails.iter().chain([&self.bed]).fold((f64::NEG_INFINITY, ""), |deepest, part| {
            let depth = radius - part.piece.distance(c).value;
            if depth > deepest.0 { (depth, part.name.as_str()) } else { deepest }
        })
    }

    /// Whether a ball with its centre at height `z` is nearer to a rail's top than to the bed.
    pub(crate) fn is_on_top(&self, z: f64, radius: f64) -> bool {
        !self.rails.is_empty() && z > radius + 0.5 * self.height
    }

    /// Distance of `p` inside the edge of the hole under it, m; negative: the distance from the
    /// nearest hole.
    pub(crate) fn over_hole(&self, p: Vec2) -> f64 {
        let inside = |(center, radius): &(Vec2, f64)| radius - (p - *center).length();
        self.holes.iter().map(inside).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Distance of `p` from the rails' tops in plan, m; 0 over them.
    pub(crate) fn beside_tops(&self, p: Vec2) -> f64 {
        let c = p.with_z(self.height);
        self.rails.iter().map(|part| part.piece.distance(c).value).fold(f64::INFINITY, f64::min)
    }
}

/// Cuts off the part of a convex polygon in front of the line through `place` with the normal
/// `normal` (Sutherland & Hodgman 1974).
fn cut(corners: &mut Vec<Vec2>, place: Vec2, normal: Vec2) {
    let front = |p: Vec2| (p - place).dot(normal);
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (k, &a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let (fa, fb) = (front(a), front(b));
        if fa <= 0.0 {
            kept.push(a);
        }
        if (fa < 0.0 && fb > 0.0) || (fa > 0.0 && fb < 0.0) {
            kept.push(a + (b - a) * (fa / (fa - fb)));
        }
    }
    *corners = kept;
}
