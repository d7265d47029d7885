//! Finds the breaks of `src/breaks/found.csv`: those that are missing there are searched, and each is
//! added to the file when it is found. So an interrupted run continues where it stopped. To search a
//! break again, remove its line.
//!
//! ```sh
//! cargo run --release -p carom-mind --example find_breaks
//! cargo run --release -p carom-mind --example find_breaks -- --only nine-ball,wpa-9ft,1 --threads 1
//! cargo run --release -p carom-mind --example find_breaks -- --table
//! ```
//!
//! `--only GAME,TABLE,NOISE` searches one break; `--table` prints the found ones as the table of
//! docs/think.md; `--threads` is the number of threads, which changes nothing else; `--simulations` is
//! the number of simulations of each of the searches of an entry.

use std::error::Error;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

use carom::Noise;
use carom::edition::{TABLES, find};
use carom::format::Node;
use carom::runner::Runner;
use carom_mind::Situation;
use carom_mind::breaks::{BreakCounts, BreakShot, Fit, FoundBreak, found as shipped};
use carom_mind::search::{BreakSearch, Racks};
use carom_mind::value::Logistic;
use carom_rules::{Frame, Game, GameFacts, OpeningKind, Options};

/// The breaks that are shipped: games with their tables.
const WANTED: [(Game, &[&str]); 7] = [
    (Game::EightBall, &POOL),
    (Game::NineBall, &POOL),
    (Game::TenBall, &POOL),
    (Game::StraightPool, &POOL),
    (Game::Snooker, &["snooker-12ft"]),
    (Game::SixRed, &["snooker-12ft"]),
    (Game::ThreeCushion, &["carom-10ft"]),
];
const POOL: [&str; 4] = ["wpa-9ft", "wpa-8ft", "bar-7ft", "poolfiz"];
/// Multiples of the Olympiad's errors.
const NOISES: [f64; 3] = [1.0, 0.5, 2.0];
/// Searches with different seeds for each break, and the simulations of each.
const SEARCHES: u64 = 4;
const SIMULATIONS: u64 = 150_000;
/// Speeds of the full hits from the middle with which every second search of a hard break begins, m/s.
const CENTER_SPEEDS: [f64; 4] = [8.0, 9.0, 10.5, 12.0];
/// Racks of the counts, one in how many is searched for its next shot, the simulations of such a
/// search, and the seed. The same seed for all breaks, so that they are
/// compared on the same racks.
const RACKS: u64 = 2000;
const EVERY: u64 = 8;
const PER_REPLY: u64 = 160;
const SEED: u64 = 0x636f_756e_7473;

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (mut threads, mut simulations, mut only) = (None, SIMULATIONS, None);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
        match word.as_str() {
            "--table" => return print_table(),
            "--only" => only = Some(value()?),
            "--threads" => threads = Some(value()?.parse()?),
            "--simulations" => simulations = value()?.parse()?,
            _ => return Err(format!("unknown word {word}; look at the top of this file").into()),
        }
    }
    let runner = Runner::new(threads)?;
    for noise in NOISES {
        for (game, tables) in WANTED {
            for table in tables {
                let key = format!("{},{table},{noise}", game.name());
                if only.as_ref().is_none_or(|only| *only == key) {
                    add(game, table, noise, (simulations, &runner))?;
                }
            }
        }
    }
    Ok(())
}

fn data() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/breaks/found.csv")
}

/// Searches a break and adds it to the data, unless it is there.
fn add(
    game: Game,
    table: &str,
    noise: f64,
    (simulations, runner): (u64, &Runner),
) -> Result<(), Box<dyn Error>> {
    let dated = find(TABLES, table).ok_or("an unknown table")?.dated;
    let key = format!("{},{dated},{noise},", game.name());
    if std::fs::read_to_string(data())?.lines().any(|line| line.starts_with(&key)) {
        return Ok(());
    }
    let began = Instant::now();
    let frame = Frame::new(game, Options::default(), Some(Node::from(table)), None, 0)?;
    let value = Logistic;
    let of_player = Noise::olympiad(noise);
    let is_hard = GameFacts::of(game).opening.kind == OpeningKind::Break;
    let speeds: &[f64] = if is_hard { &CENTER_SPEEDS } else { &[] };
    let centers = speeds.iter().map(|speed| BreakShot::center(*speed));
    // The break that is shipped now is compared with the new ones.
    let known = shipped(&frame, &of_player).filter(|(_, fit)| *fit == Fit::Same);
    let start: Vec<BreakShot> =
        known.map(|(entry, _)| entry.shot).into_iter().chain(centers).collect();
    let mut found = start.clone();
    let mut spent = 0;
    for seed in 0..SEARCHES {
        let situation = Situation::new(&frame, of_player.clone(), seed << 48);
        let start: &[BreakShot] = if seed % 2 == 0 { &start } else { &[] };
        let search = BreakSearch::new(&situation, &value, simulations, start)?;
        let (shot, counts, plays) = search.run(runner)?;
        spent += plays;
        eprintln!("{key} {shot:?} {:.3} ± {:.3}", counts.win, counts.error);
        found.push(shot);
    }
    let situation = Situation::new(&frame, of_player.clone(), SEED);
    let racks = Racks::new(&situation, &value)?.with_replies(EVERY, PER_REPLY);
    // The winner is chosen on other racks than those of its counts.
    let (counts, _) = racks.count(&found, 0, RACKS, runner)?;
    let best = (0..found.len()).max_by(|a, b| counts[*a].compare(&counts[*b]));
    let shot = found[best.ok_or("no search")?];
    let (counts, _) = racks.count(&[shot], RACKS, RACKS, runner)?;
    let version = env!("CARGO_PKG_VERSION");
    let counts = counts[0];
    let entry = FoundBreak { game, table: dated, noise, shot, counts, simulations: spent, version };
    let mut file = OpenOptions::new().append(true).open(data())?;
    writeln!(file, "{}", entry.line())?;
    eprintln!("{}  {:.0} s", entry.line(), began.elapsed().as_secs_f64());
    Ok(())
}

/// The found breaks as a table in Markdown.
fn print_table() -> Result<(), Box<dyn Error>> {
    for entry in carom_mind::breaks::entries() {
        println!("{}", row(entry));
    }
    Ok(())
}

fn row(entry: &FoundBreak) -> String {
    let FoundBreak { game, table, noise, shot, counts, .. } = entry;
    let BreakShot { across, behind, aim, speed, side, height } = shot;
    let BreakCounts { breaks, fallen, any_fallen, kept, fouls, game_ball, win, error } = counts;
    let name = find(TABLES, table).map_or(*table, |edition| edition.name);
    let share = |count: &u64| 100.0 * *count as f64 / *breaks as f64;
    format!(
        "| {} | {name} | {noise} | {across:.2}, {behind:.2} | {aim:.2} | {speed:.1} | {side:.2}, \
         {height:.2} | {:.2} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} ± {:.1} |",
        game.name(),
        *fallen as f64 / *breaks as f64,
        share(any_fallen),
        share(kept),
        share(fouls),
        share(game_ball),
        100.0 * win,
        100.0 * error,
    )
}
