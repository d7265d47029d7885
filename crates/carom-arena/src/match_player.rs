//! Who answers the requests of a match: a built-in player, or a program of somebody else.

use carom::Error;
use carom::error::InputError;
use carom::format::Node;
use carom_mind::{Budget, Decision, Player, Spent};

use crate::arena_frame::{ArenaFrame, Ask};
use crate::moves::EndReason;

/// What a player of a match does when it is asked.
#[derive(Clone, Debug, PartialEq)]
pub enum Response {
    /// It decides.
    Decision(Decision),
    /// It decides, and says this of its decision, which the record keeps.
    Explained(Decision, Node),
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

    /// The time that the last response took, s, if the player measures it itself: the clock of a program
    /// counts from the last byte of the request to the end of the line of the answer. `None` for the time
    /// of the whole call.
    fn seconds(&self) -> Option<f64> {
        None
    }

    /// The frame of the last response is over.
    fn frame_over(&mut self, _frame: &ArenaFrame) {}
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
