//! Studies: their reader, and the judge of their tasks.

use carom::Error;
use carom::format::{Node, Reader};
use carom_drill::study::{STUDY_SCHEMA, Study, goal_from_node, judge};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
use crate::trace::Trace;

/// Checks the file of a study; nothing is simulated.
#[wasm_bindgen(js_name = checkStudy)]
pub fn check_study(json: &str) -> Result<(), JsValue> {
    Study::from_json(json).map(drop).map_err(|e| to_exception(&e))
}

/// The JSON Schema of a study.
#[wasm_bindgen(js_name = studySchema)]
pub fn study_schema() -> String {
    STUDY_SCHEMA.into()
}

#[wasm_bindgen]
impl Trace {
    /// How the shot stands to the goal of a task; both JSON.
    pub fn judge(&self, goal: &str) -> Result<String, JsValue> {
        self.judged(goal).map(|node| node.to_json()).map_err(|e| to_exception(&e))
    }
}

impl Trace {
    fn judged(&self, goal: &str) -> Result<Node, Error> {
        let node = Node::from_json(goal)?;
        let goal = goal_from_node(&Reader::new(&node, "goal"), self.trace().shot())?;
        Ok(judge(self.trace(), &goal)?.to_node())
    }
}
