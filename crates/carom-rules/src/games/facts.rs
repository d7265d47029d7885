//! The facts of a game that others than its rules read: players, environments, matches, the page.

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use crate::layout::BallIndex;
use crate::ruling::Foul;

/// The facts of a game. Each game has one complete literal beside its rules, so that a new game answers every
/// question.
#[derive(Clone, Copy, Debug)]
pub struct GameFacts {
    /// The game.
    pub game: Game,
    /// Number of players.
    pub players: u32,
    /// Number of balls, with the cue balls.
    pub balls: usize,
    /// Whether each player has a cue ball of its own: ball 0 is that of seat 0, ball 1 that of seat 1.
    pub own_cue_balls: bool,
    /// What the players try to do with the object balls.
    pub objective: Objective,
    /// The ball that decides the game, if a single ball does.
    pub deciding_ball: Option<BallIndex>,
    /// How the winner is found.
    pub scoring: Scoring,
    /// The opening shot.
    pub opening: Opening,
    /// What a frame without progress leads to.
    pub stalemate: Stalemate,
    /// The random middle of a game, if it can begin there.
    pub random_start: Option<RandomStart>,
    /// Whether the players lag for the break.
    pub lag: bool,
    /// Whether a foul may also be a miss, after which the offender may have to play again.
    pub miss: bool,
    /// Whether players concede frames that they cannot win any more without fouls of the opponent.
    pub conceded: bool,
    /// The number in the rule book of the rule that forbids a foul; empty where the rule is implemented from general
    /// knowledge of the game.
    pub(crate) rule: fn(Foul) -> &'static str,
    /// The state at the start.
    pub(crate) state: fn() -> GameState,
}

/// What the players try to do with the object balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objective {
    /// To pot any of them.
    AnyBall,
    /// To pot any of them after a hit of the lowest.
    LowestFirst,
    /// To pot those of the player's group, then the deciding ball.
    Groups,
    /// To pot a red, then a colour, and so on.
    RedsAndColors,
    /// To hit two of them with the cue ball; there are no pockets.
    Caroms {
        /// Cushions that the cue ball must touch before it touches the second of them.
        cushions: usize,
    },
}

/// How the winner is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scoring {
    /// By the last ball.
    LastBall,
    /// By the points at the end of the frame.
    Points {
        /// The largest break without fouls.
        maximum: i32,
    },
    /// By a number of points that is agreed before the start: [`crate::Options::points`].
    Target {
        /// The usual number.
        usual: i32,
        /// Whether fouls cost points, so that scores may be negative.
        negative: bool,
        /// Whether the other player has a last inning, so that the frame may be drawn.
        equal_innings: bool,
    },
}

/// The opening shot of a game.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// What it is for.
    pub kind: OpeningKind,
    /// The slowest and the fastest cue that players use for it, m/s.
    pub speeds: [f64; 2],
}

/// What an opening shot is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningKind {
    /// It spreads the balls and pots some.
    Break,
    /// It moves few balls and leaves nothing to pot.
    Safety,
    /// It scores.
    Carom,
}

/// What a frame without progress leads to ([`crate::Options::patience`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stalemate {
    /// The balls are racked again.
    Rerack,
    /// The frame starts again, without scores.
    Restart,
    /// The frame ends undecided.
    End,
}

/// The balls of a random middle of a game.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RandomStart {
    /// The least and the greatest number of object balls, without those on their spots.
    pub count: [usize; 2],
    /// The balls that are always on the table, the cue ball first.
    pub always: &'static [BallIndex],
    /// The first and the last of those from which further ones are drawn.
    pub drawn: Option<[BallIndex; 2]>,
    /// The first and the last of those that stay where they are racked.
    pub racked: Option<[BallIndex; 2]>,
}

/// The cue's speeds of breaks, m/s: the cue ball has at most 35 mph, about the fastest breaks that were measured (from
/// memory, not verified). Slower breaks leave clusters, and values of positions do not see how much harder a rack with
/// clusters is to clear: a search without the lower limit plays ten-ball at 5 m/s.
pub(crate) const BREAK: Opening = Opening { kind: OpeningKind::Break, speeds: [7.5, 12.0] };

impl GameFacts {
    /// Whether the game is played on a table without pockets.
    pub const fn is_carom(&self) -> bool {
        matches!(self.objective, Objective::Caroms { .. })
    }

    /// Whether a number of points wins that is agreed before the start.
    pub const fn has_target(&self) -> bool {
        matches!(self.scoring, Scoring::Target { .. })
    }

    /// Whether the frame can end with the target reached by both players.
    pub const fn has_equal_innings(&self) -> bool {
        matches!(self.scoring, Scoring::Target { equal_innings: true, .. })
    }

    /// The usual number of points that win; none without such a number.
    pub const fn usual_points(&self) -> Option<i32> {
        match self.scoring {
            Scoring::Target { usual, .. } => Some(usual),
            Scoring::Points { .. } | Scoring::LastBall => None,
        }
    }

    /// Whether the shooter may pot `ball`, with these balls `on`; on a break none are named.
    pub fn may_pot(&self, on: &[BallIndex], ball: BallIndex) -> bool {
        match self.objective {
            Objective::AnyBall | Objective::LowestFirst => true,
            Objective::Groups | Objective::RedsAndColors if on.is_empty() => {
                Some(ball) != self.deciding_ball
            }
            Objective::Groups | Objective::RedsAndColors => on.contains(&ball),
            Objective::Caroms { .. } => false,
        }
    }

    /// The number in the rule book of the rule that forbids `foul` in this game. Empty where the rule is implemented
    /// from general knowledge of the game.
    pub fn rule(&self, foul: Foul) -> &'static str {
        (self.rule)(foul)
    }

    /// The facts as a tree of values, for the bindings.
    pub fn to_node(&self) -> Node {
        let (maximum, usual) = match self.scoring {
            Scoring::LastBall => (None, None),
            Scoring::Points { maximum } => (Some(maximum), None),
            Scoring::Target { usual, .. } => (None, Some(usual)),
        };
        Node::object([
            ("name", self.game.name().into()),
            ("table", self.game.table().into()),
            ("players", self.players.into()),
            ("balls", (self.balls as u32).into()),
            ("own_cue_balls", self.own_cue_balls.into()),
            ("objective", self.objective.name().into()),
            ("deciding_ball", self.deciding_ball.map(u32::from).into()),
            ("scoring", self.scoring.name().into()),
            ("usual_points", usual.map(i64::from).into()),
            ("maximum", maximum.map(i64::from).into()),
            ("opening", self.opening.kind.name().into()),
            ("lag", self.lag.into()),
            ("miss", self.miss.into()),
        ])
    }
}

impl Objective {
    const fn name(self) -> &'static str {
        match self {
            Self::AnyBall => "any-ball",
            Self::LowestFirst => "lowest-first",
            Self::Groups => "groups",
            Self::RedsAndColors => "reds-and-colors",
            Self::Caroms { .. } => "caroms",
        }
    }
}

impl Scoring {
    const fn name(self) -> &'static str {
        match self {
            Self::LastBall => "last-ball",
            Self::Points { .. } => "points",
            Self::Target { .. } => "target",
        }
    }
}

impl OpeningKind {
    const fn name(self) -> &'static str {
        match self {
            Self::Break => "break",
            Self::Safety => "safety",
            Self::Carom => "carom",
        }
    }
}
