//! The rounds of a search: each has 1.6 times the simulations of the one before, and starts from what
//! that one has found.

use carom::Error;
use carom_plan::Prepared;
use carom_rules::Play;

use super::candidate::Candidate;
use super::explore::{Explorer, cue_places};
use super::openings::opening_shots;
use super::pots::KnownLine;
use super::race::Race;
use super::replies::Replies;
use super::select::{best_of, distinct_first, select};
use super::shift::shift;
use super::task::{SearchTask, ShotTask};
use crate::breaks::BreakShot;
use crate::player::Spent;
use crate::settings::{BreakChoice, SearchSettings};

/// Share of the exploring simulations that goes to pots; the rest goes to safeties.
const POTS: f64 = 0.75;
/// A pot better than this makes safeties pointless.
const CERTAIN: f64 = 0.97;
/// Simulations that look for any legal shot where nothing was found.
const ANYTHING: u64 = 600;
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
/// push-outs; and for opening shots and carom games, where later rounds find nothing that is not near a play
/// of the first one.
const MORE_PLAYS: u64 = 3;
const OPENING: u64 = 5;
/// Factor of the simulations from one round to the next.
const GROWTH: f64 = 1.6;
/// Fewest samples by which the aims of a list are compared, as a share of its fresh samples.
const COMPARED: f64 = 0.3;

/// What a search has found.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// The candidates, the best first. Those that [`SearchSettings::stated`] asks for have fresh samples.
    pub(crate) candidates: Vec<Candidate>,
    /// What the search has spent.
    pub(crate) spent: Spent,
}

/// What the rounds of a search have found so far. It borrows nothing, so a program can do other work before
/// the next round.
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
    /// What the rounds have spent.
    pub const fn spent(&self) -> Spent {
        self.spent
    }

    /// The best play so far.
    pub fn best(&self) -> Option<&Candidate> {
        self.candidates.first()
    }

    /// The number of plays whose chances are stated.
    pub(crate) const fn stated(&self) -> usize {
        self.stated
    }

    /// Whether the best plays of a list are wanted, and not the best play alone.
    const fn is_list(&self) -> bool {
        self.stated > 1
    }
}

/// A search for the best plays of a shot, round by round.
pub struct ShotSearch<'a> {
    pub(crate) task: SearchTask<'a>,
    rounds: Rounds,
}

impl<'a> ShotSearch<'a> {
    /// A search before its first round. At its end the chances of `stated` plays are stated.
    pub(crate) fn new(task: SearchTask<'a>, stated: usize) -> Self {
        let SearchTask { shot, settings, budget } = task;
        let places = match shot.turn.hand {
            None => vec![None],
            Some(region) => shot.places(region).into_iter().map(Some).collect(),
        };
        let fresh = SearchSettings::fresh(budget.simulations, stated);
        let stating = (fresh * stated as u64).min(budget.simulations / 2);
        let racing = budget.simulations - stating;
        let least = settings.first_round * first_factor(&shot);
        let share = if racing > LIMITED { 0 } else { (racing / FIRST_SHARE).min(MOST_FIRST) };
        let rounds = Rounds {
            openings: Vec::new(),
            places,
            candidates: Vec::new(),
            lines: Vec::new(),
            strikes: 0,
            spent: Spent::default(),
            races: 0,
            size: round_size(least.max(share), racing),
            racing,
            stated,
            fresh,
            is_complete: false,
            foul_correction: None,
        };
        Self { task, rounds }
    }

    /// A search that goes on with `rounds`.
    pub(crate) const fn resumed(task: SearchTask<'a>, rounds: Rounds) -> Self {
        Self { task, rounds }
    }

    /// The search, which takes the value's word for what fouls are worth.
    pub(crate) fn without_doubts(mut self) -> Self {
        self.rounds.foul_correction = Some(0.0);
        self
    }

    /// What the search has found so far.
    pub const fn rounds(&self) -> &Rounds {
        &self.rounds
    }

