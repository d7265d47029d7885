//! What a player does.

use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;

use crate::BallIndex;

/// A shot as a player plays it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Play {
    /// How the cue ball is struck.
    pub strike: Strike,
    /// Where the cue ball is put first (its centre in the file's frame, m), if it is in hand.
    pub cue_ball: Option<[f64; 2]>,
    /// What is announced.
    pub call: Call,
}

impl Play {
    /// A shot with nothing announced and the cue ball where it lies.
    pub const fn new(strike: Strike) -> Self {
        Self { strike, cue_ball: None, call: Call::Nothing }
    }

    /// The same, calling `ball` into `pocket`.
    pub const fn calling(self, ball: BallIndex, pocket: PocketName) -> Self {
        Self { call: Call::Pocket(ball, pocket), ..self }
    }

    /// The same with the cue ball put at `place` first (m, in the file's frame).
    pub const fn from(self, place: [f64; 2]) -> Self {
        Self { cue_ball: Some(place), ..self }
    }
}

/// What a player announces before a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Call {
    /// Nothing.
    #[default]
    Nothing,
    /// This ball in that pocket.
    Pocket(BallIndex, PocketName),
    /// A safety: the other player shoots next, whatever falls.
    Safety,
    /// A push-out.
    PushOut,
    /// This ball is the ball on (snooker: a colour, or the free ball).
    On(BallIndex),
}
