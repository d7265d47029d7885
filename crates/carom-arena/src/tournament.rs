//! Playing a match: pairs of frames on all cores, resumable.

use core::sync::atomic::{AtomicU64, Ordering};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use carom::format::{Node, Reader};
use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_mind::{Budget, Spent};
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::arena_frame::{ArenaFrame, NextStep};
use crate::clock::Cost;
use crate::error::ArenaError;
use crate::ledger::{Ledger, RECORD};
use crate::match_player::{MatchPlayer, Response};
use crate::record::{MatchHeader, frame_line, read_agreement};
use crate::score::{FramePoints, MatchScore};
use crate::secret::Secret;
use crate::sequential::{SequentialTest, TestState};
use crate::settings::{Match, PlayerIndex};
use crate::thinking_time::ThinkingTime;

/// A match to play.
#[derive(Clone, Debug)]
pub struct MatchPlan {
    /// Settings and players.
    pub of: Arc<Match>,
    /// Number of pairs of frames; with a test the largest number.
    pub pairs: u64,
    /// The test that ends the match early.
    pub test: Option<SequentialTest>,
    /// The secret, for experiments that can be repeated; `None` for one of the operating system.
    pub secret: Option<Secret>,
}

impl MatchPlan {
    /// The plan that an object describes. It has the keys of a record's header (docs/arena.md)
    /// without `format`, `engine` and `secret_sha256`.
    ///
    /// # Errors
    /// [`Error::Input`] with the key of a value that is missing, unknown or invalid.
    pub fn from_node(node: &Node, secret: Option<Secret>) -> Result<Self, Error> {
        let (of, pairs, test) = read_agreement(&Reader::new(node, ""))?;
        Ok(Self { of, pairs, test, secret })
    }
}

/// What a match has come to.
#[derive(Clone, Debug)]
pub struct MatchReport {
    /// The record, if the match is finished.
    pub record: Option<PathBuf>,
    /// The score of the first pairs that were played without a gap; of all if it is finished.
    pub score: MatchScore,
    /// The state of the test after these pairs.
    pub test: Option<TestState>,
    /// Number of these pairs.
    pub pairs: u64,
    /// SHA-256 of the secret.
    pub secret_sha256: String,
}

/// The state of a match that its threads share.
struct Scoreboard {
    ledger: Ledger,
    score: MatchScore,
    test: Option<TestState>,
    /// Number of pairs in the score.
    counted: u64,
    /// Number of pairs of the match, once it is known that no more are needed.
    end: Option<u64>,
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
    if plan.pairs == 0 || plan.pairs > MOST_PAIRS {
        let what = format!("{} is out of range", plan.pairs);
        let remedy = format!("write a whole number from 1 to {MOST_PAIRS}");
        return Err(ErrorKind::OutOfRange.at("pairs", what, remedy).into());
    }
    plan.test.as_ref().map_or(Ok(()), SequentialTest::check)?;
    let secret = match (plan.secret, Ledger::secret_in(folder)?) {
        (Some(secret), _) | (None, Some(secret)) => secret,
        (None, None) => new_secret()?,
    };
    let header = MatchHeader::new(plan.of.clone(), plan.pairs, plan.test, secret.sha256());
    let ledger = Ledger::open(folder, secret, &header.to_node())?;
    let mut board = Scoreboard::new(ledger);
    board.count(plan);
    progress.begin(0, plan.pairs as usize);
    let board = Mutex::new(board);
    let next = AtomicU64::new(0);
    runner.map(0..runner.threads(), FrameSimulator::new, |simulator, _| {
        while let Some(pair) = next_pair(plan, &board, &next, progress) {
            let played = play_pair(plan, &secret, pair, make_player, simulator, progress);
            locked(&board).add(plan, pair, played, progress);
        }
    });
    let board = board.into_inner().unwrap_or_else(PoisonError::into_inner);
    board.report(folder, &secret)
}

/// Largest number of pairs: a thousand times the largest published match.
const MOST_PAIRS: u64 = 1_000_000;

#[cfg(feature = "os-secret")]
fn new_secret() -> Result<Secret, Error> {
    Secret::from_os()
}

#[cfg(not(feature = "os-secret"))]
fn new_secret() -> Result<Secret, Error> {
    Err(ErrorKind::Missing.at("secret", "it is missing", "give one; this build cannot draw one"))
}

fn locked(board: &Mutex<Scoreboard>) -> MutexGuard<'_, Scoreboard> {
    // A player's panic leaves the scoreboard as it was before the pair.
    board.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The next pair to play; `None` if no more are needed, or if the match was stopped.
fn next_pair(
    plan: &MatchPlan,
    board: &Mutex<Scoreboard>,
    next: &AtomicU64,
    progress: &Progress,
) -> Option<u64> {
    while !progress.is_stopped() {
        let pair = next.fetch_add(1, Ordering::Relaxed);
        let board = locked(board);
        if pair >= plan.pairs || board.end.is_some() || board.failure.is_some() {
            break;
        }
        if board.ledger.points(pair).is_none() {
            return Some(pair);
        }
        progress.add(1);
    }
    None
}

/// The lines and the points of the two frames of a pair.
type Pair = ([Node; 2], [FramePoints; 2]);

