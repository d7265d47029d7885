//! The rounds of a search: each has 1.6 times the simulations of the one before, and starts from what
//! that one has found.

use carom::Error;
use carom_rules::{Frame, Play, Rules, Turn};

use super::candidate::{Candidate, PlayKind};
use super::explore::Explorer;
use super::openings::opening_shots;
use super::pots::KnownLine;
use super::race::Race;
use super::replies::Replies;
use super::shift::{deviations, means, uphill};
use super::windows::direct_pots;
use crate::breaks::BreakShot;
use crate::player::{Budget, Situation, Spent};
use crate::settings::{BreakChoice, SearchSettings};
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
/// Simulations of the first and of a further round for each new candidate that enters its race, and the most of
/// these.
const PER_CANDIDATE: [u64; 2] = [24, 40];
const MOST_NEW: u64 = 1000;
/// Share of a further round's exploration for lines that no round has tried yet.
const UNTRIED: f64 = 0.3;
/// Shares of what is left then for neighbours of the best plays, and for further strikes on the lines of pots (for a
/// decision, and for a list, which wants the best play of every line); the rest goes to any hits of a ball on.
const NEAR: f64 = 0.3;
const FURTHER: [f64; 2] = [0.15, 0.45];
/// The first round has at least this part of the simulations, up to a limit: only the first one tries whole
/// lattices. Budgets above [`LIMITED`] are those of a clock, which may end soon.
const FIRST_SHARE: u64 = 10;
const MOST_FIRST: u64 = 2000;
const LIMITED: u64 = 1 << 40;
/// Factors of the first round's simulations: where there are more plays, with the cue ball in hand or with
/// push-outs; and for opening shots and three-cushion, where later rounds find nothing that is not near a play
/// of the first one.
const MORE_PLAYS: u64 = 3;
const OPENING: u64 = 5;
/// Factor of the simulations from one round to the next.
const GROWTH: f64 = 1.6;
/// Fewest samples by which the aims of a list are compared, as a share of its fresh samples.
const COMPARED: f64 = 0.3;
/// Finalists that are moved uphill.
const SHIFTED: usize = 4;

/// What a search has found.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// The candidates, the best first. Those that [`SearchSettings::stated`] asks for have fresh samples.
    pub(crate) candidates: Vec<Candidate>,
    /// What the search has spent.
    pub(crate) spent: Spent,
}

/// What is searched, and how.
pub(crate) struct SearchTask<'a, 'b> {
    pub(crate) situation: &'b Situation<'a>,
    pub(crate) turn: &'b Turn,
    pub(crate) value: &'b dyn Value,
    pub(crate) settings: &'b SearchSettings,
    pub(crate) budget: &'b Budget<'b>,
}

impl<'b> SearchTask<'_, 'b> {
    /// The race between plays from these positions.
    fn race(&self, prepared: &'b [Prepared<'b>], foul_correction: f64) -> Race<'b> {
        Race {
            foul_correction,
            situation: self.situation,
            value: self.value,
            prepared,
            seat: self.turn.player,
            runner: &self.budget.runner,
            common_errors: self.settings.common_errors,
        }
    }
}

/// A search between two of its rounds. It borrows nothing, so a program can do other work before the
/// next round.
#[derive(Clone, Debug)]
pub struct Rounds {
    /// The opening shots that are compared; empty for another shot.
    openings: Vec<BreakShot>,
    /// The places from which the cue ball is played.
    places: Vec<Option<[f64; 2]>>,
    candidates: Vec<Candidate>,
    /// The lines of pots.
    lines: Vec<KnownLine>,
    /// Number of strikes that further rounds have tried on them.
    strikes: u64,
    spent: Spent,
    /// Number of races so far.
    races: u32,
    /// Simulations of the next round.
    size: u64,
    /// Simulations of all rounds.
    racing: u64,
    /// Number of plays whose chances are stated.
    stated: usize,
    /// Fresh samples of such a play.
    fresh: u64,
    is_complete: bool,
    /// What is added to the value of a foul; none if no search has looked at it yet.
    foul_correction: Option<f64>,
}

