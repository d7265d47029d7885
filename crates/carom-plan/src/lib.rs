//! Questions about shots, answered by playing them many times over.
//!
//! [`evaluate()`]: what comes of a strike that a player means but does not hit exactly? Every answer is a
//! count with its confidence interval ([`Interval`]). What is asked is a pure function of shot, noise,
//! seed and number of variants: the same for any number of threads, on every platform.

pub mod evaluate;
pub mod interval;
pub mod moments;

pub use evaluate::{Evaluation, Precision, Question, Referee, Watched, evaluate};
pub use interval::{Interval, wilson};
pub use moments::Moments;
