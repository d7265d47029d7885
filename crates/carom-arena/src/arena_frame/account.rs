//! The clock and the refused answers of one seat in a frame.

use carom_rules::{Frame, Seat};

use crate::clock::{Clock, ClockPeriod, Cost};
use crate::moves::EndReason;

/// Refused answers that each seat may give in a frame; one more loses it. A program that answers
/// with a wrong key once in a while is not ended, and one that repeats itself does not hang.
pub const REFUSALS: u32 = 10;

/// Why a seat loses a frame, and the same in words.
pub type Loss = (EndReason, String);

/// What a seat has used of its clock and of its refusals in a frame.
#[derive(Clone, Copy, Debug)]
pub struct SeatAccount {
    clock: Clock,
    /// What is left on the clock, in its unit. It only counts for clocks of a frame.
    left: f64,
    /// Requests so far; one that is repeated after a refusal counts again.
    asked: u64,
    /// Refused answers.
    refusals: u32,
}

impl SeatAccount {
    /// The account at the start of a frame.
    pub const fn new(clock: Clock) -> Self {
        Self { clock, left: clock.amount, asked: 0, refusals: 0 }
    }

    /// The seat's clock.
    pub const fn clock(&self) -> Clock {
        self.clock
    }

    /// Requests so far; one that is repeated after a refusal counts again.
    pub const fn asked(&self) -> u64 {
        self.asked
    }

    /// What is left on the clock of a frame, in its unit; `None` for a clock of a decision.
    pub fn left(&self) -> Option<f64> {
        (self.clock.period == ClockPeriod::Frame).then_some(self.left)
    }

    /// What `seat`, whose account this is, may spend on the next decision in `frame`.
    pub fn budget(&self, frame: &Frame, seat: Seat) -> f64 {
        self.clock.budget(self.left, frame, seat)
    }

    /// Counts a request and its cost. The seat loses the frame if its time is over.
    pub fn charge(&mut self, cost: &Cost) -> Option<Loss> {
        self.asked += 1;
        self.left -= self.clock.charge(cost);
        let is_late = self.clock.period == ClockPeriod::Frame && self.left < 0.0;
        is_late.then(|| (EndReason::TimeOver, "the player's time was over".into()))
    }

    /// Counts a refused answer. The seat loses the frame if it was one too many.
    pub fn refuse(&mut self) -> Option<Loss> {
        self.refusals += 1;
        (self.refusals > REFUSALS).then(|| {
            let why = format!("the player gave {} refused answers", self.refusals);
            (EndReason::Refusals, why)
        })
    }
}
