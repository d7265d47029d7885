//! Reading a [`Node`] tree strictly: every error names the place, the fault and the remedy.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Display;

use super::node::Node;
use crate::error::{Error, ErrorKind};
use crate::range::{Range, describe_number, or_zero};

/// Reads a value of another file format by the rules of shot files, with the same error messages.
#[derive(Clone, Debug)]
pub struct Reader<'a>(At<'a>);

impl<'a> Reader<'a> {
    /// A reader of `node`; `place` is its path in the file, such as `vary.strike.speed`.
    pub fn new(node: &'a Node, place: &str) -> Self {
        Self(At { node, place: place.into() })
    }

    /// Checks that the value is an object without unknown keys.
    ///
    /// # Errors
    /// [`Error::Input`] with the first unknown key and the most similar known key.
    pub fn keys(&self, known: &[&str]) -> Result<(), Error> {
        self.0.fields(known).map(drop)
    }

    /// Checks that the value, the `format` of a file, is this one.
    ///
    /// # Errors
    /// [`Error::Input`] that names the file's kind, if it is another one of carom's.
    pub fn format(&self, expected: &'static str) -> Result<(), Error> {
        self.0.format(expected)
    }

    /// The value as a finite number.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not one, or larger than any number of a shot file.
    pub fn number(&self) -> Result<f64, Error> {
        self.0.number(&Range::any(""))
    }

    /// The value as a whole number from `low` up to `high`.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not one.
    pub fn whole(&self, low: i64, high: i64) -> Result<i64, Error> {
        self.0.whole(low, high)
    }

    /// The value as a finite number with exactly its bits: a tiny number stays what it is, and −0
    /// stays −0. For records of what was computed.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not a finite number.
    pub fn exact_number(&self) -> Result<f64, Error> {
        match *self.0.node {
            Node::Number(x) if x.is_finite() => Ok(x),
            Node::Integer(i) => Ok(i as f64),
            _ => Err(self.wrong_type("a finite number")),
        }
    }

    /// The value as a text; `wanted` says what to write.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not a text.
    pub fn text(&self, wanted: &str) -> Result<&'a str, Error> {
        self.0.text(wanted)
    }

    /// The value as `true` or `false`.
    ///
    /// # Errors
    /// [`Error::Input`] if it is neither.
    pub fn flag(&self) -> Result<bool, Error> {
        self.0.flag()
    }

    /// The items of a list; `wanted` says what to write.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not a list.
    pub fn items(&self, wanted: &str) -> Result<Vec<Self>, Error> {
        Ok(self.0.items(wanted)?.into_iter().map(Self).collect())
    }

    /// The value under `key`; none if this is not an object that has it, or if it is `null`.
    pub fn get(&self, key: &str) -> Option<Self> {
        let node = self.0.node.get(key).filter(|node| **node != Node::Null)?;
        Some(Self(At { node, place: self.0.child_place(key) }))
    }

    /// The value under `key`, which must be there; `example` shows how to write it.
    ///
    /// # Errors
    /// [`Error::Input`] if this is not an object that has it.
    pub fn require(&self, key: &str, example: &str) -> Result<Self, Error> {
        let at = self.0.known_fields()?.require(key, example)?;
        Ok(Self(at))
    }

    /// The value itself.
    pub const fn node(&self) -> &'a Node {
        self.0.node
    }

    /// The path of the value, such as `moves[3].play`.
    pub fn place(&self) -> &str {
        self.0.place()
    }

    /// An error at the place of the value.
    pub fn refuse(
        &self,
        kind: ErrorKind,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        self.0.refuse(kind, what, remedy)
    }

    /// The error for a value of a wrong type; `wanted` names what to write instead.
    pub fn wrong_type(&self, wanted: &str) -> Error {
        self.0.wrong_type(wanted)
    }

    /// The error for an unknown word; `kind` names what the `known` words are.
    pub fn unknown_word(&self, word: &str, kind: &str, known: &[&str]) -> Error {
        self.0.unknown_word(word, kind, known)
    }
}

