//! Many shots at once.

use carom::batch::{BatchResult, simulate_batch};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::shot::Shot;

/// Shots to be simulated together.
#[wasm_bindgen]
#[derive(Default)]
pub struct Shots(Vec<std::sync::Arc<carom::Shot>>);

#[wasm_bindgen]
impl Shots {
    /// None yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds one.
    pub fn push(&mut self, shot: &Shot) {
        self.0.push(shot.0.clone());
    }

    /// Simulates all, without traces.
    pub fn simulate(&self) -> Batch {
        Batch(simulate_batch(&self.0, None, &|_| {}))
    }
}

/// The ends of many shots.
#[wasm_bindgen]
pub struct Batch(BatchResult);

#[wasm_bindgen]
impl Batch {
    /// Rows.
    pub fn shots(&self) -> usize {
        self.0.shots
    }

    /// Columns.
    pub fn balls(&self) -> usize {
        self.0.balls
    }

    /// x, y, z (m) per shot and ball.
    #[wasm_bindgen(js_name = finalPosition)]
    pub fn final_position(&self) -> Vec<f64> {
        self.0.final_position.as_flattened().to_vec()
    }

    /// Pocket index per shot and ball.
    pub fn pocket(&self) -> Vec<i8> {
        self.0.pocket.clone()
    }

    /// Events per shot.
    pub fn events(&self) -> Vec<i32> {
        self.0.events.clone()
    }

    /// The indices of the shots that failed, ascending.
    pub fn failed(&self) -> Vec<u32> {
        self.0.errors.iter().map(|(k, _)| *k as u32).collect()
    }

    /// What went wrong in them, in the same order.
    pub fn errors(&self) -> Vec<String> {
        self.0.errors.iter().map(|(_, e)| e.to_string()).collect()
    }
}
