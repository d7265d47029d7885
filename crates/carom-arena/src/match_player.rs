//! Who answers the requests of a match: a built-in player, or a program of somebody else.

use carom::Error;
use carom::error::InputError;
use carom_mind::{Budget, Decision, Player, Spent};

use crate::arena_frame::Ask;
use crate::moves::EndReason;

/// What a player of a match does when it is asked.
#[derive(Clone, Debug, PartialEq)]
pub enum Response {
    /// It decides.
    Decision(Decision),
    /// It gives an answer that cannot be read, which is refused, and what that cost.
    Unread(InputError, Spent),
    /// It gives no answer and loses the frame: why, and the same in words.
    Failed(EndReason, String),
    /// The match is to stop. The frame has no end, and is played again when the match is continued.
    Stop,
}

/// Answers the requests of the frames of a match. Every [`Player`] in a box is one; a program that sees
/// the clock and its refusals, and may fail in ways of its own, implements this trait.
pub trait MatchPlayer: Send {
    /// The response to a request, within the budget.
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response;
}

impl<P: Player + ?Sized> MatchPlayer for Box<P> {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        let decided: Result<Decision, Error> = self.decide(&ask.situation, budget);
        match decided {
            Ok(decision) => Response::Decision(decision),
            Err(error) => Response::Failed(EndReason::Crash, error.to_string()),
        }
    }
}
