//! Plays and calls of a frame.

use carom::shot::Cling;
use carom::{Error, ErrorKind};
use carom_rules::{BallIndex, Call, Frame, Play};

use crate::entry::{flag, index};
use crate::kinds::{self, CAROM_NONE};
use crate::shot::carom_strike;

/// Nothing is called.
pub const CAROM_CALL_NOTHING: i32 = 0;
/// A ball is called into a pocket.
pub const CAROM_CALL_POCKET: i32 = 1;
/// A safety.
pub const CAROM_CALL_SAFETY: i32 = 2;
/// A push-out.
pub const CAROM_CALL_PUSH_OUT: i32 = 3;
/// A ball is nominated as the ball on.
pub const CAROM_CALL_ON: i32 = 4;

/// A player's shot. All zero but the strike: the cue ball is played from where it lies, without a call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_play {
    /// The strike of the cue ball.
    pub strike: carom_strike,
    /// Centre of a cue ball in hand, m; read if has_cue_ball is not 0.
    pub cue_ball: [f64; 2],
    /// Whether the cue ball is placed.
    pub has_cue_ball: i32,
    /// CAROM_CALL_NOTHING to CAROM_CALL_ON.
    pub call: i32,
    /// The ball of the call, an index of the frame's balls.
    pub call_ball: i32,
    /// The pocket of the call, an index of the table's pockets.
    pub call_pocket: i32,
}

impl carom_play {
    /// The play in `frame`.
    pub(crate) fn play(&self, frame: &Frame) -> Result<Play, Error> {
        let play = Play {
            strike: self.strike.strike(),
            cue_ball: flag(self.has_cue_ball).then_some(self.cue_ball),
            call: self.call(frame)?,
            policy: self.strike.policy(),
            cling: Cling::NONE,
        };
        if flag(self.strike.has_elevation) { Ok(play) } else { frame.at_default_elevation(&play) }
    }

    fn call(&self, frame: &Frame) -> Result<Call, Error> {
        let ball =
            || Ok::<_, Error>(index(self.call_ball, frame.layout().len(), "ball")? as BallIndex);
        match self.call {
            CAROM_CALL_NOTHING => Ok(Call::Nothing),
            CAROM_CALL_SAFETY => Ok(Call::Safety),
            CAROM_CALL_PUSH_OUT => Ok(Call::PushOut),
            CAROM_CALL_ON => Ok(Call::On(ball()?)),
            CAROM_CALL_POCKET => {
                let pockets = &frame.base().table().pockets;
                let pocket = index(self.call_pocket, pockets.len(), "pocket")?;
                Ok(Call::Pocket(ball()?, pockets[pocket].name))
            }
            other => Err(ErrorKind::UnknownName.at(
                "call",
                format!("{other} is not a call"),
                "write a number from CAROM_CALL_NOTHING to CAROM_CALL_ON",
            )),
        }
    }

    pub(crate) fn new(frame: &Frame, play: &Play) -> Self {
        let (call, ball, pocket) = match play.call {
            Call::Nothing => (CAROM_CALL_NOTHING, None, None),
            Call::Safety => (CAROM_CALL_SAFETY, None, None),
            Call::PushOut => (CAROM_CALL_PUSH_OUT, None, None),
            Call::On(ball) => (CAROM_CALL_ON, Some(ball), None),
            Call::Pocket(ball, pocket) => (CAROM_CALL_POCKET, Some(ball), Some(pocket)),
        };
        let table = frame.base().table();
        Self {
            strike: carom_strike::new(&play.strike, play.policy),
            cue_ball: play.cue_ball.unwrap_or_default(),
            has_cue_ball: play.cue_ball.is_some().into(),
            call,
            call_ball: ball.map_or(CAROM_NONE, i32::from),
            call_pocket: pocket.map_or(CAROM_NONE, |pocket| kinds::pocket(table, pocket)),
        }
    }
}

/// A play with default values, without a strike.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_play_def() -> carom_play {
    carom_play {
        strike: crate::shot::carom_default_strike_def(),
        cue_ball: [0.0; 2],
        has_cue_ball: 0,
        call: CAROM_CALL_NOTHING,
        call_ball: 0,
        call_pocket: 0,
    }
}