/// Plays a pair; `None` if it was stopped.
fn play_pair<C, F>(
    plan: &MatchPlan,
    secret: &Secret,
    pair: u64,
    make_player: &F,
    simulator: &mut FrameSimulator,
    progress: &Progress,
) -> Result<Option<Pair>, Error>
where
    C: MatchPlayer,
    F: Fn(PlayerIndex) -> Result<C, Error> + Sync,
{
    let mut frames = Vec::with_capacity(2);
    for number in [2 * pair, 2 * pair + 1] {
        let mut players = [make_player(0)?, make_player(1)?];
        let mut frame =
            ArenaFrame::begin(plan.of.clone(), number, secret.pair_seeds(pair), simulator)?;
        play_frame(&mut frame, &mut players, simulator, progress)?;
        let Some(end) = frame.end() else { return Ok(None) };
        let points = FramePoints { points: frame.points(), reason: end.reason };
        frames.push((frame_line(&frame), points));
    }
    Ok(match <[_; 2]>::try_from(frames) {
        Ok([(one, points), (other, points_of_other)]) => {
            Some(([one, other], [points, points_of_other]))
        }
        Err(_) => None,
    })
}

/// Lets `players` (player 0, player 1) play `frame` to its end, on the calling thread. A player
/// that returns an error loses the frame. A stopped `progress` leaves the frame without an end;
/// [`Response::Stop`] stops it.
///
/// # Errors
/// None if the frame was begun without one.
pub fn play_frame<C: MatchPlayer>(
    frame: &mut ArenaFrame,
    players: &mut [C; 2],
    simulator: &mut FrameSimulator,
    progress: &Progress,
) -> Result<(), Error> {
    while let NextStep::Ask(ask) = frame.next() {
        // Without a clock of seconds no time is read: the target may have none.
        let time = ask.seconds().map(ThinkingTime::begin);
        let is_over =
            |_: Spent| progress.is_stopped() || time.as_ref().is_some_and(ThinkingTime::is_over);
        let budget = Budget {
            simulations: ask.simulations(),
            rounds: None,
            is_over: &is_over,
            runner: Runner::new(Some(1))?,
        };
        let response = players[ask.player].respond(&ask, &budget);
        let player = &players[ask.player];
        let elapsed = |time| player.seconds().unwrap_or_else(|| ThinkingTime::elapsed(time));
        let seconds = time.as_ref().map_or(0.0, elapsed);
        let cost = |spent| Cost { spent, seconds };
        if progress.is_stopped() {
            break;
        }
        match response {
            Response::Decision(decision) => frame.answer(simulator, &decision, seconds)?,
            Response::Explained(decision, info) => {
                frame.answer_explained(simulator, &decision, Some(info), seconds)?
            }
            Response::Unread(fault, spent) => frame.refuse(simulator, fault, cost(spent))?,
            Response::Failed(reason, why) => frame.forfeit(reason, &why, cost(Spent::default()))?,
            Response::Stop => {
                progress.stop();
                break;
            }
        };
    }
    if frame.end().is_some() {
        players.iter_mut().for_each(|player| player.frame_over(frame));
    }
    Ok(())
}

impl Scoreboard {
    fn new(ledger: Ledger) -> Self {
        let score = MatchScore::default();
        Self { ledger, score, test: None, counted: 0, end: None, failure: None }
    }

    /// Adds a pair that was played, or its failure.
    fn add(
        &mut self,
        plan: &MatchPlan,
        pair: u64,
        played: Result<Option<Pair>, Error>,
        progress: &Progress,
    ) {
        let added = match played {
            Ok(Some((lines, points))) => self.ledger.add(pair, &lines, points),
            Ok(None) => return,
            Err(error) => Err(error.into()),
        };
        match added {
            Ok(()) => {
                progress.add(1);
                self.count(plan);
            }
            Err(error) => self.failure = self.failure.take().or(Some(error)),
        }
    }

    /// Counts the pairs that follow the counted ones without a gap. The test looks at the pairs in
    /// their order, so its end does not depend on which pair was finished first.
    fn count(&mut self, plan: &MatchPlan) {
        let of_record = self.ledger.finished().map(|pairs| pairs.len() as u64);
        let most = of_record.unwrap_or(plan.pairs);
        while self.end.is_none() {
            if let Some(test) = &plan.test {
                let state = test.state(&self.score.pairs);
                self.test = Some(state);
                if state.accepted.is_some() {
                    self.end = Some(self.counted);
                    break;
                }
            }
            if self.counted == most {
                self.end = Some(most);
                break;
            }
            let Some(points) = self.ledger.points(self.counted) else { break };
            self.score.add(&points);
            self.counted += 1;
        }
    }

    /// Writes the record of a match that has its end.
    fn report(mut self, folder: &Path, secret: &Secret) -> Result<MatchReport, ArenaError> {
        if let Some(failure) = self.failure {
            return Err(failure);
        }
        if let Some(end) = self.end {
            self.ledger.finish(end)?;
        }
        Ok(MatchReport {
            record: self.end.map(|_| folder.join(RECORD)),
            score: self.score,
            test: self.test,
            pairs: self.counted,
            secret_sha256: secret.sha256(),
        })
    }
}
