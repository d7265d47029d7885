//! **carom** — a billiards engine: event-driven, exact to rounding, and deterministic.
//!
//! Between events every ball follows a closed-form path. The time of the next event is computed
//! from the paths' equations, without time steps (Leckie & Greenspan 2006). Units are SI and
//! radians.
//!
#![cfg_attr(feature = "json", doc = "```")]
#![cfg_attr(not(feature = "json"), doc = "```ignore")]
//! use carom::Shot;
//!
//! # fn main() -> Result<(), carom::Error> {
//! let shot = Shot::from_json(
//!     r#"{
//!         "format": "carom-shot/1",
//!         "table": "wpa-9ft",
//!         "balls": [
//!             {"id": "cue", "position": [0.45, 0.75]},
//!             {"id": "8", "position": [0.80, 1.45]}
//!         ],
//!         "strike": {
//!             "ball": "cue", "speed": 1.84, "azimuth_deg": 62.92, "side": 0.07, "height": -0.23
//!         }
//!     }"#,
//! )?;
//! let trace = shot.simulate()?;
//! let [(ball, pocket)] = trace.outcome().pocketed[..] else { panic!("one ball falls") };
//! assert_eq!((shot.balls()[usize::from(ball)].id.as_str(), pocket.name()), ("8", "top-right"));
//! let quarter = trace.at(0.25)?; // every ball's exact state after 0.25 s
//! assert!(quarter[0].velocity.length() < 1.84 * 1.5);
//! # Ok(())
//! # }
//! ```
//!
//! - [`Shot`]: everything that is decided before a shot starts. It is read from a file
//!   ([`Shot::from_json`]) or from a tree of values; [`rack`] sets up the balls. [`Table`] and
//!   [`Physics`] describe the table.
//! - [`Shot::simulate`] gives a [`Trace`]: all events, the state at any time, and curves to draw.
//!   A [`Simulator`] passes the events to any [`Recorder`](event::Recorder), such as the one that
//!   collects an [`Outcome`], and reuses its memory for the next shot.
//! - [`batch`]: many shots on all cores; [`noise`]: the scatter of a player's strikes.
//! - [`error`]: every error has a kind, and names the place, the fault and the remedy.
//! - Internals: [`motion`] between events, contact times ([`detect`]) and impacts ([`resolve`]).
//!
//! The same shot gives the same bits on every platform, with or without the features `std`
//! (hardware square roots, wide vectors), `json` (files) and `parallel` (batches on all cores).
#![cfg_attr(not(feature = "std"), no_std)]
#![cfg_attr(target_arch = "nvptx64", feature(core_float_math))]

extern crate alloc;

pub mod ball;
pub mod batch;
pub mod candidates;
pub mod detect;
pub mod device;
pub mod edition;
pub mod error;
pub mod event;
pub mod format;
pub mod hash;
pub mod limits;
pub mod math;
pub mod motion;
pub mod noise;
pub mod outcome;
pub mod physics;
mod pocket;
pub mod rack;
mod range;
pub mod resolve;
pub mod runner;
pub mod sample;
pub mod shot;
pub mod simulate;
pub mod simulator;
pub mod table;
pub mod trace;
mod trace_event;
pub mod tracks;
pub mod version;

pub use ball::{Ball, BallState, MotionState};
pub use error::{Error, ErrorKind};
pub use format::ShotFile;
pub use noise::Noise;
pub use outcome::Outcome;
pub use physics::Physics;
pub use shot::Shot;
pub use simulate::{SimulationError, Summary, simulate};
pub use simulator::Simulator;
pub use table::Table;
pub use trace::Trace;
