//! Requests of a frame: a shot or a choice, and the seat that has to answer.

use carom::{Error, ErrorKind};

use crate::layout::{BallIndex, BallList};
use crate::region::Region;
use crate::seat::Seat;
use crate::short_list::ShortList;
use crate::state_bytes::{StateBytes, state_bytes};

/// The next request of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request {
    /// A shot.
    Shot(Turn),
    /// A choice.
    Choice {
        /// The seat that chooses.
        player: Seat,
        /// The options; there are at least two.
        choices: Choices,
        /// The reason, in words.
        why: &'static str,
    },
    /// Nothing: the frame is over.
    Over {
        /// The winner; none if the frame ended undecided.
        winner: Option<Seat>,
        /// The reason, in words.
        why: &'static str,
    },
}

state_bytes!(struct Turn { player, cue, hand, on, calls });
state_bytes!(struct Calls { pocket, safety, required, push_out, nominate });
state_bytes!(
    enum Choice {
        PlayOn,
        PlayFromHand,
        PassBack,
        Rebreak,
        RebreakByOther,
        SpotEight,
        Replace,
        SpotFrozen,
        SpotNearest,
        PlayFromAnywhere,
    }
);

/// Every reason of a choice or of the end of a frame. Bytes of a state hold its position here.
const REASONS: [&str; 27] = [
    "a ball was pocketed that was not called",
    "a breaking foul",
    "a foul and a miss",
    "a foul and a miss, and a free ball",
    "a foul on the break",
    "a foul, and a free ball",
    "a foul",
    "a stalemate: there was no progress",
    "after a push-out",
    "all balls are behind the head string",
    "all balls are down",
    "the black decided",
    "the cue ball touches another ball",
    "the eight was driven off the table",
    "the eight was pocketed",
    "the eight was pocketed on the break",
    "the eight was pocketed before the group was cleared",
    "the eight was pocketed in an uncalled pocket",
    "the eight was pocketed with a foul",
    "the last ball was pocketed",
    "the scores are equal: the black is played for",
    "the target was reached",
    "the target was reached in equal innings",
    "the other player conceded",
    "three fouls in a row",
    "three misses in a row with a ball in sight",
    "too few balls were driven to a rail",
];

impl StateBytes for Request {
    fn write_to(&self, out: &mut Vec<u8>) {
        let number = |why: &str| REASONS.iter().position(|reason| *reason == why);
        let reason = |why, out: &mut Vec<u8>| {
            out.push(number(why).map_or(u8::MAX, |number| number as u8));
        };
        match self {
            Self::Shot(turn) => {
                out.push(0);
                turn.write_to(out);
            }
            Self::Choice { player, choices, why } => {
                out.push(1);
                player.write_to(out);
                choices.write_to(out);
                reason(why, out);
            }
            Self::Over { winner, why } => {
                out.push(2);
                winner.write_to(out);
                reason(why, out);
            }
        }
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        let reason = |bytes: &mut _| {
            u8::read_from(bytes).and_then(|number| REASONS.get(usize::from(number)).copied())
        };
        Some(match u8::read_from(bytes)? {
            0 => Self::Shot(StateBytes::read_from(bytes)?),
            1 => {
                let (player, choices) = (Seat::read_from(bytes)?, Choices::read_from(bytes)?);
                Self::Choice { player, choices, why: reason(bytes)? }
            }
            2 => Self::Over { winner: StateBytes::read_from(bytes)?, why: reason(bytes)? },
            _ => return None,
        })
    }
}

impl Request {
    /// Whether [`REASONS`] has its reason.
    pub(crate) fn is_known(&self) -> bool {
        match self {
            Self::Shot(_) => true,
            Self::Choice { why, .. } | Self::Over { why, .. } => REASONS.contains(why),
        }
    }

    pub(crate) fn choice(player: Seat, choices: &[Choice], why: &'static str) -> Self {
        debug_assert!(choices.len() > 1, "a single option is applied, not offered");
        Self::Choice { player, choices: choices.into(), why }
    }

