//! Many shots at once.

use carom::Noise;
use carom::batch::{BatchResult, draw_strikes, simulate_batch, simulate_strikes};
use carom::noise::SKILLS;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::shot::Node;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
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
        Batch { result: simulate_batch(&self.0, &Runner::default()), strikes: Vec::new() }
    }
}

/// σ of the Computational Olympiad's noise: speed, azimuth, elevation, side, height.
#[wasm_bindgen]
pub fn olympiad(multiplier: f64) -> Vec<f64> {
    let Noise { speed, azimuth, elevation, side, height } = Noise::olympiad(multiplier);
    vec![speed, azimuth, elevation, side, height]
}

/// The presets of execution noise, JSON: name and σ of speed, azimuth, elevation, side, height. Levels of
/// play from the least, then the Olympiad.
#[wasm_bindgen(js_name = noisePresets)]
pub fn noise_presets() -> String {
    let olympiad = ("olympiad", Noise::olympiad(1.0));
    let presets = SKILLS.into_iter().chain([olympiad]);
    let node = |(name, n): (&str, Noise)| {
        let sigmas = [n.speed, n.azimuth, n.elevation, n.side, n.height];
        Node::List(vec![name.into(), Node::list(sigmas)])
    };
    Node::list(presets.map(node)).to_json()
}

#[wasm_bindgen]
impl Shot {
    /// Executions number `first`.. with `noise`: the σ of speed, azimuth, elevation, side, height.
    pub fn vary(
        &self,
        noise: &[f64],
        seed: u64,
        first: u64,
        count: usize,
    ) -> Result<Batch, JsValue> {
        let [speed, azimuth, elevation, side, height] = *noise else {
            return Err(js_sys::RangeError::new("noise: five numbers are wanted").into());
        };
        let noise = Noise { speed, azimuth, elevation, side, height };
        let strikes =
            draw_strikes(&self.0, &noise, count, seed, first).map_err(|e| to_exception(&e))?;
        Ok(Batch { result: simulate_strikes(&self.0, &strikes, &Runner::default()), strikes })
    }
}

/// The ends of many shots.
#[wasm_bindgen]
pub struct Batch {
    result: BatchResult,
    strikes: Vec<Strike>,
}

#[wasm_bindgen]
impl Batch {
    /// Rows.
    pub fn shots(&self) -> usize {
        self.result.shots
    }

    /// Columns.
    pub fn balls(&self) -> usize {
        self.result.balls
    }

    /// x, y, z (m) per shot and ball.
    #[wasm_bindgen(js_name = finalPosition)]
    pub fn final_position(&self) -> Vec<f64> {
        self.result.final_position.as_flattened().to_vec()
    }

    /// Pocket index per shot and ball.
    pub fn pocket(&self) -> Vec<i8> {
        self.result.pocket.clone()
    }

    /// Events per shot.
    pub fn events(&self) -> Vec<i32> {
        self.result.events.clone()
    }

    /// Speed, azimuth, elevation, side, height per shot, where they were drawn.
    pub fn strikes(&self) -> Vec<f64> {
        let row = |s: &Strike| [s.speed, s.azimuth, s.elevation, s.side, s.height];
        self.strikes.iter().flat_map(row).collect()
    }

    /// The indices of the shots that failed, ascending.
    pub fn failed(&self) -> Vec<u32> {
        self.result.errors.iter().map(|(k, _)| *k as u32).collect()
    }

    /// What went wrong in them, in the same order.
    pub fn errors(&self) -> Vec<String> {
        self.result.errors.iter().map(|(_, e)| e.to_string()).collect()
    }
}
