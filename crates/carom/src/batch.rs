//! Batches: many shots without traces, with the same results in the same order for any number of
//! threads, and on a device ([`Runner::on`]). If a device fails, its shots have an error of the kind
//! [`ErrorKind::System`].

use alloc::borrow::Cow;
use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

use crate::device::{Device, FlatEnds, FlatShots};
use crate::error::{Error, ErrorKind};
use crate::noise::{Errors, StruckBall};
pub use crate::pocket::{OFF_TABLE, ON_TABLE, PADDING, PocketRecorder};
use crate::resolve::cue_ball::Strike;
use crate::runner::Runner;
use crate::simulator::Simulator;
use crate::{MotionState, Noise, Shot, ShotFile};

/// Number of shots that a thread gets at a time: a few hundred microseconds of work, so that the
/// overhead is negligible and all threads end at about the same time.
const CHUNK: usize = 64;

/// Results of a batch: `shots` rows of `balls` columns each, in the order of the input. A failed
/// shot's row has NaN positions, [`PADDING`] pockets and 0 events.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BatchResult {
    /// Number of shots.
    pub shots: usize,
    /// Balls of the largest shot.
    pub balls: usize,
    /// Final centres in the file's coordinates, m, NaN where a shot has no such ball.
    pub final_position: Vec<[f64; 3]>,
    /// Index of the pocket that the ball fell into, in the order of `Table::pockets`, or
    /// [`ON_TABLE`], [`OFF_TABLE`], [`PADDING`].
    pub pocket: Vec<i8>,
    /// Number of events of each shot.
    pub events: Vec<i32>,
    /// The shots that failed, by index, in ascending order.
    pub errors: Vec<(usize, Error)>,
}

/// Arrays of the caller for the results of a batch, with the contents of the fields of
/// [`BatchResult`]: a row for each shot.
#[derive(Debug)]
pub struct BatchArrays<'a> {
    /// Columns of a row, at least the balls of the largest shot.
    pub balls: usize,
    /// `balls` positions a row, m.
    pub final_position: &'a mut [[f64; 3]],
    /// `balls` numbers a row.
    pub pocket: &'a mut [i8],
    /// One number a row.
    pub events: &'a mut [i32],
}

impl BatchArrays<'_> {
    fn check(&self, shots: usize, largest: usize) -> Result<(), Error> {
        let wrong = |place, found: usize, needed: usize| {
            Err(ErrorKind::WrongCount.at(
                place,
                format!("there is room for {found} values, and the batch has {needed}"),
                format!("give an array of {needed}"),
            ))
        };
        if self.balls < largest {
            return wrong("balls", self.balls, largest);
        }
        let all = shots * self.balls;
        for (place, found, needed) in [
            ("final_position", self.final_position.len(), all),
            ("pocket", self.pocket.len(), all),
            ("events", self.events.len(), shots),
        ] {
            if found != needed {
                return wrong(place, found, needed);
            }
        }
        Ok(())
    }
}

/// Simulates every shot, on the threads of `runner`.
pub fn simulate_batch<S: AsRef<Shot> + Sync>(shots: &[S], runner: &Runner) -> BatchResult {
    let balls = largest(shots);
    run(shots.len(), balls, runner, |k| own_item(shots[k].as_ref()))
}

/// As [`simulate_batch`], into arrays of the caller. Returns the shots that failed.
///
/// # Errors
/// [`Error::Input`] if an array has another length than the batch.
pub fn simulate_batch_into<S: AsRef<Shot> + Sync>(
    shots: &[S],
    arrays: BatchArrays<'_>,
    runner: &Runner,
) -> Result<Vec<(usize, Error)>, Error> {
    arrays.check(shots.len(), largest(shots))?;
    Ok(run_into(arrays, runner, |k| own_item(shots[k].as_ref())))
}

/// As [`simulate_strikes`], into arrays of the caller with a row for each of `strikes` strikes;
/// `strike` gives them by index. Returns the strikes that failed.
///
/// # Errors
/// [`Error::Input`] if an array has another length than the batch.
pub fn simulate_strikes_into(
    shot: &Shot,
    strikes: usize,
    strike: impl Fn(usize) -> Strike + Sync + Send,
    arrays: BatchArrays<'_>,
    runner: &Runner,
) -> Result<Vec<(usize, Error)>, Error> {
    arrays.check(strikes, shot.balls.len())?;
    Ok(run_into(arrays, runner, |k| struck_item(shot, strike(k))))
}

