//! Long tasks: progress is reported to Python, and Ctrl-C is noticed, while they run.

use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use carom_plan::Progress;
use pyo3::prelude::*;

use crate::error::to_exception;

/// Time between two checks for Ctrl-C. A person notices a delay of a second; a check takes some
/// microseconds.
const CHECK: Duration = Duration::from_millis(40);

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
    let (found, raised) = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel::<()>();
            let worker = scope.spawn(|| {
                // The channel closes when the work ends, also by a panic.
                let _open = sender;
                work(&progress)
            });
            let mut raised = None;
            while let Err(mpsc::RecvTimeoutError::Timeout) = receiver.recv_timeout(CHECK) {
                if raised.is_none() {
                    raised = report_now().err();
                    if raised.is_some() {
                        progress.stop();
                    }
                }
            }
            let found = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            (found, raised)
        })
    });
    if let Some(error) = raised {
        return Err(error);
    }
    let found = found.map_err(|error| to_exception(py, &error))?;
    report_now()?;
    Ok(found)
}
