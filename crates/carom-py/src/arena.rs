//! Matches: `_core.play_match`, `_core.play_pair`, `_core.OpenMatch` and `_core.replay_match`; the interval of
//! pairs that were played elsewhere: `_core.pair_interval` and `_core.adjusted_share`.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use carom::format::{Node, Reader};
use carom::runner::Runner;
use carom_arena::{
    AdjustedPairs, AdjustedShare, ArenaError, BuiltInPlayer, Hypothesis, LuckSettings, MatchPlan,
    MatchReport, MatchScore, PairScores, PlayedPair, PlayerEntry, Replay, Secret, SequentialTest,
    TestState, TestUnit, elo_of_share,
};
use carom_plan::{Interval, Progress, check_level};
use carom_rules::FrameSimulator;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::{arena_exception, to_exception};
use crate::exceptions::CaromError;
use crate::match_player::{Entrant, EntrantArguments, Raised};
use crate::node::{from_python, to_python};
use crate::options::count;
use crate::program::{StopCheck, program_entry};
use crate::progress::{self, Watch};

/// The score of player 0; a dict in Python. Intervals: (low, high).
#[derive(IntoPyObject)]
struct ScoreFields {
    /// Frames lost, drawn and won.
    frames: [u64; 3],
    /// Pairs with 0, ½, 1, 1½ and 2 points.
    pairs: [u64; 5],
    void: u64,
    share: f64,
    share_interval: (f64, f64),
    wins: f64,
    wins_interval: (f64, f64),
    elo: f64,
    elo_interval: (f64, f64),
    nelo: f64,
    nelo_interval: (f64, f64),
    pairing_ratio: Option<f64>,
    reasons: BTreeMap<&'static str, u64>,
    adjusted: Option<AdjustedFields>,
}

/// The share of the points, corrected for luck; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct AdjustedFields {
    pairs: u64,
    share: f64,
    share_interval: (f64, f64),
    weight: f64,
    saved: Option<f64>,
}

impl AdjustedFields {
    fn new(pairs: &AdjustedPairs, level: f64) -> Option<Self> {
        let AdjustedShare { share, interval, weight, saved } = pairs.share(level)?;
        let share_interval = (interval.low, interval.high);
        Some(Self { pairs: pairs.pairs(), share, share_interval, weight, saved })
    }
}

impl ScoreFields {
    fn new(score: &MatchScore, level: f64) -> Self {
        let ends = |i: Interval| (i.low, i.high);
        let (share, interval) = (score.pairs.share(), score.pairs.interval(level));
        let (wins, wins_interval) = score.wins(level);
        Self {
            frames: score.frames,
            pairs: score.pairs.counts,
            void: score.void,
            share,
            share_interval: ends(interval),
            wins,
            wins_interval: ends(wins_interval),
            elo: elo_of_share(share),
            elo_interval: (elo_of_share(interval.low), elo_of_share(interval.high)),
            nelo: score.pairs.normalised_elo(share),
            nelo_interval: (
                score.pairs.normalised_elo(interval.low),
                score.pairs.normalised_elo(interval.high),
            ),
            pairing_ratio: score.pairs.pairing_ratio(score.frames),
            reasons: score.reasons.iter().map(|(reason, n)| (reason.name(), *n)).collect(),
            adjusted: AdjustedFields::new(&score.adjusted, level),
        }
    }
}

/// The state of a sequential test; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct TestFields {
    llr: f64,
    lower: f64,
    upper: f64,
    accepted: Option<&'static str>,
}

impl From<TestState> for TestFields {
    fn from(TestState { llr, lower, upper, accepted }: TestState) -> Self {
        let accepted = accepted.map(|hypothesis| match hypothesis {
            Hypothesis::P0 => "p0",
            Hypothesis::P1 => "p1",
        });
        Self { llr, lower, upper, accepted }
    }
}

/// What a match has come to; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct MatchFields {
    record: Option<PathBuf>,
    played_pairs: u64,
    score: ScoreFields,
    test: Option<TestFields>,
    secret_sha256: String,
}

