//! Long tasks: progress is reported to Python, and Ctrl-C is noticed, while they run.
//!
//! A task runs on a thread of its own, and the calling thread watches it. If the operating system
//! refuses that thread, the task runs on the calling thread and looks after itself now and then.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use carom_plan::Progress;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::to_exception;

/// Time between two checks for Ctrl-C. A person notices a delay of a second; a check takes some
/// microseconds.
const CHECK: Duration = Duration::from_millis(40);

/// The time of the last check of a task that has to watch itself; none if another thread watches it.
#[derive(Default)]
struct OwnWatch(Mutex<Option<Instant>>);

impl OwnWatch {
    fn begin(&self) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(Instant::now());
    }

    /// Whether the task has to check now.
    fn is_due(&self) -> bool {
        // A lock that is held belongs to another thread of the task, which checks.
        let Ok(mut last) = self.0.try_lock() else { return false };
        let due = last.is_some_and(|last| last.elapsed() >= CHECK);
        if due {
            *last = Some(Instant::now());
        }
        due
    }
}

/// Runs `work` on a thread of its own and returns its result. Meanwhile this thread calls `tick` every
/// [`CHECK`]. Without another thread `work` runs on this one, and `own` begins.
fn beside<T: Send>(
    py: Python<'_>,
    own: &OwnWatch,
    work: impl FnOnce() -> T + Send,
    tick: impl Fn() + Sync,
) -> T {
    // The closure of a refused thread is lost, so the work must not be inside it.
    let work = Mutex::new(Some(work));
    let take = || work.lock().ok().and_then(|mut work| work.take()).map(|work| work());
    let done = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel::<()>();
            let worker = thread::Builder::new().spawn_scoped(scope, || {
                // The channel closes when the work ends, also by a panic.
                let _open = sender;
                take()
            });
            let Ok(worker) = worker else {
                own.begin();
                return take();
            };
            while let Err(mpsc::RecvTimeoutError::Timeout) = receiver.recv_timeout(CHECK) {
                tick();
            }
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        })
    });
    done.expect("the work is taken once")
}

/// Reports the progress of a task to Python and checks for Ctrl-C.
struct Reporter {
    report: Py<PyAny>,
    /// The first exception of a report or of Ctrl-C. It stops the task.
    raised: Mutex<Option<PyErr>>,
    own: OwnWatch,
}

impl Reporter {
    fn report(&self, progress: &Progress) {
        let mut raised = self.raised.lock().unwrap_or_else(PoisonError::into_inner);
        if raised.is_none() {
            *raised = Python::attach(|py| self.report_now(py, progress)).err();
            if raised.is_some() {
                progress.stop();
            }
        }
    }

    fn report_now(&self, py: Python<'_>, progress: &Progress) -> PyResult<()> {
        let now = progress.read();
        py.check_signals()?;
        self.report.call1(py, (now.stage, now.done, now.total)).map(drop)
    }
}

/// Runs `work` on a thread of its own and returns its result. Meanwhile this thread calls `report`
/// with the number of the stage, the items done and their number, and checks for Ctrl-C. An exception
/// from either stops the work and is raised.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    report: &Py<PyAny>,
    work: impl FnOnce(&Progress) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    run_with(py, report, &Watch::Beside(&|| ()), work)
}

/// Which thread a task that calls Python has.
pub(crate) enum Watch<'w> {
    /// A thread of its own. After a stop the watching thread calls this function again and again, until
    /// the task has ended.
    Beside(&'w (dyn Fn() + Sync)),
    /// The calling thread, so that Ctrl-C arrives in Python's code that the task calls.
    Here,
}

/// As [`run`], on the thread of `watch`.
pub(crate) fn run_with<T: Send>(
    py: Python<'_>,
    report: &Py<PyAny>,
    watch: &Watch<'_>,
    work: impl FnOnce(&Progress) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    let reporter = Arc::new(Reporter {
        report: report.clone_ref(py),
        raised: Mutex::default(),
        own: OwnWatch::default(),
    });
    let watched = Arc::clone(&reporter);
    let progress = Progress::watched_by(move |progress| {
        if watched.own.is_due() {
            watched.report(progress);
        }
    });
    let found = match watch {
        Watch::Beside(after_stop) => {
            let tick = || {
                reporter.report(&progress);
                if progress.is_stopped() {
                    after_stop();
                }
            };
            beside(py, &reporter.own, || work(&progress), tick)
        }
        Watch::Here => {
            reporter.own.begin();
            py.detach(|| work(&progress))
        }
    };
    if let Some(error) = reporter.raised.lock().unwrap_or_else(PoisonError::into_inner).take() {
        return Err(error);
    }
    let found = found.map_err(|error| to_exception(py, &error))?;
    reporter.report_now(py, &progress)?;
    Ok(found)
}

/// Whether Ctrl-C asked for the end of a task that then returns what it has found so far.
#[derive(Default)]
pub(crate) struct Interrupt {
    asked: AtomicBool,
    /// A second Ctrl-C, or another exception of a signal handler.
    raised: Mutex<Option<PyErr>>,
    own: OwnWatch,
}

impl Interrupt {
    /// Whether the end was asked for. Called by the task.
    pub(crate) fn is_asked(&self) -> bool {
        if self.own.is_due() {
            self.check();
        }
        self.asked.load(Ordering::Relaxed)
    }

    /// Whether the end was asked for, which is forgotten.
    pub(crate) fn take(&self) -> bool {
        self.asked.swap(false, Ordering::Relaxed)
    }

    fn check(&self) {
        Python::attach(|py| {
            if let Err(error) = py.check_signals() {
                let again = self.asked.swap(true, Ordering::Relaxed);
                if again || !error.is_instance_of::<PyKeyboardInterrupt>(py) {
                    *self.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                }
            }
        });
    }
}

/// Runs `work` on a thread of its own and returns its result. Ctrl-C sets `interrupt`, after which
/// the work returns what it has found so far. A second Ctrl-C, and another exception of a signal
/// handler, set it too and are raised when the work has ended.
pub(crate) fn until_interrupted<T: Send>(
    py: Python<'_>,
    interrupt: &Interrupt,
    work: impl FnOnce() -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    watched(py, interrupt, work)?.map_err(|error| to_exception(py, &error))
}

/// As [`until_interrupted`], for work with any result.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    interrupt: &Interrupt,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let found = beside(py, &interrupt.own, work, || interrupt.check());
    match interrupt.raised.lock().unwrap_or_else(PoisonError::into_inner).take() {
        Some(error) => Err(error),
        None => Ok(found),
    }
}
