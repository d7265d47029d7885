//! What detection needs of a table's geometry: where to look for what.

use alloc::vec::Vec;

use super::bounds::{Bounds, Quadrants};
use super::opening::Openings;
use super::{CushionPart, Part, Pocket};
use crate::math::Vec2;

/// By how much a straight part is taken to be longer at either end, m: 1 nm, ten million roundings of a
/// position. It shows beside a round neighbour by (1 nm)²/2δ ≈ 2e-17 m, less than one rounding.
pub(crate) const JOIN_OVERLAP: f64 = 1e-9;

/// What of the geometry only detection needs.
#[derive(Clone, Debug, PartialEq)]
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
    pub(crate) mouths: Vec<Mouth>,
    /// For balls of at least this reach, m, nothing but noses is met inside the rectangle that is
    /// `reach` smaller than the playing area on every side.
    pub(crate) clear_reach: f64,
    /// Half the table up to the outer edge of its rails, m.
    pub(crate) border: Vec2,
    /// How many parts, from the first on, a ball on the cloth can meet.
    pub(crate) on_cloth: usize,
    /// Indices of the rails' tops, in the order of `noses`.
    pub(crate) tops: [u16; 6],
    /// The openings of the pockets; none where there are none.
    pub(crate) openings: Option<Openings>,
    /// Boxes around the cushions' parts, in their order.
    pub(crate) bounds: Vec<Bounds>,
    /// Where the noses and where the mouths are.
    pub(crate) nose_quadrants: Quadrants,
    pub(crate) mouth_quadrants: Quadrants,
}

/// A pocket's features, for detection.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mouth {
    /// Indices of the cushion parts that make it, both neighbouring noses included.
    pub(crate) parts: Vec<u16>,
    /// The line that captures.
    pub(crate) gate: Gate,
    /// Seen from the hole's centre the liner's round wall stands where the cosine to the pocket's axis is
    /// greater than this.
    pub(crate) liner_from: f64,
    /// All its points, facings and liners, what a flying ball can meet: index and box.
    pub(crate) all: Vec<(u16, Bounds)>,
    /// A box around them and the hole.
    pub(crate) bounds: Bounds,
}

/// A line across a pocket; a ball on the cloth that crosses it outwards is captured. With the drop-circle
/// model it lies over the hole and bounds the search: no centre comes to it but over the hole.
///
/// A centre p is beyond when axis·p ≥ offset + lean·reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gate {
    /// Where it meets the pocket's axis, measured along the axis from the table's centre, m.
    pub(crate) offset: f64,
    /// How much nearer or further it is for a ball of some reach: the centre of a ball that touches the
    /// deep end of a facing stands a reach off it, along the facing's normal.
    pub(crate) lean: f64,
    /// Half its width, m. It ends inside the rubber.
    pub(crate) half_width: f64,
}

impl DetectionIndex {
    /// Gives the parts their boxes, every point, facing and liner to its pocket, and the mouths theirs.
    pub(super) fn bound_parts(&mut self, cushions: &[CushionPart], pockets: &[Pocket]) {
        // Straight parts are longer by the overlap at their joins.
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
                self.mouths[k].all.push((i as u16, *bounds));
                self.mouths[k].bounds = self.mouths[k].bounds.with(bounds);
            }
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
