//! The games of billiards as state machines over the outcome of a shot.
//!
//! A [`Frame`] is one rack, frame or match between two players. It says what is asked next and of
//! whom ([`Frame::request`]): a shot or a choice. A player answers with a [`Play`] or a [`Choice`], and
//! gets a [`Ruling`]: which fouls, by which rule, what was scored and spotted. The frame then asks
//! again, until it is over. Nothing is hidden in it: it can be cloned, so that a program can try a shot
//! and go back.
//!
//! Each game is a file of [`games`]. A foul names the rule that forbids it ([`Rules::rule`]); the page
//! "Rules of the games" in the documentation says which rule books were read.

mod facts;
mod frame;
pub mod games;
mod layout;
mod play;
mod pool;
mod report;
mod request;
mod ruling;
#[cfg(test)]
mod scenarios;

pub use facts::{Facts, Touch};
pub use frame::Frame;
pub use games::{Options, Rules};
pub use layout::{Layout, Piece};
pub use play::{Call, Play};
pub use request::{Calls, Choice, Region, Request, Turn};
pub use ruling::{Foul, Fouls, Ruling};

/// One of the two players: 0 begins.
pub type Player = usize;

/// A ball by its number in the frame's [`Layout`]. In games with numbered balls the cue ball is 0 and
/// every other ball has its number.
pub type BallIndex = u8;
