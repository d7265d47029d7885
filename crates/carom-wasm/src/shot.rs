//! `Shot`.

use std::sync::Arc;

use carom::ShotFile;
use carom::format::{DefaultElevation, PresetNames, coefficient_at};
use carom::resolve::cue_ball::Strike;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
use crate::trace::Trace;

/// A validated shot: immutable and shared.
#[wasm_bindgen]
pub struct Shot(pub(crate) Arc<ShotFile>);

impl From<carom::Shot> for Shot {
    fn from(shot: carom::Shot) -> Self {
        Self(ShotFile::from(shot).into())
    }
}

#[wasm_bindgen]
impl Shot {
    /// Reads a shot file.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &str) -> Result<Self, JsValue> {
        let shot = ShotFile::from_json(text).map_err(|e| to_exception(&e))?;
        Ok(Self(shot.into()))
    }

    /// The shot file: with or without an elevation that is the default, and with or without the dates
    /// of presets.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self, elevation: bool, dated: bool) -> String {
        let elevation =
            if elevation { DefaultElevation::Written } else { DefaultElevation::Omitted };
        let names = if dated { PresetNames::Dated } else { PresetNames::AsRead };
        self.0.written(elevation, names).to_json()
    }

    /// Whether the elevation is the default, because none was given.
    #[wasm_bindgen(js_name = hasDefaultElevation)]
    pub fn has_default_elevation(&self) -> bool {
        self.0.has_default_elevation()
    }

    /// The table's geometry as JSON.
    pub fn geometry(&self) -> String {
        self.0.table().to_node().to_json()
    }

    /// All values of the physics as JSON, in the form of the file.
    pub fn physics(&self) -> String {
        self.0.physics_node().to_json()
    }

    /// The balls' ids, in the order of the file.
    pub fn ids(&self) -> Vec<String> {
        self.0.balls().iter().map(|b| b.id.clone()).collect()
    }

    /// Radius (m), mass (kg), x, y, z (m) of each ball.
    pub fn balls(&self) -> Vec<f64> {
        let numbers = |b: &carom::shot::PlacedBall| {
            let [x, y, z] = b.state.position.to_array();
            [b.ball.radius, b.ball.mass, x, y, z]
        };
        self.0.balls().iter().flat_map(numbers).collect()
    }

    /// The struck ball's index.
    pub fn struck(&self) -> Option<usize> {
        self.0.strike().map(|(ball, _)| ball)
    }

    /// Speed, azimuth, elevation, side, height.
    pub fn strike(&self) -> Option<Vec<f64>> {
        let (_, s) = self.0.strike()?;
        Some(vec![s.speed, s.azimuth, s.elevation, s.side, s.height])
    }

    /// The largest tip offset without a miscue, ball radii.
    #[wasm_bindgen(js_name = miscueLimit)]
    pub fn miscue_limit(&self) -> f64 {
        self.0.miscue_limit()
    }

    /// The coefficient `key` of the physics at a speed (m/s), or `cushion.friction` at an angle (rad).
    #[wasm_bindgen(js_name = coefficientAt)]
    pub fn coefficient_at(&self, key: &str, at: f64) -> Result<f64, JsValue> {
        coefficient_at(self.0.physics(), key, at).map_err(|e| to_exception(&e))
    }

    /// The same shot with another strike; without an elevation, at the default one.
    #[wasm_bindgen(js_name = withStrike)]
    pub fn with_strike(
        &self,
        speed: f64,
        azimuth: f64,
        elevation: Option<f64>,
        side: f64,
        height: f64,
    ) -> Result<Self, JsValue> {
        let strike = Strike { speed, azimuth, elevation: elevation.unwrap_or(0.0), side, height };
        let shot = match elevation {
            Some(_) => self.0.with_strike(&strike),
            None => self.0.with_default_elevation(&strike),
        };
        Ok(Self(shot.map_err(|e| to_exception(&e))?.into()))
    }

    /// The end time, s.
    pub fn until(&self) -> Option<f64> {
        self.0.until()
    }

    /// The same shot with another end time (s), or none.
    #[wasm_bindgen(js_name = withUntil)]
    pub fn with_until(&self, until: Option<f64>) -> Result<Self, JsValue> {
        Ok(Self(self.0.with_until(until).map_err(|e| to_exception(&e))?.into()))
    }

    /// Simulates the shot and records all its events.
    pub fn simulate(&self) -> Result<Trace, JsValue> {
        let trace = self.0.simulate().map_err(|e| to_exception(&e))?;
        Ok(Trace::new(trace, self.0.clone()))
    }

    /// The same; a shot that reaches its cap of events gives the trace so far.
    #[wasm_bindgen(js_name = simulateToCap)]
    pub fn simulate_to_cap(&self) -> Result<Trace, JsValue> {
        let (trace, _) = self.0.simulate_to_cap().map_err(|e| to_exception(&e))?;
        Ok(Trace::new(trace, self.0.clone()))
    }
}

// In this file, because a shot makes traces: files do not import each other in a circle.
#[wasm_bindgen]
impl Trace {
    /// The shot that was simulated.
    pub fn shot(&self) -> Shot {
        Shot(self.file().clone())
    }
}
