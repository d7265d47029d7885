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
use carom::simulate::{SMALL, Simulation};
use carom::{Error, Noise, Shot};
use carom_rules::{Call, Frame, Play, Request};
use rayon::prelude::*;

use crate::interval::{Interval, wilson};
use crate::moments::Moments;

/// Variants between two looks at the precision: a few milliseconds of work.
pub const ROUND: usize = 1024;

/// What is asked about a shot.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// How far the strike strays.
    pub noise: Noise,
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

/// A game in which the shot is played.
#[derive(Clone, Copy, Debug)]
pub struct Referee<'a> {
    /// The frame; it asks for the shot.
    pub frame: &'a Frame,
    /// What the player announces.
    pub call: Call,
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
/// [`Error::Input`] if the shot has no strike, for a noise that [`Noise::check`] refuses, for a level or a
/// half-width out of range, for something watched that does not exist, and if the referee's frame does not
/// ask for this shot. A variant that cannot be played is no error: it is counted.
pub fn evaluate(
    shot: &Shot,
    question: &Question<'_>,
    progress: &mut dyn FnMut(u64) -> bool,
) -> Result<Evaluation, Error> {
    check(shot, question)?;
    let place = question.referee.map(|referee| place_of_cue_ball(shot, &referee)).transpose()?;
    let mut evaluation = Evaluation::nothing_yet(shot, question);
    while (evaluation.variants as usize) < question.most {
        let first = evaluation.variants;
        let count = ROUND.min(question.most - first as usize);
        let strikes = batch::draw_strikes(shot, &question.noise, question.seed, first, count)?;
        let ends = batch::simulate_strikes(shot, &strikes, question.threads, &|_| ());
        evaluation.count(&ends);
        if let (Some(referee), Some(place)) = (&question.referee, place) {
            let plays: Vec<Play> = strikes
                .into_iter()
                .map(|strike| Play { strike, cue_ball: place, call: referee.call })
                .collect();
            evaluation.rule(referee.frame, &plays, question.threads);
        }
        let precise = question.precision.is_some_and(|p| evaluation.is_precise(&p));
        if !progress(evaluation.variants) || precise {
            break;
        }
    }
    Ok(evaluation)
}

fn check(shot: &Shot, question: &Question<'_>) -> Result<(), Error> {
    question.noise.check()?;
    let refuse = |place: &str, what: String, remedy: &str| Err(Error::input(place, what, remedy));
    if shot.strike().is_none() {
        return refuse("strike", "the shot has none that could be varied".into(), "give it one");
    }
    if !(question.level > 0.0 && question.level < 1.0) {
        let what = format!("{:?} is no confidence level", question.level);
        return refuse("level", what, "give a number between 0 and 1, such as 0.95");
    }
    let Some(Precision { half_width, watched }) = question.precision else { return Ok(()) };
    if !(half_width > 0.0 && half_width < 0.5) {
        let what = format!("{half_width:?} is no half-width of a probability's interval");
        return refuse("precision", what, "give a number between 0 and 0.5, such as 0.01");
    }
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

/// Where the player puts the cue ball, if it is in hand.
fn place_of_cue_ball(shot: &Shot, referee: &Referee<'_>) -> Result<Option<[f64; 2]>, Error> {
    let Some((cue_ball, strike)) = shot.strike() else { return Ok(None) };
    let lies = shot.balls()[cue_ball].state.position;
    let in_hand = referee.frame.turn().is_some_and(|turn| turn.hand.is_some());
    let place = in_hand.then_some([lies.x, lies.y]);
    let asked = referee.frame.shot(&Play { strike, cue_ball: place, call: referee.call })?;
    // The strike's angles may differ by the rounding of degrees.
    if asked.balls() != shot.balls()
        || asked.table() != shot.table()
        || asked.physics() != shot.physics()
    {
        return Err(Error::input(
            "frame",
            "it asks for a shot with other balls, table or physics",
            "evaluate the shot that the frame gives: frame.shot(...)",
        ));
    }
    Ok(place)
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

    fn rule(&mut self, frame: &Frame, plays: &[Play], threads: Option<usize>) {
        let verdicts = || -> (u64, u64) {
            plays
                .par_iter()
                .map_init(
                    || Box::new(Simulation::<SMALL>::new()),
                    |simulation, play| verdict(frame.clone(), simulation, play),
                )
                .reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1))
        };
        let (legal, kept) = crate::with_threads(threads, verdicts);
        self.legal = self.legal.map(|count| count + legal);
        self.turn_kept = self.turn_kept.map(|count| count + kept);
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

/// Whether the play is legal, and whether the turn stays; each 0 or 1.
fn verdict(mut frame: Frame, simulation: &mut Simulation<SMALL>, play: &Play) -> (u64, u64) {
    let player = frame.player();
    let Ok((ruling, _)) = frame.play_in(simulation, play) else { return (0, 0) };
    let kept = match frame.request() {
        Request::Shot(turn) => Some(turn.player) == player,
        Request::Choice { .. } => false,
        Request::Over { winner, .. } => winner.is_some() && *winner == player,
    };
    (u64::from(ruling.is_legal()), u64::from(kept))
}
