//! Positions of balls at given times, and their differences from tracks, for many candidates and
//! without traces: what a program needs that learns physics and strikes from filmed shots.
//!
//! A simulation goes from event to event. Between two events of a ball its path is known in closed
//! form, and is evaluated at the wanted times in passing. It stops at the last wanted time. The
//! states have the bits of [`Trace::at`](crate::Trace::at).

mod ball_tracks;
mod follow;
mod residuals;
mod states;

pub use ball_tracks::{BallTrack, BallTracks};
pub use residuals::{Residuals, TrackFrame, TrackQuestion, track_residuals};
pub use states::{SampledStates, StateQuestion, sample_states};

/// Number of candidates that a thread gets at a time: a few hundred microseconds of work, so that the
/// overhead is small and a population of a few dozen uses all cores.
const CHUNK: usize = 8;
