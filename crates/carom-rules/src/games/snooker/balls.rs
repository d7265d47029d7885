//! The balls of snooker and their values.

use crate::layout::{BallIndex, BallList, FrameLayout};
use crate::state_bytes::state_bytes;

pub(crate) const CUE: BallIndex = 0;
pub(crate) const REDS: core::ops::RangeInclusive<BallIndex> = 1..=15;
pub(crate) const YELLOW: BallIndex = 16;
pub(crate) const BLACK: BallIndex = 21;
pub(crate) const COLORS: core::ops::RangeInclusive<BallIndex> = YELLOW..=BLACK;

/// Points for `ball`: 1 for a red, 2 (yellow) to 7 (black) for a colour, 0 for anything else.
pub const fn value(ball: BallIndex) -> i32 {
    match ball {
        1..=15 => 1,
        YELLOW..=BLACK => ball as i32 - 14,
        _ => 0,
    }
}

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
    /// The balls on, without a free ball.
    pub(super) fn balls(self, layout: &FrameLayout) -> BallList {
        match self {
            Self::Red => layout.left(REDS),
            Self::Color => layout.left(COLORS),
            Self::Sequence => layout.left(COLORS).iter().copied().take(1).collect(),
        }
    }
}
