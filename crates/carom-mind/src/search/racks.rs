//! Breaks of many racks.

use carom::noise::{Errors, Perception};
use carom::runner::Runner;
use carom::{Error, ErrorKind, Noise};
use carom_rules::{Frame, OpeningKind, Request, Seat, Turn};

use super::replies::quick_value;
use crate::breaks::{BreakCounts, BreakShot};
use crate::player::Situation;
use crate::value::{Position, Value};
use crate::workbench::Workbench;
use carom_plan::Prepared;

/// The breaker's seat in a new frame.
const BREAKER: Seat = 0;
/// Racks that one thread plays at a time: about two milliseconds of work.
const CHUNK: u64 = 8;
/// Simulations that search the next shot after every foul. Values of positions underrate a cue ball in
/// hand in an intact rack, so a search by the value alone breaks with fouls.
const AFTER_FOUL: u64 = 30;
/// Probability with which the player who breaks a further rack wins, before breaks have been played:
/// where a full break is usual, and where the opening shot is a safety. Estimated.
const REBREAK: f64 = 0.6;
const REBREAK_SAFELY: f64 = 0.42;

/// The racks of a game on a table, broken by a player with its errors. Rack k of a seed is the same for
/// every break, with the same errors, so that breaks are compared on equal terms.
#[derive(Clone)]
pub struct Racks<'a> {
    start: &'a Frame,
    noise: [Noise; 2],
    perception: Perception,
    seed: u64,
    value: &'a dyn Value,
    /// Probability with which the player who breaks a further rack wins, at the scores of the start.
    pub(super) rebreak: f64,
    /// What the value estimates for the start. It does not tell one break from another, but it knows
    /// what points are worth.
    at_start: f64,
    /// Of one in `every` breaks the next shot is searched with `per_reply` simulations; 0 for none.
    every: u64,
    per_reply: u64,
}

/// What a break did.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlayedBreak {
    /// The estimated probability that the breaker wins.
    value: f64,
    /// The same after a search of the next shot, less `value`.
    correction: Option<f64>,
    stratum: Option<usize>,
    fallen: u64,
    is_kept: bool,
    is_foul: bool,
    is_game_ball: bool,
    /// Number of simulations.
    pub(super) plays: u64,
}

impl<'a> Racks<'a> {
    /// The racks of the situation's frame, which must ask for an opening shot.
    ///
    /// # Errors
    /// [`Error::Input`] at `frame` if it asks for anything else, and as [`Situation::asked`].
    pub fn new(situation: &Situation<'a>, value: &'a dyn Value) -> Result<Self, Error> {
        let (seat, _) = situation.asked()?;
        let start = situation.frame;
        if !start.is_opening() {
            let what = "it does not ask for an opening shot";
            return Err(ErrorKind::WrongState.at("frame", what, "give a frame before its break"));
        }
        let noise = [situation.noise[seat].clone(), situation.noise[1 - seat].clone()];
        let (perception, seed) = (situation.perception.clone(), situation.seed);
        let rebreak = match start.facts().opening.kind {
            OpeningKind::Safety => REBREAK_SAFELY,
            OpeningKind::Break | OpeningKind::Carom => REBREAK,
        };
        let fresh = start.with_seed(seed)?;
        let at_start = value.win_chance(&Position { frame: &fresh, noise: &noise }, BREAKER);
        let (every, per_reply) = (0, 0);
        Ok(Self { start, noise, perception, seed, value, rebreak, at_start, every, per_reply })
    }

    /// The same racks; after one in `every` breaks the next shot is searched with about `per_reply`
    /// simulations. 0 for none.
    #[must_use]
    pub fn with_replies(self, every: u64, per_reply: u64) -> Self {
        Self { every, per_reply, ..self }
    }

