//! What is asked next, and of whom.

use carom::rack::snooker_spots;
use carom::{Error, Table};

use crate::layout::{distance, head_string};
use crate::{BallIndex, Player};

/// What the frame asks next.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// A shot.
    Shot(Turn),
    /// A decision.
    Choice {
        /// Who decides.
        player: Player,
        /// Among these.
        choices: Vec<Choice>,
        /// Why, in words.
        why: &'static str,
    },
    /// Nothing: the frame is over.
    Over {
        /// Who won; none where it ends undecided.
        winner: Option<Player>,
        /// Why, in words.
        why: &'static str,
    },
}

impl Request {
    pub(crate) fn choice(player: Player, choices: &[Choice], why: &'static str) -> Self {
        Self::Choice { player, choices: choices.to_vec(), why }
    }

    pub(crate) const fn won(winner: Player, why: &'static str) -> Self {
        Self::Over { winner: Some(winner), why }
    }
}

/// The shot that is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    /// Who shoots.
    pub player: Player,
    /// The cue ball.
    pub cue: BallIndex,
    /// Where the cue ball may be put first, if it is in hand; else it is played from where it lies.
    pub hand: Option<Region>,
    /// The balls of which one must be hit first; empty where any may be, or none need be.
    pub on: Vec<BallIndex>,
    /// What may or must be announced.
    pub calls: Calls,
}

/// What may or must be announced before a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Calls {
    /// A ball and its pocket may be called.
    pub pocket: bool,
    /// A safety may be called.
    pub safety: bool,
    /// One of the two must be.
    pub required: bool,
    /// A push-out may be announced.
    pub push_out: bool,
    /// One of the balls on must be nominated (snooker).
    pub nominate: bool,
}

impl Calls {
    /// Nothing is announced.
    pub(crate) const NONE: Self =
        Self { pocket: false, safety: false, required: false, push_out: false, nominate: false };

    /// A ball and its pocket are called, or a safety.
    pub(crate) const REQUIRED: Self =
        Self { pocket: true, safety: true, required: true, ..Self::NONE };
}

/// Where a cue ball in hand may be put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Anywhere on the table.
    Anywhere,
    /// Behind the head string: its centre nearer to the head rail than the string.
    BehindHeadString,
    /// In the D, or on its lines.
    TheD,
}

impl Region {
    /// Whether a centre at `place` (m, in the file's frame) is in the region.
    pub fn holds(self, table: &Table, place: [f64; 2]) -> bool {
        match self {
            Self::Anywhere => true,
            Self::BehindHeadString => place[1] < head_string(table),
            Self::TheD => {
                let (center, radius) = the_d(table);
                place[1] <= center[1] && distance(place, center) <= radius
            }
        }
    }

    /// Its bounding box: least and largest corner, in the file's frame, m.
    pub fn bounds(self, table: &Table) -> [[f64; 2]; 2] {
        let size = table.size;
        match self {
            Self::Anywhere => [[0.0, 0.0], [size.x, size.y]],
            Self::BehindHeadString => [[0.0, 0.0], [size.x, head_string(table)]],
            Self::TheD => {
                let ([middle, line], radius) = the_d(table);
                [[middle - radius, line - radius], [middle + radius, line]]
            }
        }
    }

    /// Its name in files and in Python.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Anywhere => "anywhere",
            Self::BehindHeadString => "behind-head-string",
            Self::TheD => "the-d",
        }
    }

    /// Where it is, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Anywhere => "on the table",
            Self::BehindHeadString => "behind the head string",
            Self::TheD => "in the D",
        }
    }
}

/// The D: its middle on the baulk line, where the brown stands (file's frame, m), and its radius, m; from the brown
/// to the yellow, where the table has none marked.
pub(crate) fn the_d(table: &Table) -> ([f64; 2], f64) {
    let [[yellow, _], _, brown, ..] = snooker_spots(table);
    let marked = table.description.as_ref().and_then(|d| d.markings.d_radius);
    (brown, marked.unwrap_or(yellow - brown[0]))
}

/// A decision that a player can be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Choice {
    /// Shoot, with the balls as they lie.
    PlayOn,
    /// Shoot, with the cue ball in hand behind the head string.
    PlayFromHand,
    /// Let the other player shoot, with the balls as they lie.
    PassBack,
    /// Rack the balls again, and break.
    Rebreak,
    /// Rack the balls again, and let the other player break.
    RebreakByOther,
    /// Spot the eight, and shoot.
    SpotEight,
    /// Put the balls back, and let the other player shoot again (snooker: a miss).
    Replace,
    /// Spot the balls that touch the cue ball, and shoot (three-cushion).
    SpotFrozen,
    /// Spot the legal ball nearest to the head string, and shoot from behind it (pool).
    SpotNearest,
}

impl Choice {
    /// Every choice.
    pub const ALL: [Self; 9] = [
        Self::PlayOn,
        Self::PlayFromHand,
        Self::PassBack,
        Self::Rebreak,
        Self::RebreakByOther,
        Self::SpotEight,
        Self::Replace,
        Self::SpotFrozen,
        Self::SpotNearest,
    ];

    /// Its name in files and in Python.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PlayOn => "play-on",
            Self::PlayFromHand => "play-from-hand",
            Self::PassBack => "pass-back",
            Self::Rebreak => "rebreak",
            Self::RebreakByOther => "rebreak-by-other",
            Self::SpotEight => "spot-eight",
            Self::Replace => "replace",
            Self::SpotFrozen => "spot-frozen",
            Self::SpotNearest => "spot-nearest",
        }
    }

    /// The choice of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|choice| choice.name() == name)
    }

    /// The choice of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        let names = Self::ALL.map(Self::name).join(", ");
        Self::named(name).ok_or_else(|| {
            Error::input(
                "choice",
                format!("\"{name}\" is no choice"),
                format!("write one of {names}"),
            )
        })
    }
}
