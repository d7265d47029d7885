//! The table: one parametric description, and the geometry that follows from it.
//!
//! A [`TableDescription`] has the dimensions that a maker would give; [`Table::from_description`]
//! computes noses, points, facings, holes and mouths ([`geometry`], [`jaw`]), liners and the tops
//! of the rails ([`opening`]); [`crate::detect`] finds the contacts of a ball with them.

mod bounds;
mod check;
mod coordinates;
mod description;
mod detection_index;
mod dimensions;
mod error;
mod feature;
mod geometry;
mod jaw;
mod opening;
mod place;
mod pocket_kind;
mod presets;
mod sheet;
mod sights;
mod surface;

use alloc::string::String;
use core::ops::{Deref, DerefMut};

use arrayvec::ArrayVec;

pub use description::{
    Markings, PocketDescription, PocketLayout, PocketModel, Sights, Spot, TableDescription,
};
pub use dimensions::Dimension;
pub use error::TableError;
pub use feature::TableFeature;
pub use place::{LIP_OVERHANG, Placement, TOUCH_TOLERANCE};
pub use presets::PRESETS;
pub use sheet::Source;

use crate::math::{Vec2, sqrt};
pub(crate) use bounds::Bounds;
pub(crate) use detection_index::{AISLE, BoundPart, DetectionIndex, Gate, JOIN_OVERLAP};
pub(crate) use surface::UNDER_EDGE;

/// The most parts that the cushions of a table have: six rails, each with a nose and a top, and two jaws
/// per rail. A jaw has a point, a sharp corner, a facing and two parts of the liner.
pub const MAX_PARTS: usize = 6 * (2 + 2 * 5);

/// The most pockets of a table.
pub const MAX_POCKETS: usize = 6;

/// A table: its geometry, and where that comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name of the preset, if the table is an unchanged one.
    pub name: Option<String>,
    /// The description that it was made from; `None` for unbounded cloth.
    pub description: Option<TableDescription>,
    /// Its geometry. A table can be used wherever a geometry can.
    pub geometry: TableGeometry,
}

impl Deref for Table {
    type Target = TableGeometry;

    fn deref(&self) -> &TableGeometry {
        &self.geometry
    }
}

impl DerefMut for Table {
    fn deref_mut(&mut self) -> &mut TableGeometry {
        &mut self.geometry
    }
}

/// A table's geometry, in the engine's coordinates: origin at the centre of the playing area, x
/// along the width, y along the length. Mirrored parts have mirrored bits.
///
/// It is all that a simulation reads of a table. It has no pointers, and every compiler lays it out
/// in the same way, so that its bytes can be copied to a device (docs/gpu.md).
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
pub struct TableGeometry {
    /// Playing area, nose to nose, along x and y, m; infinite for unbounded cloth.
    pub size: Vec2,
    /// Height of the cushion nose above the slate, m.
    pub cushion_height: f64,
    /// All parts, rail by rail, counter-clockwise around the table from the left end of the bottom
    /// rail. The noses, facings and points come first: on each rail facing, point, nose, point,
    /// facing. With the drop-circle model the liners follow: first all straight runs, then all
    /// round walls, two of each per rail. The rails' tops are last.
    pub cushions: ArrayVec<CushionPart, MAX_PARTS>,
    /// Pockets, in the order of their numbers in results: bottom-left, bottom-right, left, right,
    /// top-left, top-right.
    pub pockets: ArrayVec<Pocket, MAX_POCKETS>,
    pub(crate) index: DetectionIndex,
}

/// Distance from the nose line to the centre of a ball on the cloth that touches the nose, m: √(R²
/// − (h − R)²) for a ball of radius `radius` (m) and a nose `cushion_height` (m) above the slate.
/// `None` if the ball cannot touch the nose.
pub fn nose_reach(cushion_height: f64, radius: f64) -> Option<f64> {
    let squared = radius * radius - (cushion_height - radius) * (cushion_height - radius);
    (squared > 0.0).then(|| sqrt(squared))
}

impl TableGeometry {
    /// Distance from a cushion's nose line to the centre of a touching ball, m ([`nose_reach`]). 0
    /// for a ball that the nose cannot touch; a valid shot has none.
    #[inline]
    pub fn reach(&self, radius: f64) -> f64 {
        let above = self.cushion_height - radius;
        sqrt((radius * radius - above * above).max(0.0))
    }

