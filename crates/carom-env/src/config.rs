//! What an environment is asked to be.

use carom::format::Node;
use carom::{Error, Noise};
use carom_rules::{Options, Rules};

use crate::action::Aim;
use crate::opponent::Opponent;

/// What is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// One shot at balls that lie anywhere: pot one.
    Potting,
    /// A frame of a game.
    Game(Rules),
    /// Two balls, a table without pockets: exactly three cushions.
    SumToThree,
}

impl Task {
    /// Every task.
    pub const ALL: [Self; 8] = [
        Self::Potting,
        Self::Game(Rules::EightBall),
        Self::Game(Rules::NineBall),
        Self::Game(Rules::TenBall),
        Self::Game(Rules::StraightPool),
        Self::Game(Rules::Snooker),
        Self::Game(Rules::ThreeCushion),
        Self::SumToThree,
    ];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Potting => "potting",
            Self::Game(rules) => rules.name(),
            Self::SumToThree => "sum-to-three",
        }
    }

    /// The task of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "task", name)
    }

    /// Whether the cue ball can ever be in hand.
    pub const fn has_hand(self) -> bool {
        !matches!(self, Self::Potting | Self::SumToThree | Self::Game(Rules::ThreeCushion))
    }

    /// Whether fouls cost points that the player may not have.
    pub(crate) const fn has_negative_scores(self) -> bool {
        matches!(self, Self::Game(Rules::StraightPool))
    }

    /// How many object balls can lie at random at the start, least and most; none where the start is always
    /// the same. In snooker these are the reds, and the colours stand on their spots.
    const fn balls_at_random(self) -> Option<[usize; 2]> {
        match self {
            Self::Potting | Self::Game(Rules::EightBall) => Some([1, 15]),
            Self::Game(Rules::NineBall) => Some([1, 9]),
            Self::Game(Rules::TenBall) => Some([1, 10]),
            Self::Game(Rules::StraightPool) => Some([2, 15]),
            Self::Game(Rules::Snooker) => Some([0, 15]),
            Self::Game(Rules::ThreeCushion) => Some([2, 2]),
            Self::Game(Rules::Practice) | Self::SumToThree => None,
        }
    }
}

/// Which ball the potting task asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Target {
    /// Any object ball.
    #[default]
    Any,
    /// The one with the lowest number.
    Lowest,
}

impl Target {
    const ALL: [Self; 2] = [Self::Any, Self::Lowest];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Any => "any",
            Self::Lowest => "lowest",
        }
    }

    /// The target of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "target", name)
    }
}

/// When an environment whose episode has ended begins the next one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Autoreset {
    /// At once: the step that ends an episode gives the next one's first observation, and the last one's
    /// final observation besides.
    #[default]
    SameStep,
    /// In the next step, whose action is ignored and whose reward is 0.
    NextStep,
    /// When it is told to.
    Disabled,
}

impl Autoreset {
    const ALL: [Self; 3] = [Self::SameStep, Self::NextStep, Self::Disabled];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SameStep => "same-step",
            Self::NextStep => "next-step",
            Self::Disabled => "disabled",
        }
    }

    /// The mode of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "autoreset_mode", name)
    }
}

/// What a shot earns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rewards {
    /// The frame won; lost, its negative.
    pub win: f64,
    /// Each ball potted by a legal shot that was the shooter's to pot.
    pub pot: f64,
    /// A foul.
    pub foul: f64,
    /// A point more than the other player.
    pub point: f64,
    /// A shot that could not be played, or reached the cap on events.
    pub failure: f64,
}

impl Rewards {
    /// The usual ones of a task.
    pub const fn of(task: Task) -> Self {
        let none = Self { win: 0.0, pot: 0.0, foul: 0.0, point: 0.0, failure: -1.0 };
        match task {
            Task::Potting => Self { pot: 1.0, ..none },
            Task::Game(Rules::Snooker | Rules::StraightPool) => {
                Self { win: 1.0, point: 0.01, ..none }
            }
            Task::Game(Rules::ThreeCushion) | Task::SumToThree => Self { point: 1.0, ..none },
            Task::Game(_) => Self { win: 1.0, pot: 0.1, foul: -0.1, ..none },
        }
    }
}

