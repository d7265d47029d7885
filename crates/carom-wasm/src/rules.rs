//! `Frame`: games with a referee.

use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom::shot::{Cling, StrikePolicy};
use carom::{Error, Noise};
use carom_rules::{Choice, ErrorSeeds, Game, Options, Play};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::noise_of;
use crate::error::to_exception;
use crate::shot::Shot;
use crate::trace::Trace;

/// The table on which a game is played by default.
#[wasm_bindgen(js_name = usualTable)]
pub fn usual_table(game: &str) -> Result<String, JsValue> {
    let game = Game::read(game).map_err(|e| to_exception(&e))?;
    Ok(game.table().into())
}

/// Checks the keys of a frame's record and the types of its parts.
#[wasm_bindgen(js_name = checkRecord)]
pub fn check_record(json: &str) -> Result<(), JsValue> {
    let read = Node::from_json(json);
    read.and_then(|record| carom_rules::check_record(&record)).map_err(|e| to_exception(&e))
}

/// A game in progress.
#[wasm_bindgen]
pub struct Frame(pub(crate) carom_rules::Frame);

/// A player's shot: the strike, the place of a cue ball in hand, and the call.
#[wasm_bindgen]
pub struct PlayArguments {
    strike: Strike,
    has_elevation: bool,
    cue_ball: Option<[f64; 2]>,
    call: String,
    ball: Option<String>,
    pocket: Option<String>,
    policy: StrikePolicy,
    cling: Cling,
}

#[wasm_bindgen]
impl PlayArguments {
    /// A play of this strike, which calls nothing. Without an elevation it is the default one.
    #[wasm_bindgen(constructor)]
    pub fn new(speed: f64, azimuth: f64, elevation: Option<f64>, side: f64, height: f64) -> Self {
        Self {
            strike: Strike { speed, azimuth, elevation: elevation.unwrap_or(0.0), side, height },
            has_elevation: elevation.is_some(),
            cue_ball: None,
            call: "nothing".to_owned(),
            ball: None,
            pocket: None,
            policy: StrikePolicy::default(),
            cling: Cling::NONE,
        }
    }

    /// Sets the place of a cue ball in hand, m.
    #[wasm_bindgen(js_name = setCueBall)]
    pub fn set_cue_ball(&mut self, x: f64, y: f64) {
        self.cue_ball = Some([x, y]);
    }

    /// Sets the call: its kind, and the ball and the pocket that it names.
    #[wasm_bindgen(js_name = setCall)]
    pub fn set_call(&mut self, kind: String, ball: Option<String>, pocket: Option<String>) {
        (self.call, self.ball, self.pocket) = (kind, ball, pocket);
    }

    /// Sets the policies for a strike that a player could not play cleanly, by name.
    #[wasm_bindgen(js_name = setPolicy)]
    pub fn set_policy(&mut self, obstruction: &str, miscue: &str) -> Result<(), JsValue> {
        let policy = StrikePolicy::from_names(obstruction, miscue);
        self.policy = policy.map_err(|e| to_exception(&e))?;
        Ok(())
    }

    /// Sets the contacts that cling: JSON, as a shot file has them.
    #[wasm_bindgen(js_name = setCling)]
    pub fn set_cling(&mut self, json: &str) -> Result<(), JsValue> {
        let cling = Node::from_json(json).and_then(|node| Cling::from_node(&node));
        self.cling = cling.map_err(|e| to_exception(&e))?;
        Ok(())
    }
}

/// The ruling on a played shot, the strike and the contacts that cling as they were played, and the
/// trace.
#[wasm_bindgen]
pub struct PlayResult {
    ruling: String,
    play: Play,
    trace: carom::Trace,
}

#[wasm_bindgen]
impl PlayResult {
    /// The referee's ruling, JSON.
    pub fn ruling(&self) -> String {
        self.ruling.clone()
    }

    /// Speed, azimuth, elevation, side, height.
    pub fn strike(&self) -> Vec<f64> {
        let Strike { speed, azimuth, elevation, side, height } = self.play.strike;
        vec![speed, azimuth, elevation, side, height]
    }

    /// The contacts that cling, JSON as a shot file has them; none if no contact does.
    pub fn cling(&self) -> Option<String> {
        let cling = self.play.cling;
        (!cling.is_empty()).then(|| cling.to_node().to_json())
    }

    /// The trace of the shot.
    #[wasm_bindgen(js_name = intoTrace)]
    pub fn into_trace(self) -> Trace {
        Trace::from(self.trace)
    }
}

impl Frame {
    pub(crate) fn play_of(&self, arguments: &PlayArguments) -> Result<Play, Error> {
        let PlayArguments { call, ball, pocket, .. } = arguments;
        let PlayArguments { strike, cue_ball, policy, cling, .. } = *arguments;
        let call = self.0.call(call, ball.as_deref(), pocket.as_deref())?;
        let play = Play { strike, cue_ball, call, policy, cling };
        if arguments.has_elevation { Ok(play) } else { self.0.at_default_elevation(&play) }
    }

