//! Proves that a ball stays clear of the table on an interval of time, or finds an overlap.
//!
//! Two lower bounds hold for the distance from a piece of the table around a time at which it is
//! known. First, the distance changes no faster than the ball moves. Second, it is at least the
//! distance from the tangent plane at the nearest point, minus a correction for concave pieces
//! ([`Distance`]). The second bound is quadratic in time, and exact for a ball that leaves a piece
//! or slides along it. Where neither bound suffices, the interval is halved.

use std::cell::Cell;

use crate::closest::Intrusion;
use crate::curve::Curve;
use crate::solid::{Distance, NamedPiece, Solid, SolidPiece};

/// Number of subdivisions: 2⁻⁶⁰ of an interval is less than the rounding error of its ends.
const LEVELS: u32 = 60;

/// Number of samples after which a proof is abandoned, which counts as a fault. Between two bounces
/// off the same piece about a hundred are needed.
const MOST_SAMPLES: u32 = 100_000;

/// The distance from a piece at one time.
#[derive(Clone, Copy)]
struct DistanceSample {
    time: f64,
    distance: Distance,
}

impl DistanceSample {
    fn new(piece: &SolidPiece, curve: &Curve, time: f64) -> Self {
        Self { time, distance: piece.distance(curve.place(time)) }
    }

    /// Lower bound of the distance of the ball's centre from the piece between `from` and `to`, m.
    fn bound(&self, curve: &Curve, from: f64, to: f64) -> f64 {
        let (v, h, value) = (curve.velocity(self.time), curve.h, self.distance.value);
        let (early, late) = (from - self.time, to - self.time);
        let longest = late.max(-early);
        let within = |speed: f64, half_rate: f64| longest * (speed + longest * half_rate);
        let plainly = value - within(v.length(), h.length());
        // Concave pieces are upright cylinders, so only the displacement in plan bends away from the
        // tangent plane. A ball that falls along a wall stays beside it for any depth.
        let far = within(v.xy().length(), h.xy().length());
        let Distance { away, hollow, valid, .. } = self.distance;
        if far > valid || far >= hollow {
            return plainly;
        }
        let (slope, bend) = (away.dot(v), away.dot(h));
        let at = |t: f64| t * (slope + t * bend);
        let mut least = at(early).min(at(late));
        let turn = -0.5 * slope / bend;
        if bend > 0.0 && turn > early && turn < late {
            least = least.min(at(turn));
        }
        plainly.max(value + least - far * far / (2.0 * (hollow - far)))
    }
}

/// Whether the ball stays over the playing area, out of reach of the rails.
pub(crate) fn over_cloth(solid: &Solid, curve: &Curve, length: f64) -> bool {
    let reach = curve.radius + curve.travel(length);
    let inside = |half: f64, p: f64| half - p.abs() > reach;
    inside(solid.half.x, curve.p.x) && inside(solid.half.y, curve.p.y)
}

/// Calls `found` with the largest overlap of the ball and each piece of the table within `length`
/// seconds. Pieces out of reach are left out.
pub(crate) fn table<'s>(
    solid: &'s Solid,
    curve: &Curve,
    length: f64,
    tolerance: f64,
    mut found: impl FnMut(Intrusion, &'s str),
) {
    let lowest = curve.lowest(length);
    if lowest < curve.radius - tolerance {
        found(piece(&solid.bed.piece, curve, length, tolerance), &solid.bed.name);
    }
    if over_cloth(solid, curve, length) || lowest >= solid.height + curve.radius - tolerance {
        return;
    }
    let reach = curve.radius + curve.travel(length);
    for NamedPiece { piece: of, name, .. } in
        solid.rails.iter().filter(|part| part.at_least(curve.p.xy()) <= reach)
    {
        found(piece(of, curve, length, tolerance), name);
    }
}

