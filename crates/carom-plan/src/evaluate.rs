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

use carom::batch::{self, BatchResult, OFF_TABLE, PADDING};
use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Shot};

use crate::error_model::ErrorModel;
use crate::interval::{Interval, wilson};
use crate::moments::Moments;
use crate::part_size::PartSize;
use crate::progress::Progress;
use crate::referee::{Referee, Refereed, Verdicts};

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
    /// The probability whose precision ends the evaluation early.
    pub watched: Watched,
    /// The game that decides whether a variant is legal.
    pub referee: Option<Referee<'a>>,
    /// Number of threads; one per core if None.
    pub threads: Option<usize>,
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
    /// Number of variants.
    pub variants: u64,
    /// Number of variants that could not be played, such as miscues. They count as variants in
    /// which no ball falls.
    pub failed: u64,
    /// The error of the first of them.
    pub first_failure: Option<Error>,
    /// Index of the cue ball.
    pub cue_ball: usize,
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
    /// Mean (m) and covariance (m²) of each ball's place of rest on the table, in the file's
    /// coordinates.
    pub ends: Vec<Moments>,
    /// Where the cue ball came to rest in each variant, m; NaN where it did not stay on the table.
    pub cue_ball_ends: Vec<[f64; 2]>,
    /// Confidence level of all intervals.
    pub level: f64,
}

/// Plays variants of `shot`'s strike. If `progress` is stopped, the result holds the variants
/// played so far.
///
/// # Errors [`Error::Input`] if the shot has no strike, for what [`ErrorModel::check`] rejects,
/// for a watched ball or pocket that does not exist, and if the referee's frame does not ask for
/// this shot. A variant that cannot be played is not an error: it is counted.
pub fn evaluate(
    shot: &Shot,
    question: &Question<'_>,
    progress: &Progress,
) -> Result<Evaluation, Error> {
    check(shot, question)?;
    let Question { model, watched, .. } = question;
    let refereed =
        question.referee.map(|referee| Refereed::new(shot, referee, model.errors())).transpose()?;
    let runner = Runner::new(question.threads)?;
    let round = model.half_width.map_or(u64::MAX, |_| VARIANTS_PER_ROUND);
    let mut part = PartSize::new(runner.threads());
    let mut evaluation = Evaluation::empty(shot, question);
    progress.begin(0, model.variants as usize);
    while evaluation.variants < model.variants && !progress.is_stopped() {
        let first = evaluation.variants;
        let round_left = model.variants.min(round - first % round + first) - first;
        let most = part.variants();
        let count = most.min(usize::try_from(round_left).unwrap_or(most));
        evaluation.reserve(count)?;
        part.play(|| {
            if let Some(refereed) = &refereed {
                let (ends, verdicts) = refereed.simulate(first, count, &runner);
                evaluation.count(&ends);
                evaluation.rule(verdicts);
            } else {
                evaluation.count(&simulate(shot, model, first..first + count as u64, &runner)?);
            }
            Ok::<(), Error>(())
        })?;
        progress.add(count);
        let ends_round =
            evaluation.variants.is_multiple_of(round) || evaluation.variants == model.variants;
        if ends_round && model.is_precise(evaluation.watched_counts(*watched), evaluation.variants)
        {
            break;
        }
    }
    Ok(evaluation)
}

/// Plays these `variants`, with the strikes that [`batch::draw_strikes`] draws.
fn simulate(
    shot: &Shot,
    model: &ErrorModel,
    variants: Range<u64>,
    runner: &Runner,
) -> Result<BatchResult, Error> {
    let first = variants.start;
    let strikes = draw(shot, model, variants, runner);
    batch::simulate_variants(shot, &strikes, &model.errors(), first, runner)
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
        let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
        let refereed = question.referee.map(|_| 0);
        Self {
            variants: 0,
            failed: 0,
            first_failure: None,
            cue_ball: shot.cue_ball().unwrap_or_default(),
            pockets,
            potted: vec![0; balls * pockets],
            off_table: vec![0; balls],
            legal: refereed,
            turn_kept: refereed,
            ends: vec![Moments::default(); balls],
            cue_ball_ends: Vec::new(),
            level: question.model.level,
        }
    }

    fn count(&mut self, round: &BatchResult) {
        let rows = round.pocket.chunks(round.balls).zip(round.final_position.chunks(round.balls));
        for (pockets, places) in rows {
            let mut cue_ball_end = [f64::NAN; 2];
            for (ball, (pocket, [x, y, _])) in pockets.iter().zip(places).enumerate() {
                match *pocket {
                    OFF_TABLE => self.off_table[ball] += 1,
                    PADDING => (),
                    batch::ON_TABLE => {
                        self.ends[ball].add([*x, *y]);
                        if ball == self.cue_ball {
                            cue_ball_end = [*x, *y];
                        }
                    }
                    pocket => self.potted[ball * self.pockets + pocket as usize] += 1,
                }
            }
            self.cue_ball_ends.push(cue_ball_end);
        }
        self.variants += round.shots as u64;
        self.failed += round.errors.len() as u64;
        if self.first_failure.is_none() {
            self.first_failure = round.errors.first().map(|(_, error)| error.clone());
        }
    }

    fn rule(&mut self, verdicts: Verdicts) {
        self.legal = self.legal.map(|count| count + verdicts.legal);
        self.turn_kept = self.turn_kept.map(|count| count + verdicts.turn_kept);
    }

    /// Makes room for `count` more variants.
    fn reserve(&mut self, count: usize) -> Result<(), Error> {
        self.cue_ball_ends.try_reserve(count).map_err(|_| {
            let what = format!("no memory for more than {} variants", self.variants);
            ErrorKind::System.at("n", what, "give fewer, or a precision")
        })
    }

    /// The counts of the watched probability, or of all.
    fn watched_counts(&self, watched: Watched) -> Vec<u64> {
        let mut counts: Vec<u64> = Vec::new();
        match watched {
            Watched::Ball(ball) => counts.push(self.falls(ball)),
            Watched::Pocket(ball, pocket) => counts.push(self.falls_into(ball, pocket)),
            Watched::Scratch => counts.push(self.falls(self.cue_ball)),
            Watched::Legal => counts.extend(self.legal),
            Watched::Everything => {
                counts.extend_from_slice(&self.potted);
                counts.extend((0..self.off_table.len()).map(|ball| self.falls(ball)));
                counts.extend_from_slice(&self.off_table);
                counts.extend(self.legal.into_iter().chain(self.turn_kept));
            }
        }
        counts
    }

    /// Number of variants in which ball `ball` fell.
    pub fn falls(&self, ball: usize) -> u64 {
        self.potted[ball * self.pockets..][..self.pockets].iter().sum()
    }

    /// Number of variants in which ball `ball` fell into pocket `pocket`.
    pub fn falls_into(&self, ball: usize, pocket: usize) -> u64 {
        self.potted[ball * self.pockets + pocket]
    }

    /// The confidence interval of a result that occurred in `count` variants.
    pub fn interval(&self, count: u64) -> Interval {
        wilson(count, self.variants, self.level)
    }
}
