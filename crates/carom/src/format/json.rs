//! JSON text to a [`Node`] tree, with the place of every syntax error.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};

use super::node::Node;
use crate::error::{Error, ErrorKind};
use crate::limits::MOST_BYTES;

impl Node {
    /// Reads JSON text.
    ///
    /// # Errors
    /// [`Error::Input`] for text that is not JSON or longer than [`MOST_BYTES`], for a number too
    /// large for a double, and for a key that occurs twice in one object.
    pub fn from_json(text: &str) -> Result<Self, Error> {
        Self::from_json_within(text, MOST_BYTES)
    }

    /// As [`Self::from_json`], of a text of at most `most` bytes.
    ///
    /// # Errors
    /// The same, for a longer text.
    pub fn from_json_within(text: &str, most: usize) -> Result<Self, Error> {
        if text.len() > most {
            let what = format!("the text has {} bytes", text.len());
            let remedy = format!("give at most {} MiB", most >> 20);
            return Err(ErrorKind::OutOfRange.at("", what, remedy));
        }
        // Some editors put a byte-order mark in front of UTF-8.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut source = serde_json::Deserializer::from_str(text);
        let node = match serde_path_to_error::deserialize::<_, Self>(&mut source) {
            Ok(node) => node,
            Err(e) => {
                return Err(explain(text, known_part(&e.path().to_string()), e.inner()));
            }
        };
        source.end().map_err(|e| explain(text, "", &e))?;
        Ok(node)
    }
}

/// Longest place in an error, characters. Only malformed files have longer ones.
const LONGEST_PLACE: usize = 80;

/// The known part of the place of a syntax error. A key that is incomplete or missing is shown as
/// `?`, and the whole file as `.`.
fn known_part(place: &str) -> &str {
    let known = place.trim_end_matches('?').trim_end_matches('.');
    match known.char_indices().nth(LONGEST_PLACE) {
        Some((end, _)) => &known[..end],
        None => known,
    }
}

fn explain(text: &str, place: &str, e: &serde_json::Error) -> Error {
    let message = e.to_string();
    let at = format!("line {}, column {}", e.line(), e.column());
    if let Some(key) = message.strip_prefix(DUPLICATE) {
        let key = key.split(" at line").next().unwrap_or(key);
        let place = match place {
            "" => String::from(key),
            _ if place.ends_with(&format!(".{key}")) || place == key => String::from(place),
            _ => format!("{place}.{key}"),
        };
        return ErrorKind::Duplicate.at(
            place,
            format!("the key occurs twice ({at})"),
            "keep one of the two",
        );
    }
    let token = token_at(text, e.line(), e.column());
    if ["nan", "inf", "-inf", "+inf", "-nan"].iter().any(|w| token.to_lowercase().starts_with(w)) {
        return ErrorKind::OutOfRange.at(
            place,
            format!("{token} ({at}) is not a number that a shot can use"),
            "write a finite number",
        );
    }
    if message.starts_with("number out of range") {
        return ErrorKind::OutOfRange.at(
            place,
            format!("the number is too large for a double ({at})"),
            "write a finite number",
        );
    }
    let reason = message.split(" at line").next().unwrap_or(&message);
    let found = if token.is_empty() { String::new() } else { format!(" at `{token}`") };
    ErrorKind::Syntax
        .at(place, format!("not JSON: {reason}{found} ({at})"), "correct the text there")
        .with("line", e.line() as f64)
        .with("column", e.column() as f64)
}

/// The word at this line and column, where a syntax error is.
fn token_at(text: &str, line: usize, column: usize) -> String {
    let Some(line) = line.checked_sub(1).and_then(|i| text.split('\n').nth(i)) else {
        return String::new();
    };
    let bytes = line.as_bytes();
    let word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'+' | b'-' | b'.' | b'_');
    let at = column.saturating_sub(1).min(bytes.len());
    let start = at - bytes[..at].iter().rev().take_while(|b| word(b)).count();
    let end = at + bytes[at..].iter().take_while(|b| word(b)).count();
    bytes[start..end].iter().take(24).map(|&b| char::from(b)).collect()
}

const DUPLICATE: &str = "duplicate key ";

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(NodeVisitor)
    }
}

struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }
    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }
    fn visit_none<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }
    fn visit_some<D: Deserializer<'de>>(self, source: D) -> Result<Node, D::Error> {
        Node::deserialize(source)
    }
    fn visit_bool<E>(self, b: bool) -> Result<Node, E> {
        Ok(Node::Bool(b))
    }
    fn visit_i64<E>(self, i: i64) -> Result<Node, E> {
        Ok(Node::Integer(i))
    }
    fn visit_u64<E>(self, i: u64) -> Result<Node, E> {
        Ok(i64::try_from(i).map_or(Node::Number(i as f64), Node::Integer))
    }
    fn visit_f64<E>(self, x: f64) -> Result<Node, E> {
        Ok(Node::Number(x))
    }
    fn visit_str<E>(self, s: &str) -> Result<Node, E> {
        Ok(Node::Text(s.into()))
    }
    fn visit_string<E>(self, s: String) -> Result<Node, E> {
        Ok(Node::Text(s))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Node::List(list))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Node, A::Error> {
        let mut fields: Vec<(String, Node)> = Vec::new();
        let mut seen = BTreeSet::new();
        while let Some(key) = entries.next_key::<String>()? {
            if !seen.insert(key.clone()) {
                return Err(A::Error::custom(format_args!("{DUPLICATE}{key}")));
            }
            fields.push((key, entries.next_value()?));
        }
        Ok(Node::Object(fields))
    }
}
