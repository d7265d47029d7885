//! What a referee says after a shot.

use crate::BallIndex;

/// Something that the rules forbid. Balls are meant as [`BallIndex`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Foul {
    /// The cue ball was pocketed.
    Scratch,
    /// The cue ball left the table.
    CueBallOffTable,
    /// The cue ball touched no ball.
    NoContact,
    /// The cue ball touched a ball first that was not on.
    WrongBallFirst,
    /// Nothing was pocketed, and nothing driven to a rail after the contact.
    NoRailAfterContact,
    /// An object ball left the table.
    BallOffTable,
    /// Behind the head string, the cue ball touched a ball there without having crossed the string.
    BehindHeadString,
    /// A break that pocketed nothing and drove too few balls to a rail.
    SoftBreak,
    /// A ball that was not on was pocketed (snooker).
    WrongBallPocketed,
    /// The cue ball jumped over a ball (snooker).
    Jump,
    /// The cue ball moved a ball that it touched at the start (snooker).
    Push,
    /// The cue ball was left behind the free ball (snooker).
    SnookeredByFreeBall,
    /// The starting shot went to a cushion before the red (three-cushion).
    IndirectStart,
}

impl Foul {
    /// What it is, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Scratch => "the cue ball was pocketed",
            Self::CueBallOffTable => "the cue ball left the table",
            Self::NoContact => "no ball was hit",
            Self::WrongBallFirst => "the wrong ball was hit first",
            Self::NoRailAfterContact => "no rail after contact",
            Self::BallOffTable => "a ball left the table",
            Self::BehindHeadString => "a ball behind the head string was hit from behind it",
            Self::SoftBreak => "too few balls were driven to a rail",
            Self::WrongBallPocketed => "a ball that was not on was pocketed",
            Self::Jump => "the cue ball jumped over a ball",
            Self::Push => "a touching ball was moved",
            Self::SnookeredByFreeBall => "the free ball was left in the way",
            Self::IndirectStart => "the starting shot went to a cushion before the red",
        }
    }
}

/// The fouls of one shot: a small set, kept without a list of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fouls(u16);

impl Fouls {
    const ALL: [Foul; 13] = [
        Foul::Scratch,
        Foul::CueBallOffTable,
        Foul::NoContact,
        Foul::WrongBallFirst,
        Foul::NoRailAfterContact,
        Foul::BallOffTable,
        Foul::BehindHeadString,
        Foul::SoftBreak,
        Foul::WrongBallPocketed,
        Foul::Jump,
        Foul::Push,
        Foul::SnookeredByFreeBall,
        Foul::IndirectStart,
    ];

    /// None.
    pub const NONE: Self = Self(0);

    /// Adds `foul` if `committed`.
    pub(crate) const fn add_if(&mut self, committed: bool, foul: Foul) {
        if committed {
            self.0 |= 1 << foul as u16;
        }
    }

    /// Whether `foul` is among them.
    pub const fn has(self, foul: Foul) -> bool {
        self.0 & (1 << foul as u16) != 0
    }

    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// They, in the order in which they are usually told.
    pub fn iter(self) -> impl Iterator<Item = Foul> {
        Self::ALL.into_iter().filter(move |foul| self.has(*foul))
    }
}

/// What came of a shot or a choice.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ruling {
    /// The fouls; none for a legal shot.
    pub fouls: Fouls,
    /// What each player's score changed by.
    pub points: [i32; 2],
    /// Balls that were put on a spot.
    pub spotted: Vec<BallIndex>,
    /// Whether the balls were racked again, all or nearly all of them.
    pub racked: bool,
}

impl Ruling {
    /// Whether the shot was legal.
    pub const fn is_legal(&self) -> bool {
        self.fouls.is_empty()
    }
}
