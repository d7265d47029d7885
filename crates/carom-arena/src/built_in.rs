//! The built-in players by their names, for the command line and the bindings.

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind, Noise};
use carom_mind::literature::{self, Literature};
use carom_mind::{Budget, LEVELS, Level, Player, Searcher};

use crate::clock::Clock;
use crate::decisions::decision_hash;
use crate::settings::PlayerEntry;

/// The name of the searching player.
const SEARCHER: &str = "carom";

/// Makes the players of the literature. They share the potting probabilities that they measure, so
/// each table is measured once in a program.
static LITERATURE: LazyLock<Literature> = LazyLock::new(Literature::default);

/// The most simulated shots with which a player of the literature may plan: some minutes of one core.
/// With the number that stands for no limit, a decision would take hours.
pub const MOST_PLANNED: u64 = 5_000_000;

/// A built-in player: a name, some settings, and simulated shots for each decision.
///
/// It is written `NAME`, `NAME:SIMULATIONS`, `NAME[KEY=VALUE,...]` or
/// `NAME[KEY=VALUE,...]:SIMULATIONS`, such as `carom:2000` or `cue-card[level-two=off]:20000`. The
/// settings are those of [`Searcher::read`] and [`Literature::player_with`].
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltInPlayer {
    name: &'static str,
    settings: Node,
    simulations: Option<u32>,
}

impl BuiltInPlayer {
    /// The names of all built-in players.
    pub fn names() -> impl Iterator<Item = &'static str> {
        let levels = LEVELS.iter().map(|level| level.name);
        core::iter::once(SEARCHER).chain(levels).chain(literature::NAMES)
    }

    /// Reads a player.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for an unknown name, at `player.KEY` for a setting that the
    /// player does not have or that is out of range, and for a number of simulated shots that is not
    /// a whole number from 1 to 2³² − 1.
    pub fn read(text: &str) -> Result<Self, Error> {
        let (rest, simulations) = match text.rsplit_once(':') {
            Some((rest, number)) if !number.contains(']') => {
                (rest, Some(read_simulations(number)?))
            }
            _ => (text, None),
        };
        let (name, settings) = match rest.split_once('[') {
            Some((name, settings)) => (name, read_settings(settings)?),
            None => (rest, Node::object([])),
        };
        let Some(name) = Self::names().find(|known| *known == name) else {
            let names: Vec<&str> = Self::names().collect();
            let what = format!("there is no player \"{name}\"");
            let remedy = format!(
                "write one of {}; a number of simulated shots may follow, as in carom:2000",
                names.join(", ")
            );
            return Err(ErrorKind::UnknownName.at("player", what, remedy).with("name", name));
        };
        let player = Self { name, settings, simulations };
        player.make()?;
        Ok(player)
    }

    /// The player's name without settings and number.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The simulated shots for each decision, if the text or the level gives them.
    pub fn simulations(&self) -> Option<u32> {
        self.simulations.or_else(|| Some(self.level()?.simulations))
    }

    /// The errors of the player's strikes, if it is a level of strength.
    pub fn noise(&self) -> Option<Noise> {
        Some(self.level()?.noise.clone())
    }

    fn level(&self) -> Option<&'static Level> {
        Level::named(self.name)
    }

    /// The clock of [`Self::simulations`], or else `usual`.
    pub fn clock(&self, usual: Clock) -> Clock {
        self.simulations().map_or(usual, Clock::simulations)
    }

    /// The player, as new.
    ///
    /// # Errors
    /// As [`Self::read`]. A player that was read has none.
    pub fn make(&self) -> Result<Box<dyn Player>, Error> {
        if self.is_searcher() {
            return Ok(Box::new(self.searcher()?));
        }
        LITERATURE.player_with(self.name, &self.reader())
    }

    /// The player, as new, if it is the searching one.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for a player of the literature, which does not explain its plays.
    pub fn searcher(&self) -> Result<Searcher, Error> {
        if self.is_searcher() {
            return Searcher::read(self.name, &self.reader());
        }
        let what = format!("{} does not explain its plays", self.name);
        Err(ErrorKind::Unsupported.at("player", what, "ask the player carom"))
    }

    /// Rejects a budget without a bound: the players of the literature plan with all simulated shots
    /// of a decision, whatever the clock says.
    ///
    /// # Errors
    /// [`Error::Input`] at `simulations`, for a player of the literature and more than
    /// [`MOST_PLANNED`] of them.
    pub fn check_budget(&self, budget: &Budget<'_>) -> Result<(), Error> {
        if self.is_searcher() || budget.simulations <= MOST_PLANNED {
            return Ok(());
        }
        let what = format!("{} plans with a number of simulated shots, not with a time", self.name);
        Err(ErrorKind::OutOfRange.at(
            "simulations",
            what,
            format!("give a number up to {MOST_PLANNED}"),
        ))
    }

    /// Whether it is the searching player, also at a level of strength, which can also explain a
    /// position.
    pub fn is_searcher(&self) -> bool {
        self.name == SEARCHER || self.level().is_some()
    }

    /// The player as a match has it. Its name is the text that was read; its settings have a hash of its
    /// decisions, so that a changed player is noticed.
    pub fn entry(&self) -> PlayerEntry {
        let mut settings = Node::object([("player", self.name.into())]);
        if self.has_settings() {
            settings.set("settings", self.settings.clone());
        }
        settings.set("decisions", self.decisions());
        PlayerEntry { name: self.text(), settings }
    }

    /// The text that was read, without blanks.
    pub fn text(&self) -> String {
        let name = self.name_with_settings();
        match self.simulations {
            Some(simulations) => format!("{name}:{simulations}"),
            None => name,
        }
    }

    fn name_with_settings(&self) -> String {
        let Node::Object(fields) = &self.settings else { return self.name.into() };
        if fields.is_empty() {
            return self.name.into();
        }
        format!("{}{}", self.name, written_settings(&self.settings))
    }

    fn has_settings(&self) -> bool {
        matches!(&self.settings, Node::Object(fields) if !fields.is_empty())
    }

    /// A short hash of the player's decisions on fixed positions. It takes some milliseconds, once
    /// in a program.
    fn decisions(&self) -> String {
        static KNOWN: Mutex<BTreeMap<String, String>> = Mutex::new(BTreeMap::new());
        // A panic of another player leaves the map complete.
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let hash = known.entry(self.name_with_settings()).or_insert_with(|| match self.make() {
            Ok(mut player) => decision_hash(player.as_mut()),
            Err(error) => error.to_string(),
        });
        hash.clone()
    }

    fn reader(&self) -> Reader<'_> {
        Reader::new(&self.settings, "player")
    }
}

