//! `_core.Frame`.

use std::sync::{Mutex, PoisonError};

use carom::Error;
use carom::format::Node;
use carom::shot::{Cling, StrikePolicy};
use carom_mind::Answer;
use carom_rules::{BallIndex, Call, Choice, ErrorSeeds, Game, Options, Play, Ruling};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::node::{from_python, to_python};
use crate::options::NoiseOptions;
use crate::shot::{Shot, StrikeArguments, strike_or_default};
use crate::trace::Trace;

/// `carom.call.PlayArguments`, read by attribute.
#[derive(FromPyObject)]
pub(crate) struct PlayArguments {
    strike: StrikeArguments,
    /// `obstruction` and `miscue`.
    policy: (String, String),
    cue_ball: Option<[f64; 2]>,
    /// Kind, ball, pocket.
    call: (String, Option<String>, Option<String>),
    /// As in a shot file.
    cling: Option<Py<PyAny>>,
}

/// Speed, azimuth, elevation, side, height.
type Strike = (f64, f64, f64, f64, f64);
/// A ruling, the trace of the shot, and the strike and the cling of the play.
type Played<'py> = (Bound<'py, PyAny>, Trace, Strike, Option<Bound<'py, PyAny>>);

/// One seed for the frame, or one for each seat.
#[derive(FromPyObject)]
pub(crate) enum SeedArguments {
    Frame(u64),
    Seats([u64; 2]),
}

impl From<SeedArguments> for ErrorSeeds {
    fn from(seeds: SeedArguments) -> Self {
        match seeds {
            SeedArguments::Frame(seed) => Self::Frame(seed),
            SeedArguments::Seats(seeds) => Self::Seats(seeds),
        }
    }
}

/// Kind, ball and pocket of a call.
pub(crate) type CallFields = (&'static str, Option<String>, Option<&'static str>);

pub(crate) fn call_fields(frame: &carom_rules::Frame, call: Call) -> CallFields {
    let id = |ball: BallIndex| Some(frame.layout().balls()[usize::from(ball)].id.clone());
    match call {
        Call::Nothing => ("nothing", None, None),
        Call::Safety => ("safety", None, None),
        Call::PushOut => ("push-out", None, None),
        Call::On(ball) => ("on", id(ball), None),
        Call::Pocket(ball, pocket) => ("pocket", id(ball), Some(pocket.name())),
    }
}

fn optional(value: &Bound<'_, PyAny>) -> PyResult<Option<Node>> {
    if value.is_none() { Ok(None) } else { from_python(value).map(Some) }
}

/// The play of `arguments` in `frame`.
fn read_play(
    frame: &carom_rules::Frame,
    arguments: PlayArguments,
    cling: Option<&Node>,
) -> Result<Play, Error> {
    let PlayArguments { strike, policy, cue_ball, call: (kind, ball, pocket), .. } = arguments;
    let (strike, has_elevation) = strike_or_default(strike);
    let call = frame.call(&kind, ball.as_deref(), pocket.as_deref())?;
    let policy = StrikePolicy::from_names(&policy.0, &policy.1)?;
    let cling = cling.map_or(Ok(Cling::NONE), Cling::from_node)?;
    let play = Play { strike, cue_ball, call, policy, cling };
    if has_elevation { Ok(play) } else { frame.at_default_elevation(&play) }
}

/// A player's answer to the request of a frame, as `carom.player.situation.answer_arguments` returns it.
#[derive(FromPyObject)]
pub(crate) enum AnswerArguments {
    /// The name of a choice, or `concede`.
    Word(String),
    Play(PlayArguments),
}

impl AnswerArguments {
    /// The answer in `frame`, which may refuse it.
    pub(crate) fn read(self, frame: &carom_rules::Frame) -> Result<Answer, Error> {
        match self {
            Self::Word(word) if word == CONCEDE => Ok(Answer::Concede),
            Self::Word(word) => Choice::read(&word).map(Answer::Choice),
            Self::Play(arguments) => read_play(frame, arguments, None).map(Answer::Play),
        }
    }

    /// The answer, if `frame` allows it.
    pub(crate) fn allowed(self, frame: &carom_rules::Frame) -> Result<Answer, Error> {
        let answer = self.read(frame)?;
        carom_arena::check_answer(frame, &answer)?;
        Ok(answer)
    }
}

/// The word with which a player gives up the frame.
const CONCEDE: &str = "concede";

/// Checks the keys of a frame's record and the types of its parts.
#[pyfunction]
pub(crate) fn check_record(record: &Bound<'_, PyAny>) -> PyResult<()> {
    let node = from_python(record)?;
    carom_rules::check_record(&node).map_err(|error| to_exception(record.py(), &error))
}

/// A game in progress.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Frame(Mutex<carom_rules::Frame>);

impl From<carom_rules::Frame> for Frame {
    fn from(frame: carom_rules::Frame) -> Self {
        Self(Mutex::new(frame))
    }
}

