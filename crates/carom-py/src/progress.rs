//! Long tasks: progress is reported to Python, and Ctrl-C is noticed, while they run.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use carom_plan::Progress;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::to_exception;

/// Time between two checks for Ctrl-C. A person notices a delay of a second; a check takes some
/// microseconds.
const CHECK: Duration = Duration::from_millis(40);

/// Runs `work` on a thread of its own and returns its result. Meanwhile this thread calls `tick` every
/// [`CHECK`].
fn beside<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send,
    mut tick: impl FnMut() + Send,
) -> T {
    py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel::<()>();
            let worker = scope.spawn(|| {
                // The channel closes when the work ends, also by a panic.
                let _open = sender;
                work()
            });
            while let Err(mpsc::RecvTimeoutError::Timeout) = receiver.recv_timeout(CHECK) {
                tick();
            }
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        })
    })
}

/// Runs `work` on a thread of its own and returns its result. Meanwhile this thread calls `report`
/// with the number of the stage, the items done and their number, and checks for Ctrl-C. An exception
/// from either stops the work and is raised.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    report: &Py<PyAny>,
    work: impl FnOnce(&Progress) -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    let progress = Progress::default();
    let report_now = || {
        let now = progress.read();
        Python::attach(|py| {
            py.check_signals()?;
            report.call1(py, (now.stage, now.done, now.total)).map(drop)
        })
    };
    let mut raised = None;
    let found = beside(
        py,
        || work(&progress),
        || {
            if raised.is_none() {
                raised = report_now().err();
                if raised.is_some() {
                    progress.stop();
                }
            }
        },
    );
    if let Some(error) = raised {
        return Err(error);
    }
    let found = found.map_err(|error| to_exception(py, &error))?;
    report_now()?;
    Ok(found)
}

/// Runs `work` on a thread of its own and returns its result. Ctrl-C sets `stop`, after which the work
/// returns what it has found so far. A second Ctrl-C, and another exception of a signal handler, set
/// it too and are raised when the work has ended.
pub(crate) fn until_interrupted<T: Send>(
    py: Python<'_>,
    stop: &AtomicBool,
    work: impl FnOnce() -> Result<T, carom::Error> + Send,
) -> PyResult<T> {
    let (mut interrupts, mut raised) = (0, None);
    let found = beside(py, work, || {
        Python::attach(|py| {
            if let Err(error) = py.check_signals() {
                stop.store(true, Ordering::Relaxed);
                interrupts += 1;
                if interrupts > 1 || !error.is_instance_of::<PyKeyboardInterrupt>(py) {
                    raised = Some(error);
                }
            }
        });
    });
    match raised {
        Some(error) => Err(error),
        None => found.map_err(|error| to_exception(py, &error)),
    }
}
