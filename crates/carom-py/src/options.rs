//! Objects of options, read by attribute: the frozen dataclasses of `carom.noise` and
//! `carom.plan.options`.

use carom::Noise;
use carom::noise::Perception;
use carom_plan::{Disc, ErrorModel, Goal, Search};
use pyo3::prelude::*;

/// `carom.Noise`.
#[derive(FromPyObject)]
pub(crate) struct NoiseOptions {
    speed: f64,
    azimuth: f64,
    elevation: f64,
    side_m: f64,
    height_m: f64,
    cling_probability: f64,
    cling_friction: f64,
}

impl NoiseOptions {
    pub(crate) fn noise(&self) -> Noise {
        Noise {
            speed: self.speed,
            azimuth: self.azimuth,
            elevation: self.elevation,
            side_m: self.side_m,
            height_m: self.height_m,
            cling_probability: self.cling_probability,
            cling_friction: self.cling_friction,
        }
    }
}

/// `carom.Perception`.
#[derive(FromPyObject)]
pub(crate) struct PerceptionOptions {
    position: f64,
}

impl PerceptionOptions {
    pub(crate) const fn perception(&self) -> Perception {
        Perception { position: self.position }
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
            samples: self.samples,
            model: sampling.model(),
            wanted: self.wanted,
            per_route: self.per_route,
            threads: count(threads),
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
