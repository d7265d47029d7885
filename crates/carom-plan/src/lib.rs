//! Questions about shots, answered by playing them many times over.
//!
//! [`evaluate()`]: what comes of a strike that a player means but does not hit exactly? Every answer is a
//! count with its confidence interval ([`Interval`]). [`solve()`]: which strikes bring about what is wanted? What is asked is a pure function of shot, noise,
//! seed and number of variants: the same for any number of threads, on every platform.

mod aim;
pub mod evaluate;
pub mod goal;
pub mod interval;
pub mod maps;
pub mod moments;
pub mod solve;
pub mod sweep;
pub mod way;

pub use evaluate::{Evaluation, Precision, Question, Referee, Watched, evaluate};
pub use goal::{Disc, Goal};
pub use interval::{Interval, wilson};
pub use moments::Moments;
pub use solve::{Search, Solution, solve};
pub use way::{Step, Way};

/// Does `work` with so many threads, or all cores.
fn with_threads<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> T {
    match threads.map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build()) {
        Some(Ok(pool)) => pool.install(work),
        // No pool of that size to be had: the global one gives the same results.
        Some(Err(_)) | None => work(),
    }
}
