//! The error type of the engine.

use alloc::boxed::Box;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

pub use kind::ErrorKind;

mod kind;

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

/// Bad input: the kind, the place, the fault and the remedy.
#[derive(Clone, Debug, PartialEq)]
pub struct InputError {
    /// What kind of fault it is.
    pub kind: ErrorKind,
    /// Path in the input, such as `balls[3].position`.
    pub place: String,
    /// What is wrong.
    pub what: String,
    /// What to do about it; empty if `what` says so already.
    pub remedy: String,
    /// The values of which `what` speaks, for programs; [`ErrorKind::details`] lists their keys.
    pub details: Vec<(&'static str, ErrorDetail)>,
}

/// A value of which an error speaks.
#[derive(Clone, Debug, PartialEq)]
pub enum ErrorDetail {
    /// A name, an id or a unit.
    Text(String),
    /// A number.
    Number(f64),
}

impl From<&str> for ErrorDetail {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

impl From<f64> for ErrorDetail {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl Error {
    /// The same error with one more detail.
    #[must_use]
    pub fn with(mut self, key: &'static str, value: impl Into<ErrorDetail>) -> Self {
        if let Self::Input(e) = &mut self {
            debug_assert!(e.kind.details().contains(&key), "{} has no {key}", e.kind.name());
            e.details.push((key, value.into()));
        }
        self
    }

    /// What kind of error it is.
    pub const fn kind(&self) -> ErrorKind {
        match self {
            Self::Input(e) => e.kind,
            Self::TooManyEvents(e) if e.never_resting.is_some() => ErrorKind::EndlessMotion,
            Self::TooManyEvents(_) => ErrorKind::TooManyEvents,
        }
    }

    /// The same error at another place.
    #[must_use]
    pub fn at(mut self, place: impl Into<String>) -> Self {
        if let Self::Input(e) = &mut self {
            e.place = place.into();
        }
        self
    }

    /// The same error with its place inside the value of `key`.
    pub fn inside(mut self, key: &str) -> Self {
        if let Self::Input(e) = &mut self {
            let dot = if e.place.is_empty() || e.place.starts_with('[') { "" } else { "." };
            e.place = format!("{key}{dot}{}", e.place);
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
            e.place = format!("{to}{rest}");
        }
        self
    }

    /// The same error with its place in a file: `shot.json: balls[3].position`.
    pub fn in_file(mut self, file: &str) -> Self {
        if let Self::Input(e) = &mut self {
            let colon = if e.place.is_empty() { "" } else { ": " };
            e.place = format!("{file}{colon}{}", e.place);
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

impl EventCapError {
    /// The key of the shot file that can mend it.
    pub const fn place(&self) -> &'static str {
        if self.never_resting.is_some() { "until" } else { "max_events" }
    }

    /// What happened.
    pub fn what(&self) -> String {
        let Self { cap, time, never_resting, .. } = self;
        let stopped = format!("the shot was stopped at its cap of {cap} events, at {time:.6} s");
        match never_resting {
            Some(id) => format!("no friction stops ball \"{id}\", and {stopped}"),
            None => stopped,
        }
    }

    /// What to do about it.
    pub const fn remedy(&self) -> &'static str {
        match self.never_resting {
            Some(_) => "write the time in s at which the shot shall end",
            None => {
                "raise the cap, or, if it cannot have so many events, report the shot file that this \
                 error carries; with \"until\" the shot ends earlier"
            }
        }
    }
}

impl fmt::Display for EventCapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.place(), self.what(), self.remedy())
    }
}

impl core::error::Error for Error {}
