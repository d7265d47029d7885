//! The settings of a match, and the match that they give.

use carom::format::Node;
use carom::noise::Perception;
use carom::shot::DEFAULT_MAX_EVENTS;
use carom::{Error, ErrorKind, Noise};
use carom_rules::{Frame, Game, Options, Play, recorded_setup};

use crate::clock::Clock;
use crate::luck::LuckSettings;
use crate::secret::PairSeeds;

/// Longest name of a player, characters. Names stand in tables.
pub(crate) const LONGEST_NAME: usize = 80;

/// A player of the match, 0 or 1. Not a seat: the players exchange the seats within a pair.
pub type PlayerIndex = usize;

/// Who a player of the match is.
#[derive(Clone, Debug, PartialEq)]
pub struct PlayerEntry {
    /// The name in tables and records.
    pub name: String,
    /// The player's own settings, for the record: an object.
    pub settings: Node,
}

impl PlayerEntry {
    /// A player without settings.
    pub fn new(name: &str) -> Self {
        Self { name: name.into(), settings: Node::object([]) }
    }
}

/// Who has seat 0, and so begins the frames of a pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Breaker {
    /// Player 0 in the first frame of each pair, player 1 in the second. Each seat keeps its
    /// streams of errors, so two equal players play the same frame twice.
    #[default]
    Alternate,
    /// Always this player. The seats exchange their streams of errors in the second frame.
    Always(PlayerIndex),
}

/// Which standard deviations of errors a player knows. The drawn errors are never disclosed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Disclosure {
    /// Those of both players.
    #[default]
    Both,
    /// Its own. In place of the other player's it gets [`Noise::NONE`].
    Own,
    /// None. In place of both it gets [`Noise::NONE`], and an exact perception.
    Nothing,
}

/// What the players of a match agree on before its start. Index 0 and 1 of an array are player 0
/// and player 1.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchSettings {
    /// The game.
    pub game: Game,
    /// The options of the game.
    pub options: Options,
    /// The table, as the key `table` of a shot file; `None` for the game's own.
    pub table: Option<Node>,
    /// The physics, as the key `physics` of a shot file; `None` for the table's own.
    pub physics: Option<Node>,
    /// Largest number of events of a shot. A frame with a shot that reaches it does not count.
    pub max_events: u32,
    /// The errors of the players' strikes.
    pub noise: [Noise; 2],
    /// The errors with which the players see the balls.
    pub perception: [Perception; 2],
    /// The players' clocks.
    pub clock: [Clock; 2],
    /// Who begins.
    pub breaker: Breaker,
    /// The intended break of both players; `None` if they choose it. It is played, with the errors
    /// of the player who breaks, in the first shot of a frame, and also after another rack in
    /// eight-ball, nine-ball, ten-ball, snooker and practice. Published comparisons use it to
    /// measure the rest of the game (Archibald, Altman & Shoham 2009, section 5).
    pub same_break: Option<Play>,
    /// Which standard deviations of errors the players know.
    pub disclosure: Disclosure,
    /// How the luck of shots is measured; `None` if it is not. It changes nothing of what is played.
    pub luck: Option<LuckSettings>,
}

impl MatchSettings {
    /// A match of `rules` on the game's own table: no errors, ten minutes a frame and side, players
    /// who break in turn.
    pub fn new(game: Game) -> Self {
        Self {
            game,
            options: Options::default(),
            table: None,
            physics: None,
            max_events: DEFAULT_MAX_EVENTS,
            noise: [Noise::NONE; 2],
            perception: [const { Perception::round(0.0) }; 2],
            clock: [Clock::default(); 2],
            breaker: Breaker::Alternate,
            same_break: None,
            disclosure: Disclosure::Both,
            luck: None,
        }
    }
}

/// A match between two players: its settings, checked, and the frame with which it begins.
#[derive(Clone, Debug)]
pub struct Match {
    settings: MatchSettings,
    players: [PlayerEntry; 2],
    /// The first frame, racked with seed 0; table and physics are read once.
    start: Frame,
}

impl Match {
    /// A match with these settings between these players.
    ///
    /// # Errors
    /// [`Error::Input`] with the key of an invalid setting, such as `noise[1].speed`, for a player
    /// without a name, and for a same break that the game does not accept.
    pub fn new(settings: MatchSettings, players: [PlayerEntry; 2]) -> Result<Self, Error> {
        let MatchSettings { game, options, table, physics, .. } = settings.clone();
        let start = Frame::new(game, options, table, physics, 0)?;
        let start = start.with_max_events(settings.max_events);
        check(&settings)?;
        for (i, player) in players.iter().enumerate() {
            let length = player.name.chars().count();
            if length == 0 || length > LONGEST_NAME || player.name.contains(char::is_control) {
                let remedy = format!("write 1 to {LONGEST_NAME} printable characters");
                return Err(ErrorKind::Syntax.at(
                    format!("players[{i}].name"),
                    "it is not a name",
                    remedy,
                ));
            }
            if !matches!(player.settings, Node::Object(_)) {
                let place = format!("players[{i}].settings");
                return Err(ErrorKind::WrongType.at(
                    place,
                    "they are not an object",
                    "write an object {...}",
                ));
            }
        }
        if let Some(play) = &settings.same_break {
            start.shot(play).map_err(|error| error.inside("same_break"))?;
        }
        Ok(Self { settings, players, start })
    }

    /// The same match, whose luck is measured like this.
    ///
    /// # Errors
    /// As [`LuckSettings::check`].
    pub fn with_luck(&self, luck: LuckSettings) -> Result<Self, Error> {
        luck.check()?;
        let settings = MatchSettings { luck: Some(luck), ..self.settings.clone() };
        Ok(Self { settings, ..self.clone() })
    }

