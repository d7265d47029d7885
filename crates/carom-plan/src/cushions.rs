//! Kick and bank tables: the successive cushion contacts of a ball that is alone on the table.

use core::sync::atomic::{AtomicUsize, Ordering};

use carom::event::{Event, EventKind, Recorder};
use carom::math::{Vec3, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom::shot::PlacedBall;
use carom::table::{Part, Rail};
use carom::{BallState, Error, ErrorKind, Shot, Simulator};

use crate::grid::{check_cells, each_cell};
use crate::maps::{FASTEST_BALL, check_each, check_has_edges};
use crate::progress::Progress;

/// A contact with a cushion: its rail, and the ball's centre in the file's coordinates, m.
pub type CushionContact = (Rail, [f64; 2]);

/// The strikes of a kick table: every azimuth with every speed and every side.
#[derive(Clone, Copy, Debug)]
pub struct Kicks<'a> {
    /// Directions of the cue, rad.
    pub azimuths: &'a [f64],
    /// Speeds of the cue, m/s.
    pub speeds: &'a [f64],
    /// Contact points right of the centre, ball radii.
    pub sides: &'a [f64],
    /// Contact point above the centre, ball radii.
    pub height: f64,
}

/// The first `most` cushion contacts of the struck ball of `shot` before it meets a jaw, with no
/// other ball on the table. There is one entry for each cell, ordered by azimuth, then speed, then
/// side. The elevation is that of the shot's own strike; if that is the default, it is the default
/// of each cell, without the other balls. Cells that were not reached before `progress` was
/// stopped are empty.
///
/// # Errors [`Error::Input`] without a strike, for cloth without cushions, for strikes that cannot
/// be played, and for more than [`MAX_CELLS`](crate::grid::MAX_CELLS) contacts.
pub fn kick_table(
    shot: &Shot,
    kicks: &Kicks<'_>,
    most: usize,
    threads: Option<usize>,
    progress: &Progress,
) -> Result<Vec<Vec<CushionContact>>, Error> {
    let Some((struck, own)) = shot.strike() else {
        return Err(ErrorKind::NoStrike.at(
            "strike",
            "the shot has no strike",
            "give it one: it names the ball that is struck",
        ));
    };
    let Kicks { azimuths, speeds, sides, height } = *kicks;
    check_has_edges(shot)?;
    let axes = [azimuths.len(), speeds.len(), sides.len(), most];
    check_cells("azimuth, speed, side, cushions", &axes)?;
    let ball = shot.balls()[struck].clone();
    // The shot's own strike may be impossible without the other balls, so it is replaced at once.
    let per_azimuth = speeds.len() * sides.len();
    table(azimuths, per_azimuth, most, threads, progress, |azimuth, cell| {
        let (speed, side) = (speeds[cell / sides.len()], sides[cell % sides.len()]);
        let mut strike = Strike { azimuth, speed, side, height, ..own };
        if shot.has_default_elevation() {
            let none = core::iter::empty();
            strike.elevation = shot.default_elevation_among((&ball).into(), none, &strike);
        }
        shot.with_balls(vec![ball.clone()], Some((0, strike)))
    })
}

/// The same as [`kick_table`] for ball number `ball` of `shot`, which starts with each speed (m/s)
/// in each direction (rad) and with the spin that it has in `shot`. The entries are ordered by
/// azimuth, then speed.
///
/// # Errors [`Error::Input`] for a ball that does not exist, for cloth without cushions, for
/// speeds out of range, and for more than [`MAX_CELLS`](crate::grid::MAX_CELLS) contacts.
pub fn bank_table(
    shot: &Shot,
    ball: usize,
    azimuths: &[f64],
    speeds: &[f64],
    most: usize,
    threads: Option<usize>,
    progress: &Progress,
) -> Result<Vec<Vec<CushionContact>>, Error> {
    let Some(own) = shot.balls().get(ball) else {
        return Err(ErrorKind::UnknownBall.at(
            "ball",
            format!("there is no ball {ball}"),
            "count from 0",
        ));
    };
    check_has_edges(shot)?;
    check_each("speed", speeds, |v| 0.0 < v && v <= FASTEST_BALL, "give m/s, > 0 and <= 100")?;
    check_cells("azimuth, speed, cushions", &[azimuths.len(), speeds.len(), most])?;
    table(azimuths, speeds.len(), most, threads, progress, |azimuth, cell| {
        let (sin, cos) = sin_cos(azimuth);
        let velocity = Vec3::new(speeds[cell] * cos, speeds[cell] * sin, 0.0);
        let moving = PlacedBall { state: BallState { velocity, ..own.state }, ..own.clone() };
        shot.with_balls(vec![moving], None)
    })
}

/// The contacts of each cell of each azimuth; `make` returns the cell's shot of one ball.
fn table(
    azimuths: &[f64],
    per_azimuth: usize,
    most: usize,
    threads: Option<usize>,
    progress: &Progress,
    make: impl Fn(f64, usize) -> Result<Shot, Error> + Sync + Send,
) -> Result<Vec<Vec<CushionContact>>, Error> {
    let cells = azimuths.len() * per_azimuth;
    // Only cells after a cell that failed are skipped. So the first error does not depend on the
    // threads.
    let first_failed = AtomicUsize::new(usize::MAX);
    let found = each_cell(cells, threads, progress, Simulator::new, |simulator, k| {
        if k > first_failed.load(Ordering::Relaxed) {
            return Ok(Vec::new());
        }
        make(azimuths[k / per_azimuth], k % per_azimuth)
            .and_then(|shot| contacts(simulator, &shot, most))
            .inspect_err(|_| {
                first_failed.fetch_min(k, Ordering::Relaxed);
            })
    })?;
    found.into_iter().map(|cell| cell.unwrap_or_else(|| Ok(Vec::new()))).collect()
}

fn contacts(
    simulator: &mut Simulator,
    shot: &Shot,
    most: usize,
) -> Result<Vec<CushionContact>, Error> {
    let mut recorder = CushionRecorder { shot, most, contacts: Vec::new(), jaw: false };
    simulator.play(shot, &mut recorder)?;
    Ok(recorder.contacts)
}

/// Records contacts with noses up to the first jaw.
struct CushionRecorder<'a> {
    shot: &'a Shot,
    most: usize,
    contacts: Vec<CushionContact>,
    /// Whether a jaw was met.
    jaw: bool,
}

impl Recorder for CushionRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let EventKind::RailCollision(cushion) = event.kind else { return };
        let cushion = &self.shot.table().cushions[usize::from(cushion)];
        self.jaw |= cushion.part != Part::Nose;
        if self.jaw || self.contacts.len() == self.most {
            return;
        }
        let Vec3 { x, y, .. } = self.shot.to_file_coordinates(0, &event.before[0]).position;
        self.contacts.push((cushion.rail, [x, y]));
    }
}
