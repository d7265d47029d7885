//! Many shots at once.

use carom::batch::{BatchResult, draw_strikes, draw_variant, simulate_batch, simulate_variants};
use carom::format::Node;
use carom::noise::{Covariance, Errors, SKILLS, Samples};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Noise};
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

/// The Computational Olympiad's noise times `multiplier`, in the order of [`numbers`].
#[wasm_bindgen]
pub fn olympiad(multiplier: f64) -> Result<Vec<f64>, JsValue> {
    let noise = Noise::olympiad(multiplier);
    noise.check().map_err(|e| to_exception(&e))?;
    Ok(numbers(&noise))
}

/// Rejects a noise with a number out of range.
#[wasm_bindgen(js_name = checkNoise)]
pub fn check_noise(noise: &[f64]) -> Result<(), JsValue> {
    noise_of(noise)?.check().map_err(|e| to_exception(&e))
}

/// The σ of speed (m/s), azimuth, elevation (rad), side, height (m), and the probability and the
/// friction of a cling. If the noise has more, then also the error relative to the speed, the five
/// numbers of the bias, 1 and the 25 numbers of the covariance or only 0, and five numbers for each
/// measured error.
pub(crate) fn numbers(noise: &Noise) -> Vec<f64> {
    let Noise { speed, azimuth, elevation, side_m, height_m, .. } = *noise;
    let Noise { cling_probability, cling_friction, speed_relative, bias, .. } = *noise;
    let mut all =
        vec![speed, azimuth, elevation, side_m, height_m, cling_probability, cling_friction];
    let Noise { covariance, samples, .. } = noise;
    if speed_relative != 0.0 || bias != [0.0; 5] || covariance.is_some() || samples.is_some() {
        all.push(speed_relative);
        all.extend(bias);
        all.push(f64::from(u8::from(covariance.is_some())));
        all.extend(covariance.iter().flat_map(|covariance| covariance.matrix().as_flattened()));
        all.extend(samples.iter().flat_map(|samples| samples.rows().as_flattened()));
    }
    all
}

/// The inverse of [`numbers`].
pub(crate) fn noise_of(numbers: &[f64]) -> Result<Noise, JsValue> {
    read_numbers(numbers).map_err(|e| to_exception(&e))
}

fn read_numbers(numbers: &[f64]) -> Result<Noise, Error> {
    let length =
        || ErrorKind::WrongCount.at("noise", "the list has a wrong length", "use carom's `Noise`");
    let (plain, more) = numbers.split_first_chunk::<7>().ok_or_else(length)?;
    let [speed, azimuth, elevation, side_m, height_m, cling_probability, cling_friction] = *plain;
    let mut noise = Noise {
        speed,
        azimuth,
        elevation,
        side_m,
        height_m,
        cling_probability,
        cling_friction,
        ..Noise::NONE
    };
    let Some((&[speed_relative, ref bias @ .., has_covariance], more)) =
        more.split_first_chunk::<7>()
    else {
        return if more.is_empty() { Ok(noise) } else { Err(length()) };
    };
    (noise.speed_relative, noise.bias) = (speed_relative, *bias);
    let mut rows = more;
    if has_covariance != 0.0 {
        let (matrix, others) = more.split_first_chunk::<25>().ok_or_else(length)?;
        let (matrix, _) = matrix.as_chunks::<5>();
        noise.covariance = Some(Covariance::new(core::array::from_fn(|i| matrix[i]))?);
        rows = others;
    }
    match rows.as_chunks::<5>() {
        ([], []) => {}
        (rows, []) => noise.samples = Some(Samples::new(rows.to_vec())?),
        _ => return Err(length()),
    }
    Ok(noise)
}

/// The presets of execution noise, JSON: pairs of a name and the [`numbers`]. The levels of play come
/// first, from the widest errors to the smallest; then the Olympiad.
#[wasm_bindgen(js_name = noisePresets)]
pub fn noise_presets() -> String {
    let olympiad = ("olympiad", Noise::olympiad(1.0));
    let presets = SKILLS.iter().chain([&olympiad]);
    let node = |(name, noise): &(&str, Noise)| {
        Node::List(vec![(*name).into(), Node::list(numbers(noise))])
    };
    Node::list(presets.map(node)).to_json()
}

#[wasm_bindgen]
impl Shot {
    /// Simulates the variants `first .. first + n` with execution noise, given as [`numbers`].
    pub fn vary(&self, noise: &[f64], n: usize, seed: u64, first: u64) -> Result<Batch, JsValue> {
        let noise = noise_of(noise)?;
        let strikes =
            draw_strikes(&self.0, &noise, n, seed, first).map_err(|e| to_exception(&e))?;
        let errors = Errors { noise, seed, ..Errors::default() };
        let result = simulate_variants(&self.0, &strikes, &errors, first, &Runner::default());
        Ok(Batch { result: result.map_err(|e| to_exception(&e))?, strikes })
    }

    /// The shot of variant `index`: an ordinary shot, with its strike and its cling.
    pub fn variant(&self, noise: &[f64], seed: u64, index: u64) -> Result<Shot, JsValue> {
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
