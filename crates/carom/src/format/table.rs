//! The `table` of a shot file: a preset's name, or an object that may be based on one.

use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::node::{Node, word_of};
use super::read::{At, Fields};
use crate::edition;
use crate::error::{Error, ErrorKind};
use crate::range::Range;
use crate::table::{
    Markings, PocketDescription, PocketLayout, PocketModel, Sights, Spot, Table, TableDescription,
    TableError,
};

/// The physics that belongs to unbounded cloth.
pub(super) const UNBOUNDED_PHYSICS: &str = "pool";

const LENGTH: Range = Range::positive(" m");
const OPEN_LENGTH: Range = Range::not_negative(" m");
const ANYWHERE: Range = Range::any(" m");
/// Angle inside the rubber between nose and facing.
const CUT_ANGLE: Range = Range::half_open(90.0, 180.0, " degrees");

const KEYS: &[&str] = &[
    "base",
    "cloth",
    "length",
    "width",
    "cushion_height",
    "cushion_width",
    "rail_width",
    "pockets",
    "pocket_model",
    "corner_pocket",
    "side_pocket",
    "sights",
    "markings",
    "physics",
];

const POCKET_LAYOUTS: &[(&str, PocketLayout)] =
    &[("none", PocketLayout::None), ("six", PocketLayout::Six)];

const POCKET_MODELS: &[(&str, PocketModel)] =
    &[("drop-circle", PocketModel::DropCircle), ("mouth-line", PocketModel::MouthLine)];

/// Reads `table`; also the name of the physics preset that belongs to it.
pub(super) fn read(at: &At<'_>) -> Result<(Arc<Table>, String), Error> {
    if !at.is_object() {
        let name = at.text("a table preset's name, or an object {...}")?;
        let table = Table::shared_preset(name).ok_or_else(|| unknown_preset(at, name))?;
        let physics = table.description.as_ref().map_or(UNBOUNDED_PHYSICS, |d| &d.physics).into();
        return Ok((table, physics));
    }
    let fields = at.fields(KEYS)?;
    if let Some(cloth) = fields.get("cloth") {
        return unbounded(&fields, &cloth);
    }
    let description = match fields.get("base") {
        Some(at) => changed(&fields, base(&at)?)?,
        None => {
            let side = |key| {
                fields
                    .require(key, "the length in m, or start from a preset with \"base\"")?
                    .number(&LENGTH)
            };
            changed(&fields, TableDescription::rectangle(side("width")?, side("length")?))?
        }
    };
    build(at, description)
}

fn build(at: &At<'_>, description: TableDescription) -> Result<(Arc<Table>, String), Error> {
    let physics = description.physics.clone();
    let table = Table::from_description(&description).map_err(|TableError { key, problem }| {
        ErrorKind::WrongTable.at(format!("{}.{key}", at.place()), problem, "")
    })?;
    Ok((table.into(), physics))
}

fn unbounded(fields: &Fields<'_>, cloth: &At<'_>) -> Result<(Arc<Table>, String), Error> {
    cloth.choice("cloth", &[("unbounded", ())])?;
    if let Some(key) = KEYS.iter().find(|&&key| key != "cloth" && fields.get(key).is_some()) {
        return Err(fields.get(key).unwrap_or_else(|| cloth.clone()).refuse(
            ErrorKind::Conflict,
            "unbounded cloth has no sides, rails or pockets",
            "leave the key out, or leave `cloth` out",
        ));
    }
    Ok((Table::unbounded().into(), UNBOUNDED_PHYSICS.into()))
}

fn base(at: &At<'_>) -> Result<TableDescription, Error> {
    let name = at.text("a table preset's name")?;
    TableDescription::preset(name).ok_or_else(|| unknown_preset(at, name))
}

fn unknown_preset(at: &At<'_>, name: &str) -> Error {
    at.unknown_word(name, "table preset", &edition::names(edition::TABLES))
}

/// `d` changed by `fields`.
fn changed(fields: &Fields<'_>, mut d: TableDescription) -> Result<TableDescription, Error> {
    fields.number_into("length", &LENGTH, &mut d.length)?;
    fields.number_into("width", &LENGTH, &mut d.width)?;
    fields.number_into("cushion_height", &LENGTH, &mut d.cushion_height)?;
    fields.number_into("cushion_width", &LENGTH, &mut d.cushion_width)?;
    fields.number_into("rail_width", &LENGTH, &mut d.rail_width)?;
    if let Some(at) = fields.get("pockets") {
        d.pockets = at.choice("pocket layout", POCKET_LAYOUTS)?;
    }
    if let Some(at) = fields.get("pocket_model") {
        d.pocket_model = at.choice("pocket model", POCKET_MODELS)?;
    }
    if let Some(at) = fields.get("corner_pocket") {
        d.corner_pocket = Some(pocket(&at, d.corner_pocket)?);
    }
    if let Some(at) = fields.get("side_pocket") {
        d.side_pocket = Some(pocket(&at, d.side_pocket)?);
    }
    if let Some(at) = fields.get("sights") {
        d.sights = Some(sights(&at)?);
    }
    if let Some(at) = fields.get("markings") {
        d.markings = markings(&at)?;
    }
    if let Some(at) = fields.get("physics") {
        let name = at.text("a physics preset's name")?;
        let known = || edition::names(edition::PHYSICS);
        d.physics = edition::current_physics_name(name)
            .ok_or_else(|| at.unknown_word(name, "physics preset", &known()))?
            .into();
    }
    Ok(d)
}

