//! `_core.Player`: decisions and analyses of the built-in players.

use std::sync::atomic::{AtomicU64, Ordering};

use carom::Error;
use carom::runner::Runner;
use carom_arena::{BuiltInPlayer, ThinkingTime};
use carom_mind::{Analysis, Answer, Budget, Decision, Recommendation, Situation, Spent};
use carom_plan::Moments;
use carom_rules::{Frame as Game, Play};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::PlainNode;
use crate::options::{NoiseOptions, PerceptionOptions, count, numbers_of};
use crate::progress::{self, Interrupt};
use crate::rules::{CallFields, Frame, call_fields};

/// `carom.player.thinking.Thinking`, read by attribute.
#[derive(FromPyObject)]
pub(crate) struct ThinkingOptions {
    noise: NoiseOptions,
    opponent_noise: NoiseOptions,
    perception: PerceptionOptions,
    seed: u64,
    simulations: u64,
    rounds: Option<u32>,
    time: Option<f64>,
}

impl ThinkingOptions {
    /// What the player who is asked in `frame` knows.
    fn situation<'a>(&self, frame: &'a Game) -> Situation<'a> {
        let mut noise = [self.noise.noise(), self.opponent_noise.noise()];
        if frame.player() == Some(1) {
            noise.reverse();
        }
        Situation { frame, noise, perception: self.perception.perception(), seed: self.seed }
    }
}

/// A play; a dict in Python. `strike`: speed, azimuth, elevation, side, height. `call`: kind, ball,
/// pocket.
#[derive(IntoPyObject)]
pub(crate) struct PlayFields {
    strike: [f64; 5],
    cue_ball: Option<[f64; 2]>,
    call: CallFields,
}

impl PlayFields {
    pub(crate) fn new(frame: &Game, play: &Play) -> Self {
        let call = call_fields(frame, play.call);
        Self { call, ..Self::uncalled(play) }
    }

    /// The fields of a play in a task without a referee.
    pub(crate) fn uncalled(play: &Play) -> Self {
        let s = &play.strike;
        let strike = [s.speed, s.azimuth, s.elevation, s.side, s.height];
        Self { strike, cue_ball: play.cue_ball, call: ("nothing", None, None) }
    }
}

pub(crate) fn id(frame: &Game, ball: carom_rules::BallIndex) -> String {
    frame.layout().balls()[usize::from(ball)].id.clone()
}

/// A decision; a dict in Python. Without play and choice it is a concession.
#[derive(IntoPyObject)]
pub(crate) struct DecisionFields {
    play: Option<PlayFields>,
    choice: Option<&'static str>,
    win_chance: Option<f64>,
    simulations: u64,
    rounds: u32,
    interrupted: bool,
}

/// One of the recommended plays; a dict in Python. `legs`: the balls on the way to the pocket, each
/// with its number of cushions. Chances are counted: (met, of).
#[derive(IntoPyObject)]
struct RecommendationFields {
    play: PlayFields,
    kind: &'static str,
    legs: Vec<(String, u8)>,
    route: Option<PlainNode>,
    pot: Option<(String, &'static str)>,
    win: f64,
    error: f64,
    kept: (u64, u64),
    foul: (u64, u64),
    win_if_kept: Option<f64>,
    win_if_missed: Option<f64>,
    leave: LeaveFields,
}

/// Where the cue ball comes to rest: mean (m) and covariance (m²).
#[derive(IntoPyObject)]
struct LeaveFields {
    count: u64,
    mean: [f64; 2],
    covariance: [[f64; 2]; 2],
}

impl From<&Moments> for LeaveFields {
    fn from(moments: &Moments) -> Self {
        let [xx, xy, yy] = moments.covariance();
        let (count, mean) = (moments.count(), moments.mean());
        Self { count, mean, covariance: [[xx, xy], [xy, yy]] }
    }
}

impl RecommendationFields {
    fn new(frame: &Game, found: &Recommendation) -> Self {
        Self {
            play: PlayFields::new(frame, &found.play),
            kind: found.kind.name(),
            legs: found.legs.iter().map(|leg| (id(frame, leg.0), leg.1)).collect(),
            route: found.route.as_ref().map(|route| {
                // In games of carom the shot has all balls of the frame.
                let id = |ball| frame.layout().balls()[usize::from(ball)].id.as_str();
                PlainNode(route.to_node(id))
            }),
            pot: found.pot.map(|(ball, pocket)| (id(frame, ball), pocket.name())),
            win: found.win,
            error: found.error,
            kept: (found.kept.met, found.kept.variants),
            foul: (found.foul.met, found.foul.variants),
            win_if_kept: found.win_if_kept,
            win_if_missed: found.win_if_missed,
            leave: LeaveFields::from(&found.leave),
        }
    }
}

/// An analysis; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct AnalysisFields {
    plays: Vec<RecommendationFields>,
    simulations: u64,
    rounds: u32,
    interrupted: bool,
}

