//! The settings of an environment.

use carom::{Error, ErrorKind, Noise};
use carom_rules::{GameFacts, Options, Scoring};

use crate::modes::{AgentSeat, Aim, Autoreset, Opponent, Outside, TargetBall};
use crate::setup::{Setup, Variable};
use crate::task::Task;

/// Largest cue speed, m/s. The fastest breaks that were measured are near 15 m/s.
const FASTEST: f64 = 15.0;

/// Largest intended elevation, rad (80°). Players do not hold a cue closer to upright.
const STEEPEST: f64 = 1.396;

/// The reward for a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rewards {
    /// For winning the frame; its negative for losing.
    pub win: f64,
    /// For each ball that a legal shot pots, if the shooter may pot it.
    pub pot: f64,
    /// For a foul.
    pub foul: f64,
    /// For each point scored; its negative for each point of the other player.
    pub point: f64,
    /// For a shot that cannot be played or reaches the limit of events.
    pub failure: f64,
}

impl Rewards {
    /// The default rewards of a task.
    pub fn of(task: Task) -> Self {
        let none = Self { win: 0.0, pot: 0.0, foul: 0.0, point: 0.0, failure: -1.0 };
        match task {
            Task::Potting => Self { pot: 1.0, ..none },
            Task::SumToThree => Self { point: 1.0, ..none },
            Task::Game(game) => match GameFacts::of(game) {
                facts if facts.is_carom() => Self { point: 1.0, ..none },
                GameFacts { scoring: Scoring::LastBall, .. } => {
                    Self { win: 1.0, pot: 0.1, foul: -0.1, ..none }
                }
                GameFacts { scoring: Scoring::Points { .. } | Scoring::Target { .. }, .. } => {
                    Self { win: 1.0, point: 0.01, ..none }
                }
            },
        }
    }

    fn check(&self) -> Result<(), Error> {
        let Self { win, pot, foul, point, failure } = *self;
        for (name, value) in
            [("win", win), ("pot", pot), ("foul", foul), ("point", point), ("failure", failure)]
        {
            if !value.is_finite() {
                return Err(ErrorKind::OutOfRange.at(
                    format!("rewards.{name}"),
                    format!("{value} is not a finite number"),
                    "write a finite number",
                ));
            }
        }
        Ok(())
    }
}

/// The settings of an environment.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Noise of every strike, the opponent's included, unless the opponent is a level of strength: it
    /// has its own.
    pub noise: Noise,
    /// The meaning of the first number of an action.
    pub aim: Aim,
    /// Smallest and largest speed of the cue, m/s.
    pub speed: [f64; 2],
    /// Largest elevation of the cue, rad.
    pub max_elevation: f64,
    /// The player of the other seat.
    pub opponent: Opponent,
    /// The agent's seat, if it has an opponent.
    pub seat: AgentSeat,
    /// Smallest and largest number of object balls that are placed at random at the start. If none:
    /// potting has one ball, and a game starts with its rack. With random balls a game continues as
    /// after [`carom_rules::Frame::resume_at`]. In snooker these are the reds (0 to 15; the colours
    /// are on their spots), in three-cushion both object balls.
    pub balls: Option<[usize; 2]>,
    /// Which ball must be potted in the potting task.
    pub target_ball: TargetBall,
    /// The tables and the physics of the environments in their order; one for all of them.
    pub setups: Vec<Setup>,
    /// Numbers of the physics and of the table that every episode draws.
    pub randomize: Vec<Variable>,
    /// The options of the game.
    pub options: Options,
    /// The reward for a shot.
    pub rewards: Rewards,
    /// Number of steps after which an episode is truncated; `None` for no limit.
    pub max_episode_steps: Option<u32>,
    /// When the next episode begins.
    pub autoreset_mode: Autoreset,
    /// Whether the shots of a step are kept, for traces ([`crate::VectorEnv::shots`]).
    pub traces: bool,
    /// Number of threads; `None` for all cores.
    pub threads: Option<usize>,
}