/// A pocket: `base` changed by the keys here, which must be complete without a base.
fn pocket(at: &At<'_>, base: Option<PocketDescription>) -> Result<PocketDescription, Error> {
    let fields =
        at.fields(&["mouth", "cut_angle_deg", "shelf", "hole_radius", "point_radius", "throat"])?;
    let number = |key, range, old: Option<f64>| match (fields.get(key), old) {
        (Some(at), _) => at.number(range),
        (None, Some(old)) => Ok(old),
        (None, None) => {
            fields.require(key, "its value, or start from a preset with \"base\"")?.number(range)
        }
    };
    Ok(PocketDescription {
        mouth: number("mouth", &LENGTH, base.map(|b| b.mouth))?,
        cut_angle_deg: number("cut_angle_deg", &CUT_ANGLE, base.map(|b| b.cut_angle_deg))?,
        shelf: number("shelf", &ANYWHERE, base.map(|b| b.shelf))?,
        hole_radius: number("hole_radius", &LENGTH, base.map(|b| b.hole_radius))?,
        point_radius: number("point_radius", &OPEN_LENGTH, base.map(|b| b.point_radius))?,
        throat: match fields.get("throat") {
            Some(at) => Some(at.number(&LENGTH)?),
            None => base.and_then(|b| b.throat),
        },
    })
}

fn sights(at: &At<'_>) -> Result<Sights, Error> {
    const MOST: u32 = 1000;
    let fields = at.fields(&["along_length", "along_width", "setback"])?;
    let intervals = |key| fields.require(key, "the number of intervals")?.whole(1, MOST);
    Ok(Sights {
        along_length: intervals("along_length")?,
        along_width: intervals("along_width")?,
        setback: fields.require("setback", "the distance in m")?.number(&ANYWHERE)?,
    })
}

fn markings(at: &At<'_>) -> Result<Markings, Error> {
    let fields = at.fields(&["head_string", "d_radius", "spots"])?;
    let optional = |key, range| fields.get(key).map(|at: At<'_>| at.number(range)).transpose();
    let mut spots = Vec::new();
    if let Some(at) = fields.get("spots") {
        for at in at.items("a list of spots")? {
            let fields = at.fields(&["name", "position"])?;
            let name = fields.require("name", "the spot's name")?.text("the spot's name")?.into();
            let p = fields.require("position", "[x, y] in m")?.numbers(2, 2)?;
            spots.push(Spot { name, position: [p[0], p[1]] });
        }
    }
    Ok(Markings {
        head_string: optional("head_string", &OPEN_LENGTH)?,
        d_radius: optional("d_radius", &LENGTH)?,
        spots,
    })
}

/// `table` as a shot file has it: the name of a preset, else all keys. Also the name of the physics
/// preset that belongs to it.
pub(super) fn write(table: &Table) -> (Node, String) {
    let Some(description) = &table.description else {
        return (Node::object([("cloth", "unbounded".into())]), UNBOUNDED_PHYSICS.into());
    };
    let node = match &table.name {
        Some(name) => name.into(),
        None => write_description(description),
    };
    (node, description.physics.clone())
}

fn write_description(d: &TableDescription) -> Node {
    let mut node = Node::object([
        ("length", d.length.into()),
        ("width", d.width.into()),
        ("cushion_height", d.cushion_height.into()),
        ("cushion_width", d.cushion_width.into()),
        ("rail_width", d.rail_width.into()),
        ("pockets", word_of(POCKET_LAYOUTS, d.pockets)),
        ("pocket_model", word_of(POCKET_MODELS, d.pocket_model)),
    ]);
    for (key, pocket) in [("corner_pocket", &d.corner_pocket), ("side_pocket", &d.side_pocket)] {
        if let Some(pocket) = pocket {
            node.set(key, write_pocket(pocket));
        }
    }
    if let Some(sights) = &d.sights {
        node.set("sights", write_sights(sights));
    }
    if d.markings != Markings::default() {
        node.set("markings", write_markings(&d.markings));
    }
    node.set("physics", &d.physics);
    node
}

fn write_pocket(pocket: &PocketDescription) -> Node {
    let mut node = Node::object([
        ("mouth", pocket.mouth.into()),
        ("cut_angle_deg", pocket.cut_angle_deg.into()),
        ("shelf", pocket.shelf.into()),
        ("hole_radius", pocket.hole_radius.into()),
        ("point_radius", pocket.point_radius.into()),
    ]);
    if let Some(throat) = pocket.throat {
        node.set("throat", throat);
    }
    node
}

/// The sights of a table as a shot file has them.
pub(super) fn write_sights(sights: &Sights) -> Node {
    Node::object([
        ("along_length", sights.along_length.into()),
        ("along_width", sights.along_width.into()),
        ("setback", sights.setback.into()),
    ])
}

fn write_markings(markings: &Markings) -> Node {
    let mut node = Node::object([]);
    for (key, value) in [("head_string", markings.head_string), ("d_radius", markings.d_radius)] {
        if let Some(value) = value {
            node.set(key, value);
        }
    }
    node.set("spots", write_spots(&markings.spots));
    node
}

/// The spots of a table as a shot file has them.
pub(super) fn write_spots(spots: &[Spot]) -> Node {
    let spot =
        |s: &Spot| Node::object([("name", (&s.name).into()), ("position", s.position.into())]);
    Node::list(spots.iter().map(spot))
}
