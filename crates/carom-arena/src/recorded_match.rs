//! A record as viewers read it: its frames one by one, each as the record of a game.
//!
//! Nothing is played here, so that a long match opens at once. [`replay`](crate::replay()) plays a
//! record again.

use std::sync::Arc;

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};
use carom_rules::{FRAME_FORMAT, Frame, through_degrees};

use crate::record::{
    MatchHeader, at_line, frame_number, frame_points, read_execution, read_last_line, read_line,
    read_moves, read_play,
};
use crate::secret::LineHash;
use crate::settings::Match;

/// A record of a match that is finished (`match.jsonl`), or that goes on (`played.jsonl`).
#[derive(Clone, Debug)]
pub struct RecordedMatch {
    header: MatchHeader,
    /// The header as it is written.
    header_node: Node,
    frames: Vec<RecordedFrame>,
    is_finished: bool,
}

/// The line of a frame.
#[derive(Clone, Debug)]
struct RecordedFrame {
    number: u64,
    /// The number of its line in the record, from 1.
    line: u64,
    node: Node,
}

impl RecordedMatch {
    /// Reads a record. Its frames may stand in any order, and some may be missing. An incomplete
    /// last line is passed over: the frame is being written.
    ///
    /// # Errors
    /// [`Error::Input`] with the line and the key of a damaged value, and if the hash on the last
    /// line is not that of the lines before it.
    pub fn read(text: &str) -> Result<Self, Error> {
        let lines: Vec<&str> = text.lines().collect();
        let (Some(first), rest) = (lines.first(), lines.get(1..).unwrap_or_default()) else {
            let remedy = "give the match.jsonl of a match";
            return Err(ErrorKind::Syntax.at("line 1", "the record is empty", remedy));
        };
        let header_node = read_line(first, 1)?;
        let header = MatchHeader::from_node(&header_node).map_err(|error| at_line(error, 1))?;
        let (mut frames, mut is_finished) = (Vec::with_capacity(rest.len()), false);
        for (line, written) in (2..).zip(rest) {
            let is_last = line == lines.len() as u64;
            let node = match read_line(written, line) {
                Err(_) if is_last && !text.ends_with('\n') => break,
                read => read?,
            };
            if is_last && node.get("secret").is_some() {
                check_end(&header, &lines, &node).map_err(|error| at_line(error, line))?;
                is_finished = true;
                break;
            }
            let number = check_frame(&header.of, &node).map_err(|error| at_line(error, line))?;
            frames.push(RecordedFrame { number, line, node });
        }
        frames.sort_by_key(|frame| frame.number);
        let twice = frames.windows(2).find(|two| two[0].number == two[1].number);
        if let Some([_, RecordedFrame { number, line, .. }]) = twice {
            let what = format!("frame {number} is there twice");
            let error = ErrorKind::Duplicate.at("frame", what, "remove one of the lines");
            return Err(at_line(error, *line));
        }
        Ok(Self { header, header_node, frames, is_finished })
    }

    /// The settings of the match.
    pub const fn header(&self) -> &MatchHeader {
        &self.header
    }

    /// The header as it is written.
    pub const fn header_node(&self) -> &Node {
        &self.header_node
    }

    /// Whether the record has the last line, which is written when the match ends.
    pub const fn is_finished(&self) -> bool {
        self.is_finished
    }

    /// The lines of the frames, without their moves and seeds: `frame`, `seats`, `shots` (number
    /// of executed shots), `scores` and `end`.
    pub fn frames(&self) -> Vec<Node> {
        let summary = |frame: &RecordedFrame| {
            let of = |key: &str| Node::from(frame.node.get(key).cloned());
            let shots = frame.moves().iter().filter(|made| made.get("executed").is_some()).count();
            Node::object([
                ("frame", of("frame")),
                ("seats", of("seats")),
                ("shots", Node::Integer(shots as i64)),
                ("scores", of("scores")),
                ("end", of("end")),
            ])
        };
        self.frames.iter().map(summary).collect()
    }

    /// Frame number `number` as a game: `record`, a `carom-frame/1` with the executed shots, and
    /// `moves`, the moves of the match as they are written. A move that the game has too gets the
    /// key `index`, its index there. A refused or late answer is not a move of the game, and so is a
    /// shot that reached the cap of events.
    ///
    /// # Errors
    /// [`Error::Input`] if the record has no such frame, and with the line and the key of a damaged
    /// value.
    pub fn game(&self, number: u64) -> Result<Node, Error> {
        let Some(frame) = self.frames.iter().find(|frame| frame.number == number) else {
            let what = format!("the record has no frame {number}");
            return Err(ErrorKind::OutOfRange.at("frame", what, "choose one that it has"));
        };
        frame.game(&self.header).map_err(|error| at_line(error, frame.line))
    }
}

