//! Noise and perception as plain values, for files, records and dictionaries.
//!
//! A key at its default is not written, except for those that every noise has.

use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{Covariance, Noise, Perception, PositionError, Samples};
use crate::error::Error;
use crate::format::{Node, Reader};

/// The keys of a noise that hold one number; the first seven are always written.
const NUMBERS: [&str; 8] = [
    "speed",
    "azimuth",
    "elevation",
    "side_m",
    "height_m",
    "cling_probability",
    "cling_friction",
    "speed_relative",
];
const FIVE: &str = "five numbers: speed (m/s), azimuth, elevation (rad), side, height (m)";
const MATRIX: &str = "five rows of five numbers";

impl Noise {
    /// The plain values of this noise; they read back to the same bits.
    pub fn to_node(&self) -> Node {
        let mut node = Node::Object(Vec::new());
        for (key, value) in NUMBERS.into_iter().zip(self.numbers()) {
            if key != "speed_relative" || value != 0.0 {
                node.set(key, value);
            }
        }
        if let Some(covariance) = &self.covariance {
            node.set("covariance", rows(covariance.matrix()));
        }
        if self.bias != [0.0; 5] {
            node.set("bias", Node::list(self.bias));
        }
        if let Some(samples) = &self.samples {
            node.set("samples", rows(samples.rows()));
        }
        node
    }

    /// The noise with these plain values. Missing keys are those of [`Noise::NONE`].
    ///
    /// # Errors
    /// [`Error::Input`] with the place, for an unknown key, a wrong type, and as [`Noise::check`].
    pub fn read(at: &Reader<'_>) -> Result<Self, Error> {
        let known: Vec<&str> =
            NUMBERS.into_iter().chain(["covariance", "bias", "samples"]).collect();
        at.keys(&known)?;
        let mut numbers = Self::NONE.numbers();
        for (key, number) in NUMBERS.into_iter().zip(&mut numbers) {
            if let Some(value) = at.get(key) {
                *number = value.exact_number()?;
            }
        }
        // The errors of a noise begin with `noise`, those of a file with the place of the noise in it.
        let moved = |error: Error| error.moved("noise", at.place());
        let list = |key| at.get(key).filter(|value| *value.node() != Node::Null);
        let noise = Self {
            covariance: list("covariance")
                .map(|value| {
                    let rows = five_columns(&value, MATRIX)?;
                    let matrix = rows.try_into().map_err(|_| value.wrong_type(MATRIX))?;
                    Covariance::new(matrix).map_err(moved)
                })
                .transpose()?,
            bias: list("bias").map_or(Ok([0.0; 5]), |value| five(&value))?,
            samples: list("samples")
                .map(|value| {
                    let rows = five_columns(&value, "a list of rows of five numbers")?;
                    Samples::new(rows).map_err(moved)
                })
                .transpose()?,
            ..Self::NONE
        }
        .with_numbers(numbers);
        noise.check().map_err(moved)?;
        Ok(noise)
    }

    const fn numbers(&self) -> [f64; 8] {
        let [speed, azimuth, elevation, side, height] = self.sigmas();
        let Self { cling_probability, cling_friction, speed_relative, .. } = *self;
        [speed, azimuth, elevation, side, height, cling_probability, cling_friction, speed_relative]
    }

    fn with_numbers(self, numbers: [f64; 8]) -> Self {
        let [speed, azimuth, elevation, side_m, height_m, ..] = numbers;
        let [.., cling_probability, cling_friction, speed_relative] = numbers;
        Self {
            speed,
            azimuth,
            elevation,
            side_m,
            height_m,
            cling_probability,
            cling_friction,
            speed_relative,
            ..self
        }
    }
}

impl Perception {
    /// The plain values of this perception; they read back to the same bits.
    pub fn to_node(&self) -> Node {
        let mut node = position_node(&self.position);
        if let Some(balls) = &self.balls {
            let of = |(id, error): (&String, &PositionError)| (id.clone(), position_node(error));
            node.set("balls", Node::Object(balls.iter().map(of).collect()));
        }
        node
    }

    /// The perception with these plain values.
    ///
    /// # Errors
    /// [`Error::Input`] with the place, for an unknown key, a wrong type, and as
    /// [`Perception::check`].
    pub fn read(at: &Reader<'_>) -> Result<Self, Error> {
        at.keys(&["position", "correlation", "balls"])?;
        let position = read_position(at)?;
        let balls = match at.get("balls") {
            None => None,
            Some(balls) => {
                let Node::Object(fields) = balls.node() else {
                    return Err(balls.wrong_type("an object with an error for each id"));
                };
                let mut all = BTreeMap::new();
                for id in fields.iter().map(|(id, _)| id) {
                    let ball = balls.require(id, "an error")?;
                    ball.keys(&["position", "correlation"])?;
                    all.insert(id.clone(), read_position(&ball)?);
                }
                Some(Arc::new(all))
            }
        };
        let perception = Self { position, balls };
        perception.check().map_err(|error| error.moved("perception", at.place()))?;
        Ok(perception)
    }
}

fn position_node(error: &PositionError) -> Node {
    let [x, y] = error.sigma;
    let sigma = if x == y { x.into() } else { Node::list([x, y]) };
    let mut node = Node::object([("position", sigma)]);
    if error.correlation != 0.0 {
        node.set("correlation", error.correlation);
    }
    node
}

fn read_position(at: &Reader<'_>) -> Result<PositionError, Error> {
    const WANTED: &str = "a number or two of them, m";
    let position = at.require("position", WANTED)?;
    let sigma = match position.node() {
        Node::List(_) => match position.items(WANTED)?.as_slice() {
            [x, y] => [x.exact_number()?, y.exact_number()?],
            _ => return Err(position.wrong_type(WANTED)),
        },
        _ => [position.exact_number()?; 2],
    };
    let correlation = at.get("correlation").map_or(Ok(0.0), |value| value.exact_number())?;
    Ok(PositionError { sigma, correlation })
}

fn rows(rows: &[[f64; 5]]) -> Node {
    Node::List(rows.iter().map(|row| Node::list(*row)).collect())
}

fn five(at: &Reader<'_>) -> Result<[f64; 5], Error> {
    let numbers =
        at.items(FIVE)?.iter().map(Reader::exact_number).collect::<Result<Vec<_>, _>>()?;
    numbers.try_into().map_err(|_| at.wrong_type(FIVE))
}

fn five_columns(at: &Reader<'_>, wanted: &str) -> Result<Vec<[f64; 5]>, Error> {
    at.items(wanted)?.iter().map(five).collect()
}
