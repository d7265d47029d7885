//! What the finder of first contacts is measured against: other finders, hard cases, and a judge.
//!
//! Nothing here is part of the engine.

pub mod double_double;
pub mod families;
pub mod judge;
pub mod random;
