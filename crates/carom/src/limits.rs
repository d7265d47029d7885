//! How large shots and their files can be.

/// The most balls that a shot can have.
///
/// Purpose: it bounds the arrays of a simulation, so that the event loop allocates no memory. A
/// snooker table has 22 balls. Larger, and a set of balls no longer fits into 128 bits.
pub const MAX_BALLS: usize = 128;

/// The largest cap on the events of a shot, ten times the default one.
///
/// Purpose: a shot file of a stranger ends in seconds, also if nothing in it brakes the balls. Larger, and
/// its trace, about a kilobyte per event as text, no longer fits into the memory of a small machine.
pub const MOST_EVENTS: u32 = 1_000_000;

/// The longest text of a shot file, bytes. A film of ten thousand samples of sixteen balls is 9 MB.
///
/// Purpose: it bounds the memory and the time for a stranger's file, about thirty times its size and
/// a third of a second per megabyte.
pub const MOST_SHOT_BYTES: usize = 16 << 20;

/// The longest text of any other file, such as a trace, bytes. A trace of a shot that reaches the
/// default cap of events is 100 MB.
pub const MOST_BYTES: usize = 128 << 20;

/// Capacity, in balls, of the simulation for ordinary tables.
///
/// With it the whole state fits into a processor's level-1 data cache; shots with more balls use
/// [`MAX_BALLS`] and run slower. Smaller, and a snooker shot no longer fits.
pub const SMALL_CAPACITY: usize = 24;