    /// The parts that a ball on the cloth can touch, the first ones of `cushions`.
    pub fn parts_on_cloth(&self) -> &[CushionPart] {
        &self.cushions[..self.index.on_cloth]
    }

    /// Unit vector from the centre of a ball at `position` (m, engine's coordinates) into the
    /// cushion part that it touches, seen from above; zero for a rail's top.
    /// [`Self::contact_normal`] gives the normal in space.
    pub fn normal_at(&self, part: usize, position: Vec2) -> Vec2 {
        match self.cushions[part].shape {
            Shape::Segment { normal, .. } => -normal,
            Shape::Arc { center, .. } => {
                let to_center = center - position;
                to_center * (1.0 / to_center.length())
            }
            Shape::Hollow { center, .. } => {
                let outwards = position - center;
                outwards * (1.0 / outwards.length())
            }
            Shape::Plane { .. } => Vec2::ZERO,
        }
    }
}

/// A rail, or a half of a long rail that has a side pocket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Rail {
    /// y = 0.
    Bottom,
    /// y = length.
    Top,
    /// x = 0, whole.
    Left,
    /// x = width, whole.
    Right,
    /// x = 0 below the side pocket.
    LeftLower,
    /// x = 0 above the side pocket.
    LeftUpper,
    /// x = width below the side pocket.
    RightLower,
    /// x = width above the side pocket.
    RightUpper,
}

impl Rail {
    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bottom => "bottom",
            Self::Top => "top",
            Self::Left => "left",
            Self::Right => "right",
            Self::LeftLower => "left-lower",
            Self::LeftUpper => "left-upper",
            Self::RightLower => "right-lower",
            Self::RightUpper => "right-upper",
        }
    }

    /// The whole rail of which this one may be a half: bottom, top, left or right.
    pub const fn whole(self) -> Self {
        match self {
            Self::Bottom | Self::Top => self,
            Self::Left | Self::LeftLower | Self::LeftUpper => Self::Left,
            Self::Right | Self::RightLower | Self::RightUpper => Self::Right,
        }
    }

    /// The whole rail across the table.
    pub const fn opposite(self) -> Self {
        match self.whole() {
            Self::Bottom => Self::Top,
            Self::Top => Self::Bottom,
            Self::Left => Self::Right,
            _ => Self::Left,
        }
    }

    /// Whether it is a long rail: on the left or the right.
    pub const fn is_long(self) -> bool {
        matches!(self.whole(), Self::Left | Self::Right)
    }
}

/// Part of a cushion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Part {
    /// The straight nose.
    Nose,
    /// The straight side of a pocket's jaw.
    Facing,
    /// The rounded corner between nose and facing.
    Point,
    /// The flat top of the rail, cushion included, at the height of the nose.
    Top,
    /// The wall of a pocket behind the facings: a straight run from the deep end of each facing,
    /// then a round wall around the back of the hole.
    Liner,
}

impl Part {
    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nose => "nose",
            Self::Facing => "facing",
            Self::Point => "point",
            Self::Top => "top",
            Self::Liner => "liner",
        }
    }
}

/// The edge line of a cushion's part, which lies at the height of the nose, or the outline of a
/// rail's top, seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub enum Shape {
    /// A straight piece.
    Segment {
        /// One end, m; of a facing, the end at the point; of a liner's run, the deep end of the
        /// facing.
        start: Vec2,
        /// The other end, m; of a facing, the deep end; of a liner's run, the end on the hole's
        /// circle.
        end: Vec2,
        /// Unit normal towards the playing area.
        normal: Vec2,
    },
    /// A round piece, bulging towards the playing area. It spans less than half a turn.
    Arc {
        /// Centre, m.
        center: Vec2,
        /// Radius, m; 0 for a sharp corner.
        radius: f64,
        /// Unit vector from the centre to the end at the nose.
        start: Vec2,
        /// Unit vector from the centre to the end at the facing.
        end: Vec2,
    },
    /// Half of the round wall of a liner, met from inside. It spans less than half a turn.
    Hollow {
        /// Centre, that of the hole, m.
        center: Vec2,
        /// Radius, that of the hole, m.
        radius: f64,
        /// Unit vector from the centre to the end of the straight run.
        start: Vec2,
        /// Unit vector from the centre along the pocket's axis.
        end: Vec2,
    },
    /// The top of a rail: four corners, m, two on the nose line and two on the border. The openings
    /// of the pockets are cut out of it.
    Plane {
        /// The corners in their order around the outline.
        corners: [Vec2; 4],
    },
}

