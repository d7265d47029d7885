//! A pair of frames, played on one thread, in this process or in another one.

use std::sync::Arc;

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};
use carom_mind::Spent;
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::arena_frame::{ArenaFrame, NextStep};
use crate::clock::Cost;
use crate::match_player::{MatchPlayer, Response, ask_player};
use crate::record::{at_line, frame_line, frame_number, frame_points, read_agreement, read_line};
use crate::score::FramePoints;
use crate::secret::Secret;
use crate::sequential::SequentialTest;
use crate::settings::{Match, PlayerIndex};

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

/// A pair of frames that was played. Its lines may come from another process ([`Self::read`]).
#[derive(Clone, Debug, PartialEq)]
pub struct PlayedPair {
    number: u64,
    lines: [String; 2],
    points: [FramePoints; 2],
}

impl PlayedPair {
    /// Pair `number` with its two lines of a record, as [`Self::lines`] gave them.
    ///
    /// # Errors
    /// [`Error::Input`] if they are not the lines of this pair.
    pub fn read(number: u64, lines: [String; 2]) -> Result<Self, Error> {
        let read = |line: &String, frame: u64| {
            let node = read_line(line, frame + 2)?;
            let points = frame_points(&node).map_err(|error| at_line(error, frame + 2))?;
            if frame_number(&node)? == frame {
                return Ok(points);
            }
            let what = format!("it is not frame {frame}");
            let remedy = "give the lines of the pair that was asked for";
            Err(at_line(ErrorKind::Mismatch.at("frame", what, remedy), frame + 2))
        };
        let points = [read(&lines[0], 2 * number)?, read(&lines[1], 2 * number + 1)?];
        Ok(Self { number, lines, points })
    }

    /// The number of the pair, from 0.
    pub const fn number(&self) -> u64 {
        self.number
    }

    /// The lines of its two frames in the record, without line feeds.
    pub const fn lines(&self) -> &[String; 2] {
        &self.lines
    }

    /// The points of its two frames.
    pub const fn points(&self) -> [FramePoints; 2] {
        self.points
    }
}

/// Plays pair `number` of a match with this secret on the calling thread; `None` if it was stopped.
/// The lines depend only on the arguments, if no clock counts seconds: every process plays the same
/// pair. The secret of the plan is not used.
///
/// # Errors
/// Those of `make_player`, and [`Error::Input`] for a plan out of range.
pub fn play_pair<C, F>(
    plan: &MatchPlan,
    secret: &Secret,
    number: u64,
    make_player: &F,
    simulator: &mut FrameSimulator,
    progress: &Progress,
) -> Result<Option<PlayedPair>, Error>
where
    C: MatchPlayer,
    F: Fn(PlayerIndex) -> Result<C, Error> + Sync,
{
    let mut played = Vec::with_capacity(2);
    for frame_number in [2 * number, 2 * number + 1] {
        let mut players = [make_player(0)?, make_player(1)?];
        let seeds = secret.pair_seeds(number);
        let mut frame = ArenaFrame::begin(plan.of.clone(), frame_number, seeds, simulator)?;
        play_frame(&mut frame, &mut players, simulator, progress)?;
        let Some(end) = frame.end() else { return Ok(None) };
        let points = FramePoints { points: frame.points(), reason: end.reason, luck: frame.luck() };
        played.push((frame_line(&frame).to_json_line(), points));
    }
    let pair = <[_; 2]>::try_from(played).ok().map(|[(one, points), (other, points_of_other)]| {
        PlayedPair { number, lines: [one, other], points: [points, points_of_other] }
    });
    Ok(pair)
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
        let player = &mut players[ask.player];
        let (response, seconds) = ask_player(player, &ask, &|| progress.is_stopped())?;
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
