//! The error type of the arena.

use core::fmt;
use std::io;
use std::path::{Path, PathBuf};

use carom::Error;

/// An error of a match, in the user's terms.
#[derive(Debug)]
#[non_exhaustive]
pub enum ArenaError {
    /// Bad input: settings, a damaged record, a folder with another match.
    Input(Error),
    /// A file that cannot be read or written.
    File {
        /// The file or folder.
        path: PathBuf,
        /// What the operating system reports.
        error: io::Error,
    },
}

impl ArenaError {
    /// The error for a file at `path`.
    pub(crate) fn file(path: &Path) -> impl Fn(io::Error) -> Self + use<> {
        let path = path.to_path_buf();
        move |error| Self::File { path: path.clone(), error }
    }
}

impl From<Error> for ArenaError {
    fn from(error: Error) -> Self {
        Self::Input(error)
    }
}

impl fmt::Display for ArenaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) => error.fmt(f),
            Self::File { path, error } => {
                write!(f, "{}: {error}; check the folder, its rights and its disk", path.display())
            }
        }
    }
}

impl core::error::Error for ArenaError {}
