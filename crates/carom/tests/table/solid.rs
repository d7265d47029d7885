//! The table as a solid body, and a walk through the air: an independent search for the first
//! meeting of a flying ball.
//!
//! It uses neither quadratics nor roots, only distances from drawn curves, and whether a line from
//! a point to the middle of the table crosses their closed chain an odd number of times.

use crate::oracle::{LOST, distance};
use carom::Table;
use carom::math::{Vec2, Vec3, sqrt};
use carom::table::TableFeature;
use carom::table::{Capture, Part, Shape};
use carom_roots::Motion;

/// Shortest step of the walk, m. A graze shallower than step²/2R may be passed.
const SHORTEST_STEP: f64 = 2e-6;
/// A point on the cloth off every line of symmetry, m.
const MIDDLE: Vec2 = Vec2::new(0.012_345, 0.023_456);

/// The drawn curves that enclose the playing area and the pockets.
pub(crate) struct Solid<'a> {
    pub(crate) table: &'a Table,
    pub(crate) radius: f64,
    /// The mouth-line model ends its openings with straight lines.
    backs: Vec<Shape>,
}

impl<'a> Solid<'a> {
    pub(crate) fn new(table: &'a Table, radius: f64) -> Self {
        let lines = table.pockets.iter().filter(|p| p.capture != Capture::DropCircle);
        let backs = lines
            .map(|p| Shape::Segment { start: p.throat[0], end: p.throat[1], normal: -p.axis })
            .collect();
        Self { table, radius, backs }
    }

    pub(crate) fn has_holes(&self) -> bool {
        self.table.pockets.iter().any(|p| p.capture == Capture::DropCircle)
    }

    fn edges(&self) -> impl Iterator<Item = &Shape> {
        self.table.cushions.iter().filter(|c| c.part != Part::Top).map(|c| &c.shape)
    }

    /// Whether `p` is behind the edges, in rubber or wood.
    pub(crate) fn is_behind_edges(&self, p: Vec2) -> bool {
        let all = self.edges().chain(&self.backs);
        all.map(|shape| crossings(shape, p, MIDDLE)).sum::<usize>() % 2 == 1
    }

    pub(crate) fn is_within_border(&self, p: Vec2) -> bool {
        let rail = self.table.description.as_ref().map_or(f64::INFINITY, |d| d.rail_width);
        p.x.abs() <= 0.5 * self.table.size.x + rail && p.y.abs() <= 0.5 * self.table.size.y + rail
    }

    /// Distance from the nearest edge line, seen from above, m.
    pub(crate) fn distance_to_edge(&self, p: Vec2) -> f64 {
        self.edges().chain(&self.backs).map(|s| plan_distance(s, p)).fold(f64::INFINITY, f64::min)
    }

    /// Distance of a ball to the feature, m.
    pub(crate) fn gap(&self, feature: TableFeature, p: Vec3) -> f64 {
        let (height, radius) = (self.table.cushion_height, self.radius);
        match feature {
            TableFeature::Slate => p.z - radius,
            TableFeature::Lip(k) => {
                let pocket = &self.table.pockets[usize::from(k)];
                let inwards = pocket.radius - (p.xy() - pocket.center).length();
                if p.z > 0.0 { hypot(inwards, p.z) - radius } else { inwards - radius }
            }
            TableFeature::Cushion(part) => {
                let shape = &self.table.cushions[usize::from(part)].shape;
                let aside = plan_distance(shape, p.xy());
                match shape {
                    Shape::Plane { .. } => p.z - height - radius,
                    Shape::Hollow { .. } if p.z <= height => aside - radius,
                    Shape::Hollow { .. } => hypot(aside, p.z - height) - radius,
                    _ => {
                        let edge = hypot(aside, p.z - height) - radius;
                        // The rubber recedes under its edge, far below by a radius.
                        let under = hypot(aside, (p.z - (height - radius)).max(0.0));
                        edge.min(under)
                    }
                }
            }
            _ => f64::INFINITY,
        }
    }

    /// Distance of a ball to anything solid, m; negative inside.
    pub(crate) fn clearance(&self, p: Vec3) -> f64 {
        let table = self.table;
        let over = |k: &usize| {
            let pocket = &table.pockets[*k];
            pocket.capture == Capture::DropCircle
                && (p.xy() - pocket.center).length() < pocket.radius
        };
        let bed = match (0..table.pockets.len()).find(over) {
            Some(k) => TableFeature::Lip(k as u8),
            None => TableFeature::Slate,
        };
        let mut free = self.gap(bed, p);
        for (i, cushion) in table.cushions.iter().enumerate() {
            if cushion.part != Part::Top {
                free = free.min(self.gap(TableFeature::Cushion(i as u16), p));
            }
        }
        if self.is_behind_edges(p.xy()) && self.is_within_border(p.xy()) {
            let top = p.z - table.cushion_height - self.radius;
            free = free.min(if p.z > table.cushion_height {
                top
            } else {
                -self.distance_to_edge(p.xy())
            });
        }
        free
    }

    /// The first time on the flight `path` in [0, `to`] at which the ball is [`LOST`] deep in
    /// something.
    pub(crate) fn first_violation(&self, path: &Motion<3>, to: f64) -> Option<f64> {
        let bend = -2.0 * path.h[2];
        let mut t = 0.0;
        loop {
            let free = self.clearance(Vec3::from(path.at(t)));
            if free < -LOST {
                return Some(t);
            }
            if t >= to {
                return None;
            }
            let speed = Vec3::from(path.velocity_at(t)).length();
            let step = free.max(SHORTEST_STEP);
            let dt = 2.0 * step / (speed + sqrt(speed * speed + 2.0 * bend * step));
            t = (t + dt).min(to);
        }
    }
}

fn hypot(a: f64, b: f64) -> f64 {
    sqrt(a * a + b * b)
}

/// Distance of `p` from a drawn curve, ends included, m.
fn plan_distance(shape: &Shape, p: Vec2) -> f64 {
    match *shape {
        Shape::Hollow { center, radius, start, end } => {
            distance(&Shape::Arc { center, radius, start, end }, p)
        }
        _ => distance(shape, p),
    }
}

/// Number of crossings of the straight line from `p` to `q` with a drawn curve.
fn crossings(shape: &Shape, p: Vec2, q: Vec2) -> usize {
    let way = q - p;
    match *shape {
        Shape::Segment { start, end, .. } => {
            let along = end - start;
            let side = |a: Vec2, direction: Vec2, b: Vec2| direction.cross(b - a) > 0.0;
            usize::from(
                side(p, way, start) != side(p, way, end)
                    && side(start, along, p) != side(start, along, q),
            )
        }
        Shape::Arc { radius: 0.0, .. } | Shape::Plane { .. } => 0,
        Shape::Arc { center, radius, start, end }
        | Shape::Hollow { center, radius, start, end } => {
            let from = p - center;
            let (a, b) = (way.length_squared(), way.dot(from));
            let discriminant = b * b - a * (from.length_squared() - radius * radius);
            if discriminant <= 0.0 {
                return 0;
            }
            let turn = start.cross(end);
            let hit = |s: &f64| {
                let d = from + way * *s;
                (0.0..=1.0).contains(s) && start.cross(d) * turn >= 0.0 && d.cross(end) * turn > 0.0
            };
            let root = sqrt(discriminant);
            [(-b - root) / a, (-b + root) / a].iter().filter(|s| hit(s)).count()
        }
    }
}
