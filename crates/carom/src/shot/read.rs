//! Reading a [`Node`] tree strictly: every refusal names the place, what is wrong there, and what
//! would be right.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::node::Node;
use crate::error::Error;

/// No number in a shot is larger than this, whatever its unit. It keeps every product that the
/// engine forms far from overflow; a kilometre, a tonne and a year all fit.
pub(crate) const LARGEST: f64 = 1e9;

/// A mass, radius, length or gravity that must be positive is at least this (a nanogram-like
/// ball would only divide by almost zero).
pub(crate) const SMALLEST: f64 = 1e-9;

/// A parameter smaller than this, whatever its unit, means 0: its square would underflow, and
/// quotients by it overflow. −0 means 0 too, since 1/−0 is not 1/0.
const VANISHING: f64 = 1e-150;

/// The numbers that a key accepts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    low: f64,
    high: f64,
    low_open: bool,
    high_open: bool,
    /// Unit, with a leading space, or empty.
    unit: &'static str,
}

impl Range {
    /// Any finite number, in `unit`.
    pub(crate) const fn any(unit: &'static str) -> Self {
        Self { low: -LARGEST, high: LARGEST, low_open: false, high_open: false, unit }
    }
    /// [low, high].
    pub(crate) const fn closed(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: false, high_open: false, unit }
    }
    /// [low, high).
    pub(crate) const fn half_open(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: false, high_open: true, unit }
    }
    /// (low, high].
    pub(crate) const fn above(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, low_open: true, high_open: false, unit }
    }
    /// Greater than zero.
    pub(crate) const fn positive(unit: &'static str) -> Self {
        Self::closed(SMALLEST, LARGEST, unit)
    }
    /// Zero or more.
    pub(crate) const fn not_negative(unit: &'static str) -> Self {
        Self::closed(0.0, LARGEST, unit)
    }

    /// Refuses `x`, which stands at `place`, if it is out of range or not finite.
    pub(crate) fn check(&self, place: impl FnOnce() -> String, x: f64) -> Result<(), Error> {
        let above = if self.low_open { x > self.low } else { x >= self.low };
        let below = if self.high_open { x < self.high } else { x <= self.high };
        if above && below {
            return Ok(());
        }
        let what = if x.is_finite() {
            format!("{x:?} is out of range")
        } else {
            format!("{} is not a number that a shot can use", describe(&Node::Number(x)))
        };
        Err(Error::input(place(), what, format!("write {}", self.describe())))
    }

    /// Whether any finite number may stand here, since it is one that an engine wrote. Such keep
    /// their bits.
    const fn is_result(&self) -> bool {
        self.high == f64::MAX
    }

    fn describe(&self) -> String {
        let unit = self.unit;
        if self.is_result() {
            let sign = if self.low == 0.0 { " ≥ 0" } else { "" };
            return format!("a finite number{sign}{unit}");
        }
        if self.low == SMALLEST && self.high == LARGEST {
            let unit = if unit.is_empty() { String::new() } else { format!(", in{unit}") };
            return format!("a number greater than 0{unit} (from {SMALLEST:e} to {LARGEST:e})");
        }
        let open = if self.low_open { '(' } else { '[' };
        let close = if self.high_open { ')' } else { ']' };
        if self.low == 0.0 && self.high == LARGEST {
            return format!("a number ≥ 0{unit} (at most {LARGEST:e})");
        }
        if self.low == -LARGEST && self.high == LARGEST {
            return format!("a finite number (at most {LARGEST:e} in size)");
        }
        format!("a number in {open}{}, {}{close}{unit}", self.low, self.high)
    }
}

/// A node and where it stands.
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

    /// The node's path, such as `balls[3].position`; empty for the whole input.
    pub(crate) fn place(&self) -> &str {
        &self.place
    }

    /// Refuses what stands here.
    pub(crate) fn refuse(&self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::input(&*self.place, what, remedy)
    }

    fn wrong_type(&self, wanted: &str) -> Error {
        self.refuse(format!("found {}", describe(self.node)), format!("write {wanted}"))
    }

    /// The fields of an object, none of which may be unknown.
    pub(crate) fn fields(&self, allowed: &'static [&'static str]) -> Result<Fields<'a>, Error> {
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
                return Err(Error::input(place, "unknown key", remedy));
            }
        }
        Ok(Fields { fields, at: self.clone() })
    }

    /// The fields of an object, known or not.
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

    /// Whether an object stands here.
    pub(crate) const fn is_object(&self) -> bool {
        matches!(self.node, Node::Object(_))
    }

    /// A string.
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
        Ok(if x.abs() < VANISHING && !range.is_result() { 0.0 } else { x })
    }

    /// A whole number from `low` up to `high`.
    pub(crate) fn whole(&self, low: u32, high: u32) -> Result<u32, Error> {
        let wanted = format!("a whole number from {low} to {high}");
        let i = match self.node {
            Node::Integer(i) => *i,
            // 100.0 is how some writers spell 100.
            Node::Number(x) if *x == (*x as i64) as f64 => *x as i64,
            Node::Number(x) => {
                return Err(
                    self.refuse(format!("{x:?} is not a whole number"), format!("write {wanted}"))
                );
            }
            _ => return Err(self.wrong_type(&wanted)),
        };
        match u32::try_from(i) {
            Ok(i) if (low..=high).contains(&i) => Ok(i),
            _ => Err(self.refuse(format!("{i} is out of range"), format!("write {wanted}"))),
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
            return Err(self.refuse(found, format!("write {}", wanted())));
        }
        // The place of a number is put into words only where it is refused.
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

    /// One of a few words; `kind` is what they are called.
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

    /// Refuses `word`, which is none of the `known` ones.
    pub(crate) fn unknown_word(&self, word: &str, kind: &str, known: &[&'static str]) -> Error {
        let remedy = match nearest(word, known) {
            Some(near) => format!("did you mean \"{near}\"? (known: {})", quoted(known)),
            None => format!("write one of {}", quoted(known)),
        };
        self.refuse(format!("there is no {kind} \"{word}\""), remedy)
    }
}

/// The fields of an object, all known.
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
        self.get(key).ok_or_else(|| {
            Error::input(self.at.child_place(key), "the key is missing", format!("write {example}"))
        })
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
        Node::Number(x) if x.is_nan() => "NaN".into(),
        Node::Number(x) if x.is_infinite() => "an infinite number".into(),
        Node::Number(x) => format!("the number {x:?}"),
        Node::Text(s) if s.chars().count() <= 40 => format!("the text \"{s}\""),
        Node::Text(_) => "a text".into(),
        Node::List(items) => format!("a list of {}", items.len()),
        Node::Object(_) => "an object".into(),
    }
}

/// The known word that `word` most likely was meant to be.
fn nearest(word: &str, known: &[&'static str]) -> Option<&'static str> {
    // A third of the letters wrong is still a slip of the fingers; more is another word.
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
