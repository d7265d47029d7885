//! Many shots at once, into arrays of the caller.

use std::ffi::c_char;

use carom::batch::{BatchArrays, simulate_batch_into, simulate_strikes_into};
use carom::{Error, ErrorKind, Shot};

use crate::entry::{ErrorText, enter, given, runner, slice, slice_mut, too_long};
use crate::shot::{carom_shot, carom_strike};

/// In the pockets of a batch: the ball is on the table at the end.
pub const CAROM_ON_TABLE: i32 = -1;
/// In the pockets of a batch: the ball has left the table.
pub const CAROM_LEFT: i32 = -2;
/// In the pockets of a batch: the shot has no such ball, or failed.
pub const CAROM_PADDING: i32 = -3;

/// Arrays of the caller; those that are null are not wanted, and memory stands in for them.
struct Wanted<'a> {
    position: Result<&'a mut [[f64; 3]], Vec<[f64; 3]>>,
    pocket: Result<&'a mut [i8], Vec<i8>>,
    events: Result<&'a mut [i32], Vec<i32>>,
    balls: usize,
}

impl Wanted<'_> {
    /// # Safety
    /// Each pointer is null or has room for the documented number of values.
    unsafe fn new(
        position: *mut f64,
        pocket: *mut i8,
        events: *mut i32,
        shots: usize,
        balls: usize,
    ) -> Result<Self, Error> {
        let all = shots.checked_mul(balls).ok_or_else(|| too_long("n", shots))?;
        // SAFETY: the caller's promise.
        unsafe {
            Ok(Self {
                position: array(position.cast(), all, "position", [f64::NAN; 3])?,
                pocket: array(pocket, all, "pocket", 0)?,
                events: array(events, shots, "events", 0)?,
                balls,
            })
        }
    }

    fn arrays(&mut self) -> BatchArrays<'_> {
        BatchArrays {
            balls: self.balls,
            final_position: either(&mut self.position),
            pocket: either(&mut self.pocket),
            events: either(&mut self.events),
        }
    }
}

/// # Safety
/// As [`slice_mut`].
unsafe fn array<'a, T: Clone>(
    pointer: *mut T,
    length: usize,
    place: &str,
    filler: T,
) -> Result<Result<&'a mut [T], Vec<T>>, Error> {
    if pointer.is_null() {
        return Ok(Err(vec![filler; length]));
    }
    // SAFETY: the caller's promise.
    unsafe { slice_mut(pointer, length, place) }.map(Ok)
}

fn either<'b, T>(array: &'b mut Result<&mut [T], Vec<T>>) -> &'b mut [T] {
    match array {
        Ok(given) => given,
        Err(own) => own,
    }
}

/// The number of failed rows; with the first failure in words, if there is one.
fn report(failed: &[(usize, Error)], error: &ErrorText) -> Result<i32, Error> {
    if let Some((row, first)) = failed.first() {
        error.note(&first.clone().inside(&format!("[{row}]")));
    }
    Ok(i32::try_from(failed.len()).unwrap_or(i32::MAX))
}

/// Simulates n shots, without traces. The results are the same for any number of threads.
///
/// shots: n of them. balls: columns of a row, at least the balls of the largest shot. threads: 0 for one
/// on each core, 1 for the calling thread.
/// position: n × balls × 3 final centres, m, NaN where a shot has no such ball or failed. pocket:
/// n × balls indices of pockets, or CAROM_ON_TABLE, CAROM_LEFT, CAROM_PADDING. events: n numbers of
/// events. Any of the three may be null.
/// Returns the number of shots that failed, with the text of the first failure; or a negative number
/// with the text of the error.
/// Ownership: the arrays belong to the caller, and are used in the call alone. Threads: any, if no
/// two calls have the same arrays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_batch(
    shots: *const *const carom_shot,
    n: usize,
    balls: i32,
    threads: i32,
    position: *mut f64,
    pocket: *mut i8,
    events: *mut i32,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        let error = ErrorText::new(error, error_size);
        enter(&error, || {
            let shots = slice(shots.cast::<Option<&carom_shot>>(), n, "shots")?;
            let shots = shots.iter().map(|shot| Ok(given(*shot, "shots")?.file.shot()));
            let shots = shots.collect::<Result<Vec<&Shot>, Error>>()?;
            let mut wanted = Wanted::new(position, pocket, events, n, columns(balls)?)?;
            report(&simulate_batch_into(&shots, wanted.arrays(), &runner(threads)?)?, &error)
        })
    }
}

/// Simulates a shot with n strikes on its struck ball, without traces.
///
/// strikes: n of them. balls: columns of a row, at least the balls of the shot. The rest is as in
/// carom_batch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_batch_strikes(
    shot: Option<&carom_shot>,
    strikes: *const carom_strike,
    n: usize,
    balls: i32,
    threads: i32,
    position: *mut f64,
    pocket: *mut i8,
    events: *mut i32,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        let error = ErrorText::new(error, error_size);
        enter(&error, || {
            let shot = given(shot, "shot")?.file.shot();
            let strikes = slice(strikes, n, "strikes")?;
            let mut wanted = Wanted::new(position, pocket, events, n, columns(balls)?)?;
            let strike = |row: usize| strikes[row].strike_on(shot);
            let runner = runner(threads)?;
            report(&simulate_strikes_into(shot, n, strike, wanted.arrays(), &runner)?, &error)
        })
    }
}

fn columns(balls: i32) -> Result<usize, Error> {
    usize::try_from(balls).map_err(|_| {
        let what = format!("{balls} is out of range");
        ErrorKind::OutOfRange.at("balls", what, "write the number of balls of the largest shot")
    })
}
