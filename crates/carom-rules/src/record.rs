//! Records of frames, `carom-frame/1`: the start of a frame and all its moves.
//!
//! Python and JavaScript build the frame and play its moves. Both check the record here first, so that one is
//! as strict as the other.

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};

/// The format of a record.
pub const FRAME_FORMAT: &str = "carom-frame/1";

/// What to do with a record that cannot be read.
const REMEDY: &str = "give the value of Frame.record";

/// The keys of a setup: the arguments of a new frame, or of one from the balls of a shot. `target` is the
/// name of `points` in older records.
const NEW: &[&str] = &["game", "table", "physics", "seed", "points", "target", "miss", "patience"];
const OF_SHOT: &[&str] = &["game", "shot", "player", "points", "target", "miss", "patience"];

/// The keys of a move. `variations` is a text of the page's analysis, which frames pass over.
const PLAY: &[&str] = &["play", "variations"];
const CHOICE: &[&str] = &["choice"];
const CONCEDE: &[&str] = &["concede"];

/// Checks the keys of a record and the types of its parts. Their values are checked where the frame is built
/// and its moves are played.
///
/// # Errors
/// [`Error::Input`] that names the place.
pub fn check_record(record: &Node) -> Result<(), Error> {
    let root = Reader::new(record, "");
    if !matches!(record.get("format"), Some(Node::Text(format)) if format.as_str() == FRAME_FORMAT)
    {
        let what = format!("not a record of a frame, \"{FRAME_FORMAT}\"");
        return Err(ErrorKind::Format.at("format", what, REMEDY));
    }
    let (Some(setup), Some(moves)) = (root.get("setup"), root.get("moves")) else {
        let what = "setup or moves is missing or has a wrong type";
        return Err(ErrorKind::Missing.at("record", what, REMEDY));
    };
    setup.keys(if setup.get("shot").is_some() { OF_SHOT } else { NEW })?;
    setup.require("game", "\"nine-ball\"")?;
    for made in moves.items("a list of moves")? {
        check_move(&made)?;
    }
    Ok(())
}

fn check_move(made: &Reader<'_>) -> Result<(), Error> {
    if let Some(play) = made.get("play") {
        made.keys(PLAY)?;
        play.keys(&["strike", "cue_ball", "call", "cling"])?;
        return play.get("call").map_or(Ok(()), |call| call.keys(&["kind", "ball", "into"]));
    }
    if made.get("choice").is_some() {
        return made.keys(CHOICE);
    }
    if made.get("concede").is_some_and(|concede| *concede.node() == Node::Bool(true)) {
        return made.keys(CONCEDE);
    }
    Err(ErrorKind::NotAMove.at(made.place(), "not a play, a choice or a concession", REMEDY))
}
