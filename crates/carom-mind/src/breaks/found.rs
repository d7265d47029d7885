//! The breaks that were found, for common games, tables and errors.

use std::sync::LazyLock;

use carom::edition::{TABLES, find};
use carom::math::log;
use carom::{Noise, Physics};
use carom_rules::{Frame, Game};

use super::break_counts::BreakCounts;
use super::break_shot::BreakShot;

/// One line for each break. The example `find_breaks` adds those that are missing.
const DATA: &str = include_str!("found.csv");

static ENTRIES: LazyLock<Vec<FoundBreak>> =
    LazyLock::new(|| DATA.lines().skip(1).filter_map(FoundBreak::parse).collect());

/// A break that a search has found, with its counts on racks that took no part in the search.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundBreak {
    /// The game.
    pub game: Game,
    /// The dated name of the table, whose own physics was used.
    pub table: &'static str,
    /// The breaker's errors and the opponent's, as a multiple of the Computational Olympiad's.
    pub noise: f64,
    /// The break.
    pub shot: BreakShot,
    /// What it does.
    pub counts: BreakCounts,
    /// Simulations of the search.
    pub simulations: u64,
    /// The version of carom that made the search.
    pub version: &'static str,
}

/// How well a known break fits a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// It was searched on this table with these physics.
    Same,
    /// It was searched on another table, or with other physics.
    Similar,
}

/// Distance of two tables with different physics, in units of a logarithm of their widths: as much as
/// a twentieth of the width. Estimated.
const OTHER_PHYSICS: f64 = 0.05;
/// The smallest multiple of the Olympiad's errors whose logarithm is compared.
const LEAST_NOISE: f64 = 0.05;

/// All breaks that were found, in no special order.
pub fn entries() -> &'static [FoundBreak] {
    &ENTRIES
}

/// The known break of the game of `frame` that fits best, and how well it fits; none if the game
/// has none. Tables are compared first: the same one, or else one of similar width. Of the errors the
/// nearest are used, by the logarithm of [`multiplier`]. In practice the breaks of eight-ball are
/// used. The options of a frame make no difference.
pub fn found(frame: &Frame, noise: &Noise) -> Option<(&'static FoundBreak, Fit)> {
    let game = frame.game().opened_as();
    let wanted = log(multiplier(noise).max(LEAST_NOISE));
    let rank = |entry: &&FoundBreak| {
        (entry.distance(frame), (log(entry.noise.max(LEAST_NOISE)) - wanted).abs())
    };
    let of_game = ENTRIES.iter().filter(|entry| entry.game == game);
    let best = of_game.min_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    })?;
    let fit = if best.distance(frame) == 0.0 { Fit::Same } else { Fit::Similar };
    Some((best, fit))
}

/// The errors of a player as a multiple of the Computational Olympiad's, by the error of the azimuth:
/// in a break it decides how squarely the rack is hit.
pub fn multiplier(noise: &Noise) -> f64 {
    let [_, azimuth, ..] = noise.deviations(0.0);
    azimuth / Noise::olympiad(1.0).azimuth
}

impl FoundBreak {
    /// The first line of the data.
    pub const HEADER: &'static str = "game,table,noise,across,behind,aim,speed,side,height,\
        breaks,fallen,any_fallen,kept,fouls,game_ball,win,error,simulations,version";

    /// The break as a line of the data.
    pub fn line(&self) -> String {
        let Self { game, table, noise, shot, counts, simulations, version } = self;
        let BreakShot { across, behind, aim, speed, side, height } = shot;
        let BreakCounts { breaks, fallen, any_fallen, kept, fouls, game_ball, win, error } = counts;
        format!(
            "{},{table},{noise},{across},{behind},{aim},{speed},{side},{height},{breaks},{fallen},\
             {any_fallen},{kept},{fouls},{game_ball},{win:.4},{error:.4},{simulations},{version}",
            game.name(),
        )
    }

