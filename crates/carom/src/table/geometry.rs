//! From a description to noses, points, facings, mouths and holes.
//!
//! Everything is built once, in the quadrant x ≤ 0, y ≤ 0, and mirrored by negation, so that a
//! mirrored table has mirrored bits. [`super::jaw`] builds the jaws, and [`super::opening`] builds
//! the parts behind their deep ends.

use alloc::vec::Vec;
use core::f64::consts::FRAC_1_SQRT_2;

use arrayvec::ArrayVec;

use super::bounds::Quadrants;
use super::detection_index::Mouth;
use super::jaw::{Jaw, RailFrame, hole_center, jaw, tangent_length};
use super::opening::{Back, Liner, Openings, liner};
use super::pocket_kind::PocketKind;
use super::{
    Bounds, Capture, CushionPart, DetectionIndex, Gate, Part, Pocket, PocketDescription,
    PocketLayout, PocketModel, PocketName, Rail, Shape, Table, TableDescription, TableError,
    TableGeometry, check,
};
use crate::math::Vec2;

/// A jaw of the quadrant, or something that belongs to it, and how it is mirrored into another
/// quadrant.
#[derive(Clone, Copy)]
struct Mirrored<T> {
    jaw: T,
    /// Signs of x and y.
    signs: Vec2,
    /// Index of its pocket.
    pocket: usize,
    /// Number of the jaw in its pocket, 0 or 1; the same for mirrored jaws.
    slot: usize,
}

/// The six rails around the table, each with its first and its last jaw. The arguments are the jaws
/// of a short rail, of a long rail at a corner, and of a long rail at a side pocket.
fn rails_with_jaws<T: Copy>([bottom, left, side]: [T; 3]) -> [(Rail, Mirrored<T>, Mirrored<T>); 6] {
    let at = |jaw, x, y, pocket, slot| Mirrored { jaw, signs: Vec2::new(x, y), pocket, slot };
    [
        (Rail::Bottom, at(bottom, 1.0, 1.0, 0, 0), at(bottom, -1.0, 1.0, 1, 0)),
        (Rail::RightLower, at(left, -1.0, 1.0, 1, 1), at(side, -1.0, 1.0, 3, 0)),
        (Rail::RightUpper, at(side, -1.0, -1.0, 3, 1), at(left, -1.0, -1.0, 5, 1)),
        (Rail::Top, at(bottom, -1.0, -1.0, 5, 0), at(bottom, 1.0, -1.0, 4, 0)),
        (Rail::LeftUpper, at(left, 1.0, -1.0, 4, 1), at(side, 1.0, -1.0, 2, 1)),
        (Rail::LeftLower, at(side, 1.0, 1.0, 2, 0), at(left, 1.0, 1.0, 0, 1)),
    ]
}

/// The places of the rails of [`rails_with_jaws`] in `DetectionIndex::noses`.
const RAIL_PLACES: [usize; 6] = [0, 4, 5, 1, 3, 2];

/// The back of a pocket of the quadrant.
struct PocketBack {
    /// A point on the line of the first jaw, m. The line from it to its mirror image lies over the
    /// hole; with the mouth-line model it ends the opening.
    end: Vec2,
    /// Centre and radius of the hole, m; `None` with the mouth-line model.
    hole: Option<(Vec2, f64)>,
    /// See [`Mouth::liner_from`].
    liner_from: f64,
}

impl PocketBack {
    /// The back with the mouth-line model: the opening ends between the deep ends.
    fn at(jaw: &Jaw) -> Self {
        Self { end: jaw.deep, hole: None, liner_from: 1.0 }
    }

    fn of_opening(&self, kind: PocketKind) -> Back {
        let (center, radius) = self.hole.unwrap_or((self.end, 0.0));
        Back { axis: kind.axis(), straight: kind.axis().dot(self.end), center, radius }
    }
}

