//! Frames against programs that behave badly. Each loses for the right reason and leaves nothing behind,
//! and its opponent plays on as usual.
#![cfg(all(feature = "programs", target_os = "linux"))]

mod common;
mod sessions;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use carom_arena::{
    ArenaFrame, Ask, Clock, Confinement, Effect, EndReason, Match, MatchPlayer, MatchSettings,
    PlayerEntry, ProgramCommand, ProgramPlayer, ProgramSite, Response, Secret, play_frame,
};
use carom_mind::{Budget, Player};
use carom_plan::Progress;
use carom_rules::{FrameSimulator, Game};
use common::{RandomPlayer, short};
use sessions::{processes_with, supervisor};

/// A program that behaves badly once it is asked, and what follows.
struct Case {
    name: &'static str,
    /// Commands of the shell, after the first request was read.
    script: &'static str,
    settings: &'static str,
    /// The clock of the frame, s.
    clock: f64,
    reason: EndReason,
    /// Refused answers.
    refused: usize,
}

const fn case(name: &'static str, script: &'static str, reason: EndReason) -> Case {
    Case { name, script, settings: "", clock: 60.0, reason, refused: 0 }
}

/// A program whose time runs out.
const fn slow(name: &'static str, script: &'static str) -> Case {
    Case { clock: 0.3, ..case(name, script, EndReason::TimeOver) }
}

/// A program that writes this line whenever it is asked.
const fn repeated(name: &'static str, script: &'static str) -> Case {
    Case { refused: 11, ..case(name, script, EndReason::Refusals) }
}

const CASES: [Case; 26] = [
    slow("half a line", "printf '{\"type\": \"concede\", \"id\"'; sleep 100"),
    case("half a line and death", "printf '{\"type\"'", EndReason::Crash),
    repeated("bad UTF-8", "while :; do printf '\\377\\376\\n'; read -r l; done"),
    repeated("no JSON", "while :; do echo hello; read -r l; done"),
    repeated("an empty line", "while :; do echo; read -r l; done"),
    repeated(
        "NaN",
        "while :; do echo '{\"type\":\"play\",\"id\":1,\"strike\":{\"speed\":NaN,\"azimuth\":1}}'
        read -r l; done",
    ),
    repeated(
        "a number that is too large",
        "while :; do echo '{\"type\":\"play\",\"id\":1,\"strike\":{\"speed\":1e999,\"azimuth\":1}}'
        read -r l; done",
    ),
    repeated(
        "100 000 brackets",
        "b=$(printf '%0100000d' 0 | tr 0 '[')\nwhile :; do echo \"$b\"; read -r l; done",
    ),
    repeated("a stale answer", "while :; do echo '{\"type\":\"concede\",\"id\":0}'; read -r l; done"),
    Case {
        refused: 1,
        ..case(
            "two answers",
            "a='{\"type\":\"play\",\"id\":1,\"cue_ball\":[0.6,0.5],\"strike\":{\"speed\":0.2,\"azimuth\":-1.5}}'
            echo \"$a\"; echo \"$a\"; read -r l; read -r l; echo '{\"type\":\"concede\",\"id\":2}'; sleep 100",
            EndReason::Conceded,
        )
    },
    slow("unread input", "sleep 100"),
    slow("an answer a millisecond late", "sleep 0.301; echo '{\"type\":\"concede\",\"id\":1}'; sleep 100"),
    slow("stopped by itself", "kill -STOP $$"),
    slow("SIGTERM is ignored", "trap '' TERM; while :; do sleep 1; done"),
    case("a flood on stderr", "yes >&2", EndReason::Flood),
    case("a flood", "yes '{}' | head -n 100000; sleep 100", EndReason::Flood),
    case("a line that is too long", "head -c 3000000 /dev/zero; sleep 100", EndReason::LongLine),
    case("death", "exit 3", EndReason::Crash),
    case("death by a signal", "kill -SEGV $$", EndReason::Crash),
    case("closed output", "exec >&-; sleep 100", EndReason::Crash),
    case(
        "a fork bomb",
        "bomb() { if [ $1 -gt 0 ]; then bomb $(($1 - 1)) & bomb $(($1 - 1)) & fi; sleep 100; }; bomb 7",
        EndReason::Crash,
    ),
    case(
        "a daemon",
        "(setsid sh -c 'trap \"\" TERM HUP; exec sleep 100' </dev/null >/dev/null 2>&1 &)
        echo '{\"type\":\"concede\",\"id\":1}'; sleep 100",
        EndReason::Conceded,
    ),
    case("death with a daemon", "setsid sleep 100 & exit 0", EndReason::Crash),
    case(
        "a socket",
        "python3 -c 'import socket; s = socket.socket(); s.bind((\"127.0.0.1\", 0)); s.listen(); s.accept()' &
        echo '{\"type\":\"concede\",\"id\":1}'; sleep 100",
        EndReason::Conceded,
    ),
    Case {
        settings: "[file=1]",
        ..case(
            "a huge file",
            "head -c 3000000 /dev/zero > huge; [ $(wc -c < huge) -le 1048576 ] || exit 1
            echo '{\"type\":\"concede\",\"id\":1}'; sleep 100",
            EndReason::Conceded,
        )
    },
    Case {
        settings: "[memory=64]",
        ..case("much memory", "python3 -c 'x = b\"x\" * (200 << 20); input()'", EndReason::Crash)
    },
];