impl RecordedFrame {
    fn moves(&self) -> &[Node] {
        match self.node.get("moves") {
            Some(Node::List(moves)) => moves,
            _ => &[],
        }
    }

    fn game(&self, header: &MatchHeader) -> Result<Node, Error> {
        let at = Reader::new(&self.node, "");
        let seeds = at.require("seeds", "the seeds of the frame, an object")?;
        let seed = seeds.require("rack", "16 hexadecimal digits")?;
        let of = header.of.settings();
        let mut setup = Node::object([("game", of.game.name().into())]);
        for (key, value) in fields(&header.of.recorded_setup()) {
            setup.set(key, value.clone());
        }
        setup.set("seed", seed.node().clone());
        for (key, value) in fields(&of.options.to_node()) {
            setup.set(key, value.clone());
        }
        let (mut made, mut moves) = (Vec::new(), Vec::new());
        for at in at.require("moves", "the list of moves")?.items("the list of moves")? {
            let mut annotated = at.node().clone();
            if let Some(here) = move_of_game(header.of.start(), &at)? {
                annotated.set("index", Node::Integer(made.len() as i64));
                made.push(here);
            }
            moves.push(annotated);
        }
        let record = Node::object([
            ("format", FRAME_FORMAT.into()),
            ("engine", (&header.engine).into()),
            ("setup", setup),
            ("moves", Node::List(made)),
        ]);
        Ok(Node::object([("record", record), ("moves", Node::List(moves))]))
    }
}

/// The move in the form of a record of a frame; `None` if it did not change the game.
fn move_of_game(start: &Frame, at: &Reader<'_>) -> Result<Option<Node>, Error> {
    let not_made = ["capped", "refused", "late", "failed"];
    if not_made.iter().any(|key| at.get(key).is_some()) {
        return Ok(None);
    }
    if let Some(choice) = at.get("choice") {
        return Ok(Some(Node::object([("choice", choice.node().clone())])));
    }
    if at.get("concede").is_some() {
        return Ok(Some(Node::object([("concede", true.into())])));
    }
    let executed = read_execution(&at.require("executed", "the executed shot, an object")?)?;
    // The arena plays the strike after this conversion, which a game would not repeat.
    let strike = through_degrees(&executed.strike);
    let numbers = [
        ("speed", strike.speed),
        ("azimuth", strike.azimuth),
        ("elevation", strike.elevation),
        ("side", strike.side),
        ("height", strike.height),
    ];
    let strike = Node::object(numbers.map(|(key, value)| (key, Node::from(value))));
    let mut play = Node::object([("strike", strike)]);
    if let Some(place) = executed.cue_ball {
        play.set("cue_ball", Node::list(place));
    }
    let intended = at.require("play", "the intended shot, an object")?;
    if let Some(call) = intended.get("call") {
        let mut here = Node::object([]);
        for (key, value) in fields(call.node()) {
            here.set(if key == "pocket" { "into" } else { key }, value.clone());
        }
        play.set("call", here);
    }
    if !executed.cling.is_empty() {
        play.set("cling", executed.cling.to_node());
    }
    // A call may name a ball that the game does not have.
    read_play(start, &intended)?;
    Ok(Some(Node::object([("play", play)])))
}

/// The keys and values of an object.
fn fields(node: &Node) -> &[(String, Node)] {
    match node {
        Node::Object(fields) => fields,
        _ => &[],
    }
}

/// Checks the line of a frame, and returns the frame's number.
fn check_frame(of: &Arc<Match>, node: &Node) -> Result<u64, Error> {
    let number = frame_number(node)?;
    let at = Reader::new(node, "");
    let seats = at.require("seats", "the players of the seats")?;
    let expected = of.seats(number).map(|player| Node::Integer(player as i64));
    if *seats.node() != Node::List(expected.to_vec()) {
        let what = format!("frame {number} has other seats");
        return Err(seats.refuse(ErrorKind::Mismatch, what, "give the record as it was written"));
    }
    at.require("scores", "the score of each seat")?.items("a list of two numbers")?;
    read_moves(of.start(), &at)?;
    frame_points(node)?;
    Ok(number)
}

/// Checks the last line of a record.
fn check_end(header: &MatchHeader, lines: &[&str], node: &Node) -> Result<(), Error> {
    let (secret, sha256) = read_last_line(node)?;
    let remedy = "give the record as it was written";
    if secret.sha256() != header.secret_sha256 {
        let what = "it is not the secret whose SHA-256 is in the header";
        return Err(ErrorKind::Mismatch.at("secret", what, remedy));
    }
    let mut hash = LineHash::default();
    lines[..lines.len() - 1].iter().for_each(|line| hash.add(line));
    if hash.finish() != sha256 {
        let what = "it is not the hash of the lines before: the record was changed";
        return Err(ErrorKind::Changed.at("sha256", what, remedy));
    }
    Ok(())
}
