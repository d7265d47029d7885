//! `carom_trace`: a simulated shot with all its events.

use std::ffi::c_char;
use std::sync::{Arc, OnceLock};

use carom::format::Node;
use carom::trace::{Orientations, TraceEnd, Waypoint};
use carom::{ErrorKind, ShotFile, Trace};

use crate::entry::{ErrorText, enter, given, index, slice_mut, text, to_c};
use crate::event::{EventArrays, carom_events};
use crate::kinds::{CAROM_END_CAP, CAROM_END_REST, CAROM_END_UNTIL};
use crate::shot::carom_shot;
use crate::state::carom_state;

/// A simulated shot with all its events; immutable. Any number of threads may use it at once.
pub struct carom_trace {
    trace: Trace,
    shot: Arc<ShotFile>,
    orientations: OnceLock<Orientations>,
    events: OnceLock<EventArrays>,
}

impl carom_trace {
    pub(crate) const fn new(trace: Trace, shot: Arc<ShotFile>) -> Self {
        Self { trace, shot, orientations: OnceLock::new(), events: OnceLock::new() }
    }

    fn orientations(&self) -> &Orientations {
        self.orientations.get_or_init(|| self.trace.orientations())
    }
}

/// Simulates a shot and records all its events.
///
/// Returns the trace, or null with the text of the error.
/// Ownership: free it with carom_trace_free; it keeps what it needs of the shot. Threads: any. A
/// thread that plays many shots is faster with a carom_sim.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_shot_simulate(
    shot: Option<&carom_shot>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_trace>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let file = &given(shot, "shot")?.file;
            Ok(Some(Box::new(carom_trace::new(file.simulate()?, file.clone()))))
        })
    }
}

/// Writes the exact state of a ball at a time into out.
///
/// ball: index in the shot. time: s since the strike, 0 or more; after the end it is the final state.
/// Returns 0, or a negative number for a wrong index or time.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_state(
    trace: Option<&carom_trace>,
    ball: i32,
    time: f64,
    out: Option<&mut carom_state>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (trace, out) = (given(trace, "trace")?, given(out, "out")?);
        let ball = index(ball, trace.shot.balls().len(), "ball")?;
        let state = trace.trace.at(time)?[ball];
        *out = carom_state::new(&state, trace.orientations().at(ball, time));
        Ok(0)
    })
}

/// Writes the exact states of all balls at a time into out.
///
/// time: as in carom_trace_state. out: room for count states; count is the number of balls.
/// Returns 0, or a negative number for a wrong time or count.
/// Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_trace_states(
    trace: Option<&carom_trace>,
    time: f64,
    out: *mut carom_state,
    count: i32,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let trace = given(trace, "trace")?;
        let states = trace.trace.at(time)?;
        if usize::try_from(count) != Ok(states.len()) {
            let what = format!("{count} is not the number of balls");
            return Err(ErrorKind::WrongCount.at("count", what, "give room for every ball"));
        }
        // SAFETY: the caller's promise in the header.
        let out = unsafe { slice_mut(out, states.len(), "out") }?;
        for (ball, (out, state)) in out.iter_mut().zip(&states).enumerate() {
            *out = carom_state::new(state, trace.orientations().at(ball, time));
        }
        Ok(0)
    })
}

/// Writes the arrays of the events into out.
///
/// Returns the number of events, or a negative number for a null pointer.
/// Ownership: the arrays belong to the trace, and live as long. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_events(
    trace: Option<&carom_trace>,
    out: Option<&mut carom_events>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (trace, out) = (given(trace, "trace")?, given(out, "out")?);
        *out = trace.events.get_or_init(|| EventArrays::new(&trace.trace)).to_c();
        Ok(out.event_count)
    })
}

