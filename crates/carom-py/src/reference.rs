//! Reference data of the engine: table presets, racks, schemas.

use carom::format::Node;
use carom::rack::{Break, Game, break_shot as open};
use carom::{ErrorKind, Table, edition, version};
use carom_rules::{GameFacts, Options};
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::exceptions::refuse;
use crate::node::{from_python, to_python};
use crate::shot::Shot;

/// What this build of the engine is: name and version, version of its results, features, vector
/// instructions, and the commit if it was recorded.
#[pyfunction]
pub(crate) fn build(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let node = Node::object([
        ("engine", version::ENGINE.into()),
        ("results", version::RESULTS_VERSION.into()),
        ("features", Node::list(version::features().iter().copied())),
        ("vectors", version::vector_path().into()),
        ("commit", Node::from(version::COMMIT)),
    ]);
    to_python(py, &node)
}

/// Every physics preset with its values and their sources.
#[pyfunction]
pub(crate) fn physics(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    to_python(py, &carom::format::physics_list())
}

/// Every preset's geometry: the newest ones, then older editions.
#[pyfunction]
pub(crate) fn tables(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let presets = edition::listed(edition::TABLES).into_iter().filter_map(Table::preset);
    to_python(py, &Node::List(presets.map(|table| table.to_node()).collect()))
}

/// The facts of every game.
#[pyfunction]
pub(crate) fn game_facts(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    to_python(py, &Node::list(Game::ALL.map(|game| GameFacts::of(game).to_node())))
}

/// The options of a frame that has no others.
#[pyfunction]
pub(crate) fn default_options(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    to_python(py, &Options::default().to_node())
}

/// Every break preset with its values and their sources.
#[pyfunction]
pub(crate) fn break_presets(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    to_python(py, &carom::rack::break_presets())
}

/// The id of a ball, and by how much it moved, m.
type MovedBallFields = (String, [f64; 2]);

/// A shot file with overlapping balls apart, and the balls that moved: id, and by how much (m).
#[pyfunction]
pub(crate) fn repaired<'py>(
    file: &Bound<'py, PyAny>,
    tolerance: f64,
) -> PyResult<(Bound<'py, PyAny>, Vec<MovedBallFields>)> {
    let py = file.py();
    let found = carom::format::repaired(&from_python(file)?, tolerance);
    let (file, moved) = found.map_err(|e| to_exception(py, &e))?;
    let moved = moved.into_iter().map(|ball| (ball.id, ball.by)).collect();
    Ok((to_python(py, &file)?, moved))
}

/// The opening shot of a game; None stands for the game's usual value.
#[pyfunction]
pub(crate) fn break_shot(
    py: Python<'_>,
    game: &str,
    preset: Option<&str>,
    table: Option<&str>,
    speed: Option<f64>,
    seed: u64,
    gap: Option<f64>,
) -> PyResult<Shot> {
    let game = Game::read(game).map_err(|e| to_exception(py, &e))?;
    let usual = Break::named(game, preset, seed).map_err(|e| to_exception(py, &e))?;
    let (speed, gap) = (speed.or(usual.speed), gap.unwrap_or(usual.gap));
    let opening = Break { table, speed, gap, ..usual };
    open(&opening).map(Shot::from).map_err(|e| to_exception(py, &e))
}

/// Every kind of error: its name, what it says, and the keys that its details can have.
#[pyfunction]
pub(crate) fn error_kinds() -> Vec<(&'static str, &'static str, Vec<&'static str>)> {
    let all = ErrorKind::ALL.iter();
    all.map(|kind| (kind.name(), kind.sentence(), kind.details().to_vec())).collect()
}

/// The JSON Schema of `shot`, `trace`, `play`, `arena` or `study`, as JSON.
#[pyfunction]
pub(crate) fn schema(kind: &str) -> PyResult<String> {
    match kind {
        "shot" => Ok(carom::format::schema::SHOT.into()),
        "trace" => Ok(carom::format::schema::TRACE.into()),
        "play" => Ok(carom_rules::play_schema().to_json()),
        "arena" => Ok(carom_arena::ARENA_SCHEMA.into()),
        "study" => Ok(carom_drill::study::STUDY_SCHEMA.into()),
        _ => Err(refuse(
            ErrorKind::UnknownName,
            "kind",
            &format!("there is no schema \"{kind}\""),
            "write \"shot\", \"trace\", \"play\", \"arena\" or \"study\"",
        )),
    }
}
