//! Fouls, and the ruling on a shot or a choice.

use crate::carom_way::CaromCount;
use crate::layout::BallList;

/// A breach of the rules in a shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Foul {
    /// The cue ball was pocketed.
    Scratch,
    /// The cue ball left the table.
    CueBallOffTable,
    /// The cue ball touched no ball.
    NoContact,
    /// The first ball that the cue ball touched was not on.
    WrongBallFirst,
    /// After the first contact no ball was pocketed or driven to a rail.
    NoRailAfterContact,
    /// An object ball left the table.
    BallOffTable,
    /// With the cue ball in hand behind the head string: a ball behind the string was hit before
    /// the cue ball had crossed it.
    BehindHeadString,
    /// A break pocketed no ball and drove too few balls to a rail.
    SoftBreak,
    /// A ball that was not on was pocketed (snooker).
    WrongBallPocketed,
    /// The cue ball jumped over a ball (snooker).
    Jump,
    /// The cue ball moved a ball that it touched before the shot (snooker, three-cushion).
    Push,
    /// The tip touched the cue ball more than once.
    DoubleHit,
    /// The tip was still on the cue ball when it hit a ball that it had not touched before.
    PushShot,
    /// The shot left the next player snookered by the free ball (snooker), or by a nominated colour (six-red).
    SnookeredByFreeBall,
    /// The cue ball touched a cushion before the red in the starting shot (games of carom).
    IndirectStart,
    /// The cue ball touched that of the opponent (four-ball).
    OpponentsBall,
}

impl Foul {
    /// The foul in words.
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
            Self::DoubleHit => "a double hit: the tip touched the cue ball more than once",
            Self::PushShot => "a push: the tip was still on the cue ball when it hit a ball",
            Self::SnookeredByFreeBall => "the nominated ball was left in the way",
            Self::IndirectStart => "the starting shot went to a cushion before the red",
            Self::OpponentsBall => "the opponent's ball was touched",
        }
    }
}

/// The fouls of one shot: a set of [`Foul`], stored as bits so that a ruling needs no allocation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fouls(u16);

impl Fouls {
    const ALL: [Foul; 16] = [
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
        Foul::DoubleHit,
        Foul::PushShot,
        Foul::SnookeredByFreeBall,
        Foul::IndirectStart,
        Foul::OpponentsBall,
    ];

    /// The empty set.
    pub const NONE: Self = Self(0);

    /// Adds `foul` if it was `committed`.
    pub(crate) const fn add_if(&mut self, committed: bool, foul: Foul) {
        if committed {
            self.0 |= 1 << foul as u16;
        }
    }

    /// Whether the set contains `foul`.
    pub const fn has(self, foul: Foul) -> bool {
        self.0 & (1 << foul as u16) != 0
    }

    /// The set as a number: a fault is a bit, in the order of [`Self::iter`].
    pub const fn bits(self) -> u16 {
        self.0
    }

    /// Every foul.
    pub const fn all() -> [Foul; 16] {
        Self::ALL
    }

    /// Whether the set is empty.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The fouls, in the order of the variants of [`Foul`].
    pub fn iter(self) -> impl Iterator<Item = Foul> {
        Self::ALL.into_iter().filter(move |foul| self.has(*foul))
    }
}

impl FromIterator<Foul> for Fouls {
    fn from_iter<I: IntoIterator<Item = Foul>>(fouls: I) -> Self {
        let mut set = Self::NONE;
        fouls.into_iter().for_each(|foul| set.add_if(true, foul));
        set
    }
}

/// The result of a shot or a choice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ruling {
    /// The fouls; empty for a legal shot.
    pub fouls: Fouls,
    /// The change of each seat's score.
    pub points: [i32; 2],
    /// Balls that were spotted.
    pub spotted: BallList,
    /// Whether the balls were racked again; in straight pool also if only fourteen of them were.
    pub racked: bool,
    /// Balls and cushions of the cue ball; none in games with pockets.
    pub carom: Option<CaromCount>,
}

impl Ruling {
    /// Whether the shot was legal.
    pub const fn is_legal(&self) -> bool {
        self.fouls.is_empty()
    }
}