impl MatchFields {
    fn new(report: MatchReport, level: f64) -> Self {
        let MatchReport { record, score, test, pairs, secret_sha256 } = report;
        let (score, test) = (ScoreFields::new(&score, level), test.map(TestFields::from));
        Self { record, played_pairs: pairs, score, test, secret_sha256 }
    }
}

/// The players of a match and what is agreed, from Python.
struct Setup {
    entrants: [Entrant; 2],
    plan: MatchPlan,
    raised: Raised,
}

impl Setup {
    /// `agreed`: the keys of a record's header without `format`, `engine`, `secret_sha256` and `players`.
    fn read(
        players: [EntrantArguments; 2],
        agreed: &Bound<'_, PyAny>,
        secret: Option<String>,
    ) -> PyResult<Self> {
        let raise = |error| to_exception(agreed.py(), &error);
        let raised = Raised::default();
        let entrants = match players.map(|player| Entrant::read(player, &raised)) {
            [Ok(one), Ok(other)] => [one, other],
            [Err(error), _] | [_, Err(error)] => return Err(raise(error)),
        };
        let mut agreed = from_python(agreed)?;
        agreed.set("players", Node::list(entrants.each_ref().map(Entrant::entry)));
        let secret = secret.map(|digits| Secret::parse(&digits)).transpose().map_err(raise)?;
        let plan = MatchPlan::from_node(&agreed, secret).map_err(raise)?;
        Ok(Self { entrants, plan, raised })
    }

    /// What `play` returns, or the exception of a player. `interrupt` is called again and again after a
    /// stop, until the players have ended. Players in Python and one thread have the calling thread.
    fn run<T: Send>(
        &self,
        report: &Py<PyAny>,
        interrupt: &Py<PyAny>,
        threads: usize,
        play: impl FnOnce(&Progress) -> Result<T, ArenaError> + Send,
    ) -> PyResult<T> {
        let after_stop = || {
            // A failure leaves the players to end by themselves.
            let _ = Python::attach(|py| interrupt.call0(py).map(drop));
        };
        let is_outside = self.entrants.iter().any(Entrant::is_outside);
        let watch =
            if is_outside && threads == 1 { Watch::Here } else { Watch::Beside(&after_stop) };
        Python::attach(|py| {
            let played = progress::run_with(py, report, &watch, |progress| Ok(play(progress)))?;
            match self.raised.take() {
                Some(error) => Err(error),
                None => played.map_err(|error| arena_exception(py, &error)),
            }
        })
    }
}

/// Plays or continues a match in `folder`; see [`Setup`]. `report` is called with 0, pairs done, all pairs.
#[pyfunction]
#[pyo3(signature = (players, agreed, secret, folder, level, threads, report, interrupt))]
#[expect(clippy::too_many_arguments, reason = "Python's side has names for them")]
pub(crate) fn play_match(
    py: Python<'_>,
    players: [EntrantArguments; 2],
    agreed: &Bound<'_, PyAny>,
    secret: Option<String>,
    folder: PathBuf,
    level: f64,
    threads: usize,
    report: Py<PyAny>,
    interrupt: Py<PyAny>,
) -> PyResult<MatchFields> {
    let raise = |error| to_exception(py, &error);
    check_level(level).map_err(raise)?;
    let setup = Setup::read(players, agreed, secret)?;
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let played = setup.run(&report, &interrupt, threads, |progress| {
        let is_stopped: StopCheck<'_> = Arc::new(|| progress.is_stopped());
        let make = |index: usize| setup.entrants[index].make(&is_stopped);
        carom_arena::play_match(&setup.plan, &folder, &make, &runner, progress)
    })?;
    Ok(MatchFields::new(played, level))
}

