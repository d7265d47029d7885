//! One environment.

use std::borrow::Cow;
use std::sync::Arc;

use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot};
use carom_mind::Answer;
use carom_rules::{Fouls, FrameSimulator, Seat, StateBytes, Turn, through_degrees};

use crate::action::{self, StrikeDraw};
use crate::config::Config;
use crate::episode::{Ending, Episode, EpisodeStart, NoisyStrike, ShotResult};
use crate::frame::FrameEpisode;
use crate::modes::{Opponent, Outside};
use crate::potting::Potting;
use crate::random::{decision_seed, episode_seed};
use crate::setup::Setup;
use crate::sum_to_three::SumToThree;
use crate::task::Task;
use crate::worker::Worker;
use crate::{observe, opponent};

/// A new episode of `task` with this table and physics.
pub(crate) fn episode(
    task: Task,
    config: &Config,
    setup: &Setup,
) -> Result<Box<dyn Episode>, Error> {
    Ok(match task {
        Task::Potting => Box::new(Potting::new(config, setup)?),
        Task::Game(game) => Box::new(FrameEpisode::new(game, config, setup)?),
        Task::SumToThree => Box::new(SumToThree::new(config, setup)?),
    })
}

/// The result of a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct StepResult {
    pub(crate) reward: f64,
    pub(crate) terminated: bool,
    pub(crate) truncated: bool,
    /// Whether the agent's shot was legal.
    pub(crate) legal: bool,
    /// Balls that the agent potted.
    pub(crate) potted: u32,
    /// The fouls of the agent's shot.
    pub(crate) fouls: Fouls,
    /// The agent's strike as it was played; none if none was.
    pub(crate) strike: Option<Strike>,
    /// The winner of an episode that ended.
    pub(crate) winner: Option<Seat>,
    /// Why the episode ended; none if it goes on.
    pub(crate) why: Option<Cow<'static, str>>,
}

/// What an opponent outside this crate answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// An action, as an agent gives it.
    Action(Vec<f32>),
    /// The answer of a player to the frame's request.
    Answer(Answer),
    /// The player has lost the frame, such as by its clock: the reason in words.
    Lost(String),
}

/// One environment.
#[derive(Clone)]
pub(crate) struct Environment {
    seed: u64,
    /// Number of the episode with this seed.
    pub(crate) number: u64,
    /// Number of the starts of episodes, and of the states that were set, so far. It tells apart all
    /// episodes of this environment, and is not part of its state.
    pub(crate) starts: u64,
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
    /// The seat of the agent, if it has an opponent.
    agent: Seat,
    /// Table and physics before anything is drawn.
    setup: Arc<Setup>,
    /// The variables of this episode, in the order of the settings.
    pub(crate) drawn: Vec<f64>,
    /// The step in progress. Before the first step it has the reward of the opponent's opening.
    step: StepResult,
    /// Why the opponent has lost the episode outside the rules of its game.
    lost: Option<String>,
    /// The shots of the last step, if the settings ask for them.
    pub(crate) shots: Vec<Shot>,
}

impl Environment {
    pub(crate) fn new(episode: Box<dyn Episode>, setup: Arc<Setup>, seed: u64) -> Self {
        Self {
            seed,
            number: 0,
            starts: 0,
            episode_seed: 0,
            steps: 0,
            moves: 0,
            episode,
            ended: true,
            shooter: 0,
            agent: 0,
            setup,
            drawn: Vec::new(),
            step: StepResult::default(),
            lost: None,
            shots: Vec::new(),
        }
    }

    /// Begins the first episode of `seed`.
    pub(crate) fn seed(
        &mut self,
        config: &Config,
        seed: u64,
        start: Option<&EpisodeStart>,
    ) -> Result<(), Error> {
        (self.seed, self.number) = (seed, 0);
        self.begin(config, start)
    }

    /// Begins the next episode.
    pub(crate) fn next_episode(
        &mut self,
        config: &Config,
        start: Option<&EpisodeStart>,
    ) -> Result<(), Error> {
        self.number += 1;
        self.begin(config, start)
    }

