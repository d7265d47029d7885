//! Comparisons for the finder of first contacts: other finders, hard cases, and a judge of their
//! answers that works in 106-bit arithmetic.
//!
//! Nothing here is part of the engine.

pub mod algorithm_1010;
pub mod companion;
pub mod double_double;
pub mod families;
pub mod ferrari;
pub mod finder;
pub mod flight_families;
pub mod harvest;
pub mod harvested;
pub mod judge;
pub mod kinds;
pub mod operations;
pub mod quartic;
pub mod random;
pub mod ring_families;
pub mod ring_judge;
pub mod whole_shots;
