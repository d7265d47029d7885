//! A tree of plain values: the content of a JSON text or a Python dictionary, before it is checked.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;

/// A value as it was written. NaN and infinities are kept, so that a reader can refuse them with
/// their place.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number written without a fraction or an exponent.
    Integer(i64),
    /// Any other number.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    List(Vec<Node>),
    /// An object, in the order written; keys are unique.
    Object(Vec<(String, Node)>),
}

/// Lines of JSON are broken where they would be longer than this many characters.
const LINE: usize = 100;

impl Node {
    /// An object from its keys and values.
    pub fn object<const N: usize>(fields: [(&str, Node); N]) -> Self {
        Self::Object(fields.into_iter().map(|(k, v)| (String::from(k), v)).collect())
    }

    /// A list.
    pub fn list(items: impl IntoIterator<Item = impl Into<Node>>) -> Self {
        Self::List(items.into_iter().map(Into::into).collect())
    }

    /// The value under `key`, if this is an object that has it.
    pub fn get(&self, key: &str) -> Option<&Node> {
        match self {
            Self::Object(fields) => fields.iter().find(|(k, _)| k == key).map(|(_, v)| v),
            _ => None,
        }
    }

    /// The value under `key`, to change, if this is an object that has it.
    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut Node> {
        match self {
            Self::Object(fields) => fields.iter_mut().find(|(k, _)| k == key).map(|(_, v)| v),
            _ => None,
        }
    }

    /// Sets the value under `key`. An existing key keeps its position; a new one is added at the
    /// end. Does nothing if this is not an object.
    pub fn set(&mut self, key: &str, value: impl Into<Node>) {
        let Self::Object(fields) = self else { return };
        match fields.iter_mut().find(|(k, _)| k == key) {
            Some((_, old)) => *old = value.into(),
            None => fields.push((String::from(key), value.into())),
        }
    }

    /// Removes `key` if this is an object that has it.
    pub fn remove(&mut self, key: &str) {
        if let Self::Object(fields) = self {
            fields.retain(|(k, _)| k != key);
        }
    }

    /// JSON text, indented where a line would be too long. Every finite number reads back to the
    /// same bits; other numbers become `null`, because JSON has none.
    pub fn to_json(&self) -> String {
        let mut out = String::new();
        self.write_json(&mut out, 0);
        out
    }

    /// JSON text on one line, for files with a value per line (JSONL). Numbers are written as by
    /// [`Self::to_json`].
    pub fn to_json_line(&self) -> String {
        let mut out = String::new();
        self.write_flat(&mut out, usize::MAX);
        out
    }

    fn write_json(&self, out: &mut String, indent: usize) {
        let start = out.len();
        let limit = if self.is_nested() { start + LINE.saturating_sub(indent) } else { usize::MAX };
        if self.write_flat(out, limit) {
            return;
        }
        out.truncate(start);
        let inner = indent + 2;
        let (open, close) = if matches!(self, Self::List(_)) { ('[', ']') } else { ('{', '}') };
        out.push(open);
        let mut separator = "\n";
        let mut entry = |out: &mut String, key: Option<&str>, value: &Node| {
            out.push_str(separator);
            separator = ",\n";
            out.extend(core::iter::repeat_n(' ', inner));
            if let Some(key) = key {
                write_string(out, key);
                out.push_str(": ");
            }
            value.write_json(out, inner);
        };
        match self {
            Self::List(items) => items.iter().for_each(|v| entry(out, None, v)),
            Self::Object(fields) => fields.iter().for_each(|(k, v)| entry(out, Some(k), v)),
            _ => {}
        }
        out.push('\n');
        out.extend(core::iter::repeat_n(' ', indent));
        out.push(close);
    }

    fn is_nested(&self) -> bool {
        match self {
            Self::List(items) => !items.is_empty(),
            Self::Object(fields) => !fields.is_empty(),
            _ => false,
        }
    }

    /// Writes the value on one line. Stops, and returns `false`, once `out` is longer than `limit`,
    /// so that a long value is not written out at every level of its nesting.
    fn write_flat(&self, out: &mut String, limit: usize) -> bool {
        match self {
            Self::Null => out.push_str("null"),
            Self::Bool(b) => out.push_str(if *b { "true" } else { "false" }),
            Self::Integer(i) => _ = write!(out, "{i}"),
            Self::Number(x) if !x.is_finite() => out.push_str("null"),
            // Debug, unlike Display, keeps the point or the exponent that marks a float. It is the
            // shortest text that reads back to the same bits.
            Self::Number(x) => _ = write!(out, "{x:?}"),
            Self::Text(s) => write_string(out, s),
            Self::List(items) => {
                let mut open = "[";
                for item in items {
                    out.push_str(core::mem::replace(&mut open, ", "));
                    if !item.write_flat(out, limit) {
                        return false;
                    }
                }
                out.push_str(if items.is_empty() { "[]" } else { "]" });
            }
            Self::Object(fields) => {
                let mut open = "{";
                for (key, value) in fields {
                    out.push_str(core::mem::replace(&mut open, ", "));
                    write_string(out, key);
                    out.push_str(": ");
                    if !value.write_flat(out, limit) {
                        return false;
                    }
                }
                out.push_str(if fields.is_empty() { "{}" } else { "}" });
            }
        }
        out.len() <= limit
    }
}

/// The word for `value` in a table of words.
pub(super) fn word_of<T: PartialEq>(words: &[(&'static str, T)], value: T) -> Node {
    words.iter().find(|(_, v)| *v == value).map(|(word, _)| *word).into()
}

fn write_string(out: &mut String, s: &str) {
    out.push('"');
    for c in s.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if u32::from(c) < 0x20 => _ = write!(out, "\\u{:04x}", u32::from(c)),
            c => out.push(c),
        }
    }
    out.push('"');
}

impl From<f64> for Node {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}
impl From<i64> for Node {
    fn from(i: i64) -> Self {
        Self::Integer(i)
    }
}

impl From<u32> for Node {
    fn from(i: u32) -> Self {
        Self::Integer(i64::from(i))
    }
}
impl From<bool> for Node {
    fn from(b: bool) -> Self {
        Self::Bool(b)
    }
}
impl From<&str> for Node {
    fn from(s: &str) -> Self {
        Self::Text(String::from(s))
    }
}
impl From<&String> for Node {
    fn from(s: &String) -> Self {
        Self::Text(s.clone())
    }
}
impl From<String> for Node {
    fn from(s: String) -> Self {
        Self::Text(s)
    }
}
impl<T: Into<Node>> From<Option<T>> for Node {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Null, Into::into)
    }
}
impl<const N: usize> From<[f64; N]> for Node {
    fn from(v: [f64; N]) -> Self {
        Self::list(v)
    }
}