impl Frame {
    /// What `use_it` returns. It must not run Python's code: meanwhile another thread could use the frame.
    fn with<T>(&self, use_it: impl FnOnce(&mut carom_rules::Frame) -> T) -> T {
        use_it(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// A copy of the frame.
    pub(crate) fn get(&self) -> carom_rules::Frame {
        self.with(|frame| frame.clone())
    }

    /// The play of `arguments` in this frame.
    pub(crate) fn play_of(&self, py: Python<'_>, arguments: PlayArguments) -> PyResult<Play> {
        let cling = match &arguments.cling {
            Some(cling) => Some(from_python(cling.bind(py))?),
            None => None,
        };
        read_play(&self.get(), arguments, cling.as_ref()).map_err(|e| to_exception(py, &e))
    }

    /// What was played, the ruling and the trace.
    fn play_noisy(
        &self,
        meant: &Play,
        noise: Option<NoiseOptions>,
        seeds: ErrorSeeds,
    ) -> Result<(Play, Ruling, carom::Trace), Error> {
        self.with(|frame| {
            let play = match noise {
                Some(noise) => frame.draw_play(meant, &noise.noise(), seeds)?,
                None => *meant,
            };
            let trace = frame.shot(&play)?.simulate()?;
            let ruling = frame.apply(&play, &trace)?;
            Ok((play, ruling, trace))
        })
    }
}

#[pymethods]
impl Frame {
    #[new]
    fn new(
        game: &str,
        table: &Bound<'_, PyAny>,
        physics: &Bound<'_, PyAny>,
        seed: u64,
        options: (i32, bool, u32),
    ) -> PyResult<Self> {
        let py = table.py();
        let (points, miss, patience) = options;
        let game = Game::read(game).map_err(|e| to_exception(py, &e))?;
        let options = Options { points, miss, patience };
        carom_rules::Frame::new(game, options, optional(table)?, optional(physics)?, seed)
            .map(Self::from)
            .map_err(|e| to_exception(py, &e))
    }

    /// Table and physics as the record of a new frame keeps them, with dated names.
    #[staticmethod]
    fn recorded_setup<'py>(
        game: &str,
        table: &Bound<'py, PyAny>,
        physics: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = table.py();
        let game = Game::read(game).map_err(|e| to_exception(py, &e))?;
        let setup = carom_rules::recorded_setup(game, optional(table)?, optional(physics)?);
        to_python(py, &setup)
    }

    /// A frame that continues from the balls of a shot.
    #[staticmethod]
    fn of_shot(
        py: Python<'_>,
        game: &str,
        shot: &Shot,
        options: (i32, bool, u32),
        player: Option<usize>,
    ) -> PyResult<Self> {
        let (points, miss, patience) = options;
        let options = Options { points, miss, patience };
        let frame = Game::read(game)
            .and_then(|game| carom_rules::Frame::of_shot(game, options, &shot.0, player));
        frame.map(Self::from).map_err(|e| to_exception(py, &e))
    }

    fn to_object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.get().to_node())
    }

    /// The value under a key of `to_object`.
    fn entry<'py>(&self, py: Python<'py>, key: &str) -> PyResult<Bound<'py, PyAny>> {
        let value = self.get().entry(key);
        to_python(py, &value.ok_or_else(|| PyKeyError::new_err(key.to_owned()))?)
    }

    /// Table and physics, as a shot file has them.
    fn base<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.get().base().to_node())
    }

    /// The frame as text.
    fn describe(&self) -> String {
        self.get().describe()
    }

    /// The JSON Schema of an answer to the request.
    fn answer_schema<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.get().answer_schema())
    }

    /// The calls that the frame allows: kind, ball, pocket.
    fn legal_calls(&self) -> Vec<CallFields> {
        let frame = self.get();
        frame.legal_calls().into_iter().map(|call| call_fields(&frame, call)).collect()
    }

    /// At most `count` places at which the cue ball in hand may stand, m.
    fn legal_places(&self, py: Python<'_>, count: usize, seed: u64) -> Vec<[f64; 2]> {
        let frame = self.get();
        py.detach(|| frame.legal_places(count, seed))
    }

    /// Lower left and upper right corner of the box in which the cue ball may be placed, m.
    #[getter]
    fn hand_bounds(&self) -> Option<[[f64; 2]; 2]> {
        self.get().hand_bounds()
    }

    fn shot(&self, py: Python<'_>, play: PlayArguments) -> PyResult<Shot> {
        let play = self.play_of(py, play)?;
        self.get().shot(&play).map(Shot::from).map_err(|e| to_exception(py, &e))
    }

    /// Plays a shot, with the errors of `noise` if there is one: of the frame's or the seats' `seeds`.
    fn play<'py>(
        &self,
        py: Python<'py>,
        play: PlayArguments,
        noise: Option<NoiseOptions>,
        seeds: SeedArguments,
    ) -> PyResult<Played<'py>> {
        let meant = self.play_of(py, play)?;
        let (play, ruling, trace) =
            self.play_noisy(&meant, noise, seeds.into()).map_err(|e| to_exception(py, &e))?;
        let Play { strike: s, cling, .. } = play;
        let strike = (s.speed, s.azimuth, s.elevation, s.side, s.height);
        let cling = (!cling.is_empty()).then(|| to_python(py, &cling.to_node())).transpose()?;
        let ruling = to_python(py, &self.get().ruling_node(&ruling))?;
        Ok((ruling, Trace::from(trace), strike, cling))
    }

    fn choose<'py>(&self, py: Python<'py>, choice: &str) -> PyResult<Bound<'py, PyAny>> {
        let chosen =
            Choice::read(choice).and_then(|choice| self.with(|frame| frame.choose(choice)));
        let ruling = chosen.map_err(|e| to_exception(py, &e))?;
        to_python(py, &self.get().ruling_node(&ruling))
    }

    fn concede<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let ruling = self.with(carom_rules::Frame::concede).map_err(|e| to_exception(py, &e))?;
        to_python(py, &self.get().ruling_node(&ruling))
    }

    fn copy(&self) -> Self {
        self.get().into()
    }

    /// 16 hex digits over the whole state.
    #[getter]
    fn hash(&self) -> String {
        format!("{:016x}", self.with(|frame| frame.hash()))
    }
}
