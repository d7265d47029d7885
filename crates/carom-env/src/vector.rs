//! Many environments at once.

use carom::Error;
use carom::format::Node;
use carom::runner::Runner;
use carom_rules::Seat;

use crate::action::{ACTIONS, ACTIONS_WITHOUT_HAND};
use crate::config::Config;
use crate::environment::{self, Environment, StepResult};
use crate::modes::{Autoreset, Opponent};
use crate::observe::{self, SCORE_BOUND};
use crate::task::Task;
use crate::worker::Worker;

/// Largest number of environments in a vector. Each takes several kilobytes; without a limit a mistyped number
/// would exhaust the memory and abort the program.
pub const MAX_ENVIRONMENTS: usize = 1 << 20;

/// Environments in one item of work: a few hundred microseconds, so that handing items out costs
/// nothing and all threads finish at nearly the same time.
const CHUNK: usize = 16;

/// The same for a built-in player as the opponent, whose decisions take milliseconds each.
const PLAYER_CHUNK: usize = 1;

/// Number of episodes that are tried until one has a layout that fits.
const RESTARTS: u32 = 8;

/// The result of a step: one row or number for each environment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transitions {
    /// The new observations: rows of [`VectorEnv::observation_size`].
    pub observations: Vec<f32>,
    /// Rewards.
    pub rewards: Vec<f64>,
    /// Whether the episode ended by its rules.
    pub terminated: Vec<bool>,
    /// Whether the episode ended otherwise: by a stalemate, the limit on steps, or a shot that
    /// could not be played.
    pub truncated: Vec<bool>,
    /// The final observations of episodes that ended, if `observations` already belongs to the next
    /// episode: rows as there, 0 for the others. Empty unless environments reset in the same step
    /// and at least one did.
    pub final_observations: Vec<f32>,
    /// The seat that shoots next; −1 at the end of an episode.
    pub players: Vec<i8>,
    /// Whether the agent's shot was legal.
    pub legal: Vec<bool>,
    /// Number of balls that the agent's legal shot potted and that it might pot. In the potting task
    /// at most 1.
    pub potted: Vec<u8>,
}

/// A vector of independent environments of one task. A clone has the same state and is independent
/// of the original, so a program can try an action on a clone.
#[derive(Clone)]
pub struct VectorEnv {
    task: Task,
    config: Config,
    balls: usize,
    environments: Vec<Environment>,
    runner: Runner,
}

impl VectorEnv {
    /// `n` environments that have not been reset. Environment i has the seed `seed` + i.
    ///
    /// # Errors
    /// [`Error::Input`] for settings out of range, for more than [`MAX_ENVIRONMENTS`] environments,
    /// for a table or physics that a shot file could not have, and for a table on which the task
    /// cannot be played.
    pub fn new(task: Task, n: usize, seed: u64, config: Config) -> Result<Self, Error> {
        if n > MAX_ENVIRONMENTS {
            return Err(Error::input(
                "n",
                format!("{n} environments are too many"),
                format!("ask for at most {MAX_ENVIRONMENTS}"),
            ));
        }
        config.check(task)?;
        let runner = Runner::new(config.threads)?;
        let episode = environment::episode(task, &config)?;
        let balls = episode.balls().len();
        let environments = (0..n as u64)
            .map(|i| Environment::new(episode.boxed(), seed.wrapping_add(i)))
            .collect();
        let mut vector = Self { task, config, balls, environments, runner };
        // Reports a layout that does not fit now, instead of in the middle of a run.
        if let Some(first) = vector.environments.first_mut() {
            first.seed(seed)?;
        }
        Ok(vector)
    }

    /// Number of environments.
    pub fn len(&self) -> usize {
        self.environments.len()
    }

    /// Whether there are no environments.
    pub fn is_empty(&self) -> bool {
        self.environments.is_empty()
    }

    /// Length of an observation.
    pub const fn observation_size(&self) -> usize {
        observe::size(self.balls)
    }

