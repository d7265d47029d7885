//! The pots of a position: for every ball, pocket and kind of line the strikes that most probably make it.
//!
//! Each line that geometry finds is aimed by simulation with the strikes of a lattice. Of those that pot the ball
//! without errors, a race with evenly spread errors keeps the most probable ones. Their chances are then counted with
//! drawn errors that took no part in the choice.

use core::ops::Range;
use std::collections::BTreeMap;

use carom::Error;
use carom::noise::Errors;
use carom::runner::Runner;
use carom::table::PocketName;
use carom_plan::{Chance, Prepared};
use carom_rules::{BallIndex, Play, through_degrees};

use super::candidate::{Candidate, PlayKind, PlayedLeg};
use super::even_errors::EvenErrors;
use super::explore::{CuePlace, Explorer, cue_places};
use super::task::ShotTask;
use crate::line::LineKind;
use crate::player::Situation;
use crate::value::Logistic;
use crate::workbench::Workbench;

/// Samples of every strike in the two heats of the race. The better quarter is in the second one.
const HEATS: [u64; 2] = [16, 48];
/// Share of the strikes that enter the second heat, and their least number.
const SECOND: (usize, usize) = (4, 3);

/// A play that pots a ball without errors, and its chance with them.
#[derive(Clone, Debug, PartialEq)]
pub struct PotPlay {
    /// The play, as it is intended.
    pub play: Play,
    /// What it does without errors: [`PlayKind::Pot`], or [`PlayKind::Indirect`].
    pub kind: PlayKind,
    /// The balls on the way to the pocket, first the cue ball, and the cushions that each meets
    /// without errors; empty for an indirect pot.
    pub legs: Vec<PlayedLeg>,
    /// The ball that falls.
    pub ball: BallIndex,
    /// The pocket into which it falls.
    pub pocket: PocketName,
    /// The chance that it falls there in a legal shot.
    pub made: Chance,
}

/// Which pots are listed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PotList {
    /// Where the cue ball in hand is placed (file coordinates, m); `None` for places from which balls can
    /// be potted, and for a cue ball that is played where it lies.
    pub cue_ball: Option<[f64; 2]>,
    /// Number of strikes for each ball, pocket and kind of line.
    pub each: usize,
    /// Number of drawn errors behind each chance.
    pub samples: u64,
}

impl PotList {
    /// The pots that the situation's player can play, the most probable first. Games without pockets have
    /// none. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame does not ask for a shot, for a place of the cue ball that is not
    /// allowed, and for a noise out of range; [`Error::TooManyEvents`] as a simulated shot.
    pub fn find(&self, situation: &Situation<'_>, runner: &Runner) -> Result<Vec<PotPlay>, Error> {
        let value = Logistic;
        let task = ShotTask::new(situation, &value)?;
        let places: Vec<_> = match (task.turn.hand, self.cue_ball) {
            (Some(region), None) => task.places(region).into_iter().map(Some).collect(),
            (_, place) => vec![place],
        };
        let prepared = places.into_iter().map(|place| Prepared::new(task.frame(), place));
        let prepared = prepared.collect::<Result<Vec<_>, _>>()?;
        let found = runner.map(cue_places(&prepared), || (), |(), at| explored(task, at));
        let found = found.into_iter().collect::<Result<Vec<_>, _>>()?.concat();
        let race = PotRace { task, prepared: &prepared, runner };
        let kept = race.most_probable(found, self.each)?;
        let listed = runner.map(
            kept,
            || Explorer::new(task),
            |explorer, candidate| self.stated(explorer, &prepared, candidate),
        );
        let listed = listed.into_iter().filter_map(Result::transpose);
        let mut listed = listed.collect::<Result<Vec<PotPlay>, _>>()?;
        listed.sort_by_key(|pot| core::cmp::Reverse(pot.made.met));
        Ok(listed)
    }

