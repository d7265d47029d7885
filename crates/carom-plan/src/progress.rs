//! The progress of a long task, shared between its threads and the thread that watches it.

use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The finished part of a task, and whether a stop was requested.
///
/// The functions of this crate take a `&Progress`. Another thread may read it while they work, and
/// may stop them; a stopped task returns within some milliseconds. To run a task without watching
/// it, pass `&Progress::default()`.
#[derive(Debug, Default)]
pub struct Progress {
    stage: AtomicU64,
    done: AtomicU64,
    total: AtomicU64,
    stopped: AtomicBool,
}

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
    /// Requests that the task ends early.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether an early end was requested.
    pub fn is_stopped(&self) -> bool {
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
}
