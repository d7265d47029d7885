//! The themes of puzzles.

use carom::{Error, ErrorKind};

/// What a puzzle is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Theme {
    /// A pot in traffic: which pocket?
    Pot,
    /// A pot with a cut of 40° or more.
    Cut,
    /// A pot after which the cue ball leaves along the tangent and stops in a circle.
    Stun,
    /// The same with a cue ball that follows.
    Follow,
    /// The same with a cue ball that draws back.
    Draw,
    /// A pot that leaves a shot at the next ball.
    Position,
    /// A pot off a cushion.
    Bank,
    /// A ball that is hit off a cushion, because another is in the way.
    Kick,
    /// A ball that another one pots.
    Combination,
    /// A ball that the cue ball pots off another one.
    Carom,
    /// A ball that is hit and then hidden.
    Safety,
    /// A pot that drives two balls apart.
    BreakOut,
    /// A point of three-cushion.
    ThreeCushion,
    /// A point of straight rail that gathers the balls.
    StraightRail,
    /// A point of four-ball.
    FourBall,
}

impl Theme {
    /// Every theme.
    pub const ALL: [Self; 15] = [
        Self::Pot,
        Self::Cut,
        Self::Stun,
        Self::Follow,
        Self::Draw,
        Self::Position,
        Self::Bank,
        Self::Kick,
        Self::Combination,
        Self::Carom,
        Self::Safety,
        Self::BreakOut,
        Self::ThreeCushion,
        Self::StraightRail,
        Self::FourBall,
    ];

    /// Its name in ids.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pot => "pot",
            Self::Cut => "cut",
            Self::Stun => "stun",
            Self::Follow => "follow",
            Self::Draw => "draw",
            Self::Position => "position",
            Self::Bank => "bank",
            Self::Kick => "kick",
            Self::Combination => "combination",
            Self::Carom => "carom",
            Self::Safety => "safety",
            Self::BreakOut => "break-out",
            Self::ThreeCushion => "three-cushion",
            Self::StraightRail => "straight-rail",
            Self::FourBall => "four-ball",
        }
    }

    /// The theme with a name.
    ///
    /// # Errors
    /// [`Error::Input`] that lists the themes.
    pub fn read(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|theme| theme.name() == name).ok_or_else(|| {
            let known = Self::ALL.map(Self::name).join(", ");
            ErrorKind::UnknownName
                .at(
                    "theme",
                    format!("there is no theme \"{name}\""),
                    format!("write one of {known}"),
                )
                .with("name", name)
        })
    }
}
