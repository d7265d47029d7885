//! The error type of the engine.

use alloc::boxed::Box;
use alloc::string::String;
use core::fmt;

/// An error, in the user's terms.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// Bad input, refused before anything is simulated.
    Input(Box<InputError>),
    /// The shot reached its cap of events. Please report it with the shot that it carries, unless
    /// the input is at fault ([`Error::is_bad_input`]).
    TooManyEvents(Box<EventCapError>),
}

/// A shot that reached its cap of events.
#[derive(Clone, Debug, PartialEq)]
pub struct EventCapError {
    /// The cap, `max_events`.
    pub cap: u32,
    /// Time of the last event, s.
    pub time: f64,
    /// The id of a ball that no friction stops, if there is one and the table has rails: the motion
    /// has no end, and the input is at fault.
    pub never_resting: Option<String>,
    /// The shot file, JSON; [`Shot::simulate_to_cap`](crate::Shot::simulate_to_cap) of it gives the
    /// trace so far.
    pub shot: String,
}

/// Bad input: the place, the fault and the remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// Path in the input, such as `balls[3].position`.
    pub place: String,
    /// What is wrong.
    pub what: String,
    /// What to do about it; empty if `what` says so already.
    pub remedy: String,
}

impl Error {
    /// Bad input at `place`: `what` is wrong, `remedy` says what to do.
    pub fn input(
        place: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self::Input(Box::new(InputError {
            place: place.into(),
            what: what.into(),
            remedy: remedy.into(),
        }))
    }

    /// The same error with its place inside the value of `key`.
    pub fn inside(mut self, key: &str) -> Self {
        if let Self::Input(e) = &mut self {
            let dot = if e.place.is_empty() || e.place.starts_with('[') { "" } else { "." };
            e.place = alloc::format!("{key}{dot}{}", e.place);
        }
        self
    }

    /// The same error with its place inside `to`, if it is inside `from`: `noise.bias[2]` becomes
    /// `match.noise[1].bias[2]`.
    pub fn moved(mut self, from: &str, to: &str) -> Self {
        if let Self::Input(e) = &mut self
            && let Some(rest) = e.place.strip_prefix(from)
        {
            let rest = if to.is_empty() { rest.trim_start_matches('.') } else { rest };
            e.place = alloc::format!("{to}{rest}");
        }
        self
    }

    /// The same error with its place in a file: `shot.json: balls[3].position`.
    pub fn in_file(mut self, file: &str) -> Self {
        if let Self::Input(e) = &mut self {
            let colon = if e.place.is_empty() { "" } else { ": " };
            e.place = alloc::format!("{file}{colon}{}", e.place);
        }
        self
    }

    /// Whether the input is at fault (exit code 2), not the engine.
    pub const fn is_bad_input(&self) -> bool {
        match self {
            Self::Input(_) => true,
            Self::TooManyEvents(error) => error.never_resting.is_some(),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(e) => {
                if !e.place.is_empty() {
                    write!(f, "{}: ", e.place)?;
                }
                f.write_str(&e.what)?;
                if e.remedy.is_empty() { Ok(()) } else { write!(f, "; {}", e.remedy) }
            }
            Self::TooManyEvents(error) => error.fmt(f),
        }
    }
}

impl fmt::Display for EventCapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cap, time, never_resting, .. } = self;
        match never_resting {
            Some(id) => write!(
                f,
                "until: no friction stops ball \"{id}\", and the shot was stopped at its cap of \
                 {cap} events, at {time:.6} s; write the time in s at which the shot shall end"
            ),
            None => write!(
                f,
                "max_events: the shot was stopped at its cap of {cap} events, at {time:.6} s; raise \
                 the cap, or, if it cannot have so many events, report the shot file that this \
                 error carries; with \"until\" the shot ends earlier"
            ),
        }
    }
}

impl core::error::Error for Error {}