fn largest<S: AsRef<Shot>>(shots: &[S]) -> usize {
    shots.iter().map(|s| s.as_ref().balls.len()).max().unwrap_or(0)
}

fn own_item(shot: &Shot) -> Result<Item<'_>, Error> {
    Ok((Cow::Borrowed(shot), shot.strike))
}

/// `shot` with another strike on its struck ball.
fn struck_item(shot: &Shot, strike: Strike) -> Result<Item<'_>, Error> {
    shot.resolve_strike(&strike)?;
    let struck = shot.strike.as_ref().map_or(0, |(ball, _)| *ball);
    Ok((Cow::Borrowed(shot), Some((struck, strike))))
}

/// Simulates `shot` once for each of `strikes`, played on its struck ball. A strike that a shot
/// file would refuse fails; if the shot itself has no strike, every one fails.
pub fn simulate_strikes(shot: &Shot, strikes: &[Strike], runner: &Runner) -> BatchResult {
    run(strikes.len(), shot.balls.len(), runner, |k| struck_item(shot, strikes[k]))
}

/// As [`simulate_strikes`], with every strike at the elevation that `shot` gives it
/// ([`Shot::at_own_elevation`]). The elevations in `strikes` are not used.
pub fn simulate_at_own_elevation(shot: &Shot, strikes: &[Strike], runner: &Runner) -> BatchResult {
    run(strikes.len(), shot.balls.len(), runner, |k| {
        struck_item(shot, shot.at_own_elevation(&strikes[k]))
    })
}

/// As [`simulate_strikes`], with the other `errors`, those of perception and the contacts that
/// cling: the strike with index k is played in variant number `first` plus k. With an error of
/// perception `shot` holds the positions that the player sees and plans on; the layouts of the
/// variants hold possible true positions. The error has the same distribution in both directions.
///
/// # Errors
/// As [`Errors::check`]; and [`Error::Input`] if the shot has no strike.
pub fn simulate_variants(
    shot: &Shot,
    strikes: &[Strike],
    errors: &Errors,
    first: u64,
    runner: &Runner,
) -> Result<BatchResult, Error> {
    simulate_variants_in_turn(core::slice::from_ref(shot), strikes, errors, first, runner)
}

/// As [`simulate_variants`], on several `shots` with the same balls and the same struck ball, such as
/// one shot on several tables: variant number v is played on the shot with index v modulo their count.
///
/// # Errors
/// As [`simulate_variants`], also without shots, and if the runner's device fails.
pub fn simulate_variants_in_turn(
    shots: &[Shot],
    strikes: &[Strike],
    errors: &Errors,
    first: u64,
    runner: &Runner,
) -> Result<BatchResult, Error> {
    errors.check()?;
    let some = shots.first().ok_or_else(no_strike)?;
    let (struck, _) = own_strike(some)?;
    let result = run(strikes.len(), some.balls.len(), runner, |k| {
        let number = first.wrapping_add(k as u64);
        let shot = &shots[(number % shots.len() as u64) as usize];
        let strike = Some((struck, strikes[k]));
        if errors.are_of_the_strike() {
            shot.resolve_strike(&strikes[k])?;
            return Ok((Cow::Borrowed(shot), strike));
        }
        let variant = errors.shot(shot, strike, number)?;
        if errors.perception.is_exact() {
            variant.resolve_strike(&strikes[k])?;
        }
        Ok((variant, strike))
    });
    match result.errors.iter().find(|(_, error)| error.kind() == ErrorKind::System) {
        Some((_, failure)) => Err(failure.clone()),
        None => Ok(result),
    }
}

/// The most strikes of one call of [`draw_strikes`]; they take 4 GB of memory.
pub const MAX_DRAWN: usize = 100_000_000;

