//! JSON Schemas (draft 2020-12) of the files that carom reads and writes.

use alloc::string::String;
use alloc::vec::Vec;
use alloc::{format, vec};

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use crate::edition;
use crate::physics::MAX_ROLLING_BANDS;
use crate::physics::quantities::{
    BAND_END, FRACTION, FRICTION, Formula, GROUPS, Quantity, QuantityShape,
};
use crate::range::Range;

/// `carom-shot/1`: the shot file.
pub const SHOT: &str = include_str!("../../schemas/carom-shot-1.json");

/// `carom-trace/1`: the recorded shot, as this version writes it.
pub const TRACE: &str = include_str!("../../schemas/carom-trace-1.json");

/// The definitions of [`SHOT`] that follow from the code: the physics, and the names of presets. Beside
/// the keywords of JSON Schema a number may have its `unit`; a coefficient what it may depend on
/// (`argument`: speed or angle); and a number of a formula its value where the coefficient is constant
/// (`flat`). `make reference` writes them into the schema.
pub fn definitions() -> Node {
    let about =
        "Without a date the newest values; with a date the values of that edition, for ever.";
    Node::object([
        ("table_preset", words(about, edition::names(edition::TABLES))),
        ("physics_preset", words(about, edition::names(edition::PHYSICS))),
        ("physics", physics()),
    ])
}

fn physics() -> Node {
    let preset = ("$ref", Node::from("#/$defs/physics_preset"));
    let about =
        "Preset from which missing keys are taken; default: the preset that belongs to the table.";
    let base = Node::object([("description", about.into()), preset.clone()]);
    let mut values = vec![("base", base)];
    values.extend(properties(""));
    for (group, about) in GROUPS {
        let mut node = closed(about, properties(group));
        if *group == "cue" {
            let tips = ["tip_restitution", "tip_efficiency"];
            let pairs = [tips, STROKE_ELEVATION.keys()];
            let both = |keys| Node::object([("required", Node::list(keys))]);
            node.set("not", Node::object([("anyOf", Node::list(pairs.map(both)))]));
        }
        values.push((group, node));
    }
    let about = "A preset's name, or an object merged key by key over its base; default: the preset that \
                 belongs to the table.";
    one_of(about, vec![Node::object([preset]), closed("Physics, key by key.", values)])
}

/// The keys that a file may have below a path, with their schemas.
fn properties(path: &str) -> Vec<(&'static str, Node)> {
    let of = |quantity: &Quantity| {
        let (key, about) = (quantity.split().1, quantity.about);
        match &quantity.shape {
            QuantityShape::Number(n) => vec![(key, number(about, &n.range))],
            QuantityShape::Tip(_) => vec![(key, number(about, &FRACTION))],
            QuantityShape::Model(models, _) => vec![(key, words(about, (models.names)()))],
            QuantityShape::Formula(formula) => {
                vec![(key, coefficient(quantity, formulas(quantity, formula)))]
            }
            QuantityShape::Bands => vec![(
                key,
                coefficient(quantity, vec![number("The same at every speed.", &FRICTION), bands()]),
            )],
            QuantityShape::Angle(_) => {
                let ([radians, degrees], ranges) =
                    (STROKE_ELEVATION.keys(), STROKE_ELEVATION.ranges());
                let instead = format!("{about} Instead of {degrees}.");
                vec![(radians, number(&instead, &ranges[0])), (degrees, number(about, &ranges[1]))]
            }
        }
    };
    Quantity::below(path).flat_map(of).collect()
}

/// A coefficient in one of several forms.
fn coefficient(quantity: &Quantity, forms: Vec<Node>) -> Node {
    let mut node = one_of(quantity.about, forms);
    node.set("argument", quantity.law().map(|(argument, _)| argument));
    node
}

fn formulas(quantity: &Quantity, formula: &Formula) -> Vec<Node> {
    let mut numbers = properties(quantity.path);
    for ((_, node), number) in numbers.iter_mut().zip(quantity.numbers()) {
        node.set("flat", number.flat);
    }
    let names = formula.names.as_ref().map(|names| (names.names)());
    let surface = names.map(|names| words("A surface of pool balls with measured throw.", names));
    let constant = number("The coefficient, if it is constant.", &formula.constant);
    surface.into_iter().chain([constant, closed(formula.text, numbers)]).collect()
}

fn bands() -> Node {
    let about = "Coefficient of rolling resistance in the band.";
    let properties = vec![
        ("up_to", number("Largest speed of the band.", &BAND_END)),
        ("friction", number(about, &FRICTION)),
    ];
    let mut band = closed("A band of speeds.", properties);
    band.set("required", Node::list(["friction"]));
    let about =
        "Bands in ascending order of speed. Every band but the last has an end; the ends increase.";
    Node::object([
        ("type", "array".into()),
        ("description", about.into()),
        ("minItems", 1_u32.into()),
        ("maxItems", (MAX_ROLLING_BANDS as u32).into()),
        ("items", band),
    ])
}

fn number(about: &str, range: &Range) -> Node {
    let unit = range.unit();
    // The unit is at the end of the first clause.
    let (clause, rest) = about.split_at(about.find(['.', ':', ';']).unwrap_or(about.len()));
    let about = if unit.is_empty() { about.into() } else { format!("{clause}, {unit}{rest}") };
    let mut node = Node::object([("type", "number".into()), ("description", about.into())]);
    for (keyword, limit) in range.limits() {
        node.set(keyword, limit);
    }
    if !unit.is_empty() {
        node.set("unit", unit);
    }
    node
}

fn words(about: &str, names: Vec<&'static str>) -> Node {
    Node::object([("description", about.into()), ("enum", Node::list(names))])
}

fn one_of(about: &str, choices: Vec<Node>) -> Node {
    Node::object([("description", about.into()), ("oneOf", Node::List(choices))])
}

/// An object without other keys.
fn closed(about: &str, properties: Vec<(&str, Node)>) -> Node {
    let properties =
        properties.into_iter().map(|(key, value)| (String::from(key), value)).collect();
    Node::object([
        ("type", "object".into()),
        ("description", about.into()),
        ("additionalProperties", false.into()),
        ("properties", Node::Object(properties)),
    ])
}