    /// The same without the search, which [`crate::Searcher::resume`] continues.
    pub fn into_rounds(self) -> Rounds {
        self.rounds
    }

    /// Plays the next round if the budget allows one. Returns whether it was played.
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if a shot does not end.
    pub fn play_round(&mut self) -> Result<bool, Error> {
        let Rounds { races, is_complete, spent, size, .. } = self.rounds;
        let is_first = races == 0;
        if is_complete || !(is_first || self.task.budget.allows(spent, size)) {
            return Ok(false);
        }
        if is_first && self.task.shot.frame().is_opening() {
            self.find_openings()?;
        }
        let prepared = &self.prepared()?;
        let before = self.rounds.spent.simulations;
        if is_first {
            self.explore_first(prepared)?;
        } else {
            self.explore_further(prepared)?;
        }
        let explored = self.rounds.spent.simulations - before;
        self.race_candidates(prepared, size.saturating_sub(explored))?;
        self.doubt_fouls(prepared)?;
        self.end_round(before + size);
        Ok(true)
    }

    pub(super) fn prepared(&self) -> Result<Vec<Prepared<'a>>, Error> {
        let frame = self.task.shot.frame();
        self.rounds.places.iter().map(|place| Prepared::new(frame, *place)).collect()
    }

    pub(super) fn race<'b>(&'b self, prepared: &'b [Prepared<'b>]) -> Race<'b> {
        self.task.race(prepared, self.rounds.foul_correction.unwrap_or_default())
    }

    /// The opening shots that the first round compares, and their places.
    fn find_openings(&mut self) -> Result<(), Error> {
        let ShotTask { situation, turn, .. } = self.task.shot;
        let openings = opening_shots(&self.task, &mut self.rounds.spent)?;
        if !openings.is_empty() {
            let place = |shot: &BreakShot| shot.cue_ball(situation.frame, turn);
            self.rounds.places = openings.iter().map(place).collect();
        }
        self.rounds.openings = openings;
        Ok(())
    }

    /// The candidates of the first round, from whole lattices.
    fn explore_first(&mut self, prepared: &[Prepared<'_>]) -> Result<(), Error> {
        let Self { task: SearchTask { shot, settings, .. }, rounds } = self;
        let is_list = rounds.is_list();
        let mut explorer = Explorer { is_list, ..Explorer::new(*shot) };
        let simulations = (settings.exploring * rounds.size as f64) as u64;
        rounds.lines = explore(&mut explorer, prepared, &rounds.openings, simulations)?;
        let room = (rounds.size / PER_CANDIDATE[0]).min(MOST_NEW);
        rounds.candidates = select(explorer.found, settings, room as usize, is_list);
        rounds.spent.simulations += explorer.bench.plays;
        Ok(())
    }

    /// The candidates of a further round: the best so far, the same moved uphill, and new ones near them, on the
    /// known lines and in any direction.
    fn explore_further(&mut self, prepared: &[Prepared<'_>]) -> Result<(), Error> {
        let Self { task: SearchTask { shot, settings, .. }, rounds } = self;
        let is_list = rounds.is_list();
        if is_list {
            distinct_first(&mut rounds.candidates);
        }
        // A list needs a candidate of every aim, and as many that may overtake its worst plays.
        rounds.candidates.truncate(KEPT.max(2 * rounds.stated));
        let mut explorer = Explorer { is_list, measures_windows: true, ..Explorer::new(*shot) };
        if settings.shift {
            shift(&mut rounds.candidates, shot, prepared, explorer.speeds());
        }
        let all = settings.refining * rounds.size as f64;
        explorer.untried_pots(prepared, &mut rounds.lines, (UNTRIED * all) as u64)?;
        let played = explorer.bench.plays;
        let rest = all - played as f64;
        let until = played + (NEAR * rest) as u64;
        let round = rounds.races - 1;
        explorer.refine(prepared, &mut rounds.lines, &rounds.candidates, round, until)?;
        let until = explorer.bench.plays + (FURTHER[usize::from(is_list)] * rest) as u64;
        let first = rounds.strikes;
        rounds.strikes = explorer.more_pots(prepared, &mut rounds.lines, first, until)?;
        let best = rounds.candidates.first().map_or(0.0, Candidate::mean);
        if best < CERTAIN && !shot.frame().is_opening() {
            rounds.strikes = explorer.more_hits(prepared, rounds.strikes, all as u64)?;
        }
        let room = (rounds.size / PER_CANDIDATE[1]).clamp(KEPT as u64, MOST_NEW);
        rounds.candidates.extend(best_of(explorer.found, room as usize, is_list));
        rounds.spent.simulations += explorer.bench.plays;
        Ok(())
    }

    /// Races the candidates with `left` simulations, of which the replies of the finalists get their share.
    fn race_candidates(&mut self, prepared: &[Prepared<'_>], left: u64) -> Result<(), Error> {
        let settings = self.task.settings;
        let mut candidates = core::mem::take(&mut self.rounds.candidates);
        let race = self.race(prepared);
        let share = (settings.replying * self.rounds.size as f64) as u64;
        let replies = Replies::within(share, settings);
        let cost = replies.as_ref().map_or(0, Replies::cost);
        let mut plays = race.run(&mut candidates, left.saturating_sub(cost))?;
        if let Some(replies) = replies {
            plays += replies.search(&race, &mut candidates)?;
        }
        self.rounds.candidates = candidates;
        self.rounds.spent.simulations += plays;
        Ok(())
    }

    /// Looks once at what fouls are worth, when a play that lives on them comes first.
    fn doubt_fouls(&mut self, prepared: &[Prepared<'_>]) -> Result<(), Error> {
        let Self { task, rounds } = self;
        if rounds.foul_correction.is_none() {
            let spent = rounds.spent.simulations;
            let found = task.doubt_fouls(prepared, &mut rounds.candidates, spent)?;
            if let Some((correction, cost)) = found {
                rounds.foul_correction = Some(correction);
                rounds.spent.simulations += cost;
            }
        }
        Ok(())
    }

    /// Counts a round that was to end after `planned` simulations in all, and plans the next one.
    fn end_round(&mut self, planned: u64) {
        let Self { task: SearchTask { shot, settings, .. }, rounds } = self;
        rounds.spent.rounds += 1;
        rounds.races += 1;
        let left = rounds.racing.saturating_sub(rounds.spent.simulations);
        // Further rounds would change a break that is to be the same in every rack.
        let is_fixed = settings.break_shot != BreakChoice::Searched && shot.frame().is_opening();
        rounds.is_complete = planned >= rounds.racing || left == 0 || is_fixed;
        rounds.size = round_size((GROWTH * rounds.size as f64) as u64, left);
    }

    /// Prepares the candidates for a list of plays: each play occurs once, and has the kind of what it does.
    ///
    /// # Errors
    /// As [`Self::play_round`].
    pub(super) fn name_plays(&mut self) -> Result<(), Error> {
        let mut candidates = core::mem::take(&mut self.rounds.candidates);
        let mut plays: Vec<Play> = Vec::new();
        candidates.retain(|candidate| {
            let is_new = !plays.contains(&candidate.play);
            plays.push(candidate.play);
            is_new
        });
        let prepared = self.prepared()?;
        let stated = self.rounds.stated;
        if self.rounds.is_list() {
            distinct_first(&mut candidates);
            // Races have dropped some of these aims early, with few samples.
            let compared = candidates.len().min(2 * stated);
            let least = (self.rounds.fresh as f64 * COMPARED) as u64;
            let plays = self.race(&prepared).fill(&mut candidates[..compared], least)?;
            self.rounds.spent.simulations += plays;
        }
        candidates.truncate(stated + KEPT);
        let mut explorer = Explorer::new(self.task.shot);
        for candidate in &mut candidates {
            let place = candidate.place;
            explorer.name(candidate, &prepared[place])?;
        }
        self.rounds.spent.simulations += explorer.bench.plays;
        self.rounds.candidates = candidates;
        Ok(())
    }

    /// What the rounds have found. A foul on purpose is looked at again, and the best plays get fresh samples.
    ///
    /// # Errors
    /// As [`Self::play_round`].
    pub(crate) fn found(&mut self) -> Result<Found, Error> {
        let prepared = self.prepared()?;
        self.doubt_fouls(&prepared)?;
        let mut candidates = core::mem::take(&mut self.rounds.candidates);
        let Rounds { mut spent, stated, mut fresh, .. } = self.rounds;
        if !self.rounds.is_complete {
            // The clock is over, or the rounds: the statement costs its share of what they have spent.
            fresh = fresh.min(SearchSettings::fresh(spent.simulations, stated));
        }
        if self.rounds.is_list() {
            distinct_first(&mut candidates);
        }
        let stated = stated.min(candidates.len());
        spent.simulations += self.race(&prepared).freshen(&mut candidates[..stated], fresh)?;
        Ok(Found { candidates, spent })
    }
}

/// By how much the first round is larger than that of a usual shot.
fn first_factor(shot: &ShotTask<'_>) -> u64 {
    let (frame, turn) = (shot.frame(), shot.turn);
    match turn.hand {
        _ if frame.is_opening() || frame.facts().is_carom() => OPENING,
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

/// Finds candidates with about `simulations` simulations. Returns the lines of pots.
fn explore(
    explorer: &mut Explorer<'_>,
    prepared: &[Prepared<'_>],
    openings: &[BreakShot],
    simulations: u64,
) -> Result<Vec<KnownLine>, Error> {
    explorer.openings(openings, prepared)?;
    let has_pots = !explorer.task.frame().facts().is_carom();
    let pots = (POTS * simulations as f64) as u64;
    let mut lines = Vec::new();
    for at in cue_places(prepared).filter(|_| openings.is_empty()) {
        if has_pots {
            let mut known = explorer.lines(at);
            let until = pots * (at.number as u64 + 1) / prepared.len() as u64;
            explorer.pots(at.prepared, &mut known, until)?;
            lines.extend(known);
        } else {
            explorer.caroms(at, simulations)?;
        }
    }
    let mut until = simulations.max(explorer.bench.plays + simulations / 4);
    let best = explorer.found.iter().map(|candidate| candidate.prior).fold(0.0, f64::max);
    if let Some(first) = cue_places(prepared).next() {
        if openings.is_empty() && has_pots && best < CERTAIN {
            explorer.safeties(first, until)?;
        }
        if explorer.task.turn.calls.push_out {
            until += ANYTHING / 2;
            explorer.push_outs(first, until)?;
        }
        if explorer.found.is_empty() {
            explorer.anything(first, explorer.bench.plays + ANYTHING)?;
        }
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_at_the_head_of_the_search_has_the_budgets_of_all_stages() {
        let page = include_str!("mod.rs");
        let SearchSettings { exploring, refining, racing, first_round, .. } =
            SearchSettings::default();
        for budget in [
            format!("S = {first_round}, × {MORE_PLAYS} in hand or with push-outs, × {OPENING} for"),
            format!("at least R/{FIRST_SHARE}, up to {MOST_FIRST}"),
            format!("explore: {exploring} S\n"),
            format!("pots       {POTS} of it"),
            format!("unless a pot is worth {CERTAIN} "),
            format!(
                "{} more where they are allowed; any shot at all: {ANYTHING} more",
                ANYTHING / 2
            ),
            format!("select: the best {racing}, or S/{}", PER_CANDIDATE[0]),
            format!("the best {KEPT}\n"),
            format!("{GROWTH} times as many"),
            format!("explore: {refining} S."),
            format!("untried    {UNTRIED} of it"),
            format!("near       {NEAR} of the rest"),
            format!("further    {} of the rest, {} for a list", FURTHER[0], FURTHER[1]),
            format!("new ones, S/{} but at least {KEPT}", PER_CANDIDATE[1]),
        ] {
            assert!(page.contains(&budget), "{budget}");
        }
    }
}