/// Largest distance of the centre beyond the outer border of the rails, m; negative inside.
pub(crate) fn border(solid: &Solid, curve: &Curve, length: f64) -> Intrusion {
    let mut farthest = Intrusion::NONE;
    let axes = [
        (curve.p.x, curve.v.x, curve.h.x, solid.border.x),
        (curve.p.y, curve.v.y, curve.h.y, solid.border.y),
    ];
    for (p, v, h, border) in axes {
        let turn = (-0.5 * v / h).clamp(0.0, length);
        for after in [length, if turn.is_nan() { 0.0 } else { turn }] {
            let depth = (p + after * (v + after * h)).abs() - border;
            if depth > farthest.depth {
                farthest = Intrusion { depth, after };
            }
        }
    }
    farthest
}

/// The largest overlap of the ball and `piece`, or a bound of it within `tolerance`.
fn piece(piece: &SolidPiece, curve: &Curve, length: f64, tolerance: f64) -> Intrusion {
    let left = Cell::new(MOST_SAMPLES);
    let search = Search { piece, curve, allowed: curve.radius - tolerance, left };
    search.between(
        DistanceSample::new(piece, curve, 0.0),
        DistanceSample::new(piece, curve, length),
        LEVELS,
    )
}

struct Search<'a> {
    piece: &'a SolidPiece,
    curve: &'a Curve,
    /// Smallest allowed distance of the centre, m.
    allowed: f64,
    /// Number of samples left.
    left: Cell<u32>,
}

impl Search<'_> {
    fn between(&self, a: DistanceSample, b: DistanceSample, levels: u32) -> Intrusion {
        for end in [a, b] {
            if end.distance.value < self.allowed {
                return self.intrusion(end.distance.value, end.time);
            }
        }
        let bound = |s: &DistanceSample| s.bound(self.curve, a.time, b.time);
        let proved = bound(&a).max(bound(&b));
        if proved >= self.allowed {
            return self.intrusion(proved, a.time);
        }
        if self.left.get() == 0 {
            return self.intrusion(f64::NAN, a.time);
        }
        self.left.set(self.left.get() - 1);
        let middle = DistanceSample::new(self.piece, self.curve, 0.5 * (a.time + b.time));
        if levels == 0 {
            return self.intrusion(middle.distance.value, middle.time);
        }
        let first = self.between(a, middle, levels - 1);
        if first.depth.is_nan() || first.depth > self.curve.radius - self.allowed {
            return first;
        }
        let second = self.between(middle, b, levels - 1);
        if first.depth >= second.depth { first } else { second }
    }

    fn intrusion(&self, distance: f64, after: f64) -> Intrusion {
        Intrusion { depth: self.curve.radius - distance, after }
    }
}

#[cfg(test)]
mod tests {
    use carom::Table;
    use carom::math::Vec3;

    use super::*;

    /// The largest overlap of a ball on this path and the pool table, and the name of the piece.
    fn deepest(p: [f64; 3], v: [f64; 3], length: f64) -> (f64, String) {
        let table = Table::preset("wpa-9ft").expect("a preset");
        let solid = Solid::of(&table);
        let curve =
            Curve { p: p.into(), v: v.into(), h: Vec3::new(0.0, 0.0, -4.9), radius: 0.028_575 };
        let mut worst = (f64::NEG_INFINITY, String::new());
        table_of(&solid, &curve, length, &mut worst);
        worst
    }

    fn table_of(solid: &Solid, curve: &Curve, length: f64, worst: &mut (f64, String)) {
        table(solid, curve, length, 1e-12, |found, name| {
            // NaN: no proof.
            if found.depth.is_nan() || found.depth > worst.0 {
                *worst = (found.depth, name.into());
            }
        });
    }

