//! The JSON Schemas and the readers have the same keys and the same names.

use std::collections::BTreeSet;

use carom::Shot;
use carom::format::{Node, schema};

fn parsed(text: &str) -> Node {
    Node::from_json(text).unwrap_or_else(|e| panic!("{e}"))
}

/// The node at a path of keys and indices.
fn at<'a>(node: &'a Node, path: &[&str]) -> &'a Node {
    path.iter().fold(node, |node, step| match node {
        Node::List(items) => &items[step.parse::<usize>().expect("an index")],
        _ => node.get(step).unwrap_or_else(|| panic!("no `{step}` in {path:?}")),
    })
}

fn keys(node: &Node) -> BTreeSet<String> {
    let Node::Object(fields) = node else { panic!("{node:?} is not an object") };
    fields.iter().map(|(key, _)| key.clone()).collect()
}

fn words(node: &Node) -> Vec<&str> {
    let Node::List(items) = node else { panic!("{node:?} is not a list") };
    let word = |item: &'_ Node| match item {
        Node::Text(s) => s.as_str().to_owned().leak() as &str,
        other => panic!("{other:?} is not a text"),
    };
    items.iter().map(word).collect()
}

/// The keys that the reader lists when it finds an unknown one.
fn keys_of_the_reader(file: &str) -> BTreeSet<String> {
    let sentence = Shot::from_json(file).expect_err("an unknown key").to_string();
    let list = sentence.split("the keys known here are ").nth(1);
    let list = list.unwrap_or_else(|| panic!("`{sentence}` lists no keys"));
    list.split(", ").map(String::from).collect()
}

#[test]
fn the_shot_schema_and_the_reader_have_the_same_keys() {
    let schema = parsed(schema::SHOT);
    let file = |table: &str, physics: &str, ball: &str, strike: &str, more: &str| {
        format!(
            r#"{{"format": "carom-shot/1", "table": {table}, "physics": {physics},
                "balls": [{{"id": "a", "position": [0.5, 0.5]{ball}}}],
                "strike": {{"ball": "a", "speed": 1, "azimuth_deg": 0{strike}}}{more}}}"#
        )
    };
    let unknown = r#", "qqqqqqqqqq": 1"#;
    let physics = |section: &str| {
        file("\"wpa-9ft\"", &format!(r#"{{"{section}": {{"qqqqqqqqqq": 1}}}}"#), "", "", "")
    };
    let table = |section: &str| {
        let table = format!(r#"{{"base": "wpa-9ft", "{section}": {{"qqqqqqqqqq": 1}}}}"#);
        file(&table, "\"pool\"", "", "", "")
    };
    let good = ("\"wpa-9ft\"", "\"pool\"");
    for (path, text) in [
        ("properties", file(good.0, good.1, "", "", unknown)),
        ("$defs/ball/properties", file(good.0, good.1, unknown, "", "")),
        ("$defs/strike/properties", file(good.0, good.1, "", unknown, "")),
        ("$defs/physics/oneOf/1/properties", file(good.0, r#"{"qqqqqqqqqq": 1}"#, "", "", "")),
        ("$defs/pocket/properties", table("corner_pocket")),
        ("$defs/table/oneOf/2/properties/sights/properties", table("sights")),
        ("$defs/table/oneOf/2/properties/markings/properties", table("markings")),
    ] {
        let path: Vec<&str> = path.split('/').collect();
        assert_eq!(keys(at(&schema, &path)), keys_of_the_reader(&text), "{path:?}");
    }
    let Node::Object(of_physics) = at(&schema, &["$defs", "physics", "oneOf", "1", "properties"])
    else {
        panic!("no physics")
    };
    for (group, of_group) in of_physics {
        if let Some(properties) = of_group.get("properties") {
            assert_eq!(keys(properties), keys_of_the_reader(&physics(group)), "{group}");
        }
    }
    let bands = file(good.0, r#"{"cloth": {"rolling_friction": [{"qqqqqqqqqq": 1}]}}"#, "", "", "");
    let cloth = &["$defs", "physics", "oneOf", "1", "properties", "cloth", "properties"];
    let band = at(at(&schema, cloth), &["rolling_friction", "oneOf", "1"]);
    assert_eq!(keys(at(band, &["items", "properties"])), keys_of_the_reader(&bands));
    let mut of_tables = keys(at(&schema, &["$defs", "table", "oneOf", "2", "properties"]));
    of_tables.insert(String::from("cloth"));
    let text = file(r#"{"qqqqqqqqqq": 1}"#, good.1, "", "", "");
    assert_eq!(of_tables, keys_of_the_reader(&text));
}

#[test]
fn the_trace_schema_lists_what_a_trace_writes() {
    let schema = parsed(schema::TRACE);
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.635, 0.4]}],
        "strike": {"ball": "cue", "speed": 3, "azimuth_deg": 90}}"#;
    let trace = Shot::from_json(text).and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    let node = trace.to_node();
    assert_eq!(keys(at(&schema, &["properties"])), keys(&node));
    let outcome = at(&schema, &["properties", "outcome", "properties"]);
    assert_eq!(keys(outcome), keys(at(&node, &["outcome"])));
    let event = at(&node, &["events", "0"]);
    assert_eq!(keys(at(&schema, &["$defs", "cue_strike", "properties"])), keys(event));
    assert_eq!(event.get("type"), Some(&"cue-strike".into()));
    for (kind, def) in
        [("rail-collision", "rail_collision"), ("motion-transition", "motion_transition")]
    {
        let Some(Node::List(events)) = node.get("events") else { panic!("no events") };
        let event = events.iter().find(|event| event.get("type") == Some(&kind.into()));
        let written = keys(event.unwrap_or_else(|| panic!("no {kind}")));
        assert_eq!(keys(at(&schema, &["$defs", def, "properties"])), written, "{kind}");
    }
    let ball = at(event, &["after", "0"]);
    assert_eq!(keys(at(&schema, &["$defs", "ball", "properties"])), keys(ball));
    let motions: Vec<&str> = carom::MotionState::ALL.iter().map(|m| m.name()).collect();
    assert_eq!(words(at(&schema, &["$defs", "motion", "enum"])), motions);
}
