//! How many threads work on a question.

/// So many threads, or all cores.
pub(crate) struct Threads(Option<rayon::ThreadPool>);

impl Threads {
    pub(crate) fn new(count: Option<usize>) -> Self {
        // Where no pool of that size is to be had the global one gives the same results.
        Self(count.and_then(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().ok()))
    }

    /// Does `work` in them.
    pub(crate) fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.0
            .as_ref()
            .map_or_else(rayon::current_num_threads, rayon::ThreadPool::current_num_threads)
    }
}
