//! Many shots at once, without traces: the same results in the same order for any number of
//! threads.

use alloc::borrow::Cow;
use alloc::vec;
use alloc::vec::Vec;

use crate::error::Error;
use crate::event::{Event, EventKind, Recorder};
use crate::limits::{MAX_BALLS, SMALL_CAPACITY};
use crate::noise::Perception;
use crate::resolve::cue_ball::Strike;
use crate::simulate::Simulation;
use crate::{MotionState, Noise, Shot};

/// Shots that one thread takes at a time: a few hundred microseconds of work, so that handing
/// them out costs nothing and the threads still end together.
#[cfg(feature = "parallel")]
const CHUNK: usize = 64;

/// Pocket index of a ball that is on the table at the end.
pub const ON_TABLE: i8 = -1;
/// Pocket index of a ball that has left the table.
pub const OFF_TABLE: i8 = -2;
/// Pocket index where a shot has no such ball.
pub const PADDING: i8 = -3;

/// Results of a batch: `shots` rows of `balls` columns each, in the order of the input. A failed
/// shot's row has NaN positions, [`PADDING`] pockets and 0 events.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BatchResult {
    /// Number of shots.
    pub shots: usize,
    /// Balls of the largest shot.
    pub balls: usize,
    /// Final centres in the file's frame, m, NaN where a shot has no such ball.
    pub final_position: Vec<[f64; 3]>,
    /// Index of the pocket that took the ball, in the order of `Table::pockets`, or
    /// [`ON_TABLE`], [`OFF_TABLE`], [`PADDING`].
    pub pocket: Vec<i8>,
    /// Number of events of each shot.
    pub events: Vec<i32>,
    /// The shots that failed, by index, in ascending order.
    pub errors: Vec<(usize, Error)>,
}

/// Simulates every shot. `threads`: how many, or all cores; `done` is told after every piece of
/// work how many more shots have been simulated, from any thread.
pub fn simulate_batch<S: AsRef<Shot> + Sync>(
    shots: &[S],
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
) -> BatchResult {
    let balls = shots.iter().map(|s| s.as_ref().balls.len()).max().unwrap_or(0);
    run(shots.len(), balls, threads, done, &|k| {
        let shot = shots[k].as_ref();
        Ok((Cow::Borrowed(shot), shot.strike))
    })
}

/// Simulates `shot` once for each of `strikes`, played on its struck ball. A strike that a shot
/// file would refuse, and any strike if the shot has none, is among the errors. `threads` and
/// `done` as in [`simulate_batch`].
pub fn simulate_strikes(
    shot: &Shot,
    strikes: &[Strike],
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
) -> BatchResult {
    let struck = shot.strike.as_ref().map_or(0, |(ball, _)| *ball);
    run(strikes.len(), shot.balls.len(), threads, done, &|k| {
        let strike = strikes[k];
        shot.resolve_strike(&strike)?;
        Ok((Cow::Borrowed(shot), Some((struck, strike))))
    })
}

