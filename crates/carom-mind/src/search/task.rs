//! What a search is asked.

use carom::{Error, ErrorKind, Noise};
use carom_rules::{Frame, Request, Seat, Turn};

use crate::player::{Budget, Situation};
use crate::settings::SearchSettings;
use crate::value::Value;

/// The shot of a request, and the value by which its plays are judged.
#[derive(Clone, Copy)]
pub(crate) struct ShotTask<'a> {
    pub(crate) situation: &'a Situation<'a>,
    pub(crate) turn: &'a Turn,
    pub(crate) value: &'a dyn Value,
}

impl<'a> ShotTask<'a> {
    /// The shot of the situation's request.
    ///
    /// # Errors
    /// As [`Situation::asked`], and [`Error::Input`] at `frame` if it asks for a choice.
    pub(crate) fn new(situation: &'a Situation<'a>, value: &'a dyn Value) -> Result<Self, Error> {
        let Request::Shot(turn) = situation.asked()?.1 else {
            let what = "it asks for a choice, not for a shot";
            return Err(ErrorKind::WrongState.at("frame", what, "let the player choose"));
        };
        Ok(Self { situation, turn, value })
    }

    pub(crate) const fn frame(&self) -> &'a Frame {
        self.situation.frame
    }

    pub(crate) const fn seat(&self) -> Seat {
        self.turn.player
    }

    /// The errors of the player's strikes.
    pub(crate) const fn noise(&self) -> &'a Noise {
        &self.situation.noise[self.turn.player]
    }

    /// The radius of the cue ball, m.
    pub(crate) fn cue_radius(&self) -> f64 {
        self.frame().layout().balls()[usize::from(self.turn.cue)].ball.radius
    }
}

/// What is searched, and how.
#[derive(Clone, Copy)]
pub(crate) struct SearchTask<'a> {
    pub(crate) shot: ShotTask<'a>,
    pub(crate) settings: &'a SearchSettings,
    pub(crate) budget: &'a Budget<'a>,
}
