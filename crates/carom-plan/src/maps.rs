//! Maps: one question asked over a grid.
//!
//! Cells are worked on in parallel, a row at a time; no answer depends on the number of threads. `progress` is
//! told after every row how many rows are done, and says whether to go on; what is not done by then stays
//! NaN.

use carom::batch::{self, BatchResult};
use carom::event::{Event, EventKind, Recorder};
use carom::limits::{MAX_BALLS, SMALL_CAPACITY};
use carom::math::{Vec2, Vec3};
use carom::rack::{Break, break_shot};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::shot::PlacedBall;
use carom::simulate::Simulation;
use carom::{BallState, Error, Noise, Shot};
use rayon::prelude::*;

use crate::aim::{Free, Tried, center, refine, straight};
use crate::errs::{Chance, Errs};
use crate::goal::{Goal, Player};
use crate::threads::Threads;

/// Told how much is done; says whether to go on.
pub type Progress<'a> = &'a mut dyn FnMut(usize) -> bool;

/// The chance of a pot from every place of the cue ball.
#[derive(Clone, Debug, PartialEq)]
pub struct PotMap {
    /// Cells along x and y; cell (i, j) is at ((i + ½) width / columns, (j + ½) length / rows).
    pub cells: [usize; 2],
    /// The chance that the ball falls and the cue ball does not, row by row; of no variants where the cue
    /// ball cannot lie.
    pub chance: Vec<Chance>,
    /// The azimuth that was aimed at, rad.
    pub azimuth: Vec<f64>,
}

/// How likely `ball` is potted straight into `pocket` with the cue ball anywhere on the table, struck with
/// `shot`'s own speed and spin. For every place the aim is refined until it pots exactly, and turned to the
/// middle of what pots.
///
/// # Errors
/// What [`Goal::check`] and [`Errs::check`] refuse, and a table without edges.
pub fn pot_map(
    shot: &Shot,
    (ball, pocket): (usize, usize),
    cells: [usize; 2],
    errs: &Errs,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> Result<PotMap, Error> {
    let goal = Goal { pot: Some((ball, Some(pocket))), ..Goal::default() };
    goal.check(shot)?;
    errs.check()?;
    let size = table_size(shot)?;
    let [columns, rows] = cells;
    let at = |k: usize, count: usize, size: f64| (k as f64 + 0.5) * size / count as f64;
    let mut found = by_rows(rows, columns, threads, progress, |row, column| {
        let place = [at(column, columns, size.x), at(row, rows, size.y)];
        pot_from(shot, place, &goal, (ball, pocket), errs)
    });
    found.resize(rows * columns, None);
    let known = found.into_iter().map(|cell| cell.unwrap_or((Chance::default(), f64::NAN)));
    let (chance, azimuth) = known.unzip();
    Ok(PotMap { cells, chance, azimuth })
}

/// What `cell` gives for every row and column, row by row; less if `progress` stopped it.
fn by_rows<T: Send>(
    rows: usize,
    columns: usize,
    threads: Option<usize>,
    progress: Progress<'_>,
    cell: impl Fn(usize, usize) -> T + Sync,
) -> Vec<T> {
    let threads = Threads::new(threads);
    let mut all = Vec::with_capacity(rows * columns);
    for row in 0..rows {
        let found: Vec<T> =
            threads.run(|| (0..columns).into_par_iter().map(|column| cell(row, column)).collect());
        all.extend(found);
        if !progress(row + 1) {
            break;
        }
    }
    all
}

/// Chance and azimuth with the cue ball at `place`; none where it cannot lie.
fn pot_from(
    shot: &Shot,
    [x, y]: [f64; 2],
    goal: &Goal,
    (ball, pocket): (usize, usize),
    errs: &Errs,
) -> Option<(Chance, f64)> {
    let (cue_ball, strike) = shot.strike()?;
    let mut balls = shot.balls().to_vec();
    let z = balls[cue_ball].state.position.z;
    balls[cue_ball].state.position = Vec3::new(x, y, z);
    let moved = shot.with_balls(balls, Some((cue_ball, strike))).ok()?;
    let aimed = Strike { azimuth: straight(&moved, ball, pocket), ..strike };
    on_table(&moved, *goal, |player| {
        let best = player.aim(aimed)?;
        Some((player.chance(&best.strike, errs), best.strike.azimuth))
    })
}

/// Where the cue ball ends with every speed and spin.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionMap {
    /// Whether the ball falls and the cue ball does not: speed by speed, spin by spin.
    pub met: Vec<bool>,
    /// The azimuth, rad, with which it does; NaN for strikes that cannot be played.
    pub azimuth: Vec<f64>,
    /// Where the cue ball comes to rest, m.
    pub end: Vec<[f64; 2]>,
}

