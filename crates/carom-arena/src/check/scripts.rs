//! Scripted frames: the referee plays both seats until a frame asks what a situation is about.

use core::f64::consts::PI;

use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind};
use carom_mind::breaks::BreakShot;
use carom_mind::{Answer, Budget, Decision, Player, Searcher, Situation, Spent};
use carom_rules::{Call, Choice, Foul, Frame, FrameSimulator, Play, Request, Turn};

use crate::arena_frame::{ArenaFrame, Ask, NextStep};

/// Speed of a strike that is to hit nothing, m/s: the cue ball rolls some centimetres.
const SOFT: f64 = 0.1;

/// Number of directions and places that are tried for such a strike.
const TRIES: u32 = 12;

/// Distance of the cue ball from the brown that hides all reds, m.
const BEHIND_BROWN: f64 = 0.001;

/// Simulated shots of a decision that the referee makes for a seat.
const SIMULATIONS: u64 = 150;

/// How the referee answers a request of a script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Step {
    /// The usual opening shot.
    Opening,
    /// A soft strike that hits no ball: a foul.
    Nothing,
    /// The same from behind the brown, so that all reds are hidden.
    BehindBrown,
    /// A soft strike that is announced as a push-out.
    PushOut,
    /// This choice.
    Choose(Choice),
    /// The decision of the searching player.
    Best,
}

impl Step {
    /// The answer in the frame of `ask`.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub(super) fn answer(self, ask: &Ask<'_>) -> Result<Answer, Error> {
        let frame = ask.situation.frame;
        let turn =
            || frame.turn().ok_or_else(|| unreachable_here("the frame does not ask for a shot"));
        Ok(match self {
            Self::Choose(choice) => Answer::Choice(choice),
            Self::Opening => Answer::Play(BreakShot::usual(frame).play(frame)?),
            Self::Nothing => Answer::Play(soft(frame, turn()?, call_of(frame, turn()?))?),
            Self::PushOut => Answer::Play(soft(frame, turn()?, Call::PushOut)?),
            Self::BehindBrown => Answer::Play(behind_brown(frame, turn()?)?),
            Self::Best => best(&ask.situation)?,
        })
    }
}

/// Plays `steps` in `frame`, and then `last` again and again until `is_reached`. False if the frame
/// does not get there within `most` answers.
///
/// # Errors
/// Those of a frame that cannot be played.
pub(super) fn follow(
    frame: &mut ArenaFrame,
    steps: &[Step],
    most: usize,
    is_reached: fn(&Ask<'_>) -> bool,
    simulator: &mut FrameSimulator,
) -> Result<bool, Error> {
    for number in 0..=most {
        let answer = {
            let NextStep::Ask(ask) = frame.next() else { return Ok(false) };
            if number >= steps.len() && is_reached(&ask) {
                return Ok(true);
            }
            let step = match steps.get(number) {
                Some(step) => *step,
                None => Step::Best,
            };
            match step.answer(&ask) {
                Ok(answer) => answer,
                Err(Error::Input(_)) => return Ok(false),
                Err(other) => return Err(other),
            }
        };
        let decision = Decision { answer, win_chance: None, spent: Spent::default() };
        let refusals = frame.answer(simulator, &decision, 0.0)?;
        if matches!(refusals.effect, crate::Effect::Refused(_)) {
            return Ok(false);
        }
    }
    Ok(false)
}

fn unreachable_here(what: &str) -> Error {
    ErrorKind::WrongState.at("script", what, "begin with another rack")
}

fn best(situation: &Situation<'_>) -> Result<Answer, Error> {
    let budget = Budget::simulations(SIMULATIONS);
    Searcher::default().decide(situation, &budget).map(|decision| decision.answer)
}

/// A call that the rules allow; what is called does not matter.
fn call_of(frame: &Frame, turn: &Turn) -> Call {
    let calls = &turn.calls;
    let first = frame.layout().on_table().find(|ball| *ball != turn.cue);
    match (turn.on.first().copied().or(first), frame.base().table().pockets.first()) {
        (Some(ball), _) if calls.nominate => Call::On(ball),
        _ if !calls.required => Call::Nothing,
        _ if calls.safety => Call::Safety,
        (Some(ball), Some(pocket)) => Call::Pocket(ball, pocket.name),
        _ => Call::Nothing,
    }
}

/// A soft strike in a direction in which there is no ball.
fn soft(frame: &Frame, turn: &Turn, call: Call) -> Result<Play, Error> {
    let places = || {
        let bounds = turn.hand.map(|region| region.bounds(frame.base().table()));
        let of = move |k: u32| {
            let part = (f64::from(k) + 0.5) / f64::from(TRIES);
            bounds.map(|[low, high]| [0, 1].map(|axis| low[axis] + part * (high[axis] - low[axis])))
        };
        (0..TRIES).map(of)
    };
    let plays = places().flat_map(|cue_ball| {
        (0..TRIES).map(move |k| {
            let azimuth = 2.0 * PI * f64::from(k) / f64::from(TRIES);
            let strike = Strike { speed: SOFT, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
            Play { cue_ball, call, ..Play::new(strike) }
        })
    });
    plays
        .filter_map(|play| frame.at_default_elevation(&play).ok())
        .find(|play| hits_nothing(frame, play))
        .ok_or_else(|| unreachable_here("every strike hits a ball"))
}

fn hits_nothing(frame: &Frame, play: &Play) -> bool {
    let mut after = frame.clone();
    let ruling = after.play(play).map(|(ruling, _)| ruling);
    // A push-out may hit nothing.
    let is_free = play.call == Call::PushOut;
    ruling.is_ok_and(|ruling| is_free || ruling.fouls.has(Foul::NoContact))
}

/// The cue ball behind the brown, from where it hardly moves.
fn behind_brown(frame: &Frame, turn: &Turn) -> Result<Play, Error> {
    let brown = frame.ball("brown", "script")?;
    let layout = frame.layout();
    let [x, y] = layout.place(brown).ok_or_else(|| unreachable_here("the brown is down"))?;
    let radius = layout.balls()[usize::from(turn.cue)].ball.radius;
    let cue_ball = Some([x, y - 2.0 * radius - BEHIND_BROWN]);
    let azimuth = -0.5 * PI;
    let strike = Strike { speed: 0.02, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    let call = call_of(frame, turn);
    frame.at_default_elevation(&Play { cue_ball, call, ..Play::new(strike) })
}

/// Whether the frame asks for a choice.
pub(super) fn is_choice(ask: &Ask<'_>) -> bool {
    matches!(ask.situation.frame.request(), Request::Choice { .. })
}