impl Config {
    /// The default settings of a task: no noise, no opponent.
    pub fn of(task: Task) -> Self {
        let points = match task {
            Task::SumToThree => Some(10),
            Task::Game(game) => GameFacts::of(game).usual_points(),
            Task::Potting => None,
        }
        .unwrap_or(Options::default().points);
        Self {
            noise: Noise::default(),
            aim: Aim::default(),
            speed: [0.2, 8.0],
            max_elevation: 0.5,
            opponent: Opponent::default(),
            seat: AgentSeat::default(),
            balls: None,
            target_ball: TargetBall::default(),
            setups: vec![Setup::default()],
            randomize: Vec::new(),
            options: Options { points, ..Options::default() },
            rewards: Rewards::of(task),
            max_episode_steps: None,
            autoreset_mode: Autoreset::default(),
            traces: false,
            threads: None,
        }
    }

    /// The noise of the strikes of the agent, or of its opponent.
    pub(crate) fn noise_of(&self, is_agent: bool) -> Noise {
        match &self.opponent {
            Opponent::Player(player) if !is_agent => {
                player.noise().unwrap_or_else(|| self.noise.clone())
            }
            _ => self.noise.clone(),
        }
    }

    pub(crate) fn check(&self, task: Task) -> Result<(), Error> {
        self.noise.check()?;
        self.options.check()?;
        self.rewards.check()?;
        let [slow, fast] = self.speed;
        if !(0.0 < slow && slow <= fast && fast <= FASTEST) {
            return Err(ErrorKind::OutOfRange.at(
                "speed",
                format!("[{slow:?}, {fast:?}] m/s is out of range"),
                format!("write two speeds in (0, {FASTEST}], the lower one first"),
            ));
        }
        if !(0.0..=STEEPEST).contains(&self.max_elevation) {
            return Err(ErrorKind::OutOfRange.at(
                "max_elevation",
                format!("{:?} rad is out of range", self.max_elevation),
                format!("write an angle in [0, {STEEPEST}]"),
            ));
        }
        if self.max_episode_steps == Some(0) {
            return Err(ErrorKind::OutOfRange.at(
                "max_episode_steps",
                "0 is out of range",
                "write at least 1",
            ));
        }
        if task == Task::Potting && self.opponent != Opponent::None {
            return Err(ErrorKind::Conflict.at(
                "opponent",
                "the potting task has one shot and no opponent",
                "leave it out",
            ));
        }
        if let (Task::SumToThree, Opponent::Player(player)) = (task, &self.opponent) {
            return Err(ErrorKind::Conflict.at(
                "opponent",
                format!("{} plays games with a referee, not {}", player.name(), task.name()),
                "write none, random or potter, or choose a game",
            ));
        }
        if task == Task::SumToThree && self.opponent == Opponent::Outside(Outside::Player) {
            return Err(ErrorKind::Conflict.at(
                "opponent",
                "a player with choose() plays games with a referee, not sum-to-three",
                "give a policy: a function from observations to actions",
            ));
        }
        if self.opponent == Opponent::None && self.seat != AgentSeat::First {
            return Err(ErrorKind::Conflict.at(
                "seat",
                "without an opponent the agent has both seats",
                "leave it out, or give an opponent",
            ));
        }
        self.check_balls(task)
    }

    fn check_balls(&self, task: Task) -> Result<(), Error> {
        let Some([least, most]) = self.balls else { return Ok(()) };
        let wrong =
            |kind: ErrorKind, what: String, remedy: String| Err(kind.at("balls", what, remedy));
        let Some([fewest, all]) = task.random_balls() else {
            let what = format!("{} always begins in the same way", task.name());
            return wrong(ErrorKind::Conflict, what, "leave it out".into());
        };
        if least < fewest || least > most || most > all {
            return wrong(
                ErrorKind::OutOfRange,
                format!("[{least}, {most}] is out of range"),
                format!("write two numbers in [{fewest}, {all}], the lower one first"),
            );
        }
        Ok(())
    }
}
