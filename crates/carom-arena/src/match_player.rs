//! Who answers the requests of a match: a built-in player, or a program of somebody else.

use carom::Error;
use carom::error::InputError;
use carom::format::Node;
use carom::runner::Runner;
use carom_mind::{Budget, Decision, Player, Spent};

use crate::arena_frame::{ArenaFrame, Ask};
use crate::moves::EndReason;
use crate::thinking_time::ThinkingTime;

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

/// Asks a player, on the calling thread. Returns its response, and the time that it took, s; 0 if its
/// clock counts no seconds.
///
/// # Errors
/// None: one thread is always there.
pub fn ask_player<C: MatchPlayer + ?Sized>(
    player: &mut C,
    ask: &Ask<'_>,
    is_stopped: &(dyn Fn() -> bool + Sync),
) -> Result<(Response, f64), Error> {
    // Without a clock of seconds no time is read: the target may have none.
    let time = ask.seconds().map(ThinkingTime::begin);
    let is_over = |_: Spent| is_stopped() || time.as_ref().is_some_and(ThinkingTime::is_over);
    let budget = Budget {
        simulations: ask.simulations(),
        rounds: None,
        is_over: &is_over,
        runner: Runner::new(Some(1))?,
    };
    let response = player.respond(ask, &budget);
    let elapsed = |time| player.seconds().unwrap_or_else(|| ThinkingTime::elapsed(time));
    let seconds = time.as_ref().map_or(0.0, elapsed);
    Ok((response, seconds))
}