impl Rounds {
    /// A search before its first round.
    pub(crate) fn new(task: &SearchTask<'_, '_>) -> Self {
        let SearchTask { situation, turn, value, settings, budget } = *task;
        let stated = settings.stated;
        let explorer = Explorer::new(situation, value, turn, 0);
        let places = match turn.hand {
            None => vec![None],
            Some(region) => explorer.places(region).into_iter().map(Some).collect(),
        };
        let fresh = settings.fresh(budget.simulations);
        let stating = (fresh * stated as u64).min(budget.simulations / 2);
        let racing = budget.simulations - stating;
        let least = settings.first_round * first_factor(situation.frame, turn);
        let share = if racing > LIMITED { 0 } else { (racing / FIRST_SHARE).min(MOST_FIRST) };
        let size = round_size(least.max(share), racing);
        let (candidates, lines, spent) = (Vec::new(), Vec::new(), Spent::default());
        Self {
            openings: Vec::new(),
            places,
            candidates,
            lines,
            strikes: 0,
            spent,
            races: 0,
            size,
            racing,
            stated,
            fresh,
            is_complete: false,
            foul_correction: None,
        }
    }

    /// The search, which takes the value's word for what fouls are worth.
    pub(crate) fn without_doubts(self) -> Self {
        Self { foul_correction: Some(0.0), ..self }
    }

    /// What the rounds have spent.
    pub const fn spent(&self) -> Spent {
        self.spent
    }

    /// The best play so far.
    pub fn best(&self) -> Option<&Candidate> {
        self.candidates.first()
    }

