//! Environments: `_core.VectorEnv`, `tasks` and `meanings`.

use std::borrow::Cow;
use std::sync::{Mutex, MutexGuard, TryLockError};

use carom::Error;
use carom_env::{
    ACTIONS, AgentSeat, Aim, Answers, Asked, Autoreset, BALL_FEATURES, Config, EpisodeStart,
    FEATURES, Opponent, Outside, Rewards, Setup, TargetBall, Task, Transitions, Variable,
};
use carom_rules::Fouls;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList, PyString};

use crate::env_opponent::{EnvPrograms, Stopped, replies};
use crate::error::to_exception;
use crate::exceptions::CaromError;
use crate::node::{from_python, to_python};
use crate::options::{NoiseOptions, count};
use crate::player::PlayFields;
use crate::rules::Frame;
use crate::shot::Shot;

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

/// A table and its physics; None for the default.
type SetupArgument<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// The settings that `carom.env.settings.checked` returns. It has checked their names and types.
fn read_config(task: Task, settings: &Bound<'_, PyDict>) -> PyResult<Config> {
    let raise = |error: Error| to_exception(settings.py(), &error);
    let mut config = Config::of(task);
    for (name, value) in settings {
        match name.extract()? {
            "noise" => config.noise = value.extract::<NoiseOptions>()?.noise(),
            "aim" => config.aim = Aim::read(value.extract()?).map_err(raise)?,
            "speed" => config.speed = value.extract()?,
            "max_elevation" => config.max_elevation = value.extract()?,
            "balls" => config.balls = Some(value.extract()?),
            "target_ball" => {
                config.target_ball = TargetBall::read(value.extract()?).map_err(raise)?;
            }
            "setups" => {
                let setups: Vec<SetupArgument<'_>> = value.extract()?;
                config.setups = setups.iter().map(read_setup).collect::<PyResult<_>>()?;
            }
            "randomize" => {
                config.randomize = Variable::read_all(&from_python(&value)?).map_err(raise)?;
            }
            "points" => config.options.points = value.extract()?,
            "patience" => config.options.patience = value.extract()?,
            "rewards" => config.rewards = Rewards::from(&value.extract::<RewardSettings>()?),
            "max_episode_steps" => config.max_episode_steps = Some(value.extract()?),
            "traces" => config.traces = value.extract()?,
            "threads" => config.threads = Some(value.extract()?),
            "opponent" => config.opponent = Opponent::read(value.extract()?).map_err(raise)?,
            "outside" => {
                let is_policy = value.extract::<&str>()? == "policy";
                let kind = if is_policy { Outside::Policy } else { Outside::Player };
                config.opponent = Opponent::Outside(kind);
            }
            "program" => config.opponent = Opponent::Outside(Outside::Player),
            // Of the program.
            "clock" => {}
            "seat" => config.seat = AgentSeat::read(value.extract()?).map_err(raise)?,
            "autoreset_mode" => {
                config.autoreset_mode = Autoreset::read(value.extract()?).map_err(raise)?;
            }
            unknown => unreachable!("a setting that Python does not have: {unknown}"),
        }
    }
    Ok(config)
}

fn read_setup((table, physics): &SetupArgument<'_>) -> PyResult<Setup> {
    let read = |node: &Option<Bound<'_, PyAny>>| node.as_ref().map(from_python).transpose();
    Ok(Setup { table: read(table)?, physics: read(physics)? })
}

/// The start of an episode, from Python.
#[derive(FromPyObject)]
enum StartArgument<'py> {
    Shot(PyRef<'py, Shot>),
    Frame(PyRef<'py, Frame>),
}

impl StartArgument<'_> {
    fn start(&self) -> EpisodeStart {
        match self {
            Self::Shot(shot) => EpisodeStart::Shot(carom::Shot::clone(&shot.0)),
            Self::Frame(frame) => EpisodeStart::Frame(frame.get().into()),
        }
    }
}

/// Environments that step together.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct VectorEnv {
    envs: Mutex<carom_env::VectorEnv>,
    /// The opponents, if they are an external program. They are locked after the environments.
    programs: Option<EnvPrograms>,
}

#[pymethods]
impl VectorEnv {
    #[new]
    fn new(py: Python<'_>, task: &str, n: usize, settings: &Bound<'_, PyDict>) -> PyResult<Self> {
        let task = Task::read(task).map_err(|e| to_exception(py, &e))?;
        let envs = carom_env::VectorEnv::new(task, n, 0, read_config(task, settings)?)
            .map_err(|e| to_exception(py, &e))?;
        let clock = settings.get_item("clock")?.map(|clock| clock.extract()).transpose()?;
        let programs = match settings.get_item("program")? {
            Some(program) => Some(
                EnvPrograms::new(program.extract()?, clock, &envs)
                    .map_err(|e| to_exception(py, &e))?,
            ),
            None => None,
        };
        Ok(Self { envs: Mutex::new(envs), programs })
    }

