//! What a program writes to stderr, up to a limit.

/// What is kept of stderr in a frame, bytes: a thousand lines. The rest is read and dropped.
const KEPT: usize = 1 << 16;
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

    /// The log under a heading, for a file that several frames share; `None` if nothing was written.
    pub fn block(&self, heading: &str) -> Option<String> {
        if self.kept.is_empty() {
            return None;
        }
        let mut block = format!("{heading}:\n{}", self.text());
        if !block.ends_with('\n') {
            block.push('\n');
        }
        if self.dropped > 0 {
            block.push_str(&format!("({} more bytes were dropped)\n", self.dropped));
        }
        Some(block)
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
        let block = log.block("frame 3").unwrap();
        assert!(block.starts_with("frame 3:\nxxx"));
        assert!(block.ends_with("x\n(2555904 more bytes were dropped)\n"));
        assert_eq!(ErrorLog::default().block("frame 3"), None);
    }

    #[test]
    fn the_last_line_is_the_last_with_text() {
        let mut log = ErrorLog::default();
        assert_eq!(log.last_line(), None);
        log.add(b"Traceback\n  ValueError:\tno \x1b[31m\n\n  \n");
        assert_eq!(log.last_line().as_deref(), Some("ValueError: no  [31m"));
    }
}