    /// Length of an action. Each number is in [−1, 1].
    pub const fn action_size(&self) -> usize {
        if self.task.has_hand() { ACTIONS.len() } else { ACTIONS_WITHOUT_HAND }
    }

    /// Lower and upper bound of each number of an observation.
    pub fn observation_bounds(&self) -> [Vec<f32>; 2] {
        let least_score = if self.task.has_negative_scores() { -SCORE_BOUND } else { 0.0 };
        [observe::low(self.balls, least_score), observe::high(self.balls)]
    }

    /// Starts a new episode in every environment, or in those marked by `mask`. Returns the
    /// observations of all environments. With `seeds` (one for each environment) it is the first
    /// episode of that seed, else the next episode of the environment's own seed.
    ///
    /// # Errors
    /// [`Error::Input`] if `seeds` or `mask` has a length other than the number of environments,
    /// and if a random layout does not fit on the table.
    pub fn reset(
        &mut self,
        seeds: Option<&[u64]>,
        mask: Option<&[bool]>,
    ) -> Result<Vec<f32>, Error> {
        let n = self.len();
        check_length("seeds", seeds.map_or(n, <[u64]>::len), n)?;
        check_length("mask", mask.map_or(n, <[bool]>::len), n)?;
        let size = self.observation_size();
        let mut observations = vec![0.0; n * size];
        let Self { environments, config, runner, .. } = self;
        let chunks =
            environments.chunks_mut(CHUNK).zip(observations.chunks_mut(CHUNK * size)).enumerate();
        let reset = runner.map(
            chunks,
            || (),
            |(), (chunk, (environments, rows))| -> Result<(), Error> {
                let first = chunk * CHUNK;
                let rows = rows.chunks_mut(size);
                for (i, (environment, row)) in (first..).zip(environments.iter_mut().zip(rows)) {
                    if mask.is_none_or(|mask| mask[i]) {
                        match seeds {
                            Some(seeds) => environment.seed(seeds[i])?,
                            None => environment.next_episode()?,
                        }
                    }
                    environment.observe(environment.viewer(config), row);
                }
                Ok(())
            },
        );
        reset.into_iter().collect::<Result<(), Error>>()?;
        Ok(observations)
    }

    /// Plays a shot in every environment. `actions` are rows of [`Self::action_size`]. Numbers
    /// outside [−1, 1] are clamped, and NaN becomes 0.
    ///
    /// # Errors
    /// [`Error::Input`] if `actions` has another length.
    pub fn step(&mut self, actions: &[f32]) -> Result<Transitions, Error> {
        let (n, size, width) = (self.len(), self.observation_size(), self.action_size());
        check_length("actions", actions.len(), n * width)?;
        let mut out = Transitions {
            observations: vec![0.0; n * size],
            final_observations: vec![0.0; n * size],
            ..Transitions::default()
        };
        let mut steps = vec![(StepResult::default(), -1); n];
        let Self { environments, config, runner, .. } = self;
        let chunk = match config.opponent {
            Opponent::Player(_) => PLAYER_CHUNK,
            Opponent::None | Opponent::Random | Opponent::Potter => CHUNK,
        };
        let chunks = environments
            .chunks_mut(chunk)
            .zip(steps.chunks_mut(chunk))
            .zip(actions.chunks(chunk * width))
            .zip(out.observations.chunks_mut(chunk * size))
            .zip(out.final_observations.chunks_mut(chunk * size));
        runner.map(
            chunks,
            || Worker::new(config),
            |worker, ((((environments, steps), actions), seen), last)| {
                let rows = environments.iter_mut().zip(steps).zip(actions.chunks(width));
                let seen = seen.chunks_mut(size).zip(last.chunks_mut(size));
                for (((environment, step), action), (seen, last)) in rows.zip(seen) {
                    *step = advance(environment, config, worker, action, seen, last);
                }
            },
        );
        out.collect(&steps, config.autoreset);
        Ok(out)
    }