    /// The frame whose racks are played.
    pub(super) const fn start(&self) -> &'a Frame {
        self.start
    }

    /// The errors of the breaker's strikes.
    pub(super) const fn noise(&self) -> &Noise {
        &self.noise[BREAKER]
    }

    /// Breaks `count` racks with each of `shots`, from rack number `first` on. Returns the counts of
    /// each shot and the number of simulations. They do not depend on the number of threads. A shot
    /// that cannot be played has no breaks.
    ///
    /// The win chances are corrected by the searches of next shots. The corrections of all shots are
    /// pooled, apart for breaks that keep the turn, lose it, and fouls with and without a fallen ball
    /// (poststratification): a value of positions misjudges these cases differently, but hardly one
    /// break and another within a case.
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if a shot does not end.
    pub fn count(
        &self,
        shots: &[BreakShot],
        first: u64,
        count: u64,
        runner: &Runner,
    ) -> Result<(Vec<BreakCounts>, u64), Error> {
        let mut corrections = Corrections::default();
        self.count_with(&mut corrections, shots, first, count, runner)
    }

    /// As [`Self::count`]; adds to the corrections of earlier counts, and uses all of them.
    pub(super) fn count_with(
        &self,
        corrections: &mut Corrections,
        shots: &[BreakShot],
        first: u64,
        count: u64,
        runner: &Runner,
    ) -> Result<(Vec<BreakCounts>, u64), Error> {
        let jobs = (0..shots.len()).flat_map(|k| {
            let starts = (first..first + count).step_by(CHUNK as usize);
            starts.map(move |from| (k, from..(from + CHUNK).min(first + count)))
        });
        let played = runner.map(
            jobs,
            || Workbench::new(self.start),
            |bench, (k, indices)| {
                let number = |rack: u64| k as u64 * count + (rack - first);
                let breaks =
                    indices.filter_map(|i| self.play(&shots[k], i, number(i), bench).transpose());
                Ok((k, breaks.collect::<Result<Vec<_>, Error>>()?))
            },
        );
        let mut tallies = vec![Tally::default(); shots.len()];
        let mut plays = 0;
        for chunk in played {
            let (k, chunk): (usize, Vec<PlayedBreak>) = chunk?;
            for played in &chunk {
                plays += played.plays;
                tallies[k].add(played);
                if let (Some(correction), Some(k)) = (played.correction, played.stratum) {
                    corrections[k].add(correction);
                }
            }
        }
        Ok((tallies.iter().map(|tally| tally.counts(corrections)).collect(), plays))
    }

    /// Breaks rack number `index`, as break number `number` of a count; `None` if the shot cannot be
    /// played.
    fn play(
        &self,
        shot: &BreakShot,
        index: u64,
        number: u64,
        bench: &mut Workbench,
    ) -> Result<Option<PlayedBreak>, Error> {
        let Workbench { sampler, successor, .. } = bench;
        let frame = self.start.with_seed(self.seed.wrapping_add(index))?;
        let place = frame.turn().and_then(|turn| shot.cue_ball(&frame, turn));
        let Ok(prepared) = Prepared::new(&frame, place) else { return Ok(None) };
        let Ok(play) = shot.play_of(&prepared) else { return Ok(None) };
        let noise = self.noise[BREAKER].clone();
        let errors = Errors { noise, perception: self.perception.clone(), seed: self.seed };
        match sampler.simulate_variant(&prepared, &play.strike, &errors, index) {
            Err(Error::Input(_)) => return Ok(None),
            result => result?,
        }
        let Ok(ruling) = sampler.rule(&prepared, play.call, successor) else { return Ok(None) };
        let fallen = || sampler.outcome().pocketed.iter().map(|(ball, _)| *ball);
        let is_game_ball = |ball: u16| frame.facts().deciding_ball == Some(ball);
        let cue = prepared.turn().cue;
        let mut played = PlayedBreak {
            value: 0.0,
            correction: None,
            stratum: None,
            fallen: fallen().filter(|ball| *ball != cue).count() as u64,
            is_kept: successor.keeps_turn(BREAKER),
            is_foul: !ruling.is_legal(),
            is_game_ball: fallen().any(is_game_ball),
            plays: 1,
        };
        let search = if played.is_foul { AFTER_FOUL } else { 0 };
        played.value = self.chance(successor, BREAKER, search, &mut played.plays)?;
        if !successor.is_over() {
            played.stratum = Some(match played {
                PlayedBreak { is_kept: true, .. } => 0,
                PlayedBreak { is_foul: false, .. } => 1,
                PlayedBreak { fallen, .. } => 2 + usize::from(fallen == 0),
            });
        }
        if self.every > 0 && number.is_multiple_of(self.every) {
            let searched = self.chance(successor, BREAKER, self.per_reply, &mut played.plays)?;
            played.correction = Some(searched - played.value);
        }
        Ok(Some(played))
    }

    /// The probability that `seat` wins after a break. The player who has a choice takes the better
    /// option.
    fn chance(
        &self,
        frame: &Frame,
        seat: Seat,
        per_reply: u64,
        plays: &mut u64,
    ) -> Result<f64, Error> {
        let of_player = |player: Seat, value: f64| if player == seat { value } else { 1.0 - value };
        Ok(match frame.request() {
            Request::Over { winner: None, .. } => 0.5,
            Request::Over { winner: Some(winner), .. } => of_player(*winner, 1.0),
            Request::Shot(turn) => {
                of_player(turn.player, self.chance_of_shot(frame, turn, per_reply, plays)?)
            }
            Request::Choice { player, choices, .. } => {
                let mut best: f64 = 0.0;
                for choice in choices {
                    let mut next = frame.clone();
                    next.choose(*choice)?;
                    best = best.max(self.chance(&next, *player, per_reply, plays)?);
                }
                of_player(*player, best)
            }
        })
    }

    /// The probability that the player of `turn` wins.
    fn chance_of_shot(
        &self,
        frame: &Frame,
        turn: &Turn,
        per_reply: u64,
        plays: &mut u64,
    ) -> Result<f64, Error> {
        let estimated = || self.value.of_shot(&Position { frame, noise: &self.noise }, turn);
        if frame.is_opening() {
            return Ok((self.rebreak + estimated() - self.at_start).clamp(0.0, 1.0));
        }
        if per_reply == 0 {
            return Ok(estimated());
        }
        let Self { noise, perception, seed, .. } = self.clone();
        let situation = Situation { frame, noise, perception, seed };
        let (searched, more) = quick_value(&situation, self.value, per_reply)?;
        *plays += more;
        // A short search may find only a poor shot: the estimate is the better bound.
        Ok(if per_reply <= AFTER_FOUL { searched.max(estimated()) } else { searched })
    }
}

