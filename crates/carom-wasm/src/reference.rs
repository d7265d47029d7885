//! Table and physics presets, speed bands of rolling friction, racks and schemas. Lists are JSON.

use carom::format::Node;
use carom::physics::{RollingLaw, RollingTolerance};
use carom::rack::{Break, Game, break_shot as open};
use carom::{Physics, Table, edition};
use carom_rules::{GameFacts, Options};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
use crate::shot::Shot;

/// Name and version, as in traces.
#[wasm_bindgen]
pub fn version() -> String {
    carom::trace::ENGINE.into()
}

/// One tip, the unit in which players count English, ball radii.
#[wasm_bindgen]
pub fn tip() -> f64 {
    carom::resolve::cue_ball::TIP
}

/// Every table preset's geometry: the newest ones, then older editions.
#[wasm_bindgen]
pub fn tables() -> String {
    let presets = edition::listed(edition::TABLES).into_iter().filter_map(Table::preset);
    Node::list(presets.map(|table| table.to_node())).to_json()
}

/// The current name of the preset `name` of a table or of physics, see [`edition`].
#[wasm_bindgen(js_name = currentPresetName)]
pub fn current_preset_name(name: &str) -> Option<String> {
    let table = Table::preset(name).and_then(|table| table.name);
    table.or_else(|| edition::current_physics_name(name).map(String::from))
}

/// Every physics preset by name, as in a shot file: the newest ones, then older editions.
#[wasm_bindgen]
pub fn physics() -> String {
    let preset = |name: &'static str| Some((name.into(), Physics::preset(name)?.to_node()));
    Node::Object(edition::listed(edition::PHYSICS).into_iter().filter_map(preset).collect())
        .to_json()
}

/// The value of `physics.cloth.rolling_friction` that follows a measured deceleration of rolling balls,
/// `a` + `b`·v: JSON, a number or a list of speed bands.
#[wasm_bindgen(js_name = rollingBands)]
pub fn rolling_bands(
    a: f64,
    b: f64,
    fastest: f64,
    share: f64,
    least: f64,
    gravity: f64,
) -> Result<String, JsValue> {
    let bands = RollingLaw { a, b }.bands(gravity, &RollingTolerance { fastest, share, least });
    Ok(bands.map_err(|e| to_exception(&e))?.to_node().to_json())
}

/// A shot file, or a frame's table and physics, with the dated names of presets.
#[wasm_bindgen(js_name = withDatedNames)]
pub fn with_dated_names(file: &str) -> Result<String, JsValue> {
    let file = Node::from_json(file).map_err(|e| to_exception(&e))?;
    Ok(carom::format::with_dated_names(&file).to_json())
}

/// The facts of every game.
#[wasm_bindgen(js_name = gameFacts)]
pub fn game_facts() -> String {
    Node::list(Game::ALL.map(|game| GameFacts::of(game).to_node())).to_json()
}

/// The options of a frame that has no others.
#[wasm_bindgen(js_name = defaultOptions)]
pub fn default_options() -> String {
    Options::default().to_node().to_json()
}

/// The break of a game; options that are undefined take their defaults.
#[wasm_bindgen(js_name = breakShot)]
pub fn break_shot(
    game: &str,
    table: Option<String>,
    speed: Option<f64>,
    seed: u64,
    gap: Option<f64>,
    preset: Option<String>,
) -> Result<Shot, JsValue> {
    let game = Game::read(game).map_err(|e| to_exception(&e))?;
    let table = table.as_deref();
    let usual = Break::named(game, preset.as_deref(), seed).map_err(|e| to_exception(&e))?;
    let (speed, gap) = (speed.or(usual.speed), gap.unwrap_or(usual.gap));
    let opening = Break { table, speed, gap, ..usual };
    open(&opening).map(Shot::from).map_err(|e| to_exception(&e))
}

/// The JSON Schema of a shot file.
#[wasm_bindgen(js_name = shotSchema)]
pub fn shot_schema() -> String {
    carom::format::schema::SHOT.into()
}

/// The JSON Schema of a trace.
#[wasm_bindgen(js_name = traceSchema)]
pub fn trace_schema() -> String {
    carom::format::schema::TRACE.into()
}
