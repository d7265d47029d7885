//! Drills, puzzles and studies.
//!
//! - A [`DrillGoal`] says what a shot must do; [`mod@judge`] decides whether it does.
//! - A [`Drill`] is a file `carom-drill/1`: steps with layouts and goals, and how they score.
//! - A [`study::Study`] is a file `carom-study/1`: chapters with texts, shots and tasks, whose goals are such conditions.
//! - A [`Puzzle`] is made from its theme and a number alone, with its solution and the chances of the levels;
//!   [`puzzle::accepted`] lists those that were found good.
//!
//! Everything depends only on its input: it is the same on every platform.

pub mod area;
pub mod drill;
pub mod goal;
mod goal_file;
pub mod judge;
pub mod lanes;
mod met;
pub mod played;
pub mod puzzle;
pub mod study;

pub use area::DrillArea;
pub use drill::{DRILL_FORMAT, Drill, DrillOrder, DrillStep};
pub use goal::{DrillCondition, DrillGoal, RunOrder, Zone};
pub use judge::{ShotFault, ShotVerdict, judge};
pub use played::Played;
pub use puzzle::{Puzzle, Rejection, Theme};
