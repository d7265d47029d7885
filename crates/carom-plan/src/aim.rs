//! Where to aim: first by geometry, then by simulation.
//!
//! Geometry gives the ghost ball (where the cue ball must be to send a ball along a line) and
//! mirror images (where a target appears behind a cushion). It ignores throw, squirt, slip and the
//! effect of spin at a cushion. [`refine`] corrects for these by playing the shot.

use carom::Shot;
use carom::math::{Vec2, asin, atan2};
use carom::resolve::cue_ball::Strike;

use crate::goal::{Attempt, Goal, GoalTester};

/// First steps of the refinement: azimuth (rad), speed (relative), side and height (ball radii),
/// elevation (rad). Smaller steps need more plays, larger ones leave the route that was found.
const FIRST_STEPS: [f64; 5] = [4e-3, 0.05, 0.05, 0.05, 0.02];
/// The refinement ends when the step of the azimuth is less than this, rad: 0.02 mm over the length
/// of a table. Larger values would miss narrow solutions, smaller ones would waste plays.
const LEAST_STEP: f64 = 1e-5;
/// Largest number of plays in one refinement: a few milliseconds.
pub(crate) const MOST_PLAYS: u32 = 90;

/// First step to the side of an azimuth that meets the goal, rad, and the farthest that is
/// searched: 0.01° and 3°.
const FIRST_WIDTH: f64 = 2e-4;
const MOST_WIDTH: f64 = 0.05;
/// Halvings of the last step, which locate the edge to a sixteenth of it.
const HALVINGS: u32 = 4;

/// Number of aims that are spread over a ball's apparent width.
const RAYS: usize = 24;

/// The azimuths (rad) that geometry proposes for `goal`.
pub(crate) fn azimuths(shot: &Shot, goal: &Goal) -> Vec<f64> {
    let geometry = AimGeometry::new(shot);
    let mut points = Vec::new();
    if let Some((ball, pocket)) = goal.pot {
        geometry.pots(ball, pocket, &mut points);
        geometry.caroms(ball, &mut points);
    }
    let mut found = geometry.directions(&points);
    if let Some(ball) = goal.first {
        geometry.hits(ball, &mut found);
    }
    found
}

/// The azimuths (rad) of straight lines to the ball that the goal names. Massés start at an angle
/// to them.
pub(crate) fn straight_azimuths(shot: &Shot, goal: &Goal) -> Vec<f64> {
    let geometry = AimGeometry::new(shot);
    let mut points = Vec::new();
    if let Some((ball, pocket)) = goal.pot {
        let wanted = |i: usize| pocket.is_none_or(|p| p == i);
        let pockets = shot.table().pockets.iter().enumerate().filter(|(i, _)| wanted(*i));
        points.extend(pockets.map(|(_, hole)| geometry.ghost(ball, hole.center, geometry.cue)));
    }
    points.extend(goal.first.map(|ball| geometry.places[ball]));
    points.into_iter().map(|point| direction(geometry.cue_ball(), point)).collect()
}

/// The azimuths (rad) at which geometry sends `ball` into `pocket` directly, by banks, kicks and
/// combinations.
pub(crate) fn lines(shot: &Shot, ball: usize, pocket: usize) -> Vec<f64> {
    let geometry = AimGeometry::new(shot);
    let mut points = Vec::new();
    geometry.pots(ball, Some(pocket), &mut points);
    geometry.directions(&points)
}

/// The azimuth (rad) of the straight pot of `ball` into `pocket` by the ghost ball.
pub(crate) fn straight(shot: &Shot, ball: usize, pocket: usize) -> f64 {
    let geometry = AimGeometry::new(shot);
    let ghost = geometry.ghost(ball, shot.table().pockets[pocket].center, geometry.cue);
    direction(geometry.cue_ball(), ghost)
}

/// The balls of a shot, in the engine's coordinates, and lines of aim between them.
struct AimGeometry<'a> {
    shot: &'a Shot,
    cue: usize,
    places: Vec<Vec2>,
}

impl<'a> AimGeometry<'a> {
    fn new(shot: &'a Shot) -> Self {
        let center = shot.table().center();
        let places = shot.balls().iter().map(|b| b.state.position.xy() - center).collect();
        Self { shot, cue: shot.cue_ball().unwrap_or_default(), places }
    }

    fn cue_ball(&self) -> Vec2 {
        self.places[self.cue]
    }

    fn radius(&self, ball: usize) -> f64 {
        self.shot.balls()[ball].ball.radius
    }

    /// The azimuths (rad) from the cue ball to these points.
    fn directions(&self, points: &[Vec2]) -> Vec<f64> {
        points.iter().map(|point| direction(self.cue_ball(), *point)).collect()
    }

