//! The programs of examples/arena: they pass every check and play a frame, as real processes.
#![cfg(all(feature = "programs", target_os = "linux"))]

mod common;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use carom::{Error, ErrorKind};
use carom_arena::{
    ArenaFrame, Ask, ChannelFault, CheckSettings, Clock, Confinement, Effect, MatchPlayer,
    ProgramChannel, ProgramOrder, ProtocolPlayer, ProtocolSettings, Response, SupervisorCommand,
    check, play_frame,
};
use carom_mind::Budget;
use carom_plan::Progress;
use carom_rules::{FrameSimulator, Game};
use common::{Folder, RandomPlayer, SECRET, made, short};

/// The folder of the examples.
const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/arena");

/// An error of a program that does not start.
fn started(fault: ChannelFault) -> Error {
    ErrorKind::System.at("program", format!("{fault:?}"), "look at the example")
}

fn program(
    words: &[String],
    settings: ProtocolSettings,
) -> Result<ProtocolPlayer<ProgramChannel<'static>>, Error> {
    let order = ProgramOrder::new(words.to_vec(), Confinement::Plain);
    let supervisor = SupervisorCommand {
        program: env!("CARGO_BIN_EXE_carom-supervisor").into(),
        arguments: vec![],
    };
    let channel =
        ProgramChannel::start(&order, &supervisor, Arc::new(|| false)).map_err(started)?;
    ProtocolPlayer::new(channel, settings)
}

/// Prints that a program is missing. A macro would print it only if the test failed.
fn say_missing(program: &str) {
    let line = format!("\n{program} is missing: its example is not tested\n");
    io::stderr().write_all(line.as_bytes()).unwrap();
}

/// Runs a compiler; false if the machine has none.
fn compiled(compiler: &str, arguments: &[&str]) -> bool {
    match Command::new(compiler).args(arguments).current_dir(EXAMPLES).output() {
        Ok(done) => {
            assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
            true
        }
        Err(_) => {
            say_missing(compiler);
            false
        }
    }
}

/// Where a program is on this machine.
fn found(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file())
}

/// Checks a program, and lets it play a frame of nine-ball in which it pots a ball.
fn plays(words: &[String]) {
    let settings = CheckSettings { clock: Clock::seconds(60.0).per_frame(), is_program: true };
    let make = |settings| program(words, settings);
    let found = check(&make, &settings, &Progress::default(), &mut |_| ()).unwrap();
    for verdict in &found {
        assert_eq!(verdict.passed, Some(true), "{verdict:?}");
    }
    let mut simulator = FrameSimulator::new();
    let of = made(short(Game::NineBall));
    let mut frame = ArenaFrame::begin(of, 0, SECRET.pair_seeds(1), &mut simulator).unwrap();
    let mut players = [
        Seat::Program(Box::new(program(words, ProtocolSettings::default()).unwrap())),
        Seat::Random(Box::new(RandomPlayer)),
    ];
    play_frame(&mut frame, &mut players, &mut simulator, &Progress::default()).unwrap();
    let own = || frame.moves().iter().filter(|made| made.seat == 0);
    let legal = own().filter(|made| match &made.effect {
        Effect::Played { ruling, .. } => ruling.is_legal(),
        _ => false,
    });
    assert!(2 * legal.count() >= own().count(), "{:?}", frame.end());
    assert!(own().all(|made| !matches!(made.effect, Effect::Refused(_))));
}

enum Seat {
    Program(Box<ProtocolPlayer<ProgramChannel<'static>>>),
    Random(Box<dyn carom_mind::Player>),
}

impl MatchPlayer for Seat {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        match self {
            Self::Program(player) => player.respond(ask, budget),
            Self::Random(player) => player.respond(ask, budget),
        }
    }
}

fn words(words: &[&Path]) -> Vec<String> {
    words.iter().map(|word| word.display().to_string()).collect()
}

#[test]
fn the_player_in_python_passes_every_check_and_plays() {
    let python = found("python3").unwrap();
    plays(&words(&[&python, &Path::new(EXAMPLES).join("player.py")]));
}

#[test]
fn the_player_in_javascript_passes_every_check_and_plays() {
    match found("node") {
        Some(node) => plays(&words(&[&node, &Path::new(EXAMPLES).join("player.mjs")])),
        None => say_missing("node"),
    }
}

#[test]
fn the_player_in_cpp_passes_every_check_and_plays() {
    let folder = Folder::new("example-cpp");
    std::fs::create_dir_all(folder.path()).unwrap();
    let binary = folder.path().join("player");
    let output = binary.display().to_string();
    if compiled(
        "g++",
        &["-O1", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-o", &output, "player.cpp"],
    ) {
        plays(&words(&[&binary]));
    }
}

#[test]
fn the_player_in_rust_passes_every_check_and_plays() {
    let folder = Folder::new("example-rust");
    std::fs::create_dir_all(folder.path()).unwrap();
    let binary = folder.path().join("player");
    let output = binary.display().to_string();
    assert!(compiled(
        "rustc",
        &["-O", "--edition", "2021", "-D", "warnings", "-o", &output, "player.rs"]
    ));
    plays(&words(&[&binary]));
}

#[test]
fn every_example_has_at_most_a_hundred_lines() {
    for name in ["player.py", "player.mjs", "player.cpp", "player.rs"] {
        let text = std::fs::read_to_string(Path::new(EXAMPLES).join(name)).unwrap();
        assert!(text.lines().count() <= 100, "{name}: {}", text.lines().count());
    }
}
