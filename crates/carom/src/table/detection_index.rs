//! An index of a table's geometry: which parts a ball can touch where.

use arrayvec::ArrayVec;

use super::bounds::{Bounds, Quadrants};
use super::opening::Openings;
use super::{CushionPart, MAX_PARTS, MAX_POCKETS, Part, Pocket};
use crate::math::Vec2;

/// Extra length of a straight part at either end in detection, m: 1 nm, ten million roundings of a
/// position. Next to a round part the ball's centre follows an arc of at least its reach, about
/// ρ = 25 mm; the extra length departs from that arc by (1 nm)²/2ρ ≈ 2e-17 m, less than one
/// rounding.
pub(crate) const JOIN_OVERLAP: f64 = 1e-9;

/// The most parts around a mouth that a ball on the cloth can touch: on either side a nose, and a point, a
/// sharp corner, a facing and a straight run of the liner.
pub(crate) const MAX_IN_MOUTH: usize = 2 * 5;

/// Which parts a ball can touch where, and the bounding boxes of the parts.
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct DetectionIndex {
    /// Half the playing area, nose to nose, m.
    pub(crate) half: Vec2,
    /// The bottom and top noses span |x| ≤ `nose_x`, m.
    pub(crate) nose_x: f64,
    /// The noses of the long rails span `nose_y[0]` ≤ |y| ≤ `nose_y[1]`, m.
    pub(crate) nose_y: [f64; 2],
    /// Indices of the noses: bottom, top; then left and right, each lower, upper.
    pub(crate) noses: [u16; 6],
    /// The mouths, in the order of the pockets.
    pub(crate) mouths: ArrayVec<Mouth, MAX_POCKETS>,
    /// While the centre of a ball is at least its reach away from the edges of the playing area,
    /// the ball can touch only noses, if its reach is at least this, m.
    pub(crate) clear_reach: f64,
    /// Half the table, to the outer edge of its rails, m.
    pub(crate) border: Vec2,
    /// Number of parts, from the first on, that a ball on the cloth can touch.
    pub(crate) on_cloth: usize,
    /// Indices of the rails' tops, in the order of `noses`.
    pub(crate) tops: [u16; 6],
    /// The openings of the pockets; empty without pockets.
    pub(crate) openings: ArrayVec<Openings, 1>,
    /// Boxes around the cushions' parts, in their order.
    pub(crate) bounds: ArrayVec<Bounds, MAX_PARTS>,
    /// The noses and the mouths by quadrant.
    pub(crate) nose_quadrants: Quadrants,
    pub(crate) mouth_quadrants: Quadrants,
}

/// A pocket's features, for detection.
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Mouth {
    /// Indices of the cushion parts around it, with both neighbouring noses.
    pub(crate) parts: ArrayVec<u16, MAX_IN_MOUTH>,
    /// The line that captures balls.
    pub(crate) gate: Gate,
    /// Cosine of the angle, at the hole's centre, between the pocket's axis and the ends of the
    /// liner's round wall.
    pub(crate) liner_from: f64,
    /// Each point, facing and liner of the pocket, which a flying ball can touch.
    pub(crate) all: ArrayVec<BoundPart, MAX_PARTS>,
    /// The box around these parts and the hole.
    pub(crate) bounds: Bounds,
    /// Distance of the nearest edge or wall from the aisle, m. The aisle is the last part of the
    /// pocket's axis before the hole's centre, [`AISLE`] radii of the hole long.
    pub(crate) aisle: f64,
}

/// A cushion's part: its index, and its box.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct BoundPart {
    pub(crate) part: u16,
    pub(crate) bounds: Bounds,
}

/// Length of the aisle of a mouth, in radii of the hole: the hole up to its lip, and a ball's
/// radius before it.
pub(crate) const AISLE: f64 = 2.0;

/// A line across a pocket that captures a ball on the cloth which crosses it outwards. With the
/// drop-circle model it lies over the hole and only bounds the search: a centre can reach it only
/// over the hole.
///
/// A centre p is beyond the line when axis·p ≥ offset + lean·reach.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Gate {
    /// Its distance from the table's centre along the pocket's axis, m.
    pub(crate) offset: f64,
    /// Change of that distance per metre of reach: the centre of a ball that touches the deep end
    /// of a facing is one reach away from it, along the facing's normal.
    pub(crate) lean: f64,
    /// Half its width, m. It ends inside the rubber.
    pub(crate) half_width: f64,
}

