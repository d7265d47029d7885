//! The Monte-Carlo search of PickPocket (Smith 2007) and CueCard (Archibald, Altman & Shoham 2009).
//!
//! At level one a shot is played with drawn errors, and its value is the mean of the states'
//! values. At level two the value of a state is that of the best next shot from there.

use carom::Error;
use carom_rules::{Frame, Request};

use super::baseline::Baseline;
use super::clusters::{point, representatives};
use super::pot_table::EVERY_KIND;
use super::shots::{PotShot, Sight, Stroke};
use crate::search::CuePlace;
use crate::workbench::Workbench;
use carom_plan::Prepared;

/// Most drawn errors of a shot that a player's settings may ask for.
pub(crate) const MOST_SAMPLES: i64 = 10_000;

/// What a player thinks of a state that one of its shots leaves.
pub(crate) type Gain<'a> = dyn Fn(&Frame) -> f64 + Sync + 'a;

/// How the shots of a node are rated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rating {
    /// By the mean gain over this many drawn errors.
    Sampled(u64),
    /// By the table's probability times the gain of the state without errors.
    Noiseless,
}

/// The search of a node at level two.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeSearch<'a> {
    pub(crate) strokes: &'a [Stroke],
    pub(crate) rating: Rating,
    /// Most simulations of one node.
    pub(crate) most: u64,
}

/// A shot with what is known about it.
#[derive(Clone, Debug)]
pub(crate) struct Rated {
    pub(crate) shot: PotShot,
    /// The states that it left with drawn errors.
    pub(crate) states: Vec<Frame>,
    /// Mean gain of the states: the value at level one.
    pub(crate) mean: f64,
    /// Share of the states in which the player shoots next or has won.
    pub(crate) kept: f64,
}

/// The shots of the request, from each prepared position, within `most` simulations; those with the
/// best gains without errors first. Returns the simulations too.
///
/// # Errors
/// As [`Workbench::pot_shots`].
pub(crate) fn generate(
    baseline: &Baseline<'_>,
    strokes: &[Stroke],
    most: u64,
    gain: &Gain<'_>,
) -> Result<(Vec<PotShot>, u64), Error> {
    let sight = baseline.sight();
    let mut bench = Workbench::new(baseline.situation.frame);
    let mut shots = Vec::new();
    let own = most / baseline.prepared.len().max(1) as u64;
    for at in baseline.places() {
        let lines = sight.lines(at.prepared, &EVERY_KIND);
        shots.extend(bench.pot_shots(&sight, at, &lines, strokes, own)?);
    }
    let mut rated: Vec<(f64, PotShot)> =
        shots.into_iter().map(|shot| (shot.chance * gain(&shot.successor), shot)).collect();
    rated.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok((rated.into_iter().map(|(_, shot)| shot).collect(), bench.plays))
}

/// Level one: plays each shot with the drawn errors 0 to `samples` − 1, the same for all shots. The
/// best shot comes first.
///
/// # Errors
/// As [`Workbench::sample`].
pub(crate) fn level_one(
    baseline: &Baseline<'_>,
    shots: Vec<PotShot>,
    samples: u64,
    gain: &Gain<'_>,
) -> Result<Vec<Rated>, Error> {
    let errors = baseline.errors();
    let rated = baseline.budget.runner.map(
        shots,
        || Workbench::new(baseline.situation.frame),
        |bench, shot| {
            let (mut states, mut sum, mut kept) = (Vec::new(), 0.0, 0.0);
            let prepared = &baseline.prepared[shot.place];
            bench.sample(prepared, &shot.play, &errors, 0..samples, |next, keeps| {
                sum += gain(next);
                kept += f64::from(u8::from(keeps));
                states.push(next.clone());
            })?;
            let count = samples as f64;
            Ok(Rated { shot, states, mean: sum / count, kept: kept / count })
        },
    );
    let mut rated = rated.into_iter().collect::<Result<Vec<_>, Error>>()?;
    rated.sort_by(|a, b| b.mean.total_cmp(&a.mean));
    Ok(rated)
}

/// Level two: the mean value of the states of each of `finalists`, in their order, and the number
/// of simulations. States in which the player shoots again are searched; at most `clusters` of
/// each shot, which represent the others. All other states keep their gain.
///
/// # Errors
/// As [`Workbench::sample`].
pub(crate) fn level_two(
    baseline: &Baseline<'_>,
    finalists: &[Rated],
    clusters: usize,
    search: &NodeSearch<'_>,
    gain: &Gain<'_>,
) -> Result<(Vec<f64>, u64), Error> {
    // One job for each node, so that the threads have equal work.
    let mut jobs: Vec<(usize, &Frame, f64)> = Vec::new();
    let mut values = vec![0.0; finalists.len()];
    for (k, finalist) in finalists.iter().enumerate() {
        let count = finalist.states.len() as f64;
        let (own, others): (Vec<&Frame>, Vec<&Frame>) =
            finalist.states.iter().partition(|state| is_searched(state, baseline));
        values[k] = others.into_iter().map(gain).sum::<f64>() / count;
        let points: Vec<Vec<f64>> = own.iter().map(|state| point(state)).collect();
        for found in representatives(&points, clusters) {
            jobs.push((k, own[found.state], found.count as f64 / count));
        }
    }
    let searched = baseline.budget.runner.map(
        jobs.iter().map(|(_, state, _)| *state),
        || Workbench::new(baseline.situation.frame),
        |bench, state| {
            let before = bench.plays;
            let value = node_value(baseline, bench, state, search, gain)?;
            Ok((value, bench.plays - before))
        },
    );
    let mut plays = 0;
    for ((k, _, weight), searched) in jobs.into_iter().zip(searched) {
        let (value, own) = searched.map_err(|error: Error| error)?;
        values[k] += weight * value;
        plays += own;
    }
    Ok((values, plays))
}

/// Whether level two looks for the player's next shot in this state. A ball in hand is valued by
/// the gain alone.
pub(crate) fn is_searched(state: &Frame, baseline: &Baseline<'_>) -> bool {
    matches!(state.request(), Request::Shot(turn) if turn.player == baseline.seat() && turn.hand.is_none())
}

/// The value of the best shot from a state in which the player shoots; 0 if it has none.
///
/// # Errors
/// As [`Workbench::sample`].
pub(crate) fn node_value(
    baseline: &Baseline<'_>,
    bench: &mut Workbench,
    state: &Frame,
    search: &NodeSearch<'_>,
    gain: &Gain<'_>,
) -> Result<f64, Error> {
    let Some(turn) = state.turn() else { return Ok(gain(state)) };
    let sight = Sight::new(state, turn, baseline.table(), baseline.noise());
    let prepared = Prepared::new(state, None)?;
    let lines = sight.lines(&prepared, &EVERY_KIND);
    let most = match search.rating {
        Rating::Noiseless => search.most,
        // The generation of a shot costs about as much as two or three samples.
        Rating::Sampled(samples) => search.most * 3 / (samples + 3),
    };
    let at = CuePlace { number: 0, prepared: &prepared };
    let shots = bench.pot_shots(&sight, at, &lines, search.strokes, most)?;
    let errors = baseline.errors();
    let mut best: f64 = 0.0;
    for shot in &shots {
        let value = match search.rating {
            Rating::Noiseless => shot.chance * gain(&shot.successor),
            Rating::Sampled(samples) => {
                let mut sum = 0.0;
                let add = |next: &Frame, _| sum += gain(next);
                bench.sample(&prepared, &shot.play, &errors, 0..samples, add)?;
                sum / samples as f64
            }
        };
        best = best.max(value);
    }
    Ok(best)
}
