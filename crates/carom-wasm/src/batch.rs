//! Many shots at once.

use carom::batch::{BatchResult, draw_strikes, draw_variant, simulate_batch, simulate_variants};
use carom::format::{Node, Reader};
use carom::noise::{Errors, SKILLS};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, Noise};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
use crate::shot::Shot;

/// Shots to simulate together.
#[wasm_bindgen]
#[derive(Default)]
pub struct Shots(Vec<std::sync::Arc<carom::ShotFile>>);

#[wasm_bindgen]
impl Shots {
    /// An empty list.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a shot.
    pub fn push(&mut self, shot: &Shot) {
        self.0.push(shot.0.clone());
    }

    /// Simulates all shots, without traces.
    pub fn simulate(&self) -> Batch {
        let shots: Vec<&carom::Shot> = self.0.iter().map(|shot| shot.shot()).collect();
        Batch { result: simulate_batch(&shots, &Runner::default()), strikes: Vec::new() }
    }
}

/// The Computational Olympiad's noise times `multiplier`, JSON.
#[wasm_bindgen]
pub fn olympiad(multiplier: f64) -> Result<String, JsValue> {
    let noise = Noise::olympiad(multiplier);
    noise.check().map_err(|e| to_exception(&e))?;
    Ok(noise.to_node().to_json())
}

/// Rejects a noise with a number out of range.
#[wasm_bindgen(js_name = checkNoise)]
pub fn check_noise(noise: &str) -> Result<(), JsValue> {
    noise_of(noise).map(|_| ())
}

/// The noise with these plain values, JSON as [`Noise::read`] takes them.
pub(crate) fn noise_of(json: &str) -> Result<Noise, JsValue> {
    read_json(json, "noise", Noise::read).map_err(|e| to_exception(&e))
}

/// Reads plain values, JSON. `place` begins the places of errors.
pub(crate) fn read_json<T>(
    json: &str,
    place: &str,
    read: impl FnOnce(&Reader<'_>) -> Result<T, Error>,
) -> Result<T, Error> {
    read(&Reader::new(&Node::from_json(json)?, place))
}

/// The presets of execution noise, JSON: pairs of a name and its plain values. The levels of play come
/// first, from the widest errors to the smallest; then the Olympiad.
#[wasm_bindgen(js_name = noisePresets)]
pub fn noise_presets() -> String {
    let olympiad = ("olympiad", Noise::olympiad(1.0));
    let presets = SKILLS.iter().chain([&olympiad]);
    let node = |(name, noise): &(&str, Noise)| Node::List(vec![(*name).into(), noise.to_node()]);
    Node::list(presets.map(node)).to_json()
}

#[wasm_bindgen]
impl Shot {
    /// Simulates the variants `first .. first + n` with execution noise, given as JSON.
    pub fn vary(&self, noise: &str, n: usize, seed: u64, first: u64) -> Result<Batch, JsValue> {
        let noise = noise_of(noise)?;
        let strikes =
            draw_strikes(&self.0, &noise, n, seed, first).map_err(|e| to_exception(&e))?;
        let errors = Errors { noise, seed, ..Errors::default() };
        let result = simulate_variants(&self.0, &strikes, &errors, first, &Runner::default());
        Ok(Batch { result: result.map_err(|e| to_exception(&e))?, strikes })
    }

    /// The shot of variant `index`: an ordinary shot, with its strike and its cling.
    pub fn variant(&self, noise: &str, seed: u64, index: u64) -> Result<Shot, JsValue> {
        let drawn = draw_variant(&self.0, &noise_of(noise)?, seed, index);
        drawn.map(|drawn| Shot(drawn.into())).map_err(|e| to_exception(&e))
    }
}

/// The results of many shots. Arrays per ball have `shots` × `balls` entries, shot by shot.
#[wasm_bindgen]
pub struct Batch {
    result: BatchResult,
    strikes: Vec<Strike>,
}

#[wasm_bindgen]
impl Batch {
    /// Number of shots.
    pub fn shots(&self) -> usize {
        self.result.shots
    }

    /// Number of balls of the largest shot.
    pub fn balls(&self) -> usize {
        self.result.balls
    }

    /// x, y, z (m) per shot and ball.
    #[wasm_bindgen(js_name = finalPosition)]
    pub fn final_position(&self) -> Vec<f64> {
        self.result.final_position.as_flattened().to_vec()
    }

    /// Pocket index per shot and ball; negative where the ball fell into none.
    pub fn pocket(&self) -> Vec<i8> {
        self.result.pocket.clone()
    }

    /// Events per shot.
    pub fn events(&self) -> Vec<i32> {
        self.result.events.clone()
    }

    /// Speed, azimuth, elevation, side, height per shot; empty unless the strikes were drawn.
    pub fn strikes(&self) -> Vec<f64> {
        let row = |s: &Strike| [s.speed, s.azimuth, s.elevation, s.side, s.height];
        self.strikes.iter().flat_map(row).collect()
    }

    /// The indices of the shots that failed, ascending.
    pub fn failed(&self) -> Vec<u32> {
        self.result.errors.iter().map(|(k, _)| *k as u32).collect()
    }

    /// Their errors, in the order of [`Self::failed`].
    pub fn errors(&self) -> Vec<JsValue> {
        self.result.errors.iter().map(|(_, e)| to_exception(e)).collect()
    }
}
