//! Records the facts about a shot on which rewards and calls depend.

use carom::event::{Event, EventKind, Recorder};

/// Records the facts about a shot on which rewards and calls depend. Balls are indices of the
/// shot.
pub(crate) struct TaskRecorder {
    cue: u16,
    /// The first ball that the cue ball touched.
    pub(crate) first_contact: Option<u16>,
    /// Number of contacts of any ball with a cushion.
    pub(crate) cushions: u32,
    /// Whether a ball left the table other than by a pocket.
    pub(crate) left_table: bool,
    /// The pocketed balls and the indices of their pockets, in order.
    pub(crate) pots: Vec<(u16, u8)>,
}

impl TaskRecorder {
    /// For a shot whose cue ball is ball `cue`.
    pub(crate) const fn new(cue: usize) -> Self {
        Self {
            cue: cue as u16,
            first_contact: None,
            cushions: 0,
            left_table: false,
            pots: Vec::new(),
        }
    }
}

impl Recorder for TaskRecorder {
    fn record(&mut self, event: &Event<'_>) {
        if self.first_contact.is_none() && event.is_ball_contact() {
            self.first_contact = event.nearest_to(self.cue);
        }
        match event.kind {
            EventKind::RailCollision(_) => self.cushions += 1,
            EventKind::OffTable => self.left_table = true,
            EventKind::PocketCollision(pocket) => {
                self.pots.push((event.balls[0], pocket));
            }
            _ => {}
        }
    }
}