impl DetectionIndex {
    /// Computes the boxes of all parts, and assigns every point, facing and liner to the mouth of
    /// its pocket.
    pub(super) fn bound_parts(&mut self, cushions: &[CushionPart], pockets: &[Pocket]) {
        // Straight parts are longer by JOIN_OVERLAP at either end.
        let bounds = |c: &CushionPart| Bounds::of_shape(&c.shape).grown(JOIN_OVERLAP);
        self.bounds = cushions.iter().map(bounds).collect();
        for (mouth, pocket) in self.mouths.iter_mut().zip(pockets) {
            mouth.bounds = Bounds::of([pocket.center]).grown(pocket.radius);
        }
        for (i, (cushion, bounds)) in cushions.iter().zip(&self.bounds).enumerate() {
            if matches!(cushion.part, Part::Nose | Part::Top) {
                continue;
            }
            let distance = |p: &Pocket| (p.center - bounds.middle()).length_squared();
            let nearest = (0..pockets.len())
                .min_by(|a, b| distance(&pockets[*a]).total_cmp(&distance(&pockets[*b])));
            if let Some(k) = nearest {
                self.mouths[k].all.push(BoundPart { part: i as u16, bounds: *bounds });
                self.mouths[k].bounds = self.mouths[k].bounds.with(bounds);
            }
        }
        for (mouth, pocket) in self.mouths.iter_mut().zip(pockets) {
            let before = pocket.center - pocket.axis * (AISLE * pocket.radius);
            let distances = cushions.iter().map(|c| c.shape.distance(before, pocket.center));
            mouth.aisle = distances.fold(f64::INFINITY, f64::min) - JOIN_OVERLAP;
        }
        if pockets.is_empty() {
            return;
        }
        let noses = self.noses.iter().map(|&i| (i, self.bounds[usize::from(i)]));
        self.nose_quadrants = Quadrants::new(noses);
        let mouths = self.mouths.iter().enumerate().map(|(k, mouth)| (k as u16, mouth.bounds));
        self.mouth_quadrants = Quadrants::new(mouths);
    }
}

#[cfg(test)]
mod tests {
    use super::AISLE;
    use crate::math::Vec2;
    use crate::table::{PRESETS, Part, Shape, Table};

    /// Points along an edge or a wall in plan view.
    fn points(shape: &Shape) -> Vec<Vec2> {
        let between = |a: Vec2, b: Vec2| (0..=20).map(move |k| a + (b - a) * (f64::from(k) / 20.0));
        match *shape {
            Shape::Segment { start, end, .. } => between(start, end).collect(),
            Shape::Arc { center, radius, start, end }
            | Shape::Hollow { center, radius, start, end } => {
                let unit = |p: Vec2| p * (1.0 / p.length());
                between(start, end).map(|p| center + unit(p) * radius).collect()
            }
            Shape::Plane { .. } => Vec::new(),
        }
    }

    #[test]
    fn no_edge_is_nearer_to_the_middle_of_a_mouth_than_its_aisle() {
        let mut wide = 0;
        for name in PRESETS {
            let table = Table::preset(name).expect("a preset");
            for (pocket, mouth) in table.pockets.iter().zip(&table.index.mouths) {
                wide += usize::from(mouth.aisle > 0.0286);
                let edges = table.cushions.iter().filter(|c| c.part != Part::Top);
                for point in edges.flat_map(|c| points(&c.shape)) {
                    for k in 0..=10 {
                        let back = AISLE * pocket.radius * f64::from(k) / 10.0;
                        let middle = pocket.center - pocket.axis * back;
                        let distance = (point - middle).length();
                        assert!(distance >= mouth.aisle, "{name} {:?}: {distance}", pocket.name);
                    }
                }
            }
        }
        // A ball fits into the middle of most mouths, so the aisle saves searches.
        assert!(wide >= 40, "{wide}");
    }
}
