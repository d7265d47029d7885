//! One environment.

use carom::Error;
use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom_rules::{Player, Turn};

use crate::action;
use crate::config::{Config, Task};
use crate::frame::FrameScene;
use crate::observe;
use crate::opponent::Opponent;
use crate::potting::Potting;
use crate::random::{Dice, episode_seed};
use crate::scene::{Ending, Played, Scene, Stroke};
use crate::sum_to_three::SumToThree;

/// What an agent that has an opponent plays.
const AGENT: Player = 0;

/// The scene of `task`.
pub(crate) fn scene(task: Task, config: &Config) -> Result<Box<dyn Scene>, Error> {
    Ok(match task {
        Task::Potting => Box::new(Potting::new(config)?),
        Task::Game(rules) => Box::new(FrameScene::new(rules, config)?),
        Task::SumToThree => Box::new(SumToThree::new(config)?),
    })
}

/// What came of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Step {
    pub(crate) reward: f64,
    pub(crate) terminated: bool,
    pub(crate) truncated: bool,
    /// Whether the agent's shot was legal.
    pub(crate) legal: bool,
    /// Balls that the agent potted.
    pub(crate) potted: u32,
}

/// One environment.
#[derive(Clone)]
pub(crate) struct Environment {
    seed: u64,
    episode: u64,
    episode_seed: u64,
    /// Steps of this episode.
    steps: u32,
    /// Shots of this episode, the opponent's too.
    shots: u64,
    pub(crate) scene: Box<dyn Scene>,
    /// Whether the episode has ended.
    pub(crate) ended: bool,
    /// Who shot last.
    shooter: Player,
}

impl Environment {
    pub(crate) fn new(scene: Box<dyn Scene>, seed: u64) -> Self {
        Self {
            seed,
            episode: 0,
            episode_seed: 0,
            steps: 0,
            shots: 0,
            scene,
            ended: true,
            shooter: 0,
        }
    }

    /// Begins the first episode of `seed`.
    pub(crate) fn seed(&mut self, seed: u64) -> Result<(), Error> {
        (self.seed, self.episode) = (seed, 0);
        self.begin()
    }

    /// Begins the next episode.
    pub(crate) fn next_episode(&mut self) -> Result<(), Error> {
        self.episode += 1;
        self.begin()
    }

    fn begin(&mut self) -> Result<(), Error> {
        self.episode_seed = episode_seed(self.seed, self.episode);
        (self.steps, self.shots) = (0, 0);
        self.shooter = 0;
        self.ended = true;
        self.scene.restart(self.episode_seed)?;
        self.ended = false;
        Ok(())
    }

    /// The next shot; none at the end of an episode.
    pub(crate) fn next(&self) -> Option<&Turn> {
        self.scene.turn().filter(|_| !self.ended)
    }

    /// Whose eyes the agent sees with.
    pub(crate) fn viewer(&self, config: &Config) -> Player {
        match config.opponent {
            Opponent::None => self.scene.turn().map_or(self.shooter, |turn| turn.player),
            _ => AGENT,
        }
    }

    pub(crate) fn observe(&self, viewer: Player, out: &mut [f32]) {
        observe::write(&*self.scene, viewer, out);
    }

    /// Plays `action`, and what the opponent replies. Nothing after the end of an episode.
    pub(crate) fn step(
        &mut self,
        config: &Config,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        action: &[f32],
    ) -> Step {
        let mut step = Step::default();
        let Some(turn) = self.next() else {
            self.ended = true;
            return Step { truncated: true, ..step };
        };
        let (scene, errors) = (&*self.scene, (self.episode_seed, self.shots));
        let stroke = action::stroke(config, scene, turn, action, errors);
        let agent = turn.player;
        if let Some(played) = self.play(config, simulation, stroke, &mut step) {
            step.reward = self.earned(config, agent, &played);
            step.legal = played.legal;
            step.potted = played.potted;
            self.reply(config, simulation, &mut step);
        }
        match self.scene.ending() {
            Some(Ending::Stalemate) => step.truncated = true,
            Some(Ending::Won(_) | Ending::Drawn) => step.terminated = !step.truncated,
            None => {}
        }
        self.steps += 1;
        step.truncated |=
            !step.terminated && config.max_steps.is_some_and(|most| self.steps >= most);
        self.ended = step.terminated || step.truncated;
        step
    }

    /// The opponent shoots until it is the agent's turn, or the frame is over.
    fn reply(
        &mut self,
        config: &Config,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        step: &mut Step,
    ) {
        if config.opponent == Opponent::None {
            return;
        }
        while let Some(turn) = self.scene.turn().filter(|turn| turn.player != AGENT) {
            let (scene, errors) = (&*self.scene, (self.episode_seed, self.shots));
            let mut dice = Dice::of_opponent(self.episode_seed, self.shots);
            let stroke = config.opponent.stroke(config, scene, turn, &mut dice, errors);
            let Some(played) = self.play(config, simulation, stroke, step) else { return };
            step.reward -= self.earned(config, 1 - AGENT, &played);
        }
    }

    /// Plays a stroke; one that cannot be played ends the episode as truncated.
    fn play(
        &mut self,
        config: &Config,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: Option<Stroke>,
        step: &mut Step,
    ) -> Option<Played> {
        self.shooter = self.scene.turn().map_or(self.shooter, |turn| turn.player);
        self.shots += 1;
        let played = stroke.and_then(|stroke| self.scene.play(simulation, &stroke).ok());
        if played.is_none() {
            step.truncated = true;
            step.reward += config.rewards.failure;
        }
        played
    }

    /// What `player`'s shot has earned it.
    fn earned(&self, config: &Config, player: Player, played: &Played) -> f64 {
        let rewards = &config.rewards;
        let won = match self.scene.ending() {
            Some(Ending::Won(winner)) if winner == player => rewards.win,
            Some(Ending::Won(_)) => -rewards.win,
            _ => 0.0,
        };
        let foul = if played.legal { 0.0 } else { rewards.foul };
        let points = played.points[player] - played.points[1 - player];
        won + foul + rewards.pot * f64::from(played.potted) + rewards.point * f64::from(points)
    }
}
