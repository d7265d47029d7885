//! The settings of the searching player.

use carom::format::Reader;
use carom::{Error, ErrorKind};
use carom_rules::Frame;

use crate::breaks::BreakShot;

/// How the searching player chooses its opening shots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum BreakChoice {
    /// The best known break of the table and its variants are compared in the rack that is there.
    #[default]
    Searched,
    /// A full hit from the middle of the head string at the game's usual speed
    /// ([`carom::rack::Game::break_speed`]), in every rack.
    Center,
    /// This one, in every rack.
    Given(BreakShot),
}

impl BreakChoice {
    /// The shot that opens `frame`; none if it is searched.
    pub(crate) fn fixed(self, frame: &Frame) -> Option<BreakShot> {
        match self {
            Self::Searched => None,
            Self::Center => Some(BreakShot::usual(frame)),
            Self::Given(shot) => Some(shot),
        }
    }
}

/// How the searching player searches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchSettings {
    /// Share of a round's simulations that search for candidates; the rest races them. Above 0, to 0.9.
    pub exploring: f64,
    /// Candidates that enter the first race, if enough are found. A large round has more.
    pub racing: usize,
    /// Number of safeties among them.
    pub safeties: usize,
    /// Simulations of the first round: of a usual shot; more with the cue ball in hand, for opening
    /// shots, and where the budget is large. Each further round has 1.6 times as many.
    pub first_round: u64,
    /// Share of a further round's simulations that look for neighbours of the best plays. 0 to 0.9.
    pub refining: f64,
    /// Share of a round's simulations that search successors of the finalists. 0 to 0.9.
    pub replying: f64,
    /// Largest number of finalists whose successors are searched, if [`Self::replying`] is not 0. At least 1.
    pub finalists: usize,
    /// Fewest simulations for each of them. A round that cannot afford them searches none.
    pub per_reply: u64,
    /// Whether finalists are moved uphill by the weights of their samples.
    pub shift: bool,
    /// Whether all candidates are raced with the same drawn errors.
    pub common_errors: bool,
    /// Number of plays whose chances are stated, from samples that took no part in the choice. At
    /// least 1.
    pub stated: usize,
    /// A frame is conceded if the expected chance of winning is below this. Only in snooker, where
    /// points behind cannot always be made up.
    pub concede_below: f64,
    /// The opening shots.
    pub break_shot: BreakChoice,
}

impl Default for SearchSettings {
    fn default() -> Self {
        Self {
            exploring: 0.6,
            racing: 48,
            safeties: 12,
            first_round: 300,
            refining: 0.6,
            replying: 0.0,
            finalists: 6,
            per_reply: 60,
            shift: true,
            common_errors: true,
            stated: 1,
            concede_below: 0.001,
            break_shot: BreakChoice::Searched,
        }
    }
}

/// Largest sum of a round's shares for exploring or refining and for replies: the rest is for the race.
const MOST_SHARES: f64 = 0.9;
/// Settings that chose other searches than the race by sequential halving.
const REMOVED: [&str; 2] = ["method", "allocation"];
/// Share of the simulations that states the chances of a play, and the largest share for all plays.
const FRESH: f64 = 0.06;
const FRESH_IN_ALL: f64 = 0.25;
/// Fewest and most samples of such a statement: with 4000 the standard error of a chance is at most
/// 0.8 points.
const FRESH_SAMPLES: [u64; 2] = [8, 4000];
/// Largest count that a setting may have.
const MOST_OF_ANYTHING: i64 = 1_000_000;

impl SearchSettings {
    /// Number of fresh samples of a play, of `simulations` in all, if the chances of `stated` plays are stated.
    pub(crate) fn fresh(simulations: u64, stated: usize) -> u64 {
        let share = FRESH.min(FRESH_IN_ALL / stated as f64);
        ((share * simulations as f64) as u64).clamp(FRESH_SAMPLES[0], FRESH_SAMPLES[1])
    }

    /// The names of the settings that [`Self::read`] knows.
    pub const KEYS: [&str; 11] = [
        "exploring",
        "racing",
        "safeties",
        "first-round",
        "refining",
        "replying",
        "finalists",
        "per-reply",
        "shift",
        "common-errors",
        "break",
    ];

    /// Rejects the settings of searches that were removed.
    ///
    /// # Errors
    /// [`Error::Input`] with the key of such a setting.
    pub(crate) fn refuse_removed(object: &Reader<'_>) -> Result<(), Error> {
        REMOVED.into_iter().find_map(|key| object.get(key)).map_or(Ok(()), |value| {
            let what =
                "it was removed: no other search was better than the race by sequential halving";
            Err(value.refuse(ErrorKind::UnknownName, what, "leave it out"))
        })
    }