/// Pots `ball` into `pocket` with each of `speeds` (m/s) and `spins` (side and height, ball radii), aimed anew
/// each time, without noise.
///
/// # Errors
/// What [`Goal::check`] refuses.
pub fn position_map(
    shot: &Shot,
    (ball, pocket): (usize, usize),
    speeds: &[f64],
    spins: &[[f64; 2]],
    threads: Option<usize>,
    progress: Progress<'_>,
) -> Result<PositionMap, Error> {
    let goal = Goal { pot: Some((ball, Some(pocket))), ..Goal::default() };
    goal.check(shot)?;
    let azimuth = straight(shot, ball, pocket);
    let mut found = by_rows(speeds.len(), spins.len(), threads, progress, |row, column| {
        let ([side, height], (_, own)) = (spins[column], shot.strike()?);
        let strike = Strike { speed: speeds[row], azimuth, side, height, ..own };
        on_table(shot, goal, |player| player.aim(strike))
    });
    found.resize(speeds.len() * spins.len(), None);
    let mut map = PositionMap { met: Vec::new(), azimuth: Vec::new(), end: Vec::new() };
    for tried in found {
        map.met.push(tried.as_ref().is_some_and(|t| t.attempt.is_met()));
        map.azimuth.push(tried.as_ref().map_or(f64::NAN, |t| t.strike.azimuth));
        map.end.push(tried.map_or([f64::NAN; 2], |t| t.attempt.cue_ball_end));
    }
    Ok(map)
}

/// A player of either size.
struct AnyPlayer<'a> {
    few: Option<Player<'a, SMALL_CAPACITY>>,
    many: Option<Player<'a, MAX_BALLS>>,
}

impl AnyPlayer<'_> {
    fn aim(&mut self, strike: Strike) -> Option<Tried> {
        match (&mut self.few, &mut self.many) {
            (Some(player), _) => aim(player, strike),
            (_, Some(player)) => aim(player, strike),
            _ => None,
        }
    }

    fn chance(&mut self, strike: &Strike, errs: &Errs) -> Chance {
        match (&mut self.few, &mut self.many) {
            (Some(player), _) => player.chance(strike, errs),
            (_, Some(player)) => player.chance(strike, errs),
            _ => Chance::default(),
        }
    }
}

fn on_table<T>(
    shot: &Shot,
    goal: Goal,
    work: impl FnOnce(&mut AnyPlayer<'_>) -> Option<T>,
) -> Option<T> {
    let few = shot.balls().len() <= SMALL_CAPACITY;
    let mut player = AnyPlayer {
        few: few.then(|| Player::new(shot, goal)),
        many: (!few).then(|| Player::new(shot, goal)),
    };
    work(&mut player)
}

/// `strike` with the azimuth that comes nearest to the goal; none if it cannot be played.
fn aim<const N: usize>(player: &mut Player<'_, N>, strike: Strike) -> Option<Tried> {
    let attempt = player.play(&strike)?;
    let best = refine(player, Tried { strike, attempt }, Free::Azimuth);
    Some(if best.attempt.is_met() { center(player, best) } else { best })
}

/// What a pocket takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepted {
    /// The ball falls into it, and was never farther from its mouth than at the start.
    Falls,
    /// It does not.
    Stays,
    /// It cannot start there.
    Nowhere,
}

/// From where balls roll at a pocket.
#[derive(Clone, Copy, Debug)]
pub struct Approaches<'a> {
    /// Angles to the pocket's axis, rad; positive ones come from the right of it, seen from the pocket.
    pub angles: &'a [f64],
    /// How far to the right of the mouth's middle the line passes, m, seen along it.
    pub offsets: &'a [f64],
    /// Speeds at the start, m/s; the ball rolls.
    pub speeds: &'a [f64],
    /// From the start to the mouth's middle, m.
    pub distance: f64,
}

/// Which balls, rolling at `pocket` of `shot`'s table, it takes: speed by speed, angle by angle, offset by
/// offset. Only the table and the physics of `shot` count; the ball is the physics' own.
///
/// # Errors
/// [`Error::Input`] if there is no such pocket, or for a distance that is not positive.
pub fn acceptance(
    shot: &Shot,
    pocket: usize,
    approaches: &Approaches<'_>,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> Result<Vec<Accepted>, Error> {
    let Some(hole) = shot.table().pockets.get(pocket) else {
        return Err(Error::input("pocket", format!("there is no pocket {pocket}"), "count from 0"));
    };
    if !(approaches.distance > 0.0 && approaches.distance.is_finite()) {
        return Err(Error::input("distance", "it is no distance", "give a number of metres > 0"));
    }
    let mouth = (hole.mouth[0] + hole.mouth[1]) * 0.5;
    let Approaches { angles, offsets, speeds, distance } = *approaches;
    let cells = angles.len() * offsets.len();
    let mut all = by_rows(speeds.len(), cells, threads, progress, |row, cell| {
        let (angle, offset) = (angles[cell / offsets.len()], offsets[cell % offsets.len()]);
        let (sin, cos) = carom::math::sin_cos(angle);
        let way = hole.axis * cos + hole.axis.perp() * sin;
        rolls_in(shot, pocket, mouth, way * distance + way.perp() * offset, way * speeds[row])
    });
    all.resize(speeds.len() * cells, Accepted::Nowhere);
    Ok(all)
}