/// A built-in player.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Player {
    of: BuiltInPlayer,
    /// Number of calls of `stop`. Every decision in progress ends when it changes.
    stops: AtomicU64,
}

#[pymethods]
impl Player {
    #[new]
    fn new(py: Python<'_>, name: &str) -> PyResult<Self> {
        let of = BuiltInPlayer::read(name).map_err(|e| to_exception(py, &e))?;
        Ok(Self { of, stops: AtomicU64::new(0) })
    }

    #[getter]
    fn name(&self) -> &'static str {
        self.of.name()
    }

    /// The fields of `carom.Noise`, in order, of a level of strength.
    #[getter]
    fn noise(&self) -> Option<[f64; 7]> {
        self.of.noise().map(|noise| numbers_of(&noise))
    }

    /// The simulated shots that the name gives.
    #[getter]
    fn simulations(&self) -> Option<u32> {
        self.of.simulations()
    }

    /// Ends the decisions in progress after their present rounds. Other threads call it.
    fn stop(&self) {
        self.stops.fetch_add(1, Ordering::Relaxed);
    }

    fn choose(
        &self,
        py: Python<'_>,
        frame: PyRef<'_, Frame>,
        thinking: ThinkingOptions,
        threads: usize,
    ) -> PyResult<DecisionFields> {
        let frame = frame.get();
        let decide = |budget: &Budget<'_>| -> Result<Decision, Error> {
            self.of.check_budget(budget)?;
            self.of.make()?.decide(&thinking.situation(&frame), budget)
        };
        let (decision, interrupted) = self.think(py, &thinking, threads, decide)?;
        let Decision { answer, win_chance, spent: Spent { simulations, rounds } } = decision;
        let (play, choice) = match answer {
            Answer::Play(play) => (Some(PlayFields::new(&frame, &play)), None),
            Answer::Choice(choice) => (None, Some(choice.name())),
            Answer::Concede => (None, None),
        };
        Ok(DecisionFields { play, choice, win_chance, simulations, rounds, interrupted })
    }

    /// The best plays with their chances, at most `plays` of them.
    fn explain(
        &self,
        py: Python<'_>,
        frame: PyRef<'_, Frame>,
        thinking: ThinkingOptions,
        plays: usize,
        threads: usize,
    ) -> PyResult<AnalysisFields> {
        let frame = frame.get();
        let analyse = |budget: &Budget<'_>| -> Result<Analysis, Error> {
            self.of.searcher()?.analyse(&thinking.situation(&frame), budget, plays)
        };
        let (analysis, interrupted) = self.think(py, &thinking, threads, analyse)?;
        let Analysis { plays, spent: Spent { simulations, rounds } } = analysis;
        let plays = plays.iter().map(|found| RecommendationFields::new(&frame, found)).collect();
        Ok(AnalysisFields { plays, simulations, rounds, interrupted })
    }
}

impl Player {
    /// The result of `search` within the budget, and whether Ctrl-C or `stop` ended it.
    fn think<T: Send>(
        &self,
        py: Python<'_>,
        thinking: &ThinkingOptions,
        threads: usize,
        search: impl FnOnce(&Budget<'_>) -> Result<T, Error> + Send,
    ) -> PyResult<(T, bool)> {
        let runner = Runner::new(count(threads)).map_err(|e| to_exception(py, &e))?;
        let stops = self.stops.load(Ordering::Relaxed);
        let interrupt = Interrupt::default();
        let is_stopped = || interrupt.is_asked() || self.stops.load(Ordering::Relaxed) != stops;
        let time = thinking.time.map(ThinkingTime::begin);
        let is_over = |_: Spent| is_stopped() || time.as_ref().is_some_and(ThinkingTime::is_over);
        let ThinkingOptions { simulations, rounds, .. } = *thinking;
        let budget = Budget { simulations, rounds, is_over: &is_over, runner };
        let found = progress::until_interrupted(py, &interrupt, || search(&budget))?;
        Ok((found, is_stopped()))
    }
}

/// The names of the built-in players.
#[pyfunction]
pub(crate) fn players() -> Vec<&'static str> {
    BuiltInPlayer::names().collect()
}