/// As [`simulate_strikes`], with the balls beside where `shot` has them: strike k is played on layout
/// number `first` + k of this seed, as [`Perception::places`] draws it. `shot` is then what the player sees
/// and plans on, the layouts are where the balls may truly lie: to err about one is to err about the other.
///
/// # Errors
/// As [`Perception::check`].
pub fn simulate_seen(
    shot: &Shot,
    strikes: &[Strike],
    perception: &Perception,
    seed: u64,
    first: u64,
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<BatchResult, Error> {
    perception.check()?;
    let struck = shot.strike.as_ref().map_or(0, |(ball, _)| *ball);
    Ok(run(strikes.len(), shot.balls.len(), threads, done, &|k| {
        let strike = Some((struck, strikes[k]));
        let places = perception.places(shot, seed, first.wrapping_add(k as u64));
        Ok((Cow::Owned(shot.with_balls(places, strike)?), strike))
    }))
}

/// Simulates `count` of the strikes that come out when `shot`'s own is meant: row k is the strike
/// [`draw_strikes`] has there, number `first` + k of this seed. A drawn strike that a shot file
/// would refuse is among the errors; `shot`'s policy says whether a miscue is played. `threads`
/// and `done` as in [`simulate_batch`].
///
/// # Errors
/// As [`draw_strikes`].
pub fn simulate_noisy(
    shot: &Shot,
    noise: &Noise,
    seed: u64,
    first: u64,
    count: usize,
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<BatchResult, Error> {
    let strikes = draw_strikes(shot, noise, seed, first, count)?;
    Ok(simulate_strikes(shot, &strikes, threads, done))
}

/// The strikes number `first`.. of this seed that come out when `shot`'s own is meant.
///
/// # Errors
/// [`Error::Input`] if the shot has no strike, or [`Noise::check`] refuses.
pub fn draw_strikes(
    shot: &Shot,
    noise: &Noise,
    seed: u64,
    first: u64,
    count: usize,
) -> Result<Vec<Strike>, Error> {
    noise.check()?;
    let Some((ball, meant)) = shot.strike else {
        return Err(Error::input(
            "strike",
            "the shot has none that could be varied",
            "give it one",
        ));
    };
    let radius = shot.balls[ball].ball.radius;
    let strike = |k| noise.draw(&meant, radius, seed, first.wrapping_add(k));
    Ok((0..count as u64).map(strike).collect())
}

/// What shot `k` is.
type Item<'a> =
    dyn Fn(usize) -> Result<(Cow<'a, Shot>, Option<(usize, Strike)>), Error> + Sync + 'a;

fn run(
    shots: usize,
    balls: usize,
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
    item: &Item<'_>,
) -> BatchResult {
    let mut result = BatchResult {
        shots,
        balls,
        final_position: vec![[f64::NAN; 3]; shots * balls],
        pocket: vec![PADDING; shots * balls],
        events: vec![0; shots],
        errors: Vec::new(),
    };
    let width = balls.max(1);
    let rows = Rows {
        position: &mut result.final_position,
        pocket: &mut result.pocket,
        events: &mut result.events,
    };
    result.errors = if balls <= SMALL_CAPACITY {
        distribute::<SMALL_CAPACITY>(rows, width, threads, done, item)
    } else {
        distribute::<MAX_BALLS>(rows, width, threads, done, item)
    };
    result.errors.sort_by_key(|(k, _)| *k);
    result
}

/// The rows of some consecutive shots.
struct Rows<'a> {
    position: &'a mut [[f64; 3]],
    pocket: &'a mut [i8],
    events: &'a mut [i32],
}

#[cfg(feature = "parallel")]
fn distribute<const N: usize>(
    rows: Rows<'_>,
    width: usize,
    threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
    item: &Item<'_>,
) -> Vec<(usize, Error)> {
    use rayon::prelude::*;
    let work = move || {
        let Rows { position, pocket, events } = rows;
        let pieces = position
            .par_chunks_mut(CHUNK * width)
            .zip(pocket.par_chunks_mut(CHUNK * width))
            .zip(events.par_chunks_mut(CHUNK));
        pieces
            .enumerate()
            .map_init(
                || alloc::boxed::Box::new(Simulation::<N>::new()),
                |simulation, (c, ((position, pocket), events))| {
                    let count = events.len();
                    let rows = Rows { position, pocket, events };
                    let errors = play_rows(simulation, rows, c * CHUNK, width, item);
                    done(count);
                    errors
                },
            )
            .reduce(Vec::new, |mut all, mut more| {
                all.append(&mut more);
                all
            })
    };
    match threads.map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build()) {
        Some(Ok(pool)) => pool.install(work),
        // No pool of that size to be had: the global one gives the same results.
        Some(Err(_)) | None => work(),
    }
}

#[cfg(not(feature = "parallel"))]
fn distribute<const N: usize>(
    rows: Rows<'_>,
    width: usize,
    _threads: Option<usize>,
    done: &(dyn Fn(usize) + Sync),
    item: &Item<'_>,
) -> Vec<(usize, Error)> {
    let count = rows.events.len();
    let mut simulation = alloc::boxed::Box::new(Simulation::<N>::new());
    let errors = play_rows(&mut simulation, rows, 0, width, item);
    done(count);
    errors
}

/// Plays the shots `first`.. that `rows` has room for.
fn play_rows<const N: usize>(
    simulation: &mut Simulation<N>,
    rows: Rows<'_>,
    first: usize,
    width: usize,
    item: &Item<'_>,
) -> Vec<(usize, Error)> {
    let mut errors = Vec::new();
    let rows_of_balls = rows.position.chunks_mut(width).zip(rows.pocket.chunks_mut(width));
    for (k, ((position, pocket), events)) in rows_of_balls.zip(rows.events).enumerate() {
        let played = item(first + k).and_then(|(shot, strike)| {
            let row = &mut pocket[..shot.balls.len()];
            row.fill(ON_TABLE);
            let summary = simulation
                .play_strike(&shot, strike, &mut Pockets { row })
                .map_err(|failure| shot.explain(failure, strike.as_ref().map(|(_, s)| s)))?;
            *events = summary.events as i32;
            for (i, place) in position[..shot.balls.len()].iter_mut().enumerate() {
                let state = simulation.file_state(i, &shot, summary.duration);
                *place = state.position.to_array();
                if state.motion == MotionState::OffTable {
                    pocket[i] = OFF_TABLE;
                }
            }
            Ok(())
        });
        if let Err(error) = played {
            pocket.fill(PADDING);
            errors.push((first + k, error));
        }
    }
    errors
}

/// Notes which pocket took which ball.
struct Pockets<'a> {
    row: &'a mut [i8],
}

impl Recorder for Pockets<'_> {
    #[inline(always)]
    fn record(&mut self, event: &Event<'_>) {
        if let EventKind::PocketCollision(pocket) = event.kind {
            self.row[usize::from(event.balls[0])] = pocket as i8;
        }
    }
}
