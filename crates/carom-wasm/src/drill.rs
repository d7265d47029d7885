//! Puzzles, drill files and the judge. What is structured is JSON.

use carom::format::Node;
use carom::{ErrorKind, Simulator, Table};
use carom_drill::puzzle::accepted;
use carom_drill::{Drill, DrillArea, DrillGoal, Played, Puzzle, judge};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::read_json;
use crate::error::to_exception;
use crate::shot::Shot;

/// The puzzle with an id.
#[wasm_bindgen]
pub fn puzzle(id: &str) -> Result<String, JsValue> {
    Ok(Puzzle::read(id).map_err(|e| to_exception(&e))?.to_node().to_json_line())
}

/// Every puzzle of the list: lists of id and rating.
#[wasm_bindgen]
pub fn puzzles() -> String {
    let entry = |one: carom_drill::puzzle::ListedPuzzle| {
        Node::List(vec![one.id().into(), one.rating.into()])
    };
    Node::list(accepted().map(entry)).to_json_line()
}

/// A drill file, checked.
#[wasm_bindgen(js_name = readDrill)]
pub fn read_drill(text: &str) -> Result<String, JsValue> {
    Ok(Drill::from_json(text).map_err(|e| to_exception(&e))?.to_node().to_json_line())
}

/// How far (m) a place is outside an area, JSON, of a table's preset; 0 inside.
#[wasm_bindgen(js_name = areaDistance)]
pub fn area_distance(area: &str, table: &str, x: f64, y: f64) -> Result<f64, JsValue> {
    let distance = Table::preset(table)
        .ok_or_else(|| {
            let remedy = "write the name of a table's preset";
            ErrorKind::UnknownName.at("table", format!("there is no table \"{table}\""), remedy)
        })
        .and_then(|table| Ok(read_json(area, "area", DrillArea::read)?.distance(&table, [x, y])));
    distance.map_err(|e| to_exception(&e))
}

#[wasm_bindgen]
impl Shot {
    /// The verdict on the shot, with the balls that a run still has to pot.
    pub fn judge(&self, goal: &str, left: Vec<String>) -> Result<String, JsValue> {
        let judged = read_json(goal, "goal", DrillGoal::read).and_then(|goal| {
            let played = Played::of(&mut Simulator::new(), &self.0, None)?;
            judge(&self.0, &played, &goal, &left)
        });
        Ok(judged.map_err(|e| to_exception(&e))?.to_node().to_json_line())
    }
}
