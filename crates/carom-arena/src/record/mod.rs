//! The record of a match, `carom-match/1`: JSON, one value on each line.
//!
//! The first line is the header ([`MatchHeader`]), then follows a line for each frame in order, and
//! the last line has the secret. docs/arena.md lists every key.

mod frame_line;
mod header;
mod values;

use carom::Error;
use carom::format::{Node, Reader};

use crate::secret::{LineHash, Secret};

pub(crate) use frame_line::{
    Recorded, frame_line, frame_number, frame_points, read_execution, read_moves,
};
pub use header::MatchHeader;
pub(crate) use header::{clock_node, disclosure_node, read_agreement};
pub(crate) use values::{place, read_play, strike};

/// The format's name, `format` of the header.
pub const MATCH_FORMAT: &str = "carom-match/1";

/// The program that writes records, with its version.
pub(crate) const ENGINE: &str = carom::trace::ENGINE;

/// The last line of a record: the secret, and the hash of the lines before.
pub(crate) fn last_line(secret: &Secret, lines: LineHash) -> Node {
    Node::object([("secret", secret.to_hex().into()), ("sha256", lines.finish().into())])
}

/// The secret and the hash of the lines before, from the last line of a record.
pub(crate) fn read_last_line(node: &Node) -> Result<(Secret, String), Error> {
    let line = Reader::new(node, "");
    let secret = line.require("secret", "the secret of the match")?.text("64 digits")?;
    let sha256 = line.require("sha256", "the hash of the lines before")?.text("64 digits")?;
    Ok((Secret::parse(secret)?, sha256.into()))
}

/// The value on line `number` (from 1) of a record.
pub(crate) fn read_line(text: &str, number: u64) -> Result<Node, Error> {
    Node::from_json(text).map_err(|error| at_line(error, number))
}

/// The error with its place on line `number` (from 1) of a record.
pub(crate) fn at_line(error: Error, number: u64) -> Error {
    match error {
        Error::Input(mut e) => {
            let comma = if e.place.is_empty() { "" } else { ", " };
            e.place = format!("line {number}{comma}{}", e.place);
            // The JSON text of a line is always on its own line 1.
            e.what = e.what.replace("(line 1, column", "(column");
            Error::Input(e)
        }
        other => other,
    }
}
