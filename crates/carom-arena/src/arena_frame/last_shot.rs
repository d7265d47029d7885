//! The last shot of a frame, as everybody at the table has seen it.

use carom_mind::Answer;
use carom_rules::{Call, Choice, Ruling, Seat};

use crate::moves::{ArenaMove, Effect, Execution};

/// The last shot of a frame: what came out of it, and nothing of what was intended but the call, which
/// is announced.
#[derive(Clone, Copy, Debug)]
pub struct LastShot<'f> {
    /// The seat that shot.
    pub seat: Seat,
    /// What was announced.
    pub call: Call,
    /// The strike that came out.
    pub execution: &'f Execution,
    /// The ruling on it.
    pub ruling: &'f Ruling,
    /// The choice that a player has made since.
    pub choice: Option<Choice>,
}

impl<'f> LastShot<'f> {
    pub(crate) fn of(moves: &'f [ArenaMove]) -> Option<Self> {
        let mut choice = None;
        for arena_move in moves.iter().rev() {
            match (&arena_move.effect, arena_move.answer) {
                (Effect::Played { execution, ruling, .. }, Some(Answer::Play(play))) => {
                    let (seat, call) = (arena_move.seat, play.call);
                    return Some(Self { seat, call, execution, ruling, choice });
                }
                (Effect::Chosen { .. }, Some(Answer::Choice(made))) => {
                    choice = choice.or(Some(made));
                }
                _ => {}
            }
        }
        None
    }
}
