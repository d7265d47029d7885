//! A second look at the finalists: what can be done after them?
//!
//! The value of a position is an estimate. For some of a finalist's successors it is replaced by
//! that of the best shot that a small search finds there, the other player's shots included. The
//! mean difference corrects the mean over all samples (a control variate): the many cheap values
//! keep the variance small, and the few searched ones remove the bias.

use carom::Error;
use carom_rules::{Frame, Request};

use super::candidate::Candidate;
use super::explore::Explorer;
use super::race::Race;
use crate::player::Situation;
use crate::value::{Position, Value};
use carom_plan::{Prepared, Sampler};

/// A searched successor.
struct Reply {
    finalist: usize,
    /// Searched value less estimated value.
    difference: f64,
    plays: u64,
}

/// Corrects the values of the first `finalists` candidates by searching `representatives`
/// successors of each with about `per_reply` simulations. Returns the number of simulations.
///
/// # Errors
/// As [`Sampler::simulate_variant`].
pub(crate) fn search_replies(
    race: &Race<'_>,
    candidates: &mut [Candidate],
    (finalists, representatives, per_reply): (usize, usize, u64),
) -> Result<u64, Error> {
    let finalists = finalists.min(candidates.len());
    let jobs: Vec<(usize, usize)> = (0..finalists)
        .flat_map(|k| {
            let count = representatives.min(candidates[k].samples.len());
            (0..count).map(move |sample| (k, sample))
        })
        .collect();
    let racing = &*candidates;
    let replies = race.runner.map(
        jobs,
        || (Sampler::new(), race.situation.frame.clone()),
        |(sampler, successor), (k, sample)| {
            reply(race, &racing[k], (sampler, successor), (k, sample, per_reply))
        },
    );
    let mut sums = vec![(0.0, 0_u32); finalists];
    let mut spent = 0;
    for reply in replies {
        let Reply { finalist, difference, plays } = reply?;
        sums[finalist].0 += difference;
        sums[finalist].1 += 1;
        spent += plays;
    }
    for (candidate, (sum, count)) in candidates.iter_mut().zip(sums) {
        candidate.correction = if count > 0 { sum / f64::from(count) } else { 0.0 };
    }
    candidates[..finalists].sort_by(|a, b| b.mean().total_cmp(&a.mean()));
    Ok(spent)
}

fn reply(
    race: &Race<'_>,
    candidate: &Candidate,
    (sampler, successor): (&mut Sampler, &mut Frame),
    (finalist, sample, per_reply): (usize, usize, u64),
) -> Result<Reply, Error> {
    let prepared = &race.prepared[candidate.place];
    let index = candidate.samples[sample].index;
    sampler.simulate_variant(
        prepared,
        &candidate.play.strike,
        &race.errors_of(candidate),
        index,
    )?;
    sampler.rule(prepared, candidate.play.call, successor)?;
    let estimated = candidate.samples[sample].value;
    let situation = Situation { frame: successor, ..*race.situation };
    let (searched, plays) = quick_value(&situation, race.value, per_reply)?;
    let difference = match successor.player() {
        Some(player) if player == race.seat => searched - estimated,
        Some(_) => 1.0 - searched - estimated,
        None => 0.0,
    };
    Ok(Reply { finalist, difference, plays: plays + 1 })
}

/// The value of a position for the player to answer, by a search without errors of about
/// `simulations` simulations, and their number.
///
/// # Errors
/// As [`Explorer::ruled`].
pub(crate) fn quick_value(
    situation: &Situation<'_>,
    value: &dyn Value,
    simulations: u64,
) -> Result<(f64, u64), Error> {
    let frame = situation.frame;
    let position = Position { frame, noise: &situation.noise };
    let Some(player) = frame.player() else { return Ok((0.5, 0)) };
    let estimated = value.win_chance(&position, player);
    let Request::Shot(turn) = frame.request() else { return Ok((estimated, 0)) };
    let mut explorer = Explorer::new(situation, value, turn, simulations);
    let place = match turn.hand {
        Some(region) => explorer.places(region).first().copied(),
        None => None,
    };
    if turn.hand.is_some() && place.is_none() {
        return Ok((estimated, 0));
    }
    let Ok(prepared) = Prepared::new(frame, place) else { return Ok((estimated, 0)) };
    let mut lines = explorer.lines(&prepared);
    lines.truncate(3);
    explorer.most = simulations * 2 / 3;
    explorer.pots(&prepared, 0, &lines)?;
    explorer.most = simulations;
    explorer.safeties(&prepared, 0)?;
    // A safety's value without errors is too good: errors spoil some of them.
    let best = explorer.found.iter().map(|candidate| candidate.prior);
    Ok((best.fold(0.0, f64::max).max(0.0), explorer.plays))
}
