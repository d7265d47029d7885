//! Playing a shot: what is asked is checked, what happened is ruled on.

use carom::limits::SMALL_CAPACITY;
use carom::math::{degrees, radians};
use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::simulate::Simulation;
use carom::{BallState, Error, MotionState, Shot, Trace};

use super::Frame;
use crate::BallIndex;
use crate::facts::{Facts, Witness};
use crate::games::Played;
use crate::layout::Layout;
use crate::play::{Call, Play};
use crate::request::Turn;
use crate::ruling::Ruling;

/// The strike with the angles that come back from degrees. Recorded frames were played so, when shot
/// files held degrees alone, and must replay to the bit.
fn through_degrees(strike: &Strike) -> Strike {
    let through = |angle: f64| radians(degrees(angle));
    Strike { azimuth: through(strike.azimuth), elevation: through(strike.elevation), ..*strike }
}

impl Frame {
    /// The shot that `play` is, ready to simulate.
    ///
    /// # Errors
    /// [`Error::Input`] if no shot is asked, for a call that is missing or not to be made, for a cue
    /// ball put where it must not be, and for a strike that a shot file would be refused for.
    pub fn shot(&self, play: &Play) -> Result<Shot, Error> {
        let turn = self.asked_turn()?;
        self.check_call(turn, play.call)?;
        let mut layout = self.state.layout.clone();
        let place = play.cue_ball.or_else(|| layout.place(turn.cue));
        self.check_cue_ball(turn, play.cue_ball, place)?;
        layout.put(turn.cue, place);
        let cue = layout.on_table().position(|ball| ball == turn.cue).unwrap_or_default();
        let strike = through_degrees(&play.strike);
        let shot = self.state.base.with_balls(layout.placed(), Some((cue, strike)));
        shot.map_err(|error| of_cue_ball(error, cue))
    }

    fn asked_turn(&self) -> Result<&Turn, Error> {
        self.turn().ok_or_else(|| {
            Error::input(
                "play",
                "no shot is asked now",
                "look at the frame's request: answer the choice, or begin a new frame",
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
                    return wrong("no ball is called in this shot", "leave the call out");
                }
                let known = usize::from(ball) < self.state.layout.len() && ball != turn.cue;
                if !known || self.state.layout.is_down(ball) {
                    return wrong(
                        "the called ball is not on the table",
                        "call an object ball that is",
                    );
                }
                Ok(())
            }
            Call::Safety if !calls.safety => {
                wrong("no safety is called in this shot", "leave the call out")
            }
            Call::PushOut if !calls.push_out => wrong(
                "a push-out is allowed in the first shot after a legal break alone",
                "leave the call out",
            ),
            Call::On(ball) if !calls.nominate || !turn.on.contains(&ball) => wrong(
                "that ball cannot be nominated",
                "nominate one of the balls on, if it is asked",
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
            return wrong("the cue ball is in hand".into(), "say where it is put");
        };
        if !region.holds(self.state.base.table(), place) {
            let what = format!("[{:?}, {:?}] is not {}", place[0], place[1], region.words());
            return wrong(what, "put it there");
        }
        // Where it lies it may stay, even against another ball.
        if put.is_some() && !self.state.layout.is_free(turn.cue, place) {
            return wrong("it would touch another ball".into(), "put it where there is room");
        }
        Ok(())
    }

    /// Plays a shot: simulates it, rules, and asks anew.
    ///
    /// # Errors
    /// As [`Self::shot`], and if the simulation reaches its cap of events. The frame is unchanged then.
    pub fn play(&mut self, play: &Play) -> Result<(Ruling, Outcome), Error> {
        self.play_in(&mut Simulation::new(), play)
    }

    /// [`Self::play`] in a simulation that is used again and again.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_in(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        play: &Play,
    ) -> Result<(Ruling, Outcome), Error> {
        let shot = self.shot(play)?;
        let (ruling, outcome, _) = self.play_shot(simulation, play, &shot, shot.strike())?;
        Ok((ruling, outcome))
    }