impl Table {
    /// Unbounded cloth without rails. The engine's coordinates is the file's.
    pub fn unbounded() -> Self {
        let size = Vec2::new(f64::INFINITY, f64::INFINITY);
        let geometry = TableGeometry {
            size,
            cushion_height: 0.0,
            cushions: ArrayVec::new(),
            pockets: ArrayVec::new(),
            index: DetectionIndex {
                half: size,
                nose_x: f64::INFINITY,
                nose_y: [0.0, f64::INFINITY],
                noses: [0; 6],
                mouths: ArrayVec::new(),
                clear_reach: 0.0,
                border: size,
                on_cloth: 0,
                tops: [0; 6],
                openings: ArrayVec::new(),
                bounds: ArrayVec::new(),
                nose_quadrants: Quadrants::default(),
                mouth_quadrants: Quadrants::default(),
            },
        };
        Self { name: None, description: None, geometry }
    }

    /// The table that `description` describes.
    ///
    /// # Errors
    /// [`TableError`] with the key and the remedy, for a length that is not finite and positive, a
    /// missing pocket, jaws, mouths and holes that do not fit together, or rails that are too
    /// narrow for the holes.
    pub fn from_description(description: &TableDescription) -> Result<Self, TableError> {
        check::lengths(description)?;
        let half = Vec2::new(0.5 * description.width, 0.5 * description.length);
        let mut table = Self { description: Some(description.clone()), ..Self::unbounded() };
        let geometry = &mut table.geometry;
        geometry.size = Vec2::new(description.width, description.length);
        geometry.cushion_height = description.cushion_height;
        geometry.index.half = half;
        let rail = Vec2::new(description.rail_width, description.rail_width);
        geometry.index.border = half + rail;
        match description.pockets {
            PocketLayout::None => geometry.add_plain_rails(half),
            PocketLayout::Six => geometry.add_rails_and_pockets(half, description)?,
        }
        geometry.add_tops();
        geometry.index.bound_parts(&geometry.cushions, &geometry.pockets);
        Ok(table)
    }
}

impl TableGeometry {
    fn add_plain_rails(&mut self, half: Vec2) {
        let Vec2 { x, y } = half;
        let corners = [Vec2::new(-x, -y), Vec2::new(x, -y), Vec2::new(x, y), Vec2::new(-x, y)];
        for (i, rail) in [Rail::Bottom, Rail::Right, Rail::Top, Rail::Left].into_iter().enumerate()
        {
            self.cushions.push(nose(rail, corners[i], corners[(i + 1) % 4]));
        }
        self.index.nose_x = x;
        self.index.nose_y = [0.0, y];
        self.index.noses = [0, 2, 3, 3, 1, 1];
        self.index.on_cloth = self.cushions.len();
    }

    fn add_rails_and_pockets(
        &mut self,
        half: Vec2,
        description: &TableDescription,
    ) -> Result<(), TableError> {
        let corner = check::pocket(&description.corner_pocket, PocketKind::Corner)?;
        let side = check::pocket(&description.side_pocket, PocketKind::Side)?;
        let rubber = description.cushion_width;
        let (right, up) = (Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0));
        let bottom = RailFrame { origin: -half, along: right, behind: -up };
        let left = RailFrame { origin: -half, along: up, behind: -right };
        let below_side = RailFrame { origin: Vec2::new(-half.x, 0.0), along: -up, behind: -right };
        let at_bottom = jaw(corner, PocketKind::Corner, rubber, bottom)?;
        let at_left = jaw(corner, PocketKind::Corner, rubber, left)?;
        let at_side = jaw(side, PocketKind::Side, rubber, below_side)?;

