//! The values behind a dated name never change: records that have it must replay to the same bits.
//!
//! `goldens/presets/<kind>-<dated name>.json` has the values of the day on which the edition was made.
//! `make goldens` adds missing files and keys and keeps every value that is there.

use std::fs;
use std::path::PathBuf;

use carom::edition::{Edition, PHYSICS, TABLES};
use carom::format::Node;
use carom::table::TableDescription;
use carom::{Physics, Shot, Table};

fn stored(kind: &str, dated: &str) -> Node {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join(format!("../../goldens/presets/{kind}-{dated}.json"));
    let text = fs::read_to_string(&path).unwrap_or_else(|_| {
        panic!("{} does not exist: run `make goldens`", path.display());
    });
    Node::from_json(&text).unwrap()
}

/// The differences of `now` from `stored`, with their key paths.
fn differences(path: &str, stored: &Node, now: &Node, out: &mut Vec<String>) {
    let (Node::Object(stored), Node::Object(now)) = (stored, now) else {
        if number(stored) != number(now) || (number(stored).is_none() && stored != now) {
            out.push(format!("{path}: {stored:?} was stored, now {now:?}"));
        }
        return;
    };
    for (key, old) in stored {
        let path = format!("{path}.{key}");
        match now.iter().find(|(k, _)| k == key) {
            Some((_, now)) => differences(&path, old, now, out),
            None => out.push(format!("{path}: missing now")),
        }
    }
    for (key, _) in now.iter().filter(|(key, _)| stored.iter().all(|(k, _)| k != key)) {
        out.push(format!("{path}.{key}: not stored yet; run `make goldens`"));
    }
}

/// The bits of a number; a whole number may be written with or without a fraction.
fn number(node: &Node) -> Option<u64> {
    match *node {
        Node::Integer(n) => Some((n as f64).to_bits()),
        Node::Number(x) => Some(x.to_bits()),
        _ => None,
    }
}

fn check(kind: &str, editions: &[Edition], now: impl Fn(&str) -> Node) {
    let mut out = Vec::new();
    for edition in editions {
        differences(edition.dated, &stored(kind, edition.dated), &now(edition.dated), &mut out);
    }
    let remedy = "add an edition to crates/carom/src/edition.rs and keep the old values";
    assert!(out.is_empty(), "{remedy}:\n{}", out.join("\n"));
}

#[test]
fn the_physics_behind_a_dated_name_never_changes() {
    check("physics", PHYSICS, |name| Physics::preset(name).unwrap().to_node());
}

#[test]
fn the_dimensions_behind_a_dated_name_never_change() {
    check("table", TABLES, |name| {
        let TableDescription { physics, .. } = TableDescription::preset(name).unwrap();
        let table = Table::preset(name).unwrap();
        let dimensions = table.dimensions();
        let mut node =
            Node::Object(dimensions.into_iter().map(|d| (d.key, Node::Number(d.value))).collect());
        node.set("pockets", table.to_node().get("pockets").unwrap().clone());
        node.set("physics", Physics::dated_name(&physics).unwrap());
        node.set("spots", table.to_node().get("markings").unwrap().get("spots").unwrap().clone());
        node
    });
}

#[test]
fn a_change_of_one_bit_behind_a_dated_name_is_found() {
    let old = Physics::pool();
    let mut new = old.clone();
    new.cloth.sliding_friction = new.cloth.sliding_friction.next_up();
    let mut out = Vec::new();
    differences("pool", &old.to_node(), &new.to_node(), &mut out);
    assert_eq!(out.len(), 1);
    assert!(out[0].starts_with("pool.cloth.sliding_friction: "), "{out:?}");
}

fn shot_file(table: &str, more: &str) -> String {
    format!(
        r#"{{"format": "carom-shot/1", "table": {table}{more},
            "balls": [{{"id": "cue", "position": [0.6, 0.6]}}],
            "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 80.0}}}}"#
    )
}

#[test]
fn traces_have_dated_names_and_everything_else_as_it_was_read() {
    let cases = [
        (r#""wpa-9ft""#, "", r#""wpa-9ft-2026-12""#, None),
        (r#""wpa-9ft-2026-12""#, "", r#""wpa-9ft-2026-12""#, None),
        // An older edition keeps its date.
        (r#""wpa-9ft-2026-11""#, "", r#""wpa-9ft-2026-11""#, None),
        (
            r#""wpa-9ft""#,
            r#", "physics": "ideal""#,
            r#""wpa-9ft-2026-12""#,
            Some(r#""ideal-2026-11""#),
        ),
        (
            r#"{"base": "carom-10ft", "length": 2.8, "width": 1.4}"#,
            r#", "physics": {"gravity": 9.8}"#,
            r#"{"base": "carom-10ft-2026-12", "length": 2.8, "width": 1.4}"#,
            Some(r#"{"gravity": 9.8}"#),
        ),
        // The physics of these two tables follows from no name.
        (r#"{"cloth": "unbounded"}"#, "", r#"{"cloth": "unbounded"}"#, Some(r#""pool-2026-12""#)),
        (
            r#"{"length": 2.0, "width": 1.0}"#,
            r#", "physics": {"gravity": 9.8}"#,
            r#"{"length": 2.0, "width": 1.0}"#,
            Some(r#"{"gravity": 9.8, "base": "pool-2026-12"}"#),
        ),
        (
            r#"{"length": 2.0, "width": 1.0, "physics": "carom"}"#,
            "",
            r#"{"length": 2.0, "width": 1.0, "physics": "carom-2026-12"}"#,
            None,
        ),
        (
            r#""wpa-9ft""#,
            r#", "physics": {"base": "snooker", "gravity": 9.8}"#,
            r#""wpa-9ft-2026-12""#,
            Some(r#"{"base": "snooker-2026-12", "gravity": 9.8}"#),
        ),
    ];
    for (table, more, dated, physics) in cases {
        let file = carom::ShotFile::from_json(&shot_file(table, more)).unwrap();
        let trace = file.simulate().unwrap().to_node_with(file.to_node().into_owned());
        let shot = trace.get("shot").unwrap();
        let json = |text: &str| Node::from_json(text).unwrap();
        assert_eq!(shot.get("table"), Some(&json(dated)), "{table}{more}");
        assert_eq!(shot.get("physics"), physics.map(json).as_ref(), "{table}{more}");
        assert_eq!(Shot::from_node(shot).unwrap(), *file.shot(), "{table}{more}");
        assert_eq!(file.to_node().get("table"), Some(&json(table)), "the file keeps its names");
    }
}

#[test]
fn an_unknown_edition_is_refused_with_the_names_that_exist() {
    let error = Shot::from_json(&shot_file(r#""wpa-9ft-2025-01""#, "")).unwrap_err().to_string();
    assert!(error.starts_with("table: "), "{error}");
    assert!(error.contains("wpa-9ft") && error.contains("wpa-9ft-2026-11"), "{error}");
    let physics = r#", "physics": {"base": "pool-2025-01"}"#;
    let error = Shot::from_json(&shot_file(r#""wpa-9ft""#, physics)).unwrap_err().to_string();
    assert!(error.starts_with("physics.base: "), "{error}");
    assert!(error.contains("pool-2026-11"), "{error}");
}
