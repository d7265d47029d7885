//! Dated names in place of names of presets, for everything that is stored. `pool` will one day have
//! other values, and a record must replay to the same bits.

use alloc::string::String;

use super::node::Node;
use super::table::UNBOUNDED_PHYSICS;
use crate::{Physics, Table, table::TableDescription};

/// The shot file `file`, which is valid, with the dated name of every preset. The physics that
/// belongs to the table is named too, unless the dated name of the table implies it.
pub fn with_dated_names(file: &Node) -> Node {
    let mut dated = file.clone();
    let Some(table) = file.get("table") else { return dated };
    let needed = Physics::dated_name(&default_physics(table));
    let implied = date_table(&mut dated);
    let missing = if implied == needed { None } else { needed };
    match (dated.get_mut("physics"), missing) {
        (Some(physics), missing) if physics.get("base").is_none() && is_object(physics) => {
            if let Some(name) = missing {
                physics.set("base", name);
            }
        }
        (Some(physics), _) if is_object(physics) => date(physics, "base", Physics::dated_name),
        (Some(_), _) => date(&mut dated, "physics", Physics::dated_name),
        (None, Some(name)) => dated.set("physics", name),
        (None, None) => {}
    }
    dated
}

/// The shot file `file`, which is valid, with the dated name of every preset that it names. The
/// physics that belongs to the table is not added.
pub(super) fn with_named_dated(file: &Node) -> Node {
    let mut dated = file.clone();
    date_table(&mut dated);
    date_physics(&mut dated);
    dated
}

/// `value`, the value at `path` of a shot file (`table`, `physics.base`), with the dated names of
/// presets. Values at other paths, and names that no preset has, stay as they are.
pub fn with_value_dated(path: &str, value: &Node) -> Node {
    let (part, key) = path.split_once('.').unwrap_or((path, ""));
    let inner = if key.is_empty() { value.clone() } else { Node::object([(key, value.clone())]) };
    let mut file = Node::object([(part, inner)]);
    date_table(&mut file);
    date_physics(&mut file);
    let dated =
        file.get(part).and_then(|inner| if key.is_empty() { Some(inner) } else { inner.get(key) });
    dated.unwrap_or(value).clone()
}

/// Writes the dated names into `physics` of `file`.
fn date_physics(file: &mut Node) {
    date(file, "physics", Physics::dated_name);
    if let Some(physics) = file.get_mut("physics") {
        date(physics, "base", Physics::dated_name);
    }
}

/// Writes the dated names into `table` of `file`. The dated name of the physics that these names
/// imply; `None` if they imply none.
fn date_table(file: &mut Node) -> Option<&'static str> {
    date(file, "table", Table::dated_name);
    let table = file.get_mut("table")?;
    if is_object(table) {
        date(table, "base", Table::dated_name);
        date(table, "physics", Physics::dated_name);
        table.get("base").or(table.get("physics"))?;
    }
    Physics::dated_name(&default_physics(table))
}

/// Replaces a preset's name at `key` of `node` by its dated name.
fn date(node: &mut Node, key: &str, dated_name: impl Fn(&str) -> Option<&'static str>) {
    if let Some(Node::Text(name)) = node.get(key)
        && let Some(dated) = dated_name(name)
    {
        node.set(key, dated);
    }
}

const fn is_object(node: &Node) -> bool {
    matches!(node, Node::Object(_))
}

/// The physics that belongs to a shot file's `table`.
fn default_physics(table: &Node) -> String {
    let of_preset = |name: &str| TableDescription::preset(name).map(|d| d.physics);
    let found = match (table, table.get("physics"), table.get("base")) {
        (Node::Text(name), _, _) | (_, None, Some(Node::Text(name))) => of_preset(name),
        (_, Some(Node::Text(name)), _) => Some(name.clone()),
        _ => None,
    };
    found.unwrap_or_else(|| UNBOUNDED_PHYSICS.into())
}
