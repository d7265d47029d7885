//! Variants of a shot in a game: simulated once, counted and ruled on.

use carom::batch::{BatchResult, OFF_TABLE, ON_TABLE, PADDING};
use carom::noise::Perception;
use carom::outcome::Outcome;
use carom::resolve::cue_ball::Strike;
use carom::{BallState, Error, MotionState, Shot, Simulator};
use carom_rules::{Call, Frame, Play, Request};
use rayon::prelude::*;

use crate::threads::Threads;

/// A game in which the shot is played.
#[derive(Clone, Copy, Debug)]
pub struct Referee<'a> {
    /// The frame; it asks for the shot.
    pub frame: &'a Frame,
    /// What the player announces.
    pub call: Call,
}

/// A shot as its frame asks for it.
pub(crate) struct Refereed<'a> {
    referee: Referee<'a>,
    shot: &'a Shot,
    /// Where the player puts the cue ball, if it is in hand.
    place: Option<[f64; 2]>,
}

/// In how many variants.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Verdicts {
    /// The shot was legal.
    pub(crate) legal: u64,
    /// It is the same player's turn again, or they have won.
    pub(crate) turn_kept: u64,
}

/// One variant: where every ball ended, and what the frame says of it.
struct Ruled {
    ends: Vec<(i8, [f64; 3])>,
    verdicts: Verdicts,
}

impl<'a> Refereed<'a> {
    /// Refuses a shot that `referee`'s frame does not ask for.
    pub(crate) fn new(shot: &'a Shot, referee: Referee<'a>) -> Result<Self, Error> {
        let mut refereed = Self { referee, shot, place: None };
        let Some((cue_ball, strike)) = shot.strike() else { return Ok(refereed) };
        let lies = shot.balls()[cue_ball].state.position;
        let in_hand = referee.frame.turn().is_some_and(|turn| turn.hand.is_some());
        refereed.place = in_hand.then_some([lies.x, lies.y]);
        let asked = referee.frame.shot(&refereed.play(strike))?;
        // The strike's angles may differ by the rounding of degrees.
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

    /// Plays each of `strikes`, on the layouts number `first`.. that `perception` draws.
    pub(crate) fn simulate(
        &self,
        strikes: &[Strike],
        perception: &Perception,
        seed: u64,
        first: u64,
        threads: &Threads,
    ) -> (BatchResult, Verdicts) {
        let played: Vec<Result<Ruled, Error>> = threads.run(|| {
            (0..strikes.len())
                .into_par_iter()
                .map_init(
                    || Simulator::new(),
                    |simulation, k| {
                        if perception.position == 0.0 {
                            return self.rule(simulation, strikes[k], self.shot);
                        }
                        let places = perception.places(self.shot, seed, first + k as u64);
                        let struck = self.shot.strike().map(|(ball, _)| (ball, strikes[k]));
                        let shot = self.shot.with_balls(places, struck)?;
                        self.rule(simulation, strikes[k], &shot)
                    },
                )
                .collect()
        });
        self.gathered(played)
    }

    fn rule(
        &self,
        simulation: &mut Simulator,
        strike: Strike,
        shot: &Shot,
    ) -> Result<Ruled, Error> {
        let mut frame = self.referee.frame.clone();
        let player = frame.player();
        let (ruling, outcome, last) = frame.play_displaced(simulation, &self.play(strike), shot)?;
        let kept = match frame.request() {
            Request::Shot(turn) => Some(turn.player) == player,
            Request::Choice { .. } => false,
            Request::Over { winner, .. } => winner.is_some() && *winner == player,
        };
        let verdicts = Verdicts { legal: u64::from(ruling.is_legal()), turn_kept: u64::from(kept) };
        Ok(Ruled { ends: ends(shot, &outcome, &last), verdicts })
    }

    fn gathered(&self, played: Vec<Result<Ruled, Error>>) -> (BatchResult, Verdicts) {
        let balls = self.shot.balls().len();
        let mut all = BatchResult { shots: played.len(), balls, ..BatchResult::default() };
        let mut verdicts = Verdicts::default();
        for (k, one) in played.into_iter().enumerate() {
            match one {
                Ok(Ruled { ends, verdicts: one }) => {
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

/// The pocket of every ball, as batches have it, and where it ended.
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