/// The players of a frame.
enum Seated<'s> {
    Program(Box<ProgramPlayer<'s>>),
    Random(Box<dyn Player>),
}

impl MatchPlayer for Seated<'_> {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        match self {
            Self::Program(player) => player.respond(ask, budget),
            Self::Random(player) => player.respond(ask, budget),
        }
    }

    fn seconds(&self) -> Option<f64> {
        match self {
            Self::Program(player) => player.seconds(),
            Self::Random(_) => None,
        }
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        match self {
            Self::Program(player) => player.frame_over(frame),
            Self::Random(_) => {}
        }
    }
}

/// Plays a frame against the program, and returns what is wrong with the outcome.
fn faults(case: &Case, secret: Secret) -> Vec<String> {
    let quoted = case.script.replace('\'', "'\\''");
    let greeting = "echo $HOME >&2; read -r l; echo \"{\\\"type\\\":\\\"hello\\\"}\"
        read -r l; echo \"{\\\"type\\\":\\\"ready\\\"}\"; read -r l";
    let name = format!("exec{}:sh -c '{greeting}\n{quoted}'", case.settings);
    let command = Arc::new(ProgramCommand::read(&name, Path::new("")).unwrap());
    let log = Arc::new(Mutex::new(String::new()));
    let kept = Arc::clone(&log);
    let site = Arc::new(ProgramSite {
        supervisor: supervisor(),
        confinement: Confinement::Plain,
        hidden: Vec::new(),
        log: Some(Box::new(move |block| *kept.lock().unwrap() += &block)),
    });
    let clock = [Clock::seconds(case.clock).per_frame(), Clock::seconds(600.0).per_frame()];
    let settings = MatchSettings { clock, ..short(Game::NineBall) };
    let players = [PlayerEntry::new("hostile"), PlayerEntry::new("random")];
    let of = Arc::new(Match::new(settings, players).unwrap());
    let mut simulator = FrameSimulator::new();
    let mut frame = ArenaFrame::begin(of, 0, secret.pair_seeds(0), &mut simulator).unwrap();
    let program = ProgramPlayer::new(command, site, Arc::new(|| false));
    let mut seated = [Seated::Program(Box::new(program)), Seated::Random(Box::new(RandomPlayer))];
    play_frame(&mut frame, &mut seated, &mut simulator, &Progress::default()).unwrap();
    drop(seated);
    let mut found = Vec::new();
    let mut check = |is_right: bool, what: String| {
        if !is_right {
            found.push(format!("{}: {what}", case.name));
        }
    };
    let end = frame.end().unwrap();
    check(end.reason == case.reason && end.winner == Some(1), format!("{end:?}"));
    let of_other = frame.moves().iter().filter(|done| done.seat == 1);
    check(
        of_other
            .clone()
            .all(|done| matches!(done.effect, Effect::Played { .. } | Effect::Chosen { .. })),
        "the opponent was disturbed".into(),
    );
    let refused = frame.moves().iter().filter(|done| matches!(done.effect, Effect::Refused(_)));
    let refused = refused.count();
    check(refused == case.refused, format!("{refused} refused answers"));
    let log = log.lock().unwrap();
    let folder = log.lines().nth(1).map(PathBuf::from);
    match folder.filter(|folder| folder.is_absolute()) {
        Some(folder) => {
            let left = processes_with(&folder);
            check(left.is_empty(), format!("{left:?} are left"));
            check(!folder.exists(), "its folder is left".into());
        }
        None => check(false, format!("no folder in its log: {log}")),
    }
    found
}

