//! The searching player.

mod choices;

use carom::format::Reader;
use carom::{Error, ErrorKind};
use carom_rules::Request;

use crate::player::{Answer, Budget, Decision, Player, Situation};
use crate::search::{Found, Rounds, SearchTask, ShotSearch, ShotTask};
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

    /// Begins a search for the situation's shot. At its end the chances of `plays` plays are stated, usually 1 for
    /// a decision. [`ShotSearch::play_round`] plays a round, and [`ShotSearch::decision`] or
    /// [`ShotSearch::analysis`] ends it.
    /// Together they find what [`Player::decide`] or [`Self::analyse`] finds.
    ///
    /// # Errors
    /// As [`Self::analyse`].
    pub fn search<'a>(
        &'a self,
        situation: &'a Situation<'a>,
        budget: &'a Budget<'a>,
        plays: usize,
    ) -> Result<ShotSearch<'a>, Error> {
        let task = self.task(situation, budget)?;
        if plays == 0 {
            return Err(ErrorKind::OutOfRange.at(
                "count",
                "0 plays are nothing",
                "ask for at least 1",
            ));
        }
        Ok(ShotSearch::new(task, plays))
    }

    /// Goes on with a search of which a program has kept the rounds. It gets the same situation and budget.
    ///
    /// # Errors
    /// As [`Self::analyse`].
    pub fn resume<'a>(
        &'a self,
        rounds: Rounds,
        situation: &'a Situation<'a>,
        budget: &'a Budget<'a>,
    ) -> Result<ShotSearch<'a>, Error> {
        Ok(ShotSearch::resumed(self.task(situation, budget)?, rounds))
    }

    fn task<'a>(
        &'a self,
        situation: &'a Situation<'a>,
        budget: &'a Budget<'a>,
    ) -> Result<SearchTask<'a>, Error> {
        let shot = ShotTask::new(situation, self.value())?;
        Ok(SearchTask { shot, settings: &self.settings, budget })
    }
}

impl ShotSearch<'_> {
    /// The decision to which the rounds have led.
    ///
    /// # Errors
    /// As [`Self::play_round`], and [`Error::Input`] at `frame` if no strike can be played.
    pub fn decision(mut self) -> Result<Decision, Error> {
        let SearchTask { shot, settings, .. } = self.task;
        let Found { candidates, spent } = self.found()?;
        let Some(best) = candidates.first() else {
            return Err(ErrorKind::NoPlay.at(
                "frame",
                "no strike can be played from this position",
                "look at the places of the balls",
            ));
        };
        let win_chance = best.stated_win();
        let gives_up = shot.frame().facts().conceded && win_chance < settings.concede_below;
        let answer = if gives_up { Answer::Concede } else { Answer::Play(best.play) };
        Ok(Decision { answer, win_chance: Some(win_chance), spent })
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
                let mut search = self.search(situation, budget, self.settings.stated)?;
                while search.play_round()? {}
                search.decision()
            }
            Request::Choice { choices, .. } => self.choose(situation, budget, seat, choices),
            Request::Over { .. } => {
                Err(ErrorKind::FrameOver.at("frame", "it is over", "begin a new frame"))
            }
        }
    }
}