    /// Ends the programs that are opponents.
    fn close(&self, py: Python<'_>) {
        if let Some(programs) = &self.programs {
            programs.end_all(py);
        }
    }

    /// Resets the environments in `mask` (None: all) and returns observations, shape (n, size).
    /// `seeds`: one for each environment; None continues with the earlier ones. `starts`: shots and
    /// frames; none, one, or one for each environment. `opponent`: as [`replies`] asks it.
    fn reset<'py>(
        &self,
        py: Python<'py>,
        seeds: Option<Vec<u64>>,
        mask: Option<PyReadonlyArray1<'py, bool>>,
        starts: Vec<Option<StartArgument<'py>>>,
        opponent: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let mask = mask.map(|mask| mask.as_array().to_vec());
        let starts: Vec<_> =
            starts.iter().map(|start| start.as_ref().map(StartArgument::start)).collect();
        let (seen, size) = self.against(py, opponent.as_ref(), |envs, ask| {
            let seen = envs.reset_against(seeds.as_deref(), mask.as_deref(), &starts, ask)?;
            Ok((seen, envs.observation_size()))
        })?;
        rows(py, seen, size)
    }

    /// Plays one shot in every environment; returns a dictionary of arrays with n entries each.
    fn step<'py>(
        &self,
        py: Python<'py>,
        actions: PyReadonlyArray2<'py, f32>,
        opponent: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let actions = actions.as_array();
        let actions = actions.as_standard_layout();
        let (played, size) =
            self.played(py, actions.as_slice().unwrap_or_default(), opponent.as_ref())?;
        let Transitions {
            observations,
            rewards,
            terminated,
            truncated,
            final_observations,
            players,
            legal,
            potted,
            fouls,
            strikes,
            winners,
            why,
        } = played;
        let out = PyDict::new(py);
        out.set_item("observations", rows(py, observations, size)?)?;
        out.set_item("rewards", PyArray1::from_vec(py, rewards))?;
        out.set_item("terminated", PyArray1::from_vec(py, terminated))?;
        out.set_item("truncated", PyArray1::from_vec(py, truncated))?;
        out.set_item("player", PyArray1::from_vec(py, players))?;
        out.set_item("legal", PyArray1::from_vec(py, legal))?;
        out.set_item("potted", PyArray1::from_vec(py, potted))?;
        let fouls = fouls.into_iter().map(Fouls::bits).collect();
        out.set_item("fouls", PyArray1::from_vec(py, fouls))?;
        let strikes =
            PyArray1::from_vec(py, strikes.into_flattened()).reshape([winners.len(), 5])?;
        out.set_item("strike", strikes)?;
        if why.iter().any(Option::is_some) {
            out.set_item("winner", PyArray1::from_vec(py, winners))?;
            out.set_item("why", reasons(py, &why)?)?;
        }
        if !final_observations.is_empty() {
            out.set_item("final_obs", rows(py, final_observations, size)?)?;
        }
        Ok(out)
    }

    /// As `step`, in a single environment: its observation, reward, `terminated`, `truncated`, `player`,
    /// `legal`, `potted`, `fouls`, `strike`, `winner` and `why`.
    fn step_one<'py>(
        &self,
        py: Python<'py>,
        action: PyReadonlyArray1<'py, f32>,
        opponent: Option<Py<PyAny>>,
    ) -> PyResult<Step<'py>> {
        let action = action.as_array();
        let action = action.as_standard_layout();
        let (mut played, _) =
            self.played(py, action.as_slice().unwrap_or_default(), opponent.as_ref())?;
        let [speed, azimuth, elevation, side, height] = played.strikes[0];
        let was_played = !speed.is_nan();
        Ok((
            PyArray1::from_vec(py, played.observations),
            played.rewards[0],
            played.terminated[0],
            played.truncated[0],
            played.players[0],
            played.legal[0],
            played.potted[0],
            played.fouls[0].bits(),
            was_played.then_some((speed, azimuth, elevation, side, height)),
            played.winners[0],
            played.why.swap_remove(0),
        ))
    }

    /// The state of all environments, and with it the bytes of `attachment`.
    fn state<'py>(&self, py: Python<'py>, attachment: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
        let state = self.lock()?.state(attachment).map_err(|e| to_exception(py, &e))?;
        Ok(PyBytes::new(py, &state))
    }

    /// Continues from a state, and returns its attachment.
    fn set_state<'py>(&self, py: Python<'py>, state: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
        let mut envs = self.lock()?;
        let attachment = envs.set_state(state).map_err(|e| to_exception(py, &e))?;
        if let Some(programs) = &self.programs {
            programs.end_over(py, &envs);
        }
        Ok(PyBytes::new(py, attachment))
    }

    fn copy(&self, py: Python<'_>) -> PyResult<Self> {
        let envs = self.lock()?.clone();
        self.with_programs(py, envs)
    }

    /// `n` copies of one environment, with other random numbers to come if there are `seeds`.
    fn copies(
        &self,
        py: Python<'_>,
        index: usize,
        n: usize,
        seeds: Option<Vec<u64>>,
        threads: usize,
    ) -> PyResult<Self> {
        let copies = self.lock()?.copies(index, n, seeds.as_deref(), count(threads));
        self.with_programs(py, copies.map_err(|e| to_exception(py, &e))?)
    }

    /// The play that an action means; None at the end of an episode.
    fn play<'py>(
        &self,
        py: Python<'py>,
        index: usize,
        action: PyReadonlyArray1<'py, f32>,
    ) -> PyResult<Option<PlayFields>> {
        let envs = self.lock()?;
        let action = action.as_array().to_vec();
        let play = envs.play(index, &action).map_err(|e| to_exception(py, &e))?;
        let frame = envs.frame(index).map_err(|e| to_exception(py, &e))?;
        Ok(play.map(|play| match frame {
            Some(frame) => PlayFields::new(frame, &play),
            None => PlayFields::uncalled(&play),
        }))
    }

    /// A copy of the frame, without its seed; None in a task without a referee.
    fn frame(&self, py: Python<'_>, index: usize) -> PyResult<Option<Frame>> {
        let envs = self.lock()?;
        let frame = envs.frame(index).map_err(|e| to_exception(py, &e))?;
        Ok(frame.map(|frame| Frame::from(frame.without_seed())))
    }

    fn shot(&self, py: Python<'_>, index: usize) -> PyResult<Shot> {
        self.lock()?.shot(index).map(Shot::from).map_err(|e| to_exception(py, &e))
    }

    fn observe_start<'py>(
        &self,
        py: Python<'py>,
        index: usize,
        start: StartArgument<'py>,
    ) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let seen = self.lock()?.observe_start(index, &start.start());
        Ok(PyArray1::from_vec(py, seen.map_err(|e| to_exception(py, &e))?))
    }

    /// The shots of the last step, if the settings keep them.
    fn shots(&self, py: Python<'_>, index: usize) -> PyResult<Vec<Shot>> {
        let envs = self.lock()?;
        let shots = envs.shots(index).map_err(|e| to_exception(py, &e))?;
        Ok(shots.iter().cloned().map(Shot::from).collect())
    }

    fn observe<'py>(
        &self,
        py: Python<'py>,
        index: usize,
        viewer: usize,
    ) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let seen = self.lock()?.observe(index, viewer).map_err(|e| to_exception(py, &e))?;
        Ok(PyArray1::from_vec(py, seen))
    }

    /// The observations of all environments, shape (n, size).
    fn observations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let envs = self.lock()?;
        rows(py, envs.observations(), envs.observation_size())
    }

    fn player(&self, py: Python<'_>, index: usize) -> PyResult<Option<usize>> {
        self.lock()?.player(index).map_err(|e| to_exception(py, &e))
    }

    fn players<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i8>>> {
        Ok(PyArray1::from_vec(py, self.lock()?.players()))
    }

    fn seats<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i8>>> {
        Ok(PyArray1::from_vec(py, self.lock()?.seats()))
    }

    /// The variables of the episodes, shape (n, variables).
    fn drawn<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let envs = self.lock()?;
        let drawn: Vec<f64> = envs.drawn().flatten().copied().collect();
        let variables = drawn.len() / envs.len();
        PyArray1::from_vec(py, drawn).reshape([envs.len(), variables])
    }

    fn presets<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.lock()?.presets())
    }

    fn picture<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let picture = self.lock()?.picture(index).map_err(|e| to_exception(py, &e))?;
        to_python(py, &picture)
    }

    #[getter]
    fn autoreset_mode(&self) -> PyResult<&'static str> {
        Ok(self.lock()?.config().autoreset_mode.name())
    }

    #[getter]
    fn action_size(&self) -> PyResult<usize> {
        Ok(self.lock()?.action_size())
    }

    #[getter]
    fn observation_bounds<'py>(&self, py: Python<'py>) -> PyResult<Bounds<'py>> {
        let [low, high] = self.lock()?.observation_bounds();
        Ok((PyArray1::from_vec(py, low), PyArray1::from_vec(py, high)))
    }
}

