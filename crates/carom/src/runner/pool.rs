//! A pool of threads that also works in a forked process.
//!
//! `fork` copies a process with its memory, but with the calling thread alone. The copy of a pool in
//! the child has no threads, so work that is given to it never ends. Python's `multiprocessing`,
//! process pools and data loaders fork. So a [`Pool`] stores which process made its threads, and
//! another process makes its own at its first use.

use std::mem;
use std::num::NonZero;
use std::process;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::Duration;

/// How often a held lock is tried again. It is held for some nanoseconds, so a lock that is held for
/// longer was copied by a fork while a thread held it, and no thread of this process can release it.
/// With a smaller number a busy machine could make a pool for a single task, which only costs time.
const ATTEMPTS: u32 = 10_000;

/// Time between two looks at a pool that another thread is making, which takes a few hundred
/// microseconds.
const MAKING: Duration = Duration::from_micros(50);

/// The threads, which are made at the first use in each process.
#[derive(Debug)]
pub(super) struct Pool {
    /// The number of threads; 0 means one for each core.
    threads: usize,
    made: Mutex<Made>,
}

#[derive(Debug)]
enum Made {
    Nothing,
    /// A thread of this process is making the pool.
    Making(u32),
    /// The pool that this process made.
    By(u32, Arc<rayon::ThreadPool>),
}

impl Pool {
    /// A pool of one thread for each core, without any threads yet.
    pub(super) const fn of_cores() -> Self {
        Self { threads: 0, made: Mutex::new(Made::Nothing) }
    }

    /// A pool of `threads` threads, which are started now.
    pub(super) fn start(threads: usize) -> Result<Self, rayon::ThreadPoolBuildError> {
        let pool = Arc::new(build(threads)?);
        Ok(Self { threads, made: Mutex::new(Made::By(process::id(), pool)) })
    }

    /// Whether the calling thread belongs to a pool whose threads this one uses, so that nested work
    /// starts no further ones.
    pub(super) fn is_around(&self) -> bool {
        self.threads == 0 && rayon::current_thread_index().is_some()
    }

    /// The number of threads that work at the same time.
    pub(super) fn count(&self) -> usize {
        if self.is_around() {
            return rayon::current_num_threads();
        }
        self.get().map_or(1, |threads| threads.current_num_threads())
    }

    /// The threads of this process: as many as the operating system allows, at most those that were
    /// asked for. None if it allows none.
    pub(super) fn get(&self) -> Option<Arc<rayon::ThreadPool>> {
        let process = process::id();
        loop {
            let Some(mut made) = self.lock() else {
                return build_most(self.threads).map(Arc::new);
            };
            match &*made {
                Made::By(maker, pool) if *maker == process => return Some(Arc::clone(pool)),
                Made::Making(maker) if *maker == process => {
                    drop(made);
                    thread::sleep(MAKING);
                }
                Made::Nothing | Made::Making(_) | Made::By(..) => {
                    leave(&mut made, Made::Making(process));
                    break;
                }
            }
        }
        let pool = build_most(self.threads).map(Arc::new);
        if let Some(mut made) = self.lock() {
            // Nothing is stored without threads, because the next use may get some.
            *made = pool.clone().map_or(Made::Nothing, |pool| Made::By(process, pool));
        }
        pool
    }

    /// The lock, or none if it was copied by a fork while a thread held it.
    fn lock(&self) -> Option<MutexGuard<'_, Made>> {
        for _ in 0..ATTEMPTS {
            match self.made.try_lock() {
                Ok(made) => return Some(made),
                Err(TryLockError::Poisoned(made)) => return Some(made.into_inner()),
                Err(TryLockError::WouldBlock) => thread::yield_now(),
            }
        }
        None
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        let made = self.made.get_mut().unwrap_or_else(PoisonError::into_inner);
        if !matches!(made, Made::By(maker, _) if *maker == process::id()) {
            leave(made, Made::Nothing);
        }
    }
}

/// Replaces a pool of another process without freeing it: to end its threads, this process would wait
/// for locks that they may have held during the fork.
fn leave(made: &mut Made, next: Made) {
    mem::forget(mem::replace(made, next));
}

fn build(threads: usize) -> Result<rayon::ThreadPool, rayon::ThreadPoolBuildError> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build()
}

/// A pool of `threads` threads (0 means one for each core), or of half as many until the operating
/// system starts them all; none if it does not start two.
fn build_most(threads: usize) -> Option<rayon::ThreadPool> {
    if let Ok(pool) = build(threads) {
        return Some(pool);
    }
    let mut fewer = match threads {
        // The environment may ask for more than there are cores.
        0 => thread::available_parallelism().map_or(1, NonZero::get),
        _ => threads / 2,
    };
    while fewer > 1 {
        if let Ok(pool) = build(fewer) {
            return Some(pool);
        }
        fewer /= 2;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{Made, Pool};
    use std::process;
    use std::sync::Arc;
    use std::thread;

    /// What a fork leaves: the pool of a process with another number.
    fn of_the_parent(made: Made) -> Pool {
        let pool = Pool::of_cores();
        *pool.made.lock().expect("a lock") = made;
        pool
    }

    fn parent() -> u32 {
        process::id() + 1
    }

    #[test]
    fn a_process_uses_its_own_threads_and_not_those_of_its_parent() {
        let threads = Arc::new(super::build(2).expect("threads"));
        let pool = of_the_parent(Made::By(parent(), Arc::clone(&threads)));
        let own = pool.get().expect("threads");
        assert!(!Arc::ptr_eq(&own, &threads));
        assert!(Arc::ptr_eq(&own, &pool.get().expect("threads")), "they are made once");
        drop(pool);
        // The child does not end the threads of its parent.
        assert_eq!(threads.install(|| 7), 7);
    }

    #[test]
    fn a_pool_that_the_parent_was_making_is_made_again() {
        assert!(of_the_parent(Made::Making(parent())).get().is_some());
    }

    #[test]
    fn a_lock_that_the_parent_held_during_the_fork_stops_nobody() {
        let pool = Pool::of_cores();
        let held = pool.made.lock().expect("a lock");
        let threads = pool.get().expect("threads");
        assert_eq!(threads.install(|| 7), 7);
        drop(held);
    }

    #[test]
    fn threads_that_begin_at_once_share_one_pool() {
        let pool = Pool::of_cores();
        let found = thread::scope(|scope| {
            let all = [0; 8].map(|_| scope.spawn(|| pool.get().expect("threads")));
            all.map(|one| one.join().expect("threads"))
        });
        assert!(found.iter().all(|one| Arc::ptr_eq(one, &found[0])));
    }
}
