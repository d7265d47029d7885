//! A round robin of built-in players in five games, with clocks of simulated shots and a fixed secret. It writes
//! a record for each match into the folder. Two builds that play alike write the same bytes:
//! `python scripts/compare_builds.py` compares the debug with the release build.
//!
//! `cargo run -p carom-arena --example round_robin -- FOLDER`

use std::env;
use std::path::PathBuf;

use carom::Noise;
use carom::runner::Runner;
use carom_arena::{
    ArenaError, BuiltInPlayer, Clock, Match, MatchPlan, MatchSettings, Secret, play_match,
};
use carom_plan::Progress;
use carom_rules::{Game, Options};

/// The players, with the simulated shots of a decision.
const PLAYERS: [&str; 3] = ["carom:60", "pick-pocket:60", "greedy:20"];

const GAMES: [Game; 5] =
    [Game::EightBall, Game::NineBall, Game::Snooker, Game::StraightPool, Game::ThreeCushion];

const SECRET: Secret = Secret::new([7; 32]);

fn main() -> Result<(), ArenaError> {
    let Some(folder) = env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("write the folder for the records");
        std::process::exit(2);
    };
    let runner = Runner::new(None)?;
    for game in GAMES {
        for (i, one) in PLAYERS.iter().enumerate() {
            for other in &PLAYERS[i + 1..] {
                let players = [one, other].map(|name| BuiltInPlayer::read(name));
                let [one, other] = players;
                let players = [one?, other?];
                let settings = MatchSettings {
                    options: Options { points: 5, patience: 12, ..Options::default() },
                    noise: [const { Noise::olympiad(1.0) }; 2],
                    clock: players.each_ref().map(|player| player.clock(Clock::simulations(60))),
                    ..MatchSettings::new(game)
                };
                let of = Match::new(settings, players.each_ref().map(BuiltInPlayer::entry))?.into();
                let plan = MatchPlan { of, pairs: 1, test: None, secret: Some(SECRET) };
                let [one, other] = plan.of.players();
                let name = format!("{}/{}+{}", game.name(), one.name, other.name);
                let make = |player: usize| players[player].make();
                play_match(&plan, &folder.join(&name), &make, &runner, &Progress::default())?;
                eprintln!("{name}");
            }
        }
    }
    Ok(())
}
