//! The folder of a match: what was played is there at any time, and nothing is played twice.
//!
//! While the match goes on, the folder has two files. `secret` holds the secret. `played.jsonl` holds
//! the header of the record and the frames, in the order in which they ended: both frames of a pair
//! are written at once, at the end of the file. When all pairs are there, `match.jsonl` is
//! written, the record with the frames in order, and the two other files are removed.
//!
//! An incomplete line at the end of `played.jsonl`, from a program that was ended while it wrote, is
//! cut off; its pair is played again.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use carom::format::Node;
use carom::{Error, ErrorKind};

use crate::error::ArenaError;
use crate::hold::Hold;
use crate::pair::PlayedPair;
use crate::record::{at_line, frame_number, frame_points, last_line, read_last_line, read_line};
use crate::score::FramePoints;
use crate::secret::{LineHash, Secret};

/// The record of the finished match, in its folder.
pub const RECORD: &str = "match.jsonl";
const PLAYED: &str = "played.jsonl";
const SECRET: &str = "secret";
/// The record while it is written.
const UNFINISHED: &str = "match.jsonl.part";

/// A pair in `played.jsonl`.
struct WrittenPair {
    /// Place of its two lines in the file, bytes.
    start: u64,
    length: u64,
    points: [FramePoints; 2],
}

/// The folder of a match.
pub(crate) struct Ledger {
    folder: PathBuf,
    secret: Secret,
    header: String,
    state: LedgerState,
}

enum LedgerState {
    /// The record is complete: the points of its frames.
    Finished(Vec<[FramePoints; 2]>),
    /// The pairs that were played, by their numbers, and the file that holds them.
    Open { file: File, end: u64, pairs: BTreeMap<u64, WrittenPair>, _hold: Hold },
}

impl Ledger {
    /// The secret of the match in `folder`; `None` if no match was begun there. A finished match
    /// has its secret in the record.
    pub(crate) fn secret_in(folder: &Path) -> Result<Option<Secret>, ArenaError> {
        let of_record = |text: String| {
            let last = text.lines().last().unwrap_or_default();
            let number = text.lines().count() as u64;
            let node = read_line(last, number)?;
            let read = read_last_line(&node).map_err(|error| at_line(error, number))?;
            Ok::<_, Error>(read.0)
        };
        if let Some(text) = read_if_there(&folder.join(RECORD))? {
            return Ok(Some(of_record(text).map_err(in_folder(folder, RECORD))?));
        }
        match read_if_there(&folder.join(SECRET))? {
            Some(text) => {
                Ok(Some(Secret::parse(text.trim_end()).map_err(in_folder(folder, SECRET))?))
            }
            None => Ok(None),
        }
    }

    /// Opens the match with this secret and this header line in `folder`, or begins it.
    ///
    /// # Errors
    /// [`ArenaError::Input`] at `folder` if it has another match, and with the line for a damaged
    /// file; [`ArenaError::File`] if a file cannot be read or written.
    pub(crate) fn open(folder: &Path, secret: Secret, header: &Node) -> Result<Self, ArenaError> {
        let header = header.to_json_line();
        fs::create_dir_all(folder).map_err(ArenaError::file(folder))?;
        let record = folder.join(RECORD);
        // The lock comes before the look at the other files: two programs may begin at once. The
        // record may have been written while this one waited to open the file.
        let played = if record.exists() { None } else { Some(open_locked(&folder.join(PLAYED))?) };
        let state = match played {
            Some((file, hold)) if !record.exists() => {
                write_new(&folder.join(SECRET), &format!("{}\n", secret.to_hex()))?;
                begin_or_continue(file, hold, &folder.join(PLAYED), &header)?
            }
            _ => {
                let points = finished_points(folder, &header)?;
                // A program that was ended just after it wrote the record has left these.
                remove_working_files(folder)?;
                LedgerState::Finished(points)
            }
        };
        Ok(Self { folder: folder.into(), secret, header, state })
    }

    /// The pairs of a finished match, in order; `None` if it goes on.
    pub(crate) fn finished(&self) -> Option<&[[FramePoints; 2]]> {
        match &self.state {
            LedgerState::Finished(pairs) => Some(pairs),
            LedgerState::Open { .. } => None,
        }
    }