/// Lower and upper bounds.
type Bounds<'py> = (Bound<'py, PyArray1<f32>>, Bound<'py, PyArray1<f32>>);

/// The result of `step_one`.
type Step<'py> = (
    Bound<'py, PyArray1<f32>>,
    f64,
    bool,
    bool,
    i8,
    bool,
    u8,
    u16,
    Option<(f64, f64, f64, f64, f64)>,
    i8,
    Option<Cow<'static, str>>,
);

impl VectorEnv {
    /// The environments, if no other thread uses them.
    fn lock(&self) -> PyResult<MutexGuard<'_, carom_env::VectorEnv>> {
        match self.envs.try_lock() {
            Ok(envs) => Ok(envs),
            Err(TryLockError::Poisoned(envs)) => Ok(envs.into_inner()),
            Err(TryLockError::WouldBlock) => Err(CaromError::new_err(
                "environment: another thread or the opponent uses it now; give each thread an \
                 environment of its own, for example a copy, or let them take turns with a lock",
            )),
        }
    }

    /// The transitions of `actions`, and the size of an observation.
    fn played(
        &self,
        py: Python<'_>,
        actions: &[f32],
        opponent: Option<&Py<PyAny>>,
    ) -> PyResult<(Transitions, usize)> {
        self.against(py, opponent, |envs, ask| {
            Ok((envs.step_against(actions, ask)?, envs.observation_size()))
        })
    }

    /// What `work` returns with the function that asks the opponent.
    fn against<T: Send>(
        &self,
        py: Python<'_>,
        opponent: Option<&Py<PyAny>>,
        work: impl FnOnce(&mut carom_env::VectorEnv, &mut Answers<'_, Stopped>) -> Result<T, Stopped>
        + Send,
    ) -> PyResult<T> {
        let mut lock = self.lock()?;
        let envs = &mut *lock;
        if let Some(programs) = &self.programs {
            return programs.run(py, envs, work);
        }
        let is_policy = envs.config().opponent == Opponent::Outside(Outside::Policy);
        let mut ask = |asked: &[Asked<'_>]| replies(opponent, is_policy, asked);
        py.detach(|| work(envs, &mut ask)).map_err(|stopped| stopped.exception(py))
    }

    /// Other environments with the same opponent; a program has processes of its own in them.
    fn with_programs(&self, py: Python<'_>, envs: carom_env::VectorEnv) -> PyResult<Self> {
        let programs = self.programs.as_ref().map(|programs| programs.again(&envs)).transpose();
        let programs = programs.map_err(|e| to_exception(py, &e))?;
        Ok(Self { envs: Mutex::new(envs), programs })
    }
}

fn rows<'py>(py: Python<'py>, flat: Vec<f32>, size: usize) -> PyResult<Bound<'py, PyArray2<f32>>> {
    let count = flat.len() / size;
    PyArray1::from_vec(py, flat).reshape([count, size])
}

