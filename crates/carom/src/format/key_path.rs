//! Paths of values in a shot file, such as `physics.cloth.sliding_friction`, `balls.cue.position`
//! or `balls.cue.position[0]`.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use super::node::Node;
use crate::error::{Error, ErrorKind};

/// The path of a value in a shot file: keys with dots between them, `[i]` for an item of a list. A
/// ball may be named by its id.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyPath {
    steps: Vec<PathStep>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum PathStep {
    /// A key, or the id of an item.
    Key(String),
    Item(usize),
}

impl KeyPath {
    /// Reads a path.
    ///
    /// # Errors
    /// [`Error::Input`] for a text that is not a path.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let refuse = |what: &str| {
            let remedy = "write keys with dots between them, such as strike.speed, \
                          physics.cloth.sliding_friction, balls.cue.position or balls.cue.position[0]";
            ErrorKind::Syntax.at(text, what, remedy)
        };
        let mut steps = Vec::new();
        for part in text.split('.') {
            let mut items = part.split('[');
            let key = items.next().unwrap_or_default();
            if key.is_empty() {
                return Err(refuse("a key of the path is empty"));
            }
            steps.push(PathStep::Key(key.into()));
            for item in items {
                let number = item.strip_suffix(']').and_then(|digits| digits.parse().ok());
                steps.push(PathStep::Item(number.ok_or_else(|| refuse("an item has no number"))?));
            }
        }
        Ok(Self { steps })
    }

    /// Whether `other` is the same path or the path of a value inside this one.
    pub fn contains(&self, other: &Self) -> bool {
        other.steps.starts_with(&self.steps)
    }

    /// Whether the path consists of these keys.
    pub(super) fn is(&self, keys: &[&str]) -> bool {
        let is_key =
            |(step, key): (&PathStep, &&str)| matches!(step, PathStep::Key(own) if own == *key);
        self.steps.len() == keys.len() && self.steps.iter().zip(keys).all(is_key)
    }

    /// Replaces the value in `file` at this path; missing keys are added.
    pub(super) fn set(&self, file: &mut Node, value: Node) -> Result<(), Error> {
        let mut node = file;
        for (depth, step) in self.steps.iter().enumerate() {
            node = inside(node, step).map_err(|(what, remedy)| {
                ErrorKind::UnknownKey.at(
                    Self { steps: self.steps[..=depth].into() }.to_string(),
                    what,
                    remedy,
                )
            })?;
        }
        *node = value;
        Ok(())
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.steps.iter().enumerate() {
            match step {
                PathStep::Key(key) => write!(f, "{}{key}", if i > 0 { "." } else { "" })?,
                PathStep::Item(item) => write!(f, "[{item}]")?,
            }
        }
        Ok(())
    }
}

/// The value in `node` at `step`; a missing key is added. The error is what is wrong, and the
/// remedy.
fn inside<'a>(node: &'a mut Node, step: &PathStep) -> Result<&'a mut Node, (String, String)> {
    // A preset's name becomes the base of an object, so that one of its values can be changed.
    if let Node::Text(_) = node {
        *node = Node::object([("base", node.clone())]);
    }
    match (node, step) {
        (Node::Object(fields), PathStep::Key(key)) => {
            let at = fields.iter().position(|(k, _)| k == key).unwrap_or_else(|| {
                fields.push((key.clone(), Node::object([])));
                fields.len() - 1
            });
            Ok(&mut fields[at].1)
        }
        (Node::List(items), PathStep::Item(item)) => {
            let count = items.len();
            items
                .get_mut(*item)
                .ok_or_else(|| (format!("the list has {count} items"), "count them from 0".into()))
        }
        (Node::List(items), PathStep::Key(key)) => {
            let has_id = |item: &Node| item.get("id") == Some(&Node::Text(key.clone()));
            items.iter_mut().find(|item| has_id(item)).ok_or_else(|| {
                (format!("nothing here has the id \"{key}\""), "write an id, or [0]".into())
            })
        }
        (Node::Object(_), PathStep::Item(_)) => {
            Err(("an object has no items".into(), "write a dot and a key after it".into()))
        }
        _ => Err((
            "a number has no values inside".into(),
            "write the path of the number, or of a list or an object".into(),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShotFile;

    fn shot() -> ShotFile {
        let file = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.6, 0.6]}, {"id": "1", "position": [0.6, 1.9]}],
            "strike": {"ball": "cue", "speed": 2, "azimuth_deg": 90}}"#;
        ShotFile::from_json(file).unwrap()
    }

    fn with(path: &str, value: impl Into<Node>) -> Result<ShotFile, Error> {
        shot().with_values([(&KeyPath::parse(path)?, value.into())])
    }

    #[test]
    fn a_value_in_a_preset_leaves_the_rest_of_it_as_it_is() {
        let changed = with("physics.cloth.sliding_friction", 0.3).unwrap();
        assert_eq!(changed.physics().cloth.sliding_friction, 0.3);
        let before = shot();
        assert_eq!(
            changed.physics().cloth.rolling_friction,
            before.physics().cloth.rolling_friction
        );
        assert_eq!(changed.balls(), before.balls());
        let higher = with("table.cushion_height", 0.037).unwrap();
        assert_ne!(higher.table(), before.table());
    }

    #[test]
    fn balls_are_named_by_their_id_or_counted() {
        let moved = with("balls.1.position[1]", 1.5).unwrap();
        assert_eq!(moved.balls()[1].state.position.y, 1.5);
        assert_eq!(moved.balls()[1].state.position.x, 0.6);
        assert_eq!(moved, with("balls[1].position", [0.6, 1.5]).unwrap());
    }

    #[test]
    fn a_value_that_a_shot_file_may_not_have_is_refused_with_its_place() {
        for (path, value, place) in [
            ("physics.cloth.slide", Node::Number(0.1), "physics.cloth.slide: unknown key"),
            ("balls.9.position", Node::Number(0.1), "balls.9: nothing here has the id \"9\""),
            ("balls[7].position", Node::Number(0.1), "balls[7]: the list has 2 items"),
            ("strike.speed.x", Node::Number(0.1), "strike.speed.x: a number has no values inside"),
            ("strike[0]", Node::Number(0.1), "strike[0]: an object has no items"),
            ("strike.speed", Node::Number(-1.0), "strike.speed: -1.0 is out of range"),
            (
                "balls.cue.position",
                Node::from([0.6, 1.9]),
                "balls[1].position: ball \"1\" overlaps",
            ),
            ("strike..speed", Node::Number(1.0), "strike..speed: a key of the path is empty"),
            ("balls[x]", Node::Number(1.0), "balls[x]: an item has no number"),
        ] {
            let error = with(path, value).unwrap_err().to_string();
            assert!(error.starts_with(place), "{error}");
        }
    }

    #[test]
    fn a_path_reads_back_as_it_was_written() {
        for text in ["strike.speed", "balls[3].position[0]", "table"] {
            assert_eq!(KeyPath::parse(text).unwrap().to_string(), text);
        }
        let [outer, inner] = ["physics", "physics.cloth"].map(|text| KeyPath::parse(text).unwrap());
        assert!(outer.contains(&inner) && outer.contains(&outer) && !inner.contains(&outer));
    }
}