    fn begin(&mut self, config: &Config, start: Option<&EpisodeStart>) -> Result<(), Error> {
        self.episode_seed = episode_seed(self.seed, self.number);
        (self.steps, self.moves) = (0, 0);
        self.starts += 1;
        self.step = StepResult::default();
        self.lost = None;
        self.shots.clear();
        self.ended = true;
        self.agent = config.seat.of(self.episode_seed, self.number);
        self.draw(config)?;
        self.set_chooser(config);
        self.episode.restart(self.episode_seed)?;
        if let Some(start) = start {
            self.episode.start_at(start, config)?;
        }
        self.shooter = self.episode.turn().map_or(0, |turn| turn.player);
        self.ended = false;
        Ok(())
    }

    /// Draws the variables of this episode, if the settings have any, and changes table and physics.
    fn draw(&mut self, config: &Config) -> Result<(), Error> {
        if config.randomize.is_empty() {
            return Ok(());
        }
        let Self { episode, setup, .. } = self;
        let accepts = |setup: &Setup| episode.set_up(setup, config);
        self.drawn = setup.draw(&config.randomize, self.episode_seed, accepts)?;
        Ok(())
    }

    fn set_chooser(&mut self, config: &Config) {
        self.episode.set_chooser(config.opponent.answers_choices().then_some(1 - self.agent));
    }

    /// Other errors of strikes and other racks from here on.
    pub(crate) fn reseed(&mut self, seed: u64) {
        self.episode_seed = episode_seed(seed, 0);
        self.episode.reseed(self.episode_seed);
    }

    /// The next shot; none after the end of the episode.
    pub(crate) fn next(&self) -> Option<&Turn> {
        self.episode.turn().filter(|_| !self.ended)
    }

