//! Many environments at once.

use std::borrow::Cow;
use std::sync::Arc;

use carom::format::{Node, with_dated_names};
use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::shot::PlacedBall;
use carom::{BallState, Error, ErrorKind, Noise, Shot};
use carom_rules::{Fouls, Frame, FrameBall, FrameSimulator, Play, Seat, StateBytes};

use crate::action::{ACTIONS, ACTIONS_WITHOUT_HAND};
use crate::config::Config;
use crate::environment::{self, Environment, Reply, StepResult};
use crate::episode::EpisodeStart;
use crate::modes::{Autoreset, Opponent};
use crate::observe::{self, SCORE_BOUND};
use crate::saved;
use crate::setup::Setup;
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
    /// The fouls of the agent's shot.
    pub fouls: Vec<Fouls>,
    /// The agent's strike as it was played: speed (m/s), azimuth, elevation (rad), side, height. NaN if
    /// none was played.
    pub strikes: Vec<[f64; 5]>,
    /// The winner of an episode that ended; −1 without one.
    pub winners: Vec<i8>,
    /// Why the episode ended; none if it goes on.
    pub why: Vec<Option<Cow<'static, str>>>,
}

/// An environment whose opponent, outside this crate, has to answer.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The environment's number.
    pub index: usize,
    pub(crate) environment: &'a Environment,
    config: &'a Config,
}

impl<'a> Asked<'a> {
    /// The opponent's seat.
    pub const fn seat(&self) -> Seat {
        self.environment.opponent()
    }

    /// The frame that asks; none in a task without a referee.
    pub fn frame(&self) -> Option<&'a Frame> {
        self.environment.episode.frame()
    }

    /// The noise of the opponent's strikes, and of the agent's.
    pub fn noise(&self) -> [Noise; 2] {
        [false, true].map(|is_agent| self.config.noise_of(is_agent))
    }

    /// Appends the opponent's observation to `rows`.
    pub fn observe(&self, rows: &mut Vec<f32>) {
        let (first, episode) = (rows.len(), &self.environment.episode);
        rows.resize(first + observe::size(episode.balls().len()), 0.0);
        self.environment.observe(self.seat(), &mut rows[first..]);
    }
}

/// An opponent outside this crate: an answer for each of the environments that ask.
pub type Answers<'a, E> = dyn FnMut(&[Asked<'_>]) -> Result<Vec<Reply>, E> + 'a;

