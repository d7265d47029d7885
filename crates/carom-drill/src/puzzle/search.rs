//! Strikes that solve a puzzle.

use carom::math::{Vec2, asin, atan2};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot};
use carom_plan::{PotLines, pot_aim};

use super::task::{Search, Task, Tip};

/// Strikes that are ranked.
const MOST: usize = 60;

/// Speeds of strikes without spin: those of a player who thinks of the pot alone, m/s.
const PLAIN: [f64; 2] = [1.2, 1.9];

/// The strikes that solve the puzzle, spread over those that were tried.
pub(super) fn strikes(
    task: &Task,
    solves: &mut impl FnMut(&Strike) -> bool,
) -> Result<Vec<Strike>, Error> {
    let tried = match &task.search {
        Search::Pot { ball, pockets, tips, .. } => pots(&task.shot, *ball, pockets, tips)?,
        Search::Aims { balls, tips, aims } => aims_at(&task.shot, balls, tips, *aims),
        Search::Around { tips, directions } => around(&task.shot, tips, *directions),
    };
    let solving: Vec<Strike> = tried.into_iter().filter(|strike| solves(strike)).collect();
    let step = solving.len().div_ceil(MOST).max(1);
    Ok(solving.into_iter().step_by(step).collect())
}

/// Strikes without spin that pot the ball of a puzzle in which the cue ball has a task after the pot.
pub(super) fn plain(task: &Task) -> Result<Vec<Strike>, Error> {
    let Search::Pot { ball, pockets, is_about_cue_ball: true, .. } = &task.search else {
        return Ok(Vec::new());
    };
    pots(&task.shot, *ball, pockets, &PLAIN.map(|speed| Tip { speed, side: 0.0, height: 0.0 }))
}

/// For each pocket: the strike of the first tip that pots the ball, then those of the other tips near it.
fn pots(shot: &Shot, ball: usize, pockets: &[usize], tips: &[Tip]) -> Result<Vec<Strike>, Error> {
    let mut found = Vec::new();
    for &pocket in pockets {
        let mut azimuth: Option<f64> = None;
        for tip in tips {
            let (from, lines) = match azimuth {
                None => (shot.strike().map_or(0.0, |(_, strike)| strike.azimuth), PotLines::All),
                Some(known) => (known, PotLines::Near),
            };
            let Ok(aimed) = shot.with_default_elevation(&tip.towards(shot, from)) else { continue };
            match pot_aim(&aimed, ball, pocket, lines)? {
                Some(aim) if !aim.loses_cue_ball => {
                    azimuth = Some(aim.strike.azimuth);
                    found.push(aim.strike);
                }
                Some(aim) => azimuth = Some(aim.strike.azimuth),
                None if azimuth.is_none() => break,
                None => {}
            }
        }
    }
    Ok(found)
}

/// Every tip, aimed at each ball from one edge to the other.
fn aims_at(shot: &Shot, balls: &[usize], tips: &[Tip], aims: u32) -> Vec<Strike> {
    let place = |ball: usize| {
        let [x, y, _] = shot.balls()[ball].state.position.to_array();
        Vec2::new(x, y)
    };
    let Some((cue, _)) = shot.strike() else { return Vec::new() };
    let mut found = Vec::new();
    for &ball in balls {
        let way = place(ball) - place(cue);
        let reach = shot.balls()[cue].ball.radius + shot.balls()[ball].ball.radius;
        let (straight, half) = (atan2(way.y, way.x), asin((reach / way.length()).min(1.0)));
        for tip in tips {
            let aim =
                |k: u32| straight + half * (2.0 * (f64::from(k) + 0.5) / f64::from(aims) - 1.0);
            found.extend((0..aims).map(|k| tip.towards(shot, aim(k))));
        }
    }
    found
}

/// Every tip in every direction.
fn around(shot: &Shot, tips: &[Tip], directions: u32) -> Vec<Strike> {
    let turn = core::f64::consts::TAU / f64::from(directions);
    let all = tips
        .iter()
        .flat_map(|tip| (0..directions).map(move |k| tip.towards(shot, turn * f64::from(k))));
    all.collect()
}