    /// The object balls.
    fn objects(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.places.len()).filter(|ball| *ball != self.cue)
    }

    /// The ghost ball: where ball `by` must be to send `ball` towards `target`.
    fn ghost(&self, ball: usize, target: Vec2, by: usize) -> Vec2 {
        let line = target - self.places[ball];
        self.places[ball] - line * ((self.radius(ball) + self.radius(by)) / line.length())
    }

    /// `point` and its mirror images behind up to `cushions` cushions, for the centre of `ball`.
    fn images(&self, point: Vec2, ball: usize, cushions: u32) -> Vec<Vec2> {
        let table = self.shot.table();
        let size = table.size;
        let mut all = vec![point];
        if !(size.x.is_finite() && size.y.is_finite()) {
            return all;
        }
        let reach = table.reach(self.radius(ball));
        let (x, y) = (size.x - 2.0 * reach, size.y - 2.0 * reach);
        let mut last = vec![(point, 4)];
        for _ in 0..cushions {
            let mut next = Vec::new();
            for (p, before) in last {
                let mirrored = [
                    Vec2::new(x - p.x, p.y),
                    Vec2::new(-x - p.x, p.y),
                    Vec2::new(p.x, y - p.y),
                    Vec2::new(p.x, -y - p.y),
                ];
                next.extend(mirrored.into_iter().zip(0..).filter(|(_, side)| *side != before));
            }
            all.extend(next.iter().map(|(p, _)| *p));
            last = next;
        }
        all
    }

    /// Adds points at which to aim the cue ball so that `ball` falls.
    fn pots(&self, ball: usize, pocket: Option<usize>, points: &mut Vec<Vec2>) {
        let pockets = self.shot.table().pockets.iter().enumerate();
        for (_, hole) in pockets.filter(|(i, _)| pocket.is_none_or(|p| p == *i)) {
            let targets = self.images(hole.center, ball, 2);
            // Direct pots and banks, kicks, combinations.
            points.extend(targets.iter().map(|target| self.ghost(ball, *target, self.cue)));
            let ghost = self.ghost(ball, hole.center, self.cue);
            points.extend(self.images(ghost, self.cue, 2).into_iter().skip(1));
            for by in self.objects().filter(|by| *by != ball) {
                for target in &targets[..targets.len().min(5)] {
                    points.push(self.ghost(by, self.ghost(ball, *target, by), self.cue));
                }
            }
        }
    }

    /// Adds points for caroms off another ball: the simulation finds the line.
    fn caroms(&self, ball: usize, points: &mut Vec<Vec2>) {
        let cue_ball = self.cue_ball();
        for by in self.objects().filter(|by| *by != ball) {
            points.extend(self.rays(by, self.places[by]).map(|azimuth| {
                let (sin, cos) = carom::math::sin_cos(azimuth);
                cue_ball + Vec2::new(cos, sin)
            }));
        }
    }

    /// Adds azimuths that lead the cue ball to `ball`, directly or off up to two cushions.
    fn hits(&self, ball: usize, found: &mut Vec<f64>) {
        for image in self.images(self.places[ball], self.cue, 2) {
            found.extend(self.rays(ball, image));
        }
    }

    /// Azimuths across the apparent width of `ball` if it were at `place`.
    fn rays(&self, ball: usize, place: Vec2) -> impl Iterator<Item = f64> + use<> {
        let middle = direction(self.cue_ball(), place);
        let reach = self.radius(self.cue) + self.radius(ball);
        let distance = (place - self.cue_ball()).length();
        let half = asin((reach / distance).min(1.0));
        (0..RAYS).map(move |k| middle + half * ((2 * k + 1) as f64 / RAYS as f64 - 1.0))
    }
}

fn direction(from: Vec2, to: Vec2) -> f64 {
    let line = to - from;
    atan2(line.y, line.x)
}

/// A strike and its result.
#[derive(Clone, Debug)]
pub(crate) struct TriedStrike {
    pub(crate) strike: Strike,
    pub(crate) attempt: Attempt,
}

/// The parameters that a refinement may change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Free {
    /// The azimuth alone.
    Azimuth,
    /// All parameters, within these limits; the azimuth freely.
    Within(Limits),
}

/// The range of strikes that a search may return.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    /// Least and greatest speed, m/s.
    pub(crate) speed: [f64; 2],
    /// Largest tip offset, ball radii.
    pub(crate) offset: f64,
    /// Least and greatest elevation to which the cue may be raised, rad; `None` if every strike has
    /// the elevation that the shot gives it.
    pub(crate) elevation: Option<[f64; 2]>,
}

