//! Questions about shots, answered by simulating many variants of them.
//!
//! - [`evaluate()`] counts the results of a strike that a player intends but does not hit exactly.
//!   Every answer is a count with its confidence interval ([`Interval`]).
//! - [`solve()`] searches the strikes that reach a goal.
//! - [`maps`] computes a result for every cell of a grid; [`breaks`] counts the results of many
//!   breaks; [`cushions`] lists the cushion contacts of a ball that is alone on the table.
//! - [`sweep`] plays the rows of a table of shots.
//! - A [`Sampler`] gives the frames that may follow a play, for programs that search.
//!
//! The questions whose answers are probabilities may be asked of several tables, of which each may be
//! the true one ([`DrawnTables`]).
//!
//! Every answer depends only on the shot, the noise, the seed and the number of variants: it is the
//! same for any number of threads and on every platform. Long tasks take a [`Progress`], through
//! which another thread can watch and stop them.

mod aim;
mod ball_way;
pub mod breaks;
pub mod carom_route;
pub mod cushions;
pub mod diamonds;
pub mod drawn_tables;
pub mod error_model;
pub mod evaluate;
pub mod goal;
pub mod grid;
pub mod interval;
pub mod leave_aim;
pub mod maps;
pub mod moments;
mod part_size;
mod places;
pub mod pot_aim;
pub mod progress;
pub mod reach;
pub mod referee;
pub mod route;
pub mod sampler;
pub mod solve;
mod successors;
pub mod sweep;

pub use carom_route::{CaromFigure, CaromPattern, CaromRoute, RouteSide, counted_touches};
pub use carom_rules::Prepared;
pub use diamonds::{DiamondNumber, DiamondReading, DiamondSystem};
pub use drawn_tables::DrawnTables;
pub use error_model::{Chance, ChanceByTable, ErrorModel, check_level};
pub use evaluate::{Evaluation, Question, ResultCounts, Watched, evaluate};
pub use goal::{Disc, Goal};
pub use interval::{Interval, clustered, two_sided_quantile, wilson};
pub use leave_aim::{LeaveAim, leave_aim};
pub use moments::Moments;
pub use pot_aim::{PotAim, PotLines, pot_aim};
pub use progress::Progress;
pub use reach::Reach;
pub use referee::Referee;
pub use route::{Leg, Route};
pub use sampler::Sampler;
pub use solve::{Search, Solution, Stage, solve};
pub use successors::{Successor, successors};

/// The examples of the documentation's page on Rust. They are tested with this crate because it
/// depends on both the engine and the games.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/rust.md")]
struct Documentation;