/// Plays pair `number` of a match on one thread; see [`play_match`]. Returns its two lines of the record.
#[pyfunction]
pub(crate) fn play_pair(
    py: Python<'_>,
    players: [EntrantArguments; 2],
    agreed: &Bound<'_, PyAny>,
    secret: &str,
    number: u64,
    report: Py<PyAny>,
    interrupt: Py<PyAny>,
) -> PyResult<[String; 2]> {
    let secret = Secret::parse(secret).map_err(|error| to_exception(py, &error))?;
    let setup = Setup::read(players, agreed, None)?;
    let played = setup.run(&report, &interrupt, 1, |progress| {
        let is_stopped: StopCheck<'_> = Arc::new(|| progress.is_stopped());
        let make = |index: usize| setup.entrants[index].make(&is_stopped);
        let simulator = &mut FrameSimulator::new();
        let (plan, make) = (&setup.plan, &make);
        Ok(carom_arena::play_pair(plan, &secret, number, make, simulator, progress)?)
    })?;
    // Without an exception only the end of this thread's work stops a pair.
    played.map(|pair| pair.lines().clone()).ok_or_else(|| PyKeyboardInterrupt::new_err(()))
}

/// A match in its folder, whose pairs are played elsewhere.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct OpenMatch(Mutex<Option<carom_arena::OpenMatch>>);

impl OpenMatch {
    /// What `use_it` returns for the match, which is not closed.
    fn with<T>(&self, use_it: impl FnOnce(&mut carom_arena::OpenMatch) -> T) -> PyResult<T> {
        match self.0.lock().unwrap_or_else(PoisonError::into_inner).as_mut() {
            Some(open) => Ok(use_it(open)),
            None => Err(CaromError::new_err("match: it is closed; open it again")),
        }
    }
}

#[pymethods]
impl OpenMatch {
    #[new]
    fn new(
        py: Python<'_>,
        players: [EntrantArguments; 2],
        agreed: &Bound<'_, PyAny>,
        secret: Option<String>,
        folder: PathBuf,
    ) -> PyResult<Self> {
        let setup = Setup::read(players, agreed, secret)?;
        let open = carom_arena::OpenMatch::open(&setup.plan, &folder);
        Ok(Self(Mutex::new(Some(open.map_err(|error| arena_exception(py, &error))?))))
    }

    /// 64 hexadecimal digits.
    #[getter]
    fn secret(&self) -> PyResult<String> {
        self.with(|open| open.secret().to_hex())
    }

    /// Number of pairs that were played.
    #[getter]
    fn played(&self) -> PyResult<u64> {
        self.with(|open| open.played())
    }

    /// The number of the next pair to play; None if no more are needed.
    fn next_pair(&self) -> PyResult<Option<u64>> {
        self.with(carom_arena::OpenMatch::next_pair)
    }

    /// Writes the pair with these lines to the folder.
    fn add(&self, py: Python<'_>, number: u64, lines: [String; 2]) -> PyResult<()> {
        let pair = PlayedPair::read(number, lines).map_err(|error| to_exception(py, &error))?;
        self.with(|open| open.add(&pair))?.map_err(|error| arena_exception(py, &error))
    }

    /// What the match has come to. The folder is free afterwards.
    fn close(&self, py: Python<'_>, level: f64) -> PyResult<MatchFields> {
        check_level(level).map_err(|error| to_exception(py, &error))?;
        let open = self.0.lock().unwrap_or_else(PoisonError::into_inner).take();
        let open = open.ok_or_else(|| CaromError::new_err("match: it is closed; open it again"))?;
        let report = open.close().map_err(|error| arena_exception(py, &error))?;
        Ok(MatchFields::new(report, level))
    }
}

/// The first value that a replay does not reproduce; a dict in Python.
#[derive(IntoPyObject)]
struct DifferenceFields {
    line: u64,
    key: String,
    recorded: String,
    replayed: String,
}

/// What a replay has found; a dict in Python.
#[derive(IntoPyObject)]
pub(crate) struct ReplayFields<'py> {
    header: Bound<'py, PyAny>,
    frames: u64,
    difference: Option<DifferenceFields>,
    other_engine: bool,
    score: ScoreFields,
    with_luck: Option<String>,
}

