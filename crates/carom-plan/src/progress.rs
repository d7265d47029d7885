//! The progress of a long task, shared between its threads and the thread that watches it.

use core::fmt;
use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The finished part of a task, and whether a stop was requested.
///
/// The functions of this crate take a `&Progress`. Another thread may read it while they work, and
/// may stop them; a stopped task returns within some milliseconds. To run a task without watching
/// it, pass `&Progress::default()`.
#[derive(Default)]
pub struct Progress {
    stage: AtomicU64,
    done: AtomicU64,
    total: AtomicU64,
    stopped: AtomicBool,
    watch: Option<Box<Watch>>,
}

/// What a task calls whenever it looks whether to stop.
type Watch = dyn Fn(&Progress) + Send + Sync;

/// One reading of a [`Progress`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// Number of stages that have been finished.
    pub stage: u64,
    /// Items of the present stage that are done.
    pub done: u64,
    /// Items of the present stage.
    pub total: u64,
}

impl Progress {
    /// The progress of a task that calls `watch` whenever it looks whether to stop, many times a
    /// second and from any of its threads. With it a program without a second thread can watch the
    /// task.
    pub fn watched_by(watch: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self { watch: Some(Box::new(watch)), ..Self::default() }
    }

    /// Requests that the task ends early.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether an early end was requested. Called by the task.
    pub fn is_stopped(&self) -> bool {
        if let Some(watch) = &self.watch {
            watch(self);
        }
        self.stopped.load(Ordering::Relaxed)
    }

    /// The present state of the task.
    pub fn read(&self) -> Reading {
        Reading {
            stage: self.stage.load(Ordering::Acquire),
            done: self.done.load(Ordering::Relaxed),
            total: self.total.load(Ordering::Relaxed),
        }
    }

    /// Begins stage number `stage`, which has `total` items. Called by the task.
    pub fn begin(&self, stage: u64, total: usize) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total as u64, Ordering::Relaxed);
        self.stage.store(stage, Ordering::Release);
    }

    /// Adds `count` items to those that are done. Called by the task.
    pub fn add(&self, count: usize) {
        self.done.fetch_add(count as u64, Ordering::Relaxed);
    }
}

impl fmt::Debug for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Progress")
            .field("reading", &self.read())
            .field("stopped", &self.stopped)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::{Progress, Reading};

    #[test]
    fn a_reading_counts_the_items_of_the_present_stage() {
        let progress = Progress::default();
        progress.begin(0, 10);
        progress.add(4);
        progress.begin(1, 20);
        progress.add(3);
        assert_eq!(progress.read(), Reading { stage: 1, done: 3, total: 20 });
    }

    #[test]
    fn a_requested_stop_can_be_read() {
        let progress = Progress::default();
        assert!(!progress.is_stopped());
        progress.stop();
        assert!(progress.is_stopped());
    }

    #[test]
    fn a_task_can_be_stopped_from_its_own_thread() {
        let progress = Progress::watched_by(|progress| {
            if progress.read().done == 3 {
                progress.stop();
            }
        });
        while !progress.is_stopped() {
            progress.add(1);
        }
        assert_eq!(progress.read().done, 3);
    }
}
