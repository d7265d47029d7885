//! The table: one parametric description, and the geometry that follows from it.

mod frame;
mod normal_stub;

use alloc::string::String;
use alloc::vec::Vec;

use crate::math::Vec2;

/// A table's geometry, in the engine's frame: origin at the centre of the playing area, x along
/// the width, y along the length.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Preset's name, if it is one unchanged.
    pub name: Option<String>,
    /// Playing area, nose to nose, along x and y, m; infinite for unbounded cloth.
    pub size: Vec2,
    /// Height of the cushion nose above the slate, m.
    pub cushion_height: f64,
    /// Noses, facings and points.
    pub cushions: Vec<CushionPart>,
    /// Pockets, in the order that results number them.
    pub pockets: Vec<Pocket>,
}

/// A rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
}

/// Part of a cushion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// The straight nose.
    Nose,
    /// The straight side of a pocket's jaw.
    Facing,
    /// The round horn between nose and facing.
    Point,
}

impl Part {
    /// The name used in traces.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nose => "nose",
            Self::Facing => "facing",
            Self::Point => "point",
        }
    }
}

/// The line of a cushion's nose, seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A straight piece.
    Segment {
        /// One end, m.
        start: Vec2,
        /// The other end, m.
        end: Vec2,
        /// Unit normal towards the playing area.
        normal: Vec2,
    },
    /// A round piece, bulging towards the playing area.
    Arc {
        /// Centre, m.
        center: Vec2,
        /// Radius, m.
        radius: f64,
    },
}

/// One piece of a cushion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CushionPart {
    /// The rail it belongs to.
    pub rail: Rail,
    /// Which part of it.
    pub part: Part,
    /// Its nose line.
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

/// When a ball counts as pocketed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Capture {
    /// Its centre comes over the hole.
    DropCircle,
    /// Its centre crosses the mouth, away from the table's centre (Leckie & Greenspan 2006,
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
pub struct Pocket {
    /// Which.
    pub name: PocketName,
    /// Centre of the hole in the slate, m.
    pub center: Vec2,
    /// Radius of the hole in the slate, m.
    pub radius: f64,
    /// What captures a ball.
    pub capture: Capture,
}
