//! Lines to and from a program: what the protocol needs from its transport.

use std::time::Instant;

use crate::moves::EndReason;

/// Longest line that a program may write, bytes: a hundred times a request with a menu and a schema.
/// A longer line loses the frame, so that no program fills the referee's memory.
pub const LONGEST_LINE: usize = 1 << 20;

/// Lines to and from a program.
pub trait LineChannel: Send {
    /// Writes a line, given without its end, until `deadline` if there is one.
    ///
    /// # Errors
    /// The reason for which the line was not written.
    fn send(&mut self, line: &str, deadline: Option<Instant>) -> Result<(), ChannelFault>;

    /// The next line of the program, without its end.
    ///
    /// # Errors
    /// The reason for which there is none. After [`ChannelFault::NotUtf8`] the channel goes on with
    /// the next line.
    fn receive(&mut self, deadline: Option<Instant>) -> Result<String, ChannelFault>;
}

/// Why a program gave no line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChannelFault {
    /// The deadline has passed.
    TimeOver,
    /// The program does not answer although its clock goes on.
    Stall,
    /// The program ended: how, in words.
    Crash(String),
    /// The program wrote more than the referee reads.
    Flood,
    /// The program wrote a line that is too long.
    LongLine,
    /// The line is not UTF-8. It counts as a refused answer.
    NotUtf8,
    /// The referee was stopped, for example by Ctrl-C.
    Stopped,
}

impl ChannelFault {
    /// The reason of the lost frame, and the same in words. `None` if the frame goes on: the line is
    /// refused, or the match stops.
    pub fn loss(&self) -> Option<(EndReason, String)> {
        let (reason, why) = match self {
            Self::TimeOver => (EndReason::TimeOver, "the player's time was over"),
            Self::Stall => (EndReason::Stall, "the program did not answer"),
            Self::Crash(why) => (EndReason::Crash, why.as_str()),
            Self::Flood => (EndReason::Flood, "the program wrote more than the referee reads"),
            Self::LongLine => (EndReason::LongLine, "the program wrote a line that is too long"),
            Self::NotUtf8 | Self::Stopped => return None,
        };
        Some((reason, why.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::ChannelFault;
    use crate::moves::EndReason;

    #[test]
    fn a_crash_keeps_its_words_and_a_line_that_is_not_utf_8_loses_no_frame() {
        let crash = ChannelFault::Crash("it ended with status 3".into());
        assert_eq!(crash.loss(), Some((EndReason::Crash, "it ended with status 3".into())));
        assert_eq!(ChannelFault::NotUtf8.loss(), None);
    }
}
