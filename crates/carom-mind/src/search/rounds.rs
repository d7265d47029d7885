//! The rounds of a search: each has twice the simulations of the one before, and starts from what
//! that one has found.

use carom::Error;
use carom_rules::{Rules, Turn};

use super::candidate::{Candidate, PlayKind};
use super::explore::Explorer;
use super::openings::opening_shots;
use super::race::Race;
use super::replies::search_replies;
use super::shift::{deviations, uphill};
use crate::breaks::BreakShot;
use crate::player::{Budget, Situation, Spent};
use crate::settings::SearchSettings;
use crate::value::Value;
use carom_plan::Prepared;

/// Share of the exploring simulations that goes to pots; the rest goes to safeties.
const POTS: f64 = 0.75;
/// A pot better than this makes safeties pointless.
const CERTAIN: f64 = 0.97;
/// Simulations that look for any legal shot where nothing was found.
const ANYTHING: u64 = 600;
/// Two plays on one line whose cue balls end nearer than this, m, are alike.
const ALIKE: f64 = 0.08;
/// Number of alike plays that enter the race.
const MOST_ALIKE: usize = 2;
/// Push-outs that enter the race.
const PUSH_OUTS: usize = 6;
/// Candidates that a further round keeps.
const KEPT: usize = 16;
/// Finalists that are moved uphill.
const SHIFTED: usize = 4;

/// What a search has found.
#[derive(Clone, Debug)]
pub struct Found<'a> {
    /// The candidates, the best first. Those that [`SearchSettings::stated`] asks for have fresh samples.
    pub candidates: Vec<Candidate>,
    /// The positions from which they are played, by [`Candidate::place`].
    pub prepared: Vec<Prepared<'a>>,
    /// What the search has spent.
    pub spent: Spent,
}

/// Searches the plays of a shot.
///
/// # Errors
/// [`Error::Input`] as [`Situation::asked`], and [`Error::TooManyEvents`] if a shot does not end.
pub fn search<'a>(
    situation: &Situation<'a>,
    turn: &Turn,
    (value, settings): (&dyn Value, &SearchSettings),
    budget: &Budget<'_>,
) -> Result<Found<'a>, Error> {
    let mut explorer = Explorer::new(situation, value, turn, 0);
    let mut spent = Spent::default();
    let openings = match situation.frame.is_opening() {
        true => opening_shots(situation, turn, (value, settings), (budget, &mut spent))?,
        false => Vec::new(),
    };
    let places: Vec<Option<[f64; 2]>> = match turn.hand {
        _ if !openings.is_empty() => {
            openings.iter().map(|shot| shot.cue_ball(situation.frame, turn)).collect()
        }
        None => vec![None],
        Some(region) => explorer.places(region).into_iter().map(Some).collect(),
    };
    let prepared = places
        .into_iter()
        .map(|place| Prepared::new(situation.frame, place))
        .collect::<Result<Vec<_>, _>>()?;
    let race =
        Race { situation, value, prepared: &prepared, seat: turn.player, runner: &budget.runner };
    let mut candidates = Vec::new();
    let fresh = settings.fresh(budget.simulations);
    let stating = (fresh * settings.stated as u64).min(budget.simulations / 2);
    let racing = budget.simulations - stating;
    let mut size = settings.first_round.min(racing);
    let mut is_first = true;
    while is_first || budget.allows(spent, size) {
        let before = spent.simulations;
        if core::mem::take(&mut is_first) {
            let simulations = (settings.exploring * size as f64) as u64;
            explore(&mut explorer, (&prepared, &openings), simulations)?;
            spent.simulations += explorer.plays;
            candidates = select(core::mem::take(&mut explorer.found), settings);
        } else {
            candidates.truncate(KEPT);
            if settings.shift {
                shift(&mut candidates, &race);
            }
        }
        let replies = (settings.finalists * settings.representatives) as u64 * settings.per_reply;
        let replies = if 3 * replies <= size { replies } else { 0 };
        let left = size.saturating_sub(spent.simulations - before).saturating_sub(replies);
        spent.simulations += race.run(&mut candidates, left)?;
        if replies > 0 {
            let how = (settings.finalists, settings.representatives, settings.per_reply);
            spent.simulations += search_replies(&race, &mut candidates, how)?;
        }
        spent.rounds += 1;
        size = (2 * size).min(racing.saturating_sub(spent.simulations));
        // A round that is much smaller than the one before would only add noise.
        if size < settings.first_round {
            break;
        }
    }
    if settings.stated > 1 {
        distinct_first(&mut candidates);
    }
    let stated = settings.stated.min(candidates.len());
    spent.simulations += race.freshen(&mut candidates[..stated], fresh)?;
    Ok(Found { candidates, prepared, spent })
}

