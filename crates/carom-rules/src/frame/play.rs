//! Playing a shot: the play is checked, simulated and ruled on.

use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::shot::PlacedBall;
use carom::{BallState, Error, MotionState, Shot, Simulator, Trace};

use super::Frame;
use crate::games::PlayedShot;
use crate::layout::FrameLayout;
use crate::play::{Call, Play, through_degrees};
use crate::referee::{CueBallTravel, RefereeRecorder, renumbered};
use crate::request::Turn;
use crate::ruling::Ruling;

impl Frame {
    /// The shot of `play`, ready to simulate.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame does not ask for a shot, if the call is missing or not
    /// allowed, if the cue ball is placed where it must not be, and for a strike that a shot file
    /// could not have.
    pub fn shot(&self, play: &Play) -> Result<Shot, Error> {
        let (balls, cue) = self.balls_of(play)?;
        let strike = through_degrees(&play.strike);
        let shot = self.state.base.with_balls(balls, Some((cue, strike)));
        shot.map_err(|error| at_cue_ball(error, cue))
    }

    /// `play` at the default elevation of its strike ([`Shot::default_elevation`]). The elevation in
    /// `play` is not used.
    ///
    /// # Errors
    /// As [`Self::shot`].
    pub fn at_default_elevation(&self, play: &Play) -> Result<Play, Error> {
        let (balls, cue) = self.balls_of(play)?;
        let strike = Strike { elevation: 0.0, ..play.strike };
        let shot = self.state.base.with_balls(balls, Some((cue, strike)));
        let shot = shot.map_err(|error| at_cue_ball(error, cue))?;
        let elevation = shot.default_elevation(&strike);
        Ok(Play { strike: Strike { elevation, ..strike }, ..*play })
    }

    /// The balls of `play`, and the index of the struck ball among them.
    fn balls_of(&self, play: &Play) -> Result<(Vec<PlacedBall>, usize), Error> {
        let turn = self.asked_turn()?;
        self.check_call(turn, play.call)?;
        let mut layout = self.state.layout.clone();
        let place = play.cue_ball.or_else(|| layout.place(turn.cue));
        self.check_cue_ball(turn, play.cue_ball, place)?;
        layout.put(turn.cue, place);
        let cue = layout.on_table().position(|ball| ball == turn.cue).unwrap_or_default();
        Ok((layout.placed(), cue))
    }

    /// The shot that the frame asks for.
    fn asked_turn(&self) -> Result<&Turn, Error> {
        self.turn().ok_or_else(|| {
            Error::input(
                "play",
                "the frame does not ask for a shot now",
                "look at its request: answer the choice, or begin a new frame",
            )
        })
    }

    fn check_call(&self, turn: &Turn, call: Call) -> Result<(), Error> {
        let calls = &turn.calls;
        let wrong = |what: &str, remedy: &str| Err(Error::input("call", what, remedy));
        match call {
            Call::Nothing if calls.required => {
                wrong("nothing is called", "call a ball and its pocket, or a safety")
            }
            Call::Nothing if calls.nominate => {
                wrong("no ball is nominated", "nominate one of the balls on")
            }
            Call::Pocket(ball, _) => {
                if !calls.pocket {
                    return wrong("this shot is not called", "leave the call out");
                }
                if ball == turn.cue || self.state.layout.is_down(ball) {
                    return wrong(
                        "the called ball is not on the table",
                        "call an object ball that is",
                    );
                }
                Ok(())
            }
            Call::Safety if !calls.safety => {
                wrong("a safety is not called in this shot", "leave the call out")
            }
            Call::PushOut if !calls.push_out => wrong(
                "a push-out is allowed only in the first shot after a legal break",
                "leave the call out",
            ),
            Call::On(ball) if !calls.nominate || !turn.on.contains(&ball) => wrong(
                "that ball cannot be nominated",
                "nominate one of the balls on, if the frame asks for it",
            ),
            _ => Ok(()),
        }
    }

    fn check_cue_ball(
        &self,
        turn: &Turn,
        put: Option<[f64; 2]>,
        place: Option<[f64; 2]>,
    ) -> Result<(), Error> {
        let wrong = |what: String, remedy: &str| Err(Error::input("cue_ball", what, remedy));
        let Some(region) = turn.hand else {
            return match put {
                Some(_) => wrong("the cue ball is not in hand".into(), "play it where it lies"),
                None => Ok(()),
            };
        };
        let Some(place) = place else {
            return wrong("the cue ball is in hand".into(), "give the place where it is put");
        };
        if !region.holds(self.state.base.table(), place) {
            let what = format!("[{:?}, {:?}] is not {}", place[0], place[1], region.words());
            return wrong(what, "put it there");
        }
        // A cue ball that is not moved may stay where it lies, even if it touches another ball.
        if put.is_some() && !self.state.layout.is_free(turn.cue, place) {
            return wrong("it would touch another ball".into(), "put it where there is room");
        }
        Ok(())
    }

