//! The engine for JavaScript: conversions, no logic. The public face is `web/src/engine`, which gives
//! these classes their types and parses their JSON.

pub mod batch;
pub mod error;
pub mod reference;
pub mod rules;
pub mod shot;
pub mod trace;

use wasm_bindgen::prelude::wasm_bindgen;

/// A panic is thrown as an exception with its message, rather than as "unreachable".
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
}
