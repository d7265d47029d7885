//! The searching player.

use carom::Error;
use carom::format::Reader;
use carom_rules::{Choice, Frame, Request, Rules, Seat, Turn};

use crate::player::{Answer, Budget, Decision, Player, Situation, Spent};
use crate::search::{quick_value, search};
use crate::settings::SearchSettings;
use crate::value::{Logistic, Markov, Value};

/// Simulations that value one of the options of a choice.
const PER_CHOICE: u64 = 400;

/// A player that searches: candidates from lines and lattices, a race between them under the
/// player's own errors, judged by a [`Value`].
pub struct Searcher {
    name: String,
    value: Box<dyn Value>,
    settings: SearchSettings,
}

impl Default for Searcher {
    fn default() -> Self {
        Self {
            name: "carom".into(),
            value: Box::<Logistic>::default(),
            settings: SearchSettings::default(),
        }
    }
}

impl Searcher {
    /// A player with this name, value of positions and settings.
    ///
    /// # Errors
    /// As [`SearchSettings::check`].
    pub fn new(
        name: impl Into<String>,
        value: Box<dyn Value>,
        settings: SearchSettings,
    ) -> Result<Self, Error> {
        settings.check()?;
        Ok(Self { name: name.into(), value, settings })
    }

    /// A player with the settings of an object: `value` (`logistic` or `markov`) and
    /// [`SearchSettings::KEYS`].
    ///
    /// # Errors
    /// [`Error::Input`] for an unknown key and for a value out of range.
    pub fn read(object: &Reader<'_>) -> Result<Self, Error> {
        let keys: Vec<&str> = core::iter::once("value").chain(SearchSettings::KEYS).collect();
        object.keys(&keys)?;
        let value: Box<dyn Value> = match object.get("value") {
            None => Box::<Logistic>::default(),
            Some(value) => match value.text("logistic or markov")? {
                "logistic" => Box::<Logistic>::default(),
                "markov" => Box::<Markov>::default(),
                other => return Err(value.unknown_word(other, "value", &["logistic", "markov"])),
            },
        };
        Self::new("carom", value, SearchSettings::read(object)?)
    }

    /// The value by which it judges positions.
    pub fn value(&self) -> &dyn Value {
        self.value.as_ref()
    }

    /// Its settings.
    pub const fn settings(&self) -> &SearchSettings {
        &self.settings
    }

    fn shoot(
        &self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
        turn: &Turn,
    ) -> Result<Decision, Error> {
        let found = search(situation, turn, (self.value(), &self.settings), budget)?;
        let spent = found.spent;
        let Some(best) = found.candidates.first() else {
            return Err(Error::input(
                "frame",
                "no strike can be played from this position",
                "look at the places of the balls",
            ));
        };
        let win_chance = Some(best.stated_win());
        let gives_up = situation.frame.rules() == Rules::Snooker
            && win_chance.is_some_and(|chance| chance < self.settings.concede_below);
        let answer = if gives_up { Answer::Concede } else { Answer::Play(best.play) };
        Ok(Decision { answer, win_chance, spent })
    }

    fn choose(
        &self,
        situation: &Situation<'_>,
        seat: Seat,
        choices: &[Choice],
    ) -> Result<Decision, Error> {
        let mut best: Option<(Choice, f64)> = None;
        let mut spent = Spent { simulations: 0, rounds: 1 };
        for choice in choices {
            let mut next: Frame = situation.frame.clone();
            next.choose(*choice)?;
            let after = Situation { frame: &next, ..*situation };
            let (value, plays) = quick_value(&after, self.value(), PER_CHOICE)?;
            spent.simulations += plays;
            let own = if next.player() == Some(seat) { value } else { 1.0 - value };
            if best.is_none_or(|(_, most)| own > most) {
                best = Some((*choice, own));
            }
        }
        let Some((choice, value)) = best else {
            return Err(Error::input("frame", "it offers no choice", "look at its request"));
        };
        Ok(Decision { answer: Answer::Choice(choice), win_chance: Some(value), spent })
    }
}

impl Player for Searcher {
    fn name(&self) -> &str {
        &self.name
    }

    fn decide(
        &mut self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Decision, Error> {
        let (seat, request) = situation.asked()?;
        match request {
            Request::Shot(turn) => self.shoot(situation, budget, turn),
            Request::Choice { choices, .. } => self.choose(situation, seat, choices),
            Request::Over { .. } => Err(Error::input("frame", "it is over", "begin a new frame")),
        }
    }
}
