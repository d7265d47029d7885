//! What an environment notes of a shot.

use carom::event::{Event, EventKind, Recorder};
use carom::limits::SMALL_CAPACITY;

/// Notes what the tasks ask of a shot. Balls are numbered as in the shot.
pub(crate) struct Notes {
    cue: u16,
    /// The first ball that the cue ball touched.
    pub(crate) first_contact: Option<u16>,
    /// Touches of cushions, by all balls.
    pub(crate) cushions: u32,
    /// Whether a ball left the table otherwise than by a pocket.
    pub(crate) left_table: bool,
    pots: [(u16, u8); SMALL_CAPACITY],
    count: usize,
}

impl Notes {
    /// Of a shot that strikes ball `cue`.
    pub(crate) const fn new(cue: usize) -> Self {
        Self {
            cue: cue as u16,
            first_contact: None,
            cushions: 0,
            left_table: false,
            pots: [(0, 0); SMALL_CAPACITY],
            count: 0,
        }
    }

    /// The balls that fell and the pockets that took them, in order.
    pub(crate) fn pots(&self) -> impl Iterator<Item = (u16, u8)> + '_ {
        self.pots[..self.count].iter().copied()
    }
}

impl Recorder for Notes {
    fn record(&mut self, event: &Event<'_>) {
        match event.kind {
            EventKind::BallCollision
                if self.first_contact.is_none() && event.balls.contains(&self.cue) =>
            {
                self.first_contact = event.balls.iter().copied().find(|b| *b != self.cue);
            }
            EventKind::RailCollision(_) => self.cushions += 1,
            EventKind::OffTable => self.left_table = true,
            EventKind::PocketCollision(pocket) => {
                self.pots[self.count] = (event.balls[0], pocket);
                self.count += 1;
            }
            _ => {}
        }
    }
}
