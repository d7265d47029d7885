//! Aiming by ball and pocket.

use carom::resolve::cue_ball::Strike;
use carom_plan::{ErrorModel, PotLines, leave_aim, pot_aim};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::noise_of;
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

    /// The strike that pots `ball` into `pocket` and leaves the cue ball nearest to (x, y), if any pots
    /// it. `errors` and `variants` rank strikes that reach the place.
    #[wasm_bindgen(js_name = leaveAim)]
    pub fn leave_aim(
        &self,
        ball: usize,
        pocket: usize,
        place: &[f64],
        range: &[f64],
        noise: &str,
        variants: u32,
    ) -> Result<Option<LeaveAim>, JsValue> {
        let (&[x, y], &[least, most, offset]) = (place, range) else {
            return Err(js_sys::RangeError::new("write two numbers and three").into());
        };
        let noise = noise_of(noise)?;
        let model = ErrorModel { noise, variants: variants.into(), ..ErrorModel::default() };
        leave_aim(&self.0, ball, pocket, [x, y], [least, most], offset, &model)
            .map(|found| found.map(LeaveAim))
            .map_err(|e| to_exception(&e))
    }
}

/// The strike that leaves the cue ball near a place.
#[wasm_bindgen]
pub struct LeaveAim(carom_plan::LeaveAim);

#[wasm_bindgen]
impl LeaveAim {
    /// Speed, azimuth, elevation, side, height.
    pub fn strike(&self) -> Vec<f64> {
        numbers(&self.0.strike)
    }

    /// Where the cue ball stops, m.
    pub fn end(&self) -> Vec<f64> {
        self.0.end.to_vec()
    }

    /// Its distance from the place, m.
    pub fn distance(&self) -> f64 {
        self.0.distance
    }

    /// Whether the place counts as reached.
    #[wasm_bindgen(js_name = isReached)]
    pub fn is_reached(&self) -> bool {
        self.0.is_reached
    }

    /// The share of variants that pot the ball and stop within 15 cm of the end.
    pub fn chance(&self) -> f64 {
        self.0.chance.share()
    }
}

fn numbers(s: &Strike) -> Vec<f64> {
    vec![s.speed, s.azimuth, s.elevation, s.side, s.height]
}

#[wasm_bindgen]
impl PotAim {
    /// Speed, azimuth, elevation, side, height.
    pub fn strike(&self) -> Vec<f64> {
        numbers(&self.aim.strike)
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
