//! What all players of the literature share: from a request to a decision by the player's own
//! method.

use std::sync::Arc;

use carom::Error;
use carom_rules::{Choice, Play, Request, Seat};

use super::baseline::{Baseline, anything, carom, safety, usual_break};
use super::best_shots::{BestShots, COUNTED};
use super::pot_table::{PotTable, PotTables};
use crate::player::{Answer, Budget, Decision, Player, Situation, Spent};
use crate::value::{Position, Value};

/// A shot that tries to keep the turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attack {
    pub(crate) play: Play,
    /// Its probability of keeping the turn or winning.
    pub(crate) chance: f64,
}

/// What distinguishes the players. The settings of a player are its method.
pub trait Method: Send + Sync {
    /// The player's name.
    fn name(&self) -> String;

    /// The weights with which the best shots of a position are counted. Usually only the best one
    /// counts.
    fn weights(&self) -> [f64; COUNTED] {
        [1.0, 0.0, 0.0]
    }

    /// An attack that is less probable than this gives way to a better safety.
    fn safety_below(&self) -> f64;

    /// The player's attack; none if it finds none.
    ///
    /// # Errors
    /// As [`crate::Player::decide`].
    fn attack(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Option<Attack>, Error>;

    /// The break from one of the prepared places.
    ///
    /// # Errors
    /// As [`crate::Player::decide`].
    fn break_shot(
        &self,
        baseline: &Baseline<'_>,
        spent: &mut Spent,
    ) -> Result<Option<Play>, Error> {
        let _ = spent;
        Ok(usual_break(baseline))
    }
}

/// A player of the literature.
#[derive(Clone, Debug)]
pub struct Planner<M> {
    name: String,
    method: M,
    tables: PotTables,
}

impl<M: Method + Default> Default for Planner<M> {
    fn default() -> Self {
        Self::new(M::default())
    }
}

impl<M: Method> Planner<M> {
    /// A player with these settings.
    pub fn new(settings: M) -> Self {
        Self::with_tables(settings, PotTables::default())
    }

    pub(crate) fn with_tables(method: M, tables: PotTables) -> Self {
        Self { name: method.name(), method, tables }
    }

    /// The player's value of positions. A game without pots needs no table of them.
    pub(crate) fn value_of(&self, situation: &Situation<'_>) -> Result<BestShots, Error> {
        let frame = situation.frame;
        let table = |seat: Seat| {
            if frame.facts().is_carom() {
                Ok(Arc::new(PotTable::geometric(situation.noise[seat].clone())))
            } else {
                self.tables.table(frame, &situation.noise[seat])
            }
        };
        Ok(BestShots { tables: [table(0)?, table(1)?], weights: self.method.weights() })
    }

    fn shot(&self, baseline: &Baseline<'_>, spent: &mut Spent) -> Result<Play, Error> {
        let frame = baseline.situation.frame;
        if frame.facts().is_carom() {
            return carom(baseline, spent);
        }
        let attack = if !frame.is_opening() {
            self.method.attack(baseline, spent)?
        } else if baseline.task().breaks_hard()
            && let Some(play) = self.method.break_shot(baseline, spent)?
        {
            return Ok(play);
        } else {
            None
        };
        match attack {
            Some(attack) if attack.chance >= self.method.safety_below() => Ok(attack.play),
            Some(attack) => Ok(match safety(baseline, spent)? {
                Some((play, value)) if value > attack.chance => play,
                _ => attack.play,
            }),
            None => match safety(baseline, spent)? {
                Some((play, _)) => Ok(play),
                None => anything(baseline, spent),
            },
        }
    }
}

impl<M: Method> Player for Planner<M> {
    fn name(&self) -> &str {
        &self.name
    }

    fn decide(
        &mut self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Decision, Error> {
        let (seat, request) = situation.asked()?;
        let mut spent = Spent::default();
        let value = self.value_of(situation)?;
        let answer = match request {
            Request::Choice { choices, .. } => {
                Answer::Choice(best_choice(&value, situation, seat, choices))
            }
            Request::Shot(turn) => {
                let baseline = Baseline::new(situation, budget, turn, value)?;
                Answer::Play(self.shot(&baseline, &mut spent)?)
            }
            Request::Over { .. } => unreachable!("a finished frame has no request"),
        };
        spent.rounds = spent.rounds.max(1);
        Ok(Decision { answer, win_chance: None, spent })
    }
}

fn best_choice(
    value: &BestShots,
    situation: &Situation<'_>,
    seat: Seat,
    choices: &[Choice],
) -> Choice {
    let mut best = (f64::NEG_INFINITY, choices[0]);
    for choice in choices {
        let mut next = situation.frame.clone();
        if next.choose(*choice).is_err() {
            continue;
        }
        let position = Position { frame: &next, noise: &situation.noise };
        let chance = value.win_chance(&position, seat);
        if chance > best.0 {
            best = (chance, *choice);
        }
    }
    best.1
}