    /// Plays a shot, with the errors of a noise if there is one.
    fn play_checked(
        &mut self,
        arguments: &PlayArguments,
        errors: Option<(Noise, ErrorSeeds)>,
    ) -> Result<PlayResult, Error> {
        let meant = self.play_of(arguments)?;
        let play = match &errors {
            Some((noise, seeds)) => self.0.draw_play(&meant, noise, *seeds)?,
            None => meant,
        };
        let trace = self.0.shot(&play)?.simulate()?;
        let ruling = self.0.apply(&play, &trace)?;
        let play = match trace.shot().strike() {
            Some((_, strike)) if !arguments.has_elevation && errors.is_none() => {
                Play { strike: Strike { elevation: strike.elevation, ..play.strike }, ..play }
            }
            _ => play,
        };
        Ok(PlayResult { ruling: self.0.ruling_node(&ruling).to_json(), play, trace })
    }
}

#[wasm_bindgen]
impl Frame {
    /// Racks a frame. `table` and `physics` are JSON, as a shot file has them under these keys.
    #[wasm_bindgen(constructor)]
    pub fn new(
        game: &str,
        table: Option<String>,
        physics: Option<String>,
        seed: u64,
        points: i32,
        miss: bool,
        patience: u32,
    ) -> Result<Self, JsValue> {
        let read = |json: Option<String>| json.map(|text| Node::from_json(&text)).transpose();
        let frame = || {
            let options = Options { points, miss, patience };
            carom_rules::Frame::new(Game::read(game)?, options, read(table)?, read(physics)?, seed)
        };
        frame().map(Self).map_err(|e| to_exception(&e))
    }

    /// Table and physics as the record of a new frame keeps them, with dated names: JSON.
    #[wasm_bindgen(js_name = recordedSetup)]
    pub fn recorded_setup(
        game: &str,
        table: Option<String>,
        physics: Option<String>,
    ) -> Result<String, JsValue> {
        let read = |json: Option<String>| json.map(|text| Node::from_json(&text)).transpose();
        let setup = || {
            let game = Game::read(game)?;
            Ok(carom_rules::recorded_setup(game, read(table)?, read(physics)?).to_json())
        };
        setup().map_err(|e| to_exception(&e))
    }

    /// A frame that starts from the balls of a shot.
    #[wasm_bindgen(js_name = ofShot)]
    pub fn of_shot(
        game: &str,
        shot: &Shot,
        points: i32,
        miss: bool,
        patience: u32,
        player: Option<usize>,
    ) -> Result<Self, JsValue> {
        let options = Options { points, miss, patience };
        let frame = Game::read(game)
            .and_then(|game| carom_rules::Frame::of_shot(game, options, &shot.0, player));
        frame.map(Self).map_err(|e| to_exception(&e))
    }

    /// The player whose turn it is; none when the frame is over.
    pub fn player(&self) -> Option<usize> {
        self.0.player()
    }

    /// The state of the frame, JSON.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> String {
        self.0.to_node().to_json()
    }

    /// The box around the region in which the cue ball may be placed: left, bottom, right, top (m). None
    /// unless the cue ball is in hand.
    #[wasm_bindgen(js_name = handBounds)]
    pub fn hand_bounds(&self) -> Option<Vec<f64>> {
        Some(self.0.hand_bounds()?.as_flattened().to_vec())
    }

    /// The frame as text.
    pub fn describe(&self) -> String {
        self.0.describe()
    }

    /// The JSON Schema of an answer to the request, JSON.
    #[wasm_bindgen(js_name = answerSchema)]
    pub fn answer_schema(&self) -> String {
        self.0.answer_schema().to_json()
    }

    /// The shot that [`Self::play`] would play.
    pub fn shot(&self, play: &PlayArguments) -> Result<Shot, JsValue> {
        let shot = self.play_of(play).and_then(|play| self.0.shot(&play));
        shot.map(Shot::from).map_err(|e| to_exception(&e))
    }

    /// Plays a shot, and rules on it.
    pub fn play(&mut self, play: &PlayArguments) -> Result<PlayResult, JsValue> {
        self.play_checked(play, None).map_err(|e| to_exception(&e))
    }

    /// Plays a shot as a player with this execution noise does, and rules on it. `seeds`: one of the
    /// frame, or one of each seat.
    #[wasm_bindgen(js_name = playNoisy)]
    pub fn play_noisy(
        &mut self,
        play: &PlayArguments,
        noise: &str,
        seeds: &[u64],
    ) -> Result<PlayResult, JsValue> {
        let seeds = match *seeds {
            [seed] => ErrorSeeds::Frame(seed),
            [one, other] => ErrorSeeds::Seats([one, other]),
            _ => return Err(js_sys::RangeError::new("seed: write one or two numbers").into()),
        };
        let errors = Some((noise_of(noise)?, seeds));
        self.play_checked(play, errors).map_err(|e| to_exception(&e))
    }

    /// Answers the choice that the frame asks for; returns the ruling, JSON.
    pub fn choose(&mut self, choice: &str) -> Result<String, JsValue> {
        let chosen = Choice::read(choice).and_then(|choice| self.0.choose(choice));
        let ruling = chosen.map_err(|e| to_exception(&e))?;
        Ok(self.0.ruling_node(&ruling).to_json())
    }

    /// Concedes: the player whose turn it is loses. Returns the ruling, JSON.
    pub fn concede(&mut self) -> Result<String, JsValue> {
        let ruling = self.0.concede().map_err(|e| to_exception(&e))?;
        Ok(self.0.ruling_node(&ruling).to_json())
    }

    /// Sixteen hexadecimal digits over the whole state.
    pub fn hash(&self) -> String {
        format!("{:016x}", self.0.hash())
    }

    /// A copy that can be played on independently.
    pub fn copy(&self) -> Self {
        Self(self.0.clone())
    }
}