/// Variants `first` to `first` + `n` − 1, of this seed, of `shot`'s own strike under `noise`
/// ([`Noise::draw`]).
///
/// # Errors
/// [`Error::Input`] if the shot has no strike, as [`Noise::check`], and for more than [`MAX_DRAWN`]
/// strikes.
pub fn draw_strikes(
    shot: &Shot,
    noise: &Noise,
    n: usize,
    seed: u64,
    first: u64,
) -> Result<Vec<Strike>, Error> {
    noise.check()?;
    let (ball, meant) = own_strike(shot)?;
    if n > MAX_DRAWN {
        let remedy = format!("draw at most {MAX_DRAWN} at a time, and the next ones with `first`");
        return Err(ErrorKind::OutOfRange.at("n", format!("{n} strikes are too many"), remedy));
    }
    let struck = StruckBall::of(shot, &shot.balls[ball].ball);
    let strike = |k| noise.draw(&meant, &struck, seed, first.wrapping_add(k));
    Ok((0..n as u64).map(strike).collect())
}

/// Variant `index`, of this seed, of `shot` under `noise`: an ordinary shot with the strike and the
/// cling of that variant. It simulates to the bits of the variant's row.
///
/// # Errors [`Error::Input`] if the shot has no strike, as [`Noise::check`], and if the drawn
/// strike cannot be played.
pub fn draw_variant(
    shot: &ShotFile,
    noise: &Noise,
    seed: u64,
    index: u64,
) -> Result<ShotFile, Error> {
    let strike = draw_strikes(shot, noise, 1, seed, index)?[0];
    let struck = shot.with_strike(&strike)?;
    if noise.cling_probability == 0.0 {
        return Ok(struck);
    }
    Ok(struck.with_cling(noise.draw_cling(seed, index)))
}

/// The struck ball's index and the strike of `shot`.
fn own_strike(shot: &Shot) -> Result<(usize, Strike), Error> {
    shot.strike.ok_or_else(no_strike)
}

fn no_strike() -> Error {
    ErrorKind::NoStrike.at("strike", "the shot has no strike to vary", "give it one")
}

/// A shot of a batch, and the strike that is played in it: the struck ball's index, and the strike.
type Item<'a> = (Cow<'a, Shot>, Option<(usize, Strike)>);

/// Plays `shots` shots of at most `balls` balls each; `item` gives them by index.
fn run<'a>(
    shots: usize,
    balls: usize,
    runner: &Runner,
    item: impl Fn(usize) -> Result<Item<'a>, Error> + Sync + Send,
) -> BatchResult {
    let mut result = BatchResult {
        shots,
        balls,
        final_position: vec![[f64::NAN; 3]; shots * balls],
        pocket: vec![PADDING; shots * balls],
        events: vec![0; shots],
        errors: Vec::new(),
    };
    let BatchResult { final_position, pocket, events, .. } = &mut result;
    result.errors = run_into(BatchArrays { balls, final_position, pocket, events }, runner, item);
    result
}

/// As [`run`], into arrays of the right lengths. Returns the errors.
fn run_into<'a>(
    arrays: BatchArrays<'_>,
    runner: &Runner,
    item: impl Fn(usize) -> Result<Item<'a>, Error> + Sync + Send,
) -> Vec<(usize, Error)> {
    if let Some(device) = runner.device() {
        return run_on(device, arrays, runner, item);
    }
    let BatchArrays { balls, final_position, pocket, events } = arrays;
    let width = balls.max(1);
    let chunks = final_position.chunks_mut(CHUNK * width);
    let chunks = chunks.zip(pocket.chunks_mut(CHUNK * width));
    let chunks = chunks.zip(events.chunks_mut(CHUNK)).enumerate();
    let rows = chunks.map(|(c, ((position, pocket), events))| Chunk {
        first: c * CHUNK,
        position,
        pocket,
        events,
    });
    let errors = runner
        .map(rows, Simulator::new, |simulator, rows| play_rows(simulator, rows, width, &item));
    errors.into_iter().flatten().collect()
}

