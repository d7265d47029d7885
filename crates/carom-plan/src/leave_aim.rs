//! The strike that pots a ball and leaves the cue ball at a place: position play with the pot kept.
//!
//! [`crate::solve()`] searches every line. Here the line of the pot is given, as for a player who
//! has chosen ball and pocket and asks for the stroke: speed and tip offset are tried on a
//! lattice, every one aimed separately, and the strikes that end nearest to the place are refined.

use core::f64::consts::TAU;

use carom::math::{exp, log, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind, Shot};

use crate::aim::{Free, Limits, TriedStrike, center, refine, straight};
use crate::drawn_tables::DrawnTables;
use crate::error_model::{Chance, ErrorModel};
use crate::goal::{Disc, Goal, GoalTester};
use crate::progress::Progress;

/// Speeds of the lattice, evenly spaced on a logarithmic scale. With fewer, the refinement would
/// have to change the speed by more than it can.
const SPEEDS: usize = 10;
/// Radii of the rings of tip offsets, as shares of the largest offset, and the offsets on each. The
/// centre is tried besides.
const RINGS: [(f64, usize); 2] = [(0.55, 6), (1.0, 8)];
/// Strikes that are refined: those of the lattice that end nearest to the place.
const REFINED: usize = 8;
/// The place is reached if the cue ball stops within this distance of it, m: less than a ball's
/// radius.
const REACHED: f64 = 0.02;
/// Radius of the area in which the cue ball should stop under the errors, m: five balls wide.
const AREA: f64 = 0.15;
/// An own strike whose ball passes the pocket at less than this gives the line, m.
const NEAR: f64 = 0.4;

/// A strike that pots the ball, and where it leaves the cue ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeaveAim {
    /// The strike. It pots the ball when it is hit exactly.
    pub strike: Strike,
    /// Where the cue ball comes to rest, m, in the file's coordinates.
    pub end: [f64; 2],
    /// Distance of that from the place, m.
    pub distance: f64,
    /// Whether the place counts as reached.
    pub is_reached: bool,
    /// The chance that the ball falls and the cue ball stops within 15 cm of `end`.
    pub chance: Chance,
}

/// The strike that pots `ball` into `pocket` (indices in the shot and the table) and brings the
/// cue ball nearest to `place` (m, file's coordinates); among strikes that reach it, the most
/// probable under the errors of `model`. Speeds are within `speed`, m/s; tip offsets are at most
/// `offset`, ball radii. The line is that of the shot's own strike if its ball almost falls, or
/// else the straight one. None if no strike of the lattice pots the ball.
///
/// # Errors As [`Goal::check`] and [`ErrorModel::check`], and [`Error::Input`] for a range of
/// speeds or an offset out of range.
pub fn leave_aim(
    shot: &Shot,
    ball: usize,
    pocket: usize,
    place: [f64; 2],
    speed: [f64; 2],
    offset: f64,
    model: &ErrorModel,
) -> Result<Option<LeaveAim>, Error> {
    let pot = Goal { pot: Some((ball, Some(pocket))), ..Goal::default() };
    let disc = |center: [f64; 2], radius: f64| Goal { leave: Some(Disc { center, radius }), ..pot };
    disc(place, REACHED).check(shot)?;
    model.check()?;
    check(speed, offset)?;
    let offset = offset.min(0.95 * shot.miscue_limit());
    let mut potting = GoalTester::new(shot, pot);
    let azimuth = line(&mut potting, ball, pocket);
    let away = |end: [f64; 2]| {
        let [x, y] = [end[0] - place[0], end[1] - place[1]];
        carom::math::sqrt(x * x + y * y)
    };

    let mut found: Vec<TriedStrike> = lattice(speed, offset)
        .filter_map(|strike| {
            let strike = shot.at_own_elevation(&Strike { azimuth, ..strike });
            let attempt = potting.play(&strike)?;
            let tried = refine(&mut potting, TriedStrike { strike, attempt }, Free::Azimuth);
            tried.attempt.is_met().then_some(tried)
        })
        .collect();
    found.sort_by(|a, b| away(a.attempt.cue_ball_end).total_cmp(&away(b.attempt.cue_ball_end)));
    found.truncate(REFINED);

    let limits = Free::Within(Limits { speed, offset, elevation: None });
    let mut placing = GoalTester::new(shot, disc(place, REACHED));
    let mut best: Option<LeaveAim> = None;
    for start in found {
        let Some(attempt) = placing.play(&start.strike) else { continue };
        let moved = refine(&mut placing, TriedStrike { attempt, ..start.clone() }, limits);
        let moved = if moved.attempt.is_met() { center(&mut placing, moved) } else { moved };
        // A refinement may have left the pocket to come nearer.
        let kept = potting.play(&moved.strike).filter(|attempt| attempt.is_met());
        let strike = if kept.is_some() { moved.strike } else { start.strike };
        let end = kept.map_or(start.attempt.cue_ball_end, |attempt| attempt.cue_ball_end);
        let distance = away(end);
        let (none, progress) = (DrawnTables::default(), Progress::default());
        let mut area = GoalTester::new(shot, disc(end, AREA));
        let chance = area.chance(&strike, model, &none, &progress).total();
        let is_reached = distance <= REACHED;
        let aim = LeaveAim { strike, end, distance, is_reached, chance };
        if best.is_none_or(|best| aim.is_better(&best)) {
            best = Some(aim);
        }
    }
    Ok(best)
}

