//! Which candidates enter a race, and in which order a list shows them.

use super::candidate::{Candidate, PlayKind};
use crate::settings::SearchSettings;

/// Two plays on one line whose cue balls end nearer than this, m, are alike.
const ALIKE: f64 = 0.08;
/// Number of alike plays that enter the race.
const MOST_ALIKE: usize = 2;
/// Push-outs that enter the race.
const PUSH_OUTS: usize = 6;

/// The best of `found` by their priors, not too many alike, at most `count`. For a list the best one of every
/// aim comes first.
pub(super) fn best_of(mut found: Vec<Candidate>, count: usize, is_list: bool) -> Vec<Candidate> {
    shuffle(&mut found);
    found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
    if is_list {
        distinct_first(&mut found);
    }
    let mut kept: Vec<Candidate> = Vec::new();
    for candidate in found {
        let alike = kept.iter().filter(|other| are_alike(&candidate, other)).count();
        if alike < MOST_ALIKE && kept.len() < count {
            kept.push(candidate);
        }
    }
    kept
}

/// Brings plays into an order that has nothing to do with that in which they were found, so that
/// equal priors favour no speed or spin.
fn shuffle(found: &mut [Candidate]) {
    // The fractional part of k φ is spread evenly over 0 to 1.
    const PHI: f64 = 0.618_033_988_749_894_9;
    let mut order: Vec<usize> = (0..found.len()).collect();
    order.sort_by(|a, b| (PHI * *a as f64 % 1.0).total_cmp(&(PHI * *b as f64 % 1.0)));
    let mut shuffled: Vec<Candidate> = order.iter().map(|k| found[*k].clone()).collect();
    found.swap_with_slice(&mut shuffled);
}

/// The candidates that enter the race: the best by their priors, not too many alike, and the best
/// safeties.
pub(super) fn select(
    mut found: Vec<Candidate>,
    settings: &SearchSettings,
    wanted: usize,
    is_list: bool,
) -> Vec<Candidate> {
    found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
    let (push_outs, found): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::PushOut);
    let (safe, pots): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::Safety);
    let room = settings.racing.max(wanted);
    let room = room.saturating_sub(settings.safeties.min(safe.len())).max(1);
    let mut kept = best_of(pots, room, is_list);
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

/// Moves the best candidate of each aim before all others, these by their values, and
/// keeps the order otherwise. Without this a list of a few plays would show one pot in several variants, and
/// omit a play that a race has dropped for variants of a better one.
pub(super) fn distinct_first(candidates: &mut Vec<Candidate>) {
    let mut aims = Vec::new();
    let (first, rest): (Vec<_>, Vec<_>) = candidates.drain(..).partition(|candidate| {
        let aim = candidate.aim();
        let is_new = !aims.contains(&aim);
        aims.push(aim);
        is_new
    });
    candidates.extend(first);
    candidates.sort_by(|a, b| b.mean().total_cmp(&a.mean()));
    candidates.extend(rest);
}