/// As [`run_into`], on `device`. What the device cannot play is played here: shots with too many balls,
/// and those that fail, for their errors.
fn run_on<'a>(
    device: &dyn Device,
    mut arrays: BatchArrays<'_>,
    runner: &Runner,
    item: impl Fn(usize) -> Result<Item<'a>, Error> + Sync + Send,
) -> Vec<(usize, Error)> {
    let (most, count) = (device.most_shots().max(1), arrays.events.len());
    let mut simulator = Simulator::new();
    let mut errors = Vec::new();
    for first in (0..count).step_by(most) {
        let end = count.min(first + most);
        let chunks = (first..end).step_by(CHUNK).map(|k| k..end.min(k + CHUNK));
        let items = runner.map(chunks, || (), |(), chunk| chunk.map(&item).collect::<Vec<_>>());
        let mut on_device = Vec::new();
        let mut flat = FlatShots::default();
        for (k, item) in (first..).zip(items.into_iter().flatten()) {
            match item {
                Ok((shot, strike)) if shot.balls.len() <= device.most_balls() => {
                    flat.push(&shot, strike);
                    on_device.push((k, shot, strike));
                }
                item => errors.extend(arrays.play(k, &item, &mut simulator)),
            }
        }
        let ends = device.play(&flat);
        for (place, (k, shot, strike)) in on_device.into_iter().enumerate() {
            match &ends {
                Ok(ends) if ends.end[place].events > 0 => {
                    arrays.copy(k, shot.balls.len(), ends, place);
                }
                Ok(_) => errors.extend(arrays.play(k, &Ok((shot, strike)), &mut simulator)),
                Err(error) => errors.extend(arrays.play(k, &Err(error.clone()), &mut simulator)),
            }
        }
    }
    errors.sort_by_key(|(k, _)| *k);
    errors
}

impl BatchArrays<'_> {
    /// Writes the row `k`, of `count` balls, with the results of the shot at `place`.
    fn copy(&mut self, k: usize, count: usize, ends: &FlatEnds, place: usize) {
        let row = k * self.balls..(k + 1) * self.balls;
        let from = place * ends.width;
        self.events[k] = ends.end[place].events as i32;
        let (pockets, padding) = self.pocket[row.clone()].split_at_mut(count);
        pockets.copy_from_slice(&ends.pocket[from..][..count]);
        padding.fill(PADDING);
        let (places, padding) = self.final_position[row].split_at_mut(count);
        let positions = ends.position[from..][..count].iter().map(|position| position.to_array());
        places.iter_mut().zip(positions).for_each(|(to, from)| *to = from);
        padding.fill([f64::NAN; 3]);
    }

    /// Plays `item` here and writes it to the row `k`. Returns its error.
    fn play(
        &mut self,
        k: usize,
        item: &Result<Item<'_>, Error>,
        simulator: &mut Simulator,
    ) -> Vec<(usize, Error)> {
        let row = Chunk {
            first: k,
            position: &mut self.final_position[k * self.balls..][..self.balls],
            pocket: &mut self.pocket[k * self.balls..][..self.balls],
            events: &mut self.events[k..=k],
        };
        play_rows(simulator, row, self.balls.max(1), |_| item.clone())
    }
}

/// The results of some consecutive shots.
struct Chunk<'a> {
    /// Index of the first of them.
    first: usize,
    position: &'a mut [[f64; 3]],
    pocket: &'a mut [i8],
    events: &'a mut [i32],
}

/// Plays the shots of a chunk. Returns the errors of those that failed.
fn play_rows<'a>(
    simulator: &mut Simulator,
    rows: Chunk<'_>,
    width: usize,
    item: impl Fn(usize) -> Result<Item<'a>, Error>,
) -> Vec<(usize, Error)> {
    let mut errors = Vec::new();
    let rows_of_balls = rows.position.chunks_mut(width).zip(rows.pocket.chunks_mut(width));
    for (k, ((position, pocket), events)) in rows_of_balls.zip(rows.events).enumerate() {
        let played = item(rows.first + k).and_then(|(shot, strike)| {
            let count = shot.balls.len();
            position[count..].fill([f64::NAN; 3]);
            pocket[count..].fill(PADDING);
            let mut recorder = PocketRecorder::new(&mut pocket[..count]);
            let summary = simulator.play_strike(&shot, strike, &mut recorder)?;
            *events = summary.events as i32;
            for (i, place) in position[..count].iter_mut().enumerate() {
                let state = simulator.file_state(i, &shot, summary.duration);
                *place = state.position.to_array();
                if state.motion == MotionState::OffTable {
                    pocket[i] = OFF_TABLE;
                }
            }
            Ok(())
        });
        if let Err(error) = played {
            position.fill([f64::NAN; 3]);
            pocket.fill(PADDING);
            *events = 0;
            errors.push((rows.first + k, error));
        }
    }
    errors
}