/// The settings as they stand behind a name, `[KEY=VALUE,...]`.
pub(crate) fn written_settings(settings: &Node) -> String {
    let Node::Object(fields) = settings else { return String::new() };
    let texts = fields.iter().map(|(key, value)| match value {
        Node::Text(text) => format!("{key}={text}"),
        value => format!("{key}={}", value.to_json_line()),
    });
    format!("[{}]", texts.collect::<Vec<_>>().join(","))
}

/// The settings `KEY=VALUE,...]`: a value is a number, `true`, `false`, or a word.
pub(crate) fn read_settings(text: &str) -> Result<Node, Error> {
    let refuse = |kind: ErrorKind, what: String| {
        kind.at("player", what, "write settings as in carom[shift=false,finalists=4]:2000")
    };
    let Some(inside) = text.strip_suffix(']') else {
        return Err(refuse(ErrorKind::Syntax, format!("the settings \"[{text}\" have no end")));
    };
    let mut settings = Node::object([]);
    for setting in inside.split(',') {
        let Some((key, value)) = setting.split_once('=') else {
            return Err(refuse(ErrorKind::Syntax, format!("\"{setting}\" is not a setting")));
        };
        let (key, value) = (key.trim(), value.trim());
        if settings.get(key).is_some() {
            return Err(refuse(
                ErrorKind::Duplicate,
                format!("the setting \"{key}\" occurs twice"),
            ));
        }
        let value = match Node::from_json(value) {
            Ok(value @ (Node::Bool(_) | Node::Integer(_) | Node::Number(_))) => value,
            _ => value.into(),
        };
        settings.set(key, value);
    }
    Ok(settings)
}

fn read_simulations(text: &str) -> Result<u32, Error> {
    text.parse().ok().filter(|number| *number > 0).ok_or_else(|| {
        let what = format!("\"{text}\" is not a number of simulated shots");
        let remedy = format!("write a whole number from 1 to {}, as in carom:2000", u32::MAX);
        ErrorKind::Syntax.at("player", what, remedy)
    })
}

#[cfg(test)]
mod tests {
    use super::{BuiltInPlayer, Level, MOST_PLANNED};
    use crate::clock::Clock;
    use carom::format::Node;
    use carom_mind::Budget;

    #[test]
    fn every_name_makes_the_player_of_this_name() {
        for name in BuiltInPlayer::names() {
            let player = BuiltInPlayer::read(name).unwrap();
            assert_eq!((player.name(), player.make().unwrap().name()), (name, name));
            let simulations = Level::named(name).map(|level| level.simulations);
            assert_eq!((player.simulations(), player.entry().name.as_str()), (simulations, name));
        }
    }

