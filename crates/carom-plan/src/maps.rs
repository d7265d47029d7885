//! Maps: a result for every cell of a grid.

use carom::event::{Event, EventKind, Recorder};
use carom::math::{Vec2, Vec3, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom::shot::PlacedBall;
use carom::{BallState, Error, ErrorKind, Shot, Simulator};

use crate::aim::{Free, TriedStrike, center, refine, straight};
use crate::drawn_tables::DrawnTables;
use crate::error_model::{Chance, ChanceByTable, ErrorModel};
use crate::goal::{Goal, GoalTester};
use crate::grid::{check_cells, each_cell};
use crate::interval::Interval;
use crate::progress::Progress;

/// Greatest speed of a strike and of a ball, m/s: the ranges of a shot file.
const FASTEST_CUE: f64 = 50.0;
pub(crate) const FASTEST_BALL: f64 = 100.0;

/// A ball and the pocket it shall fall into, by their indices in the shot and the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PotTarget {
    /// The ball.
    pub ball: usize,
    /// The pocket.
    pub pocket: usize,
}

/// The probability of a pot from every place of the cue ball.
#[derive(Clone, Debug, PartialEq)]
pub struct PotMap {
    /// Cells along x and y; cell (i, j) is at ((i + ½) width / columns, (j + ½) length / rows).
    pub cells: [usize; 2],
    /// The probability that the ball falls and the cue ball does not, row by row. It has no
    /// variants where the cue ball has no room, be it on a single drawn table.
    pub chance: Vec<Chance>,
    /// Its confidence interval; [0, 1] without variants.
    pub interval: Vec<Interval>,
    /// The azimuth of the aim, rad; NaN where the cue ball has no room.
    pub azimuth: Vec<f64>,
}

/// The probability of potting a ball straight into a pocket with the cue ball anywhere on the table, struck with the speed and spin of `shot`'s own strike. For every
/// place the aim is refined until it pots exactly on the shot's own table, and turned to the middle
/// of the azimuths that pot. The variants are played in turn on `tables`.
///
/// Cells that were not reached before `progress` was stopped have no variants.
///
/// # Errors
/// [`Error::Input`] for what [`Goal::check`], [`ErrorModel::check`] and [`DrawnTables::check`]
/// reject, for cloth without cushions, and for more than [`MAX_CELLS`](crate::grid::MAX_CELLS) cells.
pub fn pot_map(
    shot: &Shot,
    target: PotTarget,
    cells: [usize; 2],
    model: &ErrorModel,
    tables: &DrawnTables,
    threads: Option<usize>,
    progress: &Progress,
) -> Result<PotMap, Error> {
    let goal = Goal { pot: Some((target.ball, Some(target.pocket))), ..Goal::default() };
    goal.check(shot)?;
    model.check()?;
    tables.check(shot)?;
    let size = check_has_edges(shot)?;
    let [columns, rows] = cells;
    let count = check_cells("columns × rows", &cells)?;
    let center_of = |k: usize, count: usize, size: f64| (k as f64 + 0.5) * size / count as f64;
    let found = each_cell(
        count,
        threads,
        progress,
        || (),
        |(), cell| {
            let (row, column) = (cell / columns, cell % columns);
            let place = [center_of(column, columns, size.x), center_of(row, rows, size.y)];
            pot_from(shot, place, target, model, tables, progress)
        },
    )?;
    let mut map = PotMap { cells, chance: vec![], interval: vec![], azimuth: vec![] };
    for cell in found {
        let (chance, azimuth) = cell.flatten().unwrap_or((ChanceByTable::default(), f64::NAN));
        map.chance.push(chance.total());
        map.interval.push(chance.interval(model.level));
        map.azimuth.push(azimuth);
    }
    Ok(map)
}

/// The chance and the azimuth with the cue ball at `place`; None if it has no room there.
fn pot_from(
    shot: &Shot,
    place: [f64; 2],
    target: PotTarget,
    model: &ErrorModel,
    tables: &DrawnTables,
    progress: &Progress,
) -> Option<(ChanceByTable, f64)> {
    let moved = with_cue_ball_at(shot, place)?;
    let tables = tables.changed(|drawn| with_cue_ball_at(drawn, place))?;
    let azimuth = straight(&moved, target.ball, target.pocket);
    let aimed = moved.at_own_elevation(&Strike { azimuth, ..shot.strike()?.1 });
    let goal = Goal { pot: Some((target.ball, Some(target.pocket))), ..Goal::default() };
    let mut tester = GoalTester::new(&moved, goal);
    let best = aim(&mut tester, aimed)?;
    Some((tester.chance(&best.strike, model, &tables, progress), best.strike.azimuth))
}

/// `shot` with its cue ball at this place, m; None if it has no room there.
fn with_cue_ball_at(shot: &Shot, [x, y]: [f64; 2]) -> Option<Shot> {
    let cue_ball = shot.cue_ball()?;
    let mut balls = shot.balls().to_vec();
    let z = balls[cue_ball].state.position.z;
    balls[cue_ball].state.position = Vec3::new(x, y, z);
    shot.with_layout(balls).ok()
}