    /// The settings of an object with some of [`Self::KEYS`]; the others keep their defaults.
    ///
    /// # Errors
    /// [`Error::Input`] with the key of a value that is out of range.
    pub fn read(object: &Reader<'_>) -> Result<Self, Error> {
        let mut settings = Self::default();
        let share = |key: &str, usual: f64| -> Result<f64, Error> {
            let Some(value) = object.get(key) else { return Ok(usual) };
            let share = value.number()?;
            if !(0.0..=0.9).contains(&share) {
                return Err(value.refuse(
                    ErrorKind::OutOfRange,
                    "it is not a share",
                    "write a number from 0 to 0.9",
                ));
            }
            Ok(share)
        };
        let count = |key: &str, least: i64, usual: u64| -> Result<u64, Error> {
            let value = object.get(key);
            value.map_or(Ok(usual), |value| Ok(value.whole(least, MOST_OF_ANYTHING)? as u64))
        };
        let flag = |key: &str, usual: bool| -> Result<bool, Error> {
            object.get(key).map_or(Ok(usual), |value| value.flag())
        };
        settings.exploring = share("exploring", settings.exploring)?;
        settings.refining = share("refining", settings.refining)?;
        settings.replying = share("replying", settings.replying)?;
        settings.racing = count("racing", 1, settings.racing as u64)? as usize;
        settings.safeties = count("safeties", 0, settings.safeties as u64)? as usize;
        settings.first_round = count("first-round", 1, settings.first_round)?;
        settings.finalists = count("finalists", 1, settings.finalists as u64)? as usize;
        settings.per_reply = count("per-reply", 1, settings.per_reply)?;
        settings.shift = flag("shift", settings.shift)?;
        settings.common_errors = flag("common-errors", settings.common_errors)?;
        if let Some((key, what, remedy)) = settings.leaves_too_little() {
            let value = object.get(key).or_else(|| object.get("replying"));
            return Err(value.map_or_else(
                || ErrorKind::Conflict.at("settings", what.clone(), remedy.clone()),
                |value| value.refuse(ErrorKind::Conflict, what.clone(), remedy.clone()),
            ));
        }
        if let Some(value) = object.get("break") {
            settings.break_shot = match value.text("searched or center")? {
                "searched" => BreakChoice::Searched,
                "center" => BreakChoice::Center,
                word => return Err(value.unknown_word(word, "break", &["searched", "center"])),
            };
        }
        Ok(settings)
    }

    /// The setting whose share leaves too few simulations for others, what is wrong with it, and the remedy.
    fn leaves_too_little(&self) -> Option<(&'static str, String, String)> {
        let Self { exploring, refining, replying, .. } = *self;
        if exploring == 0.0 {
            let what = "without exploring there are no plays to choose from";
            return Some(("exploring", what.into(), "write a number above 0".into()));
        }
        let shares = [("exploring", exploring), ("refining", refining)];
        let (key, share) = shares.into_iter().find(|(_, share)| share + replying > MOST_SHARES)?;
        let what =
            format!("with {share:?} and replying {replying:?} too little is left for the race");
        Some((key, what, format!("keep their sum at or below {MOST_SHARES:?}")))
    }

    /// Rejects settings out of range.
    ///
    /// # Errors
    /// [`Error::Input`] for a share outside 0 to 0.9, for shares that leave nothing for the race, for a race
    /// without candidates, and as
    /// [`BreakShot::check`].
    pub fn check(&self) -> Result<(), Error> {
        for (key, share) in [
            ("exploring", self.exploring),
            ("refining", self.refining),
            ("replying", self.replying),
        ] {
            if !(0.0..=0.9).contains(&share) {
                let (place, what) =
                    (format!("settings.{key}"), format!("{share:?} is not a share"));
                return Err(ErrorKind::OutOfRange.at(place, what, "write a number from 0 to 0.9"));
            }
        }
        if let Some((key, what, remedy)) = self.leaves_too_little() {
            return Err(ErrorKind::Conflict.at(format!("settings.{key}"), what, remedy));
        }
        for (key, value) in [
            ("racing", self.racing as u64),
            ("stated", self.stated as u64),
            ("first_round", self.first_round),
            ("per_reply", self.per_reply),
            ("finalists", self.finalists as u64),
        ] {
            if value == 0 {
                let place = format!("settings.{key}");
                return Err(ErrorKind::OutOfRange.at(
                    place,
                    "0 is out of range",
                    "write at least 1",
                ));
            }
        }
        match self.break_shot {
            BreakChoice::Searched | BreakChoice::Center => Ok(()),
            BreakChoice::Given(shot) => {
                shot.check().map_err(|error| error.inside("settings.break_shot"))
            }
        }
    }
}
