//! The parts of a shot that a simulation reads, without names, counts of references and lists.

use crate::shot::Cling;
use crate::table::TableGeometry;
use crate::{Physics, Shot};

/// What a simulation reads of a shot besides its balls and its strike. Every part is flat: its bytes
/// can be copied to a device (docs/gpu.md).
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// The table.
    pub table: &'a TableGeometry,
    /// The physics.
    pub physics: &'a Physics,
    /// The contacts that cling.
    pub cling: &'a Cling,
    /// The cap on the number of events.
    pub max_events: u32,
    /// The end time, s since the strike; [`f64::MAX`] for an end at rest.
    pub until: f64,
}

impl<'a> Surroundings<'a> {
    /// Those of `shot`.
    pub fn of(shot: &'a Shot) -> Self {
        Self {
            table: &shot.table,
            physics: &shot.physics,
            cling: shot.cling(),
            max_events: shot.max_events,
            until: shot.until.unwrap_or(f64::MAX),
        }
    }
}
