//! Choices: the position after each of them is searched.

use carom::{Error, ErrorKind};
use carom_rules::{Choice, Frame, Request, Seat};

use super::Searcher;
use crate::player::{Answer, Budget, Decision, Situation, Spent};
use crate::search::ShotSearch;
use crate::value::Position;

/// One of the choices, and the search of what follows it.
struct Branch<'a> {
    choice: Choice,
    /// What the players know after the choice.
    situation: &'a Situation<'a>,
    /// None if the frame asks for another choice, or is over.
    search: Option<ShotSearch<'a>>,
}

impl Searcher {
    /// The choice after which `seat` has the best chances. Each has its share of the budget; the searches
    /// play their rounds in turns.
    ///
    /// # Errors
    /// As [`crate::Player::decide`].
    pub(super) fn choose(
        &self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
        seat: Seat,
        choices: &[Choice],
    ) -> Result<Decision, Error> {
        let share = Budget {
            simulations: budget.simulations / choices.len().max(1) as u64,
            runner: budget.runner.clone(),
            rounds: None,
            is_over: &|_| false,
        };
        let chosen = |choice: &Choice| -> Result<Frame, Error> {
            let mut frame = situation.frame.clone();
            frame.choose(*choice)?;
            Ok(frame)
        };
        let frames = choices.iter().map(chosen).collect::<Result<Vec<Frame>, Error>>()?;
        let after = |frame| Situation { frame, ..situation.clone() };
        let situations: Vec<Situation<'_>> = frames.iter().map(after).collect();
        let mut branches = Vec::new();
        for (choice, situation) in choices.iter().copied().zip(&situations) {
            let search = match situation.frame.request() {
                Request::Shot(_) => Some(self.search(situation, &share, self.settings().stated)?),
                _ => None,
            };
            branches.push(Branch { choice, situation, search });
        }
        let mut spent = Spent::default();
        while budget.allows(spent, 0) {
            let before = spent.simulations;
            for search in branches.iter_mut().filter_map(|branch| branch.search.as_mut()) {
                let so_far = search.rounds().spent().simulations;
                search.play_round()?;
                spent.simulations += search.rounds().spent().simulations - so_far;
            }
            if spent.simulations == before {
                break;
            }
            spent.rounds += 1;
        }
        let mut best: Option<(Choice, f64)> = None;
        spent.simulations = 0;
        for Branch { choice, situation: Situation { frame, noise, .. }, search } in branches {
            let found = search.map(|mut search| search.found()).transpose()?;
            spent.simulations += found.as_ref().map_or(0, |found| found.spent.simulations);
            let own = match found.as_ref().and_then(|found| found.candidates.first()) {
                Some(play) if frame.player() == Some(seat) => play.stated_win(),
                Some(play) => 1.0 - play.stated_win(),
                None => self.value().win_chance(&Position { frame, noise }, seat),
            };
            if best.is_none_or(|(_, most)| own > most) {
                best = Some((choice, own));
            }
        }
        let Some((choice, value)) = best else {
            return Err(ErrorKind::WrongState.at(
                "frame",
                "it offers no choice",
                "look at its request",
            ));
        };
        Ok(Decision { answer: Answer::Choice(choice), win_chance: Some(value), spent })
    }
}