#[test]
fn a_program_that_behaves_badly_loses_for_the_right_reason_and_leaves_nothing() {
    let all: Vec<String> = std::thread::scope(|scope| {
        let each = CASES.each_ref().map(|case| scope.spawn(|| faults(case, common::SECRET)));
        each.into_iter().flat_map(|session| session.join().unwrap()).collect()
    });
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// Sessions between two lines that say how many are done.
const PROGRESS: usize = 500;

/// Run it with `cargo test --release -p carom-arena --test hostile ten_thousand -- --ignored --nocapture`.
/// It prints every fault when it is found. The number
/// of sessions is 10 000, or that of the variable `CAROM_SESSIONS`.
#[test]
#[ignore = "it takes about an hour of one core"]
fn ten_thousand_hostile_sessions() {
    let number = std::env::var("CAROM_SESSIONS").ok().and_then(|text| text.parse().ok());
    let number: usize = number.unwrap_or(10_000);
    let next = AtomicUsize::new(0);
    let results = Mutex::new((BTreeMap::<&str, usize>::new(), Vec::new(), Duration::ZERO));
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                loop {
                    let session = next.fetch_add(1, Ordering::Relaxed);
                    if session >= number {
                        break;
                    }
                    let case = &CASES[session % CASES.len()];
                    let begin = Instant::now();
                    let wrong = faults(case, Secret::from_os().unwrap());
                    let mut results = results.lock().unwrap();
                    wrong.iter().for_each(|fault| println!("session {session}: {fault}"));
                    *results.0.entry(case.reason.name()).or_default() += 1;
                    results.1.extend(wrong);
                    results.2 = results.2.max(begin.elapsed());
                    let done: usize = results.0.values().sum();
                    if done.is_multiple_of(PROGRESS) {
                        println!("{done} sessions, {} faults", results.1.len());
                    }
                }
            });
        }
    });
    let (reasons, wrong, longest) = results.into_inner().unwrap();
    println!("{number} sessions, expected reasons {reasons:?}; the longest took {longest:?}");
    println!("{} faults\n{}", wrong.len(), wrong.join("\n"));
    assert!(wrong.is_empty());
}

/// A player and the times of its responses, s.
struct Timed<P: MatchPlayer> {
    player: P,
    times: Vec<f64>,
}

impl<P: MatchPlayer> MatchPlayer for Timed<P> {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        let begin = Instant::now();
        let response = self.player.respond(ask, budget);
        self.times.push(begin.elapsed().as_secs_f64());
        response
    }
}

/// Prints what a shot of a program costs beyond its own thinking: the medians of the time until the
/// answer of a program, which replies at once, and of a player in this process.
/// `cargo test --release -p carom-arena --test hostile overhead -- --ignored --nocapture`
#[test]
#[ignore = "it measures times"]
fn the_overhead_of_a_program() {
    let program = r#"
import json, sys
STRIKE = {"speed": 0.2, "azimuth": -1.5}
for line in sys.stdin:
    message = json.loads(line)
    answer = {"id": message.get("id")}
    if message["type"] == "hello": answer = {"type": "hello"}
    elif message["type"] == "match": answer = {"type": "ready"}
    elif message["type"] != "request": continue
    elif message["kind"] == "choice": answer |= {"type": "choose", "choice": message["choices"][0]}
    else:
        answer |= {"type": "play", "strike": STRIKE}
        if message["in_hand"]: answer["cue_ball"] = [0.6, 0.5]
    print(json.dumps(answer), flush=True)
"#;
    let name = format!("exec:python3 -c {}", shlex::try_quote(program).unwrap());
    let command = Arc::new(ProgramCommand::read(&name, Path::new("")).unwrap());
    let mut simulator = FrameSimulator::new();
    let mut median_of = |confinement| {
        let site = Arc::new(ProgramSite {
            supervisor: supervisor(),
            confinement,
            hidden: Vec::new(),
            log: None,
        });
        let settings = MatchSettings { clock: [Clock::default(); 2], ..short(Game::ThreeCushion) };
        let players = [PlayerEntry::new("program"), PlayerEntry::new("same")];
        let of = Arc::new(Match::new(settings, players).unwrap());
        let mut times = Vec::new();
        // Soft strikes end a frame by its second stalemate, after fifty shots.
        for pair in 0..24 {
            let seeds = common::SECRET.pair_seeds(pair);
            let mut frame = ArenaFrame::begin(of.clone(), 0, seeds, &mut simulator).unwrap();
            let program = || {
                let (command, site) = (Arc::clone(&command), Arc::clone(&site));
                let player = ProgramPlayer::new(command, site, Arc::new(|| false));
                Timed { player, times: Vec::new() }
            };
            let mut seated = [program(), program()];
            play_frame(&mut frame, &mut seated, &mut simulator, &Progress::default()).unwrap();
            // The first response has the start of the program.
            times.extend(seated.iter().flat_map(|player| &player.times[1..]).copied());
        }
        times.sort_by(f64::total_cmp);
        (times.len(), times[times.len() / 2], times[times.len() * 9 / 10])
    };
    for confinement in [Confinement::Plain, Confinement::strongest()] {
        let (shots, median, most) = median_of(confinement);
        println!(
            "{}: {shots} shots, median {:.0} µs, nine tenths within {:.0} µs",
            confinement.name(),
            1e6 * median,
            1e6 * most
        );
    }
}