/// The opponent of a vector that has none outside.
fn nobody(_: &[Asked<'_>]) -> Result<Vec<Reply>, Error> {
    let remedy = "call reset_against and step_against with it";
    Err(ErrorKind::WrongState.at("opponent", "it is outside the environments", remedy))
}

/// A vector of independent environments of one task. A clone has the same state and is independent
/// of the original, so a program can try an action on a clone.
#[derive(Clone)]
pub struct VectorEnv {
    task: Task,
    config: Arc<Config>,
    balls: usize,
    environments: Vec<Environment>,
    runner: Runner,
    /// Whether an opponent outside failed in the middle of the last step or reset.
    interrupted: bool,
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
            return Err(ErrorKind::OutOfRange.at(
                "n",
                format!("{n} environments are too many"),
                format!("ask for at most {MAX_ENVIRONMENTS}"),
            ));
        }
        config.check(task)?;
        let runner = Runner::new(config.threads)?;
        let setups: Vec<Arc<Setup>> = config
            .setups
            .iter()
            .map(|setup| {
                let table = setup.table.clone().or_else(|| Some(task.table().into()));
                Arc::new(Setup { table, physics: setup.physics.clone() })
            })
            .collect();
        if setups.len() != 1 && setups.len() != n {
            let what = format!("there are {} for {n} environments", setups.len());
            return Err(ErrorKind::WrongCount.at(
                "setups",
                what,
                "give one, or one for each environment",
            ));
        }
        let episodes = config.setups.iter().enumerate().map(|(index, setup)| {
            environment::episode(task, &config, setup).map_err(|error| match config.setups.len() {
                1 => error,
                _ => error.inside(&format!("[{index}]")),
            })
        });
        let episodes = episodes.collect::<Result<Vec<_>, Error>>()?;
        let balls = episodes[0].balls().len();
        let environments = (0..n)
            .map(|i| {
                let own = i % setups.len();
                let seed = seed.wrapping_add(i as u64);
                Environment::new(episodes[own].boxed(), setups[own].clone(), seed)
            })
            .collect();
        let config = Arc::new(config);
        let mut vector = Self { task, config, balls, environments, runner, interrupted: false };
        // Reports a layout that does not fit now, instead of in the middle of a run.
        let config = vector.config.clone();
        if let Some(first) = vector.environments.first_mut() {
            first.seed(&config, seed, None)?;
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

    /// The task.
    pub const fn task(&self) -> Task {
        self.task
    }

    /// The settings.
    pub fn config(&self) -> &Config {
        &self.config
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
        self.reset_against(seeds, mask, &[], &mut nobody)
    }

    /// As [`Self::reset`], against an opponent outside, if the settings name one. An episode begins at
    /// its entry in `starts`; the list may be empty, or have one entry for all environments.
    ///
    /// # Errors
    /// As [`Self::reset`]; for a start that the task cannot have; and those of `opponent`, after which
    /// every environment has to be reset.
    pub fn reset_against<E: From<Error>>(
        &mut self,
        seeds: Option<&[u64]>,
        mask: Option<&[bool]>,
        starts: &[Option<EpisodeStart>],
        opponent: &mut Answers<'_, E>,
    ) -> Result<Vec<f32>, E> {
        let n = self.len();
        check_length("seeds", seeds.map_or(n, <[u64]>::len), n)?;
        check_length("mask", mask.map_or(n, <[bool]>::len), n)?;
        if starts.len() > 1 {
            check_length("shot", starts.len(), n)?;
        }
        if mask.is_some_and(|mask| mask.contains(&false)) {
            self.check_whole()?;
        }
        self.interrupted = true;
        let Self { environments, config, runner, .. } = self;
        let chunks = environments.chunks_mut(chunk(config)).enumerate();
        let size = chunk(config);
        let reset = runner.map(
            chunks,
            || Worker::new(config),
            |worker, (chunk, environments)| -> Result<(), Error> {
                for (i, environment) in (chunk * size..).zip(environments.iter_mut()) {
                    if mask.is_some_and(|mask| !mask[i]) {
                        continue;
                    }
                    let start = starts.get(i % starts.len().max(1)).and_then(Option::as_ref);
                    let begun = match seeds {
                        Some(seeds) => environment.seed(config, seeds[i], start),
                        None => environment.next_episode(config, start),
                    };
                    begun.map_err(|error| match starts.len() {
                        0 | 1 => error,
                        _ => error.inside(&format!("[{i}]")),
                    })?;
                    environment.reply(config, worker);
                }
                Ok(())
            },
        );
        reset.into_iter().collect::<Result<(), Error>>()?;
        self.ask(opponent)?;
        self.interrupted = false;
        Ok(self.observations())
    }

    /// Plays a shot in every environment. `actions` are rows of [`Self::action_size`]. Numbers
    /// outside [−1, 1] are clamped, and NaN becomes 0.
    ///
    /// # Errors
    /// [`Error::Input`] if `actions` has another length.
    pub fn step(&mut self, actions: &[f32]) -> Result<Transitions, Error> {
        self.step_against(actions, &mut nobody)
    }

    /// As [`Self::step`], against an opponent outside, if the settings name one. It answers for all
    /// environments together, until none waits for it.
    ///
    /// # Errors
    /// As [`Self::step`], and those of `opponent`, after which every environment has to be reset or to
    /// get another state.
    pub fn step_against<E: From<Error>>(
        &mut self,
        actions: &[f32],
        opponent: &mut Answers<'_, E>,
    ) -> Result<Transitions, E> {
        let (n, size, width) = (self.len(), self.observation_size(), self.action_size());
        check_length("actions", actions.len(), n * width)?;
        self.check_whole()?;
        let mut out = Transitions {
            observations: vec![0.0; n * size],
            final_observations: vec![0.0; n * size],
            ..Transitions::default()
        };
        let mut steps = vec![(StepResult::default(), -1); n];
        if matches!(self.config.opponent, Opponent::Outside(_)) {
            self.interrupted = true;
            self.begin_steps(actions);
            self.ask(opponent)?;
            self.end_steps(&mut steps, &mut out.final_observations);
            self.ask(opponent)?;
            self.interrupted = false;
            out.observations = self.observations();
            for ((_, player), environment) in steps.iter_mut().zip(&self.environments) {
                *player = next_player(environment);
            }
            out.collect(steps, self.config.autoreset_mode);
            return Ok(out);
        }
        let Self { environments, config, runner, .. } = self;
        let chunk = chunk(config);
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
        out.collect(steps, config.autoreset_mode);
        Ok(out)
    }

    /// Plays the agent's shot in every environment whose episode goes on.
    fn begin_steps(&mut self, actions: &[f32]) {
        let width = self.action_size();
        let Self { environments, config, runner, .. } = self;
        let chunks = environments.chunks_mut(CHUNK).zip(actions.chunks(CHUNK * width));
        runner.map(
            chunks,
            || Worker::new(config),
            |worker, (environments, actions)| {
                for (environment, action) in environments.iter_mut().zip(actions.chunks(width)) {
                    if !environment.ended || config.autoreset_mode != Autoreset::NextStep {
                        environment.begin_step(config, worker, action);
                    }
                }
            },
        );
    }

    /// Completes the step of every environment, and resets according to the settings.
    fn end_steps(&mut self, steps: &mut [(StepResult, i8)], last: &mut [f32]) {
        let size = self.observation_size();
        let Self { environments, config, .. } = self;
        for ((environment, (step, _)), last) in
            environments.iter_mut().zip(steps).zip(last.chunks_mut(size))
        {
            if environment.ended && config.autoreset_mode == Autoreset::NextStep {
                restart(environment, config, None);
                continue;
            }
            *step = environment.end_step(config);
            if environment.ended && config.autoreset_mode == Autoreset::SameStep {
                environment.observe(environment.viewer(config), last);
                restart(environment, config, None);
            }
        }
    }

    /// Asks the opponent outside until no environment waits for it.
    fn ask<E: From<Error>>(&mut self, opponent: &mut Answers<'_, E>) -> Result<(), E> {
        loop {
            let config = &*self.config;
            let asked: Vec<Asked<'_>> = self
                .environments
                .iter()
                .enumerate()
                .filter(|(_, environment)| environment.waits(config))
                .map(|(index, environment)| Asked { index, environment, config })
                .collect();
            if asked.is_empty() {
                return Ok(());
            }
            let replies = opponent(&asked)?;
            check_length("opponent", replies.len(), asked.len())?;
            let mut waiting = vec![None; self.environments.len()];
            let indices: Vec<usize> = asked.iter().map(|asked| asked.index).collect();
            for (index, reply) in indices.into_iter().zip(replies) {
                waiting[index] = Some(reply);
            }
            let Self { environments, config, runner, .. } = self;
            let chunks = environments.chunks_mut(CHUNK).zip(waiting.chunks(CHUNK));
            runner.map(
                chunks,
                || Worker::new(config),
                |worker, (environments, replies)| {
                    for (environment, reply) in environments.iter_mut().zip(replies) {
                        if let Some(reply) = reply {
                            environment.answer(config, worker, reply);
                        }
                    }
                },
            );
        }
    }

    fn check_whole(&self) -> Result<(), Error> {
        if !self.interrupted {
            return Ok(());
        }
        Err(ErrorKind::WrongState.at(
            "environment",
            "its last step or reset did not end",
            "reset every environment, or set an earlier state",
        ))
    }

    /// The observations of all environments, as the agent sees them.
    pub fn observations(&self) -> Vec<f32> {
        let size = self.observation_size();
        let mut observations = vec![0.0; self.len() * size];
        for (environment, row) in self.environments.iter().zip(observations.chunks_mut(size)) {
            environment.observe(environment.viewer(&self.config), row);
        }
        observations
    }

    /// `n` copies of environment `index` in its present state, which step as one vector and do not reset
    /// by themselves, on this number of threads. With `seeds`, the errors of strikes, the decisions and
    /// the racks to come are other ones in each copy; without, they are those of the environment.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment, for too many copies, and for another number of
    /// seeds.
    pub fn copies(
        &self,
        index: usize,
        n: usize,
        seeds: Option<&[u64]>,
        threads: Option<usize>,
    ) -> Result<Self, Error> {
        self.check_whole()?;
        let environment = self.environment(index)?;
        check_length("seeds", seeds.map_or(n, <[u64]>::len), n)?;
        if n > MAX_ENVIRONMENTS {
            let what = format!("{n} copies are too many");
            return Err(ErrorKind::OutOfRange.at(
                "n",
                what,
                format!("ask for at most {MAX_ENVIRONMENTS}"),
            ));
        }
        let setups = self.config.setups.get(index).or(self.config.setups.first());
        let config = Config {
            autoreset_mode: Autoreset::Disabled,
            setups: setups.cloned().into_iter().collect(),
            threads,
            ..(*self.config).clone()
        };
        let mut environments = vec![environment.clone(); n];
        for (environment, seed) in environments.iter_mut().zip(seeds.unwrap_or_default()) {
            environment.reseed(*seed);
        }
        let (task, balls, runner) = (self.task, self.balls, Runner::new(threads)?);
        Ok(Self { task, config: config.into(), balls, environments, runner, interrupted: false })
    }

    /// The state of all environments, for [`Self::set_state`]: everything on which the results of further
    /// steps and resets depend. `attachment` is stored with it, for the state of an opponent outside.
    ///
    /// # Errors
    /// [`Error::Input`] after an opponent outside failed in the middle of a step.
    pub fn state(&self, attachment: &[u8]) -> Result<Vec<u8>, Error> {
        self.check_whole()?;
        let mut body = Vec::new();
        (attachment.len() as u64).write_to(&mut body);
        body.extend(attachment);
        self.environments.iter().for_each(|environment| environment.write_to(&mut body));
        Ok(saved::pack(&saved::settings(self.task, self.len(), &self.config), &body))
    }

    /// Continues from a state of environments with the same task and settings; the number of threads and
    /// the mode of resets may differ. Returns the attachment. After an error the environments are as
    /// before.
    ///
    /// # Errors
    /// [`Error::Input`] for bytes that are not such a state, are damaged, or are of another version of
    /// the format; and for other settings, which it names.
    pub fn set_state<'a>(&mut self, state: &'a [u8]) -> Result<&'a [u8], Error> {
        let settings = saved::settings(self.task, self.len(), &self.config);
        let mut body = saved::unpack(&settings, state)?;
        let length = u64::read_from(&mut body).ok_or_else(saved::damaged)?;
        let parts = usize::try_from(length).ok().and_then(|length| body.split_at_checked(length));
        let (attachment, mut body) = parts.ok_or_else(saved::damaged)?;
        let mut environments = self.environments.clone();
        for environment in &mut environments {
            environment.read_from(&self.config, &mut body).ok_or_else(saved::damaged)?;
        }
        if !body.is_empty() {
            return Err(saved::damaged());
        }
        (self.environments, self.interrupted) = (environments, false);
        Ok(attachment)
    }

    /// The strike, the place of a cue ball in hand and the call of `action` in environment `index`, as the
    /// agent intends them; none at the end of an episode, and if there is no place for the cue ball.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn play(&self, index: usize, action: &[f32]) -> Result<Option<Play>, Error> {
        let environment = self.environment(index)?;
        Ok(environment.intended(&self.config, action).map(|strike| {
            let call = environment.episode.call_of(&mut FrameSimulator::new(), &strike);
            Play { cue_ball: strike.cue_ball, call, ..Play::new(strike.intended) }
        }))
    }

    /// The frame of environment `index`; none in a task without a referee.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn frame(&self, index: usize) -> Result<Option<&Frame>, Error> {
        Ok(self.environment(index)?.episode.frame())
    }

    /// The balls on the table of environment `index`, as a shot without a strike.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn shot(&self, index: usize) -> Result<Shot, Error> {
        let episode = &self.environment(index)?.episode;
        let placed = (0..).zip(episode.balls()).filter_map(|(i, FrameBall { id, ball })| {
            let [x, y] = episode.place(i)?;
            let position = Vec3::new(x, y, ball.radius);
            let state = BallState { position, ..BallState::default() };
            Some(PlacedBall { id: id.clone(), ball: *ball, state })
        });
        episode.base().with_balls(placed.collect(), None)
    }

    /// The observation at the start of an episode that starts in environment `index` at `start`, by the
    /// player who shoots first. The environment does not change.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment, and for a start that the task cannot have.
    pub fn observe_start(&self, index: usize, start: &EpisodeStart) -> Result<Vec<f32>, Error> {
        let mut episode = self.environment(index)?.episode.boxed();
        episode.restart(0)?;
        episode.start_at(start, &self.config)?;
        let mut out = vec![0.0; self.observation_size()];
        observe::write(&*episode, episode.turn().map_or(0, |turn| turn.player), &mut out);
        Ok(out)
    }

    /// The shots of the last step in environment `index` as they were played: the agent's, then the
    /// opponent's. Empty unless the settings ask for them.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment.
    pub fn shots(&self, index: usize) -> Result<&[Shot], Error> {
        Ok(&self.environment(index)?.shots)
    }

    /// The seat that shoots next in every environment; −1 at the end of an episode.
    pub fn players(&self) -> Vec<i8> {
        self.environments.iter().map(next_player).collect()
    }

    /// The agent's seat in every environment, if it has an opponent.
    pub fn seats(&self) -> Vec<i8> {
        self.environments.iter().map(|environment| 1 - environment.opponent() as i8).collect()
    }

    /// The variables of the present episodes: for each environment one number for each variable of
    /// [`Config::randomize`].
    pub fn drawn(&self) -> impl Iterator<Item = &[f64]> {
        self.environments.iter().map(|environment| &environment.drawn[..])
    }

    /// The observation of `viewer` in environment `index`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such environment or seat.
    pub fn observe(&self, index: usize, viewer: Seat) -> Result<Vec<f32>, Error> {
        let environment = self.environment(index)?;
        if viewer > 1 {
            let what = format!("there is no player {viewer}");
            return Err(ErrorKind::OutOfRange.at("player", what, "write 0 or 1"));
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
        let mut node = with_dated_names(&self.environments[0].episode.base().to_node());
        let Node::Object(fields) = &mut node else { return node };
        fields.retain(|(key, _)| key == "table" || key == "physics");
        node
    }

    /// What tells the episode of environment `index` apart from all others in it; none after its end.
    pub(crate) fn episode_in_progress(&self, index: usize) -> Option<u64> {
        let environment = self.environments.get(index)?;
        (!environment.ended).then_some(environment.starts)
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
            ErrorKind::OutOfRange.at("index", what, format!("write a number below {count}"))
        })
    }
}