    #[test]
    fn a_number_behind_the_name_is_the_clock_of_a_decision() {
        let usual = Clock::seconds(2.0);
        let player = BuiltInPlayer::read("carom:2000").unwrap();
        assert_eq!(player.clock(usual), Clock::simulations(2000));
        assert_eq!(player.entry().name, "carom:2000");
        assert_eq!(BuiltInPlayer::read("carom").unwrap().clock(usual), usual);
    }

    #[test]
    fn a_level_has_errors_and_simulations_that_a_number_replaces() {
        let [level, with_number] =
            ["level-3", "level-3:50"].map(|text| BuiltInPlayer::read(text).unwrap());
        assert_eq!(level.noise(), Level::named("level-3").map(|level| level.noise.clone()));
        assert_eq!(level.clock(Clock::seconds(2.0)), Clock::simulations(600));
        assert_eq!((with_number.noise(), with_number.simulations()), (level.noise(), Some(50)));
        assert_eq!(BuiltInPlayer::read("carom").unwrap().noise(), None);
    }

    #[test]
    fn settings_stand_in_brackets_behind_the_name() {
        for text in [
            "carom[value=markov,exploring=0.3,shift=false]:2000",
            "cue-card[level-two=off,samples=30,break=usual]",
            "greedy[aim=simulated]:100",
            "pick-pocket[samples=30]",
        ] {
            let player = BuiltInPlayer::read(text).unwrap();
            assert_eq!(player.entry().name, text);
        }
        let spaced = BuiltInPlayer::read("carom[ shift = false, finalists = 4 ]").unwrap();
        assert_eq!(spaced.entry().name, "carom[shift=false,finalists=4]");
    }

    #[test]
    fn rejects_settings_with_their_place() {
        for (text, place) in [
            ("carom[finalists=-1]", "player.finalists"),
            ("carom[finalists=0]", "player.finalists"),
            ("carom[exploring=0]", "player.exploring"),
            ("carom[exploring=0.9,replying=0.9]", "player.exploring"),
            ("carom[refining=0.8,replying=0.3]", "player.refining"),
            ("carom[replying=0.9]", "player.replying"),
            ("carom[method=kr-uct]", "player.method"),
            ("carom[allocation=halving]", "player.allocation"),
            ("carom[exploring=1.5]", "player.exploring"),
            ("carom[value=network]", "player.value"),
            ("carom[samples=30]", "player"),
            ("carom[shift=1]", "player.shift"),
            ("carom[shift=true,shift=false]", "player"),
            ("carom[shift]", "player"),
            ("carom[shift=true", "player"),
            ("greedy[aim=]", "player.aim"),
            ("pool-master[samples=3]", "player"),
        ] {
            let error = BuiltInPlayer::read(text).unwrap_err().to_string();
            assert!(error.starts_with(place), "{text}: {error}");
        }
    }

    #[test]
    fn the_hash_of_the_decisions_is_that_of_the_player() {
        let hash = |text: &str| {
            let settings = BuiltInPlayer::read(text).unwrap().entry().settings;
            let Some(Node::Text(hash)) = settings.get("decisions") else { panic!("{settings:?}") };
            hash.clone()
        };
        let searcher = hash("carom");
        assert_eq!(searcher.len(), 16);
        assert!(searcher.bytes().all(|digit| digit.is_ascii_hexdigit()), "{searcher}");
        assert_eq!(hash("carom:2000"), searcher, "the number belongs to the clock");
        let others = ["greedy", "pick-pocket", "carom[value=markov]", "carom[common-errors=false]"];
        let hashes: std::collections::BTreeSet<String> =
            others.into_iter().chain(["carom"]).map(hash).collect();
        assert_eq!(hashes.len(), 5, "{hashes:?}");
    }

    #[test]
    fn only_the_searching_player_explains_and_takes_any_budget() {
        let [searcher, other] = ["carom", "greedy"].map(|name| BuiltInPlayer::read(name).unwrap());
        assert!(searcher.searcher().is_ok());
        assert!(other.searcher().is_err_and(|e| e.to_string().starts_with("player: ")));
        for (simulations, is_accepted) in [(MOST_PLANNED, true), (MOST_PLANNED + 1, false)] {
            let budget = Budget::simulations(simulations);
            assert!(searcher.check_budget(&budget).is_ok());
            assert_eq!(other.check_budget(&budget).is_ok(), is_accepted);
        }
    }

    #[test]
    fn rejects_unknown_names_and_numbers() {
        for text in ["", "Carom", "someone", "carom:", "carom:0", "carom:-5", "carom:1e3", ":5"] {
            let error = BuiltInPlayer::read(text).unwrap_err().to_string();
            assert!(error.starts_with("player: ") && error.contains("carom"), "{error}");
        }
    }
}
