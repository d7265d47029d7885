//! The engine for JavaScript: conversions, no logic. The public interface is `web/src/engine`, which adds
//! types to these classes, checks the arguments and parses the JSON.

pub mod aim;
pub mod batch;
pub mod drill;
pub mod error;
pub mod evaluate;
pub mod match_record;
pub mod player;
pub mod reference;
pub mod rules;
pub mod shot;
pub mod study;
pub mod successors;
pub mod trace;

use wasm_bindgen::prelude::wasm_bindgen;

/// Throws a panic as an exception with its message; by default the exception says only "unreachable".
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
}
