//! Many environments at once.

use std::sync::Arc;

use carom::Error;
use carom::format::Node;
use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom_rules::Player;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::action::{ACTIONS, ACTIONS_WITHOUT_HAND};
use crate::config::{Autoreset, Config, Task};
use crate::environment::{self, Environment, Step};
use crate::observe::{self, SCORE_BOUND};

/// Environments that one thread takes at a time: some hundred microseconds of work, so that handing them
/// out costs nothing and the threads still end together.
const CHUNK: usize = 16;

/// Episodes that are tried to begin with a layout that fits.
const RESTARTS: u32 = 8;

/// What came of a step of every environment: a row or a number for each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transitions {
    /// What is seen now, rows of [`VectorEnv::observation_size`].
    pub observations: Vec<f32>,
    /// Rewards.
    pub rewards: Vec<f64>,
    /// Whether the episode has ended by its rules.
    pub terminated: Vec<bool>,
    /// Whether it has ended otherwise: nobody got on, or a shot could not be played.
    pub truncated: Vec<bool>,
    /// What was seen at the end of an episode, where `observations` is of the next one already: rows as
    /// there, 0 elsewhere. Empty unless environments reset in the same step, and one has.
    pub final_observations: Vec<f32>,
    /// Who shoots next; −1 at the end of an episode.
    pub players: Vec<i8>,
    /// Whether the agent's shot was legal.
    pub legal: Vec<bool>,
    /// Balls that the agent's shot potted, and that were the shooter's to pot.
    pub potted: Vec<u8>,
}

/// A row of environments of one task. A clone goes on by itself from where the row is: to try an action,
/// and forget it.
#[derive(Clone)]
pub struct VectorEnv {
    task: Task,
    config: Config,
    balls: usize,
    environments: Vec<Environment>,
    pool: Option<Arc<ThreadPool>>,
}

impl VectorEnv {
    /// `n` environments, not yet reset. Environment i has the seed `seed` + i.
    ///
    /// # Errors
    /// [`Error::Input`] for numbers out of range, a table or physics that a shot file would be refused
    /// for, and a table that the task cannot be played on.
    pub fn new(task: Task, n: usize, seed: u64, config: Config) -> Result<Self, Error> {
        config.check(task)?;
        let scene = environment::scene(task, &config)?;
        let balls = scene.pieces().len();
        let environments =
            (0..n as u64).map(|i| Environment::new(scene.boxed(), seed.wrapping_add(i))).collect();
        let threads = config.threads.map(|n| ThreadPoolBuilder::new().num_threads(n).build());
        let pool = threads.transpose().map_err(|e| {
            Error::input("threads", format!("{e}"), "ask for fewer, or leave it out")
        })?;
        let mut vector = Self { task, config, balls, environments, pool: pool.map(Arc::new) };
        // A layout that does not fit is found here, not in the middle of a run.
        if let Some(first) = vector.environments.first_mut() {
            first.seed(seed)?;
        }
        Ok(vector)
    }

    /// Number of environments.
    pub fn len(&self) -> usize {
        self.environments.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.environments.is_empty()
    }

    /// Length of an observation.
    pub const fn observation_size(&self) -> usize {
        observe::size(self.balls)
    }

    /// Length of an action; every number is in [−1, 1].
    pub const fn action_size(&self) -> usize {
        if self.task.has_hand() { ACTIONS.len() } else { ACTIONS_WITHOUT_HAND }
    }

    /// The least and the largest number at every place of an observation.
    pub fn observation_bounds(&self) -> [Vec<f32>; 2] {
        let least_score = if self.task.has_negative_scores() { -SCORE_BOUND } else { 0.0 };
        [observe::low(self.balls, least_score), observe::high(self.balls)]
    }

