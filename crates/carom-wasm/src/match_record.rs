//! `MatchRecord`: the record of a match, frame by frame.

use carom::format::Node;
use carom_arena::RecordedMatch;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;

/// The record of a match.
#[wasm_bindgen]
pub struct MatchRecord(RecordedMatch);

#[wasm_bindgen]
impl MatchRecord {
    /// Reads a record: JSONL.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str) -> Result<Self, JsValue> {
        RecordedMatch::read(text).map(Self).map_err(|e| to_exception(&e))
    }

    /// The header, JSON.
    pub fn header(&self) -> String {
        self.0.header_node().to_json()
    }

    /// Whether the record has the last line.
    #[wasm_bindgen(js_name = isFinished)]
    pub fn is_finished(&self) -> bool {
        self.0.is_finished()
    }

    /// The frames without their moves: a list, JSON.
    pub fn frames(&self) -> String {
        Node::List(self.0.frames()).to_json()
    }

    /// A frame as a game, JSON: `record` and `moves`.
    pub fn game(&self, frame: u64) -> Result<String, JsValue> {
        self.0.game(frame).map(|game| game.to_json()).map_err(|e| to_exception(&e))
    }
}
