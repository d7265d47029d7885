//! The options of an environment that have names.

use carom::Error;

use crate::names::named;

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

/// The player of seat 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Opponent {
    /// The agent itself: it shoots for both seats, observes the table as the shooter, and is
    /// rewarded for the shooter's result.
    #[default]
    None,
    /// Random actions.
    Random,
    /// A player who aims by the ghost ball at the easiest pot, with the same noise as the agent.
    Potter,
}

impl Opponent {
    const ALL: [Self; 3] = [Self::None, Self::Random, Self::Potter];

    /// The opponent's name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Random => "random",
            Self::Potter => "potter",
        }
    }

    /// The opponent called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "opponent", name)
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
