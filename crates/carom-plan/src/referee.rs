//! Variants of a shot in a game: each is simulated once, and the frame rules on it.

use carom::batch::{BatchResult, OFF_TABLE, ON_TABLE, PADDING};
use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{BallState, Error, MotionState, Shot, Simulator};
use carom_rules::{Call, Frame, Play, Request};

use crate::error_model::ErrorModel;

/// A game in which the shot is played.
#[derive(Clone, Copy, Debug)]
pub struct Referee<'a> {
    /// The frame. The shot must be the one that it asks for.
    pub frame: &'a Frame,
    /// The player's call.
    pub call: Call,
}

/// A shot that its frame asks for.
pub(crate) struct Refereed<'a> {
    referee: Referee<'a>,
    shot: &'a Shot,
    /// Where the player places the cue ball, m, if it is in hand.
    place: Option<[f64; 2]>,
}

/// Numbers of variants with these rulings.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Verdicts {
    /// The shot was legal.
    pub(crate) legal: u64,
    /// The same player shoots again or has won.
    pub(crate) turn_kept: u64,
}

/// One variant: the end of every ball, and the frame's ruling.
struct RuledVariant {
    ends: Vec<(i8, [f64; 3])>,
    verdicts: Verdicts,
}

impl<'a> Refereed<'a> {
    /// Rejects a shot that `referee`'s frame does not ask for.
    pub(crate) fn new(shot: &'a Shot, referee: Referee<'a>) -> Result<Self, Error> {
        let mut refereed = Self { referee, shot, place: None };
        let Some((cue_ball, strike)) = shot.strike() else { return Ok(refereed) };
        let lies = shot.balls()[cue_ball].state.position;
        let in_hand = referee.frame.turn().is_some_and(|turn| turn.hand.is_some());
        refereed.place = in_hand.then_some([lies.x, lies.y]);
        let asked = referee.frame.shot(&refereed.play(strike))?;
        // The strike may differ, because the conversion of angles to degrees rounds them.
        if asked.balls() != shot.balls()
            || asked.table() != shot.table()
            || asked.physics() != shot.physics()
        {
            return Err(Error::input(
                "frame",
                "it asks for a shot with other balls, table or physics",
                "evaluate the shot that the frame gives: frame.shot(...)",
            ));
        }
        Ok(refereed)
    }

    fn play(&self, strike: Strike) -> Play {
        Play { strike, cue_ball: self.place, call: self.referee.call }
    }

    /// Plays each of `strikes`, on the layouts from number `first` on that the model's perception draws.
    pub(crate) fn simulate(
        &self,
        strikes: &[Strike],
        model: &ErrorModel,
        first: u64,
        runner: &Runner,
    ) -> (BatchResult, Verdicts) {
        let errors = model.errors();
        let played = runner.map(0..strikes.len(), Simulator::new, |simulator, k| {
            let struck = self.shot.strike().map(|(ball, _)| (ball, strikes[k]));
            let variant = errors.shot(self.shot, struck, first + k as u64)?;
            self.rule(simulator, strikes[k], &variant)
        });
        self.gather(played)
    }

    fn rule(
        &self,
        simulator: &mut Simulator,
        strike: Strike,
        shot: &Shot,
    ) -> Result<RuledVariant, Error> {
        let mut frame = self.referee.frame.clone();
        let player = frame.player();
        let (ruling, outcome, last) = frame.play_displaced(simulator, &self.play(strike), shot)?;
        let kept = match frame.request() {
            Request::Shot(turn) => Some(turn.player) == player,
            Request::Choice { .. } => false,
            Request::Over { winner, .. } => winner.is_some() && *winner == player,
        };
        let verdicts = Verdicts { legal: u64::from(ruling.is_legal()), turn_kept: u64::from(kept) };
        Ok(RuledVariant { ends: ends(shot, &outcome, &last), verdicts })
    }

    fn gather(&self, played: Vec<Result<RuledVariant, Error>>) -> (BatchResult, Verdicts) {
        let balls = self.shot.balls().len();
        let mut all = BatchResult { shots: played.len(), balls, ..BatchResult::default() };
        let mut verdicts = Verdicts::default();
        for (k, one) in played.into_iter().enumerate() {
            match one {
                Ok(RuledVariant { ends, verdicts: one }) => {
                    all.pocket.extend(ends.iter().map(|(pocket, _)| pocket));
                    all.final_position.extend(ends.iter().map(|(_, place)| place));
                    verdicts.legal += one.legal;
                    verdicts.turn_kept += one.turn_kept;
                }
                Err(error) => {
                    all.pocket.extend(std::iter::repeat_n(PADDING, balls));
                    all.final_position.extend(std::iter::repeat_n([f64::NAN; 3], balls));
                    all.errors.push((k, error));
                }
            }
        }
        (all, verdicts)
    }
}

/// The end of every ball: its pocket, numbered as in a batch, and its position.
fn ends(shot: &Shot, outcome: &Outcome, last: &[BallState]) -> Vec<(i8, [f64; 3])> {
    let pockets = &shot.table().pockets;
    let pocket = |ball: usize| {
        let fell = outcome.pocketed.iter().find(|(b, _)| usize::from(*b) == ball);
        fell.and_then(|(_, name)| pockets.iter().position(|pocket| pocket.name == *name))
    };
    last.iter()
        .enumerate()
        .map(|(ball, state)| {
            let end = match (state.motion, pocket(ball)) {
                (MotionState::OffTable, _) => OFF_TABLE,
                (_, Some(pocket)) => pocket as i8,
                (_, None) => ON_TABLE,
            };
            (end, state.position.to_array())
        })
        .collect()
}