        self.index.nose_x = half.x - at_bottom.nose_start;
        self.index.nose_y = [at_side.nose_start, half.y - at_left.nose_start];
        check::noses(self.index.nose_x, self.index.nose_y)?;
        let jaws = [&at_bottom, &at_left, &at_side];
        let mut in_mouth = self.add_rails(jaws);
        self.index.on_cloth = self.cushions.len();
        let model = description.pocket_model;
        let backs = match model {
            PocketModel::DropCircle => self.add_backs(jaws, [corner, side], &mut in_mouth)?,
            PocketModel::MouthLine => [PocketBack::at(&at_bottom), PocketBack::at(&at_side)],
        };
        self.index.openings.push(Openings::new(
            jaws,
            [backs[0].of_opening(PocketKind::Corner), backs[1].of_opening(PocketKind::Side)],
        ));
        let corner_jaws = [&at_bottom, &at_left];
        self.add_pockets(model, [corner, side], corner_jaws, &at_side, backs, in_mouth);
        self.index.clear_reach = clear_reach(model, corner, side, &at_bottom);
        check::holes(&self.pockets)?;
        check::rails(self.index.border, half, &self.pockets)
    }

    /// Adds the liners, which close the pockets behind the deep ends of their jaws. Returns the
    /// backs of a corner and of a side pocket.
    fn add_backs(
        &mut self,
        [bottom, left, side]: [&Jaw; 3],
        [corner_shape, side_shape]: [&PocketDescription; 2],
        in_mouth: &mut [Vec<u16>; 6],
    ) -> Result<[PocketBack; 2], TableError> {
        let half = self.index.half;
        let (at_corner, at_side) = (PocketKind::Corner, PocketKind::Side);
        let corner_hole = hole_center(corner_shape, at_corner, half);
        let side_hole = hole_center(side_shape, at_side, half);
        let liners = [
            liner(bottom, corner_shape, corner_hole, at_corner.axis())?,
            liner(left, corner_shape, corner_hole, at_corner.axis())?,
            liner(side, side_shape, side_hole, at_side.axis())?,
        ];
        self.add_liners(&liners, in_mouth);
        let back = |liner: &Liner, kind: PocketKind, center, radius| PocketBack {
            end: liner.over_hole,
            hole: Some((center, radius)),
            liner_from: liner.start_cosine(kind.axis()),
        };
        Ok([
            back(&liners[0], at_corner, corner_hole, corner_shape.hole_radius),
            back(&liners[2], at_side, side_hole, side_shape.hole_radius),
        ])
    }

    /// Adds all cushion parts; returns the indices of those that make each pocket's mouth.
    fn add_rails(&mut self, jaws: [&Jaw; 3]) -> [Vec<u16>; 6] {
        let rails = rails_with_jaws(jaws);
        let mut jaws: [[Vec<u16>; 2]; 6] = Default::default();
        for ((rail, first, last), place) in rails.into_iter().zip(RAIL_PLACES) {
            let first_indices = self.add_jaw(rail, first, true);
            let nose_index = self.cushions.len() as u16;
            let [start, end] =
                [first, last].map(|placed| scaled(placed.jaw.nose_end, placed.signs));
            self.cushions.push(nose(rail, start, end));
            self.index.noses[place] = nose_index;
            let last_indices = self.add_jaw(rail, last, false);
            for (placed, indices) in [(first, first_indices), (last, last_indices)] {
                let list = &mut jaws[placed.pocket][placed.slot];
                list.extend(indices);
                list.push(nose_index);
            }
        }
        jaws.map(|slots| slots.concat())
    }

    /// Adds a jaw's parts, from the deep end to the nose or the other way round. Returns their
    /// indices, that of the point first.
    fn add_jaw(&mut self, rail: Rail, placed: Mirrored<&Jaw>, from_deep_end: bool) -> Vec<u16> {
        let begin = self.cushions.len() as u16;
        let mut parts: Vec<CushionPart> = placed
            .jaw
            .parts
            .iter()
            .map(|&(part, shape)| CushionPart { rail, part, shape: mirrored(shape, placed.signs) })
            .collect();
        if from_deep_end {
            parts.reverse();
        }
        self.cushions.extend(parts);
        let indices = begin..self.cushions.len() as u16;
        if from_deep_end { indices.rev().collect() } else { indices.collect() }
    }

    /// Adds the liners: first the straight runs, then the walls. A run that a ball on the cloth can
    /// touch is added to the parts of its mouth.
    fn add_liners(&mut self, [bottom, left, side]: &[Liner; 3], in_mouth: &mut [Vec<u16>; 6]) {
        let rails = rails_with_jaws([bottom, left, side]);
        let each = rails.iter().flat_map(|(rail, first, last)| [(*rail, first), (*rail, last)]);
        for (rail, placed) in each.clone() {
            if placed.jaw.exposed {
                in_mouth[placed.pocket].push(self.cushions.len() as u16);
            }
            let shape = mirrored(placed.jaw.run, placed.signs);
            self.cushions.push(CushionPart { rail, part: Part::Liner, shape });
        }
        if [bottom, left, side].iter().any(|liner| liner.exposed) {
            self.index.on_cloth = self.cushions.len();
        }
        for (rail, placed) in each {
            let shape = mirrored(placed.jaw.wall, placed.signs);
            self.cushions.push(CushionPart { rail, part: Part::Liner, shape });
        }
    }

    /// Adds the tops of the rails, mitred at the corners.
    fn add_tops(&mut self) {
        let DetectionIndex { half, border, .. } = self.index;
        let mut add = |rail, places: &[usize], ends: [Vec2; 2]| {
            for &place in places {
                self.index.tops[place] = self.cushions.len() as u16;
            }
            // From the nose line out to the border.
            let on = |size: Vec2| ends.map(|end| scaled(size, end));
            let ([a, b], [c, d]) = (on(half), on(border));
            let shape = Shape::Plane { corners: [a, b, d, c] };
            self.cushions.push(CushionPart { rail, part: Part::Top, shape });
        };
        let end = Vec2::new;
        add(Rail::Bottom, &[0], [end(-1.0, -1.0), end(1.0, -1.0)]);
        if self.pockets.is_empty() {
            add(Rail::Right, &[4, 5], [end(1.0, -1.0), end(1.0, 1.0)]);
        } else {
            add(Rail::RightLower, &[4], [end(1.0, -1.0), end(1.0, 0.0)]);
            add(Rail::RightUpper, &[5], [end(1.0, 0.0), end(1.0, 1.0)]);
        }
        add(Rail::Top, &[1], [end(1.0, 1.0), end(-1.0, 1.0)]);
        if self.pockets.is_empty() {
            add(Rail::Left, &[2, 3], [end(-1.0, 1.0), end(-1.0, -1.0)]);
        } else {
            add(Rail::LeftUpper, &[3], [end(-1.0, 1.0), end(-1.0, 0.0)]);
            add(Rail::LeftLower, &[2], [end(-1.0, 0.0), end(-1.0, -1.0)]);
        }
    }

    fn add_pockets(
        &mut self,
        model: PocketModel,
        [corner, side]: [&PocketDescription; 2],
        [bottom_jaw, left_jaw]: [&Jaw; 2],
        side_jaw: &Jaw,
        backs: [PocketBack; 2],
        in_mouth: [Vec<u16>; 6],
    ) {
        let half = self.index.half;
        let pockets = [
            (PocketName::BottomLeft, 1.0, 1.0, PocketKind::Corner),
            (PocketName::BottomRight, -1.0, 1.0, PocketKind::Corner),
            (PocketName::Left, 1.0, 1.0, PocketKind::Side),
            (PocketName::Right, -1.0, 1.0, PocketKind::Side),
            (PocketName::TopLeft, 1.0, -1.0, PocketKind::Corner),
            (PocketName::TopRight, -1.0, -1.0, PocketKind::Corner),
        ];
        for ((name, sx, sy, kind), parts) in pockets.into_iter().zip(in_mouth) {
            let signs = Vec2::new(sx, sy);
            // Tips and deep ends of both jaws; the upper jaw of a side pocket mirrors the lower
            // one.
            let (shape, jaw, ends, back) = match kind {
                PocketKind::Corner => {
                    (corner, bottom_jaw, [left_jaw.tip, left_jaw.deep], &backs[0])
                }
                PocketKind::Side => {
                    let up = Vec2::new(1.0, -1.0);
                    (
                        side,
                        side_jaw,
                        [scaled(side_jaw.tip, up), scaled(side_jaw.deep, up)],
                        &backs[1],
                    )
                }
            };
            let (axis, middle) = (kind.axis(), kind.middle(half));
            let mouth = [jaw.tip, ends[0]].map(|p| scaled(p, signs));
            let throat = [jaw.deep, ends[1]].map(|p| scaled(p, signs));
            let gate = match model {
                PocketModel::DropCircle => Gate {
                    offset: axis.dot(back.end),
                    lean: axis.dot(jaw.facing_normal),
                    half_width: axis.cross(back.end - middle).abs(),
                },
                PocketModel::MouthLine => Gate {
                    offset: axis.dot(jaw.tip),
                    lean: 0.0,
                    // The line continues into the rounded point.
                    half_width: axis.cross(jaw.tip - middle).abs() + tangent_length(shape),
                },
            };
            self.pockets.push(Pocket {
                name,
                center: scaled(hole_center(shape, kind, half), signs),
                radius: shape.hole_radius,
                capture: match model {
                    PocketModel::DropCircle => Capture::DropCircle,
                    PocketModel::MouthLine => Capture::MouthLine { start: mouth[0], end: mouth[1] },
                },
                axis: scaled(axis, signs),
                mouth,
                throat,
            });
            let bounds = Bounds::of([mouth[0]]);
            let (liner_from, all) = (back.liner_from, ArrayVec::new());
            let parts = parts.into_iter().collect();
            self.index.mouths.push(Mouth { parts, gate, liner_from, all, bounds, aisle: 0.0 });
        }
    }
}

