//! How many balls a shot can have.

/// The most balls that a shot can have.
///
/// Purpose: it bounds the arrays of a simulation, so that the event loop allocates no memory. A
/// snooker table has 22 balls. Larger, and a set of balls no longer fits into 128 bits.
pub const MAX_BALLS: usize = 128;

/// Capacity, in balls, of the simulation for ordinary tables.
///
/// With it the whole state fits into a processor's level-1 data cache; shots with more balls use
/// [`MAX_BALLS`] and run slower. Smaller, and a snooker shot no longer fits.
pub const SMALL_CAPACITY: usize = 24;
