//! The `marks` of a shot file: lines, arrows, circles, areas and labels drawn on the table. They change nothing
//! in the shot; programs show them over the cloth.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::node::{Node, word_of};
use super::read::At;
use crate::error::{Error, ErrorKind};
use crate::range::Range;

/// The most marks of a shot. It bounds the size of a file, and what a program draws in a picture.
pub const MOST_MARKS: usize = 100;

/// The corners of an area.
const CORNERS: core::ops::RangeInclusive<usize> = 3..=64;

/// The most characters of a label: one short line on a table.
const LONGEST_LABEL: usize = 40;

const PLACE: Range = Range::any(" m");
const RADIUS: Range = Range::positive(" m");

const COLORS: &[(&str, MarkColor)] = &[
    ("white", MarkColor::White),
    ("yellow", MarkColor::Yellow),
    ("red", MarkColor::Red),
    ("blue", MarkColor::Blue),
];

/// What the user has drawn on the table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableMark {
    /// Form and place.
    pub shape: MarkShape,
    /// Colour.
    pub color: MarkColor,
}

/// Form and place of a mark; x and y (m) in the coordinates of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum MarkShape {
    /// A line between two places.
    Line([[f64; 2]; 2]),
    /// A line with a head at its second place.
    Arrow([[f64; 2]; 2]),
    /// A circle.
    Circle {
        /// Its centre.
        center: [f64; 2],
        /// Its radius, m.
        radius: f64,
    },
    /// A polygon of 3 to 64 corners.
    Area(Vec<[f64; 2]>),
    /// A short text, centred at a place.
    Label {
        /// Its middle.
        at: [f64; 2],
        /// 1 to 40 characters in one line.
        text: String,
    },
}

/// The colours of marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say everything")]
pub enum MarkColor {
    White,
    Yellow,
    Red,
    Blue,
}

/// Reads `marks`.
pub(super) fn read(at: &At<'_>) -> Result<Vec<TableMark>, Error> {
    let items = at.items("a list of marks")?;
    if items.len() > MOST_MARKS {
        let what = format!("found {} marks", items.len());
        let remedy = format!("write at most {MOST_MARKS}");
        return Err(at
            .refuse(ErrorKind::WrongCount, what, remedy)
            .with("count", items.len() as f64));
    }
    items.iter().map(mark).collect()
}

fn mark(at: &At<'_>) -> Result<TableMark, Error> {
    let known = at.known_fields()?;
    let kind = known.require("kind", "the kind of the mark")?.choice("kind of mark", KINDS)?;
    let fields = at.fields(kind.keys())?;
    let place = |key| place(&fields.require(key, "[x, y] in m")?);
    let shape = match kind {
        Kind::Line => MarkShape::Line([place("from")?, place("to")?]),
        Kind::Arrow => MarkShape::Arrow([place("from")?, place("to")?]),
        Kind::Circle => {
            let radius = fields.require("radius", "the radius in m")?.number(&RADIUS)?;
            MarkShape::Circle { center: place("center")?, radius }
        }
        Kind::Area => MarkShape::Area(outline(&fields.require("outline", "a list of [x, y]")?)?),
        Kind::Label => {
            let text = label(&fields.require("text", "a short text")?)?;
            MarkShape::Label { at: place("at")?, text }
        }
    };
    let color = fields.require("color", "the name of a colour")?.choice("colour", COLORS)?;
    Ok(TableMark { shape, color })
}

#[derive(Clone, Copy)]
enum Kind {
    Line,
    Arrow,
    Circle,
    Area,
    Label,
}

const KINDS: &[(&str, Kind)] = &[
    ("line", Kind::Line),
    ("arrow", Kind::Arrow),
    ("circle", Kind::Circle),
    ("area", Kind::Area),
    ("label", Kind::Label),
];

impl Kind {
    const fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Line | Self::Arrow => &["kind", "color", "from", "to"],
            Self::Circle => &["kind", "color", "center", "radius"],
            Self::Area => &["kind", "color", "outline"],
            Self::Label => &["kind", "color", "at", "text"],
        }
    }
}

fn place(at: &At<'_>) -> Result<[f64; 2], Error> {
    let numbers = at.numbers_in(2, 2, &PLACE)?;
    Ok([numbers[0], numbers[1]])
}

fn outline(at: &At<'_>) -> Result<Vec<[f64; 2]>, Error> {
    let corners = at.items("a list of [x, y]")?;
    if !CORNERS.contains(&corners.len()) {
        let what = format!("found {} corners", corners.len());
        let remedy = format!("write {} to {}", CORNERS.start(), CORNERS.end());
        return Err(at
            .refuse(ErrorKind::WrongCount, what, remedy)
            .with("count", corners.len() as f64));
    }
    corners.iter().map(place).collect()
}

fn label(at: &At<'_>) -> Result<String, Error> {
    let text = at.text("a short text")?;
    let length = text.chars().count();
    if !(1..=LONGEST_LABEL).contains(&length) {
        let what = format!("found {length} characters");
        let remedy = format!("write 1 to {LONGEST_LABEL}");
        return Err(at.refuse(ErrorKind::WrongCount, what, remedy).with("count", length as f64));
    }
    if text.chars().any(char::is_control) {
        let what = "the text has a control character";
        return Err(at.refuse(ErrorKind::WrongType, what, "write one line of text"));
    }
    Ok(text.into())
}

/// `marks` as a shot file has them.
pub(super) fn write(marks: &[TableMark]) -> Node {
    Node::list(marks.iter().map(|TableMark { shape, color }| {
        let list = |place: &[f64; 2]| Node::list(*place);
        let color = word_of(COLORS, *color);
        let of = |kind: &str, fields: [(&str, Node); 2]| {
            let [first, second] = fields;
            Node::object([("kind", kind.into()), ("color", color.clone()), first, second])
        };
        match shape {
            MarkShape::Line([from, to]) => of("line", [("from", list(from)), ("to", list(to))]),
            MarkShape::Arrow([from, to]) => of("arrow", [("from", list(from)), ("to", list(to))]),
            MarkShape::Circle { center, radius } => {
                of("circle", [("center", list(center)), ("radius", (*radius).into())])
            }
            MarkShape::Area(corners) => Node::object([
                ("kind", "area".into()),
                ("color", color.clone()),
                ("outline", Node::list(corners.iter().map(list))),
            ]),
            MarkShape::Label { at, text } => {
                of("label", [("at", list(at)), ("text", text.as_str().into())])
            }
        }
    }))
}
