//! Playing a record again, to the bit.

use carom::format::{Node, Reader};
use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::arena_frame::{ArenaFrame, Ask, NextStep};
use crate::moves::FrameEnd;
use crate::record::{
    ENGINE, MatchHeader, Recorded, at_line, frame_line, frame_number, frame_points, last_line,
    read_last_line, read_line, read_moves,
};
use crate::score::MatchScore;
use crate::secret::{LineHash, Secret};

/// What a replay has found.
#[derive(Clone, Debug)]
pub struct Replay {
    /// The header of the record.
    pub header: MatchHeader,
    /// Number of frames in the record.
    pub frames: u64,
    /// The first difference; `None` if the record has replayed to the bit.
    pub difference: Option<RecordDifference>,
    /// The score of the record.
    pub score: MatchScore,
}

/// A value of a record that its replay does not reproduce.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordDifference {
    /// The line, from 1.
    pub line: u64,
    /// The key on that line, such as `moves[3].executed.strike.side`.
    pub key: String,
    /// The value in the record, as JSON.
    pub recorded: String,
    /// The value of the replay, as JSON.
    pub replayed: String,
}

/// A complete record.
struct Record<'a> {
    lines: Vec<&'a str>,
    header: MatchHeader,
    secret: Secret,
    /// The last line, which has the secret.
    last: Node,
}

impl<'a> Record<'a> {
    fn read(text: &'a str) -> Result<Self, Error> {
        let lines: Vec<&str> = text.lines().collect();
        let [first, .., last] = lines.as_slice() else {
            return Err(at_line(incomplete(), 1));
        };
        let header = MatchHeader::from_node(&read_line(first, 1)?).map_err(|e| at_line(e, 1))?;
        let last_number = lines.len() as u64;
        let last = read_line(last, last_number)?;
        let (secret, _) = match last.get("secret") {
            Some(_) => read_last_line(&last).map_err(|error| at_line(error, last_number))?,
            None => return Err(at_line(incomplete(), last_number)),
        };
        Ok(Self { lines, header, secret, last })
    }

    /// The lines of the frames.
    fn frames(&self) -> &[&'a str] {
        &self.lines[1..self.lines.len() - 1]
    }
}

/// Plays the record `text` of a match again: with the recorded answers, every seed, error, strike,
/// ruling, trace and result is computed again and compared. Costs, chances and settings of players
/// cannot be computed again; the hash on the last line covers them.
///
/// # Errors
/// [`Error::Input`] with the line and the key for a damaged record, and for one without its last
/// line. [`Error::Input`] at `progress` if the replay was stopped.
pub fn replay(text: &str, runner: &Runner, progress: &Progress) -> Result<Replay, Error> {
    let record = Record::read(text)?;
    let (frames, Record { header, secret, .. }) = (record.frames(), &record);
    progress.begin(0, frames.len());
    let replayed =
        runner.map((0..).zip(frames), FrameSimulator::new, |simulator, (index, line)| {
            if progress.is_stopped() {
                let remedy = "start the replay again";
                return Err(ErrorKind::Stopped.at("progress", "the replay was stopped", remedy));
            }
            let (node, line) = (read_line(line, index + 2)?, index + 2);
            let again = play_again(header, secret, index, &node, simulator, &mut |_| ());
            let again = again.map_err(|error| at_line(error, line))?;
            let again = frame_line(&again);
            progress.add(1);
            let points = frame_points(&node).map_err(|error| at_line(error, line))?;
            Ok((difference("", &node, &again).map(|d| RecordDifference { line, ..d }), points))
        });
    let replayed = replayed.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let mut score = MatchScore::default();
    for pair in replayed.as_chunks::<2>().0 {
        score.add(&[pair[0].1, pair[1].1]);
    }
    let of_frames = replayed.into_iter().find_map(|(difference, _)| difference);
    let difference =
        difference_of_secret(header, secret).or(of_frames).or_else(|| difference_of_hash(&record));
    let frames = frames.len() as u64;
    Ok(Replay { header: record.header, frames, difference, score })
}

