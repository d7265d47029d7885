//! `Successors`: the frames that may follow a play.

use carom::noise::Errors;
use carom::{Error, Noise};
use carom_plan::{Prepared, Sampler};
use carom_rules::Request;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::noise_of;
use crate::error::to_exception;
use crate::rules::{Frame, PlayArguments};

/// Variants of a play, each ruled on. Arrays have an entry for each variant.
#[wasm_bindgen]
#[derive(Default)]
pub struct Successors {
    player: Vec<i8>,
    winner: Vec<i8>,
    legal: Vec<u8>,
    cue_ball: Vec<f64>,
}

#[wasm_bindgen]
impl Successors {
    /// The player who is asked next; −1 if the frame is over.
    pub fn player(&self) -> Vec<i8> {
        self.player.clone()
    }

    /// The winner; −1 if there is none.
    pub fn winner(&self) -> Vec<i8> {
        self.winner.clone()
    }

    /// 1 for a shot without a foul, 0 otherwise.
    pub fn legal(&self) -> Vec<u8> {
        self.legal.clone()
    }

    /// Where the cue ball lies (x, y in m); NaN if it is not on the table.
    #[wasm_bindgen(js_name = cueBall)]
    pub fn cue_ball(&self) -> Vec<f64> {
        self.cue_ball.clone()
    }
}

impl Successors {
    fn add(&mut self, frame: &carom_rules::Frame, is_legal: bool, cue: carom_rules::BallIndex) {
        let code = |seat: Option<usize>| seat.map_or(-1, |seat| seat as i8);
        let winner = match frame.request() {
            Request::Over { winner, .. } => *winner,
            _ => None,
        };
        self.player.push(code(frame.player()));
        self.winner.push(code(winner));
        self.legal.push(is_legal.into());
        self.cue_ball.extend(frame.layout().place(cue).unwrap_or([f64::NAN; 2]));
    }
}

#[wasm_bindgen]
impl Frame {
    /// The variants `first .. first + n` of a play with execution noise, each ruled on.
    pub fn successors(
        &self,
        play: &PlayArguments,
        noise: &str,
        n: usize,
        seed: u64,
        first: u64,
    ) -> Result<Successors, JsValue> {
        let noise = noise_of(noise)?;
        self.sample(play, noise, n, seed, first).map_err(|e| to_exception(&e))
    }
}

impl Frame {
    fn sample(
        &self,
        play: &PlayArguments,
        noise: Noise,
        n: usize,
        seed: u64,
        first: u64,
    ) -> Result<Successors, Error> {
        let play = self.play_of(play)?;
        let errors = Errors { noise, seed, ..Errors::default() };
        errors.check()?;
        let prepared = Prepared::of_play(&self.0, &play)?;
        let (mut sampler, mut successor) = (Sampler::new(), self.0.clone());
        let mut successors = Successors::default();
        for k in 0..n as u64 {
            sampler.simulate_variant(&prepared, &play.strike, &errors, first.wrapping_add(k))?;
            let ruling = sampler.rule(&prepared, play.call, &mut successor)?;
            successors.add(&successor, ruling.is_legal(), prepared.turn().cue);
        }
        Ok(successors)
    }
}
