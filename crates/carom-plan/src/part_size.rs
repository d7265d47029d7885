//! How many variants are played between two checks for a stop.

#[cfg(feature = "parallel")]
use std::time::{Duration, Instant};

/// Variants per thread in the first part. Without threads every part has this size, since a page has
/// no clock: it is some milliseconds of work.
const FIRST_PART: usize = if cfg!(feature = "parallel") { 64 } else { 512 };

/// Target time of a part. With shorter times the threads would wait for each other more often;
/// longer ones would delay Ctrl-C.
#[cfg(feature = "parallel")]
const PART_TIME: Duration = Duration::from_millis(60);

/// The size of the next part. Results do not depend on it.
pub(crate) struct PartSize(usize);

impl PartSize {
    /// The first part on this number of threads.
    pub(crate) const fn new(threads: usize) -> Self {
        Self(FIRST_PART * threads)
    }

    /// The number of variants of the next part.
    pub(crate) const fn variants(&self) -> usize {
        self.0
    }

    /// Plays a part with `play`, and adapts the size of the next one to the time that it took.
    #[cfg(feature = "parallel")]
    pub(crate) fn play<T>(&mut self, play: impl FnOnce() -> T) -> T {
        let began = Instant::now();
        let played = play();
        self.0 = if began.elapsed() < PART_TIME { 2 * self.0 } else { self.0.div_ceil(2) };
        played
    }

    /// Plays a part with `play`.
    #[cfg(not(feature = "parallel"))]
    pub(crate) fn play<T>(&mut self, play: impl FnOnce() -> T) -> T {
        play()
    }
}