    /// The seat from which the agent observes.
    pub(crate) fn viewer(&self, config: &Config) -> Seat {
        match &config.opponent {
            Opponent::None => self.episode.turn().map_or(self.shooter, |turn| turn.player),
            _ => self.agent,
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
        self.begin_step(config, worker, action);
        self.end_step(config)
    }

    /// Plays `action`, and the reply of an opponent that is not outside.
    pub(crate) fn begin_step(&mut self, config: &Config, worker: &mut Worker, action: &[f32]) {
        let reward = if self.steps == 0 { self.step.reward } else { 0.0 };
        self.step = StepResult { reward, ..StepResult::default() };
        self.shots.clear();
        let Some(turn) = self.next() else { return };
        let (episode, agent) = (&*self.episode, turn.player);
        let strike = action::strike(config, episode, turn, action, self.errors_of_agent());
        if let Some(strike) = &strike {
            self.step.strike = Some(through_degrees(&strike.actual));
        }
        if let Some(result) = self.play(config, &mut worker.simulator, strike) {
            self.step.reward += self.reward(config, agent, &result);
            self.step.legal = result.legal;
            self.step.potted = result.potted;
            self.step.fouls = result.fouls;
            self.reply(config, worker);
        }
    }

    /// Completes a step, once the opponent has replied.
    pub(crate) fn end_step(&mut self, config: &Config) -> StepResult {
        if self.ended {
            self.step.truncated = true;
            return self.step.clone();
        }
        let ending = self.episode.ending();
        match ending {
            Some(Ending::Stalemate) => self.step.truncated = true,
            Some(Ending::Won(_) | Ending::Drawn) => self.step.terminated = !self.step.truncated,
            None => {}
        }
        self.steps += 1;
        let step = &mut self.step;
        let is_last = config.max_episode_steps.is_some_and(|most| self.steps >= most);
        step.truncated |= !step.terminated && is_last;
        self.ended = step.terminated || step.truncated;
        if self.ended {
            let by_rules = || self.episode.why().unwrap_or("the limit of steps was reached").into();
            step.why = Some(self.lost.clone().map_or_else(by_rules, Cow::from));
            step.winner = match ending {
                Some(Ending::Won(winner)) => Some(winner),
                _ => None,
            };
        }
        self.step.clone()
    }

    const fn errors_of_agent(&self) -> StrikeDraw {
        StrikeDraw { seed: self.episode_seed, index: self.moves, is_agent: true }
    }

    const fn errors_of_opponent(&self) -> StrikeDraw {
        StrikeDraw { seed: self.episode_seed, index: self.moves, is_agent: false }
    }

    /// The strike of `action` as the agent intends it, if it plays now.
    pub(crate) fn intended(&self, config: &Config, action: &[f32]) -> Option<NoisyStrike> {
        action::strike(config, &*self.episode, self.next()?, action, self.errors_of_agent())
    }

    /// Whether an opponent outside this crate has to answer next.
    pub(crate) fn waits(&self, config: &Config) -> bool {
        let asked = match &config.opponent {
            Opponent::Outside(Outside::Policy) => self.episode.turn().map(|turn| turn.player),
            Opponent::Outside(Outside::Player) => {
                self.episode.frame().and_then(carom_rules::Frame::player)
            }
            _ => return false,
        };
        !self.ended && asked == Some(1 - self.agent)
    }

    /// The seed of a player's next decision.
    pub(crate) fn decision_seed(&self) -> u64 {
        decision_seed(self.episode_seed, self.moves)
    }

    /// The seat that an opponent has.
    pub(crate) const fn opponent(&self) -> Seat {
        1 - self.agent
    }

    /// Plays one answer of an opponent outside.
    pub(crate) fn answer(&mut self, config: &Config, worker: &mut Worker, reply: &Reply) {
        let result = match reply {
            Reply::Action(action) => {
                let Some(turn) = self.next() else { return };
                let draw = self.errors_of_opponent();
                let strike = action::strike(config, &*self.episode, turn, action, draw);
                self.play(config, &mut worker.simulator, strike)
            }
            Reply::Answer(answer) => self.take(config, &mut worker.simulator, Some(*answer)),
            Reply::Lost(why) => {
                self.lost = Some(why.clone());
                self.take(config, &mut worker.simulator, Some(Answer::Concede))
            }
        };
        self.charge(config, result);
    }

    /// Subtracts what the opponent earned with its move. Whether it made one.
    fn charge(&mut self, config: &Config, result: Option<ShotResult>) -> bool {
        if let Some(result) = &result {
            self.step.reward -= self.reward(config, self.opponent(), result);
        }
        result.is_some()
    }

    /// The opponent shoots until it is the agent's turn, or the frame is over. An opponent outside is
    /// left to the caller.
    pub(crate) fn reply(&mut self, config: &Config, worker: &mut Worker) {
        loop {
            let result = match &config.opponent {
                Opponent::None | Opponent::Outside(_) => return,
                Opponent::Random | Opponent::Potter => {
                    let turn = self.episode.turn().filter(|turn| turn.player != self.agent);
                    let Some(turn) = turn else { return };
                    let draw = self.errors_of_opponent();
                    let strike = opponent::strike(config, &*self.episode, turn, draw);
                    self.play(config, &mut worker.simulator, strike)
                }
                Opponent::Player(_) => {
                    let frame = self.episode.frame();
                    let asked = frame.filter(|frame| frame.player() == Some(self.opponent()));
                    let Some(frame) = asked else { return };
                    let answer = worker.decide(config, frame, self.agent, self.decision_seed());
                    self.take(config, &mut worker.simulator, answer)
                }
            };
            if !self.charge(config, result) {
                return;
            }
        }
    }

    /// Takes the answer of a player. A missing answer truncates the episode, and so does one that is not
    /// possible.
    fn take(
        &mut self,
        config: &Config,
        simulator: &mut FrameSimulator,
        answer: Option<Answer>,
    ) -> Option<ShotResult> {
        let choice = match answer {
            Some(Answer::Play(play)) => {
                let draw = self.errors_of_opponent();
                let strike = opponent::strike_of_play(config, &*self.episode, &play, draw);
                return self.play(config, simulator, strike);
            }
            Some(Answer::Choice(choice)) => Some(choice),
            Some(Answer::Concede) => None,
            None => return self.play(config, simulator, None),
        };
        self.moves += 1;
        let result = self.episode.choose(choice).ok();
        self.fail_without(result, config)
    }

    /// Plays a strike. One that cannot be played truncates the episode.
    fn play(
        &mut self,
        config: &Config,
        simulator: &mut FrameSimulator,
        strike: Option<NoisyStrike>,
    ) -> Option<ShotResult> {
        self.shooter = self.episode.turn().map_or(self.shooter, |turn| turn.player);
        self.moves += 1;
        let shots = config.traces.then_some(&mut self.shots);
        let result = strike.and_then(|strike| self.episode.play(simulator, &strike, shots).ok());
        self.fail_without(result, config)
    }

    /// `result`; without one the step is a failure.
    fn fail_without(&mut self, result: Option<ShotResult>, config: &Config) -> Option<ShotResult> {
        if result.is_none() {
            self.step.truncated = true;
            self.step.reward += config.rewards.failure;
        }
        result
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

    /// Appends the state between two steps.
    pub(crate) fn write_to(&self, out: &mut Vec<u8>) {
        let Self { seed, number, episode_seed, steps, moves, ended, shooter, agent, .. } = self;
        [*seed, *number, *episode_seed, *moves].write_to(out);
        steps.write_to(out);
        ended.write_to(out);
        shooter.write_to(out);
        agent.write_to(out);
        self.step.reward.write_to(out);
        let lost = self.lost.as_deref().unwrap_or_default();
        (lost.len() as u64).write_to(out);
        out.extend(lost.as_bytes());
        self.episode.write_to(out);
    }

    /// Replaces the state by that which `bytes` begin with. After `None` the state is undefined.
    pub(crate) fn read_from(&mut self, config: &Config, bytes: &mut &[u8]) -> Option<()> {
        [self.seed, self.number, self.episode_seed, self.moves] = StateBytes::read_from(bytes)?;
        self.steps = StateBytes::read_from(bytes)?;
        self.ended = StateBytes::read_from(bytes)?;
        self.shooter = StateBytes::read_from(bytes)?;
        self.agent = StateBytes::read_from(bytes)?;
        self.step = StepResult { reward: StateBytes::read_from(bytes)?, ..StepResult::default() };
        let length = usize::try_from(u64::read_from(bytes)?).ok()?;
        let (lost, rest) = bytes.split_at_checked(length)?;
        let lost = str::from_utf8(lost).ok()?;
        (self.lost, *bytes) = ((length > 0).then(|| lost.into()), rest);
        self.starts += 1;
        self.shots.clear();
        // Branches have other seeds, but the table of their episode.
        let seed = std::mem::replace(&mut self.episode_seed, episode_seed(self.seed, self.number));
        self.draw(config).ok()?;
        self.episode_seed = seed;
        self.set_chooser(config);
        self.episode.read_from(bytes)?;
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use carom::batch::draw_strikes;
    use carom::noise::{OFFSET_KEPT, SLOWEST, STEEPEST};
    use carom::{Noise, Simulator};
    use carom_arena::BuiltInPlayer;
    use carom_mind::{Answer, Budget, Situation};
    use carom_rules::{Choice, Frame, Game, Play, Request};

    use super::{Environment, episode};
    use crate::action::{StrikeDraw, strike};
    use crate::config::Config;
    use crate::episode::{Ending, Episode};
    use crate::modes::Opponent;
    use crate::opponent::strike_of_play;
    use crate::random::{decision_seed, episode_seed};
    use crate::setup::Setup;
    use crate::task::Task;
    use crate::worker::Worker;

    /// An action at the limits of all numbers: the slowest strike, far off centre, with a steep cue.
    const FAR_OUT: [f32; 7] = [0.3, -1.0, 0.8, -0.6, 1.0, 0.1, 0.2];

    #[test]
    fn an_action_is_struck_as_the_engine_draws_it_beyond_each_limit_too() {
        let task = Task::Game(Game::NineBall);
        let noise = Noise { elevation: 0.3, ..Noise::preset("beginner").expect("a preset") };
        let config = Config {
            noise: noise.clone(),
            speed: [0.1, 8.0],
            max_elevation: 1.3,
            ..Config::of(task)
        };
        let mut episode: Box<dyn Episode> =
            episode(task, &config, &Setup::default()).expect("a task");
        episode.restart(4).expect("a rack");
        let frame = carom_rules::Frame::new(Game::NineBall, config.options, None, None, 4);
        let frame = frame.expect("the same rack");
        let turn = episode.turn().expect("a shot");
        let mut simulator = Simulator::new();
        let [mut slow, mut steep, mut far] = [0; 3];
        for index in 0..200 {
            let struck =
                strike(&config, &*episode, turn, &FAR_OUT, agent(9, index)).expect("a place");
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

    const fn agent(seed: u64, index: u64) -> StrikeDraw {
        StrikeDraw { seed, index, is_agent: true }
    }

    /// The first episode of a game against `opponent`, and its settings without noise for the agent.
    fn against(game: Game, opponent: &str) -> (Environment, Config) {
        let task = Task::Game(game);
        let opponent = Opponent::read(opponent).expect("an opponent");
        let config = Config { opponent, ..Config::of(task) };
        let setup = Setup::default();
        let episode = episode(task, &config, &setup).expect("a task");
        let mut environment = Environment::new(episode, setup.into(), SEED);
        environment.seed(&config, SEED, None).expect("a rack");
        (environment, config)
    }

    fn frame(environment: &Environment) -> Frame {
        environment.episode.frame().expect("a game").clone()
    }

    /// The agent's strike of `action`, without the reply.
    fn agent_plays(environment: &mut Environment, config: &Config, action: &[f32]) {
        let turn = *environment.episode.turn().expect("a shot");
        let strike = strike(config, &*environment.episode, &turn, action, agent(0, 0));
        let mut worker = Worker::new(config);
        environment.play(config, &mut worker.simulator, strike).expect("it is played");
    }

    /// A break too weak to be legal: the other player chooses.
    const WEAK_BREAK: [f32; 7] = [0.5, -0.4, 0.0, 0.0, 0.0, 0.0, 0.0];

    #[test]
    fn a_reply_is_what_the_player_decides_about_the_frame() {
        for (game, name) in [
            (Game::EightBall, "carom:30"),
            (Game::NineBall, "greedy:30"),
            (Game::Snooker, "carom:30"),
        ] {
            let (mut environment, config) = against(game, name);
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
            let (mut environment, config) = against(Game::EightBall, name);
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let frame = frame(&environment);
            let asks = matches!(frame.request(), Request::Choice { player: 1, .. });
            assert_eq!((asks, frame.player()), (is_asked, Some(1)), "{name}");
        }
        let (mut environment, config) = against(Game::EightBall, "carom:30");
        agent_plays(&mut environment, &config, &WEAK_BREAK);
        let mut worker = Worker::new(&config);
        let answer = Some(Answer::Choice(Choice::Rebreak));
        let result = environment.take(&config, &mut worker.simulator, answer);
        assert!(result.expect("a choice").legal);
        assert_eq!(
            (frame(&environment).player(), frame(&environment).is_opening()),
            (Some(1), true)
        );
    }

    #[test]
    fn a_player_that_concedes_loses() {
        let (mut environment, config) = against(Game::Snooker, "level-2");
        agent_plays(&mut environment, &config, &WEAK_BREAK);
        let mut worker = Worker::new(&config);
        let conceded = environment.take(&config, &mut worker.simulator, Some(Answer::Concede));
        assert_eq!(environment.episode.ending(), Some(Ending::Won(0)));
        let reward = environment.reward(&config, 1, &conceded.expect("a concession"));
        assert_eq!((reward, environment.step.truncated), (-config.rewards.win, false));
    }

    #[test]
    fn an_answer_that_is_not_possible_truncates_the_episode() {
        for answer in [None, Some(Answer::Choice(Choice::Replace))] {
            let (mut environment, config) = against(Game::EightBall, "carom:30");
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let mut worker = Worker::new(&config);
            let result = environment.take(&config, &mut worker.simulator, answer);
            assert!(result.is_none() && environment.step.truncated, "{answer:?}");
            assert_eq!(environment.step.reward, config.rewards.failure);
        }
    }

    #[test]
    fn a_level_strikes_with_its_own_noise_and_other_players_with_that_of_the_environment() {
        for (name, is_own) in [("level-1", true), ("carom", false), ("potter", false)] {
            let (mut environment, config) = against(Game::NineBall, name);
            let turn = *environment.episode.turn().expect("a break");
            let agent = strike(&config, &*environment.episode, &turn, &WEAK_BREAK, agent(1, 2));
            let agent = agent.expect("a place");
            assert_eq!(agent.actual, agent.intended, "{name}");
            agent_plays(&mut environment, &config, &WEAK_BREAK);
            let play = Play::new(agent.intended);
            let other = StrikeDraw { seed: 1, index: 2, is_agent: false };
            if environment.episode.turn().is_none() {
                environment.episode.choose(Some(Choice::PlayOn)).expect("a choice");
            }
            let struck = strike_of_play(&config, &*environment.episode, &play, other);
            let struck = struck.expect("a shot");
            assert_eq!(struck.intended, play.strike, "{name}");
            assert_eq!(struck.actual != struck.intended, is_own, "{name}");
        }
        let (_, config) = against(Game::NineBall, "level-1");
        let level = BuiltInPlayer::read("level-1").expect("a level");
        assert_eq!(
            (config.noise_of(true), Some(config.noise_of(false))),
            (Noise::NONE, level.noise())
        );
    }
}