    #[test]
    fn accepts_a_flying_ball_that_touches_nothing() {
        // Over the cloth, over a rail and out, and down the middle of a hole.
        let hole = Table::preset("wpa-9ft").expect("a preset").pockets[0].center;
        for (p, v, length) in [
            ([0.0, 0.0, 0.3], [3.0, 1.0, 1.0], 0.1),
            ([0.4, 0.5, 0.4], [4.0, 0.0, 1.0], 0.1),
            ([hole.x, hole.y, 0.2], [0.0, 0.0, -1.0], 0.3),
        ] {
            let (depth, name) = deepest(p, v, length);
            assert!(depth <= 1e-12, "{depth} in {name}");
        }
    }

    #[test]
    fn detects_an_overlap_with_each_piece_of_the_table() {
        let table = Table::preset("wpa-9ft").expect("a preset");
        let (hole, hole_radius) = (table.pockets[0].center, table.pockets[0].radius);
        let (x, h) = (0.5 * table.size.x, table.cushion_height);
        for (p, v, length, what) in [
            // Into the slate; through the nose from the side; onto the nose from above.
            ([0.0, 0.0, 0.1], [1.0, 0.0, -3.0], 0.1, "the slate"),
            ([x - 0.1, 0.5, h], [10.0, 0.0, 0.05], 0.02, "the right-upper rail"),
            ([x + 0.01, 0.5, h + 0.1], [-1.0, 0.0, -3.0], 0.025, "the right-upper rail"),
            // Down onto the lip; through the wall of the hole.
            ([hole.x + 0.05, hole.y + 0.03, 0.1], [0.0, 0.0, -2.0], 0.1, "the slate"),
            (
                [hole.x, hole.y, 0.03],
                [-4.0, -4.0, 0.0],
                0.02,
                "the liner of the bottom-left pocket",
            ),
            // Slowly into the wall below the slate, while it falls along it.
            (
                [hole.x + hole_radius - 0.028_575, hole.y, -1e-3],
                [1e-3, 0.0, -0.8],
                0.02,
                "the slate",
            ),
        ] {
            let (depth, name) = deepest(p, v, length);
            assert!(depth > 1e-6 && name == what, "{depth} in {name}, not in {what}");
        }
    }

    #[test]
    fn accepts_a_ball_that_falls_along_the_wall_of_a_hole() {
        let table = Table::preset("wpa-9ft").expect("a preset");
        let pocket = table.pockets[0];
        let beside = pocket.radius - 0.028_575;
        // At the wall of the hole towards the table, with the sideways speed of a rounding error.
        let p = pocket.center - pocket.axis * beside;
        let (depth, name) = deepest([p.x, p.y, -1e-3], [1e-15, -1e-15, -0.8], 0.02);
        assert!(depth <= 1e-12, "{depth} in {name}");
    }

    #[test]
    fn accepts_a_ball_that_slides_along_a_piece() {
        let table = Table::preset("wpa-9ft").expect("a preset");
        let (x, h, r) = (0.5 * table.size.x, table.cushion_height, 0.028_575);
        let reach = table.reach(r);
        // A ball above the nose that it touches leaves it when rising; a ball below moves into it.
        let above = (r * r - 1e-4_f64).sqrt();
        let (depth, name) = deepest([x - above, -0.6, h + 0.01], [0.0, 2.0, 1.0], 0.2);
        assert!(depth <= 1e-12, "{depth} in {name}");
        let (depth, name) = deepest([x - reach, -0.6, r], [0.0, 2.0, 1.0], 0.1);
        assert!(depth > 1e-6, "{depth} in {name}");
        // Level motion on a rail's top, and along the nose.
        let solid = Solid::of(&table);
        for p in [[x + 0.05, -0.6, h + r], [x - reach, -0.6, r]] {
            let curve =
                Curve { p: p.into(), v: Vec3::new(0.0, 0.5, 0.0), h: Vec3::ZERO, radius: r };
            let mut worst = (f64::NEG_INFINITY, String::new());
            table_of(&solid, &curve, 0.5, &mut worst);
            assert!(worst.0 <= 1e-12, "{worst:?}");
        }
    }
}
