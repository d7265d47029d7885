//! The pockets that balls fell into, as numbers.

use crate::event::{Event, EventKind, Recorder};

/// Pocket index of a ball that is on the table at the end.
pub const ON_TABLE: i8 = -1;
/// Pocket index of a ball that has left the table.
pub const OFF_TABLE: i8 = -2;
/// Pocket index in a column for which the shot has no ball, and in the row of a failed shot.
pub const PADDING: i8 = -3;

/// Records the pocket that each ball fell into: its index in `Table::pockets`, or [`ON_TABLE`].
#[derive(Debug)]
pub struct PocketRecorder<'a> {
    pockets: &'a mut [i8],
}

impl<'a> PocketRecorder<'a> {
    /// A recorder that writes into `pockets`, one number for each ball of the shot.
    pub fn new(pockets: &'a mut [i8]) -> Self {
        pockets.fill(ON_TABLE);
        Self { pockets }
    }
}

impl Recorder for PocketRecorder<'_> {
    #[inline(always)]
    fn record(&mut self, event: &Event<'_>) {
        if let EventKind::PocketCollision(pocket) = event.kind {
            self.pockets[usize::from(event.balls[0])] = pocket as i8;
        }
    }
}