/// A node and its place in the input.
#[derive(Clone, Debug)]
pub(crate) struct At<'a> {
    node: &'a Node,
    place: String,
}

impl<'a> At<'a> {
    /// The whole input.
    pub(crate) const fn root(node: &'a Node) -> Self {
        Self { node, place: String::new() }
    }

    /// The node itself.
    pub(crate) const fn node(&self) -> &'a Node {
        self.node
    }

    /// The place of the node, such as `balls[3].position`; empty for the whole input.
    pub(crate) fn place(&self) -> &str {
        &self.place
    }

    /// An error at this place.
    pub(crate) fn refuse(
        &self,
        kind: ErrorKind,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        kind.at(&*self.place, what, remedy)
    }

    fn wrong_type(&self, wanted: &str) -> Error {
        let kind = match self.node {
            Node::Null => ErrorKind::Missing,
            _ => ErrorKind::WrongType,
        };
        self.refuse(kind, format!("found {}", describe(self.node)), format!("write {wanted}"))
    }

    /// The fields of an object; unknown keys are refused.
    pub(crate) fn fields(&self, allowed: &[&str]) -> Result<Fields<'a>, Error> {
        let Node::Object(fields) = self.node else {
            return Err(self.wrong_type("an object {...}"));
        };
        for (key, _) in fields {
            if !allowed.contains(&key.as_str()) {
                let place = self.child_place(key);
                let remedy = match nearest(key, allowed) {
                    Some(known) => {
                        format!("did you mean `{known}`? (known here: {})", allowed.join(", "))
                    }
                    None => format!("the keys known here are {}", allowed.join(", ")),
                };
                return Err(ErrorKind::UnknownKey.at(place, "unknown key", remedy));
            }
        }
        Ok(Fields { fields, at: self.clone() })
    }

    /// The fields of an object; unknown keys are accepted.
    pub(crate) fn known_fields(&self) -> Result<Fields<'a>, Error> {
        match self.node {
            Node::Object(fields) => Ok(Fields { fields, at: self.clone() }),
            _ => Err(self.wrong_type("an object {...}")),
        }
    }

    fn child_place(&self, key: &str) -> String {
        if self.place.is_empty() { key.into() } else { format!("{}.{key}", self.place) }
    }

    /// The items of a list.
    pub(crate) fn items(&self, wanted: &str) -> Result<Vec<At<'a>>, Error> {
        let Node::List(items) = self.node else { return Err(self.wrong_type(wanted)) };
        Ok(items
            .iter()
            .enumerate()
            .map(|(i, node)| At { node, place: format!("{}[{i}]", self.place) })
            .collect())
    }

    /// Whether this is an object.
    pub(crate) const fn is_object(&self) -> bool {
        matches!(self.node, Node::Object(_))
    }

    /// Whether this is a string.
    pub(crate) const fn is_text(&self) -> bool {
        matches!(self.node, Node::Text(_))
    }

    /// A string.
    pub(crate) fn flag(&self) -> Result<bool, Error> {
        match self.node {
            Node::Bool(flag) => Ok(*flag),
            _ => Err(self.wrong_type("true or false")),
        }
    }

    pub(crate) fn text(&self, wanted: &str) -> Result<&'a str, Error> {
        match self.node {
            Node::Text(s) => Ok(s),
            _ => Err(self.wrong_type(wanted)),
        }
    }

    /// A number in `range`.
    pub(crate) fn number(&self, range: &Range) -> Result<f64, Error> {
        let x = match self.node {
            Node::Integer(i) => *i as f64,
            Node::Number(x) => *x,
            _ => return Err(self.wrong_type(&range.describe())),
        };
        range.check(|| self.place.clone(), x)?;
        Ok(if range.is_result() { x } else { or_zero(x) })
    }

    /// A whole number from `low` up to `high`.
    pub(crate) fn whole<T>(&self, low: T, high: T) -> Result<T, Error>
    where
        T: TryFrom<i64> + PartialOrd + Display,
    {
        let wanted = format!("a whole number from {low} to {high}");
        let i = match self.node {
            Node::Integer(i) => *i,
            // Some writers write 100 as 100.0.
            Node::Number(x) if *x == (*x as i64) as f64 => *x as i64,
            Node::Number(x) => {
                return Err(self.refuse(
                    ErrorKind::OutOfRange,
                    format!("{x:?} is not a whole number"),
                    format!("write {wanted}"),
                ));
            }
            _ => return Err(self.wrong_type(&wanted)),
        };
        match T::try_from(i) {
            Ok(i) if (low..=high).contains(&i) => Ok(i),
            _ => Err(self.refuse(
                ErrorKind::OutOfRange,
                format!("{i} is out of range"),
                format!("write {wanted}"),
            )),
        }
    }

    /// Between `low` and `high` numbers, each finite.
    pub(crate) fn numbers(&self, low: usize, high: usize) -> Result<Vec<f64>, Error> {
        self.numbers_in(low, high, &Range::any(""))
    }

    /// Between `low` and `high` numbers, each in `range`.
    pub(crate) fn numbers_in(
        &self,
        low: usize,
        high: usize,
        range: &Range,
    ) -> Result<Vec<f64>, Error> {
        let wanted = || {
            if low == high {
                format!("a list of {low} numbers")
            } else {
                format!("a list of {low} or {high} numbers")
            }
        };
        let Node::List(items) = self.node else { return Err(self.wrong_type(&wanted())) };
        if !(low..=high).contains(&items.len()) {
            let found = format!("found a list of {}", items.len());
            return Err(self.refuse(ErrorKind::WrongCount, found, format!("write {}", wanted())));
        }
        // The place of a number is formatted only if it is refused.
        let number = |(i, node): (usize, &'a Node)| match node {
            Node::Number(x) if range.check(String::new, *x).is_ok() => Ok(*x),
            _ => At { node, place: format!("{}[{i}]", self.place) }.number(range),
        };
        items.iter().enumerate().map(number).collect()
    }

    /// Three numbers.
    pub(crate) fn vector(&self) -> Result<crate::math::Vec3, Error> {
        let v = self.numbers(3, 3)?;
        Ok(crate::math::Vec3::new(v[0], v[1], v[2]))
    }

    /// One of a few words; `kind` names them in errors.
    pub(crate) fn choice<T: Copy>(
        &self,
        kind: &str,
        options: &[(&'static str, T)],
    ) -> Result<T, Error> {
        let names: Vec<&'static str> = options.iter().map(|(name, _)| *name).collect();
        let word = self.text(&format!("one of {}", quoted(&names)))?;
        match options.iter().find(|(name, _)| *name == word) {
            Some((_, value)) => Ok(*value),
            None => Err(self.unknown_word(word, kind, &names)),
        }
    }

    /// The error for `word`, which is not one of the `known` ones.
    pub(crate) fn unknown_word(&self, word: &str, kind: &str, known: &[&str]) -> Error {
        let remedy = match nearest(word, known) {
            Some(near) => format!("did you mean \"{near}\"? (known: {})", quoted(known)),
            None => format!("write one of {}", quoted(known)),
        };
        self.refuse(ErrorKind::UnknownName, format!("there is no {kind} \"{word}\""), remedy)
            .with("name", word)
    }
}

/// The fields of an object.
#[derive(Clone, Debug)]
pub(crate) struct Fields<'a> {
    fields: &'a [(String, Node)],
    at: At<'a>,
}