impl Transitions {
    fn collect(&mut self, steps: Vec<(StepResult, i8)>, autoreset: Autoreset) {
        self.rewards = steps.iter().map(|(step, _)| step.reward).collect();
        self.terminated = steps.iter().map(|(step, _)| step.terminated).collect();
        self.truncated = steps.iter().map(|(step, _)| step.truncated).collect();
        self.legal = steps.iter().map(|(step, _)| step.legal).collect();
        self.potted = steps.iter().map(|(step, _)| step.potted as u8).collect();
        self.fouls = steps.iter().map(|(step, _)| step.fouls).collect();
        self.strikes = steps.iter().map(|(step, _)| numbers(step.strike)).collect();
        self.winners =
            steps.iter().map(|(step, _)| step.winner.map_or(-1, |seat| seat as i8)).collect();
        self.players = steps.iter().map(|(_, player)| *player).collect();
        let ended = steps.iter().any(|(step, _)| step.terminated || step.truncated);
        self.why = steps.into_iter().map(|(step, _)| step.why).collect();
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
    if environment.ended && config.autoreset_mode == Autoreset::NextStep {
        restart(environment, config, Some(worker));
    } else {
        step = environment.step(config, worker, action);
        if environment.ended && config.autoreset_mode == Autoreset::SameStep {
            environment.observe(environment.viewer(config), last);
            restart(environment, config, Some(worker));
        }
    }
    environment.observe(environment.viewer(config), seen);
    (step, next_player(environment))
}

/// The seat that shoots next; −1 at the end of an episode.
fn next_player(environment: &Environment) -> i8 {
    environment.next().map_or(-1, |turn| turn.player as i8)
}

/// Speed, azimuth, elevation, side, height; NaN without a strike.
fn numbers(strike: Option<Strike>) -> [f64; 5] {
    strike.map_or([f64::NAN; 5], |s| [s.speed, s.azimuth, s.elevation, s.side, s.height])
}

/// Environments in one item of work.
const fn chunk(config: &Config) -> usize {
    match config.opponent {
        Opponent::Player(_) => PLAYER_CHUNK,
        _ => CHUNK,
    }
}

/// Starts the next episode whose layout fits. If several in a row do not fit, the table is too
/// small for the task, and every step is truncated. An opponent of the worker opens, if it begins.
fn restart(environment: &mut Environment, config: &Config, worker: Option<&mut Worker>) {
    for _ in 0..RESTARTS {
        if environment.next_episode(config, None).is_ok() {
            if let Some(worker) = worker {
                environment.reply(config, worker);
            }
            return;
        }
    }
}

fn check_length(place: &str, found: usize, wanted: usize) -> Result<(), Error> {
    if found == wanted {
        return Ok(());
    }
    Err(ErrorKind::WrongCount.at(
        place,
        format!("its length is {found}"),
        format!("give {wanted} numbers"),
    ))
}
