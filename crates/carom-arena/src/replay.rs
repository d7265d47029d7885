//! Playing a record again, to the bit.

use carom::format::{Node, Reader};
use carom::runner::Runner;
use carom::{Error, ErrorKind};
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::arena_frame::{ArenaFrame, Ask, NextStep};
use crate::luck::LuckSettings;
use crate::moves::FrameEnd;
use crate::record::{
    ENGINE, MatchHeader, Recorded, at_line, frame_line, frame_number, frame_points, last_line,
    read_last_line, read_line, read_moves,
};
use crate::score::{FramePoints, MatchScore};
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
    /// The record with the luck of its shots, if [`measure_luck`] has made it.
    pub with_luck: Option<String>,
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

    /// The result, with the difference that each frame has and its points.
    fn into_replay(
        self,
        differences: Vec<Option<RecordDifference>>,
        points: Vec<FramePoints>,
    ) -> Replay {
        let mut score = MatchScore::default();
        for pair in points.as_chunks().0 {
            score.add(pair);
        }
        let of_frames = (2..).zip(differences);
        let of_frames = of_frames
            .filter_map(|(line, found)| found.map(|found| RecordDifference { line, ..found }));
        let difference = difference_of_secret(&self.header, &self.secret)
            .or_else(|| of_frames.into_iter().next())
            .or_else(|| difference_of_hash(&self));
        let frames = self.frames().len() as u64;
        Replay { header: self.header, frames, difference, score, with_luck: None }
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
    let replayed = replay_frames(&record, &record.header, runner, progress, |node, frame| {
        let again = frame_line(frame);
        Ok((difference("", node, &again), frame_points(node)?))
    })?;
    let (differences, points) = replayed.into_iter().unzip();
    Ok(record.into_replay(differences, points))
}

/// Plays the record `text` of a match again as [`replay`] does, and measures the luck of its shots.
/// The result has the score that is corrected for it, and the record with the luck of every shot. A
/// luck that the record had before is replaced.
///
/// # Errors
/// As [`replay`], and [`Error::Input`] at `luck.draws`.
pub fn measure_luck(
    text: &str,
    luck: LuckSettings,
    runner: &Runner,
    progress: &Progress,
) -> Result<Replay, Error> {
    let record = Record::read(text)?;
    let MatchHeader { of, pairs, test, secret_sha256, .. } = &record.header;
    let of = of.with_luck(luck)?;
    let header = MatchHeader::new(of.into(), *pairs, *test, secret_sha256.clone());
    let replayed = replay_frames(&record, &header, runner, progress, |node, frame| {
        let again = frame_line(frame);
        let difference = difference("", &without_luck(node.clone()), &without_luck(again.clone()));
        let points = frame_points(&again)?;
        Ok((again.to_json_line(), difference, points))
    })?;
    let mut with_luck = LineWriter::default();
    with_luck.add(&header.to_node().to_json_line());
    let (mut differences, mut points) = (Vec::new(), Vec::new());
    for (line, difference, of_frame) in replayed {
        with_luck.add(&line);
        differences.push(difference);
        points.push(of_frame);
    }
    let with_luck = Some(with_luck.finish(&record.secret));
    Ok(Replay { with_luck, ..record.into_replay(differences, points) })
}

/// Plays the frames of a record again, in a match with this `header`. `judge` gets each line and its
/// frame.
fn replay_frames<T: Send>(
    record: &Record<'_>,
    header: &MatchHeader,
    runner: &Runner,
    progress: &Progress,
    judge: impl Fn(&Node, &ArenaFrame) -> Result<T, Error> + Sync,
) -> Result<Vec<T>, Error> {
    let frames = record.frames();
    progress.begin(0, frames.len());
    let replayed =
        runner.map((0..).zip(frames), FrameSimulator::new, |simulator, (index, line)| {
            if progress.is_stopped() {
                let remedy = "start the replay again";
                return Err(ErrorKind::Stopped.at("progress", "the replay was stopped", remedy));
            }
            let (node, line) = (read_line(line, index + 2)?, index + 2);
            let again = play_again(header, &record.secret, index, &node, simulator, &mut |_| ());
            let judged = again.and_then(|frame| judge(&node, &frame));
            progress.add(1);
            judged.map_err(|error| at_line(error, line))
        });
    replayed.into_iter().collect()
}

/// The lines of a record, and their hash.
#[derive(Default)]
struct LineWriter {
    text: String,
    hash: LineHash,
}

impl LineWriter {
    fn add(&mut self, line: &str) {
        self.hash.add(line);
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// The record with its last line.
    fn finish(self, secret: &Secret) -> String {
        let last = last_line(secret, self.hash).to_json_line();
        format!("{}{last}\n", self.text)
    }
}

/// The line of a frame without the luck of its shots.
fn without_luck(mut line: Node) -> Node {
    if let Node::Object(entries) = &mut line {
        for (key, value) in entries {
            match value {
                Node::Object(_) if key == "seeds" => value.remove("luck"),
                Node::List(moves) if key == "moves" => {
                    moves.iter_mut().for_each(|played| played.remove("luck"));
                }
                _ => {}
            }
        }
    }
    line
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