impl<'a> Fields<'a> {
    /// The value under `key`, if it is there.
    pub(crate) fn get(&self, key: &str) -> Option<At<'a>> {
        let (_, node) = self.fields.iter().find(|(k, _)| k == key)?;
        Some(At { node, place: self.at.child_place(key) })
    }

    /// The value under `key`, which must be there; `example` shows how to write it.
    pub(crate) fn require(&self, key: &str, example: &str) -> Result<At<'a>, Error> {
        self.get(key).ok_or_else(|| self.missing(key, example))
    }

    /// The error for a missing `key`; `example` shows how to write its value.
    pub(crate) fn missing(&self, key: &str, example: &str) -> Error {
        ErrorKind::Missing.at(
            self.at.child_place(key),
            "the key is missing",
            format!("write {example}"),
        )
    }

    /// Overwrites `target` with the number under `key`, if it is there.
    pub(crate) fn number_into(
        &self,
        key: &str,
        range: &Range,
        target: &mut f64,
    ) -> Result<(), Error> {
        if let Some(at) = self.get(key) {
            *target = at.number(range)?;
        }
        Ok(())
    }
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|w| format!("\"{w}\"")).collect::<Vec<_>>().join(", ")
}

fn describe(node: &Node) -> String {
    match node {
        Node::Null => "null".into(),
        Node::Bool(b) => b.to_string(),
        Node::Integer(i) => format!("the number {i}"),
        Node::Number(x) => describe_number(*x),
        Node::Text(s) if s.chars().count() <= 40 => format!("the text \"{s}\""),
        Node::Text(_) => "a text".into(),
        Node::List(items) => format!("a list of {}", items.len()),
        Node::Object(_) => "an object".into(),
    }
}

