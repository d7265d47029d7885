//! The results of a strike that a player intends but does not hit exactly.
//!
//! Variants of the strike are drawn as described in [`carom::noise`] and simulated in rounds of
//! [`VARIANTS_PER_ROUND`]. After every round the results may be precise enough to stop. Rounds do
//! not depend on the number of threads, so the results do not either.
//!
//! Stopping as soon as an interval is short enough makes its true confidence level slightly lower
//! than asked for, since the width itself is estimated. With rounds of a thousand variants this
//! effect is smaller than the difference between two seeds.

use core::ops::Range;
use std::sync::Arc;

use carom::batch::{self, BatchResult, OFF_TABLE};
use carom::device::Device;
use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Shot};

use crate::drawn_tables::DrawnTables;
use crate::error_model::{Chance, ChanceByTable, ErrorModel};
use crate::interval::Interval;
use crate::moments::Moments;
use crate::part_size::PartSize;
use crate::progress::Progress;
use crate::referee::{Referee, Refereed, VariantRuling};

/// Variants between two checks of the precision: some milliseconds of work.
pub const VARIANTS_PER_ROUND: u64 = 1024;
/// Largest number of variants. Each stores the cue ball's final position, 16 bytes. Intervals of a
/// billion variants are already far shorter than needed.
pub const MOST_VARIANTS: u64 = 1_000_000_000;

/// A question about the strike of a shot.
#[derive(Clone, Debug, Default)]
pub struct Question<'a> {
    /// The errors of the player, the number of variants and the precision.
    pub model: ErrorModel,
    /// The tables on which the variants are played.
    pub tables: DrawnTables,
    /// The probability whose precision ends the evaluation early.
    pub watched: Watched,
    /// The game that decides whether a variant is legal.
    pub referee: Option<Referee<'a>>,
    /// Number of threads; one per core if None.
    pub threads: Option<usize>,
    /// The device that plays the variants. A referee needs the events of a shot, which it does not give.
    pub device: Option<Arc<dyn Device>>,
}

/// The probabilities whose precision ends an evaluation early.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Watched {
    /// All probabilities that are counted.
    #[default]
    Everything,
    /// This ball falls.
    Ball(usize),
    /// This ball falls into that pocket.
    Pocket(usize, usize),
    /// The cue ball falls.
    Scratch,
    /// The shot is legal; the question needs a referee.
    Legal,
}

impl Watched {
    /// The probability called `name`: that the ball of `shot` with this id falls (into `pocket`,
    /// if one is given), or `scratch` or `legal`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such ball or pocket.
    pub fn read(shot: &Shot, name: &str, pocket: Option<&str>) -> Result<Self, Error> {
        let Some(ball) = shot.ball_index(name) else {
            return match (name, pocket) {
                ("scratch", None) => Ok(Self::Scratch),
                ("legal", None) => Ok(Self::Legal),
                _ => {
                    let ids: Vec<_> = shot.balls().iter().map(|b| b.id.as_str()).collect();
                    let remedy = format!("write scratch, legal or one of {}", ids.join(", "));
                    Err(ErrorKind::UnknownBall
                        .at("watch", format!("there is no ball \"{name}\""), remedy)
                        .with("ball", name))
                }
            };
        };
        let Some(pocket) = pocket else { return Ok(Self::Ball(ball)) };
        let pockets = &shot.table().pockets;
        let index = pockets.iter().position(|p| p.name.name() == pocket);
        index.map(|index| Self::Pocket(ball, index)).ok_or_else(|| {
            let names: Vec<_> = pockets.iter().map(|p| p.name.name()).collect();
            let remedy = format!("write one of {}", names.join(", "));
            ErrorKind::UnknownName
                .at("watch", format!("there is no pocket \"{pocket}\""), remedy)
                .with("name", pocket)
        })
    }
}

