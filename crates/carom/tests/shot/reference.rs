//! Parts of files that follow from the code are as it writes them. With `CAROM_WRITE` in the environment
//! these tests write them (`make reference`).

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use carom::format::{Node, schema};

/// Compares a file with what the code makes of it, or writes that.
fn check(path: &str, written: impl Fn(&str) -> String) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path);
    let stored = fs::read_to_string(&path).unwrap();
    let now = written(&stored);
    if std::env::var_os("CAROM_WRITE").is_some() {
        fs::write(&path, now).unwrap();
    } else {
        assert!(
            stored == now,
            "{} is not what the code gives: run `make reference`",
            path.display()
        );
    }
}

#[test]
fn the_schema_has_the_physics_and_the_presets_of_the_code() {
    check("schemas/carom-shot-1.json", |stored| {
        let mut schema = Node::from_json(stored).unwrap();
        let mut definitions = schema.get("$defs").unwrap().clone();
        let Node::Object(of_the_code) = schema::definitions() else { panic!("no definitions") };
        for (name, definition) in of_the_code {
            definitions.set(&name, definition);
        }
        schema.set("$defs", definitions);
        schema.to_json() + "\n"
    });
}

#[test]
fn the_page_on_formats_has_every_value_of_the_physics() {
    const MARKS: [&str; 2] =
        ["<!-- values of the physics: `make reference` writes this table -->\n", "<!-- end -->\n"];
    check("../../docs/formats.md", |stored| {
        let (before, rest) = stored.split_once(MARKS[0]).expect("the first mark");
        let (_, after) = rest.split_once(MARKS[1]).expect("the second mark");
        format!("{before}{}{}{}{after}", MARKS[0], table(), MARKS[1])
    });
}

/// The values of the physics as a table in Markdown.
fn table() -> String {
    let definitions = schema::definitions();
    let physics = definitions.get("physics").and_then(|node| node.get("oneOf"));
    let Some(Node::List(choices)) = physics else { panic!("no physics") };
    let mut out = String::from("| Key | Meaning | Range |\n|---|---|---|\n");
    rows("", &choices[1], &mut out);
    out
}

fn rows(path: &str, node: &Node, out: &mut String) {
    let about = match node.get("description") {
        Some(Node::Text(text)) => text.replace('|', "\\|"),
        _ => String::new(),
    };
    if !path.is_empty() && path != "base" && !about.is_empty() {
        writeln!(out, "| `{path}` | {about} | {} |", range(node)).unwrap();
    }
    if let Some(Node::Object(properties)) = node.get("properties") {
        for (key, inner) in properties {
            rows(&if path.is_empty() { key.clone() } else { format!("{path}.{key}") }, inner, out);
        }
    }
    if let Some(Node::List(choices)) = node.get("oneOf") {
        for choice in choices.iter().filter(|choice| choice.get("properties").is_some()) {
            let mut inner = choice.clone();
            inner.remove("description");
            rows(path, &inner, out);
        }
    }
}

/// The range of a number, or the words that a value may have.
fn range(node: &Node) -> String {
    if let Some(Node::List(words)) = node.get("enum") {
        let word = |node: &Node| format!("`{}`", node.to_json_line().trim_matches('"'));
        return words.iter().map(word).collect::<Vec<_>>().join(", ");
    }
    let limit = |keyword| match node.get(keyword) {
        Some(Node::Number(x)) => Some(*x),
        _ => None,
    };
    let (low, high, below) = (limit("minimum"), limit("maximum"), limit("exclusiveMaximum"));
    match (low, high, below) {
        (Some(low), Some(1e9), _) if low < 0.0 => String::from("any"),
        (Some(0.0), Some(1e9), _) => String::from("≥ 0"),
        (Some(_), Some(1e9), _) => String::from("> 0"),
        (Some(low), Some(high), _) => format!("{low} to {high}"),
        (Some(low), _, Some(below)) => format!("{low} to below {below}"),
        _ => String::new(),
    }
}
