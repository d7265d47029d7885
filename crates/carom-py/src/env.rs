//! Environments: `_core.VectorEnv`, `tasks` and `meanings`.

use carom::Error;
use carom::format::Node;
use carom_env::{
    ACTIONS, Aim, Autoreset, BALL_FEATURES, Config, FEATURES, Opponent, Rewards, TargetBall, Task,
    Transitions,
};
use carom_rules::Options;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::options::NoiseOptions;

/// `carom.env.settings.Settings`, read by attribute; Python has checked the types.
#[derive(FromPyObject)]
struct Settings<'py> {
    noise: NoiseOptions,
    aim: String,
    speed: [f64; 2],
    max_elevation: f64,
    opponent: String,
    balls: Option<[usize; 2]>,
    target_ball: String,
    table: Bound<'py, PyAny>,
    physics: Bound<'py, PyAny>,
    points: Option<i32>,
    patience: u32,
    rewards: Option<RewardSettings>,
    max_episode_steps: Option<u32>,
    autoreset_mode: String,
    threads: Option<usize>,
}

/// `carom.env.Rewards`, read by attribute.
#[derive(FromPyObject)]
struct RewardSettings {
    win: f64,
    pot: f64,
    foul: f64,
    point: f64,
    failure: f64,
}

impl From<&RewardSettings> for Rewards {
    fn from(&RewardSettings { win, pot, foul, point, failure }: &RewardSettings) -> Self {
        Self { win, pot, foul, point, failure }
    }
}

impl Settings<'_> {
    fn config(&self, task: Task) -> PyResult<Result<Config, Error>> {
        let optional = |value: &Bound<'_, PyAny>| {
            if value.is_none() { Ok(None) } else { from_python(value).map(Some) }
        };
        let (table, physics) = (optional(&self.table)?, optional(&self.physics)?);
        Ok(self.named(task, table, physics))
    }

    fn named(
        &self,
        task: Task,
        table: Option<Node>,
        physics: Option<Node>,
    ) -> Result<Config, Error> {
        let usual = Config::of(task);
        Ok(Config {
            noise: self.noise.noise(),
            aim: Aim::read(&self.aim)?,
            speed: self.speed,
            elevation: self.max_elevation,
            opponent: Opponent::read(&self.opponent)?,
            balls: self.balls,
            target_ball: TargetBall::read(&self.target_ball)?,
            table,
            physics,
            options: Options {
                points: self.points.unwrap_or(usual.options.points),
                patience: self.patience,
                ..usual.options
            },
            rewards: self.rewards.as_ref().map_or(usual.rewards, Rewards::from),
            max_steps: self.max_episode_steps,
            autoreset: Autoreset::read(&self.autoreset_mode)?,
            threads: self.threads,
        })
    }
}

/// Environments that step together.
#[pyclass(module = "carom._core")]
pub(crate) struct VectorEnv(carom_env::VectorEnv);

#[pymethods]
impl VectorEnv {
    #[new]
    fn new(py: Python<'_>, task: &str, n: usize, settings: Settings<'_>) -> PyResult<Self> {
        let task = Task::read(task).map_err(|e| to_exception(py, &e))?;
        let config = settings.config(task)?;
        config
            .and_then(|config| carom_env::VectorEnv::new(task, n, 0, config))
            .map(Self)
            .map_err(|e| to_exception(py, &e))
    }

    /// Resets the environments in `mask` (None: all) and returns observations, shape (n, size).
    /// `seeds`: one for each environment; None continues with the earlier ones.
    fn reset<'py>(
        &mut self,
        py: Python<'py>,
        seeds: Option<Vec<u64>>,
        mask: Option<PyReadonlyArray1<'py, bool>>,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let mask = mask.map(|mask| mask.as_array().to_vec());
        let seen = py.detach(|| self.0.reset(seeds.as_deref(), mask.as_deref()));
        self.rows(py, seen.map_err(|e| to_exception(py, &e))?)
    }

    /// Plays one shot in every environment; returns a dictionary of arrays with n entries each.
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        actions: PyReadonlyArray2<'py, f32>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let actions = actions.as_array();
        let actions = actions.as_standard_layout();
        let actions = actions.as_slice().unwrap_or_default();
        let played = py.detach(|| self.0.step(actions)).map_err(|e| to_exception(py, &e))?;
        let Transitions {
            observations,
            rewards,
            terminated,
            truncated,
            final_observations,
            players,
            legal,
            potted,
        } = played;
        let out = PyDict::new(py);
        out.set_item("observations", self.rows(py, observations)?)?;
        out.set_item("rewards", PyArray1::from_vec(py, rewards))?;
        out.set_item("terminated", PyArray1::from_vec(py, terminated))?;
        out.set_item("truncated", PyArray1::from_vec(py, truncated))?;
        out.set_item("player", PyArray1::from_vec(py, players))?;
        out.set_item("legal", PyArray1::from_vec(py, legal))?;
        out.set_item("potted", PyArray1::from_vec(py, potted))?;
        if !final_observations.is_empty() {
            out.set_item("final_obs", self.rows(py, final_observations)?)?;
        }
        Ok(out)
    }

    fn observe<'py>(
        &self,
        py: Python<'py>,
        index: usize,
        viewer: usize,
    ) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let seen = self.0.observe(index, viewer).map_err(|e| to_exception(py, &e))?;
        Ok(PyArray1::from_vec(py, seen))
    }

    fn player(&self, py: Python<'_>, index: usize) -> PyResult<Option<usize>> {
        self.0.player(index).map_err(|e| to_exception(py, &e))
    }

    fn presets<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.0.presets())
    }

    fn picture<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.0.picture(index).map_err(|e| to_exception(py, &e))?)
    }

    /// For `copy.deepcopy`: an independent copy in the same state.
    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        Self(self.0.clone())
    }

    /// For `pickle`: an error with a remedy.
    fn __reduce__(&self) -> PyResult<()> {
        Err(PyTypeError::new_err(
            "an environment cannot be pickled; pickle a function that makes it, such as \
             functools.partial(gymnasium.make, name), or copy it with copy.deepcopy",
        ))
    }

    #[getter]
    fn action_size(&self) -> usize {
        self.0.action_size()
    }

    #[getter]
    fn observation_bounds<'py>(
        &self,
        py: Python<'py>,
    ) -> (Bound<'py, PyArray1<f32>>, Bound<'py, PyArray1<f32>>) {
        let [low, high] = self.0.observation_bounds();
        (PyArray1::from_vec(py, low), PyArray1::from_vec(py, high))
    }
}

impl VectorEnv {
    fn rows<'py>(&self, py: Python<'py>, flat: Vec<f32>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        PyArray1::from_vec(py, flat).reshape([self.0.len(), self.0.observation_size()])
    }
}

/// The names of all tasks.
#[pyfunction]
pub(crate) fn tasks() -> Vec<&'static str> {
    Task::ALL.into_iter().map(Task::name).collect()
}

/// The names of the numbers of an action, of a ball's features, and of the other features.
#[pyfunction]
pub(crate) fn meanings() -> (Vec<&'static str>, Vec<&'static str>, Vec<&'static str>) {
    (ACTIONS.to_vec(), BALL_FEATURES.to_vec(), FEATURES.to_vec())
}