    /// The observation of `viewer` in environment `index`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment or seat.
    pub fn observe(&self, index: usize, viewer: Seat) -> Result<Vec<f32>, Error> {
        let environment = self.environment(index)?;
        if viewer > 1 {
            let what = format!("there is no player {viewer}");
            return Err(Error::input("player", what, "write 0 or 1"));
        }
        let mut out = vec![0.0; self.observation_size()];
        environment.observe(viewer, &mut out);
        Ok(out)
    }

    /// The seat that shoots next in environment `index`; none at the end of an episode.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn player(&self, index: usize) -> Result<Option<Seat>, Error> {
        Ok(self.environment(index)?.next().map(|turn| turn.player))
    }

    /// `table` and `physics` of the environments as in a shot file, with dated names of presets: what
    /// a record needs to make the same environments after the presets have changed. No `physics` if
    /// the table's name implies it.
    pub fn presets(&self) -> Node {
        let mut node = self.environments[0].episode.base().to_record_node();
        let Node::Object(fields) = &mut node else { return node };
        fields.retain(|(key, _)| key == "table" || key == "physics");
        node
    }

    /// The data for a drawing of environment `index`: its table, the balls on it (id, radius in m,
    /// position in m) and the scores.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn picture(&self, index: usize) -> Result<Node, Error> {
        let episode = &self.environment(index)?.episode;
        let balls = (0..).zip(episode.balls()).filter_map(|(i, ball)| {
            Some(Node::object([
                ("id", ball.id.as_str().into()),
                ("radius", ball.ball.radius.into()),
                ("position", Node::from(episode.place(i)?)),
            ]))
        });
        Ok(Node::object([
            ("table", episode.base().table().to_node()),
            ("balls", Node::List(balls.collect())),
            ("scores", Node::list(episode.scores().map(i64::from))),
        ]))
    }

    fn environment(&self, index: usize) -> Result<&Environment, Error> {
        let count = self.len();
        self.environments.get(index).ok_or_else(|| {
            let what = format!("there is no environment {index}");
            Error::input("index", what, format!("write a number below {count}"))
        })
    }
}

impl Transitions {
    fn collect(&mut self, steps: &[(StepResult, i8)], autoreset: Autoreset) {
        self.rewards = steps.iter().map(|(step, _)| step.reward).collect();
        self.terminated = steps.iter().map(|(step, _)| step.terminated).collect();
        self.truncated = steps.iter().map(|(step, _)| step.truncated).collect();
        self.legal = steps.iter().map(|(step, _)| step.legal).collect();
        self.potted = steps.iter().map(|(step, _)| step.potted as u8).collect();
        self.players = steps.iter().map(|(_, player)| *player).collect();
        let ended = steps.iter().any(|(step, _)| step.terminated || step.truncated);
        if autoreset != Autoreset::SameStep || !ended {
            self.final_observations.clear();
        }
    }
}

/// Plays one shot in one environment, and resets it according to the settings. Returns the result
/// and the seat that shoots next.
fn advance(
    environment: &mut Environment,
    config: &Config,
    worker: &mut Worker,
    action: &[f32],
    seen: &mut [f32],
    last: &mut [f32],
) -> (StepResult, i8) {
    let mut step = StepResult::default();
    if environment.ended && config.autoreset == Autoreset::NextStep {
        restart(environment);
    } else {
        step = environment.step(config, worker, action);
        if environment.ended && config.autoreset == Autoreset::SameStep {
            environment.observe(environment.viewer(config), last);
            restart(environment);
        }
    }
    environment.observe(environment.viewer(config), seen);
    (step, environment.next().map_or(-1, |turn| turn.player as i8))
}

/// Starts the next episode whose layout fits. If several in a row do not fit, the table is too
/// small for the task, and every step is truncated.
fn restart(environment: &mut Environment) {
    for _ in 0..RESTARTS {
        if environment.next_episode().is_ok() {
            return;
        }
    }
}

fn check_length(place: &str, found: usize, wanted: usize) -> Result<(), Error> {
    if found == wanted {
        return Ok(());
    }
    Err(Error::input(place, format!("its length is {found}"), format!("give {wanted} numbers")))
}
