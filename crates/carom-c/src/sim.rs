//! `carom_sim`: one shot after another, with memory that is used again.

use std::ffi::c_char;

use carom::{Error, Simulator};

use crate::entry::{ErrorText, enter, given};
use crate::shot::carom_shot;
use crate::trace::carom_trace;

/// Plays one shot after another and keeps their memory. One thread uses it at a time.
#[derive(Default)]
pub struct carom_sim {
    simulator: Simulator,
    played: Option<carom_trace>,
}

/// Makes a simulator, for one thread.
///
/// Ownership: free it with carom_sim_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_sim_new() -> Option<Box<carom_sim>> {
    enter(&ErrorText::NONE, || Ok(Some(Box::default())))
}

/// Simulates a shot and records all its events.
///
/// Returns the trace, or null with the text of the error.
/// Ownership: the trace belongs to the simulator. It, and the arrays of its events, are valid until the
/// next call of this function or of carom_sim_free. Threads: one at a time for each simulator.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_sim_play(
    sim: Option<&mut carom_sim>,
    shot: Option<&carom_shot>,
    error: *mut c_char,
    error_size: i32,
) -> *const carom_trace {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (sim, file) = (given(sim, "sim")?, &given(shot, "shot")?.file);
            sim.played = None;
            let trace = sim.simulator.record(file.shot()).map_err(|error| match error {
                Error::TooManyEvents(mut cap) => {
                    cap.shot = file.to_json();
                    Error::TooManyEvents(cap)
                }
                other => other,
            })?;
            Ok(std::ptr::from_ref(sim.played.insert(carom_trace::new(trace, file.clone()))))
        })
    }
}

/// Frees a simulator; null is passed over.
///
/// Ownership: the pointer must not be used afterwards, nor its trace. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_sim_free(sim: Option<Box<carom_sim>>) {
    enter(&ErrorText::NONE, || {
        drop(sim);
        Ok(())
    });
}
