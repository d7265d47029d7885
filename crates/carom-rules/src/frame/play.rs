//! Playing a shot: the play is checked, simulated and ruled on.

use carom::event::Recorder;
use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::shot::{Policy, StrikePolicy};
use carom::{Error, ErrorKind, Noise, Shot, Summary, Trace};

use super::{Frame, FrameSimulator, Prepared};
use crate::execution::{ErrorSeeds, execute};
use crate::games::PlayedShot;
use crate::layout::FrameLayout;
use crate::play::{Call, Play, through_degrees};
use crate::referee::CueBallTravel;
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
        Ok(self.prepared(play)?.into_shot())
    }

    /// `play` as a player with the errors of `noise` executes it ([`execute`]): with the strike
    /// and the contacts that cling of the variant that `seeds` determine. So every shot of a frame
    /// has errors of its own. If `noise` has no cling, that of `play` remains.
    ///
    /// # Errors As [`Self::shot`] for the intended play, and as [`Noise::check`]. The drawn play
    /// can be played if the intended one can, except where the cue would pass through a ball or a
    /// rail and the policies refuse that.
    pub fn draw_play(&self, play: &Play, noise: &Noise, seeds: ErrorSeeds) -> Result<Play, Error> {
        noise.check()?;
        let turn = self.asked_turn()?;
        let draw = seeds.draw(turn.player, self.shots);
        let (strike, cling) = execute(noise, &self.shot(play)?, draw)?;
        let has_cling = noise.cling_probability > 0.0;
        let cling = if has_cling { cling } else { play.cling };
        Ok(Play { strike, cling, ..*play })
    }

    /// `play` at the default elevation of its strike ([`Shot::default_elevation`]). The elevation
    /// in `play` is not used.
    ///
    /// # Errors
    /// As [`Self::shot`].
    pub fn at_default_elevation(&self, play: &Play) -> Result<Play, Error> {
        let strike = Strike { elevation: 0.0, ..play.strike };
        // A level cue may be obstructed where the raised one is not.
        let policy = StrikePolicy { obstruction: Policy::Report, ..play.policy };
        let prepared = self.prepared(&Play { strike, policy, ..*play })?;
        let elevation = prepared.shot().default_elevation(&strike);
        Ok(Play { strike: Strike { elevation, ..strike }, ..*play })
    }

    /// The shot of `play`.
    fn prepared(&self, play: &Play) -> Result<Prepared<'_>, Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        Prepared::of_play(self, play)
    }

    /// The balls before the shot of `turn`, with a cue ball in hand at `cue_ball`.
    pub(super) fn layout_with(
        &self,
        turn: &Turn,
        cue_ball: Option<[f64; 2]>,
    ) -> Result<FrameLayout, Error> {
        let mut layout = self.state.layout.clone();
        let place = cue_ball.or_else(|| layout.place(turn.cue));
        self.check_cue_ball(turn, cue_ball, place)?;
        layout.put(turn.cue, place);
        Ok(layout)
    }

    /// The shot that the frame asks for.
    pub(super) fn asked_turn(&self) -> Result<&Turn, Error> {
        self.turn().ok_or_else(|| {
            ErrorKind::WrongState.at(
                "play",
                "the frame does not ask for a shot now",
                "look at its request: answer the choice, or begin a new frame",
            )
        })
    }

    pub(super) fn check_call(&self, turn: &Turn, call: Call) -> Result<(), Error> {
        let calls = &turn.calls;
        let wrong = |kind: ErrorKind, what: &str, remedy: &str| Err(kind.at("call", what, remedy));
        match call {
            Call::Nothing if calls.required => wrong(
                ErrorKind::NoCall,
                "nothing is called",
                "call a ball and its pocket, or a safety",
            ),
            Call::Nothing if calls.nominate => wrong(
                ErrorKind::NoNomination,
                "no ball is nominated",
                "nominate one of the balls on",
            ),
            Call::Pocket(ball, _) => {
                if !calls.pocket {
                    return wrong(
                        ErrorKind::NotCalled,
                        "this shot is not called",
                        "leave the call out",
                    );
                }
                if ball == turn.cue || self.state.layout.is_down(ball) {
                    return wrong(
                        ErrorKind::CalledBallDown,
                        "the called ball is not on the table",
                        "call an object ball that is",
                    );
                }
                Ok(())
            }
            Call::Safety if !calls.safety => wrong(
                ErrorKind::NoSafety,
                "a safety is not called in this shot",
                "leave the call out",
            ),
            Call::PushOut if !calls.push_out => wrong(
                ErrorKind::NoPushOut,
                "a push-out is allowed only in the first shot after a legal break",
                "leave the call out",
            ),
            Call::On(ball) if !calls.nominate || !turn.on.contains(&ball) => wrong(
                ErrorKind::WrongNomination,
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
        let wrong =
            |kind: ErrorKind, what: String, remedy: &str| Err(kind.at("cue_ball", what, remedy));
        let Some(region) = turn.hand else {
            return match put {
                Some(_) => wrong(
                    ErrorKind::NotInHand,
                    "the cue ball is not in hand".into(),
                    "play it where it lies",
                ),
                None => Ok(()),
            };
        };
        let Some(place) = place else {
            return wrong(
                ErrorKind::NoPlace,
                "the cue ball is in hand".into(),
                "give the place where it is put",
            );
        };
        if !region.holds(self.state.base.table(), place) {
            let table = self.state.base.table();
            let what = format!("[{:?}, {:?}] is not {}", place[0], place[1], region.words());
            let remedy = format!("put it {}", region.limits(table));
            let error = ErrorKind::OutsideRegion.at("cue_ball", what, remedy);
            return Err(error.with("region", region.name()));
        }
        // A cue ball that is not moved may stay where it lies, even if it touches another ball.
        if put.is_some() && !self.state.layout.is_free(turn.cue, place) {
            return wrong(
                ErrorKind::TouchesBall,
                "it would touch another ball".into(),
                "put it where there is room",
            );
        }
        Ok(())
    }

    /// Plays a shot: simulates it, rules on it, and updates the request. Balls of the outcome are
    /// indices of the frame.
    ///
    /// # Errors
    /// As [`Self::shot`], and if the simulation reaches its limit of events. The frame is unchanged
    /// then.
    pub fn play(&mut self, play: &Play) -> Result<(Ruling, Outcome), Error> {
        self.play_in(&mut FrameSimulator::new(), play)
    }

    /// As [`Self::play`], with the memory of a simulator that is used many times.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_in(
        &mut self,
        simulator: &mut FrameSimulator,
        play: &Play,
    ) -> Result<(Ruling, Outcome), Error> {
        let prepared = self.prepared(play)?;
        simulator.simulate(&prepared, &through_degrees(&play.strike))?;
        let mut successor = self.clone();
        let ruling = simulator.rule_on(&prepared, play.call, &mut successor);
        *self = successor;
        Ok((ruling, simulator.outcome().clone()))
    }

    /// As [`Self::play_in`], with a strike that is played to the last bit, in `shot`: what
    /// [`Self::shot`] returned for the same place of the cue ball, or a variant of it in which the
    /// balls are displaced a little (errors of perception) or other contacts cling. `recorder` gets
    /// every event. The outcome and the final states are those of `simulator`.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_displaced(
        &mut self,
        simulator: &mut FrameSimulator,
        play: &Play,
        shot: &Shot,
        recorder: &mut dyn Recorder,
    ) -> Result<(Ruling, Summary), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        let prepared = Prepared::with_shot(self, play.cue_ball, shot)?;
        let summary = simulator.simulate_shot_recorded(&prepared, shot, &play.strike, recorder)?;
        let mut successor = self.clone();
        let ruling = simulator.rule_on(&prepared, play.call, &mut successor);
        *self = successor;
        Ok((ruling, summary))
    }

    /// Rules on a shot that was simulated elsewhere: `trace` is the trace of the shot that
    /// [`Self::shot`] returns for `play`. A trace does not hold all that a referee needs, so the
    /// shot is simulated again.
    ///
    /// # Errors
    /// As [`Self::play`], and [`Error::Input`] if `trace` belongs to another shot.
    pub fn apply(&mut self, play: &Play, trace: &Trace) -> Result<Ruling, Error> {
        if *trace.shot() != self.shot(play)? {
            return Err(ErrorKind::Mismatch.at(
                "trace",
                "it belongs to another shot than the one that is played",
                "simulate the shot that the frame returns for this play",
            ));
        }
        self.play(play).map(|(ruling, _)| ruling)
    }

    /// Rules on a shot with this outcome, in the frame's ball indices. The balls already are where
    /// they came to rest.
    pub(crate) fn decide(
        &mut self,
        turn: &Turn,
        call: Call,
        outcome: &Outcome,
        travel: &CueBallTravel,
        before: &FrameLayout,
    ) -> Ruling {
        let shot = PlayedShot { turn, call, outcome, travel, before };
        let request = self.game_state.rules_mut().judge(&mut self.state, &shot);
        self.settle(request, Some(turn.player))
    }
}
