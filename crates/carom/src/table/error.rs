//! The error of a description that does not make a table.

use alloc::string::String;
use core::fmt;

/// A description that does not make a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableError {
    /// The key at fault, from the table on: `corner_pocket.mouth`.
    pub key: String,
    /// What is wrong, and the remedy: one sentence without its full stop.
    pub problem: String,
}

impl TableError {
    pub(super) fn new(key: impl Into<String>, problem: impl Into<String>) -> Self {
        Self { key: key.into(), problem: problem.into() }
    }
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.key, self.problem)
    }
}

impl core::error::Error for TableError {}
