//! The games, with what the engine needs of each: its table, its rack and its opening shot. The crate `carom-rules`
//! has its rules and further facts.

use alloc::format;

use crate::error::{Error, ErrorKind};

/// What the engine needs of a game.
pub(super) struct Equipment {
    /// The name on the command line, in files, and in Python and JavaScript.
    name: &'static str,
    /// The table preset that the game is played on.
    table: &'static str,
    pub(super) pattern: Pattern,
    /// The game whose opening shots are used, if it has none of its own.
    opened_as: Option<Game>,
    /// The cue's speed in a usual opening shot, m/s.
    break_speed: f64,
    /// The ball that the opening shot aims at, by its number in the rack (the cue ball is 0), and the aim's offset to
    /// the right of its centre, in ball radii.
    pub(super) break_aim: (usize, f64),
}

/// The pattern of a rack.
pub(super) enum Pattern {
    /// Rows of numbered balls behind the foot spot.
    Numbers(&'static [usize], Order),
    /// Rows of reds behind the pink, and the colours on their spots.
    Reds(&'static [usize]),
    /// The two cue balls of a carom table and the red.
    Carom,
    /// The two cue balls, a red between them and one at the other end.
    TwoReds,
}

/// The order of numbered balls.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    Any,
    /// The 1 at the apex and the highest ball in the middle (WPA, sections 2 and 9).
    OneAndLast,
    /// The 8 in the middle, a solid in one back corner and a stripe in the other (WPA, section 3).
    Eight,
}

/// Six balls.
const SIX: &[usize] = &[1, 2, 3];

/// Fifteen balls.
const TRIANGLE: &[usize] = &[1, 2, 3, 4, 5];

/// In full breaks the cue ball has 24 mph (Onoda, in Dr. Dave's FAQ), and the cue is 1.35 times slower.
const FULL_BREAK: f64 = 8.0;

const EIGHT_BALL: Equipment = Equipment {
    name: "eight-ball",
    table: "wpa-9ft",
    pattern: Pattern::Numbers(TRIANGLE, Order::Eight),
    opened_as: None,
    break_speed: FULL_BREAK,
    break_aim: (1, 0.0),
};

const SNOOKER: Equipment = Equipment {
    name: "snooker",
    table: "snooker-12ft",
    pattern: Pattern::Reds(TRIANGLE),
    break_speed: 3.5,
    break_aim: (15, 1.3),
    ..EIGHT_BALL
};

const THREE_CUSHION: Equipment = Equipment {
    name: "three-cushion",
    table: "carom-10ft",
    pattern: Pattern::Carom,
    opened_as: None,
    break_speed: 3.0,
    // The red, half full.
    break_aim: (2, 1.0),
};

/// Makes the enum of the games, their list, and the equipment of each.
macro_rules! games {
    ($($(#[$doc:meta])+ $game:ident = $equipment:expr;)+) => {
        /// The games.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Game {
            $($(#[$doc])+ $game,)+
        }

        impl Game {
            /// Every game.
            pub const ALL: [Self; [$(Self::$game),+].len()] = [$(Self::$game),+];

            pub(super) const fn equipment(self) -> &'static Equipment {
                match self {
                    $(Self::$game => const { &$equipment },)+
                }
            }
        }
    };
}

// The speeds of safeties and plain shots are estimated.
games! {
    /// Eight-ball (WPA, section 3): fifteen balls, the 8 in the middle, a solid and a stripe in the corners.
    EightBall = EIGHT_BALL;
    /// Nine-ball (WPA, section 2): nine balls in a diamond, the 1 at the apex, the 9 in the middle.
    NineBall = Equipment {
        name: "nine-ball",
        pattern: Pattern::Numbers(&[1, 2, 3, 2, 1], Order::OneAndLast),
        ..EIGHT_BALL
    };
    /// Ten-ball (WPA, section 9): ten balls, the 1 at the apex, the 10 in the middle.
    TenBall = Equipment {
        name: "ten-ball",
        pattern: Pattern::Numbers(&[1, 2, 3, 4], Order::OneAndLast),
        ..EIGHT_BALL
    };
    /// 14.1 continuous pool (WPA, section 4): fifteen balls in any order.
    StraightPool = Equipment {
        name: "straight-pool",
        pattern: Pattern::Numbers(TRIANGLE, Order::Any),
        break_speed: 2.5,
        // The right back corner, thin: out and back to the head rail.
        break_aim: (15, 1.3),
        ..EIGHT_BALL
    };
    /// Snooker (WPBSA, section 3): fifteen reds behind the pink, and the colours on their spots.
    Snooker = SNOOKER;
    /// Three-cushion carom (UMB): three balls.
    ThreeCushion = THREE_CUSHION;
    /// A rack of eight-ball without fouls.
    Practice = Equipment { name: "practice", opened_as: Some(Game::EightBall), ..EIGHT_BALL };
    /// Straight rail, the free game of carom (UMB): the balls of three-cushion, which has the same opening shot.
    StraightRail = Equipment {
        name: "straight-rail",
        opened_as: Some(Game::ThreeCushion),
        ..THREE_CUSHION
    };
    /// Korean four-ball: two cue balls, a red beside them and one at the other end.
    FourBall = Equipment {
        name: "four-ball",
        pattern: Pattern::TwoReds,
        break_speed: 2.5,
        // The red at the other end, half full.
        break_aim: (3, 1.0),
        ..THREE_CUSHION
    };
    /// Six-red snooker (WPBSA, with six reds): a triangle of three rows behind the pink.
    SixRed = Equipment {
        name: "six-red",
        pattern: Pattern::Reds(SIX),
        break_aim: (6, 1.3),
        ..SNOOKER
    };
    /// Chinese eight-ball, heyball: the rack and the break of eight-ball, on its own table.
    ChineseEightBall = Equipment {
        name: "chinese-eight-ball",
        table: "chinese-9ft",
        opened_as: Some(Game::EightBall),
        ..EIGHT_BALL
    };
}

impl Game {
    /// The name on the command line, in files, and in Python and JavaScript.
    pub const fn name(self) -> &'static str {
        self.equipment().name
    }

    /// The game called `name`, if there is one. `heyball` is the other name of `chinese-eight-ball`.
    pub fn named(name: &str) -> Option<Self> {
        let name = if name == "heyball" { "chinese-eight-ball" } else { name };
        Self::ALL.into_iter().find(|game| game.name() == name)
    }

    /// The game called `name`.
    ///
    /// # Errors
    /// [`Error::Input`] that lists the games, if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        Self::named(name).ok_or_else(|| {
            let known = Self::ALL.map(Self::name).join(", ");
            let what = format!("there is no game \"{name}\"");
            ErrorKind::UnknownName
                .at("game", what, format!("write one of {known}"))
                .with("name", name)
        })
    }

    /// The table preset that the game is played on.
    pub const fn table(self) -> &'static str {
        self.equipment().table
    }

    /// The cue's speed in a usual opening shot, m/s.
    pub const fn break_speed(self) -> f64 {
        self.equipment().break_speed
    }

    /// The game whose opening shots are known: another game for one that has none of its own.
    pub const fn opened_as(self) -> Self {
        match self.equipment().opened_as {
            Some(game) => game,
            None => self,
        }
    }
}
