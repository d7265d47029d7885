//! What may follow a play: `_core.successors`, and the plays that pot a ball: `_core.pots`.

use carom::noise::Errors;
use carom::runner::Runner;
use carom_mind::Situation;
use carom_mind::search::{PotList, PotPlay};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::to_python;
use crate::options::{NoiseOptions, PerceptionOptions, count};
use crate::player::{PlayFields, id};
use crate::rules::{Frame, PlayArguments};

/// The frame after a play, the ruling, and the strike as it was executed: speed, azimuth, elevation, side,
/// height.
type Successor<'py> = (Frame, Bound<'py, PyAny>, [f64; 5]);

/// The frames that may follow a play with `n` drawn errors, from variant `first` on.
#[pyfunction]
#[pyo3(signature = (frame, play, noise, perception, seed, first, n, threads))]
#[expect(clippy::too_many_arguments, reason = "Python's side has names for them")]
pub(crate) fn successors<'py>(
    py: Python<'py>,
    frame: PyRef<'py, Frame>,
    play: PlayArguments,
    noise: NoiseOptions,
    perception: PerceptionOptions,
    seed: u64,
    first: u64,
    n: u64,
    threads: usize,
) -> PyResult<Vec<Successor<'py>>> {
    let raise = |error| to_exception(py, &error);
    let (play, frame) = (frame.play_of(py, play)?, frame.get().without_seed());
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let errors = Errors { noise: noise.noise(), perception: perception.perception(), seed };
    let drawn = first..first + n;
    let found = py.detach(|| carom_plan::successors(&frame, &play, &errors, drawn, &runner));
    let fields = |successor: carom_plan::Successor| {
        let ruling = to_python(py, &successor.frame.ruling_node(&successor.ruling))?;
        let s = successor.executed;
        let strike = [s.speed, s.azimuth, s.elevation, s.side, s.height];
        Ok((Frame::from(successor.frame), ruling, strike))
    };
    found.map_err(raise)?.into_iter().map(fields).collect()
}

/// A play that pots a ball; a dict in Python. `legs`: the balls on the way, each with its number of
/// cushions. `made`: (met, of).
#[derive(IntoPyObject)]
pub(crate) struct PotFields {
    play: PlayFields,
    kind: &'static str,
    legs: Vec<(String, u8)>,
    ball: String,
    pocket: &'static str,
    made: (u64, u64),
}

/// The plays that pot a ball, the most probable first.
#[pyfunction]
#[pyo3(signature = (frame, noise, perception, seed, cue_ball, each, n, threads))]
#[expect(clippy::too_many_arguments, reason = "Python's side has names for them")]
pub(crate) fn pots(
    py: Python<'_>,
    frame: PyRef<'_, Frame>,
    noise: NoiseOptions,
    perception: PerceptionOptions,
    seed: u64,
    cue_ball: Option<[f64; 2]>,
    each: usize,
    n: u64,
    threads: usize,
) -> PyResult<Vec<PotFields>> {
    let raise = |error| to_exception(py, &error);
    let frame = frame.get();
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let noise = noise.noise();
    let perception = perception.perception();
    let situation = Situation { frame: &frame, noise: [noise.clone(), noise], perception, seed };
    let list = PotList { cue_ball, each, samples: n };
    let found = py.detach(|| list.find(&situation, &runner)).map_err(raise)?;
    let fields = |pot: PotPlay| PotFields {
        play: PlayFields::new(&frame, &pot.play),
        kind: pot.kind.name(),
        legs: pot.legs.iter().map(|(ball, cushions)| (id(&frame, *ball), *cushions)).collect(),
        ball: id(&frame, pot.ball),
        pocket: pot.pocket.name(),
        made: (pot.made.met, pot.made.variants),
    };
    Ok(found.into_iter().map(fields).collect())
}