/// The results of a shot's variants.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// The numbers of all variants.
    pub counts: ResultCounts,
    /// Those on each drawn table; empty if nothing about the table is unknown.
    pub by_table: Vec<ResultCounts>,
    /// The error of the first variant that could not be played.
    pub first_failure: Option<Error>,
    /// Index of the cue ball.
    pub cue_ball: usize,
    /// Mean (m) and covariance (m²) of each ball's place of rest on the table, in the file's
    /// coordinates.
    pub ends: Vec<Moments>,
    /// Where the cue ball came to rest in each variant, m; NaN where it did not stay on the table.
    pub cue_ball_ends: Vec<[f64; 2]>,
    /// Confidence level of all intervals.
    pub level: f64,
}

/// How often variants had each result.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultCounts {
    /// Number of variants.
    pub variants: u64,
    /// Number of variants that could not be played, such as miscues. They count as variants in
    /// which no ball falls.
    pub failed: u64,
    /// Number of pockets.
    pub pockets: usize,
    /// Number of variants in which each ball fell into each pocket: row by ball, column by pocket.
    pub potted: Vec<u64>,
    /// Number of variants in which each ball left the table.
    pub off_table: Vec<u64>,
    /// Number of legal variants; None without a referee.
    pub legal: Option<u64>,
    /// Number of variants after which the same player has the turn again or has won; None without
    /// a referee.
    pub turn_kept: Option<u64>,
}

/// Plays variants of `shot`'s strike. If `progress` is stopped, the result holds the variants
/// played so far.
///
/// # Errors [`Error::Input`] if the shot has no strike, for what [`ErrorModel::check`] rejects,
/// for a watched ball or pocket that does not exist, for [`DrawnTables::check`], and if the referee's
/// frame does not ask for this shot. A variant that cannot be played is not an error: it is counted.
pub fn evaluate(
    shot: &Shot,
    question: &Question<'_>,
    progress: &Progress,
) -> Result<Evaluation, Error> {
    check(shot, question)?;
    let Question { model, tables, watched, .. } = question;
    let refereed =
        question.referee.map(|referee| Refereed::new(shot, referee, model.errors())).transpose()?;
    let runner = Runner::new(question.threads)?;
    let runner = match &question.device {
        Some(device) => runner.on(device.clone()),
        None => runner,
    };
    let round = model.half_width.map_or(u64::MAX, |_| VARIANTS_PER_ROUND);
    let mut part = PartSize::new(runner.threads());
    let mut evaluation = Evaluation::empty(shot, question);
    progress.begin(0, model.variants as usize);
    while evaluation.counts.variants < model.variants && !progress.is_stopped() {
        let first = evaluation.counts.variants;
        let round_left = model.variants.min(round - first % round + first) - first;
        let most = part.variants();
        let count = most.min(usize::try_from(round_left).unwrap_or(most));
        evaluation.reserve(count)?;
        part.play(|| {
            if let Some(refereed) = &refereed {
                let (ends, verdicts) = refereed.simulate(first, count, tables, &runner);
                evaluation.count(&ends, &verdicts, tables);
            } else {
                let ends = simulate(shot, question, first..first + count as u64, &runner)?;
                evaluation.count(&ends, &[], tables);
            }
            Ok::<(), Error>(())
        })?;
        progress.add(count);
        let played = evaluation.counts.variants;
        let ends_round = played.is_multiple_of(round) || played == model.variants;
        if ends_round && model.are_precise(evaluation.watched(*watched)) {
            break;
        }
    }
    Ok(evaluation)
}

/// Plays these `variants`, with the strikes that [`batch::draw_strikes`] draws.
fn simulate(
    shot: &Shot,
    Question { model, tables, .. }: &Question<'_>,
    variants: Range<u64>,
    runner: &Runner,
) -> Result<BatchResult, Error> {
    let first = variants.start;
    let strikes = draw(shot, model, variants, runner);
    let (shots, errors) = (tables.shots(shot), model.errors());
    batch::simulate_variants_in_turn(shots, &strikes, &errors, first, runner)
}

