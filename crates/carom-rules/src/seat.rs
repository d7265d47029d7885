//! The two sides of a frame.

/// One of the two seats at the table: 0 or 1. Seat 0 breaks first.
pub type Seat = usize;

/// The other seat.
pub(crate) const fn opponent(seat: Seat) -> Seat {
    1 - seat
}