/// Plays the record `text` of a match again. `luck`: with how many fresh errors of each shot its luck is
/// measured; None if it is not. `report` is called with 0, frames done, all frames.
#[pyfunction]
#[pyo3(signature = (text, luck, level, threads, report))]
pub(crate) fn replay_match<'py>(
    py: Python<'py>,
    text: &str,
    luck: Option<u32>,
    level: f64,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<ReplayFields<'py>> {
    let raise = |error| to_exception(py, &error);
    check_level(level).map_err(raise)?;
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let luck = luck.map(|draws| LuckSettings { draws, ..LuckSettings::default() });
    let found: Replay = progress::run(py, &report, |progress| match luck {
        Some(luck) => carom_arena::measure_luck(text, luck, &runner, progress),
        None => carom_arena::replay(text, &runner, progress),
    })?;
    let other_engine = found.is_of_another_engine();
    let difference = found.difference.map(|found| DifferenceFields {
        line: found.line,
        key: found.key,
        recorded: found.recorded,
        replayed: found.replayed,
    });
    Ok(ReplayFields {
        header: to_python(py, &found.header.to_node())?,
        frames: found.frames,
        difference,
        other_engine,
        score: ScoreFields::new(&found.score, level),
        with_luck: found.with_luck,
    })
}

/// A built-in player, or a program whose files are relative to `folder`, as the header of a record has it.
#[pyfunction]
pub(crate) fn player_entry<'py>(
    py: Python<'py>,
    name: &str,
    folder: PathBuf,
) -> PyResult<Bound<'py, PyAny>> {
    let entry = match program_entry(name, &folder) {
        Some(entry) => entry,
        None => BuiltInPlayer::read(name).map(|player| player.entry()),
    };
    let PlayerEntry { name, settings } = entry.map_err(|error| to_exception(py, &error))?;
    to_python(py, &Node::object([("name", name.into()), ("settings", settings)]))
}

/// The share of the points that is corrected for luck, from the share of the points and the luck of
/// each pair; None without pairs.
#[pyfunction]
pub(crate) fn adjusted_share(
    py: Python<'_>,
    pairs: Vec<(f64, f64)>,
    level: f64,
) -> PyResult<Option<AdjustedFields>> {
    check_level(level).map_err(|e| to_exception(py, &e))?;
    let mut adjusted = AdjustedPairs::default();
    pairs.into_iter().for_each(|(share, luck)| adjusted.add(share, luck));
    Ok(AdjustedFields::new(&adjusted, level))
}

/// The state of a sequential test, from the numbers of pairs with 0, ½, 1, 1½ and 2 points.
#[pyfunction]
pub(crate) fn test_state(
    py: Python<'_>,
    counts: [u64; 5],
    p0: f64,
    p1: f64,
    alpha: f64,
    beta: f64,
    unit: &str,
) -> PyResult<TestFields> {
    let Some(unit) = TestUnit::named(unit) else {
        let known = TestUnit::ALL.map(TestUnit::name);
        let error = Reader::new(&Node::Null, "test.unit").unknown_word(unit, "unit", &known);
        return Err(to_exception(py, &error));
    };
    let test = SequentialTest { p0, p1, unit, alpha, beta };
    test.check().map_err(|error| to_exception(py, &error))?;
    Ok(test.state(&PairScores { counts }).into())
}

/// The interval of the share of the points, from the numbers of pairs with 0, ½, 1, 1½ and 2 points.
#[pyfunction]
pub(crate) fn pair_interval(py: Python<'_>, counts: [u64; 5], level: f64) -> PyResult<(f64, f64)> {
    check_level(level).map_err(|e| to_exception(py, &e))?;
    let interval = PairScores { counts }.interval(level);
    Ok((interval.low, interval.high))
}

/// The difference of normalised Elo that belongs to a share of the points, from the numbers of pairs
/// with 0, ½, 1, 1½ and 2 points.
#[pyfunction]
pub(crate) fn normalised_elo(counts: [u64; 5], share: f64) -> f64 {
    PairScores { counts }.normalised_elo(share)
}