    fn prepared<'a>(&self, situation: &Situation<'a>) -> Result<Vec<Prepared<'a>>, Error> {
        self.places.iter().map(|place| Prepared::new(situation.frame, *place)).collect()
    }

    /// Plays the next round if the budget allows one. Returns whether it was played.
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if a shot does not end.
    pub(crate) fn play(&mut self, task: &SearchTask<'_, '_>) -> Result<bool, Error> {
        let SearchTask { situation, turn, value, settings, budget } = *task;
        let is_first = self.races == 0;
        if self.is_complete || !(is_first || budget.allows(self.spent, self.size)) {
            return Ok(false);
        }
        if is_first && situation.frame.is_opening() {
            let searching = (budget, &mut self.spent);
            self.openings = opening_shots(situation, turn, (value, settings), searching)?;
            let place = |shot: &BreakShot| shot.cue_ball(situation.frame, turn);
            if !self.openings.is_empty() {
                self.places = self.openings.iter().map(place).collect();
            }
        }
        let prepared = &self.prepared(situation)?;
        let race = task.race(prepared, self.foul_correction.unwrap_or_default());
        let before = self.spent.simulations;
        let is_last = before + self.size >= self.racing;
        let mut explorer = Explorer::new(situation, value, turn, 0);
        explorer.lists = self.stated > 1;
        if is_first {
            let simulations = (settings.exploring * self.size as f64) as u64;
            self.lines = explore(&mut explorer, (prepared, &self.openings), simulations)?;
            let room = (self.size / PER_CANDIDATE[0]).min(MOST_NEW);
            self.candidates = select(explorer.found, settings, (room as usize, self.stated > 1));
        } else {
            if self.stated > 1 {
                distinct_first(&mut self.candidates);
            }
            self.candidates.truncate(KEPT);
            if settings.shift {
                shift(&mut self.candidates, &race, explorer.speeds);
            }
            explorer.measures_windows = true;
            let made = self.lines.iter().filter(|known| known.is_made());
            explorer.direct_pots = direct_pots(made.map(|known| &known.line), &prepared[0]);
            let refining = settings.refining * self.size as f64;
            let round = self.races - 1;
            explorer.most = (UNTRIED * refining) as u64;
            explorer.untried_pots(prepared, &mut self.lines)?;
            let rest = refining - explorer.plays as f64;
            explorer.most = explorer.plays + (NEAR * rest) as u64;
            explorer.refine((prepared, &mut self.lines), &self.candidates, round)?;
            explorer.most = explorer.plays + (FURTHER[usize::from(self.stated > 1)] * rest) as u64;
            let first = self.strikes;
            self.strikes = explorer.more_pots(prepared, &mut self.lines, first)?;
            explorer.most = refining as u64;
            let best = self.candidates.first().map_or(0.0, Candidate::mean);
            if best < CERTAIN && !situation.frame.is_opening() {
                self.strikes = explorer.more_hits(prepared, self.strikes)?;
            }
            let room = (self.size / PER_CANDIDATE[1]).clamp(KEPT as u64, MOST_NEW);
            self.candidates.extend(best_of(explorer.found, (room as usize, self.stated > 1)));
        }
        self.spent.simulations += explorer.plays;
        let left = self.size.saturating_sub(self.spent.simulations - before);
        let replies = Replies::within((settings.replying * self.size as f64) as u64, settings);
        let cost = replies.as_ref().map_or(0, Replies::cost);
        self.spent.simulations += race.run(&mut self.candidates, left.saturating_sub(cost))?;
        if let Some(replies) = replies {
            self.spent.simulations += replies.search(&race, &mut self.candidates)?;
        }
        self.doubt_fouls(task, prepared)?;
        self.spent.rounds += 1;
        self.races += 1;
        let left = self.racing.saturating_sub(self.spent.simulations);
        // Further rounds would change a break that is to be the same in every rack.
        let is_fixed = settings.break_shot != BreakChoice::Searched && situation.frame.is_opening();
        self.is_complete = is_last || left == 0 || is_fixed;
        self.size = round_size((GROWTH * self.size as f64) as u64, left);
        Ok(true)
    }

    /// Looks once at what fouls are worth, when a play that lives on them comes first.
    fn doubt_fouls(
        &mut self,
        task: &SearchTask<'_, '_>,
        prepared: &[Prepared<'_>],
    ) -> Result<(), Error> {
        if self.foul_correction.is_none() {
            let spent = self.spent.simulations;
            let found = task.doubt_fouls(prepared, &mut self.candidates, spent)?;
            if let Some((correction, cost)) = found {
                self.foul_correction = Some(correction);
                self.spent.simulations += cost;
            }
        }
        Ok(())
    }

    /// Prepares the candidates for a list of plays: each play occurs once, and has the kind of what it does.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub(crate) fn name(&mut self, task: &SearchTask<'_, '_>) -> Result<(), Error> {
        let mut plays: Vec<Play> = Vec::new();
        self.candidates.retain(|candidate| {
            let is_new = !plays.contains(&candidate.play);
            plays.push(candidate.play);
            is_new
        });
        let prepared = self.prepared(task.situation)?;
        if self.stated > 1 {
            distinct_first(&mut self.candidates);
            // Races have dropped some of these aims early, with few samples.
            let compared = self.candidates.len().min(2 * self.stated);
            let least = (self.fresh as f64 * COMPARED) as u64;
            let race = task.race(&prepared, self.foul_correction.unwrap_or_default());
            self.spent.simulations += race.fill(&mut self.candidates[..compared], least)?;
        }
        self.candidates.truncate(self.stated + KEPT);
        let mut explorer = Explorer::new(task.situation, task.value, task.turn, 0);
        for candidate in &mut self.candidates {
            let place = candidate.place;
            explorer.name(candidate, &prepared[place])?;
        }
        self.spent.simulations += explorer.plays;
        Ok(())
    }

    /// What the rounds have found. A foul on purpose is looked at again, and the best plays get fresh samples.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub(crate) fn end(mut self, task: &SearchTask<'_, '_>) -> Result<Found, Error> {
        let prepared = self.prepared(task.situation)?;
        self.doubt_fouls(task, &prepared)?;
        let Self { mut candidates, mut spent, stated, mut fresh, foul_correction, .. } = self;
        let race = task.race(&prepared, foul_correction.unwrap_or_default());
        if !self.is_complete {
            // The clock is over, or the rounds: the statement costs its share of what they have spent.
            let settings = SearchSettings { stated, ..*task.settings };
            fresh = fresh.min(settings.fresh(spent.simulations));
        }
        if stated > 1 {
            distinct_first(&mut candidates);
        }
        let stated = stated.min(candidates.len());
        spent.simulations += race.freshen(&mut candidates[..stated], fresh)?;
        Ok(Found { candidates, spent })
    }
}

