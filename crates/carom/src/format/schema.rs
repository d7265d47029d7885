//! JSON Schemas (draft 2020-12) of the files that carom reads and writes.

use alloc::string::String;
use alloc::vec::Vec;
use alloc::{format, vec};

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use super::physics::keys;
use crate::edition;
use crate::physics::MAX_ROLLING_BANDS;
use crate::physics::quantities::{
    BAND_END, FRACTION, FRICTION, Formula, GROUPS, Quantity, QuantityShape, TIPS, Words,
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
        ("table_preset", words(about, &edition::names(edition::TABLES))),
        ("physics_preset", words(about, &edition::names(edition::PHYSICS))),
        ("physics", physics()),
    ])
}

fn physics() -> Node {
    let preset = |fields: Vec<(&str, Node)>| {
        let mut node = object(fields);
        node.set("$ref", "#/$defs/physics_preset");
        node
    };
    let base =
        "Preset from which missing keys are taken; default: the preset that belongs to the table.";
    let mut values = vec![("base", preset(vec![("description", base.into())]))];
    values.extend(properties(""));
    for (group, about) in GROUPS {
        let mut node = closed(about, properties(group));
        let pairs = Quantity::of_group(group).map(|q| keys([q].into_iter()).collect::<Vec<_>>());
        let pairs: Vec<_> = pairs.filter(|keys| keys.len() > 1).map(required).collect();
        if !pairs.is_empty() {
            node.set("not", Node::object([("anyOf", Node::List(pairs))]));
        }
        values.push((group, node));
    }
    let about = "A preset's name, or an object merged key by key over its base; default: the preset that \
                 belongs to the table.";
    one_of(about, vec![preset(vec![]), closed("Physics, key by key.", values)])
}

fn properties(group: &str) -> Vec<(&'static str, Node)> {
    Quantity::of_group(group).flat_map(value).collect()
}

/// The keys that a file may have for a value, with their schemas.
fn value(quantity: &'static Quantity) -> Vec<(&'static str, Node)> {
    let about = quantity.about;
    let node = match &quantity.shape {
        QuantityShape::Number(n) => number(about, &n.range),
        QuantityShape::Model(models, _) => words(about, &(models.names)()),
        QuantityShape::Formula(fit) => one_of(about, fit_choices(fit)),
        QuantityShape::Bands => {
            one_of(about, vec![number("The coefficient at every speed.", &FRICTION), bands()])
        }
        QuantityShape::Tip => {
            return TIPS.map(|(key, about, _)| (key, number(about, &FRACTION))).to_vec();
        }
        QuantityShape::Angle(_) => {
            let [radians, degrees] = STROKE_ELEVATION.keys();
            let [in_radians, in_degrees] = STROKE_ELEVATION.ranges();
            let instead = format!("{about} Instead of {degrees}.");
            return vec![
                (radians, number(&instead, &in_radians)),
                (degrees, number(about, &in_degrees)),
            ];
        }
    };
    let mut node = node;
    if let Some(argument) = quantity.argument() {
        node.set("argument", argument);
    }
    vec![(quantity.key(), node)]
}

fn fit_choices(fit: &'static Formula) -> Vec<Node> {
    let surface =
        |names: &Words| words("A surface of pool balls with measured throw.", &(names.names)());
    let numbers = fit.numbers.iter().map(|n| {
        let mut node = number(n.about, &n.number.range);
        node.set("flat", n.flat);
        (n.key, node)
    });
    let constant = number("The coefficient, if it is constant.", &fit.constant);
    let formula = closed(fit.formula, numbers.collect());
    fit.names.iter().map(surface).chain([constant, formula]).collect()
}

fn bands() -> Node {
    let number = |about, range| number(about, range);
    let mut band = closed(
        "A band of speeds.",
        vec![
            ("up_to", number("Largest speed of the band.", &BAND_END)),
            ("friction", number("Coefficient of rolling resistance in the band.", &FRICTION)),
        ],
    );
    band.set("required", Node::list(["friction"]));
    let about =
        "Bands in ascending order of speed. Every band but the last has an end; the ends increase.";
    object(vec![
        ("type", "array".into()),
        ("description", about.into()),
        ("minItems", 1_u32.into()),
        ("maxItems", (MAX_ROLLING_BANDS as u32).into()),
        ("items", band),
    ])
}

fn number(about: &str, range: &Range) -> Node {
    let unit = range.unit();
    let mut fields =
        vec![("type", Node::from("number")), ("description", with_unit(about, unit).into())];
    fields.extend(range.limits().map(|(keyword, limit)| (keyword, limit.into())));
    if !unit.is_empty() {
        fields.push(("unit", unit.into()));
    }
    object(fields)
}

/// The sentence with the unit at the end of its first clause.
fn with_unit(about: &str, unit: &str) -> String {
    let (clause, rest) = about.split_at(about.find(['.', ':', ';']).unwrap_or(about.len()));
    if unit.is_empty() { about.into() } else { format!("{clause}, {unit}{rest}") }
}

fn words(about: &str, names: &[&'static str]) -> Node {
    Node::object([("description", about.into()), ("enum", Node::list(names.iter().copied()))])
}

fn one_of(about: &str, choices: Vec<Node>) -> Node {
    Node::object([("description", about.into()), ("oneOf", Node::List(choices))])
}

/// An object without other keys.
fn closed(about: &str, properties: Vec<(&str, Node)>) -> Node {
    Node::object([
        ("type", "object".into()),
        ("description", about.into()),
        ("additionalProperties", false.into()),
        ("properties", object(properties)),
    ])
}

fn required(keys: Vec<&'static str>) -> Node {
    Node::object([("required", Node::list(keys))])
}

fn object(fields: Vec<(&str, Node)>) -> Node {
    Node::Object(fields.into_iter().map(|(key, value)| (key.into(), value)).collect())
}