/// Fills the explorer's candidates with about `simulations` simulations.
fn explore(
    explorer: &mut Explorer<'_>,
    (prepared, openings): (&[Prepared<'_>], &[BreakShot]),
    simulations: u64,
) -> Result<(), Error> {
    let frame = explorer.situation.frame;
    let is_opening = !openings.is_empty();
    explorer.openings(openings, prepared)?;
    let pots = (POTS * simulations as f64) as u64;
    for (k, position) in prepared.iter().enumerate() {
        explorer.most = pots * (k as u64 + 1) / prepared.len() as u64;
        if is_opening {
            break;
        } else if frame.rules() == Rules::ThreeCushion {
            explorer.most = simulations;
            explorer.caroms(position, k)?;
        } else {
            let lines = explorer.lines(position);
            explorer.pots(position, k, &lines)?;
        }
    }
    explorer.most = simulations.max(explorer.plays + simulations / 4);
    let best = explorer.found.iter().map(|candidate| candidate.prior).fold(0.0, f64::max);
    if let Some(first) = prepared.first() {
        if !is_opening && frame.rules() != Rules::ThreeCushion && best < CERTAIN {
            explorer.safeties(first, 0)?;
        }
        if explorer.turn.calls.push_out {
            explorer.most += ANYTHING / 2;
            explorer.push_outs(first, 0)?;
        }
        if explorer.found.is_empty() {
            explorer.most = explorer.plays + ANYTHING;
            explorer.anything(first, 0)?;
        }
    }
    Ok(())
}

/// The candidates that enter the race: the best by their priors, not too many alike, and the best
/// safeties.
fn select(mut found: Vec<Candidate>, settings: &SearchSettings) -> Vec<Candidate> {
    found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
    let (push_outs, found): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::PushOut);
    let (safe, pots): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::Safety);
    let room = settings.racing.saturating_sub(settings.safeties.min(safe.len())).max(1);
    let mut kept: Vec<Candidate> = Vec::new();
    for candidate in pots {
        let alike = kept.iter().filter(|other| are_alike(&candidate, other)).count();
        if alike < MOST_ALIKE && kept.len() < room {
            kept.push(candidate);
        }
    }
    kept.extend(safe.into_iter().take(settings.safeties));
    kept.extend(push_outs.into_iter().take(PUSH_OUTS));
    kept
}

fn are_alike(a: &Candidate, b: &Candidate) -> bool {
    let (Some(la), Some(lb), Some(ea), Some(eb)) = (&a.line, &b.line, a.end, b.end) else {
        return false;
    };
    let (x, y) = (ea[0] - eb[0], ea[1] - eb[1]);
    (la.object, la.pocket, la.kind, a.place) == (lb.object, lb.pocket, lb.kind, b.place)
        && x * x + y * y < ALIKE * ALIKE
}

/// Moves the best candidate of each aim (kind, ball and pocket) before all others, and keeps the
/// order otherwise. Without
/// this a list of a few plays would show one pot in several variants.
fn distinct_first(candidates: &mut Vec<Candidate>) {
    let mut aims = Vec::new();
    let (first, rest): (Vec<_>, Vec<_>) = candidates.drain(..).partition(|candidate| {
        let aim = (candidate.kind, candidate.line.map(|line| (line.object, line.pocket)));
        let is_new = !aims.contains(&aim);
        aims.push(aim);
        is_new
    });
    candidates.extend(first);
    candidates.extend(rest);
}

/// Adds the finalists moved uphill.
fn shift(candidates: &mut Vec<Candidate>, race: &Race<'_>) {
    let frame = race.situation.frame;
    let Some(turn) = frame.turn() else { return };
    let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
    let noise = &race.situation.noise[race.seat];
    let deviations = deviations(noise, radius);
    let moved: Vec<Candidate> = candidates
        .iter()
        .take(SHIFTED)
        .filter_map(|candidate| {
            let shot = race.prepared[candidate.place].shot();
            let most = super::pots::largest_offset(shot, noise, radius);
            let strike = uphill(candidate, &deviations, most.max(candidate.play.strike.offset()))?;
            let play = carom_rules::Play { strike, ..candidate.play };
            let (samples, prior) = (Vec::new(), candidate.mean());
            Some(Candidate { play, samples, prior, correction: 0.0, ..candidate.clone() })
        })
        .collect();
    candidates.extend(moved);
}
