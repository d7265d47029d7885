//! The values of a physics preset as a list, with their units and sources. `carom physics` prints it.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::node::Node;
use crate::edition::{self, Edition};
use crate::error::Error;
use crate::math::sin_cos;
use crate::physics::Physics;
use crate::physics::sources::{Evidence, source};

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
    let dated = edition::find(edition::PHYSICS, name)?.dated;
    let mut list = Vec::new();
    add_leaves(dated, String::new(), Physics::preset(dated)?.to_node(), &mut list);
    Some(list)
}

fn add_leaves(dated: &str, path: String, node: Node, list: &mut Vec<Parameter>) {
    let Node::Object(fields) = node else {
        // Every key of every preset has a source: a test reads them all.
        let Some((_, (_, evidence, source))) = source(dated, source_key(&path)) else { return };
        let unit = unit(&path);
        list.push(Parameter { key: path, value: node, unit, evidence, source });
        return;
    };
    for (key, value) in fields {
        let path = if path.is_empty() { key } else { format!("{path}.{key}") };
        add_leaves(dated, path, value, list);
    }
}

/// The key without the unit in its name.
fn source_key(key: &str) -> &str {
    key.strip_suffix("_deg").unwrap_or(key)
}

/// The unit of the value at `key`.
fn unit(key: &str) -> &'static str {
    match key {
        "gravity" => "m/s²",
        "cloth.spin_deceleration" => "rad/s²",
        "cushion.restitution.b" => "per m/s",
        "cushion.restitution.c" => "per (m/s)²",
        "cushion.friction.b" => "per rad",
        "ball_ball.friction.c" => "s/m",
        _ if key.ends_with("_deg") => "deg",
        _ if key.ends_with("elevation") => "rad",
        _ if key.ends_with("mass") => "kg",
        _ if key.ends_with("radius") => "m",
        _ if key.starts_with("contact_times.") => "s",
        _ => "",
    }
}

/// Keys of the coefficients that may depend on a speed or an angle.
const VARIABLE: [&str; 4] =
    ["cloth.rolling_friction", "ball_ball.friction", "cushion.restitution", "cushion.friction"];

/// The coefficient `key` of `physics` at a speed (m/s): of a rolling ball for
/// `cloth.rolling_friction`, of slip for `ball_ball.friction`, perpendicular to the rail for
/// `cushion.restitution`; and for `cushion.friction` at an angle of incidence (rad).
///
/// # Errors
/// [`Error::Input`] for another key, and for a speed or angle that is negative or not finite.
pub fn coefficient_at(physics: &Physics, key: &str, at: f64) -> Result<f64, Error> {
    if !(at >= 0.0 && at.is_finite()) {
        let what = format!("{at:?} is out of range");
        return Err(Error::input("at", what, "give a finite speed or angle ≥ 0"));
    }
    let Physics { cloth, ball_ball, cushion, .. } = physics;
    match key {
        "cloth.rolling_friction" => Ok(cloth.rolling_friction.at(at)),
        "ball_ball.friction" => Ok(ball_ball.friction.at(at)),
        "cushion.restitution" => Ok(cushion.restitution.at(at)),
        "cushion.friction" => {
            let (sin, cos) = sin_cos(at);
            Ok(cushion.friction.at(sin, cos))
        }
        _ => {
            let what = format!("\"{key}\" is not a coefficient that may depend on speed or angle");
            Err(Error::input("key", what, format!("write one of {}", VARIABLE.join(", "))))
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
    use alloc::vec::Vec;

    use super::{Node, Parameter, coefficient_at, parameters, source_key};
    use crate::Physics;
    use crate::edition::PHYSICS;
    use crate::physics::sources::source;

    fn leaves(node: &Node) -> usize {
        match node {
            Node::Object(fields) => fields.iter().map(|(_, value)| leaves(value)).sum(),
            _ => 1,
        }
    }

    #[test]
    fn every_value_of_every_preset_has_a_source() {
        for edition in PHYSICS {
            let list = parameters(edition.dated).unwrap();
            let all = leaves(&Physics::preset(edition.dated).unwrap().to_node());
            assert_eq!(list.len(), all, "{}: add the missing keys to sources.rs", edition.dated);
            assert!(list.iter().all(|p| !p.source.is_empty()));
        }
    }

    #[test]
    fn a_source_of_another_preset_is_used_only_for_its_value() {
        for edition in PHYSICS {
            for p in parameters(edition.dated).unwrap() {
                let (from, _) = source(edition.dated, source_key(&p.key)).unwrap();
                let there: Vec<Parameter> = parameters(from).unwrap();
                let same = there.iter().find(|other| other.key == p.key);
                let same = same.map(|other| &other.value);
                assert_eq!(same, Some(&p.value), "{} of {}", p.key, edition.dated);
            }
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
