//! The searching player.

mod choices;

use carom::Error;
use carom::format::Reader;
use carom_rules::{Request, Rules, Turn};

use crate::player::{Answer, Budget, Decision, Player, Situation};
use crate::search::{Found, Rounds, SearchTask};
use crate::settings::SearchSettings;
use crate::value::{Logistic, Markov, Value};

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

    /// A player with this name and the settings of an object: `value` (`logistic` or `markov`) and
    /// [`SearchSettings::KEYS`].
    ///
    /// # Errors
    /// [`Error::Input`] for an unknown key and for a value out of range.
    pub fn read(name: &str, object: &Reader<'_>) -> Result<Self, Error> {
        SearchSettings::refuse_removed(object)?;
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
        Self::new(name, value, SearchSettings::read(object)?)
    }

    /// The value by which it judges positions.
    pub fn value(&self) -> &dyn Value {
        self.value.as_ref()
    }

    /// Its settings.
    pub const fn settings(&self) -> &SearchSettings {
        &self.settings
    }

    /// Begins a search for the situation's shot, for programs that do other work between its rounds.
    /// [`Self::play_round`] goes on with it; [`Self::decision`] or [`Self::analysis`] ends it. All get
    /// the same situation and budget, and together they find what [`Player::decide`] or
    /// [`Self::analyse`] finds. `plays` is the number of plays whose chances are stated, usually 1
    /// for a decision.
    ///
    /// # Errors
    /// As [`Self::analyse`].
    pub fn begin(
        &self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
        plays: usize,
    ) -> Result<Rounds, Error> {
        let turn = turn_of(situation)?;
        if plays == 0 {
            return Err(Error::input("count", "0 plays are nothing", "ask for at least 1"));
        }
        let settings = SearchSettings { stated: plays, ..self.settings };
        Ok(Rounds::new(&self.task(situation, turn, (budget, &settings))))
    }

    /// Plays the next round of a search if the budget allows one. Returns whether it was played.
    ///
    /// # Errors
    /// [`Error::TooManyEvents`] if a shot does not end.
    pub fn play_round(
        &self,
        rounds: &mut Rounds,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<bool, Error> {
        let turn = turn_of(situation)?;
        rounds.play(&self.task(situation, turn, (budget, &self.settings)))
    }

    /// Gives the plays that the rounds have found the kinds of what they do.
    pub(crate) fn name(
        &self,
        rounds: &mut Rounds,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<(), Error> {
        let turn = turn_of(situation)?;
        rounds.name(&self.task(situation, turn, (budget, &self.settings)))
    }

    /// The plays that the rounds have found, the best first.
    pub(crate) fn found(
        &self,
        rounds: Rounds,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Found, Error> {
        let turn = turn_of(situation)?;
        rounds.end(&self.task(situation, turn, (budget, &self.settings)))
    }

    fn task<'a, 'b>(
        &'b self,
        situation: &'b Situation<'a>,
        turn: &'b Turn,
        (budget, settings): (&'b Budget<'b>, &'b SearchSettings),
    ) -> SearchTask<'a, 'b> {
        SearchTask { situation, turn, value: self.value(), settings, budget }
    }

    /// The decision to which the rounds of a search have led.
    ///
    /// # Errors
    /// As [`Self::play_round`], and [`Error::Input`] at `frame` if no strike can be played.
    pub fn decision(
        &self,
        rounds: Rounds,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Decision, Error> {
        let found = self.found(rounds, situation, budget)?;
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
            Request::Shot(_) => {
                let mut rounds = self.begin(situation, budget, self.settings.stated)?;
                while self.play_round(&mut rounds, situation, budget)? {}
                self.decision(rounds, situation, budget)
            }
            Request::Choice { choices, .. } => self.choose((situation, budget), (seat, choices)),
            Request::Over { .. } => Err(Error::input("frame", "it is over", "begin a new frame")),
        }
    }
}

/// The turn of the situation's request, which asks for a shot.
fn turn_of<'a>(situation: &Situation<'a>) -> Result<&'a Turn, Error> {
    match situation.asked()?.1 {
        Request::Shot(turn) => Ok(turn),
        _ => {
            let what = "it asks for a choice, not for a shot";
            Err(Error::input("frame", what, "let the player choose"))
        }
    }
}