/// What an environment is asked to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Errors of every strike, the opponent's too.
    pub noise: Noise,
    /// What the first action means.
    pub aim: Aim,
    /// The least and the largest speed of the cue, m/s.
    pub speed: [f64; 2],
    /// The largest elevation, rad.
    pub elevation: f64,
    /// Who plays player 1.
    pub opponent: Opponent,
    /// Object balls that lie at random at the start, least and most. Potting always has some (1 if none are
    /// given); a game begins with its rack if none are given, else in the middle, as
    /// [`carom_rules::Frame::scatter`] has it. In snooker these are the reds (0 to 15; the colours stand on
    /// their spots), in three-cushion both object balls.
    pub balls: Option<[usize; 2]>,
    /// Which ball the potting task asks for.
    pub target: Target,
    /// The table as a shot file has it; the task's own if none is given.
    pub table: Option<Node>,
    /// The physics as a shot file has it; the table's own if none is given.
    pub physics: Option<Node>,
    /// What is agreed on before a frame.
    pub options: Options,
    /// What a shot earns.
    pub rewards: Rewards,
    /// Steps after which an episode is truncated; no limit if none is given.
    pub max_steps: Option<u32>,
    /// When the next episode begins.
    pub autoreset: Autoreset,
    /// How many threads step; all cores if none is given.
    pub threads: Option<usize>,
}

impl Config {
    /// The usual one of a task: no noise, no opponent.
    pub fn of(task: Task) -> Self {
        let target = match task {
            Task::SumToThree => 10,
            Task::Game(Rules::StraightPool) => 100,
            _ => Options::default().target,
        };
        Self {
            noise: Noise::default(),
            aim: Aim::default(),
            speed: [0.2, 8.0],
            elevation: 0.5,
            opponent: Opponent::default(),
            balls: None,
            target: Target::default(),
            table: None,
            physics: None,
            options: Options { target, ..Options::default() },
            rewards: Rewards::of(task),
            max_steps: None,
            autoreset: Autoreset::default(),
            threads: None,
        }
    }

    pub(crate) fn check(&self, task: Task) -> Result<(), Error> {
        self.noise.check()?;
        let [slow, fast] = self.speed;
        if !(0.0 < slow && slow <= fast && fast <= FASTEST) {
            return Err(Error::input(
                "speed",
                format!("[{slow:?}, {fast:?}] m/s is out of range"),
                format!("write two speeds in (0, {FASTEST}], the lower one first"),
            ));
        }
        if !(0.0..=STEEPEST).contains(&self.elevation) {
            return Err(Error::input(
                "max_elevation",
                format!("{:?} rad is out of range", self.elevation),
                format!("write an angle in [0, {STEEPEST}]"),
            ));
        }
        if self.max_steps == Some(0) {
            return Err(Error::input("max_episode_steps", "0 is out of range", "write at least 1"));
        }
        if task == Task::Potting && self.opponent != Opponent::None {
            return Err(Error::input(
                "opponent",
                "the potting task has one shot and no opponent",
                "leave it out",
            ));
        }
        self.check_balls(task)
    }

    fn check_balls(&self, task: Task) -> Result<(), Error> {
        let Some([least, most]) = self.balls else { return Ok(()) };
        let wrong = |what: String, remedy: String| Err(Error::input("balls", what, remedy));
        let Some([fewest, all]) = task.balls_at_random() else {
            let what = format!("{} always begins in the same way", task.name());
            return wrong(what, "leave it out".into());
        };
        if least < fewest || least > most || most > all {
            return wrong(
                format!("[{least}, {most}] is out of range"),
                format!("write two numbers in [{fewest}, {all}], the lower one first"),
            );
        }
        Ok(())
    }
}

/// Cue speeds beyond this are no player's, m/s: the record is about 15.
const FASTEST: f64 = 15.0;

/// Elevations beyond this are near enough to upright that noise could carry a cue past it, rad (80°).
pub(crate) const STEEPEST: f64 = 1.396;

/// The value of that name.
pub(crate) fn named<T: Copy>(
    all: &[T],
    name_of: impl Fn(T) -> &'static str,
    place: &str,
    name: &str,
) -> Result<T, Error> {
    all.iter().copied().find(|value| name_of(*value) == name).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|value| name_of(*value)).collect();
        Error::input(
            place,
            format!("there is no \"{name}\""),
            format!("write one of {}", names.join(", ")),
        )
    })
}
