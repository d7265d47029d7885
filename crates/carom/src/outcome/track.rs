//! A ball's path between two of its events.

use crate::motion::Path;

/// A ball's path since its last event.
#[derive(Clone, Debug)]
pub(super) struct Track {
    /// Time of that event, s since the strike.
    pub(super) since: f64,
    pub(super) path: Path,
}

impl Track {
    /// The greatest height of a path in the air, m.
    pub(super) fn apex(&self) -> f64 {
        let rise = self.path.velocity.z.max(0.0);
        self.path.position.z - 0.25 * rise * rise / self.path.half_acceleration.z
    }
}
