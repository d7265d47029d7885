//! Matches: `_core.play_match` and `_core.replay_match`; the interval of
//! pairs that were played elsewhere: `_core.pair_interval`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use carom::format::Node;
use carom::runner::Runner;
use carom_arena::{
    Hypothesis, MatchPlan, MatchReport, MatchScore, PairScores, Replay, Secret, TestState,
    elo_of_share,
};
use carom_plan::{Interval, check_level};
use pyo3::prelude::*;

use crate::error::{arena_exception, to_exception};
use crate::match_player::{Entrant, EntrantArguments, Raised};
use crate::node::{from_python, to_python};
use crate::options::count;
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
    pairing_ratio: Option<f64>,
    reasons: BTreeMap<&'static str, u64>,
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
            pairing_ratio: score.pairs.pairing_ratio(score.frames),
            reasons: score.reasons.iter().map(|(reason, n)| (reason.name(), *n)).collect(),
        }
    }
}

/// The state of a sequential test; a dict in Python.
#[derive(IntoPyObject)]
struct TestFields {
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

/// Plays or continues a match in `folder`. `agreed`: the keys of a record's header without `format`,
/// `engine`, `secret_sha256` and `players`. `report` is called with 0, pairs done, all pairs.
/// `interrupt` is called again and again after a stop, until the players have ended; None if no player
/// needs it. Players in Python and one thread have the calling thread.
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
    interrupt: Option<Py<PyAny>>,
) -> PyResult<MatchFields> {
    let raise = |error| to_exception(py, &error);
    check_level(level).map_err(raise)?;
    let raised = Raised::default();
    let players = players.map(|player| Entrant::read(player, &raised));
    let players = match players {
        [Ok(one), Ok(other)] => [one, other],
        [Err(error), _] | [_, Err(error)] => return Err(raise(error)),
    };
    let mut agreed = from_python(agreed)?;
    agreed.set("players", Node::list(players.each_ref().map(Entrant::entry)));
    let secret = secret.map(|digits| Secret::parse(&digits)).transpose().map_err(raise)?;
    let plan = MatchPlan::from_node(&agreed, secret).map_err(raise)?;
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let make = |index: usize| players[index].make();
    let after_stop = || {
        if let Some(interrupt) = &interrupt {
            // A failure leaves the players to end by themselves.
            let _ = Python::attach(|py| interrupt.call0(py).map(drop));
        }
    };
    let is_outside = players.iter().any(Entrant::is_outside);
    let watch = if is_outside && threads == 1 { Watch::Here } else { Watch::Beside(&after_stop) };
    let played = progress::run_with(py, &report, &watch, |progress| {
        Ok(carom_arena::play_match(&plan, &folder, &make, &runner, progress))
    })?;
    if let Some(error) = raised.take() {
        return Err(error);
    }
    let MatchReport { record, score, test, pairs, secret_sha256 } =
        played.map_err(|error| arena_exception(py, &error))?;
    let (score, test) = (ScoreFields::new(&score, level), test.map(TestFields::from));
    Ok(MatchFields { record, played_pairs: pairs, score, test, secret_sha256 })
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
}

/// Plays the record `text` of a match again. `report` is called with 0, frames done, all frames.
#[pyfunction]
pub(crate) fn replay_match<'py>(
    py: Python<'py>,
    text: &str,
    level: f64,
    threads: usize,
    report: Py<PyAny>,
) -> PyResult<ReplayFields<'py>> {
    let raise = |error| to_exception(py, &error);
    check_level(level).map_err(raise)?;
    let runner = Runner::new(count(threads)).map_err(raise)?;
    let found: Replay =
        progress::run(py, &report, |progress| carom_arena::replay(text, &runner, progress))?;
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
    })
}

/// The interval of the share of the points, from the numbers of pairs with 0, ½, 1, 1½ and 2 points.
#[pyfunction]
pub(crate) fn pair_interval(py: Python<'_>, counts: [u64; 5], level: f64) -> PyResult<(f64, f64)> {
    check_level(level).map_err(|e| to_exception(py, &e))?;
    let interval = PairScores { counts }.interval(level);
    Ok((interval.low, interval.high))
}