    /// [`Self::play_in`] with a shot that is made already: what [`Self::shot`] gave for the same cue ball's
    /// place, whatever the strike and the call. For programs that look first at what a strike would do, and
    /// call, or err, accordingly.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_prepared(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        play: &Play,
        prepared: &Shot,
    ) -> Result<(Ruling, Outcome), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        let shot = prepared.with_strike(&through_degrees(&play.strike))?;
        let (ruling, outcome, _) = self.play_shot(simulation, play, &shot, shot.strike())?;
        Ok((ruling, outcome))
    }

    /// [`Self::play_prepared`] with the strike to the last bit, on balls that may lie a little beside where
    /// the frame has them. Tells as well where they came to rest, before any was spotted: the final states
    /// in the file's frame, in the order of `prepared`.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_beside(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        play: &Play,
        prepared: &Shot,
    ) -> Result<(Ruling, Outcome, Vec<BallState>), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        prepared.resolve_strike(&play.strike)?;
        let strike = prepared.strike().map(|(ball, _)| (ball, play.strike));
        self.play_shot(simulation, play, prepared, strike)
    }

    /// Rules on a shot that was simulated elsewhere: `trace` is of the shot that [`Self::shot`] gives for
    /// `play`. A trace does not keep all that a referee looks at, so the shot is played once more.
    ///
    /// # Errors
    /// As [`Self::play`], and [`Error::Input`] if `trace` is of another shot.
    pub fn apply(&mut self, play: &Play, trace: &Trace) -> Result<Ruling, Error> {
        if *trace.shot() != self.shot(play)? {
            return Err(Error::input(
                "trace",
                "it is of another shot than the one that is played",
                "simulate the shot that the frame gives for this play",
            ));
        }
        let shot = trace.shot();
        let played = self.play_shot(&mut Simulation::new(), play, shot, shot.strike())?;
        Ok(played.0)
    }

    /// `shot` with this strike is the shot that `play` is. The last are the final states, in the file's
    /// frame.
    fn play_shot(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        play: &Play,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
    ) -> Result<(Ruling, Outcome, Vec<BallState>), Error> {
        let turn = self.asked_turn()?.clone();
        let mut witness = Witness::new(shot);
        let summary = simulation
            .play_strike(shot, strike, &mut witness)
            .map_err(|failure| shot.explain(failure, strike.as_ref().map(|(_, s)| s)))?;
        let last: Vec<BallState> =
            (0..shot.balls().len()).map(|i| simulation.state(i, summary.duration)).collect();

        let layout = &mut self.state.layout;
        layout.put(turn.cue, play.cue_ball.or_else(|| layout.place(turn.cue)));
        let balls: Vec<BallIndex> = layout.on_table().collect();
        let before = layout.clone();
        let (outcome, facts) = witness.finish(&balls, &last, 0.5 * shot.table().size.y);
        let last: Vec<BallState> =
            (0..).zip(&last).map(|(i, state)| shot.to_file_frame(i, state)).collect();
        for (&ball, state) in balls.iter().zip(&last) {
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            layout.put(ball, (!gone).then_some([state.position.x, state.position.y]));
        }
        Ok((self.decide(&turn, play, &facts, &before), outcome, last))
    }

    /// Rules on what happened; the balls already lie where they came to rest.
    pub(crate) fn decide(
        &mut self,
        turn: &Turn,
        play: &Play,
        facts: &Facts,
        before: &Layout,
    ) -> Ruling {
        let shot = Played { turn, play, facts, before };
        let request = self.law.game_mut().judge(&mut self.state, &shot);
        self.settle(request, 1)
    }
}

/// What is wrong with the cue ball's place, as such.
fn of_cue_ball(error: Error, cue: usize) -> Error {
    match error {
        Error::Input(e) if e.place == format!("balls[{cue}].position") => {
            Error::input("cue_ball", e.what, e.remedy)
        }
        other => other,
    }
}
