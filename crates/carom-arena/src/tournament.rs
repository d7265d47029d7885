//! Playing a match: pairs of frames on all cores, resumable.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use carom::Error;
use carom::runner::Runner;
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::error::ArenaError;
use crate::match_player::MatchPlayer;
use crate::open_match::{MatchReport, OpenMatch};
use crate::pair::{MatchPlan, PlayedPair, play_pair};
use crate::settings::PlayerIndex;

/// The state of a match that its threads share.
struct Scoreboard {
    open: OpenMatch,
    failure: Option<ArenaError>,
}

/// Plays a match in `folder`, or continues it. `make_player` makes player 0 or 1; it is called for
/// every frame, so that a frame does not depend on those before it. Results do not depend on the
/// number of threads, and with clocks of simulated shots neither on the machine. Every pair is
/// written when it ends. A stopped `progress` ends the match early; the frames in progress are then
/// played again when the match is continued.
///
/// # Errors
/// [`ArenaError::Input`] for a plan out of range, for a folder with another match or a damaged
/// file, and for the errors of `make_player`; [`ArenaError::File`] if a file cannot be read or
/// written. All pairs that had ended before are kept.
pub fn play_match<C, F>(
    plan: &MatchPlan,
    folder: &Path,
    make_player: &F,
    runner: &Runner,
    progress: &Progress,
) -> Result<MatchReport, ArenaError>
where
    C: MatchPlayer,
    F: Fn(PlayerIndex) -> Result<C, Error> + Sync,
{
    let open = OpenMatch::open(plan, folder)?;
    let secret = *open.secret();
    progress.begin(0, plan.pairs as usize);
    progress.add(open.played() as usize);
    let board = Mutex::new(Scoreboard { open, failure: None });
    runner.map(0..runner.threads(), FrameSimulator::new, |simulator, _| {
        while let Some(pair) = next_pair(&board, progress) {
            let played = play_pair(plan, &secret, pair, make_player, simulator, progress);
            locked(&board).add(played, progress);
        }
    });
    let Scoreboard { open, failure } = board.into_inner().unwrap_or_else(PoisonError::into_inner);
    failure.map_or_else(|| open.close(), Err)
}

fn locked(board: &Mutex<Scoreboard>) -> MutexGuard<'_, Scoreboard> {
    // A player's panic leaves the scoreboard as it was before the pair.
    board.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The next pair to play; `None` if no more are needed, or if the match was stopped.
fn next_pair(board: &Mutex<Scoreboard>, progress: &Progress) -> Option<u64> {
    if progress.is_stopped() {
        return None;
    }
    let mut board = locked(board);
    if board.failure.is_some() { None } else { board.open.next_pair() }
}

impl Scoreboard {
    /// Adds a pair that was played, or its failure.
    fn add(&mut self, played: Result<Option<PlayedPair>, Error>, progress: &Progress) {
        let added = match played {
            Ok(Some(pair)) => self.open.add(&pair),
            Ok(None) => return,
            Err(error) => Err(error.into()),
        };
        match added {
            Ok(()) => progress.add(1),
            Err(error) => self.failure = self.failure.take().or(Some(error)),
        }
    }
}
