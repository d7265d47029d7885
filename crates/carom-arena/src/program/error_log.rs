//! What a program writes to stderr, up to a limit.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::Path;

/// What is kept of stderr in a frame, bytes. The rest is read and dropped.
const KEPT: usize = 1 << 20;
/// Size above which a file gets no more, bytes.
const LARGEST_FILE: u64 = 64 << 20;
/// Longest last line, characters. It stands in a record.
const LONGEST_LINE: usize = 200;

/// What a program wrote to stderr in one frame.
#[derive(Clone, Debug, Default)]
pub struct ErrorLog {
    kept: Vec<u8>,
    dropped: u64,
}

impl ErrorLog {
    /// Adds what was read.
    pub(super) fn add(&mut self, bytes: &[u8]) {
        let room = KEPT.saturating_sub(self.kept.len()).min(bytes.len());
        self.kept.extend_from_slice(&bytes[..room]);
        self.dropped += (bytes.len() - room) as u64;
    }

    /// All that was written, bytes.
    pub(super) fn size(&self) -> u64 {
        self.kept.len() as u64 + self.dropped
    }

    /// What is kept, as text.
    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.kept).into_owned()
    }

    /// The last line with a printable character.
    pub(super) fn last_line(&self) -> Option<String> {
        let text = self.text();
        let line = text.lines().rev().find(|line| !line.trim().is_empty())?;
        let printable = line.trim().chars().map(|c| if c.is_control() { ' ' } else { c });
        Some(printable.take(LONGEST_LINE).collect())
    }

    /// Appends the log to a file, under a heading, in one write: several frames may use the file.
    ///
    /// # Errors
    /// Those of the file.
    pub fn append_to(&self, path: &Path, heading: &str) -> io::Result<()> {
        if self.kept.is_empty() {
            return Ok(());
        }
        let mut file = OpenOptions::new().create(true).append(true).open(path)?;
        if file.metadata()?.len() > LARGEST_FILE {
            return Ok(());
        }
        let mut block = format!("{heading}:\n").into_bytes();
        block.extend_from_slice(&self.kept);
        if !block.ends_with(b"\n") {
            block.push(b'\n');
        }
        if self.dropped > 0 {
            block.extend(format!("({} more bytes were dropped)\n", self.dropped).bytes());
        }
        file.write_all(&block)
    }
}

#[cfg(test)]
mod tests {
    use super::{ErrorLog, KEPT};

    #[test]
    fn a_flood_is_cut_off_and_counted() {
        let mut log = ErrorLog::default();
        for _ in 0..40 {
            log.add(&[b'x'; 1 << 16]);
        }
        assert_eq!((log.kept.len(), log.size()), (KEPT, 40 << 16));
    }

    #[test]
    fn the_last_line_is_the_last_with_text() {
        let mut log = ErrorLog::default();
        assert_eq!(log.last_line(), None);
        log.add(b"Traceback\n  ValueError:\tno \x1b[31m\n\n  \n");
        assert_eq!(log.last_line().as_deref(), Some("ValueError: no  [31m"));
    }
}
