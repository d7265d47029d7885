//! The header of a record: all that was agreed before the first shot.

use std::sync::Arc;

use carom::format::{Node, Reader};
use carom::limits::MOST_EVENTS;
use carom::noise::Perception;
use carom::{Error, ErrorKind, Noise};
use carom_rules::{Game, Options};

use super::values::{play, read_play, read_whole, two, whole};
use super::{ENGINE, MATCH_FORMAT};
use crate::clock::{Clock, ClockPeriod, ClockUnit};
use crate::luck::{LuckSettings, LuckValue};
use crate::sequential::{SequentialTest, TestUnit};
use crate::settings::{Breaker, Disclosure, Match, MatchSettings, PlayerEntry};

const KEYS: &[&str] = &[
    "format",
    "engine",
    "players",
    "game",
    "options",
    "table",
    "physics",
    "max_events",
    "noise",
    "perception",
    "clock",
    "breaker",
    "same_break",
    "disclosure",
    "luck",
    "pairs",
    "test",
    "secret_sha256",
];

const DISCLOSURES: [(&str, Disclosure); 3] =
    [("both", Disclosure::Both), ("own", Disclosure::Own), ("nothing", Disclosure::Nothing)];

const UNITS: [(&str, ClockUnit); 2] =
    [("simulations", ClockUnit::Simulations), ("seconds", ClockUnit::Seconds)];

const PERIODS: [(&str, ClockPeriod); 2] =
    [("decision", ClockPeriod::Decision), ("frame", ClockPeriod::Frame)];

/// The header of a record.
#[derive(Clone, Debug)]
pub struct MatchHeader {
    /// The engine that played the match, with its version.
    pub engine: String,
    /// Settings and players.
    pub of: Arc<Match>,
    /// Number of pairs; the largest one if the match has a sequential test.
    pub pairs: u64,
    /// The test that ends the match.
    pub test: Option<SequentialTest>,
    /// SHA-256 of the secret.
    pub secret_sha256: String,
}

impl MatchHeader {
    /// The header of a match that this engine plays.
    pub fn new(
        of: Arc<Match>,
        pairs: u64,
        test: Option<SequentialTest>,
        secret_sha256: String,
    ) -> Self {
        Self { engine: ENGINE.into(), of, pairs, test, secret_sha256 }
    }

    /// The header as an object.
    pub fn to_node(&self) -> Node {
        let settings = self.of.settings();
        let setup = self.of.recorded_setup();
        let players = self.of.players().iter().map(|PlayerEntry { name, settings }| {
            Node::object([("name", name.into()), ("settings", settings.clone())])
        });
        let breaker = match settings.breaker {
            Breaker::Alternate => "alternate".into(),
            Breaker::Always(player) => Node::Integer(player as i64),
        };
        let same_break = settings.same_break.as_ref().map(|same| play(self.of.start(), same));
        let mut node = Node::object([
            ("format", MATCH_FORMAT.into()),
            ("engine", (&self.engine).into()),
            ("players", Node::list(players)),
            ("game", settings.game.name().into()),
            ("options", settings.options.to_node()),
            ("table", setup.get("table").cloned().into()),
            ("physics", setup.get("physics").cloned().into()),
            ("max_events", settings.max_events.into()),
            ("noise", Node::list(settings.noise.iter().map(Noise::to_node))),
            ("perception", Node::list(settings.perception.iter().map(Perception::to_node))),
            ("clock", Node::list(settings.clock.iter().map(clock_node))),
            ("breaker", breaker),
            ("same_break", same_break.into()),
            ("disclosure", disclosure_node(settings.disclosure)),
            ("pairs", whole(self.pairs)),
            ("test", self.test.as_ref().map(test_node).into()),
            ("secret_sha256", (&self.secret_sha256).into()),
        ]);
        if let Some(luck) = &settings.luck {
            node.set("luck", luck_node(luck));
        }
        node
    }