/// Where the cue ball ends with every speed and spin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PositionMap {
    /// Whether the ball falls and the cue ball does not: speed by speed, spin by spin.
    pub met: Vec<bool>,
    /// The azimuth of the aim, rad; NaN for strikes that cannot be played.
    pub azimuth: Vec<f64>,
    /// Where the cue ball comes to rest, m; NaN for strikes that cannot be played.
    pub end: Vec<[f64; 2]>,
}

/// Pots `ball` into `pocket` with each of `speeds` (m/s) and `spins` (side and height, ball
/// radii), without noise. Every strike is aimed separately. Strikes past the miscue limit cannot
/// be played; cells that were not reached before `progress` was stopped count as such.
///
/// # Errors [`Error::Input`] for what [`Goal::check`] rejects, for speeds outside (0, 50] m/s, for
/// offsets off the ball, and for more than [`MAX_CELLS`](crate::grid::MAX_CELLS) cells.
pub fn position_map(
    shot: &Shot,
    ball: usize,
    pocket: usize,
    speeds: &[f64],
    spins: &[[f64; 2]],
    threads: Option<usize>,
    progress: &Progress,
) -> Result<PositionMap, Error> {
    let goal = Goal { pot: Some((ball, Some(pocket))), ..Goal::default() };
    goal.check(shot)?;
    check_each("speed", speeds, |v| 0.0 < v && v <= FASTEST_CUE, "give m/s, > 0 and <= 50")?;
    for [side, height] in spins {
        let offset = side * side + height * height;
        if offset > 1.0 || offset.is_nan() {
            let what = format!("({side:?}, {height:?}) ball radii is off the ball");
            return Err(ErrorKind::OutOfRange.at(
                "side, height",
                what,
                "keep side² + height² <= 1",
            ));
        }
    }
    let cells = check_cells("speed, spin", &[speeds.len(), spins.len()])?;
    let azimuth = straight(shot, ball, pocket);
    let found = each_cell(
        cells,
        threads,
        progress,
        || GoalTester::new(shot, goal),
        |tester, cell| {
            let ([side, height], (_, own)) = (spins[cell % spins.len()], shot.strike()?);
            let strike = Strike { speed: speeds[cell / spins.len()], azimuth, side, height, ..own };
            let strike = shot.at_own_elevation(&strike);
            let TriedStrike { strike, attempt } = aim(tester, strike)?;
            Some((attempt.is_met(), strike.azimuth, attempt.cue_ball_end))
        },
    )?;
    let mut map = PositionMap::default();
    for cell in found {
        let (met, azimuth, end) = cell.flatten().unwrap_or((false, f64::NAN, [f64::NAN; 2]));
        map.met.push(met);
        map.azimuth.push(azimuth);
        map.end.push(end);
    }
    Ok(map)
}

/// `strike` with the azimuth that comes nearest to the goal; None if it cannot be played.
fn aim(tester: &mut GoalTester<'_>, strike: Strike) -> Option<TriedStrike> {
    let attempt = tester.play(&strike)?;
    let best = refine(tester, TriedStrike { strike, attempt }, Free::Azimuth);
    Some(if best.attempt.is_met() { center(tester, best) } else { best })
}

/// Whether a pocket accepts a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepted {
    /// The ball falls into the pocket and was never farther from its mouth than at the start.
    Falls,
    /// The ball does not fall.
    Stays,
    /// The ball has no room at the start.
    Nowhere,
}

/// Balls that roll towards a pocket: every speed with every angle and every offset.
#[derive(Clone, Copy, Debug)]
pub struct Approaches<'a> {
    /// Angles to the pocket's axis, rad. A ball with a positive angle comes from the right of the
    /// axis, seen from the pocket.
    pub angles: &'a [f64],
    /// Distances by which the line passes to the right of the mouth's centre, m, seen along the
    /// line.
    pub offsets: &'a [f64],
    /// Speeds at the start, m/s. The ball rolls.
    pub speeds: &'a [f64],
    /// Distance from the start to the mouth's centre, m.
    pub distance: f64,
}

impl Approaches<'_> {
    fn check(&self, shot: &Shot) -> Result<usize, Error> {
        let size = check_has_edges(shot)?;
        let farthest = size.length();
        if !(0.0 < self.distance && self.distance <= farthest) {
            let what = format!("{:?} m is out of range", self.distance);
            let remedy = format!("give > 0 and at most the table's diagonal, {farthest:.3} m");
            return Err(ErrorKind::OutOfRange.at("distance", what, remedy));
        }
        let remedy = "give m/s, > 0 and <= 100";
        check_each("speed", self.speeds, |v| 0.0 < v && v <= FASTEST_BALL, remedy)?;
        let half_turn = core::f64::consts::PI;
        check_each("angle", self.angles, |a| a.abs() <= half_turn, "give radians from -π to π")?;
        let remedy =
            format!("give metres, at most the table's diagonal, {farthest:.3}, either way");
        check_each("offset", self.offsets, |x| x.abs() <= farthest, &remedy)?;
        let axes = [self.speeds.len(), self.angles.len(), self.offsets.len()];
        check_cells("speed, angle, offset", &axes)
    }
}