impl Shape {
    /// A lower bound of the distance (m), in plan view, of the edge from the straight line between
    /// `a` and `b`. Infinite for a rail's top, which has no edge of its own. A wall's is right for
    /// a line that ends at the wall's centre.
    pub(crate) fn distance(&self, a: Vec2, b: Vec2) -> f64 {
        match *self {
            Self::Segment { start, end, .. } => {
                let crosses = |p: Vec2, q: Vec2, r: Vec2, s: Vec2| {
                    ((q - p).cross(r - p) > 0.0) != ((q - p).cross(s - p) > 0.0)
                };
                if crosses(a, b, start, end) && crosses(start, end, a, b) {
                    return 0.0;
                }
                let ends = [
                    distance_from_line(start, a, b),
                    distance_from_line(end, a, b),
                    distance_from_line(a, start, end),
                    distance_from_line(b, start, end),
                ];
                ends.into_iter().fold(f64::INFINITY, f64::min)
            }
            Self::Arc { center, radius, .. } => distance_from_line(center, a, b) - radius,
            Self::Hollow { center, radius, start, .. } => {
                distance_from_line(center + start * radius, a, b).min(radius)
            }
            Self::Plane { .. } => f64::INFINITY,
        }
    }
}

/// Distance (m) of `point` from the straight line between `a` and `b`.
fn distance_from_line(point: Vec2, a: Vec2, b: Vec2) -> f64 {
    let (line, offset) = (b - a, point - a);
    let share = (line.dot(offset) / line.length_squared()).clamp(0.0, 1.0);
    let share = if share.is_nan() { 0.0 } else { share };
    (offset - line * share).length()
}

/// Directions of the two half planes that meet in the span of an arc between the unit vectors
/// `start` and `end`: a quarter turn from `start` towards `end`, and one from `end` towards
/// `start`.
pub(crate) fn arc_sides(start: Vec2, end: Vec2) -> [Vec2; 2] {
    let turn = if start.cross(end) >= 0.0 { 1.0 } else { -1.0 };
    [start.perp() * turn, end.perp() * -turn]
}

/// One piece of a cushion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CushionPart {
    /// The rail it belongs to.
    pub rail: Rail,
    /// The part of the cushion.
    pub part: Part,
    /// Its edge line.
    pub shape: Shape,
}

/// Where a pocket is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum PocketName {
    /// x = 0, y = 0.
    BottomLeft,
    /// x = width, y = 0.
    BottomRight,
    /// Middle of x = 0.
    Left,
    /// Middle of x = width.
    Right,
    /// x = 0, y = length.
    TopLeft,
    /// x = width, y = length.
    TopRight,
}

impl PocketName {
    /// Every pocket.
    pub const ALL: [Self; 6] = [
        Self::BottomLeft,
        Self::BottomRight,
        Self::Left,
        Self::Right,
        Self::TopLeft,
        Self::TopRight,
    ];

    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::BottomLeft => "bottom-left",
            Self::BottomRight => "bottom-right",
            Self::Left => "left",
            Self::Right => "right",
            Self::TopLeft => "top-left",
            Self::TopRight => "top-right",
        }
    }
}

/// The condition for a ball to be pocketed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub enum Capture {
    /// The centre comes over the hole.
    DropCircle,
    /// The centre crosses the mouth, away from the table's centre (Leckie & Greenspan 2006,
    /// section 2.2).
    MouthLine {
        /// One end of the mouth, m.
        start: Vec2,
        /// The other end, m.
        end: Vec2,
    },
}

/// A pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Pocket {
    /// Its name.
    pub name: PocketName,
    /// Centre of the hole in the slate, m.
    pub center: Vec2,
    /// Radius of the hole in the slate, m.
    pub radius: f64,
    /// When it captures a ball.
    pub capture: Capture,
    /// Unit vector along the pocket's axis, away from the table.
    pub axis: Vec2,
    /// The tips of its jaws, m.
    pub mouth: [Vec2; 2],
    /// The deep ends of its facings, m.
    pub throat: [Vec2; 2],
}
