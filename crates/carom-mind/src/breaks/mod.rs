//! Opening shots, found by search.
//!
//! A [`BreakShot`] is an opening shot in the terms of a player: where the cue ball is, how the first
//! ball is hit, and the stroke. It fits every rack of a game, and a similar one fits a similar table.
//!
//! [`BreakSearch`](crate::search::BreakSearch) finds one for a game, a table, its physics and a player's errors, by the
//! cross-entropy method (Rubinstein 1999). It is judged over many racks, each of them with its own gaps
//! and its own errors of the strike. [`BreakCounts`] counts what a break does. [`found()`] gives the
//! best known break: the results of searches are shipped as data (`found.csv`, made by the example
//! `find_breaks`).

mod break_counts;
mod break_shot;
mod found;

pub use break_counts::BreakCounts;
pub use break_shot::BreakShot;
pub use found::{Fit, FoundBreak, entries, found, multiplier};