    /// Plays a shot: simulates it, rules on it, and updates the request.
    ///
    /// # Errors
    /// As [`Self::shot`], and if the simulation reaches its limit of events. The frame is unchanged
    /// then.
    pub fn play(&mut self, play: &Play) -> Result<(Ruling, Outcome), Error> {
        self.play_in(&mut Simulator::new(), play)
    }

    /// As [`Self::play`], with the memory of a simulator that is used many times.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_in(
        &mut self,
        simulator: &mut Simulator,
        play: &Play,
    ) -> Result<(Ruling, Outcome), Error> {
        let shot = self.shot(play)?;
        let (ruling, outcome, _) = self.play_shot(simulator, play, &shot, shot.strike())?;
        Ok((ruling, outcome))
    }

    /// As [`Self::play_in`], with a shot that was prepared before: `prepared` is what
    /// [`Self::shot`] returned for the same place of the cue ball, with any strike and any call.
    /// For programs that simulate the intended strike first, and then choose the call or add errors
    /// to the strike.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_prepared(
        &mut self,
        simulator: &mut Simulator,
        play: &Play,
        prepared: &Shot,
    ) -> Result<(Ruling, Outcome), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        let shot = prepared.with_strike(&through_degrees(&play.strike))?;
        let (ruling, outcome, _) = self.play_shot(simulator, play, &shot, shot.strike())?;
        Ok((ruling, outcome))
    }

    /// As [`Self::play_prepared`], with a strike that is played to the last bit and with balls that
    /// may be displaced a little from their places in the frame (errors of perception). Also
    /// returns the final states (file frame, in the order of `prepared`), before any ball was
    /// spotted.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_displaced(
        &mut self,
        simulator: &mut Simulator,
        play: &Play,
        prepared: &Shot,
    ) -> Result<(Ruling, Outcome, Vec<BallState>), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        prepared.resolve_strike(&play.strike)?;
        let strike = prepared.strike().map(|(ball, _)| (ball, play.strike));
        self.play_shot(simulator, play, prepared, strike)
    }

    /// Rules on a shot that was simulated elsewhere: `trace` is the trace of the shot that
    /// [`Self::shot`] returns for `play`. A trace does not hold all that a referee needs, so the
    /// shot is simulated again.
    ///
    /// # Errors
    /// As [`Self::play`], and [`Error::Input`] if `trace` belongs to another shot.
    pub fn apply(&mut self, play: &Play, trace: &Trace) -> Result<Ruling, Error> {
        if *trace.shot() != self.shot(play)? {
            return Err(Error::input(
                "trace",
                "it belongs to another shot than the one that is played",
                "simulate the shot that the frame returns for this play",
            ));
        }
        let shot = trace.shot();
        let played = self.play_shot(&mut Simulator::new(), play, shot, shot.strike())?;
        Ok(played.0)
    }

    /// Simulates `shot` with `strike`, the shot of `play`, and rules on it. Also returns the final
    /// states (file frame).
    fn play_shot(
        &mut self,
        simulator: &mut Simulator,
        play: &Play,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
    ) -> Result<(Ruling, Outcome, Vec<BallState>), Error> {
        let turn = self.asked_turn()?.clone();
        let mut recorder = RefereeRecorder::new(shot);
        let summary = simulator.play_strike(shot, strike, &mut recorder)?;
        let last: Vec<BallState> = simulator.states(summary.duration).collect();

        let layout = &mut self.state.layout;
        layout.put(turn.cue, play.cue_ball.or_else(|| layout.place(turn.cue)));
        let mut balls = Vec::with_capacity(layout.len());
        balls.extend(layout.on_table());
        let before = layout.clone();
        let (outcome, travel) = recorder.finish(&last, 0.5 * shot.table().size.y);
        let last: Vec<BallState> =
            (0..).zip(&last).map(|(i, state)| shot.to_file_frame(i, state)).collect();
        for (&ball, state) in balls.iter().zip(&last) {
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            layout.put(ball, (!gone).then_some([state.position.x, state.position.y]));
        }
        let of_frame = renumbered(&outcome, &balls);
        Ok((self.decide(&turn, play, &of_frame, &travel, &before), outcome, last))
    }

    /// Rules on a shot with this outcome, in the frame's ball indices. The balls already are where
    /// they came to rest.
    pub(crate) fn decide(
        &mut self,
        turn: &Turn,
        play: &Play,
        outcome: &Outcome,
        travel: &CueBallTravel,
        before: &FrameLayout,
    ) -> Ruling {
        let shot = PlayedShot { turn, play, outcome, travel, before };
        let request = self.game_state.rules_mut().judge(&mut self.state, &shot);
        self.settle(request, 1)
    }
}

/// An error at the place of ball `cue` of a shot, as an error at the play's `cue_ball`.
fn at_cue_ball(error: Error, cue: usize) -> Error {
    match error {
        Error::Input(e) if e.place == format!("balls[{cue}].position") => {
            Error::input("cue_ball", e.what, e.remedy)
        }
        other => other,
    }
}
