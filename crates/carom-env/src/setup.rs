//! The table and the physics of an environment, and variables of both that every episode draws.

use carom::format::Node;
use carom::sample::Distribution;
use carom::{Error, ErrorKind};

use crate::random::Dice;

/// Layouts of variables that are tried until the table and the physics can exist: a normal law may draw
/// a negative friction.
const TRIES: u32 = 100;

/// Table and physics, as in a shot file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Setup {
    /// The table; `None` for the task's own.
    pub table: Option<Node>,
    /// The physics; `None` for the table's own.
    pub physics: Option<Node>,
}

/// A number of the physics or of the table that every episode draws from a law.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The keys, separated by points, such as `cloth.rolling_friction`. A key of the table begins with
    /// `table`, as in `table.cushion_height`.
    pub path: String,
    /// The law.
    pub law: VariableLaw,
}

/// The law of a variable.
#[derive(Clone, Debug, PartialEq)]
pub enum VariableLaw {
    /// A distribution.
    Distribution(Distribution),
    /// One of these numbers, each with the same probability.
    Choice(Vec<f64>),
}

impl VariableLaw {
    const NAMES: &'static str = "uniform, log_uniform, normal, choice";

    /// The law in `node`, at `place`: two numbers for a uniform one, or an object with its name as the key.
    fn from_node(node: &Node, place: &str) -> Result<Self, Error> {
        let wrong = |kind: ErrorKind, what: &str, remedy: &str| Err(kind.at(place, what, remedy));
        let (name, numbers) = match node {
            Node::List(_) => ("uniform", node),
            Node::Object(fields) if fields.len() == 1 => (fields[0].0.as_str(), &fields[0].1),
            _ => {
                let remedy =
                    format!("write (low, high), or one of {} with its numbers", Self::NAMES);
                return wrong(ErrorKind::WrongType, "it is not a law", &remedy);
            }
        };
        let numbers: Option<Vec<f64>> = match numbers {
            Node::List(items) => items.iter().map(number).collect(),
            _ => None,
        };
        let numbers = numbers.filter(|numbers| numbers.iter().all(|x| x.is_finite()));
        let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) else {
            return wrong(
                ErrorKind::WrongType,
                "it does not have finite numbers",
                "write a list of numbers",
            );
        };
        let pair = || match numbers[..] {
            [a, b] => Ok([a, b]),
            _ => Err(ErrorKind::WrongCount.at(
                place,
                format!("{name} has two numbers"),
                "write two numbers",
            )),
        };
        let rising = || {
            pair().and_then(|[low, high]| {
                if low <= high {
                    Ok([low, high])
                } else {
                    Err(ErrorKind::OutOfRange.at(place, "the first number is larger", "swap them"))
                }
            })
        };
        match name {
            "uniform" => {
                rising().map(|[low, high]| Self::Distribution(Distribution::Uniform(low, high)))
            }
            "log_uniform" => match rising()? {
                [low, _] if low <= 0.0 => {
                    wrong(ErrorKind::OutOfRange, "a logarithm needs numbers above 0", "raise them")
                }
                [low, high] => Ok(Self::Distribution(Distribution::LogUniform(low, high))),
            },
            "normal" => match pair()? {
                [_, deviation] if deviation < 0.0 => wrong(
                    ErrorKind::OutOfRange,
                    "the standard deviation is negative",
                    "write it without the sign",
                ),
                [mean, deviation] => Ok(Self::Distribution(Distribution::Normal(mean, deviation))),
            },
            "choice" => Ok(Self::Choice(numbers)),
            _ => wrong(
                ErrorKind::UnknownName,
                &format!("there is no law \"{name}\""),
                &format!("write one of {}", Self::NAMES),
            ),
        }
    }

    fn draw(&self, dice: &mut Dice) -> f64 {
        match self {
            Self::Distribution(distribution) => distribution.quantile(dice.inner()),
            Self::Choice(numbers) => numbers[dice.below(numbers.len())],
        }
    }
}

fn number(node: &Node) -> Option<f64> {
    match node {
        Node::Number(x) => Some(*x),
        Node::Integer(i) => Some(*i as f64),
        _ => None,
    }
}

impl Variable {
    /// The variables of an object whose keys are paths and whose values are laws.
    ///
    /// # Errors
    /// [`Error::Input`] at `randomize` for another node, and for a law that does not exist.
    pub fn read_all(node: &Node) -> Result<Vec<Self>, Error> {
        let Node::Object(fields) = node else {
            let remedy = "write keys of the physics with laws, such as cloth.rolling_friction: (0.008, 0.012)";
            return Err(ErrorKind::WrongType.at("randomize", "it is not an object", remedy));
        };
        let read = |(path, law): &(String, Node)| {
            let law = VariableLaw::from_node(law, &format!("randomize.{path}"))?;
            Ok(Self { path: path.clone(), law })
        };
        fields.iter().map(read).collect()
    }
}