fn draw(shot: &Shot, model: &ErrorModel, variants: Range<u64>, runner: &Runner) -> Vec<Strike> {
    let Some((ball, meant)) = shot.strike() else { return Vec::new() };
    let struck = StruckBall::of(shot, &shot.balls()[ball].ball);
    let end = variants.end;
    let chunks = variants.step_by(DRAWN).map(|start| start..end.min(start + DRAWN as u64));
    let drawn = runner.map(
        chunks,
        || (),
        |(), chunk| {
            let strike = |k| model.noise.draw(&meant, &struck, model.seed, k);
            chunk.map(strike).collect::<Vec<_>>()
        },
    );
    drawn.into_iter().flatten().collect()
}

/// Number of strikes that one thread draws at a time: a few tens of microseconds of work.
const DRAWN: usize = 128;

fn check(shot: &Shot, question: &Question<'_>) -> Result<(), Error> {
    let refuse = |kind: ErrorKind, place: &str, what: String, remedy: &str| {
        Err(kind.at(place, what, remedy))
    };
    if shot.strike().is_none() {
        return refuse(
            ErrorKind::NoStrike,
            "strike",
            "the shot has no strike to vary".into(),
            "give it one",
        );
    }
    question.model.check()?;
    question.tables.check(shot)?;
    if question.model.variants > MOST_VARIANTS {
        let what = format!("{} is out of range", question.model.variants);
        return refuse(ErrorKind::OutOfRange, "n", what, &format!("give at most {MOST_VARIANTS}"));
    }
    let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
    match question.watched {
        Watched::Ball(ball) | Watched::Pocket(ball, _) if ball >= balls => refuse(
            ErrorKind::UnknownBall,
            "watch",
            format!("there is no ball {ball}"),
            "count the balls from 0",
        ),
        Watched::Pocket(_, pocket) if pocket >= pockets => refuse(
            ErrorKind::UnknownName,
            "watch",
            format!("there is no pocket {pocket}"),
            "count the pockets from 0",
        ),
        _ if question.referee.is_some() && question.device.is_some() => refuse(
            ErrorKind::Unsupported,
            "device",
            "a device does not rule on shots".into(),
            "leave the frame out, or use device \"cpu\"",
        ),
        Watched::Legal if question.referee.is_none() => refuse(
            ErrorKind::Missing,
            "watch",
            "the legality of a shot needs a frame".into(),
            "give the frame in which the shot is played",
        ),
        _ => Ok(()),
    }
}

impl Evaluation {
    fn empty(shot: &Shot, question: &Question<'_>) -> Self {
        let counts = ResultCounts::empty(shot, question.referee.is_some());
        let tables = question.tables.count();
        Self {
            by_table: if tables > 1 { vec![counts.clone(); tables] } else { Vec::new() },
            counts,
            first_failure: None,
            cue_ball: shot.cue_ball().unwrap_or_default(),
            ends: vec![Moments::default(); shot.balls().len()],
            cue_ball_ends: Vec::new(),
            level: question.model.level,
        }
    }

    /// Counts the variants that follow those counted so far; without a referee there are no
    /// `verdicts`.
    fn count(&mut self, round: &BatchResult, verdicts: &[VariantRuling], tables: &DrawnTables) {
        let first = self.counts.variants;
        let rows = round.pocket.chunks(round.balls).zip(round.final_position.chunks(round.balls));
        for (k, (pockets, places)) in rows.enumerate() {
            self.each_count(tables.index(first + k as u64), |c| c.add(pockets, verdicts.get(k)));
            let mut cue_ball_end = [f64::NAN; 2];
            for (ball, [x, y, _]) in places.iter().enumerate() {
                if pockets[ball] == batch::ON_TABLE {
                    self.ends[ball].add([*x, *y]);
                    if ball == self.cue_ball {
                        cue_ball_end = [*x, *y];
                    }
                }
            }
            self.cue_ball_ends.push(cue_ball_end);
        }
        for (k, _) in &round.errors {
            self.each_count(tables.index(first + *k as u64), |counts| counts.failed += 1);
        }
        if self.first_failure.is_none() {
            self.first_failure = round.errors.first().map(|(_, error)| error.clone());
        }
    }

