//! Objects of options, read by attribute: the frozen dataclasses of `carom.noise` and
//! `carom.plan.options`.

use std::sync::Arc;

use carom::Noise;
use carom::noise::{Covariance, Perception, PositionError, Samples};
use carom_plan::{Disc, ErrorModel, Goal, Reach, Search};
use pyo3::prelude::*;

use crate::error::to_exception;

/// `carom.Noise`.
pub(crate) struct NoiseOptions(Noise);

#[derive(FromPyObject)]
struct NoiseFields {
    speed: f64,
    azimuth: f64,
    elevation: f64,
    side_m: f64,
    height_m: f64,
    cling_probability: f64,
    cling_friction: f64,
    speed_relative: f64,
    covariance: Option<[[f64; 5]; 5]>,
    bias: Option<[f64; 5]>,
    samples: Option<Vec<[f64; 5]>>,
}

impl NoiseOptions {
    pub(crate) fn noise(&self) -> Noise {
        self.0.clone()
    }
}

impl FromPyObject<'_, '_> for NoiseOptions {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let fields: NoiseFields = object.extract()?;
        let raise = |error: carom::Error| to_exception(object.py(), &error);
        Ok(Self(Noise {
            speed: fields.speed,
            azimuth: fields.azimuth,
            elevation: fields.elevation,
            side_m: fields.side_m,
            height_m: fields.height_m,
            cling_probability: fields.cling_probability,
            cling_friction: fields.cling_friction,
            speed_relative: fields.speed_relative,
            covariance: fields.covariance.map(Covariance::new).transpose().map_err(raise)?,
            bias: fields.bias.unwrap_or_default(),
            samples: fields.samples.map(Samples::new).transpose().map_err(raise)?,
        }))
    }
}

/// `carom.Perception`.
#[derive(FromPyObject)]
pub(crate) struct PerceptionOptions {
    sigma: [f64; 2],
    correlation: f64,
    errors: Vec<(String, [f64; 2], f64)>,
}

impl PerceptionOptions {
    pub(crate) fn perception(&self) -> Perception {
        let position = PositionError { sigma: self.sigma, correlation: self.correlation };
        let of_ball = |(id, sigma, correlation): &(String, [f64; 2], f64)| {
            (id.clone(), PositionError { sigma: *sigma, correlation: *correlation })
        };
        let balls = self.errors.iter().map(of_ball).collect();
        Perception { position, balls: (!self.errors.is_empty()).then(|| Arc::new(balls)) }
    }
}

/// `carom.plan.options.Sampling`.
#[derive(FromPyObject)]
pub(crate) struct SamplingOptions {
    noise: NoiseOptions,
    perception: PerceptionOptions,
    seed: u64,
    n: u64,
    precision: Option<f64>,
    level: f64,
}

impl SamplingOptions {
    pub(crate) fn model(&self) -> ErrorModel {
        ErrorModel {
            noise: self.noise.noise(),
            perception: self.perception.perception(),
            seed: self.seed,
            variants: self.n,
            half_width: self.precision,
            level: self.level,
        }
    }
}

/// `carom.plan.options.Goal`, with balls and pockets by index.
#[derive(FromPyObject)]
pub(crate) struct GoalOptions {
    pot: Option<(usize, Option<usize>)>,
    leave: Option<([f64; 2], f64)>,
    first: Option<usize>,
}

impl GoalOptions {
    pub(crate) fn goal(&self) -> Goal {
        let leave = self.leave.map(|(center, radius)| Disc { center, radius });
        Goal { pot: self.pot, leave, first: self.first }
    }
}

/// `carom.plan.options.Search`.
#[derive(FromPyObject)]
pub(crate) struct SearchOptions {
    speed: [f64; 2],
    offset: f64,
    elevation: Option<f64>,
    azimuth_reach: Option<[f64; 2]>,
    elevation_reach: Option<[f64; 2]>,
    butt: Option<[[f64; 2]; 2]>,
    samples: usize,
    wanted: usize,
    per_route: usize,
}

impl SearchOptions {
    pub(crate) fn search(&self, sampling: &SamplingOptions, threads: usize) -> Search {
        Search {
            speed: self.speed,
            offset: self.offset,
            elevation: self.elevation,
            reach: Reach {
                azimuth: self.azimuth_reach,
                elevation: self.elevation_reach,
                butt: self.butt,
            },
            samples: self.samples,
            model: sampling.model(),
            wanted: self.wanted,
            per_route: self.per_route,
            threads: count(threads),
            ..Search::default()
        }
    }
}

/// The numbers of a noise in the order of the fields of `carom.Noise`.
pub(crate) fn numbers_of(noise: &Noise) -> [f64; 7] {
    let Noise { speed, azimuth, elevation, side_m, height_m, .. } = *noise;
    let Noise { cling_probability, cling_friction, .. } = *noise;
    [speed, azimuth, elevation, side_m, height_m, cling_probability, cling_friction]
}

/// A number of threads from Python, where 0 is one per core.
pub(crate) fn count(threads: usize) -> Option<usize> {
    (threads > 0).then_some(threads)
}