    pub(crate) const fn won(winner: Seat, why: &'static str) -> Self {
        Self::Over { winner: Some(winner), why }
    }
}

/// The shot that the frame asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// The seat that shoots.
    pub player: Seat,
    /// The cue ball.
    pub cue: BallIndex,
    /// Where a cue ball in hand may be placed; none if it is played from where it lies.
    pub hand: Option<Region>,
    /// The balls on: the cue ball must hit one of them first. Empty where the rules name none.
    pub on: BallList,
    /// The calls that the player may or must make.
    pub calls: Calls,
}

/// The calls that a player may or must make before a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Calls {
    /// A ball and its pocket may be called.
    pub pocket: bool,
    /// A safety may be called.
    pub safety: bool,
    /// A ball and its pocket or a safety must be called.
    pub required: bool,
    /// A push-out may be announced.
    pub push_out: bool,
    /// One of the balls on must be nominated (snooker).
    pub nominate: bool,
}

impl Calls {
    /// The kinds of call that are allowed, by name; `nothing` where a call may be left out.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        let kinds = [
            ("nothing", !self.required && !self.nominate),
            ("pocket", self.pocket),
            ("safety", self.safety),
            ("push-out", self.push_out),
            ("on", self.nominate),
        ];
        kinds.into_iter().filter(|(_, may)| *may).map(|(name, _)| name)
    }

    /// Nothing is announced.
    pub(crate) const NONE: Self =
        Self { pocket: false, safety: false, required: false, push_out: false, nominate: false };

    /// A ball and its pocket or a safety must be called.
    pub(crate) const REQUIRED: Self =
        Self { pocket: true, safety: true, required: true, ..Self::NONE };
}

/// The options of a player, each at most once.
pub type Choices = ShortList<Choice, { Choice::ALL.len() }>;

/// An option of a player.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Choice {
    /// Shoot, with the balls as they lie.
    #[default]
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
    /// Put the balls back, and let the other player shoot again (snooker, after a miss).
    Replace,
    /// Spot the cue ball and the balls that touch it, and shoot (three-cushion).
    SpotFrozen,
    /// Spot the legal ball nearest to the head string, and shoot from behind the string (pool).
    SpotNearest,
    /// Shoot, with the cue ball in hand anywhere (six-red snooker, after the fifth miss).
    PlayFromAnywhere,
}

impl Choice {
    /// Every choice.
    pub const ALL: [Self; 10] = [
        Self::PlayOn,
        Self::PlayFromHand,
        Self::PassBack,
        Self::Rebreak,
        Self::RebreakByOther,
        Self::SpotEight,
        Self::Replace,
        Self::SpotFrozen,
        Self::SpotNearest,
        Self::PlayFromAnywhere,
    ];

    /// The choice's name in files and in Python.
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
            Self::PlayFromAnywhere => "play-from-anywhere",
        }
    }

    /// The choice in words: what follows for the player who makes it.
    pub const fn words(self) -> &'static str {
        match self {
            Self::PlayOn => "shoot with the balls as they lie",
            Self::PlayFromHand => "shoot with the cue ball in hand behind the head string",
            Self::PassBack => "let the other player shoot",
            Self::Rebreak => "have the balls racked again, and break",
            Self::RebreakByOther => "have the balls racked again, and let the other player break",
            Self::SpotEight => "have the eight spotted, and shoot",
            Self::Replace => "have the balls put back, and let the other player shoot again",
            Self::SpotFrozen => "have the balls spotted that touch the cue ball, and shoot",
            Self::SpotNearest => {
                "have the legal ball nearest to the head string spotted, and shoot from behind the \
                 head string"
            }
            Self::PlayFromAnywhere => "shoot with the cue ball in hand anywhere",
        }
    }

    /// The choice called `name`, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|choice| choice.name() == name)
    }

    /// The choice called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        let names = Self::ALL.map(Self::name).join(", ");
        Self::named(name).ok_or_else(|| {
            ErrorKind::UnknownName
                .at(
                    "choice",
                    format!("\"{name}\" is not a choice"),
                    format!("write one of {names}"),
                )
                .with("name", name)
        })
    }
}