    /// Changes the numbers of all variants and those on this table.
    fn each_count(&mut self, table: usize, change: impl Fn(&mut ResultCounts)) {
        change(&mut self.counts);
        self.by_table.get_mut(table).map(change);
    }

    /// Makes room for `count` more variants.
    fn reserve(&mut self, count: usize) -> Result<(), Error> {
        self.cue_ball_ends.try_reserve(count).map_err(|_| {
            let what = format!("no memory for more than {} variants", self.counts.variants);
            ErrorKind::System.at("n", what, "give fewer, or a precision")
        })
    }

    /// The watched probability, or all.
    fn watched(&self, watched: Watched) -> Vec<ChanceByTable> {
        let (all, cue_ball) = (&self.counts, self.cue_ball);
        let of = |count: &dyn Fn(&ResultCounts) -> u64| self.chance(count);
        match watched {
            Watched::Ball(ball) => vec![of(&|c| c.falls(ball))],
            Watched::Pocket(ball, pocket) => vec![of(&|c| c.falls_into(ball, pocket))],
            Watched::Scratch => vec![of(&|c| c.falls(cue_ball))],
            Watched::Legal => vec![of(&|c| c.legal.unwrap_or(0))],
            Watched::Everything => {
                let cells = (0..all.potted.len()).map(|k| of(&|c| c.potted[k]));
                let balls = 0..all.off_table.len();
                let falls = balls.clone().map(|ball| of(&|c| c.falls(ball)));
                let gone = balls.map(|ball| of(&|c| c.off_table[ball]));
                let ruled = all.legal.into_iter().flat_map(|_| {
                    [of(&|c| c.legal.unwrap_or(0)), of(&|c| c.turn_kept.unwrap_or(0))]
                });
                cells.chain(falls).chain(gone).chain(ruled).collect()
            }
        }
    }

    /// The probability of the result that `count` reads, on each table.
    pub fn chance(&self, count: impl Fn(&ResultCounts) -> u64) -> ChanceByTable {
        let of = |counts: &ResultCounts| Chance { met: count(counts), variants: counts.variants };
        if self.by_table.is_empty() {
            return ChanceByTable(vec![of(&self.counts)]);
        }
        ChanceByTable(self.by_table.iter().map(of).collect())
    }

    /// The confidence interval of the result that `count` reads.
    pub fn interval(&self, count: impl Fn(&ResultCounts) -> u64) -> Interval {
        self.chance(count).interval(self.level)
    }
}

impl ResultCounts {
    fn empty(shot: &Shot, ruled: bool) -> Self {
        let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
        Self {
            variants: 0,
            failed: 0,
            pockets,
            potted: vec![0; balls * pockets],
            off_table: vec![0; balls],
            legal: ruled.then_some(0),
            turn_kept: ruled.then_some(0),
        }
    }

    /// Adds a variant, whose balls ended in these `pockets`.
    fn add(&mut self, pockets: &[i8], verdict: Option<&VariantRuling>) {
        self.variants += 1;
        for (ball, pocket) in pockets.iter().enumerate() {
            match *pocket {
                OFF_TABLE => self.off_table[ball] += 1,
                pocket if pocket >= 0 => self.potted[ball * self.pockets + pocket as usize] += 1,
                _ => (),
            }
        }
        if let Some(verdict) = verdict {
            self.legal = self.legal.map(|count| count + u64::from(verdict.legal));
            self.turn_kept = self.turn_kept.map(|count| count + u64::from(verdict.turn_kept));
        }
    }

    /// Number of variants in which ball `ball` fell.
    pub fn falls(&self, ball: usize) -> u64 {
        self.potted[ball * self.pockets..][..self.pockets].iter().sum()
    }

    /// Number of variants in which ball `ball` fell into pocket `pocket`.
    pub fn falls_into(&self, ball: usize, pocket: usize) -> u64 {
        self.potted[ball * self.pockets + pocket]
    }
}