/// By how much the first round is larger than that of a usual shot.
fn first_factor(frame: &Frame, turn: &Turn) -> u64 {
    match turn.hand {
        _ if frame.is_opening() || frame.rules() == Rules::ThreeCushion => OPENING,
        Some(_) => MORE_PLAYS,
        None if turn.calls.push_out => MORE_PLAYS,
        None => 1,
    }
}

/// The simulations of a round that should have `wanted` of the `left` ones: all, if less than
/// another such round would remain.
const fn round_size(wanted: u64, left: u64) -> u64 {
    if left < 2 * wanted { left } else { wanted }
}

/// Fills the explorer's candidates with about `simulations` simulations.
fn explore(
    explorer: &mut Explorer<'_>,
    (prepared, openings): (&[Prepared<'_>], &[BreakShot]),
    simulations: u64,
) -> Result<Vec<KnownLine>, Error> {
    let frame = explorer.situation.frame;
    let is_opening = !openings.is_empty();
    explorer.openings(openings, prepared)?;
    let pots = (POTS * simulations as f64) as u64;
    let mut lines = Vec::new();
    for (k, position) in prepared.iter().enumerate() {
        explorer.most = pots * (k as u64 + 1) / prepared.len() as u64;
        if is_opening {
            break;
        }
        if frame.rules() == Rules::ThreeCushion {
            explorer.most = simulations;
            explorer.caroms(position, k)?;
        } else {
            let mut known = explorer.lines(position, k);
            explorer.pots(position, &mut known)?;
            lines.extend(known);
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
    Ok(lines)
}

/// The best of `found` by their priors, not too many alike, at most `count`. For a list the best one of every
/// aim comes first.
fn best_of(mut found: Vec<Candidate>, (count, is_list): (usize, bool)) -> Vec<Candidate> {
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
fn select(
    mut found: Vec<Candidate>,
    settings: &SearchSettings,
    (wanted, is_list): (usize, bool),
) -> Vec<Candidate> {
    found.sort_by(|a, b| b.prior.total_cmp(&a.prior));
    let (push_outs, found): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::PushOut);
    let (safe, pots): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|c| c.kind == PlayKind::Safety);
    let room = settings.racing.max(wanted);
    let room = room.saturating_sub(settings.safeties.min(safe.len())).max(1);
    let mut kept = best_of(pots, (room, is_list));
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

/// Moves the best candidate of each aim (kind, ball and pocket) before all others, these by their values, and
/// keeps the order otherwise. Without this a list of a few plays would show one pot in several variants, and
/// omit a play that a race has dropped for variants of a better one.
fn distinct_first(candidates: &mut Vec<Candidate>) {
    let mut aims = Vec::new();
    let (first, rest): (Vec<_>, Vec<_>) = candidates.drain(..).partition(|candidate| {
        let aim = (candidate.kind, candidate.pot);
        let is_new = !aims.contains(&aim);
        aims.push(aim);
        is_new
    });
    candidates.extend(first);
    candidates.sort_by(|a, b| b.mean().total_cmp(&a.mean()));
    candidates.extend(rest);
}

/// Adds the finalists moved uphill, within `speeds` (the least and the greatest, m/s).
fn shift(candidates: &mut Vec<Candidate>, race: &Race<'_>, speeds: [f64; 2]) {
    let frame = race.situation.frame;
    let Some(turn) = frame.turn() else { return };
    let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
    let noise = &race.situation.noise[race.seat];
    let means = means(noise, radius);
    let moved: Vec<Candidate> = candidates
        .iter()
        .take(SHIFTED)
        .filter_map(|candidate| {
            let shot = race.prepared[candidate.place].shot();
            let most = super::pots::largest_offset(shot, noise, radius);
            let most = most.max(candidate.play.strike.offset());
            let deviations = deviations(noise, candidate.play.strike.speed, radius);
            let strike = uphill(candidate, (&means, &deviations), (speeds, most))?;
            let play = carom_rules::Play { strike, ..candidate.play };
            let (samples, prior) = (Vec::new(), candidate.mean());
            Some(Candidate { play, samples, prior, correction: 0.0, ..candidate.clone() })
        })
        .collect();
    candidates.extend(moved);
}
