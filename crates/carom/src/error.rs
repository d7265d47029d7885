//! The error type of the engine.

use alloc::boxed::Box;
use alloc::string::String;
use core::fmt;

/// An error, in the user's terms.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// Bad input, refused before anything is simulated.
    Input(Box<InputError>),
    /// The shot reached its cap of events. Please report it with the shot that it carries.
    TooManyEvents {
        /// The cap, `max_events`.
        cap: u32,
        /// The shot file, JSON.
        shot: String,
    },
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
        matches!(self, Self::Input(_))
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
            Self::TooManyEvents { cap, .. } => write!(
                f,
                "max_events: the shot was stopped at its cap of {cap} events; raise the cap, or, \
                 if it cannot have so many events, report the shot file that this error carries"
            ),
        }
    }
}

impl core::error::Error for Error {}
