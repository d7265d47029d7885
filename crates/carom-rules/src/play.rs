//! The shot of a player: strike, place of a cue ball in hand, and call.

use carom::math::{degrees, radians};
use carom::resolve::cue_ball::Strike;
use carom::shot::{Cling, StrikePolicy};
use carom::table::PocketName;

use crate::layout::BallIndex;

/// The shot of a player: strike, place of a cue ball in hand, and call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Play {
    /// The strike of the cue ball.
    pub strike: Strike,
    /// Where a cue ball in hand is placed before the strike: its centre (file coordinates, m).
    pub cue_ball: Option<[f64; 2]>,
    /// The call.
    pub call: Call,
    /// The policies for a strike that a player could not play cleanly.
    pub policy: StrikePolicy,
    /// The contacts of two balls that cling.
    pub cling: Cling,
}

impl Play {
    /// A shot without an announcement that plays the cue ball where it lies, under the usual
    /// policies and without cling.
    pub fn new(strike: Strike) -> Self {
        let policy = StrikePolicy::default();
        Self { strike, cue_ball: None, call: Call::Nothing, policy, cling: Cling::NONE }
    }

    /// The same shot with `ball` called into `pocket`.
    pub const fn calling(self, ball: BallIndex, pocket: PocketName) -> Self {
        Self { call: Call::Pocket(ball, pocket), ..self }
    }

    /// The same shot with the cue ball placed at `place` (file coordinates, m) before the strike.
    pub const fn from(self, place: [f64; 2]) -> Self {
        Self { cue_ball: Some(place), ..self }
    }
}

/// The strike with its angles (rad) converted to degrees and back. Frames recorded when shot files
/// could hold only degrees must replay to the bit, and the results of environments must stay the
/// same.
pub fn through_degrees(strike: &Strike) -> Strike {
    let through = |angle: f64| radians(degrees(angle));
    Strike { azimuth: through(strike.azimuth), elevation: through(strike.elevation), ..*strike }
}

/// An announcement before a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Call {
    /// Nothing.
    #[default]
    Nothing,
    /// This ball in that pocket.
    Pocket(BallIndex, PocketName),
    /// A safety: the other player shoots next, even if a ball is pocketed.
    Safety,
    /// A push-out.
    PushOut,
    /// This ball is nominated as the ball on (snooker: a colour, or a free ball).
    On(BallIndex),
}
