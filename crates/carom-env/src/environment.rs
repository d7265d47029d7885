//! One environment.

use carom::Error;
use carom_mind::Answer;
use carom_rules::{FrameSimulator, Seat, Turn};

use crate::config::{AGENT, Config};
use crate::episode::{Ending, Episode, NoisyStrike, ShotResult};
use crate::frame::FrameEpisode;
use crate::modes::Opponent;
use crate::potting::Potting;
use crate::random::{decision_seed, episode_seed};
use crate::sum_to_three::SumToThree;
use crate::task::Task;
use crate::worker::Worker;
use crate::{action, observe, opponent};

/// A new episode of `task`.
pub(crate) fn episode(task: Task, config: &Config) -> Result<Box<dyn Episode>, Error> {
    Ok(match task {
        Task::Potting => Box::new(Potting::new(config)?),
        Task::Game(rules) => Box::new(FrameEpisode::new(rules, config)?),
        Task::SumToThree => Box::new(SumToThree::new(config)?),
    })
}

/// The result of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct StepResult {
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
    /// Number of the episode with this seed.
    number: u64,
    episode_seed: u64,
    /// Steps of this episode.
    steps: u32,
    /// Moves of this episode: all shots, and the answers of a player to choices.
    moves: u64,
    pub(crate) episode: Box<dyn Episode>,
    /// Whether the episode has ended.
    pub(crate) ended: bool,
    /// The seat that shot last.
    shooter: Seat,
}

impl Environment {
    pub(crate) fn new(episode: Box<dyn Episode>, seed: u64) -> Self {
        Self {
            seed,
            number: 0,
            episode_seed: 0,
            steps: 0,
            moves: 0,
            episode,
            ended: true,
            shooter: 0,
        }
    }

    /// Begins the first episode of `seed`.
    pub(crate) fn seed(&mut self, seed: u64) -> Result<(), Error> {
        (self.seed, self.number) = (seed, 0);
        self.begin()
    }

    /// Begins the next episode.
    pub(crate) fn next_episode(&mut self) -> Result<(), Error> {
        self.number += 1;
        self.begin()
    }

    fn begin(&mut self) -> Result<(), Error> {
        self.episode_seed = episode_seed(self.seed, self.number);
        (self.steps, self.moves) = (0, 0);
        self.shooter = 0;
        self.ended = true;
        self.episode.restart(self.episode_seed)?;
        self.ended = false;
        Ok(())
    }

    /// The next shot; none after the end of the episode.
    pub(crate) fn next(&self) -> Option<&Turn> {
        self.episode.turn().filter(|_| !self.ended)
    }

    /// The seat from which the agent observes.
    pub(crate) fn viewer(&self, config: &Config) -> Seat {
        match &config.opponent {
            Opponent::None => self.episode.turn().map_or(self.shooter, |turn| turn.player),
            _ => AGENT,
        }
    }

    pub(crate) fn observe(&self, viewer: Seat, out: &mut [f32]) {
        observe::write(&*self.episode, viewer, out);
    }

