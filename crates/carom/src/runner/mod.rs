//! A [`Runner`] shares work among threads, everywhere in the workspace.
//!
//! Batches, evaluations, searches, maps, sweeps and environments all compute one result for each of
//! many items, on the number of threads that the user allows. A `Runner` does this for all of them
//! by the same rules:
//!
//! - Results come in the order of the items and do not depend on the number of threads.
//! - `None` means one thread for each core, in a pool that all runners of the process share; 1 means
//!   the calling thread; any other number gets a pool of its own, which lives as long as the runner
//!   and its clones. Make one runner for a task and use it for every round of that task.
//! - If the operating system refuses threads, `None` works with as many as it allows, down to the
//!   calling thread alone. For a number it is an [`Error::Input`] at `threads`.
//! - After a fork the child has none of its parent's threads. A runner starts its own there when it
//!   is first used, or works with as many as it gets.
//! - Work that itself uses a runner of `None` shares the threads of the pool in which it runs.
//! - Without the feature `parallel` all work runs on the calling thread, with the same results.
//!
//! ```
//! use carom::runner::Runner;
//!
//! # fn main() -> Result<(), carom::Error> {
//! let runner = Runner::new(Some(2))?;
//! let squares = runner.map(1..=4_u64, || (), |(), k| k * k);
//! assert_eq!(squares, [1, 4, 9, 16]);
//! # Ok(())
//! # }
//! ```

use alloc::format;
use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::device::Device;
use crate::error::{Error, ErrorKind};

#[cfg(feature = "parallel")]
use self::pool::Pool;

#[cfg(feature = "parallel")]
mod pool;

/// The most threads of a runner. Few machines have so many cores, and several times as many threads
/// would exhaust the memory or the process table before any work is done.
pub const MAX_THREADS: usize = 1024;

/// The threads of all runners without a number of their own.
#[cfg(feature = "parallel")]
static CORES: Pool = Pool::of_cores();

/// The threads that a task may use. A clone uses the same ones.
#[derive(Clone, Debug, Default)]
pub struct Runner {
    threads: Threads,
    device: Option<Arc<dyn Device>>,
}

#[derive(Clone, Debug, Default)]
enum Threads {
    /// The calling thread alone.
    #[cfg_attr(not(feature = "parallel"), default)]
    Calling,
    /// One for each core, shared by the whole process.
    #[cfg(feature = "parallel")]
    #[default]
    Cores,
    /// A pool that was made for this runner.
    #[cfg(feature = "parallel")]
    Own(Arc<Pool>),
}

impl Runner {
    /// A runner with this number of threads; `None` means one for each core.
    ///
    /// # Errors
    /// [`Error::Input`] at `threads` for 0, for more than [`MAX_THREADS`], and if the operating
    /// system refuses to start that many.
    pub fn new(threads: Option<usize>) -> Result<Self, Error> {
        match threads {
            None => Ok(Self::default()),
            Some(1) => Ok(Self::of(Threads::Calling)),
            Some(count) if (2..=MAX_THREADS).contains(&count) => Self::with_pool(count),
            Some(count) => Err(ErrorKind::OutOfRange.at(
                "threads",
                format!("{count} is out of range"),
                format!("write a whole number from 1 to {MAX_THREADS}, or leave it out"),
            )),
        }
    }

    #[cfg(feature = "parallel")]
    fn with_pool(count: usize) -> Result<Self, Error> {
        match Pool::start(count) {
            Ok(pool) => Ok(Self::of(Threads::Own(Arc::new(pool)))),
            Err(error) => Err(ErrorKind::System.at(
                "threads",
                format!("{count} threads could not be started ({error})"),
                "choose a smaller number, or leave it out",
            )),
        }
    }

    #[cfg(not(feature = "parallel"))]
    #[expect(clippy::unnecessary_wraps, reason = "the same signature with the feature `parallel`")]
    fn with_pool(_count: usize) -> Result<Self, Error> {
        Ok(Self::of(Threads::Calling))
    }

    const fn of(threads: Threads) -> Self {
        Self { threads, device: None }
    }

    /// The same runner, whose batches ([`crate::batch`]) play their shots on `device`. All other work,
    /// and shots that the device cannot play, stay on the threads.
    #[must_use]
    pub fn on(self, device: Arc<dyn Device>) -> Self {
        Self { device: Some(device), ..self }
    }

    /// The device that batches use, if there is one.
    pub fn device(&self) -> Option<&dyn Device> {
        self.device.as_deref()
    }

    /// How many threads work at the same time.
    pub fn threads(&self) -> usize {
        match &self.threads {
            Threads::Calling => 1,
            #[cfg(feature = "parallel")]
            Threads::Cores => CORES.count(),
            #[cfg(feature = "parallel")]
            Threads::Own(pool) => pool.count(),
        }
    }

