//! The formats of carom's files, and the error for a file of another kind than was asked for.

use alloc::format;

use super::read::At;
use super::{SHOT_FORMAT, TRACE_FORMAT};
use crate::error::{Error, ErrorKind};

/// Each format with what its file is, and what reads it.
const KINDS: [(&str, &str, &str); 6] = [
    (SHOT_FORMAT, "a shot", "`carom shot FILE --json` prints its trace, and Shot.load reads it"),
    (
        TRACE_FORMAT,
        "a trace",
        "`carom replay` and `carom play` read it, and Trace.load, which has its shot",
    ),
    ("carom-frame/1", "the record of a frame", "`carom think` and Frame.replay read it"),
    ("carom-sweep/1", "the spec of a sweep", "`carom sweep` and Sweep.load read it"),
    ("carom-match/1", "the record of a match", "`carom match --replay` reads it"),
    ("carom-study/1", "a study", "`carom study check` and Study.load read it"),
];

impl At<'_> {
    /// Checks the format of a file.
    pub(crate) fn format(&self, expected: &'static str) -> Result<(), Error> {
        let found = self.text(&format!("\"{expected}\""))?;
        if found == expected {
            return Ok(());
        }
        match KINDS.iter().find(|(format, ..)| *format == found) {
            Some((_, what, reader)) => Err(self.refuse(
                ErrorKind::Format,
                format!("the file is {what}, \"{found}\", but \"{expected}\" is needed"),
                *reader,
            )),
            None => Err(self.unknown_word(found, "format", &[expected])),
        }
    }
}
