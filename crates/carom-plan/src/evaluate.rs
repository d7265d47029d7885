//! What comes of a strike that a player means but does not hit exactly.
//!
//! Variants of the strike are drawn as [`carom::noise`] says and simulated in rounds of [`ROUND`]; after
//! every round what is known may be precise enough to stop. Rounds do not depend on the number of
//! threads, so neither does the answer.
//!
//! Stopping as soon as an interval is short enough makes its true level a little lower than the one asked
//! for, since the width is itself estimated. With rounds of a thousand variants that is less than what a
//! seed changes.

use carom::batch::{self, BatchResult, OFF_TABLE, PADDING};
use carom::noise::Perception;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, Noise, Shot};
use rayon::prelude::*;

use crate::errs::{check_half_width, check_level};
use crate::interval::{Interval, wilson};
use crate::moments::Moments;
use crate::referee::{Referee, Refereed, Verdicts};
use crate::threads::Threads;

/// Variants between two looks at the precision: a few milliseconds of work.
pub const ROUND: usize = 1024;
/// Rounds at once where nobody looks: the threads wait less often for each other.
const UNWATCHED: usize = 4;
/// Strikes that one thread draws at a time, some tens of microseconds of work.
const DRAWN: usize = 128;

/// What is asked about a shot.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// How far the strike strays.
    pub noise: Noise,
    /// How far from where they are seen the balls truly lie. The shot is what the player sees and plans
    /// on; every variant has a layout of its own around it. The tip meets the cue ball where that truly is:
    /// errors of the contact point are the noise's.
    pub perception: Perception,
    /// Which random numbers.
    pub seed: u64,
    /// Variants to play, at most.
    pub most: usize,
    /// Confidence of all intervals, in (0, 1).
    pub level: f64,
    /// When to stop before that.
    pub precision: Option<Precision>,
    /// Who says whether a variant was legal.
    pub referee: Option<Referee<'a>>,
    /// How many threads; all cores if none.
    pub threads: Option<usize>,
}

/// How precisely something is to be known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// Half the width of the interval, a probability.
    pub half_width: f64,
    /// Of what.
    pub watched: Watched,
}

/// A probability that can be watched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// All that there are.
    Everything,
    /// This ball falls.
    Ball(usize),
    /// This ball falls into that pocket.
    Pocket(usize, usize),
    /// The cue ball falls.
    Scratch,
    /// The shot is legal: the question needs a referee.
    Legal,
}

impl Watched {
    /// What `name` says about `shot`: a ball's id, into `pocket` if one is named, or else `scratch` or
    /// `legal`.
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
                    Err(Error::input("watch", format!("there is no ball \"{name}\""), remedy))
                }
            };
        };
        let Some(pocket) = pocket else { return Ok(Self::Ball(ball)) };
        let pockets = &shot.table().pockets;
        let index = pockets.iter().position(|p| p.name.name() == pocket);
        index.map(|index| Self::Pocket(ball, index)).ok_or_else(|| {
            let names: Vec<_> = pockets.iter().map(|p| p.name.name()).collect();
            let remedy = format!("write one of {}", names.join(", "));
            Error::input("watch", format!("there is no pocket \"{pocket}\""), remedy)
        })
    }
}

/// What came of a shot's variants.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Variants played.
    pub variants: u64,
    /// Of these, how many could not be played: miscues, a cue that passes through a ball. They count as
    /// variants in which nothing falls.
    pub failed: u64,
    /// Why the first of them could not.
    pub first_failure: Option<Error>,
    /// Index of the cue ball.
    pub cue_ball: usize,
    /// Number of pockets.
    pub pockets: usize,
    /// How often each ball fell into each pocket: row by ball, column by pocket.
    pub potted: Vec<u64>,
    /// How often each ball left the table.
    pub off_table: Vec<u64>,
    /// How often the shot was legal, with a referee.
    pub legal: Option<u64>,
    /// How often it is the same player's turn again, or they have won, with a referee.
    pub turn_kept: Option<u64>,
    /// Where each ball came to rest on the table, m, in the file's frame.
    pub ends: Vec<Moments>,
    /// Where the cue ball came to rest in each variant, m; NaN where it did not.
    pub cue_ball_ends: Vec<[f64; 2]>,
    /// Confidence of all intervals.
    pub level: f64,
}