    /// Plays `action` and the opponent's reply. After the end of the episode nothing is played.
    pub(crate) fn step(
        &mut self,
        config: &Config,
        worker: &mut Worker,
        action: &[f32],
    ) -> StepResult {
        let mut step = StepResult::default();
        let Some(turn) = self.next() else {
            self.ended = true;
            return StepResult { truncated: true, ..step };
        };
        let (episode, draw) = (&*self.episode, (self.episode_seed, self.moves));
        let strike = action::strike(config, episode, turn, action, draw);
        let agent = turn.player;
        if let Some(result) = self.play(config, &mut worker.simulator, strike, &mut step) {
            step.reward = self.reward(config, agent, &result);
            step.legal = result.legal;
            step.potted = result.potted;
            self.reply(config, worker, &mut step);
        }
        match self.episode.ending() {
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
    fn reply(&mut self, config: &Config, worker: &mut Worker, step: &mut StepResult) {
        loop {
            let result = match &config.opponent {
                Opponent::None => return,
                Opponent::Random | Opponent::Potter => {
                    let turn = self.episode.turn().filter(|turn| turn.player != AGENT);
                    let Some(turn) = turn else { return };
                    let draw = (self.episode_seed, self.moves);
                    let strike = opponent::strike(config, &*self.episode, turn, draw);
                    self.play(config, &mut worker.simulator, strike, step)
                }
                Opponent::Player(_) => {
                    let frame = self.episode.frame();
                    let asked = frame.filter(|frame| frame.player() == Some(1 - AGENT));
                    let Some(frame) = asked else { return };
                    let seed = decision_seed(self.episode_seed, self.moves);
                    let answer = worker.decide(config, frame, seed);
                    self.take(config, &mut worker.simulator, answer, step)
                }
            };
            let Some(result) = result else { return };
            step.reward -= self.reward(config, 1 - AGENT, &result);
        }
    }

    /// Takes the answer of a player. A missing answer truncates the episode, and so does one that is not
    /// possible.
    fn take(
        &mut self,
        config: &Config,
        simulator: &mut FrameSimulator,
        answer: Option<Answer>,
        step: &mut StepResult,
    ) -> Option<ShotResult> {
        let draw = (self.episode_seed, self.moves);
        let choice = match answer {
            Some(Answer::Play(play)) => {
                let strike = opponent::strike_of_play(config, &*self.episode, &play, draw);
                return self.play(config, simulator, strike, step);
            }
            Some(Answer::Choice(choice)) => Some(choice),
            Some(Answer::Concede) => None,
            None => return self.play(config, simulator, None, step),
        };
        self.moves += 1;
        let result = self.episode.choose(choice).ok();
        fail_without(result, config, step)
    }

    /// Plays a strike. One that cannot be played truncates the episode.
    fn play(
        &mut self,
        config: &Config,
        simulator: &mut FrameSimulator,
        strike: Option<NoisyStrike>,
        step: &mut StepResult,
    ) -> Option<ShotResult> {
        self.shooter = self.episode.turn().map_or(self.shooter, |turn| turn.player);
        self.moves += 1;
        let result = strike.and_then(|strike| self.episode.play(simulator, &strike).ok());
        fail_without(result, config, step)
    }

    /// The reward of `seat` for its shot.
    fn reward(&self, config: &Config, seat: Seat, result: &ShotResult) -> f64 {
        let rewards = &config.rewards;
        let won = match self.episode.ending() {
            Some(Ending::Won(winner)) if winner == seat => rewards.win,
            Some(Ending::Won(_)) => -rewards.win,
            _ => 0.0,
        };
        let foul = if result.legal { 0.0 } else { rewards.foul };
        let points = result.points[seat] - result.points[1 - seat];
        won + foul + rewards.pot * f64::from(result.potted) + rewards.point * f64::from(points)
    }
}

/// `result`; without one the step is a failure.
fn fail_without(
    result: Option<ShotResult>,
    config: &Config,
    step: &mut StepResult,
) -> Option<ShotResult> {
    if result.is_none() {
        step.truncated = true;
        step.reward += config.rewards.failure;
    }
    result
}

#[cfg(test)]
mod tests {
    use carom::batch::draw_strikes;
    use carom::noise::{OFFSET_KEPT, SLOWEST, STEEPEST};
    use carom::{Noise, Simulator};
    use carom_arena::BuiltInPlayer;
    use carom_mind::{Answer, Budget, Situation};
    use carom_rules::{Choice, Frame, Play, Request, Rules};

    use super::{Environment, StepResult, episode};
    use crate::action::strike;
    use crate::config::Config;
    use crate::episode::{Ending, Episode};
    use crate::modes::Opponent;
    use crate::opponent::strike_of_play;
    use crate::random::{decision_seed, episode_seed};
    use crate::task::Task;
    use crate::worker::Worker;

    /// An action at the limits of all numbers: the slowest strike, far off centre, with a steep cue.
    const FAR_OUT: [f32; 7] = [0.3, -1.0, 0.8, -0.6, 1.0, 0.1, 0.2];

    #[test]
    fn an_action_is_struck_as_the_engine_draws_it_beyond_each_limit_too() {
        let task = Task::Game(Rules::NineBall);
        let noise = Noise { elevation: 0.3, ..Noise::preset("beginner").expect("a preset") };
        let config = Config { noise, speed: [0.1, 8.0], elevation: 1.3, ..Config::of(task) };
        let mut episode: Box<dyn Episode> = episode(task, &config).expect("a task");
        episode.restart(4).expect("a rack");
        let frame = carom_rules::Frame::new(Rules::NineBall, config.options, None, None, 4);
        let frame = frame.expect("the same rack");
        let turn = episode.turn().expect("a shot");
        let mut simulator = Simulator::new();
        let [mut slow, mut steep, mut far] = [0; 3];
        for index in 0..200 {
            let struck = strike(&config, &*episode, turn, &FAR_OUT, (9, index)).expect("a place");
            let play = Play { cue_ball: struck.cue_ball, ..Play::new(struck.intended) };
            let shot = frame.shot(&play).expect("a shot");
            let meant = shot.with_strike(&struck.intended).expect("an intended strike");
            let drawn = draw_strikes(&meant, &noise, 1, 9, index).expect("a strike")[0];
            assert_eq!(struck.actual, drawn);
            let shot = shot.with_strike(&drawn).expect("it can be played");
            simulator.play(&shot, &mut carom::event::NullRecorder).expect("it ends");
            slow += usize::from(drawn.speed == SLOWEST);
            steep += usize::from(drawn.elevation == STEEPEST);
            far += usize::from(drawn.offset() > 0.999_999 * OFFSET_KEPT * shot.miscue_limit());
        }
        assert!(slow > 10 && steep > 10 && far > 10, "{slow} slow, {steep} steep, {far} far out");
    }

    const SEED: u64 = 6;

    /// The first episode of a game against `opponent`, and its settings without noise for the agent.
    fn against(rules: Rules, opponent: &str) -> (Environment, Config) {
        let task = Task::Game(rules);
        let opponent = Opponent::read(opponent).expect("an opponent");
        let config = Config { opponent, ..Config::of(task) };
        let mut environment = Environment::new(episode(task, &config).expect("a task"), SEED);
        environment.seed(SEED).expect("a rack");
        (environment, config)
    }

    fn frame(environment: &Environment) -> Frame {
        environment.episode.frame().expect("a game").clone()
    }

    /// The agent's strike of `action`, without the reply.
    fn agent_plays(environment: &mut Environment, config: &Config, action: &[f32]) {
        let turn = *environment.episode.turn().expect("a shot");
        let strike = strike(config, &*environment.episode, &turn, action, (0, 0));
        let (mut worker, mut step) = (Worker::new(config), StepResult::default());
        environment.play(config, &mut worker.simulator, strike, &mut step).expect("it is played");
    }

    /// A break too weak to be legal: the other player chooses.
    const WEAK_BREAK: [f32; 7] = [0.5, -0.4, 0.0, 0.0, 0.0, 0.0, 0.0];

    #[test]
    fn a_reply_is_what_the_player_decides_about_the_frame() {
        for (rules, name) in [
            (Rules::EightBall, "carom:30"),
            (Rules::NineBall, "greedy:30"),
            (Rules::Snooker, "carom:30"),
        ] {
            let (mut environment, config) = against(rules, name);
            let mut other = environment.clone();
            agent_plays(&mut other, &config, &WEAK_BREAK);
            let mut expected = frame(&other);
            assert_eq!(expected.player(), Some(1), "{name}");
            let read = BuiltInPlayer::read(name).expect("a player");
            let mut moves = 1;
            while expected.player() == Some(1) {
                let seed = decision_seed(episode_seed(SEED, 0), moves);
                let situation = Situation::new(&expected, Noise::NONE, seed);
                let mut player = read.make().expect("a player");
                let decision = player.decide(&situation, &Budget::simulations(30));
                match decision.expect("a decision").answer {
                    Answer::Play(play) => drop(expected.play(&play).expect("a legal play")),
                    Answer::Choice(choice) => drop(expected.choose(choice).expect("a choice")),
                    Answer::Concede => drop(expected.concede().expect("a concession")),
                }
                moves += 1;
            }
            environment.step(&config, &mut Worker::new(&config), &WEAK_BREAK);
            let found = frame(&environment);
            assert_eq!(found.layout(), expected.layout(), "{name}");
            assert_eq!(environment.moves, moves, "{name}");
        }
    }

    #[test]
    fn a_player_answers_its_choices_itself_and_the_others_do_not() {
        for (name, is_asked) in [("carom:30", true), ("potter", false)] {
            let (mut environment, config) = against(Rules::EightBall, name);
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let frame = frame(&environment);
            let asks = matches!(frame.request(), Request::Choice { player: 1, .. });
            assert_eq!((asks, frame.player()), (is_asked, Some(1)), "{name}");
        }
        let (mut environment, config) = against(Rules::EightBall, "carom:30");
        agent_plays(&mut environment, &config, &WEAK_BREAK);
        let (mut worker, mut step) = (Worker::new(&config), StepResult::default());
        let answer = Some(Answer::Choice(Choice::Rebreak));
        let result = environment.take(&config, &mut worker.simulator, answer, &mut step);
        assert!(result.expect("a choice").legal);
        assert_eq!(
            (frame(&environment).player(), frame(&environment).is_opening()),
            (Some(1), true)
        );
    }

    #[test]
    fn a_player_that_concedes_loses() {
        let (mut environment, config) = against(Rules::Snooker, "level-2");
        agent_plays(&mut environment, &config, &WEAK_BREAK);
        let (mut worker, mut step) = (Worker::new(&config), StepResult::default());
        let conceded =
            environment.take(&config, &mut worker.simulator, Some(Answer::Concede), &mut step);
        assert_eq!(environment.episode.ending(), Some(Ending::Won(0)));
        let reward = environment.reward(&config, 1, &conceded.expect("a concession"));
        assert_eq!((reward, step.truncated), (-config.rewards.win, false));
    }

    #[test]
    fn an_answer_that_is_not_possible_truncates_the_episode() {
        for answer in [None, Some(Answer::Choice(Choice::Replace))] {
            let (mut environment, config) = against(Rules::EightBall, "carom:30");
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let (mut worker, mut step) = (Worker::new(&config), StepResult::default());
            let result = environment.take(&config, &mut worker.simulator, answer, &mut step);
            assert!(result.is_none() && step.truncated, "{answer:?}");
            assert_eq!(step.reward, config.rewards.failure);
        }
    }

    #[test]
    fn a_level_strikes_with_its_own_noise_and_other_players_with_that_of_the_environment() {
        for (name, is_own) in [("level-1", true), ("carom", false), ("potter", false)] {
            let (mut environment, config) = against(Rules::NineBall, name);
            let turn = *environment.episode.turn().expect("a break");
            let agent = strike(&config, &*environment.episode, &turn, &WEAK_BREAK, (1, 2));
            let agent = agent.expect("a place");
            assert_eq!(agent.actual, agent.intended, "{name}");
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let play = Play::new(agent.intended);
            if environment.episode.turn().is_none() {
                environment.episode.choose(Some(Choice::PlayOn)).expect("a choice");
            }
            let struck = strike_of_play(&config, &*environment.episode, &play, (1, 2));
            let struck = struck.expect("a shot");
            assert_eq!(struck.intended, play.strike, "{name}");
            assert_eq!(struck.actual != struck.intended, is_own, "{name}");
        }
        let (_, config) = against(Rules::NineBall, "level-1");
        let level = BuiltInPlayer::read("level-1").expect("a level");
        assert_eq!((config.noise_of(0), Some(config.noise_of(1))), (Noise::NONE, level.noise()));
    }
}