    /// The settings.
    pub const fn settings(&self) -> &MatchSettings {
        &self.settings
    }

    /// The players.
    pub const fn players(&self) -> &[PlayerEntry; 2] {
        &self.players
    }

    /// The frame with which the match begins, racked with seed 0.
    pub const fn start(&self) -> &Frame {
        &self.start
    }

    /// `table` and `physics` as a record has them, with the dated names of presets.
    pub fn recorded_setup(&self) -> Node {
        let MatchSettings { game, table, physics, .. } = &self.settings;
        recorded_setup(*game, table.clone(), physics.clone())
    }

    /// The player at each seat in frame number `frame`. Frames 2k and 2k + 1 are pair k.
    pub const fn seats(&self, frame: u64) -> [PlayerIndex; 2] {
        match self.settings.breaker {
            Breaker::Alternate if frame.is_multiple_of(2) => [0, 1],
            Breaker::Alternate => [1, 0],
            Breaker::Always(player) => [player, 1 - player],
        }
    }

    /// The seeds of frame number `frame`, with those of its pair.
    pub const fn seeds(&self, frame: u64, of_pair: PairSeeds) -> PairSeeds {
        match self.settings.breaker {
            Breaker::Always(_) if !frame.is_multiple_of(2) => of_pair.exchanged(),
            _ => of_pair,
        }
    }
}

fn check(settings: &MatchSettings) -> Result<(), Error> {
    for i in 0..2 {
        let at = |error: Error| inside_item(error, i);
        settings.noise[i].check().map_err(at)?;
        settings.perception[i].check().map_err(at)?;
        settings.clock[i].check().map_err(at)?;
    }
    if settings.max_events == 0 {
        return Err(ErrorKind::OutOfRange.at(
            "max_events",
            "0 is out of range",
            "write at least 1",
        ));
    }
    settings.luck.map_or(Ok(()), |luck| luck.check())?;
    match settings.breaker {
        Breaker::Always(player) if player > 1 => Err(ErrorKind::OutOfRange.at(
            "breaker",
            format!("there is no player {player}"),
            "write 0 or 1",
        )),
        _ => Ok(()),
    }
}

/// An error at a key such as `noise.speed`, as an error at `noise[i].speed`.
fn inside_item(error: Error, i: usize) -> Error {
    match error {
        Error::Input(mut e) => {
            let end = e.place.find('.').unwrap_or(e.place.len());
            e.place.insert_str(end, &format!("[{i}]"));
            Error::Input(e)
        }
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::resolve::cue_ball::Strike;

    fn made(settings: MatchSettings) -> Result<Match, Error> {
        Match::new(settings, [PlayerEntry::new("a"), PlayerEntry::new("b")])
    }

    #[test]
    fn rejects_invalid_settings_at_their_keys() {
        let good = MatchSettings::new(Game::NineBall);
        let strike = Strike { speed: 5.0, azimuth: 1.57, elevation: 0.05, side: 0.9, height: 0.0 };
        let breaking = Play::new(strike).from([0.635, 0.5]);
        let noise = [Noise::NONE, Noise { speed: -1.0, ..Noise::NONE }];
        let perception = [Perception::round(3.0), Perception::default()];
        let no_draws = LuckSettings { draws: 0, ..LuckSettings::default() };
        for (settings, place) in [
            (MatchSettings { noise, ..good.clone() }, "noise[1].speed: "),
            (MatchSettings { perception, ..good.clone() }, "perception[0].position: "),
            (MatchSettings { clock: [Clock::seconds(0.0); 2], ..good.clone() }, "clock[0]: "),
            (MatchSettings { breaker: Breaker::Always(2), ..good.clone() }, "breaker: "),
            (MatchSettings { max_events: 0, ..good.clone() }, "max_events: "),
            (MatchSettings { same_break: Some(breaking), ..good.clone() }, "same_break.strike"),
            (MatchSettings { luck: Some(no_draws), ..good.clone() }, "luck.draws: "),
            (MatchSettings { table: Some("carom-10ft".into()), ..good.clone() }, "table: "),
        ] {
            let error = made(settings).unwrap_err().to_string();
            assert!(error.starts_with(place), "{error}");
        }
        assert!(made(good).is_ok());
    }

    #[test]
    fn rejects_players_without_a_name() {
        for name in ["", "a\nb", &"x".repeat(81)] {
            let players = [PlayerEntry::new("a"), PlayerEntry::new(name)];
            let error = Match::new(MatchSettings::new(Game::NineBall), players).unwrap_err();
            assert!(error.to_string().starts_with("players[1].name: "), "{error}");
        }
    }

    #[test]
    fn the_players_exchange_the_seats_or_the_streams() {
        let seeds = PairSeeds {
            rack: 1,
            errors: [2, 3],
            sight: [4, 5],
            decisions: [6, 7],
            luck: [8, 9],
            later: 10,
        };
        let alternate = made(MatchSettings::new(Game::NineBall)).unwrap();
        assert_eq!([alternate.seats(4), alternate.seats(5)], [[0, 1], [1, 0]]);
        assert_eq!([alternate.seeds(4, seeds), alternate.seeds(5, seeds)], [seeds; 2]);
        let breaker = Breaker::Always(1);
        let always = made(MatchSettings { breaker, ..MatchSettings::new(Game::NineBall) }).unwrap();
        assert_eq!([always.seats(4), always.seats(5)], [[1, 0], [1, 0]]);
        let exchanged =
            PairSeeds { errors: [3, 2], sight: [5, 4], decisions: [7, 6], luck: [9, 8], ..seeds };
        assert_eq!([always.seeds(4, seeds), always.seeds(5, seeds)], [seeds, exchanged]);
    }
}