    /// Begins a new episode in every environment (in those that `mask` marks, if it is given), and tells
    /// what is seen in all of them. With `seeds` (one for each environment) it is the first episode of that
    /// seed, else the next one of the environment's own.
    ///
    /// # Errors
    /// [`Error::Input`] if `seeds` or `mask` has another length than the row.
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
        let Self { environments, config, pool, .. } = self;
        let mut work = || {
            environments
                .par_iter_mut()
                .zip(observations.par_chunks_mut(size))
                .enumerate()
                .try_for_each(|(i, (environment, out))| {
                    if mask.is_none_or(|mask| mask[i]) {
                        match seeds {
                            Some(seeds) => environment.seed(seeds[i])?,
                            None => environment.next_episode()?,
                        }
                    }
                    environment.observe(environment.viewer(config), out);
                    Ok(())
                })
        };
        match pool {
            Some(pool) => pool.install(work)?,
            None => work()?,
        }
        Ok(observations)
    }

    /// Plays a shot in every environment. `actions`: rows of [`Self::action_size`]; numbers beyond [−1, 1]
    /// are brought into it, what is no number is 0.
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
        let mut steps = vec![(Step::default(), -1); n];
        let Self { environments, config, pool, .. } = self;
        let mut work = || {
            environments
                .par_chunks_mut(CHUNK)
                .zip(steps.par_chunks_mut(CHUNK))
                .zip(actions.par_chunks(CHUNK * width))
                .zip(out.observations.par_chunks_mut(CHUNK * size))
                .zip(out.final_observations.par_chunks_mut(CHUNK * size))
                .for_each_init(
                    || Box::new(Simulation::new()),
                    |simulation, ((((environments, steps), actions), seen), last)| {
                        let rows = environments.iter_mut().zip(steps).zip(actions.chunks(width));
                        let seen = seen.chunks_mut(size).zip(last.chunks_mut(size));
                        for (((environment, step), action), (seen, last)) in rows.zip(seen) {
                            *step = advance(environment, config, simulation, action, seen, last);
                        }
                    },
                );
        };
        match pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
        out.collect(&steps, config.autoreset);
        Ok(out)
    }

    /// What `viewer` sees in environment `index`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment or player.
    pub fn observe(&self, index: usize, viewer: Player) -> Result<Vec<f32>, Error> {
        let environment = self.environment(index)?;
        if viewer > 1 {
            return Err(Error::input("player", format!("{viewer} is none"), "write 0 or 1"));
        }
        let mut out = vec![0.0; self.observation_size()];
        environment.observe(viewer, &mut out);
        Ok(out)
    }

    /// Who shoots next in environment `index`; none at the end of an episode.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn player(&self, index: usize) -> Result<Option<Player>, Error> {
        Ok(self.environment(index)?.next().map(|turn| turn.player))
    }

    /// What a picture of environment `index` needs: its table, its balls (id, radius in m, and place in m) and
    /// the scores.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn picture(&self, index: usize) -> Result<Node, Error> {
        let scene = &self.environment(index)?.scene;
        let balls = (0..).zip(scene.pieces()).filter_map(|(ball, piece)| {
            Some(Node::object([
                ("id", piece.id.as_str().into()),
                ("radius", piece.ball.radius.into()),
                ("position", Node::from(scene.place(ball)?)),
            ]))
        });
        Ok(Node::object([
            ("table", scene.base().table().to_node()),
            ("balls", Node::List(balls.collect())),
            ("scores", Node::list(scene.scores().map(i64::from))),
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
    fn collect(&mut self, steps: &[(Step, i8)], autoreset: Autoreset) {
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

/// Plays one shot in one environment, and resets it as asked. Returns what came of it, and who is next.
fn advance(
    environment: &mut Environment,
    config: &Config,
    simulation: &mut Simulation<SMALL_CAPACITY>,
    action: &[f32],
    seen: &mut [f32],
    last: &mut [f32],
) -> (Step, i8) {
    let mut step = Step::default();
    if environment.ended && config.autoreset == Autoreset::NextStep {
        restart(environment);
    } else {
        step = environment.step(config, simulation, action);
        if environment.ended && config.autoreset == Autoreset::SameStep {
            environment.observe(environment.viewer(config), last);
            restart(environment);
        }
    }
    environment.observe(environment.viewer(config), seen);
    (step, environment.next().map_or(-1, |turn| turn.player as i8))
}

/// The next episode. Should a layout not fit, the next one does; where none of some does, the table is too
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
    Err(Error::input(place, format!("found {found}"), format!("give {wanted}")))
}