    /// The play with its chance and what it does without errors; `None` if it does not pot its ball.
    fn stated(
        &self,
        explorer: &mut Explorer<'_>,
        prepared: &[Prepared<'_>],
        mut candidate: Candidate,
    ) -> Result<Option<PotPlay>, Error> {
        let (meant, at) = (candidate.pot, &prepared[candidate.place]);
        explorer.name(&mut candidate, at)?;
        let Candidate { play, kind, legs, pot, .. } = candidate;
        let Some((ball, pocket)) = pot.filter(|_| pot == meant) else { return Ok(None) };
        // The frame's own shot of the play, so that its evaluation counts the same variants.
        let of_play = Prepared::of_play(explorer.task.frame(), &play)?;
        let pot = MeantPlay { prepared: &of_play, play: &play, pot: (ball, pocket) };
        let errors = errors_of(explorer.task);
        let met = pot.count(&mut explorer.bench, &errors, 0..self.samples, None)?;
        let made = Chance { met, variants: self.samples };
        Ok(Some(PotPlay { play, kind, legs, ball, pocket, made }))
    }
}

/// The strikes that pot a ball from one place of the cue ball.
fn explored(task: ShotTask<'_>, at: CuePlace<'_>) -> Result<Vec<Candidate>, Error> {
    let mut explorer = Explorer { is_list: true, ..Explorer::new(task) };
    let mut lines = explorer.all_lines(at);
    explorer.coarse_lattices(at.prepared, &mut lines)?;
    Ok(explorer.found)
}

/// The errors with which the player executes a play.
fn errors_of(task: ShotTask<'_>) -> Errors {
    let Situation { perception, seed, .. } = task.situation;
    Errors { noise: task.noise().clone(), perception: perception.clone(), seed: *seed }
}

/// A play that is meant to pot a ball.
struct MeantPlay<'a> {
    prepared: &'a Prepared<'a>,
    play: &'a Play,
    pot: (BallIndex, PocketName),
}

impl MeantPlay<'_> {
    /// Number of variants in which the ball falls into the pocket in a legal shot: of drawn errors, or of
    /// those of `even`. A variant that cannot be played pots nothing.
    fn count(
        &self,
        bench: &mut Workbench,
        errors: &Errors,
        variants: Range<u64>,
        even: Option<&EvenErrors>,
    ) -> Result<u64, Error> {
        let Workbench { sampler, successor, .. } = bench;
        // A frame's shot has its angles in this form.
        let (struck, meant) = (self.prepared.struck_ball(), through_degrees(&self.play.strike));
        let mut met = 0;
        for index in variants {
            let executed = match even {
                Some(even) => errors.noise.apply(&meant, &struck, even.deviates(index)),
                None => errors.noise.draw(&meant, &struck, errors.seed, index),
            };
            match sampler.simulate_executed(self.prepared, &executed, errors, index) {
                Ok(()) => {}
                Err(Error::Input(_)) => continue,
                Err(error) => return Err(error),
            }
            if sampler.outcome().pocketed.contains(&self.pot) {
                let ruling = sampler.rule(self.prepared, self.play.call, successor)?;
                met += u64::from(ruling.is_legal());
            }
        }
        Ok(met)
    }
}

/// The race between the strikes of each pot.
#[derive(Clone, Copy)]
struct PotRace<'a> {
    task: ShotTask<'a>,
    prepared: &'a [Prepared<'a>],
    runner: &'a Runner,
}

impl PotRace<'_> {
    /// The `each` most probable candidates of every ball, pocket and kind of line.
    fn most_probable(&self, found: Vec<Candidate>, each: usize) -> Result<Vec<Candidate>, Error> {
        let mut aims: BTreeMap<(BallIndex, usize, LineKind), Vec<Candidate>> = BTreeMap::new();
        for candidate in found {
            let Some(line) = &candidate.line else { continue };
            let aim = (line.object, line.pocket, line.kind);
            aims.entry(aim).or_default().push(candidate);
        }
        let mut rated: Vec<Vec<(u64, Candidate)>> =
            aims.into_values().map(|all| all.into_iter().map(|one| (0, one)).collect()).collect();
        let (share, least) = SECOND;
        let mut first = 0;
        for samples in HEATS {
            rated = self.heat(rated, first..first + samples)?;
            first += samples;
            for aim in &mut rated {
                aim.sort_by_key(|(met, _)| core::cmp::Reverse(*met));
                aim.truncate(aim.len().div_ceil(share).max(least).max(each));
            }
        }
        let best = rated.into_iter().flat_map(|aim| aim.into_iter().take(each));
        Ok(best.map(|(_, candidate)| candidate).collect())
    }

    /// Adds the counts of these variants to all candidates.
    fn heat(
        &self,
        rated: Vec<Vec<(u64, Candidate)>>,
        variants: Range<u64>,
    ) -> Result<Vec<Vec<(u64, Candidate)>>, Error> {
        let errors = errors_of(self.task);
        let even = EvenErrors::new(errors.seed);
        let counted = self.runner.map(
            rated,
            || Workbench::new(self.task.frame()),
            |bench, mut aim| {
                for (met, candidate) in &mut aim {
                    let Some(pot) = candidate.pot else { continue };
                    let prepared = &self.prepared[candidate.place];
                    let meant = MeantPlay { prepared, play: &candidate.play, pot };
                    *met += meant.count(bench, &errors, variants.clone(), Some(&even))?;
                }
                Ok(aim)
            },
        );
        counted.into_iter().collect()
    }
}