    /// The points of pair `pair`, if it was played.
    pub(crate) fn points(&self, pair: u64) -> Option<[FramePoints; 2]> {
        match &self.state {
            LedgerState::Finished(pairs) => pairs.get(usize::try_from(pair).ok()?).copied(),
            LedgerState::Open { pairs, .. } => pairs.get(&pair).map(|played| played.points),
        }
    }

    /// Number of pairs that were played.
    pub(crate) fn len(&self) -> u64 {
        match &self.state {
            LedgerState::Finished(pairs) => pairs.len() as u64,
            LedgerState::Open { pairs, .. } => pairs.len() as u64,
        }
    }

    /// Adds a pair that was played.
    pub(crate) fn add(&mut self, pair: &PlayedPair) -> Result<(), ArenaError> {
        let LedgerState::Open { file, end, pairs, .. } = &mut self.state else { return Ok(()) };
        let [one, other] = pair.lines();
        let text = format!("{one}\n{other}\n");
        let path = self.folder.join(PLAYED);
        file.write_all(text.as_bytes()).map_err(ArenaError::file(&path))?;
        let length = text.len() as u64;
        pairs.insert(pair.number(), WrittenPair { start: *end, length, points: pair.points() });
        *end += length;
        Ok(())
    }

    /// Writes the record of the first `count` pairs, which must be there, and removes the other
    /// files.
    pub(crate) fn finish(&mut self, count: u64) -> Result<(), ArenaError> {
        let LedgerState::Open { file, pairs, .. } = &mut self.state else { return Ok(()) };
        let part = self.folder.join(UNFINISHED);
        let played = self.folder.join(PLAYED);
        let at_part = || ArenaError::file(&part);
        let mut out = BufWriter::new(File::create(&part).map_err(at_part())?);
        let mut hash = LineHash::default();
        let mut write = |text: &str, out: &mut BufWriter<File>| {
            text.lines().for_each(|line| hash.add(line));
            out.write_all(text.as_bytes())
        };
        write(&format!("{}\n", self.header), &mut out).map_err(at_part())?;
        let mut points = Vec::new();
        for (_, pair) in pairs.range(..count) {
            let mut text = vec![0; pair.length as usize];
            file.seek(SeekFrom::Start(pair.start)).map_err(ArenaError::file(&played))?;
            file.read_exact(&mut text).map_err(ArenaError::file(&played))?;
            let text = String::from_utf8_lossy(&text);
            write(&text, &mut out).map_err(at_part())?;
            points.push(pair.points);
        }
        let last = last_line(&self.secret, hash).to_json_line();
        writeln!(out, "{last}").map_err(at_part())?;
        let out = out.into_inner().map_err(|e| at_part()(e.into_error()))?;
        out.sync_all().map_err(at_part())?;
        let record = self.folder.join(RECORD);
        fs::rename(&part, &record).map_err(ArenaError::file(&record))?;
        remove_working_files(&self.folder)?;
        self.state = LedgerState::Finished(points);
        Ok(())
    }
}

