//! The values of a physics preset as a list, with their units and sources. `carom physics` prints it.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::node::Node;
use super::physics::write_value;
use crate::edition::{self, Edition};
use crate::error::{Error, ErrorKind};
use crate::physics::presets::source;
use crate::physics::quantities::{GROUPS, QUANTITIES, Quantity, QuantityShape};
use crate::physics::{Evidence, Physics};

/// One line of the list that `carom physics` prints.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its key in a shot file's `physics`: `cloth.rolling_friction`.
    pub key: String,
    /// Its value: a number, or the name of a model.
    pub value: Node,
    /// The unit: `m`, `kg`, `s`, `rad/s²`, `deg`, ...; empty for a number without a unit and for a model.
    pub unit: &'static str,
    /// What the value rests on.
    pub evidence: Evidence,
    /// The measurement, publication or rule book, or why there is none.
    pub source: &'static str,
}

/// The values of the physics preset `name`, with or without a date, in the order of a shot file.
/// `None` if there is no such preset.
pub fn parameters(name: &str) -> Option<Vec<Parameter>> {
    let physics = Physics::preset(name)?;
    let mut list = Vec::new();
    for quantity in
        [""].into_iter().chain(GROUPS.iter().map(|group| group.0)).flat_map(Quantity::below)
    {
        let mut written = Node::object([]);
        write_value(&physics, quantity, &mut written);
        let field =
            if let QuantityShape::Tip(_) = quantity.shape { "cue.tip" } else { quantity.path };
        add(&written, quantity.split().0, source(name, field)?, &mut list);
    }
    Some(list)
}

/// Adds the numbers and names below `path`.
fn add(node: &Node, path: &str, from: (Evidence, &'static str), list: &mut Vec<Parameter>) {
    let Node::Object(fields) = node else {
        let unit = Quantity::unit(path);
        let (evidence, source) = from;
        list.push(Parameter { key: path.into(), value: node.clone(), unit, evidence, source });
        return;
    };
    for (key, value) in fields {
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        add(value, &path, from, list);
    }
}

/// The coefficient `key` of `physics` at a speed (m/s): of a rolling ball for
/// `cloth.rolling_friction`, of slip for `ball_ball.friction`, perpendicular to the rail for
/// `cushion.restitution`; and for `cushion.friction` at an angle of incidence (rad).
///
/// # Errors
/// [`Error::Input`] for another key, and for a speed or angle that is negative or not finite.
pub fn coefficient_at(physics: &Physics, key: &str, at: f64) -> Result<f64, Error> {
    if !(at >= 0.0 && at.is_finite()) {
        let what = format!("{at:?} is out of range");
        return Err(ErrorKind::OutOfRange.at("at", what, "give a finite speed or angle ≥ 0"));
    }
    let laws = || QUANTITIES.iter().filter_map(|q| Some((q.path, q.law()?.1)));
    match laws().find(|(path, _)| *path == key) {
        Some((_, law)) => Ok(law(physics, at)),
        None => {
            let what = format!("\"{key}\" is not a coefficient that may depend on speed or angle");
            let keys: Vec<_> = laws().map(|(path, _)| path).collect();
            Err(ErrorKind::UnknownName.at("key", what, format!("write one of {}", keys.join(", "))))
        }
    }
}

/// Every physics preset: `name`, `dated_name`, `parameters` (`key`, `value`, `unit`, `evidence`,
/// `source`), and `physics`, the same values as a shot file has them.
pub fn physics_list() -> Node {
    let names = edition::listed(edition::PHYSICS).into_iter();
    Node::list(names.filter_map(|name| preset(edition::find(edition::PHYSICS, name)?)))
}

fn preset(edition: &Edition) -> Option<Node> {
    let line = |p: Parameter| {
        Node::object([
            ("key", p.key.into()),
            ("value", p.value),
            ("unit", p.unit.into()),
            ("evidence", p.evidence.name().into()),
            ("source", p.source.into()),
        ])
    };
    Some(Node::object([
        ("name", edition.current_name(edition::PHYSICS).into()),
        ("dated_name", edition.dated.into()),
        ("parameters", Node::list(parameters(edition.dated)?.into_iter().map(line))),
        ("physics", Physics::preset(edition.dated)?.to_node()),
    ]))
}

#[cfg(test)]
mod tests {
    use super::{coefficient_at, parameters};
    use crate::Physics;
    use crate::edition::PHYSICS;

    #[test]
    fn every_value_of_every_preset_has_a_source() {
        for edition in PHYSICS {
            let list = parameters(edition.dated).expect("a source for every quantity");
            assert!(list.iter().all(|p| !p.source.is_empty()));
        }
    }

    #[test]
    fn a_coefficient_is_that_of_its_law_at_a_speed_or_an_angle() {
        let physics = Physics::preset("carom").unwrap();
        let at = |key: &str, at: f64| coefficient_at(&physics, key, at).unwrap();
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        near(at("cushion.restitution", 2.0), 0.915 - 0.034 * 2.0 - 0.005 * 4.0);
        near(at("cushion.friction", 0.5), 0.240 + 0.034 * 0.5);
        near(at("ball_ball.friction", 0.0), 0.0942);
        assert!(at("cloth.rolling_friction", 3.0) > at("cloth.rolling_friction", 0.1));
        assert!(coefficient_at(&physics, "cloth.sliding_friction", 1.0).is_err());
        assert!(coefficient_at(&physics, "cushion.restitution", -1.0).is_err());
    }

    #[test]
    fn a_friction_that_depends_on_the_speed_has_one_source_for_all_its_numbers() {
        let list = parameters("pool").unwrap();
        let of = |key: &str| list.iter().find(|p| p.key == key).unwrap();
        let [a, c] = ["a", "c"].map(|key| of(&alloc::format!("ball_ball.friction.{key}")));
        assert_eq!((a.source, a.unit), (c.source, ""));
        assert_eq!((c.unit, of("cue.stroke_elevation_deg").unit), ("s/m", "deg"));
    }
}
