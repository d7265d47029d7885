//! The azimuth that pots a ball with a given speed, spin and elevation: aiming by ball and pocket.
//!
//! [`crate::solve()`] searches all strikes. Here only the azimuth is free, as for a player who has chosen
//! the rest: the ghost ball and mirror images give first azimuths, which are refined by simulation,
//! because throw, squirt and swerve turn the balls off these lines.

use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot};

use crate::aim::{Free, MOST_PLAYS, TriedStrike, margins, refine_within, straight};
use crate::goal::{Goal, GoalTester};
use crate::route::Route;

/// Azimuths whose ball passes the pocket at more than this are not refined, m. Refinement turns the
/// cue by a few degrees at most.
const TOO_FAR: f64 = 0.6;

/// A strike is near a pot if its ball passes the pocket at less than this, m: a turn of a degree over
/// the length of a table.
const NEAR: f64 = 0.4;

/// Plays that refine a near strike: half a millisecond or two. Those that need more are mostly lines that
/// are lost; [`PotLines::All`] finds the others.
const NEAR_PLAYS: u32 = 30;

/// Azimuths on either side of the straight line that are tried besides, and their distance, rad: up to
/// 16°. A raised cue with English swerves by as much.
const SWERVES: i32 = 14;
const SWERVE_STEP: f64 = 0.02;

/// Azimuths that are refined, the nearest first: with at most 90 plays each, a few milliseconds.
const REFINED: usize = 5;

/// The azimuth that pots a ball, in the middle of those that do.
#[derive(Clone, Debug, PartialEq)]
pub struct PotAim {
    /// The strike: that of the shot, turned to the pocket. Without an elevation in the shot, at the
    /// default elevation of its direction.
    pub strike: Strike,
    /// By how much the azimuth may be wrong on either side, rad; at most 3° are measured.
    pub margin: f64,
    /// How the balls go.
    pub route: Route,
    /// Whether the cue ball falls into a pocket or leaves the table.
    pub loses_cue_ball: bool,
}

/// Which azimuths are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PotLines {
    /// Those near the shot's own: its ball must almost fall already. The search has few plays, for a picture
    /// that waits for it.
    Near,
    /// These first; then direct lines; then banks, kicks and combinations.
    All,
}

/// Aims the strike of `shot` so that `ball` falls into `pocket` (indices in the shot and the table);
/// speed, spin and elevation stay. None if no such azimuth was found among `lines`.
///
/// # Errors
/// As [`Goal::check`].
pub fn pot_aim(
    shot: &Shot,
    ball: usize,
    pocket: usize,
    lines: PotLines,
) -> Result<Option<PotAim>, Error> {
    let goal = Goal { pot: Some((ball, Some(pocket))), ..Goal::default() };
    goal.check(shot)?;
    let Some((_, strike)) = shot.strike() else { return Ok(None) };
    let mut tester = GoalTester::letting_scratch(shot, goal);
    let own = play(&mut tester, &strike).filter(|tried| tried.attempt.miss < NEAR);
    let plays = if lines == PotLines::Near { NEAR_PLAYS } else { MOST_PLAYS };
    let found = aimed(&mut tester, own.into_iter().collect(), plays);
    if found.is_some() || lines == PotLines::Near {
        return Ok(found);
    }
    let straight = straight(shot, ball, pocket);
    let swerved = (-SWERVES..=SWERVES).filter(|k| *k != 0);
    let swerved = swerved.map(|k| straight + SWERVE_STEP * f64::from(k));
    // The straight line comes first among those that pot the ball.
    let around: Vec<f64> = [straight].into_iter().chain(swerved).collect();
    // A direct pot that is a little off comes before a bank that falls.
    for azimuths in [around, crate::aim::lines(shot, ball, pocket)] {
        let turned = |azimuth| shot.at_own_elevation(&Strike { azimuth, ..strike });
        let mut tried: Vec<TriedStrike> = azimuths
            .into_iter()
            .filter_map(|azimuth| play(&mut tester, &turned(azimuth)))
            .filter(|tried| tried.attempt.miss < TOO_FAR)
            .collect();
        tried.sort_by(|a, b| a.attempt.miss.total_cmp(&b.attempt.miss));
        tried.truncate(REFINED);
        let found = aimed(&mut tester, tried, MOST_PLAYS);
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// The first of these strikes that pots the ball on a simple line after it was refined, with `plays` each.
fn aimed(tester: &mut GoalTester<'_>, tried: Vec<TriedStrike>, plays: u32) -> Option<PotAim> {
    let mut found =
        tried.into_iter().map(|start| refine_within(tester, start, Free::Azimuth, plays));
    let found = found.find(|tried| tried.attempt.is_met() && is_simple(&tried.attempt.route));
    found.map(|found| centered(tester, found))
}

/// Whether players would call this line: at most one of a bank, a kick and a combination, and any
/// jump or massé.
fn is_simple(route: &Route) -> bool {
    let kind = route.kind();
    let names = kind.split('+').filter(|name| !matches!(*name, "jump" | "massé"));
    names.clone().count() <= 1
        && names.into_iter().all(|name| matches!(name, "direct" | "bank" | "kick" | "combination"))
}

fn play(tester: &mut GoalTester<'_>, strike: &Strike) -> Option<TriedStrike> {
    tester.play(strike).map(|attempt| TriedStrike { strike: *strike, attempt })
}

/// The strike in the middle of the azimuths around `found` that pot the ball.
fn centered(tester: &mut GoalTester<'_>, found: TriedStrike) -> PotAim {
    let [left, right] = margins(tester, &found.strike);
    let middle = tester.turned(&found.strike, 0.5 * (left - right));
    let (tried, margin) = match play(tester, &middle) {
        Some(tried) if tried.attempt.is_met() && tried.attempt.route == found.attempt.route => {
            (tried, 0.5 * (left + right))
        }
        // The azimuths that pot the ball are not contiguous.
        _ => (found, left.min(right)),
    };
    let TriedStrike { strike, attempt } = tried;
    let (route, loses_cue_ball) = (attempt.route, attempt.loses_cue_ball);
    PotAim { strike, margin, route, loses_cue_ball }
}