/// Plays variants of `shot`'s strike. `progress` is told after every round how many have been played, and
/// says whether to go on.
///
/// # Errors
/// [`Error::Input`] if the shot has no strike, for what [`Noise::check`] and [`Perception::check`] refuse, for a
/// level or a half-width out of range, for something watched that does not exist, and if the referee's frame
/// does not ask for this shot. A variant that cannot be played is no error: it is counted.
pub fn evaluate(
    shot: &Shot,
    question: &Question<'_>,
    progress: &mut dyn FnMut(u64) -> bool,
) -> Result<Evaluation, Error> {
    check(shot, question)?;
    let refereed = question.referee.map(|referee| Refereed::new(shot, referee)).transpose()?;
    let threads = Threads::new(question.threads);
    let round = if question.precision.is_some() { ROUND } else { UNWATCHED * ROUND };
    let mut evaluation = Evaluation::nothing_yet(shot, question);
    while (evaluation.variants as usize) < question.most {
        let first = evaluation.variants;
        let count = round.min(question.most - first as usize);
        let strikes = threads.run(|| drawn(shot, question, first, count));
        if let Some(refereed) = &refereed {
            let Question { perception, seed, .. } = question;
            let (ends, verdicts) = refereed.simulate(&strikes, perception, *seed, first, &threads);
            evaluation.count(&ends);
            evaluation.rule(verdicts);
        } else {
            let ends = threads.run(|| unrefereed(shot, &strikes, question, first))?;
            evaluation.count(&ends);
        }
        let precise = question.precision.is_some_and(|p| evaluation.is_precise(&p));
        if !progress(evaluation.variants) || precise {
            break;
        }
    }
    Ok(evaluation)
}

/// The strikes of variants `first`.., as [`batch::draw_strikes`] has them.
fn drawn(shot: &Shot, question: &Question<'_>, first: u64, count: usize) -> Vec<Strike> {
    let Some((ball, meant)) = shot.strike() else { return Vec::new() };
    let radius = shot.balls()[ball].ball.radius;
    let strikes = (0..count).into_par_iter().with_min_len(DRAWN);
    strikes.map(|k| question.noise.draw(&meant, radius, question.seed, first + k as u64)).collect()
}

fn unrefereed(
    shot: &Shot,
    strikes: &[Strike],
    question: &Question<'_>,
    first: u64,
) -> Result<BatchResult, Error> {
    let Question { perception, seed, .. } = question;
    if perception.position == 0.0 {
        return Ok(batch::simulate_strikes(shot, strikes, &Runner::default()));
    }
    batch::simulate_seen(shot, strikes, perception, *seed, first, &Runner::default())
}

fn check(shot: &Shot, question: &Question<'_>) -> Result<(), Error> {
    question.noise.check()?;
    question.perception.check()?;
    let refuse = |place: &str, what: String, remedy: &str| Err(Error::input(place, what, remedy));
    if shot.strike().is_none() {
        return refuse("strike", "the shot has no strike to vary".into(), "give it one");
    }
    check_level(question.level)?;
    let Some(Precision { half_width, watched }) = question.precision else { return Ok(()) };
    check_half_width(half_width)?;
    let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
    match watched {
        Watched::Ball(ball) | Watched::Pocket(ball, _) if ball >= balls => {
            refuse("watch", format!("there is no ball {ball}"), "count the balls from 0")
        }
        Watched::Pocket(_, pocket) if pocket >= pockets => {
            refuse("watch", format!("there is no pocket {pocket}"), "count the pockets from 0")
        }
        Watched::Legal if question.referee.is_none() => refuse(
            "watch",
            "nobody says what is legal".into(),
            "give the frame in which the shot is played",
        ),
        _ => Ok(()),
    }
}

impl Evaluation {
    fn nothing_yet(shot: &Shot, question: &Question<'_>) -> Self {
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
            cue_ball_ends: Vec::with_capacity(question.most.min(ROUND)),
            level: question.level,
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

    fn is_precise(&self, wanted: &Precision) -> bool {
        let mut counts: Vec<u64> = Vec::new();
        match wanted.watched {
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
        counts.iter().all(|&count| self.interval(count).half_width() <= wanted.half_width)
    }

    /// How often ball `ball` fell.
    pub fn falls(&self, ball: usize) -> u64 {
        self.potted[ball * self.pockets..][..self.pockets].iter().sum()
    }

    /// How often ball `ball` fell into pocket `pocket`.
    pub fn falls_into(&self, ball: usize, pocket: usize) -> u64 {
        self.potted[ball * self.pockets + pocket]
    }

    /// The confidence interval of something that happened `count` times.
    pub fn interval(&self, count: u64) -> Interval {
        wilson(count, self.variants, self.level)
    }
}