fn scaled(p: Vec2, signs: Vec2) -> Vec2 {
    Vec2::new(p.x * signs.x, p.y * signs.y)
}

fn mirrored(shape: Shape, signs: Vec2) -> Shape {
    match shape {
        Shape::Segment { start, end, normal } => Shape::Segment {
            start: scaled(start, signs),
            end: scaled(end, signs),
            normal: scaled(normal, signs),
        },
        Shape::Arc { center, radius, start, end } => Shape::Arc {
            center: scaled(center, signs),
            radius,
            start: scaled(start, signs),
            end: scaled(end, signs),
        },
        Shape::Hollow { center, radius, start, end } => Shape::Hollow {
            center: scaled(center, signs),
            radius,
            start: scaled(start, signs),
            end: scaled(end, signs),
        },
        Shape::Plane { corners } => Shape::Plane { corners: corners.map(|p| scaled(p, signs)) },
    }
}

fn nose(rail: Rail, start: Vec2, end: Vec2) -> CushionPart {
    let normal = match rail {
        Rail::Bottom => Vec2::new(0.0, 1.0),
        Rail::Top => Vec2::new(0.0, -1.0),
        Rail::Left | Rail::LeftLower | Rail::LeftUpper => Vec2::new(1.0, 0.0),
        Rail::Right | Rail::RightLower | Rail::RightUpper => Vec2::new(-1.0, 0.0),
    };
    CushionPart { rail, part: Part::Nose, shape: Shape::Segment { start, end, normal } }
}

/// The least reach, m, for which no hole and no gate lies in the playing area made smaller by that
/// reach on every side.
fn clear_reach(
    model: PocketModel,
    corner: &PocketDescription,
    side: &PocketDescription,
    bottom: &Jaw,
) -> f64 {
    let inwards = Vec2::new(FRAC_1_SQRT_2, FRAC_1_SQRT_2);
    // Distances in front of the corner along the diagonal; the smaller area's corner is at
    // √2·reach.
    let at_corner = match model {
        PocketModel::MouthLine => 0.5 * corner.mouth * FRAC_1_SQRT_2,
        PocketModel::DropCircle => {
            let [along, behind] = bottom.deep_in_rail;
            let gate = (along - behind) * FRAC_1_SQRT_2;
            let lean = inwards.dot(bottom.facing_normal);
            let hole = (0.5 * corner.mouth - corner.shelf) * FRAC_1_SQRT_2;
            hole.max(gate / (core::f64::consts::SQRT_2 - lean))
        }
    };
    let at_side = match model {
        PocketModel::MouthLine => 0.0,
        PocketModel::DropCircle => -side.shelf,
    };
    at_corner.max(at_side).max(0.0)
}
