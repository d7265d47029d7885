//! Batches: many shots without traces, with the same results in the same order for any number of
//! threads.

use alloc::borrow::Cow;
use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

use crate::error::{Error, ErrorKind};
use crate::event::{Event, EventKind, Recorder};
use crate::noise::{Errors, StruckBall};
use crate::resolve::cue_ball::Strike;
use crate::runner::Runner;
use crate::simulator::Simulator;
use crate::{MotionState, Noise, Shot, ShotFile};

/// Number of shots that a thread gets at a time: a few hundred microseconds of work, so that the
/// overhead is negligible and all threads end at about the same time.
const CHUNK: usize = 64;

/// Pocket index of a ball that is on the table at the end.
pub const ON_TABLE: i8 = -1;
/// Pocket index of a ball that has left the table.
pub const OFF_TABLE: i8 = -2;
/// Pocket index in a column for which the shot has no ball, and in the row of a failed shot.
pub const PADDING: i8 = -3;

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

/// Simulates every shot, on the threads of `runner`.
pub fn simulate_batch<S: AsRef<Shot> + Sync>(shots: &[S], runner: &Runner) -> BatchResult {
    let balls = shots.iter().map(|s| s.as_ref().balls.len()).max().unwrap_or(0);
    run(shots.len(), balls, runner, |k| {
        let shot = shots[k].as_ref();
        Ok((Cow::Borrowed(shot), shot.strike))
    })
}

/// Simulates `shot` once for each of `strikes`, played on its struck ball. A strike that a shot
/// file would refuse fails; if the shot itself has no strike, every one fails.
pub fn simulate_strikes(shot: &Shot, strikes: &[Strike], runner: &Runner) -> BatchResult {
    let struck = shot.strike.as_ref().map_or(0, |(ball, _)| *ball);
    run(strikes.len(), shot.balls.len(), runner, |k| {
        let strike = strikes[k];
        shot.resolve_strike(&strike)?;
        Ok((Cow::Borrowed(shot), Some((struck, strike))))
    })
}

/// As [`simulate_strikes`], with every strike at the elevation that `shot` gives it
/// ([`Shot::at_own_elevation`]). The elevations in `strikes` are not used.
pub fn simulate_at_own_elevation(shot: &Shot, strikes: &[Strike], runner: &Runner) -> BatchResult {
    let struck = shot.strike.as_ref().map_or(0, |(ball, _)| *ball);
    run(strikes.len(), shot.balls.len(), runner, |k| {
        let strike = shot.at_own_elevation(&strikes[k]);
        shot.resolve_strike(&strike)?;
        Ok((Cow::Borrowed(shot), Some((struck, strike))))
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
/// As [`simulate_variants`], also without shots.
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
    Ok(run(strikes.len(), some.balls.len(), runner, |k| {
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
    }))
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
    let width = balls.max(1);
    let chunks = result.final_position.chunks_mut(CHUNK * width);
    let chunks = chunks.zip(result.pocket.chunks_mut(CHUNK * width));
    let chunks = chunks.zip(result.events.chunks_mut(CHUNK)).enumerate();
    let rows = chunks.map(|(c, ((position, pocket), events))| Chunk {
        first: c * CHUNK,
        position,
        pocket,
        events,
    });
    let errors = runner
        .map(rows, Simulator::new, |simulator, rows| play_rows(simulator, rows, width, &item));
    result.errors = errors.into_iter().flatten().collect();
    result
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
            pocket.fill(PADDING);
            errors.push((rows.first + k, error));
        }
    }
    errors
}

/// Records the pocket that each ball fell into: its index in `Table::pockets`, or [`ON_TABLE`].
#[derive(Debug)]
pub struct PocketRecorder<'a> {
    pockets: &'a mut [i8],
}

impl<'a> PocketRecorder<'a> {
    /// A recorder that writes into `pockets`, one number for each ball of the shot.
    pub fn new(pockets: &'a mut [i8]) -> Self {
        pockets.fill(ON_TABLE);
        Self { pockets }
    }
}

impl Recorder for PocketRecorder<'_> {
    #[inline(always)]
    fn record(&mut self, event: &Event<'_>) {
        if let EventKind::PocketCollision(pocket) = event.kind {
            self.pockets[usize::from(event.balls[0])] = pocket as i8;
        }
    }
}