/// The known word that `word` was most likely meant to be.
fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    // More wrong letters than a third are another word rather than a typing error.
    let slips = (word.chars().count() / 3).max(2);
    let extends = |k: &&&str| word.len() >= 3 && (k.starts_with(word) || word.starts_with(**k));
    known
        .iter()
        .map(|k| (edit_distance(word, k), *k))
        .filter(|(d, k)| *d <= slips && *d < k.chars().count())
        .min_by_key(|(d, _)| *d)
        .map(|(_, k)| k)
        .or_else(|| known.iter().find(extends).copied())
}

/// Insertions, deletions and substitutions that turn `a` into `b` (Levenshtein 1966).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().take(64).enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, cb) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(!ca.eq_ignore_ascii_case(cb));
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(all(test, feature = "json"))]
mod tests {
    use super::{Node, Reader};

    fn node(text: &str) -> Node {
        Node::from_json(text).unwrap()
    }

    #[test]
    fn an_exact_number_keeps_its_bits() {
        for x in [-0.0, 1e-200, 0.1, f64::MIN_POSITIVE, f64::MAX] {
            let text = Node::Number(x).to_json_line();
            let read = Reader::new(&node(&text), "x").exact_number().unwrap();
            assert_eq!(read.to_bits(), x.to_bits(), "{text}");
        }
        for wrong in ["null", "\"1\"", "[1]"] {
            let error = Reader::new(&node(wrong), "x").exact_number().unwrap_err().to_string();
            assert!(error.starts_with("x: found "), "{error}");
        }
    }

    #[test]
    fn a_reader_reads_values_inside_and_names_their_places() {
        let file = node(r#"{"list": [{"on": true, "word": "yes"}], "none": null}"#);
        let reader = Reader::new(&file, "");
        let items = reader.require("list", "a list").unwrap().items("a list").unwrap();
        let item = &items[0];
        assert_eq!(item.place(), "list[0]");
        assert_eq!(item.require("on", "true").unwrap().flag(), Ok(true));
        assert_eq!(item.require("word", "a text").unwrap().text("a text"), Ok("yes"));
        assert!(reader.get("none").is_none() && reader.get("absent").is_none());
        let missing = item.require("other", "a number").unwrap_err().to_string();
        assert_eq!(missing, "list[0].other: the key is missing; write a number");
        let wrong = item.get("word").unwrap().flag().unwrap_err().to_string();
        assert!(wrong.starts_with("list[0].word: found the text"), "{wrong}");
    }

    #[test]
    fn a_value_on_one_line_reads_back() {
        let text = format!(r#"{{"numbers": [{}], "text": "a\nb"}}"#, vec!["0.125"; 60].join(", "));
        let line = node(&text).to_json_line();
        assert!(!line.contains('\n') && line.len() > 200);
        assert_eq!(node(&line), node(&text));
    }
}