impl LeaveAim {
    /// Whether the place is reached with a greater chance, or missed by less.
    fn is_better(&self, other: &Self) -> bool {
        match (self.is_reached, other.is_reached) {
            (true, true) => self.chance.compare(other.chance).is_gt(),
            (false, false) => self.distance < other.distance,
            (reached, _) => reached,
        }
    }
}

/// The azimuth of the shot's own strike if its ball almost falls, or else the straight line, rad.
fn line(tester: &mut GoalTester<'_>, ball: usize, pocket: usize) -> f64 {
    let own = tester.shot().strike().map(|(_, strike)| strike);
    let near = own.filter(|own| tester.play(own).is_some_and(|attempt| attempt.miss < NEAR));
    near.map_or_else(|| straight(tester.shot(), ball, pocket), |own| own.azimuth)
}

/// Every speed with every tip offset, without an azimuth.
fn lattice([least, most]: [f64; 2], offset: f64) -> impl Iterator<Item = Strike> {
    let points = RINGS.into_iter().flat_map(move |(share, count)| {
        (0..count).map(move |k| {
            let (sin, cos) = sin_cos(TAU * k as f64 / count as f64);
            [share * offset * cos, share * offset * sin]
        })
    });
    let points: Vec<[f64; 2]> = core::iter::once([0.0; 2]).chain(points).collect();
    (0..SPEEDS).flat_map(move |k| {
        let speed = least * exp(log(most / least) * k as f64 / (SPEEDS - 1) as f64);
        let strike = move |[side, height]: [f64; 2]| Strike {
            speed,
            azimuth: 0.0,
            elevation: 0.0,
            side,
            height,
        };
        points.clone().into_iter().map(strike)
    })
}

fn check([least, most]: [f64; 2], offset: f64) -> Result<(), Error> {
    if !(0.0 < least && least < most && most <= 50.0) {
        let what = format!("{least:?} to {most:?} m/s is not a range of speeds");
        return Err(ErrorKind::OutOfRange.at("speed", what, "give 0 < least < most <= 50"));
    }
    if !(0.0..=1.0).contains(&offset) {
        let what = format!("{offset:?} ball radii is out of range");
        return Err(ErrorKind::OutOfRange.at("offset", what, "give a number from 0 to 1"));
    }
    Ok(())
}