    /// Reads a header.
    ///
    /// # Errors
    /// [`Error::Input`] with the key of a value that is missing or invalid, and for another format.
    pub fn from_node(node: &Node) -> Result<Self, Error> {
        let header = Reader::new(node, "");
        let format = header.require("format", &format!("\"{MATCH_FORMAT}\""))?;
        if format.text(MATCH_FORMAT)? != MATCH_FORMAT {
            let remedy = format!("give a record with the format \"{MATCH_FORMAT}\"");
            return Err(format.refuse(ErrorKind::Format, "it is another format", remedy));
        }
        header.keys(KEYS)?;
        let text = |key: &str| Ok(header.require(key, "a text")?.text("a text")?.to_owned());
        let (of, pairs, test) = read_agreement(&header)?;
        let (engine, secret_sha256) = (text("engine")?, text("secret_sha256")?);
        Ok(Self { engine, of, pairs, test, secret_sha256 })
    }
}

/// The match, the number of its pairs and its test, from the keys of a header that everybody has to
/// agree on: all but `format`, `engine` and `secret_sha256`.
pub(crate) fn read_agreement(
    header: &Reader<'_>,
) -> Result<(Arc<Match>, u64, Option<SequentialTest>), Error> {
    let players = two(&header.require("players", "a list of two players")?, read_player)?;
    let mut settings = read_settings(header)?;
    let mut of = Match::new(settings.clone(), players.clone())?;
    if let Some(same) = header.get("same_break") {
        settings.same_break = Some(read_play(of.start(), &same)?);
        of = Match::new(settings, players)?;
    }
    let test = header.get("test").map(|test| read_test(&test)).transpose()?;
    let pairs = read_whole(&header.require("pairs", "the number of pairs")?)?;
    Ok((of.into(), pairs, test))
}

fn read_settings(header: &Reader<'_>) -> Result<MatchSettings, Error> {
    let game = header.require("game", "the name of a game")?;
    let name = game.text("the name of a game")?;
    let known = Game::ALL.map(Game::name);
    let game = Game::named(name).ok_or_else(|| game.unknown_word(name, "game", &known))?;
    let require = |key: &str| header.require(key, "the setting");
    let max_events = require("max_events")?.whole(1, MOST_EVENTS.into())? as u32;
    Ok(MatchSettings {
        game,
        options: read_options(&require("options")?)?,
        table: header.get("table").map(|table| table.node().clone()),
        physics: header.get("physics").map(|physics| physics.node().clone()),
        max_events,
        noise: two(&require("noise")?, Noise::read)?,
        perception: two(&require("perception")?, Perception::read)?,
        clock: two(&require("clock")?, read_clock)?,
        breaker: read_breaker(&require("breaker")?)?,
        same_break: None,
        disclosure: word(&require("disclosure")?, "disclosure", &DISCLOSURES)?,
        luck: header.get("luck").map(|luck| read_luck(&luck)).transpose()?,
    })
}

fn read_player(at: &Reader<'_>) -> Result<PlayerEntry, Error> {
    at.keys(&["name", "settings"])?;
    let name = at.require("name", "the name of the player")?.text("a name")?.to_owned();
    let settings = at.require("settings", "an object")?.node().clone();
    Ok(PlayerEntry { name, settings })
}

fn read_options(at: &Reader<'_>) -> Result<Options, Error> {
    at.keys(&["points", "miss", "patience"])?;
    Ok(Options {
        points: at.require("points", "a whole number")?.whole(1, i32::MAX.into())? as i32,
        miss: at.require("miss", "true or false")?.flag()?,
        patience: at.require("patience", "a whole number")?.whole(1, u32::MAX.into())? as u32,
    })
}

fn read_breaker(at: &Reader<'_>) -> Result<Breaker, Error> {
    match at.node() {
        Node::Text(text) if text == "alternate" => Ok(Breaker::Alternate),
        Node::Integer(player @ 0..=1) => Ok(Breaker::Always(*player as usize)),
        _ => Err(at.wrong_type("\"alternate\", 0 or 1")),
    }
}

