//! Puzzles: a position, a goal and its solution, from a theme and a number alone.

mod accepted;
mod dice;
mod file;
mod layouts;
mod levels;
mod make;
mod search;
mod task;
mod theme;

pub use accepted::{ListedPuzzle, accepted};
pub use levels::{LEVELS, Way, rating_of};
pub use make::{Puzzle, Rejection};
pub use theme::Theme;
