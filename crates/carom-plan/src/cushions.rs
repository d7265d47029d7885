//! Kick and bank tables: where a ball, alone on the table, meets one cushion after the other.

use carom::event::{Event, EventKind, Recorder};
use carom::limits::SMALL_CAPACITY;
use carom::math::{Vec3, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom::shot::PlacedBall;
use carom::simulate::Simulation;
use carom::table::{Part, Rail};
use carom::{BallState, Error, Shot};
use rayon::prelude::*;

use crate::maps::Progress;
use crate::threads::Threads;

/// A cushion that was met: its rail, and the ball's centre, m, in the file's frame.
pub type Met = (Rail, [f64; 2]);

/// Where the struck ball of `shot` meets the first `most` cushions, up to the first jaw, with nothing else on
/// the table: for each azimuth (rad), of each speed (m/s), of each side (ball radii). Elevation is the shot's
/// own; `height` in ball radii. `progress` is told after every azimuth how many are done.
///
/// # Errors
/// [`Error::Input`] without a strike, and for strikes that cannot be played.
#[expect(
    clippy::too_many_arguments,
    reason = "the axes of a table, and what is the same in all of it"
)]
pub fn kick_table(
    shot: &Shot,
    azimuths: &[f64],
    speeds: &[f64],
    sides: &[f64],
    height: f64,
    most: usize,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> Result<Vec<Vec<Met>>, Error> {
    let Some((struck, own)) = shot.strike() else {
        return Err(Error::input(
            "strike",
            "the shot has none; it says which ball is struck",
            "give it one",
        ));
    };
    let ball = shot.balls()[struck].clone();
    // The shot's own strike need not be one that can be played without the other balls.
    let cells = speeds.len() * sides.len();
    table(azimuths, cells, most, threads, progress, |azimuth, cell| {
        let (speed, side) = (speeds[cell / sides.len()], sides[cell % sides.len()]);
        let strike = Strike { azimuth, speed, side, height, ..own };
        shot.with_balls(vec![ball.clone()], Some((0, strike)))
    })
}

/// Where ball `ball` of `shot`, sent off with each speed (m/s) in each direction (rad) as if hit by another,
/// without new spin, meets the first `most` cushions; else as [`kick_table`].
///
/// # Errors
/// [`Error::Input`] for a ball that does not exist, and for speeds out of range.
pub fn bank_table(
    shot: &Shot,
    ball: usize,
    azimuths: &[f64],
    speeds: &[f64],
    most: usize,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> Result<Vec<Vec<Met>>, Error> {
    let Some(own) = shot.balls().get(ball) else {
        return Err(Error::input("ball", format!("there is no ball {ball}"), "count from 0"));
    };
    table(azimuths, speeds.len(), most, threads, progress, |azimuth, cell| {
        let (sin, cos) = sin_cos(azimuth);
        let velocity = Vec3::new(speeds[cell] * cos, speeds[cell] * sin, 0.0);
        let sent = PlacedBall { state: BallState { velocity, ..own.state }, ..own.clone() };
        shot.with_balls(vec![sent], None)
    })
}

/// What each cell of each azimuth meets; `make` gives its shot of one ball.
fn table(
    azimuths: &[f64],
    cells: usize,
    most: usize,
    threads: Option<usize>,
    progress: Progress<'_>,
    make: impl Fn(f64, usize) -> Result<Shot, Error> + Sync,
) -> Result<Vec<Vec<Met>>, Error> {
    let threads = Threads::new(threads);
    let mut all = Vec::with_capacity(azimuths.len() * cells);
    // Enough cells at once that every thread has some.
    let rows = (threads.count() * CELLS).div_ceil(cells.max(1));
    for some in azimuths.chunks(rows) {
        let found: Result<Vec<Vec<Met>>, Error> = threads.run(|| {
            (0..some.len() * cells)
                .into_par_iter()
                .map_init(
                    || Box::new(Simulation::<SMALL_CAPACITY>::new()),
                    |simulation, k| met(simulation, &make(some[k / cells], k % cells)?, most),
                )
                .collect()
        });
        all.extend(found?);
        if !progress(all.len() / cells.max(1)) {
            break;
        }
    }
    all.resize(azimuths.len() * cells, Vec::new());
    Ok(all)
}

/// Cells for each thread between two tellings of the progress: a millisecond of work.
const CELLS: usize = 64;

fn met(
    simulation: &mut Simulation<SMALL_CAPACITY>,
    shot: &Shot,
    most: usize,
) -> Result<Vec<Met>, Error> {
    let mut noses = Noses { shot, most, met: Vec::new(), jaw: false };
    simulation.play(shot, &mut noses).map_err(|failure| shot.explain(failure, None))?;
    Ok(noses.met)
}

/// Notes noses up to the first jaw.
struct Noses<'a> {
    shot: &'a Shot,
    most: usize,
    met: Vec<Met>,
    jaw: bool,
}

impl Recorder for Noses<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let EventKind::RailCollision(cushion) = event.kind else { return };
        let cushion = &self.shot.table().cushions[usize::from(cushion)];
        self.jaw |= cushion.part != Part::Nose;
        if self.jaw || self.met.len() == self.most {
            return;
        }
        let Vec3 { x, y, .. } = self.shot.to_file_frame(0, &event.before[0]).position;
        self.met.push((cushion.rail, [x, y]));
    }
}
