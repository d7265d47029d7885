//! A shot that a frame asks for, ready to be simulated.

use std::borrow::Cow;

use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind, Shot};

use super::Frame;
use crate::layout::{BallList, FrameLayout};
use crate::play::{Play, through_degrees};
use crate::request::Turn;

/// Stands in a prepared shot until a strike is given: a level strike at the centre.
const PLACEHOLDER: Strike =
    Strike { speed: 1.0, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };

/// The shot that a frame asks for, with the cue ball at its place. It is built once and can be
/// simulated with any strike ([`FrameSimulator`](crate::FrameSimulator)).
#[derive(Clone, Debug)]
pub struct Prepared<'a> {
    frame: &'a Frame,
    turn: Turn,
    shot: Cow<'a, Shot>,
    /// The frame's index of each ball of the shot.
    balls: BallList,
    /// The balls before the shot, with a cue ball in hand where it was placed.
    before: FrameLayout,
}

impl<'a> Prepared<'a> {
    /// The shot that `frame` asks for, under the usual policies for strikes. `cue_ball` is the
    /// place of a cue ball in hand: its centre (file coordinates, m).
    ///
    /// # Errors
    /// [`Error::Input`] if the frame does not ask for a shot, and if the cue ball is placed where
    /// it must not be.
    pub fn new(frame: &'a Frame, cue_ball: Option<[f64; 2]>) -> Result<Self, Error> {
        Self::with_base(frame, cue_ball, frame.base(), PLACEHOLDER)
    }

    /// As [`Self::new`], with the strike of `play`, under its policies and with its contacts that
    /// cling. Its call is not used.
    ///
    /// # Errors
    /// As [`Self::new`], and for a strike that a shot file could not have under these policies.
    pub fn of_play(frame: &'a Frame, play: &Play) -> Result<Self, Error> {
        let (mut base, strike) = (Cow::Borrowed(frame.base()), through_degrees(&play.strike));
        if play.policy != base.strike_policy() {
            base = Cow::Owned(base.with_strike_policy(play.policy)?);
        }
        if !play.cling.is_empty() {
            base = Cow::Owned(base.with_cling(play.cling));
        }
        Self::with_base(frame, play.cue_ball, &base, strike)
    }

    /// As [`Self::new`], on the table, with the physics, policies and cling of `base`.
    fn with_base(
        frame: &'a Frame,
        cue_ball: Option<[f64; 2]>,
        base: &Shot,
        strike: Strike,
    ) -> Result<Self, Error> {
        let turn = *frame.asked_turn()?;
        let before = frame.layout_with(&turn, cue_ball)?;
        let cue = before.on_table().position(|ball| ball == turn.cue).unwrap_or_default();
        let shot = base.with_balls(before.placed(), Some((cue, strike)));
        let shot = Cow::Owned(shot.map_err(|error| at_cue_ball(error, cue))?);
        let balls = before.on_table().collect();
        Ok(Self { frame, turn, shot, balls, before })
    }

    /// As [`Self::new`], with a `shot` that was made before: [`Frame::shot`] of the same frame and
    /// the same place of the cue ball.
    ///
    /// # Errors As [`Self::new`], and [`Error::Input`] if `shot` has another number of balls, or
    /// an end time.
    pub fn with_shot(
        frame: &'a Frame,
        cue_ball: Option<[f64; 2]>,
        shot: &'a Shot,
    ) -> Result<Self, Error> {
        let turn = *frame.asked_turn()?;
        if shot.until().is_some() {
            let what =
                "the shot has an end time, but the rules judge it when all balls are at rest";
            return Err(ErrorKind::Conflict.at("until", what, "leave it out"));
        }
        let before = frame.layout_with(&turn, cue_ball)?;
        let balls: BallList = before.on_table().collect();
        if balls.len() != shot.balls().len() {
            let what = format!("it has {} balls, the frame {}", shot.balls().len(), balls.len());
            return Err(ErrorKind::WrongCount.at(
                "shot",
                what,
                "give the shot that the frame returns",
            ));
        }
        Ok(Self { frame, turn, shot: Cow::Borrowed(shot), balls, before })
    }

    /// The frame that asks for the shot.
    pub const fn frame(&self) -> &'a Frame {
        self.frame
    }

    /// The frame's request.
    pub const fn turn(&self) -> &Turn {
        &self.turn
    }

    /// The shot. Its strike is only a placeholder, except after [`Self::of_play`].
    pub fn shot(&self) -> &Shot {
        &self.shot
    }

    /// As [`Self::shot`], without the rest.
    pub(super) fn into_shot(self) -> Shot {
        self.shot.into_owned()
    }

    /// The struck ball under the policies of the shot, for drawing errors of its strike.
    pub fn struck_ball(&self) -> StruckBall {
        let ball = self.shot.cue_ball().unwrap_or_default();
        StruckBall::of(&self.shot, &self.shot.balls()[ball].ball)
    }

    /// The frame's index of each ball of the shot.
    pub fn balls(&self) -> &[crate::BallIndex] {
        &self.balls
    }

    /// Where a cue ball in hand was placed (file coordinates, m); none if it is played where it
    /// lies.
    pub fn cue_ball(&self) -> Option<[f64; 2]> {
        self.turn.hand.and_then(|_| self.before.place(self.turn.cue))
    }

    /// The balls before the shot, with a cue ball in hand where it was placed.
    pub const fn before(&self) -> &FrameLayout {
        &self.before
    }
}

/// An error at the place of ball `cue` of a shot, as an error at the play's `cue_ball`.
fn at_cue_ball(error: Error, cue: usize) -> Error {
    match error {
        Error::Input(ref e) if e.place == format!("balls[{cue}].position") => error.at("cue_ball"),
        other => other,
    }
}
