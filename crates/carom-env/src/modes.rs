//! The options of an environment that have names.

use carom::{Error, ErrorKind};
use carom_arena::BuiltInPlayer;
use carom_mind::Budget;

use carom_rules::Seat;

use crate::names::named;
use crate::random::Dice;

/// The meaning of the first number of an action.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aim {
    /// The azimuth of the cue: −1 to 1 is −π to π; 0 is along the table's width.
    #[default]
    Absolute,
    /// Where the target ball is hit: from its right edge (−1) through its centre (0) to its left
    /// edge (1). The target ball is the nearest ball on; the nearest object ball where the rules
    /// name none.
    Relative,
}

impl Aim {
    const ALL: [Self; 2] = [Self::Absolute, Self::Relative];

    /// The name of the mode.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Absolute => "absolute",
            Self::Relative => "relative",
        }
    }

    /// The mode called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "aim", name)
    }
}

/// Simulated shots for each decision of a player whose name has no number of them and who is not a
/// level of strength. A step then takes some milliseconds of one core.
pub const OPPONENT_SIMULATIONS: u32 = 200;

/// The seat of an agent that has an opponent. Seat 0 begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AgentSeat {
    /// The agent begins.
    #[default]
    First,
    /// The opponent begins.
    Second,
    /// Drawn for every episode, with equal probabilities.
    Random,
    /// The agent begins the episodes with an even number: the first of a seed, the third, ...
    Alternate,
}

impl AgentSeat {
    const ALL: [Self; 4] = [Self::First, Self::Second, Self::Random, Self::Alternate];

    /// The name of the mode.
    pub const fn name(self) -> &'static str {
        match self {
            Self::First => "0",
            Self::Second => "1",
            Self::Random => "random",
            Self::Alternate => "alternate",
        }
    }

    /// The mode called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "seat", name)
    }

    /// The agent's seat in episode `number` of its seed.
    pub(crate) fn of(self, episode_seed: u64, number: u64) -> Seat {
        match self {
            Self::First => 0,
            Self::Second => 1,
            Self::Random => Dice::of_seat(episode_seed).below(2),
            Self::Alternate => (number % 2) as Seat,
        }
    }
}

/// Who answers for an opponent outside this crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// A policy: actions for observations. Calls and choices are made for it, as for the agent.
    Policy,
    /// A player: it answers everything that its seat is asked.
    Player,
}

/// The player of the other seat.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Opponent {
    /// The agent itself: it shoots for both seats, observes the table as the shooter, and is
    /// rewarded for the shooter's result.
    #[default]
    None,
    /// Random actions.
    Random,
    /// A player who aims by the ghost ball at the easiest pot, with the same noise as the agent.
    Potter,
    /// A built-in player, in the games with a referee. It answers everything that its seat is asked:
    /// shots with their calls, and choices; and it may concede. A level of strength has its own noise,
    /// the others have the same noise as the agent.
    Player(BuiltInPlayer),
    /// The caller answers for it: [`crate::VectorEnv::step_against`].
    Outside(Outside),
}

impl Opponent {
    const SIMPLE: [Self; 3] = [Self::None, Self::Random, Self::Potter];

    /// The names of all opponents. Settings and a number of simulated shots may follow the name of a
    /// built-in player.
    pub fn names() -> impl Iterator<Item = &'static str> {
        Self::SIMPLE.iter().map(Self::stem).chain(BuiltInPlayer::names())
    }

    /// The opponent's name, with the settings and the number of a built-in player.
    pub fn name(&self) -> String {
        match self {
            Self::Player(player) => player.text(),
            Self::Outside(Outside::Policy) => "a policy of your own".into(),
            Self::Outside(Outside::Player) => "a player of your own".into(),
            simple => simple.stem().into(),
        }
    }

    fn stem(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Random => "random",
            Self::Potter => "potter",
            Self::Player(player) => player.name(),
            Self::Outside(_) => "",
        }
    }

    /// Whether it answers choices itself.
    pub(crate) const fn answers_choices(&self) -> bool {
        matches!(self, Self::Player(_) | Self::Outside(Outside::Player))
    }

    /// The opponent called `name`: `none`, `random`, `potter`, or a built-in player as
    /// [`BuiltInPlayer::read`] reads it, such as `level-2` or `carom:500`.
    ///
    /// # Errors
    /// [`Error::Input`] at `opponent` if there is none, and for a number of simulated shots that is
    /// not possible; at `opponent.KEY` for a setting that is not possible.
    pub fn read(name: &str) -> Result<Self, Error> {
        if let Some(simple) = Self::SIMPLE.into_iter().find(|simple| simple.stem() == name) {
            return Ok(simple);
        }
        let stem = name.split(['[', ':']).next().unwrap_or_default();
        if !BuiltInPlayer::names().any(|known| known == stem) {
            let names: Vec<&str> = Self::names().collect();
            let remedy = format!(
                "write one of {}; a number of simulated shots may follow a player, as in carom:200",
                names.join(", ")
            );
            return Err(ErrorKind::UnknownName
                .at("opponent", format!("there is no \"{name}\""), remedy)
                .with("name", name));
        }
        let player = BuiltInPlayer::read(name).map_err(at_opponent)?;
        let budget = Budget::simulations(simulations_of(&player));
        player.check_budget(&budget).map_err(at_opponent)?;
        Ok(Self::Player(player))
    }
}

/// The simulated shots for each decision of `player`.
pub(crate) fn simulations_of(player: &BuiltInPlayer) -> u64 {
    player.simulations().unwrap_or(OPPONENT_SIMULATIONS).into()
}

/// An error at the place of a player (`player`, `player.KEY`, `simulations`), as one at the opponent.
fn at_opponent(error: Error) -> Error {
    match error {
        Error::Input(ref fault) => {
            let key = fault.place.strip_prefix("player").unwrap_or_default();
            let place = format!("opponent{key}");
            error.at(place)
        }
        other => other,
    }
}

/// Which ball must be potted in the potting task.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TargetBall {
    /// Any object ball.
    #[default]
    Any,
    /// The ball with the lowest number.
    Lowest,
}

impl TargetBall {
    const ALL: [Self; 2] = [Self::Any, Self::Lowest];

    /// The name of the mode.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Any => "any",
            Self::Lowest => "lowest",
        }
    }

    /// The mode called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "target_ball", name)
    }
}

/// When an environment whose episode has ended begins the next one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Autoreset {
    /// In the same step: the step that ends an episode returns the first observation of the next
    /// one, and also the final observation of the old one.
    #[default]
    SameStep,
    /// In the next step, which ignores its action and has reward 0.
    NextStep,
    /// Only when it is reset.
    Disabled,
}

impl Autoreset {
    const ALL: [Self; 3] = [Self::SameStep, Self::NextStep, Self::Disabled];

    /// The name of the mode.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SameStep => "same-step",
            Self::NextStep => "next-step",
            Self::Disabled => "disabled",
        }
    }

    /// The mode called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "autoreset_mode", name)
    }
}