/// Whether `pocket` of `shot`'s table accepts each rolling ball: speed by speed, angle by angle,
/// offset by offset. Only the table and the physics of `shot` are used; the ball is that of the
/// physics. Cells that were not reached before `progress` was stopped are [`Accepted::Nowhere`].
///
/// # Errors [`Error::Input`] if there is no such pocket, for speeds, angles, offsets or a distance
/// out of range, and for more than [`MAX_CELLS`](crate::grid::MAX_CELLS) cells.
pub fn acceptance(
    shot: &Shot,
    pocket: usize,
    approaches: &Approaches<'_>,
    threads: Option<usize>,
    progress: &Progress,
) -> Result<Vec<Accepted>, Error> {
    let Some(hole) = shot.table().pockets.get(pocket) else {
        return Err(ErrorKind::UnknownName.at(
            "pocket",
            format!("there is no pocket {pocket}"),
            "count from 0",
        ));
    };
    let cells = approaches.check(shot)?;
    let mouth = (hole.mouth[0] + hole.mouth[1]) * 0.5;
    let Approaches { angles, offsets, speeds, distance } = *approaches;
    let found = each_cell(cells, threads, progress, Simulator::new, |simulator, cell| {
        let (rest, offset) = (cell / offsets.len(), offsets[cell % offsets.len()]);
        let (speed, angle) = (speeds[rest / angles.len()], angles[rest % angles.len()]);
        let (sin, cos) = sin_cos(angle);
        let direction = hole.axis * cos + hole.axis.perp() * sin;
        let back = direction * distance + direction.perp() * offset;
        let approach = Approach { pocket, mouth, back, velocity: direction * speed };
        approach.play(simulator, shot)
    })?;
    Ok(found.into_iter().map(|cell| cell.unwrap_or(Accepted::Nowhere)).collect())
}

/// One ball that rolls towards a pocket, in the engine's coordinates.
struct Approach {
    /// Index of the pocket.
    pocket: usize,
    /// The centre of its mouth, m.
    mouth: Vec2,
    /// From the ball at the start to the mouth, m.
    back: Vec2,
    /// The ball's velocity, m/s.
    velocity: Vec2,
}

impl Approach {
    fn play(&self, simulator: &mut Simulator, shot: &Shot) -> Accepted {
        let ball = shot.physics().ball;
        let spin = self.velocity.perp() * (1.0 / ball.radius);
        let state = BallState {
            position: (self.mouth - self.back + shot.table().center()).with_z(ball.radius),
            velocity: self.velocity.with_z(0.0),
            angular_velocity: spin.with_z(0.0),
            ..BallState::default()
        };
        let placed = PlacedBall { id: "1".into(), ball, state };
        let Ok(rolling) = shot.with_balls(vec![placed], None) else { return Accepted::Nowhere };
        let reach = self.back.length() + AWAY;
        let mut recorder = ApproachRecorder { mouth: self.mouth, reach, into: None, away: false };
        let played = simulator.play(&rolling, &mut recorder);
        match (played, recorder.into) {
            (Ok(_), Some(into)) if into == self.pocket && !recorder.away => Accepted::Falls,
            (Ok(_), _) => Accepted::Stays,
            (Err(_), _) => Accepted::Nowhere,
        }
    }
}

/// A ball counts as gone from a pocket when its distance from the mouth exceeds that at the start
/// by this much, m. The value is far above rounding and far below a table's size. Without this
/// test, a ball that returns from across the table would count as accepted by the jaws.
const AWAY: f64 = 1e-3;

/// Records which pocket the ball fell into, and whether it had gone away from the mouth before.
struct ApproachRecorder {
    mouth: Vec2,
    /// Distance from the mouth beyond which the ball has gone away, m.
    reach: f64,
    into: Option<usize>,
    away: bool,
}

impl Recorder for ApproachRecorder {
    fn record(&mut self, event: &Event<'_>) {
        // Between two events the ball moves nearly straight, so its farthest point is at an event.
        let distance = |state: &BallState| (state.position.xy() - self.mouth).length();
        self.away |= event.before.iter().any(|state| distance(state) > self.reach);
        if let EventKind::PocketCollision(pocket) = event.kind {
            self.into = Some(usize::from(pocket));
        }
    }
}

/// Rejects numbers that are not `valid`.
pub(crate) fn check_each(
    place: &str,
    numbers: &[f64],
    valid: impl Fn(f64) -> bool,
    remedy: &str,
) -> Result<(), Error> {
    match numbers.iter().find(|number| !valid(**number)) {
        Some(number) => {
            Err(ErrorKind::OutOfRange.at(place, format!("{number:?} is out of range"), remedy))
        }
        None => Ok(()),
    }
}

/// The size of `shot`'s table, m; rejects cloth without cushions.
pub(crate) fn check_has_edges(shot: &Shot) -> Result<Vec2, Error> {
    let size = shot.table().size;
    if size.x.is_finite() && size.y.is_finite() {
        return Ok(size);
    }
    Err(ErrorKind::Unsupported.at(
        "table",
        "the cloth has no cushions",
        "choose a table with cushions",
    ))
}
