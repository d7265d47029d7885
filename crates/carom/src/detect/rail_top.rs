//! When and where a ball on a rail's top loses its support.
//!
//! A ball that rolls or slides on a top loses its support where its centre crosses an edge line
//! towards the cloth or a pocket's opening, or the outer border.

use carom_roots::{Motion, first_crossing};

use crate::math::{Vec2, sqrt};
use crate::table::TableFeature;
use crate::table::{Bounds, Capture, JOIN_OVERLAP, Pocket, Shape, TableGeometry, arc_sides};

/// First time in [0, `horizon`] (s, may be infinite) at which a ball on a rail's top loses its
/// support, and where: `Brink` at the edge of a cushion or pocket, `Edge` at the border. The centre
/// moves on d + v t + h t² (m, in the engine's coordinates, in plan view).
pub fn first_loss_of_support(
    table: &TableGeometry,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let mut last = horizon;
    let mut feature = None;
    let mut offer = |t: Option<f64>, of: TableFeature| {
        if let Some(t) = t
            && (t < last || (feature.is_none() && t <= last))
        {
            (last, feature) = (t, Some(of));
        }
        last
    };
    for (axis, border) in [(0, table.index.border.x), (1, table.index.border.y)] {
        let (d, v, h) = (path.d[axis], path.v[axis], path.h[axis]);
        offer(first_crossing(border - d, -v, -h, horizon), TableFeature::Border);
        offer(first_crossing(border + d, v, h, horizon), TableFeature::Border);
    }
    // A moving ball reaches the border in the end.
    let end = offer(None, TableFeature::Border);
    if end < f64::INFINITY {
        let field = field(path, end);
        for (cushion, place) in table.cushions.iter().zip(&table.index.bounds) {
            if field.is_clear_of(place) {
                continue;
            }
            offer(edge_crossing(&cushion.shape, path, end), TableFeature::Brink);
        }
        for pocket in &table.pockets {
            offer(back_of_mouth(pocket, path, end), TableFeature::Brink);
        }
    }
    feature.map(|feature| (last, feature))
}

/// A bounding box of the path until `end`.
fn field(path: &Motion<2>, end: f64) -> Bounds {
    let reach = |k: usize| end * (path.v[k].abs() + end * path.h[k].abs());
    let (start, reach) = (vec(path.d), Vec2::new(reach(0), reach(1)));
    Bounds::of([start - reach, start + reach])
}

