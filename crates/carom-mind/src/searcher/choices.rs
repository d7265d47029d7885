//! Choices: the position after each of them is searched.

use carom::Error;
use carom_rules::{Choice, Frame, Request, Seat};

use super::Searcher;
use crate::player::{Answer, Budget, Decision, Situation, Spent};
use crate::search::Rounds;
use crate::value::Position;

/// One of the choices, and the search of what follows it.
struct Branch {
    choice: Choice,
    /// The frame after the choice.
    frame: Frame,
    /// None if the frame asks for another choice, or is over.
    rounds: Option<Rounds>,
}

impl Searcher {
    /// The choice after which `seat` has the best chances. Each has its share of the budget; the searches
    /// play their rounds in turns.
    ///
    /// # Errors
    /// As [`crate::Player::decide`].
    pub(super) fn choose(
        &self,
        (situation, budget): (&Situation<'_>, &Budget<'_>),
        (seat, choices): (Seat, &[Choice]),
    ) -> Result<Decision, Error> {
        let share = Budget {
            simulations: budget.simulations / choices.len().max(1) as u64,
            runner: budget.runner.clone(),
            rounds: None,
            is_over: &|_| false,
        };
        let begin = |choice: &Choice| -> Result<Branch, Error> {
            let mut frame = situation.frame.clone();
            frame.choose(*choice)?;
            let after = Situation { frame: &frame, ..situation.clone() };
            let rounds = match frame.request() {
                Request::Shot(_) => Some(self.begin(&after, &share, self.settings().stated)?),
                _ => None,
            };
            Ok(Branch { choice: *choice, frame, rounds })
        };
        let mut branches = choices.iter().map(begin).collect::<Result<Vec<Branch>, Error>>()?;
        let mut spent = Spent::default();
        while budget.allows(spent, 0) {
            let before = spent.simulations;
            for Branch { frame, rounds, .. } in &mut branches {
                let Some(rounds) = rounds else { continue };
                let so_far = rounds.spent().simulations;
                self.play_round(rounds, &Situation { frame, ..situation.clone() }, &share)?;
                spent.simulations += rounds.spent().simulations - so_far;
            }
            if spent.simulations == before {
                break;
            }
            spent.rounds += 1;
        }
        let mut best: Option<(Choice, f64)> = None;
        spent.simulations = 0;
        for Branch { choice, frame, rounds } in branches {
            let after = Situation { frame: &frame, ..situation.clone() };
            let found = rounds.map(|rounds| self.found(rounds, &after, &share)).transpose()?;
            spent.simulations += found.as_ref().map_or(0, |found| found.spent.simulations);
            let own = match found.as_ref().and_then(|found| found.candidates.first()) {
                Some(play) if frame.player() == Some(seat) => play.stated_win(),
                Some(play) => 1.0 - play.stated_win(),
                None => {
                    let position = Position { frame: &frame, noise: &situation.noise };
                    self.value().win_chance(&position, seat)
                }
            };
            if best.is_none_or(|(_, most)| own > most) {
                best = Some((choice, own));
            }
        }
        let Some((choice, value)) = best else {
            return Err(Error::input("frame", "it offers no choice", "look at its request"));
        };
        Ok(Decision { answer: Answer::Choice(choice), win_chance: Some(value), spent })
    }
}
