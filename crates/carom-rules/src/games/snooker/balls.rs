//! The balls of snooker and their values.

use crate::layout::{BallIndex, BallList, FrameLayout};
use crate::state_bytes::state_bytes;

pub(crate) const CUE: BallIndex = 0;

/// Number of colours.
const COLORS: BallIndex = 6;

/// The balls of a frame: the cue ball, the reds, and the colours from yellow to black. Games differ in the number of
/// reds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Balls {
    pub(crate) yellow: BallIndex,
}

impl Balls {
    /// The balls of a frame with `count` balls.
    pub(crate) const fn of_count(count: usize) -> Self {
        Self { yellow: count as BallIndex - COLORS }
    }

    pub(crate) fn of(layout: &FrameLayout) -> Self {
        Self::of_count(layout.len())
    }

    pub(crate) fn reds(self) -> impl Iterator<Item = BallIndex> {
        1..self.yellow
    }

    pub(crate) fn colors(self) -> impl DoubleEndedIterator<Item = BallIndex> {
        self.yellow..self.yellow + COLORS
    }

    pub(crate) const fn black(self) -> BallIndex {
        self.yellow + COLORS - 1
    }

    /// Points for `ball`: 1 for a red, 2 (yellow) to 7 (black) for a colour, 0 for anything else.
    pub(crate) fn value(self, ball: BallIndex) -> i32 {
        if ball == CUE || ball > self.black() {
            0
        } else if ball < self.yellow {
            1
        } else {
            i32::from(ball - self.yellow) + 2
        }
    }
}

/// Points for the black.
pub(crate) const BLACK_VALUE: i32 = 7;

/// The kind of ball that is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum On {
    /// Any red.
    #[default]
    Red,
    /// A colour of the player's choice, after a red.
    Color,
    /// The colours in ascending order.
    Sequence,
}

state_bytes!(
    enum On {
        Red,
        Color,
        Sequence,
    }
);

impl On {
    /// What is on for the next player after a shot that pots nothing.
    pub(super) fn after_a_miss(self, layout: &FrameLayout) -> Self {
        match self {
            Self::Color if layout.left(Balls::of(layout).reds()).is_empty() => Self::Sequence,
            Self::Color => Self::Red,
            Self::Red | Self::Sequence => self,
        }
    }

    /// The balls on, without a free ball.
    pub(super) fn balls(self, layout: &FrameLayout) -> BallList {
        let balls = Balls::of(layout);
        match self {
            Self::Red => layout.left(balls.reds()),
            Self::Color => layout.left(balls.colors()),
            Self::Sequence => layout.left(balls.colors()).iter().copied().take(1).collect(),
        }
    }
}
