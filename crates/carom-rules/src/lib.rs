//! The games of billiards as state machines over the outcomes of shots.
//!
//! A [`Frame`] is one rack, frame or match between two players. [`Frame::request`] returns the next
//! request: a shot or a choice, and the seat that it is addressed to. The answer is a [`Play`]
//! ([`Frame::play`]) or a [`Choice`] ([`Frame::choose`]). Each answer gives a [`Ruling`]: the fouls
//! with the rules that forbid them, the points, and the balls that were spotted. A new request
//! follows, until the frame is over. A frame has no hidden state and can be cloned, so a program
//! can try a shot on a copy.
//!
//! ```
//! use carom::resolve::cue_ball::Strike;
//! use carom_rules::{Frame, Options, Play, Request, Game};
//!
//! # fn main() -> Result<(), carom::Error> {
//! let mut frame = Frame::new(Game::NineBall, Options::default(), None, None, 7)?;
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
//! Each game is a file of [`games`], with its [`GameFacts`]. [`GameFacts::rule`] gives the rule that forbids a foul; the
//! documentation's page "Rules of the games" lists the rule books.

mod answer;
mod carom_way;
mod describe;
mod execution;
mod frame;
pub mod games;
mod history;
mod layout;
mod markings;
mod options;
mod plain_play;
mod play;
mod record;
mod referee;
mod region;
mod report;
mod request;
mod ruling;
mod seat;
mod short_list;
mod state;
mod state_bytes;

// They rule on outcomes that no shot gave, which only this crate can do.
#[cfg(test)]
#[path = "../tests/scenarios/mod.rs"]
mod scenarios;

pub use answer::play_schema;
pub use carom::rack::Game;
pub use carom_way::{CaromCount, CaromWay};
pub use execution::{ErrorDraw, ErrorSeeds, execute};
pub use frame::{Frame, FrameSimulator, Prepared, recorded_setup};
pub use games::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
pub use history::FrameHistory;
pub use layout::{BallIndex, BallList, FrameBall, FrameLayout, MOST_BALLS};
pub use options::Options;
pub use play::{Call, Play, through_degrees};
pub use record::{FRAME_FORMAT, check_record};
pub use region::Region;
pub use request::{Calls, Choice, Choices, Request, Turn};

pub use ruling::{Foul, Fouls, Ruling};
pub use seat::Seat;
pub use short_list::ShortList;
pub use state_bytes::StateBytes;