    fn parse(line: &'static str) -> Option<Self> {
        let mut words = line.split(',');
        let game = Game::named(words.next()?)?;
        let table = words.next()?;
        let mut number = || words.next()?.parse::<f64>().ok();
        let noise = number()?;
        let shot = BreakShot {
            across: number()?,
            behind: number()?,
            aim: number()?,
            speed: number()?,
            side: number()?,
            height: number()?,
        };
        let mut count = || Some(number()? as u64);
        let counts = BreakCounts {
            breaks: count()?,
            fallen: count()?,
            any_fallen: count()?,
            kept: count()?,
            fouls: count()?,
            game_ball: count()?,
            win: number()?,
            error: number()?,
        };
        let simulations = number()? as u64;
        let version = words.next()?;
        Some(Self { game, table, noise, shot, counts, simulations, version })
    }

    /// 0 on the same table with the same physics, else greater.
    fn distance(&self, frame: &Frame) -> f64 {
        let (table, physics) = (frame.base().table(), frame.base().physics());
        let Some(own) = find(TABLES, self.table) else { return f64::INFINITY };
        let name = table.name.as_deref().and_then(|name| find(TABLES, name));
        let same_physics = Physics::preset(own.physics).is_some_and(|own| own == **physics);
        let apart = if name == Some(own) {
            0.0
        } else {
            let width = carom::Table::preset(own.dated).map_or(f64::INFINITY, |t| t.size.x);
            // Two tables of one width can have different pockets.
            log(table.size.x / width).abs() + 0.5 * OTHER_PHYSICS
        };
        if same_physics { apart } else { apart + OTHER_PHYSICS }
    }
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom::format::Node;
    use carom_rules::{Frame, Game, Options};

    use super::{DATA, Fit, FoundBreak, entries, found};

    fn new_frame(game: Game, table: Option<&str>, physics: Option<&str>) -> Frame {
        let node = |name: Option<&str>| name.map(Node::from);
        Frame::new(game, Options::default(), node(table), node(physics), 0).unwrap()
    }

    #[test]
    fn the_data_are_what_their_entries_write_again() {
        let mut lines = DATA.lines();
        assert_eq!(lines.next(), Some(FoundBreak::HEADER));
        assert_eq!(lines.clone().count(), entries().len());
        for (line, entry) in lines.zip(entries()) {
            assert_eq!(line, entry.line());
        }
    }

    #[test]
    fn every_entry_is_found_for_its_own_game_table_and_errors() {
        assert!(!entries().is_empty());
        for entry in entries() {
            let frame = new_frame(entry.game, Some(entry.table), None);
            let best = found(&frame, &Noise::olympiad(entry.noise)).unwrap();
            assert_eq!(best, (entry, Fit::Same));
            assert!(entry.shot.play(&frame).is_ok(), "{}", entry.line());
        }
    }

    #[test]
    fn every_game_with_breaks_has_one_for_its_usual_table() {
        // The opening of a game for which no search was made is searched in every rack.
        let of = |game: &Game| entries().iter().any(|e| e.game == game.opened_as());
        let has_entry = |game: &Game| of(game) && game.table() == game.opened_as().table();
        assert!(Game::ALL.iter().filter(|game| has_entry(game)).count() >= 8);
        for game in Game::ALL.into_iter().filter(has_entry) {
            for multiplier in [0.0, 0.5, 1.0, 2.0, 9.0] {
                let frame = new_frame(game, None, None);
                let (entry, fit) = found(&frame, &Noise::olympiad(multiplier)).unwrap();
                assert_eq!(fit, Fit::Same, "{} {}", game.name(), entry.table);
            }
        }
    }

    #[test]
    fn another_table_or_other_physics_gets_the_break_of_a_similar_table() {
        let noise = Noise::olympiad(1.0);
        let cloth = new_frame(Game::NineBall, None, Some("pool-worn-cloth"));
        let (entry, fit) = found(&cloth, &noise).unwrap();
        assert_eq!((entry.table, fit), ("wpa-9ft-2026-12", Fit::Similar));
        let old = new_frame(Game::NineBall, Some("bar-7ft-2026-11"), None);
        let (entry, fit) = found(&old, &noise).unwrap();
        assert_eq!((entry.table, fit), ("bar-7ft-2026-12", Fit::Similar));
    }
}
