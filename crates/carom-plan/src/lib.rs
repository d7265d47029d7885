//! Questions about shots, answered by playing them many times over.
//!
//! [`evaluate()`]: what comes of a strike that a player means but does not hit exactly? Every answer is a
//! count with its confidence interval ([`Interval`]). [`solve()`]: which strikes bring about what is wanted?
//! [`maps`]: one question asked over a grid; [`cushions`]: where a ball meets one cushion after the other.
//! Every answer is a pure function of shot, noise, seed and number of variants: the same for any number of
//! threads, on every platform.

mod aim;
pub mod cushions;
pub mod errs;
pub mod evaluate;
pub mod goal;
pub mod interval;
pub mod maps;
pub mod moments;
mod places;
pub mod referee;
pub mod solve;
pub mod sweep;
mod threads;
pub mod way;

pub use errs::{Chance, Errs, check_level};
pub use evaluate::{Evaluation, Precision, Question, Watched, evaluate};
pub use goal::{Disc, Goal};
pub use interval::{Interval, wilson};
pub use moments::Moments;
pub use referee::Referee;
pub use solve::{Search, Solution, Stage, solve};
pub use way::{Step, Way};

/// The examples of the documentation's page on Rust, which are tested with this crate, since it knows the engine and
/// the games.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/rust.md")]
struct Documentation;