/// A clock as records and messages have it.
pub(crate) fn clock_node(clock: &Clock) -> Node {
    let amount = match clock.unit {
        ClockUnit::Simulations => Node::Integer(clock.amount as i64),
        ClockUnit::Seconds => clock.amount.into(),
    };
    let mut node = Node::object([]);
    if let Some((unit, _)) = UNITS.iter().find(|(_, unit)| *unit == clock.unit) {
        node.set(unit, amount);
    }
    node.set("per", word_of(&PERIODS, clock.period));
    node
}

fn read_clock(at: &Reader<'_>) -> Result<Clock, Error> {
    at.keys(&["simulations", "seconds", "per"])?;
    let period = word(&at.require("per", "\"decision\" or \"frame\"")?, "period", &PERIODS)?;
    match (at.get("simulations"), at.get("seconds")) {
        (Some(amount), None) => Ok(Clock {
            unit: ClockUnit::Simulations,
            period,
            amount: amount.whole(1, u32::MAX.into())? as f64,
        }),
        (None, Some(amount)) => {
            Ok(Clock { unit: ClockUnit::Seconds, period, amount: amount.exact_number()? })
        }
        _ => Err(at.refuse(
            ErrorKind::Conflict,
            "it has no unit, or two",
            "write either simulations or seconds",
        )),
    }
}

fn luck_node(luck: &LuckSettings) -> Node {
    let LuckSettings { draws, value } = *luck;
    Node::object([("draws", draws.into()), ("value", value.name().into())])
}

fn read_luck(at: &Reader<'_>) -> Result<LuckSettings, Error> {
    at.keys(&["draws", "value"])?;
    let draws = at.require("draws", "a whole number")?.whole(1, u32::MAX.into())? as u32;
    let value = at.require("value", "the name of a value")?;
    let name = value.text("the name of a value")?;
    let known = LuckValue::ALL.map(LuckValue::name);
    let found = LuckValue::named(name).ok_or_else(|| value.unknown_word(name, "value", &known))?;
    Ok(LuckSettings { draws, value: found })
}

/// A test of shares has no unit, so records from before there were units keep their bytes.
fn test_node(test: &SequentialTest) -> Node {
    let SequentialTest { p0, p1, unit, alpha, beta } = *test;
    let keys = [("p0", p0), ("p1", p1), ("alpha", alpha), ("beta", beta)];
    let mut node = Node::object(keys.map(|(key, value)| (key, value.into())));
    if unit != TestUnit::Shares {
        node.set("unit", unit.name());
    }
    node
}

fn read_test(at: &Reader<'_>) -> Result<SequentialTest, Error> {
    at.keys(&["p0", "p1", "unit", "alpha", "beta"])?;
    let key = |key| at.require(key, "a number")?.exact_number();
    let (p0, p1, alpha, beta) = (key("p0")?, key("p1")?, key("alpha")?, key("beta")?);
    let unit = at.get("unit").map(|unit| read_unit(&unit)).transpose()?.unwrap_or_default();
    let test = SequentialTest { p0, p1, unit, alpha, beta };
    test.check().map(|()| test)
}

fn read_unit(at: &Reader<'_>) -> Result<TestUnit, Error> {
    let name = at.text("the unit of the hypotheses")?;
    let known = TestUnit::ALL.map(TestUnit::name);
    TestUnit::named(name).ok_or_else(|| at.unknown_word(name, "unit", &known))
}

/// The name of a disclosure.
pub(crate) fn disclosure_node(disclosure: Disclosure) -> Node {
    word_of(&DISCLOSURES, disclosure)
}

fn word_of<T: PartialEq>(words: &[(&'static str, T)], value: T) -> Node {
    words.iter().find(|(_, known)| *known == value).map(|(word, _)| *word).into()
}

fn word<T: Copy>(at: &Reader<'_>, kind: &str, words: &[(&'static str, T)]) -> Result<T, Error> {
    let names: Vec<&str> = words.iter().map(|(name, _)| *name).collect();
    let found = at.text(&format!("one of {}", names.join(", ")))?;
    let known = words.iter().find(|(name, _)| *name == found);
    known.map(|(_, value)| *value).ok_or_else(|| at.unknown_word(found, kind, &names))
}