/// Whether `pocket` takes a ball that rolls with `velocity` from `back` before the middle of its `mouth`, which is
/// in the engine's frame.
fn rolls_in(shot: &Shot, pocket: usize, mouth: Vec2, back: Vec2, velocity: Vec2) -> Accepted {
    let ball = shot.physics().ball;
    let start = mouth - back + shot.table().center();
    let spin = velocity.perp() * (1.0 / ball.radius);
    let state = BallState {
        position: start.with_z(ball.radius),
        velocity: velocity.with_z(0.0),
        angular_velocity: spin.with_z(0.0),
        ..BallState::default()
    };
    let placed = PlacedBall { id: "1".into(), ball, state };
    let Ok(rolling) = shot.with_balls(vec![placed], None) else { return Accepted::Nowhere };
    let mut fall = Fall { mouth, reach: back.length() + LEFT, into: None, left: false };
    let played = Simulation::<SMALL_CAPACITY>::new().play(&rolling, &mut fall);
    match (played, fall.into) {
        (Ok(_), Some(into)) if into == pocket && !fall.left => Accepted::Falls,
        (Ok(_), _) => Accepted::Stays,
        (Err(_), _) => Accepted::Nowhere,
    }
}

/// A ball is away from a pocket when it is farther from it than at the start by this, m: far above rounding, far
/// below a table.
const LEFT: f64 = 1e-3;

/// Notes which pocket a ball fell into, and whether it went away first: around the table and back is no matter of
/// the jaws.
struct Fall {
    mouth: Vec2,
    /// How far a ball is that has left, m.
    reach: f64,
    into: Option<usize>,
    left: bool,
}

impl Recorder for Fall {
    fn record(&mut self, event: &Event<'_>) {
        // Who comes back turns somewhere, and that is an event.
        let away = |state: &BallState| (state.position.xy() - self.mouth).length();
        self.left |= event.before.iter().any(|state| away(state) > self.reach);
        if let EventKind::PocketCollision(pocket) = event.kind {
            self.into = Some(usize::from(pocket));
        }
    }
}

/// Breaks racks number `first`.. of the seed in `opening`, each with the strike that comes out of its own error:
/// row k is rack `opening.seed` + `first` + k, struck with error number `first` + k of that seed. Racks have
/// their balls in various orders; the columns have them as rack `opening.seed` has.
///
/// # Errors
/// As [`break_shot`] and [`Noise::check`].
pub fn breaks(
    opening: &Break<'_>,
    noise: &Noise,
    first: u64,
    count: usize,
    threads: Option<usize>,
) -> Result<BatchResult, Error> {
    noise.check()?;
    let columns = break_shot(opening)?;
    let one = |k: u64| {
        let seed = opening.seed.wrapping_add(k);
        let shot = break_shot(&Break { seed, ..*opening })?;
        let strikes = batch::draw_strikes(&shot, noise, 1, opening.seed, k)?;
        let row = batch::simulate_strikes(&shot, &strikes, &Runner::default());
        Ok(reordered(row, &shot, &columns))
    };
    let rows: Result<Vec<BatchResult>, Error> = Threads::new(threads)
        .run(|| (0..count as u64).into_par_iter().map(|k| one(first.wrapping_add(k))).collect());
    let mut all = BatchResult { shots: count, ..BatchResult::default() };
    for (k, row) in rows?.into_iter().enumerate() {
        all.balls = row.balls;
        all.final_position.extend(row.final_position);
        all.pocket.extend(row.pocket);
        all.events.extend(row.events);
        all.errors.extend(row.errors.into_iter().map(|(_, error)| (k, error)));
    }
    Ok(all)
}

/// The one row of `shot` with its balls in the order of `columns`.
fn reordered(mut row: BatchResult, shot: &Shot, columns: &Shot) -> BatchResult {
    let places: Vec<usize> =
        columns.balls().iter().filter_map(|ball| shot.ball_index(&ball.id)).collect();
    row.pocket = places.iter().map(|i| row.pocket[*i]).collect();
    row.final_position = places.iter().map(|i| row.final_position[*i]).collect();
    row
}

fn table_size(shot: &Shot) -> Result<Vec2, Error> {
    let size = shot.table().size;
    if size.x.is_finite() && size.y.is_finite() {
        return Ok(size);
    }
    Err(Error::input("table", "the cloth has no edges", "choose a table"))
}