/// Number of cases whose corrections are kept apart: see [`Racks::count`].
const STRATA: usize = 4;

/// The corrections of the win chances, by case.
pub(super) type Corrections = [Sum; STRATA];

/// Sums over breaks.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    counts: BreakCounts,
    values: Sum,
    /// Number of breaks of each case.
    strata: [u64; STRATA],
}

/// Sums of numbers and of their squares.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Sum {
    fn add(&mut self, x: f64) {
        self.count += 1.0;
        self.sum += x;
        self.squares += x * x;
    }

    /// 0 without numbers.
    fn mean(&self) -> f64 {
        if self.count > 0.0 { self.sum / self.count } else { 0.0 }
    }

    /// The variance of the mean; 0 for fewer than two numbers.
    fn variance(&self) -> f64 {
        if self.count < 2.0 {
            return 0.0;
        }
        let mean = self.mean();
        let around = (self.squares - self.count * mean * mean).max(0.0);
        around / (self.count - 1.0) / self.count
    }
}

impl Tally {
    fn add(&mut self, played: &PlayedBreak) {
        let counts = &mut self.counts;
        counts.breaks += 1;
        counts.fallen += played.fallen;
        counts.any_fallen += u64::from(played.fallen > 0);
        counts.kept += u64::from(played.is_kept);
        counts.fouls += u64::from(played.is_foul);
        counts.game_ball += u64::from(played.is_game_ball);
        self.values.add(played.value);
        if let Some(k) = played.stratum {
            self.strata[k] += 1;
        }
    }

    fn counts(&self, corrections: &Corrections) -> BreakCounts {
        let (mut win, mut variance) = (self.values.mean(), self.values.variance());
        for (count, correction) in self.strata.iter().zip(corrections) {
            let share = *count as f64 / self.counts.breaks.max(1) as f64;
            win += share * correction.mean();
            variance += share * share * correction.variance();
        }
        BreakCounts { win: win.clamp(0.0, 1.0), error: carom::math::sqrt(variance), ..self.counts }
    }
}
