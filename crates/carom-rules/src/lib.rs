//! The games of billiards as state machines over the outcome of a shot.
//!
//! A [`Frame`] is one rack, frame or match between two players. It says what is asked next and of
//! whom ([`Frame::request`]): a shot or a choice. A player answers with a [`Play`] or a [`Choice`], and
//! gets a [`Ruling`]: which fouls, by which rule, what was scored and spotted. The frame then asks
//! again, until it is over. Nothing is hidden in it: it can be cloned, so that a program can try a shot
//! and go back.
//!
//! ```
//! use carom::resolve::cue_ball::Strike;
//! use carom_rules::{Frame, Options, Play, Request, Rules};
//!
//! # fn main() -> Result<(), carom::Error> {
//! let mut frame = Frame::new(Rules::NineBall, Options::default(), None, None, 7)?;
//! let azimuth = std::f64::consts::FRAC_PI_2;
//! let strike = Strike { speed: 8.0, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
//! let (ruling, outcome) =
//!     frame.play(&Play { cue_ball: Some([0.635, 0.6]), ..Play::new(strike) })?;
//! println!("fouls: {:?}, pocketed: {:?}", ruling.fouls, outcome.pocketed);
//! assert!(matches!(frame.request(), Request::Shot(_)));
//! # Ok(())
//! # }
//! ```
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