/// Writes points of the path of a ball into out: x, y, z (m) and t (s) of each. The chords between
/// them stay within the tolerance of the exact path.
///
/// tolerance: m, above 0. out: room for count points, four numbers each; null with count 0 to ask for
/// their number.
/// Returns the number of points of the path, which may be more than count; or a negative number.
/// Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_trace_path(
    trace: Option<&carom_trace>,
    ball: i32,
    tolerance: f64,
    out: *mut f64,
    count: i32,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let trace = given(trace, "trace")?;
        let ball = index(ball, trace.shot.balls().len(), "ball")?;
        // A finer path has more points than memory holds.
        if !(tolerance >= 1e-9 && tolerance.is_finite()) {
            let what = format!("{tolerance} m is out of range");
            return Err(ErrorKind::OutOfRange.at("tolerance", what, "write 1e-9 or more"));
        }
        let room = usize::try_from(count).unwrap_or_default();
        // SAFETY: the caller's promise in the header.
        let out = unsafe { slice_mut(out.cast::<[f64; 4]>(), room, "out") }?;
        let points = trace.trace.polyline(ball, tolerance);
        for (out, Waypoint { position, time }) in out.iter_mut().zip(&points) {
            let [x, y, z] = position.to_array();
            *out = [x, y, z, *time];
        }
        Ok(points.len() as i32)
    })
}

/// Time from the strike to the end, s.
///
/// Returns the time, or NaN for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_duration(trace: Option<&carom_trace>) -> f64 {
    enter(&ErrorText::NONE, || Ok(given(trace, "trace")?.trace.duration()))
}

/// What ended the shot.
///
/// Returns CAROM_END_REST, CAROM_END_UNTIL or CAROM_END_CAP, or a negative number for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_end(trace: Option<&carom_trace>) -> i32 {
    enter(&ErrorText::NONE, || {
        Ok(match given(trace, "trace")?.trace.end() {
            TraceEnd::Rest => CAROM_END_REST,
            TraceEnd::Until => CAROM_END_UNTIL,
            TraceEnd::Cap => CAROM_END_CAP,
        })
    })
}

/// The hash over the exact bits of all events and final states. It is the same in every language and
/// on every platform.
///
/// Returns the hash, or 0 for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_hash(trace: Option<&carom_trace>) -> u64 {
    enter(&ErrorText::NONE, || Ok(given(trace, "trace")?.trace.hash()))
}

/// The outcome for a referee, JSON: the first contact, the pocketed balls and more.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_outcome_json(trace: Option<&carom_trace>) -> *mut c_char {
    enter(&ErrorText::NONE, || {
        let trace = &given(trace, "trace")?.trace;
        to_c(trace.outcome().to_node(trace.shot()).to_json())
    })
}

/// The trace as JSON, carom-trace/1.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_to_json(trace: Option<&carom_trace>) -> *mut c_char {
    enter(&ErrorText::NONE, || {
        let carom_trace { trace, shot, .. } = given(trace, "trace")?;
        to_c(trace.to_node_with(shot.to_node().into_owned()).to_json())
    })
}

/// Reads a trace, carom-trace/1.
///
/// Returns the trace, or null with the text of the error.
/// Ownership: free it with carom_trace_free. The text is read in the call. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_trace_from_json(
    json: *const c_char,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_trace>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (trace, shot) = Trace::from_node_with_file(&Node::from_json(text(json, "json")?)?)?;
            Ok(Some(Box::new(carom_trace::new(trace, shot.into()))))
        })
    }
}

/// The shot of a trace.
///
/// Returns the shot, or null for a null pointer.
/// Ownership: free it with carom_shot_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_shot(trace: Option<&carom_trace>) -> Option<Box<carom_shot>> {
    enter(&ErrorText::NONE, || {
        carom_shot::new(given(trace, "trace")?.shot.clone()).map(Box::new).map(Some)
    })
}

/// Frees a trace; null is passed over.
///
/// Ownership: the pointer must not be used afterwards, nor the arrays of its events. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_trace_free(trace: Option<Box<carom_trace>>) {
    enter(&ErrorText::NONE, || {
        drop(trace);
        Ok(())
    });
}
