//! Aiming by ball and pocket.

use carom_plan::{PotLines, pot_aim};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;
use crate::shot::Shot;

/// The strike that pots a ball.
#[wasm_bindgen]
pub struct PotAim {
    aim: carom_plan::PotAim,
    route: String,
}

#[wasm_bindgen]
impl Shot {
    /// The strike turned so that `ball` falls into `pocket`, if a line was found.
    #[wasm_bindgen(js_name = potAim)]
    pub fn pot_aim(
        &self,
        ball: usize,
        pocket: usize,
        near: bool,
    ) -> Result<Option<PotAim>, JsValue> {
        let lines = if near { PotLines::Near } else { PotLines::All };
        let found = pot_aim(&self.0, ball, pocket, lines).map_err(|e| to_exception(&e))?;
        Ok(found.map(|aim| PotAim { route: aim.route.words(&self.0), aim }))
    }
}

#[wasm_bindgen]
impl PotAim {
    /// Speed, azimuth, elevation, side, height.
    pub fn strike(&self) -> Vec<f64> {
        let s = &self.aim.strike;
        vec![s.speed, s.azimuth, s.elevation, s.side, s.height]
    }

    /// By how much the azimuth may be wrong on either side, rad.
    pub fn margin(&self) -> f64 {
        self.aim.margin
    }

    /// The players' name of the route.
    pub fn kind(&self) -> String {
        self.aim.route.kind()
    }

    /// The route in words.
    pub fn route(&self) -> String {
        self.route.clone()
    }

    /// Whether the cue ball falls or leaves the table.
    #[wasm_bindgen(js_name = losesCueBall)]
    pub fn loses_cue_ball(&self) -> bool {
        self.aim.loses_cue_ball
    }
}
