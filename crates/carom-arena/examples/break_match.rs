//! What a break is worth: two equal searching players, one of which breaks by itself, and the other full
//! from the middle of the head string at 8 m/s.
//!
//! ```sh
//! cargo run --release -p carom-arena --example break_match -- eight-ball wpa-9ft 1 1500 1000 out/breaks
//! ```
//!
//! The words are the game, the table, the multiple of the Computational Olympiad's errors, the
//! simulations of a decision, the number of pairs of frames, and a folder. The match uses one thread for
//! each core, or `CAROM_THREADS`. An interrupted match continues where it stopped.

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use carom::Noise;
use carom::format::Node;
use carom::runner::Runner;
use carom_arena::{Clock, Match, MatchPlan, MatchSettings, PlayerEntry, Secret, play_match};
use carom_mind::breaks::BreakShot;
use carom_mind::value::Logistic;
use carom_mind::{Player, SearchSettings, Searcher};
use carom_plan::Progress;
use carom_rules::Rules;

/// Cue speed of the break from the middle, m/s: the average of good players (docs/breaks.md).
const CENTER_SPEED: f64 = 8.0;
/// The secret of every such match, so that it can be repeated.
const SECRET: [u8; 32] = [0x62; 32];
const LEVEL: f64 = 0.95;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [game, table, noise, simulations, pairs, folder] = words.as_slice() else {
        return Err("usage: break_match GAME TABLE NOISE SIMULATIONS PAIRS FOLDER".into());
    };
    let settings = MatchSettings {
        table: Some(Node::from(table.as_str())),
        noise: [Noise::olympiad(noise.parse()?); 2],
        clock: [Clock::simulations(simulations.parse()?); 2],
        ..MatchSettings::new(Rules::read(game)?)
    };
    let players = ["own break", "centre break"].map(PlayerEntry::new);
    let plan = MatchPlan {
        of: Arc::new(Match::new(settings, players)?),
        pairs: pairs.parse()?,
        test: None,
        secret: Some(Secret::new(SECRET)),
    };
    let make = |player| -> Result<Box<dyn Player>, carom::Error> {
        let break_shot = (player == 1).then(|| BreakShot::center(CENTER_SPEED));
        let settings = SearchSettings { break_shot, ..SearchSettings::default() };
        Ok(Box::new(Searcher::new("carom", Box::new(Logistic), settings)?))
    };
    let threads = std::env::var("CAROM_THREADS").ok().map(|text| text.parse()).transpose()?;
    let runner = Runner::new(threads)?;
    let report = play_match(&plan, Path::new(folder), &make, &runner, &Progress::default())?;
    let score = report.score.pairs;
    let interval = score.interval(LEVEL);
    println!(
        "{game}, {table}, noise × {noise}: the own break wins {:.1} % ({:.1} to {:.1}) of {} pairs",
        100.0 * score.share(),
        100.0 * interval.low,
        100.0 * interval.high,
        report.pairs,
    );
    Ok(())
}