fn vec([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

/// The time at which the centre leaves the top across the edge line `shape`.
fn edge_crossing(shape: &Shape, path: &Motion<2>, end: f64) -> Option<f64> {
    match *shape {
        Shape::Segment { start, end: other, normal } => {
            let t = line_crossing(normal, start, path, end)?;
            let tangent = normal.perp();
            let (s, length) = (tangent.dot(vec(path.at(t)) - start), tangent.dot(other - start));
            let low = length.min(0.0) - JOIN_OVERLAP;
            let high = length.max(0.0) + JOIN_OVERLAP;
            (s >= low && s <= high).then_some(t)
        }
        Shape::Arc { center, radius, start, end: other } => {
            circle_crossing(center, radius, [start, other], 1.0, path, end)
        }
        Shape::Hollow { center, radius, start, end: other } => {
            circle_crossing(center, radius, [start, other], -1.0, path, end)
        }
        Shape::Plane { .. } => None,
    }
}

/// The time at which the centre crosses the infinite line through `point` in the direction of its
/// `normal`. A centre that turns back before the line does not cross it here; such a ball is at
/// another part of the table.
fn line_crossing(normal: Vec2, point: Vec2, path: &Motion<2>, end: f64) -> Option<f64> {
    let behind = normal.dot(point - vec(path.d));
    let t = first_crossing(behind, -normal.dot(vec(path.v)), -normal.dot(vec(path.h)), end)?;
    (normal.dot(vec(path.at(t)) - point) <= JOIN_OVERLAP).then_some(t)
}

/// In the mouth-line model an opening ends in a straight line between the deep ends of the facings.
fn back_of_mouth(pocket: &Pocket, path: &Motion<2>, end: f64) -> Option<f64> {
    if !matches!(pocket.capture, Capture::MouthLine { .. }) {
        return None;
    }
    let [a, b] = pocket.throat;
    let t = line_crossing(-pocket.axis, a, path, end)?;
    let (from_a, across) = (vec(path.at(t)) - a, b - a);
    let s = across.dot(from_a);
    (s >= 0.0 && s <= across.length_squared()).then_some(t)
}

/// The time at which the centre crosses a circle, between two directions from the circle's centre,
/// outwards (`sign` 1) or inwards (−1).
fn circle_crossing(
    center: Vec2,
    radius: f64,
    [start, other]: [Vec2; 2],
    sign: f64,
    path: &Motion<2>,
    end: f64,
) -> Option<f64> {
    let from_center = Motion { d: [path.d[0] - center.x, path.d[1] - center.y], ..*path };
    let circle = Circle { path: from_center, radius, sign };
    let sides = arc_sides(start, other);
    let within = |t: f64| {
        let p = vec(from_center.at(t));
        sides.iter().all(|side| side.dot(p) >= 0.0)
    };
    circle.crossings(end, within)
}

/// A path near a circle: f(t) = ±(|p|² − r²), a quartic.
struct Circle {
    path: Motion<2>,
    radius: f64,
    sign: f64,
}

impl Circle {
    fn gap(&self, t: f64) -> f64 {
        self.sign * (vec(self.path.at(t)).length_squared() - self.radius * self.radius)
    }

    /// Half the derivative of the gap.
    fn rate(&self, t: f64) -> f64 {
        self.sign * vec(self.path.at(t)).dot(vec(self.path.velocity_at(t)))
    }

    /// The first time in [0, `end`] at which the gap rises through zero and `within` holds; 0 if
    /// the gap is already open by a rounding error and rises.
    ///
    /// Between the roots of the second derivative the first derivative is monotone, and between the
    /// roots of the first derivative the gap is. So each interval has at most one root, which
    /// bisection finds.
    fn crossings(&self, end: f64, within: impl Fn(f64) -> bool) -> Option<f64> {
        let at_edge = 2.0 * self.radius * JOIN_OVERLAP;
        if (0.0..=at_edge).contains(&self.gap(0.0)) && self.rate(0.0) > 0.0 && within(0.0) {
            return Some(0.0);
        }
        let mut turns = [end; 5];
        turns[0] = 0.0;
        let mut count = 1;
        let mut left = 0.0;
        for right in self.inflections(end) {
            if let Some(t) =
                rise(|t| self.rate(t), left, right).or_else(|| rise(|t| -self.rate(t), left, right))
            {
                turns[count] = t;
                count += 1;
            }
            left = right;
        }
        let pieces = turns[..=count].windows(2);
        pieces.filter_map(|piece| rise(|t| self.gap(t), piece[0], piece[1])).find(|t| within(*t))
    }

    /// The ends of the intervals of [0, `end`] in which the first derivative is monotone.
    fn inflections(&self, end: f64) -> [f64; 3] {
        let (a, b, c) = (vec(self.path.d), vec(self.path.v), vec(self.path.h));
        // ½f″ = c₀ + 2·c₁t + c₂t².
        let c0 = b.length_squared() + 2.0 * a.dot(c);
        let (c1, c2) = (3.0 * b.dot(c), 6.0 * c.length_squared());
        let discriminant = c1 * c1 - c0 * c2;
        if discriminant <= 0.0 || c2 == 0.0 {
            return [end; 3];
        }
        let root = sqrt(discriminant);
        [(-c1 - root) / c2, (-c1 + root) / c2, end].map(|t| t.clamp(0.0, end))
    }
}

/// The point at which `f` rises through zero on an interval where it is monotone: the first
/// floating-point number at which it is positive.
fn rise(f: impl Fn(f64) -> f64, left: f64, right: f64) -> Option<f64> {
    if !(f(left) <= 0.0 && f(right) > 0.0) {
        return None;
    }
    let (mut low, mut high) = (left, right);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(high);
        }
        if f(middle) > 0.0 { high = middle } else { low = middle }
    }
}