impl Free {
    /// Whether a strike that was changed in this `parameter` is still allowed.
    fn allows(self, strike: &Strike, parameter: usize) -> bool {
        let Self::Within(Limits { speed, offset, elevation }) = self else { return true };
        let within = |[least, most]: [f64; 2], value| (least..=most).contains(&value);
        within(speed, strike.speed)
            && strike.offset() <= offset
            // A default elevation may be larger than one to which the cue may be raised.
            && (parameter != ELEVATION || elevation.is_some_and(|e| within(e, strike.elevation)))
    }
}

/// Reduces the miss of a strike by a pattern search (Hooke & Jeeves 1961): one parameter at a time,
/// with halved steps when no step helps.
pub(crate) fn refine(tester: &mut GoalTester<'_>, start: TriedStrike, free: Free) -> TriedStrike {
    refine_within(tester, start, free, MOST_PLAYS)
}

/// As [`refine`], with `most` plays.
pub(crate) fn refine_within(
    tester: &mut GoalTester<'_>,
    start: TriedStrike,
    free: Free,
    most: u32,
) -> TriedStrike {
    let mut best = start;
    let mut steps = FIRST_STEPS;
    let parameters = match free {
        Free::Azimuth => 1,
        // A cue that may not be raised has one parameter less.
        Free::Within(Limits { elevation: None, .. }) => ELEVATION,
        Free::Within(_) => steps.len(),
    };
    let mut plays = 0;
    while !best.attempt.is_met() && steps[0] > LEAST_STEP && plays < most {
        let mut helped = false;
        for (parameter, step) in steps.iter().enumerate().take(parameters) {
            for sign in [1.0, -1.0] {
                let strike = tester.moved(&best.strike, parameter, sign * step);
                if !free.allows(&strike, parameter) {
                    continue;
                }
                plays += 1;
                let Some(attempt) = tester.play(&strike) else { continue };
                if attempt.miss < best.attempt.miss {
                    best = TriedStrike { strike, attempt };
                    helped = true;
                    break;
                }
            }
        }
        if !helped {
            steps.iter_mut().for_each(|step| *step *= 0.5);
        }
    }
    best
}

/// The index of the elevation among the parameters of a refinement.
const ELEVATION: usize = 4;

impl GoalTester<'_> {
    /// `strike` with an azimuth that is larger `by` this, rad.
    pub(crate) fn turned(&self, strike: &Strike, by: f64) -> Strike {
        self.moved(strike, 0, by)
    }

    /// `strike` with one parameter changed. A strike at the elevation that the shot gives it keeps
    /// to that: the default elevation follows the aim.
    fn moved(&self, strike: &Strike, parameter: usize, by: f64) -> Strike {
        let mut moved = *strike;
        match parameter {
            0 => moved.azimuth += by,
            1 => moved.speed *= 1.0 + by,
            2 => moved.side += by,
            3 => moved.height += by,
            _ => moved.elevation += by,
        }
        let shot = self.shot();
        let follows = parameter != ELEVATION && shot.has_default_elevation();
        if follows && *strike == shot.at_own_elevation(strike) {
            return shot.at_own_elevation(&moved);
        }
        moved
    }
}

/// Moves the azimuth of a strike that meets its goal to the middle of the azimuths that meet it,
/// where a small error is least likely to miss.
pub(crate) fn center(tester: &mut GoalTester<'_>, found: TriedStrike) -> TriedStrike {
    let [left, right] = margins(tester, &found.strike);
    let strike = tester.turned(&found.strike, 0.5 * (left - right));
    match tester.play(&strike) {
        Some(attempt) if attempt.is_met() => TriedStrike { strike, attempt },
        // The azimuths that meet the goal are not contiguous, and their middle is between two
        // parts.
        _ => found,
    }
}

/// By how much (rad) the azimuth of `strike`, which meets its goal, may turn to the left and to the
/// right until it does not; at most 3° (`MOST_WIDTH`).
pub(crate) fn margins(tester: &mut GoalTester<'_>, strike: &Strike) -> [f64; 2] {
    [1.0, -1.0].map(|sign| {
        let mut meets = |by: f64| {
            let turned = tester.turned(strike, sign * by);
            tester.play(&turned).is_some_and(|a| a.is_met())
        };
        let (mut inside, mut width) = (0.0, FIRST_WIDTH);
        while width < MOST_WIDTH && meets(width) {
            inside = width;
            width *= 2.0;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + width);
            if meets(middle) {
                inside = middle;
            } else {
                width = middle;
            }
        }
        inside
    })
}