/// Plays the record `text` of a match again, and gives every request of every frame to `see`. Returns
/// what it returned, frame by frame, and how each frame ended.
///
/// # Errors
/// As [`replay`]. Differences between the record and the replay are not looked for.
pub fn positions<T: Send>(
    text: &str,
    runner: &Runner,
    see: impl Fn(&Ask<'_>) -> T + Sync,
) -> Result<Vec<(Vec<T>, FrameEnd)>, Error> {
    let record = Record::read(text)?;
    let frames =
        runner.map((0..).zip(record.frames()), FrameSimulator::new, |simulator, (index, line)| {
            let number = index + 2;
            let node = read_line(line, number)?;
            let mut seen = Vec::new();
            let mut visit = |ask: &Ask<'_>| seen.push(see(ask));
            let played =
                play_again(&record.header, &record.secret, index, &node, simulator, &mut visit);
            let frame = played.map_err(|error| at_line(error, number))?;
            let end = frame.end().cloned().ok_or_else(|| at_line(incomplete(), number))?;
            Ok((seen, end))
        });
    frames.into_iter().collect()
}

fn incomplete() -> Error {
    ErrorKind::Syntax.at(
        "",
        "the record ends before the line with the secret",
        "finish the match, or give a complete record",
    )
}

/// Frame number `index`, played again with the moves of the line `node`. `visit` sees every request.
fn play_again(
    header: &MatchHeader,
    secret: &Secret,
    index: u64,
    node: &Node,
    simulator: &mut FrameSimulator,
    visit: &mut dyn FnMut(&Ask<'_>),
) -> Result<ArenaFrame, Error> {
    let number = frame_number(node)?;
    if number != index {
        let what = format!("found frame {number}, but frame {index} is next");
        return Err(ErrorKind::Mismatch.at("frame", what, "put the lines back in order"));
    }
    let moves = read_moves(header.of.start(), &Reader::new(node, ""))?;
    let seeds = secret.pair_seeds(number / 2);
    let mut frame = ArenaFrame::begin(header.of.clone(), number, seeds, simulator)?;
    for recorded in moves {
        match frame.next() {
            NextStep::Ask(ask) => visit(&ask),
            NextStep::Over(_) => break,
        }
        match recorded {
            Recorded::Decision(decision, info, seconds) => {
                frame.answer_explained(simulator, &decision, info, seconds)?;
            }
            Recorded::Unread(fault, cost) => {
                frame.refuse(simulator, fault, cost)?;
            }
            Recorded::Failure(reason, why, cost) => {
                frame.forfeit(reason, &why, cost)?;
            }
        }
    }
    Ok(frame)
}

/// The first difference between two values; `key` is their place.
fn difference(key: &str, recorded: &Node, replayed: &Node) -> Option<RecordDifference> {
    let differ = |key: &str, recorded: Option<&Node>, replayed: Option<&Node>| {
        let text = |node: Option<&Node>| node.map_or_else(|| "nothing".into(), Node::to_json_line);
        let (recorded, replayed) = (text(recorded), text(replayed));
        Some(RecordDifference { line: 0, key: key.into(), recorded, replayed })
    };
    match (recorded, replayed) {
        (Node::Object(one), Node::Object(other)) => {
            let dot = if key.is_empty() { "" } else { "." };
            let inside = |name: &str| format!("{key}{dot}{name}");
            let of_recorded = one.iter().find_map(|(name, value)| match replayed.get(name) {
                Some(again) => difference(&inside(name), value, again),
                None => differ(&inside(name), Some(value), None),
            });
            let missing = || {
                let absent = other.iter().find(|(name, _)| recorded.get(name).is_none());
                absent.and_then(|(name, value)| differ(&inside(name), None, Some(value)))
            };
            of_recorded.or_else(missing)
        }
        (Node::List(one), Node::List(other)) => {
            let longest = one.len().max(other.len());
            (0..longest).find_map(|i| {
                let key = format!("{key}[{i}]");
                match (one.get(i), other.get(i)) {
                    (Some(one), Some(other)) => difference(&key, one, other),
                    (one, other) => differ(&key, one, other),
                }
            })
        }
        // Equal numbers may have other bits: 0 and −0.
        (Node::Number(one), Node::Number(other)) if one.to_bits() == other.to_bits() => None,
        (Node::Number(_), Node::Number(_)) => differ(key, Some(recorded), Some(replayed)),
        _ if recorded == replayed => None,
        _ => differ(key, Some(recorded), Some(replayed)),
    }
}

fn difference_of_secret(header: &MatchHeader, secret: &Secret) -> Option<RecordDifference> {
    let (recorded, replayed) = (header.secret_sha256.clone(), secret.sha256());
    let key = "secret_sha256".into();
    (recorded != replayed).then_some(RecordDifference { line: 1, key, recorded, replayed })
}

/// Compares the hash of the lines. It finds changes of values that a replay only repeats.
fn difference_of_hash(record: &Record<'_>) -> Option<RecordDifference> {
    let Record { lines, secret, last, .. } = record;
    let mut hash = LineHash::default();
    lines[..lines.len() - 1].iter().for_each(|line| hash.add(line));
    let expected = last_line(secret, hash);
    difference("", last, &expected).map(|d| RecordDifference { line: lines.len() as u64, ..d })
}

impl Replay {
    /// Whether the record was written by another version of the engine, whose results may differ.
    pub fn is_of_another_engine(&self) -> bool {
        self.header.engine != ENGINE
    }
}