/// The reasons as a list of texts and None. Equal neighbours share their text.
fn reasons<'py>(
    py: Python<'py>,
    why: &[Option<Cow<'static, str>>],
) -> PyResult<Bound<'py, PyList>> {
    let mut last: Option<(&str, Bound<'py, PyString>)> = None;
    let texts: Vec<Option<Bound<'py, PyString>>> = why
        .iter()
        .map(|why| {
            let why = why.as_deref()?;
            let known = last.as_ref().filter(|(known, _)| *known == why);
            let text = known.map_or_else(|| PyString::new(py, why), |(_, text)| text.clone());
            Some(last.insert((why, text)).1.clone())
        })
        .collect();
    PyList::new(py, texts)
}

/// The words of the fouls, in the order of their bits.
#[pyfunction]
pub(crate) fn foul_words() -> Vec<&'static str> {
    Fouls::all().map(carom_rules::Foul::words).into()
}

/// The names of all tasks.
#[pyfunction]
pub(crate) fn tasks() -> Vec<&'static str> {
    Task::all().into_iter().map(Task::name).collect()
}

/// The names of the numbers of an action, of a ball's features, and of the other features.
#[pyfunction]
pub(crate) fn meanings() -> (Vec<&'static str>, Vec<&'static str>, Vec<&'static str>) {
    (ACTIONS.to_vec(), BALL_FEATURES.to_vec(), FEATURES.to_vec())
}
