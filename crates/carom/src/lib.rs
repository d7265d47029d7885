//! **carom** — the billiards engine: exact, deterministic, and fast enough to think with.
//!
//! Every ball follows a closed-form path until the next event, whose time is solved, never
//! stepped (Leckie & Greenspan 2006). SI units and radians throughout.
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

pub mod ball;
pub mod batch;
pub mod detect;
pub mod error;
pub mod event;
pub mod math;
pub mod motion;
pub mod noise;
pub mod outcome;
pub mod physics;
pub mod rack;
pub mod resolve;
pub mod sample;
pub mod schema;
pub mod shot;
pub mod simulate;
pub mod table;
pub mod trace;

pub use ball::{Ball, BallState, MotionState};
pub use error::Error;
pub use noise::Noise;
pub use outcome::Outcome;
pub use physics::Physics;
pub use shot::Shot;
pub use simulate::{SimulationError, Summary, simulate};
pub use table::Table;
pub use trace::Trace;