    /// The results of `work` for each of `items`, in the order of the items.
    ///
    /// `make_worker` makes a value that a thread needs for its work and reuses for its next item,
    /// such as a [`Simulator`](crate::Simulator) or a recorder. It is called at least once for each
    /// thread that takes part. So the result of `work` must not depend on the items before.
    ///
    /// The overhead for each item is a few hundred nanoseconds. If the work for an item takes less
    /// than about ten microseconds, pass chunks of them as items (`slice.chunks(n)`,
    /// `chunks_mut(n)`). To report progress, or to let a user stop, call `map` for one part of the
    /// items after the other.
    ///
    /// If `work` returns a [`Result`], collect the results into one to get the error of the first
    /// item that failed.
    pub fn map<I: Send, W, T: Send>(
        &self,
        items: impl IntoIterator<Item = I>,
        make_worker: impl Fn() -> W + Sync + Send,
        work: impl Fn(&mut W, I) -> T + Sync + Send,
    ) -> Vec<T> {
        match &self.threads {
            Threads::Calling => in_order(items, make_worker, work),
            #[cfg(feature = "parallel")]
            Threads::Cores => in_parallel(&CORES, items.into_iter().collect(), make_worker, work),
            #[cfg(feature = "parallel")]
            Threads::Own(pool) => in_parallel(pool, items.into_iter().collect(), make_worker, work),
        }
    }
}

/// [`Runner::map`] on the calling thread.
fn in_order<I, W, T>(
    items: impl IntoIterator<Item = I>,
    make_worker: impl Fn() -> W,
    work: impl Fn(&mut W, I) -> T,
) -> Vec<T> {
    let mut worker = make_worker();
    items.into_iter().map(|item| work(&mut worker, item)).collect()
}

/// [`Runner::map`] in a pool, or on the calling thread if the pool has no threads.
#[cfg(feature = "parallel")]
fn in_parallel<I: Send, W, T: Send>(
    pool: &Pool,
    items: Vec<I>,
    make_worker: impl Fn() -> W + Sync + Send,
    work: impl Fn(&mut W, I) -> T + Sync + Send,
) -> Vec<T> {
    use rayon::prelude::*;
    // One item is not worth a change of threads.
    if items.len() < 2 {
        return in_order(items, make_worker, work);
    }
    let spread = |items: Vec<I>| items.into_par_iter().map_init(&make_worker, &work).collect();
    if pool.is_around() {
        return spread(items);
    }
    match pool.get() {
        Some(threads) => threads.install(|| spread(items)),
        None => in_order(items, make_worker, work),
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_THREADS, Runner};
    use alloc::vec::Vec;

    #[test]
    fn results_are_in_the_order_of_the_items_for_any_number_of_threads() {
        let expected: Vec<usize> = (0..1000).map(|k| 3 * k).collect();
        for threads in [None, Some(1), Some(2), Some(7)] {
            let runner = Runner::new(threads).expect("a runner");
            assert_eq!(runner.map(0..1000, || (), |(), k| 3 * k), expected, "{threads:?}");
        }
    }

    #[test]
    fn items_may_be_disjoint_mutable_slices() {
        let mut numbers = [0_usize; 100];
        let runner = Runner::new(Some(3)).expect("a runner");
        let lengths = runner.map(
            numbers.chunks_mut(30).enumerate(),
            || 10,
            |ten, (k, chunk)| {
                chunk.fill(*ten * k);
                chunk.len()
            },
        );
        assert_eq!(lengths, [30, 30, 30, 10]);
        assert_eq!((numbers[29], numbers[30], numbers[99]), (0, 10, 30));
    }

    #[test]
    fn a_runner_has_as_many_threads_as_were_asked_for() {
        assert_eq!(Runner::new(Some(1)).expect("a runner").threads(), 1);
        let three = Runner::new(Some(3)).expect("a runner").threads();
        assert_eq!(three, if cfg!(feature = "parallel") { 3 } else { 1 });
    }

    #[cfg(feature = "parallel")]
    #[test]
    fn work_inside_a_pool_shares_its_threads() {
        let (outer, inner) = (Runner::new(Some(3)).expect("a runner"), Runner::default());
        let found = outer.map(
            0..20,
            || (),
            |(), k| (inner.threads(), inner.map(0..20, || (), |(), j| j * k).iter().sum::<i32>()),
        );
        assert_eq!(found, Vec::from_iter((0..20).map(|k| (3, 190 * k))));
    }

    #[test]
    fn a_number_of_threads_out_of_range_is_refused_at_its_place() {
        for count in [0, MAX_THREADS + 1, usize::MAX] {
            let error = Runner::new(Some(count)).expect_err("too few or too many");
            let text = alloc::string::ToString::to_string(&error);
            assert!(
                text.starts_with(&alloc::format!("threads: {count} is out of range")),
                "{text}"
            );
        }
    }
}