/// Removes the files that are needed only while the match goes on.
fn remove_working_files(folder: &Path) -> Result<(), ArenaError> {
    for name in [PLAYED, SECRET] {
        let path = folder.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(ArenaError::file(&path)(error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// The text of a file; `None` if there is no such file.
fn read_if_there(path: &Path) -> Result<Option<String>, ArenaError> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ArenaError::file(path)(error)),
    }
}

/// Writes a file unless it is there, in one step: it is complete or absent.
fn write_new(path: &Path, text: &str) -> Result<(), ArenaError> {
    if path.exists() {
        return Ok(());
    }
    let part = path.with_extension("part");
    fs::write(&part, text).map_err(ArenaError::file(&part))?;
    fs::rename(&part, path).map_err(ArenaError::file(path))
}

/// An error in the file `name`, with its place.
fn in_folder(folder: &Path, name: &str) -> impl Fn(Error) -> ArenaError {
    let path = folder.join(name).display().to_string();
    move |error| match error {
        Error::Input(mut e) => {
            let comma = if e.place.is_empty() { "" } else { ", " };
            e.place = format!("{path}{comma}{}", e.place);
            ArenaError::Input(Error::Input(e))
        }
        other => ArenaError::Input(other),
    }
}

/// Rejects a folder with the header of another match.
fn check_header(found: &str, expected: &str) -> Result<(), Error> {
    if found == expected {
        return Ok(());
    }
    let what = "it has another match, or this one from another version of the engine";
    Err(ErrorKind::Mismatch.at(
        "folder",
        what,
        "choose an empty folder, or the settings of that match",
    ))
}

/// The points of the pairs of the finished record in `folder`.
fn finished_points(folder: &Path, header: &str) -> Result<Vec<[FramePoints; 2]>, ArenaError> {
    let text = read_if_there(&folder.join(RECORD))?.unwrap_or_default();
    let lines: Vec<&str> = text.lines().collect();
    check_header(lines.first().unwrap_or(&""), header)?;
    let frames = lines.get(1..lines.len() - 1).unwrap_or_default();
    let points = (2..).zip(frames).map(|(number, line)| {
        let node = read_line(line, number)?;
        frame_points(&node).map_err(|error| at_line(error, number))
    });
    let points = points.collect::<Result<Vec<_>, _>>().map_err(in_folder(folder, RECORD))?;
    Ok(points.as_chunks().0.to_vec())
}

/// Opens the file, which is made if it is missing and never replaced, and locks it: two programs
/// that write it would destroy it.
fn open_locked(path: &Path) -> Result<(File, Hold), ArenaError> {
    let open = OpenOptions::new().read(true).append(true).create(true).open(path);
    let file = open.map_err(ArenaError::file(path))?;
    let hold = Hold::lock(&file, path)?;
    Ok((file, hold))
}

/// Reads `played.jsonl`, or begins it with the header.
fn begin_or_continue(
    mut file: File,
    hold: Hold,
    path: &Path,
    header: &str,
) -> Result<LedgerState, ArenaError> {
    if !has_line(&file).map_err(ArenaError::file(path))? {
        file.set_len(0).map_err(ArenaError::file(path))?;
        file.write_all(format!("{header}\n").as_bytes()).map_err(ArenaError::file(path))?;
    }
    file.rewind().map_err(ArenaError::file(path))?;
    let (pairs, end) = read_played(&file, path, header)?;
    // What follows is the incomplete rest of a pair.
    file.set_len(end).map_err(ArenaError::file(path))?;
    Ok(LedgerState::Open { file, end, pairs, _hold: hold })
}

/// Whether the first line is complete.
fn has_line(file: &File) -> std::io::Result<bool> {
    let mut line = Vec::new();
    BufReader::new(file).read_until(b'\n', &mut line)?;
    Ok(line.ends_with(b"\n"))
}

/// The complete pairs of `played.jsonl`, and the end of the last one, bytes.
fn read_played(
    file: &File,
    path: &Path,
    header: &str,
) -> Result<(BTreeMap<u64, WrittenPair>, u64), ArenaError> {
    let in_file = |error| in_folder(path.parent().unwrap_or(path), PLAYED)(error);
    let mut reader = BufReader::new(file);
    let mut bytes = Vec::new();
    let mut next_line = |line: &mut String| {
        bytes.clear();
        let length = reader.read_until(b'\n', &mut bytes).map_err(ArenaError::file(path))?;
        *line = String::from_utf8_lossy(&bytes).into_owned();
        Ok::<_, ArenaError>(if line.ends_with('\n') { length as u64 } else { 0 })
    };
    let mut line = String::new();
    let mut end = next_line(&mut line)?;
    check_header(line.trim_end(), header)?;
    let mut pairs = BTreeMap::new();
    let mut first: Option<(Node, u64)> = None;
    for number in 2.. {
        let length = next_line(&mut line)?;
        if length == 0 {
            break;
        }
        let node = read_line(&line, number).map_err(in_file)?;
        let Some((before, length_before)) = first.take() else {
            first = Some((node, length));
            continue;
        };
        let read = || {
            let [one, other] = [frame_number(&before)?, frame_number(&node)?];
            if one % 2 != 0 || other != one + 1 {
                let what = format!("frame {other} does not belong to frame {one} before it");
                return Err(ErrorKind::Mismatch.at(
                    "frame",
                    what,
                    "remove the file, to play from the start",
                ));
            }
            Ok((one / 2, [frame_points(&before)?, frame_points(&node)?]))
        };
        let (pair, points) = read().map_err(|error| in_file(at_line(error, number)))?;
        let length = length_before + length;
        pairs.insert(pair, WrittenPair { start: end, length, points });
        end += length;
    }
    Ok((pairs, end))
}