impl Setup {
    /// Draws `variables` with the seed of an episode until `accepts` takes the table and the physics with
    /// them. Returns the numbers.
    ///
    /// # Errors
    /// The last error of `accepts`.
    pub(crate) fn draw(
        &self,
        variables: &[Variable],
        seed: u64,
        mut accepts: impl FnMut(&Self) -> Result<(), Error>,
    ) -> Result<Vec<f64>, Error> {
        let mut dice = Dice::of_setup(seed);
        let mut tried = Ok(());
        for _ in 0..TRIES {
            let drawn: Vec<f64> = variables.iter().map(|one| one.law.draw(&mut dice)).collect();
            tried = accepts(&self.with(variables, &drawn));
            if tried.is_ok() {
                return Ok(drawn);
            }
        }
        tried.map(|()| Vec::new())
    }

    /// The same with `values` for `variables`.
    fn with(&self, variables: &[Variable], values: &[f64]) -> Self {
        let mut setup = self.clone();
        for (variable, value) in variables.iter().zip(values) {
            let keys: Vec<&str> = variable.path.split('.').collect();
            match &keys[..] {
                ["table", rest @ ..] => put(setup.table.get_or_insert(Node::Null), rest, *value),
                ["physics", keys @ ..] | keys => {
                    put(setup.physics.get_or_insert(Node::Null), keys, *value);
                }
            }
        }
        setup
    }
}

/// Sets the value at `keys` in `node`. A name of a preset becomes an object with it as the base.
fn put(node: &mut Node, keys: &[&str], value: f64) {
    let [key, rest @ ..] = keys else {
        *node = value.into();
        return;
    };
    *node = match std::mem::replace(node, Node::Null) {
        Node::Text(name) => Node::object([("base", name.as_str().into())]),
        Node::Object(fields) => Node::Object(fields),
        _ => Node::object([]),
    };
    let mut inner = node.get(key).cloned().unwrap_or(Node::Null);
    put(&mut inner, rest, value);
    node.set(key, inner);
}

#[cfg(test)]
mod tests {
    use core::f64::consts::E;

    use carom::format::Node;
    use carom::sample::Distribution;

    use super::{Setup, Variable, VariableLaw};

    fn variable(path: &str, law: VariableLaw) -> Variable {
        Variable { path: path.into(), law }
    }

    #[test]
    fn a_drawn_number_changes_one_key_of_a_preset_or_of_an_object() {
        let setup = Setup { table: Some("wpa-9ft".into()), physics: None };
        let variables = [
            ("table.cushion_height", 0.037),
            ("cloth.rolling_friction", 0.01),
            ("physics.gravity", 9.8),
        ];
        let values = variables.map(|(_, value)| value);
        let variables =
            variables.map(|(path, value)| variable(path, VariableLaw::Choice(vec![value])));
        let drawn = setup.with(&variables, &values);
        let table = Node::object([("base", "wpa-9ft".into()), ("cushion_height", 0.037.into())]);
        assert_eq!(drawn.table, Some(table));
        let cloth = Node::object([("rolling_friction", 0.01.into())]);
        let physics = Node::object([("cloth", cloth), ("gravity", 9.8.into())]);
        assert_eq!(drawn.physics, Some(physics));
    }

    #[test]
    fn every_law_has_its_mean() {
        for (law, mean) in [
            (VariableLaw::Distribution(Distribution::Uniform(1.0, 3.0)), 2.0),
            (VariableLaw::Distribution(Distribution::LogUniform(1.0, E)), E - 1.0),
            (VariableLaw::Distribution(Distribution::Normal(5.0, 2.0)), 5.0),
            (VariableLaw::Choice(vec![1.0, 2.0, 6.0]), 3.0),
        ] {
            let variables = [variable("gravity", law)];
            let draw =
                |seed| Setup::default().draw(&variables, seed, |_| Ok(())).expect("a draw")[0];
            let found = (0..20_000).map(draw).sum::<f64>() / 20_000.0;
            assert!((found - mean).abs() < 0.06, "{variables:?}: {found}");
        }
    }

    #[test]
    fn a_draw_that_cannot_exist_is_drawn_again() {
        let variables = [variable(
            "cloth.sliding_friction",
            VariableLaw::Distribution(Distribution::Normal(0.1, 0.2)),
        )];
        let number = |setup: &Setup| match setup
            .physics
            .as_ref()
            .and_then(|node| node.get("cloth")?.get("sliding_friction"))
        {
            Some(Node::Number(x)) => *x,
            _ => f64::NAN,
        };
        let refuse = |setup: &Setup| {
            if number(setup) > 0.0 {
                Ok(())
            } else {
                Err(carom::ErrorKind::OutOfRange.at("a", "b", "c"))
            }
        };
        for seed in 0..200 {
            assert!(Setup::default().draw(&variables, seed, refuse).expect("a draw")[0] > 0.0);
        }
        assert!(
            Setup::default()
                .draw(&variables, 0, |_| Err(carom::ErrorKind::OutOfRange.at("a", "b", "c")))
                .is_err()
        );
    }
}
