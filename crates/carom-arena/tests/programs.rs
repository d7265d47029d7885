//! External programs: lines, deadlines, limits, and that nothing is left running.
#![cfg(all(feature = "programs", target_os = "linux"))]

mod sessions;

use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use carom_arena::{
    ChannelFault, Confinement, LineChannel, ProgramChannel, ProgramOrder, SupervisorCommand,
};
use sessions::{Session, processes_with, python, shell, start, states, supervisor};

fn soon() -> Option<Instant> {
    Some(Instant::now() + Duration::from_secs(20))
}

fn after(milliseconds: u64) -> Option<Instant> {
    Some(Instant::now() + Duration::from_millis(milliseconds))
}

/// The fault after the first line.
fn fault(session: &mut Session) -> ChannelFault {
    session.channel.receive(soon()).unwrap_err()
}

#[test]
fn lines_go_to_a_program_and_come_back() {
    let mut session = start(shell("while read line; do echo \"got $line\"; done"));
    for text in ["one", "ü { } \"", ""] {
        session.channel.send(text, soon()).unwrap();
        assert_eq!(session.channel.receive(soon()).unwrap(), format!("got {text}"));
    }
    session.ends();
}

#[test]
fn a_carriage_return_before_the_line_feed_is_no_part_of_a_line() {
    let mut session = start(shell("printf 'a\\r\\nb\\n'"));
    assert_eq!(session.channel.receive(soon()).unwrap(), "a");
    assert_eq!(session.channel.receive(soon()).unwrap(), "b");
    session.ends();
}

#[test]
fn a_program_that_ends_is_a_crash_with_its_status_and_last_words() {
    for (script, how) in [
        ("exit 0", "with exit status 0"),
        (
            "echo oh >&2; echo dear >&2; exit 3",
            "with exit status 3; the last line on its stderr: dear",
        ),
        ("kill -KILL $$", "by signal 9"),
        ("printf half; exit 1", "with exit status 1"),
    ] {
        let mut session = start(shell(script));
        let ChannelFault::Crash(why) = fault(&mut session) else { panic!("{script}") };
        assert_eq!(why, format!("the program ended {how}"));
        session.ends();
    }
}

#[test]
fn what_a_program_wrote_before_its_end_is_still_read() {
    let mut session = start(shell("echo last; exit 1"));
    std::thread::sleep(Duration::from_millis(100));
    assert_eq!(session.channel.receive(soon()).unwrap(), "last");
    assert!(matches!(fault(&mut session), ChannelFault::Crash(_)));
    session.ends();
}

#[test]
fn a_program_that_cannot_be_started_is_a_crash() {
    let order = ProgramOrder::new(vec!["/no/such".into()], Confinement::Plain);
    let start = |supervisor: SupervisorCommand| {
        ProgramChannel::start(&order, &supervisor, Arc::new(|| false)).err()
    };
    let Some(ChannelFault::Crash(why)) = start(supervisor()) else { panic!("it started") };
    assert!(why.starts_with("the program could not be started: "), "{why}");
    let missing = SupervisorCommand { program: "/no/such".into(), arguments: vec![] };
    let Some(ChannelFault::Crash(why)) = start(missing) else { panic!("it started") };
    assert!(why.starts_with("the supervisor could not be started: "), "{why}");
}

#[test]
fn the_time_of_an_answer_ends_at_its_deadline() {
    let mut session = start(shell("sleep 0.4; echo late; sleep 100"));
    let begin = Instant::now();
    assert_eq!(session.channel.receive(after(100)), Err(ChannelFault::TimeOver));
    assert!(begin.elapsed() >= Duration::from_millis(100));
    session.ends();
}

#[test]
fn a_program_that_does_not_read_cannot_hold_the_referee_up() {
    let mut session = start(shell("sleep 100"));
    // The pipe takes 64 KiB.
    assert_eq!(session.channel.send(&"x".repeat(1 << 18), after(100)), Err(ChannelFault::TimeOver));
    session.ends();
}

#[test]
fn a_program_that_has_closed_its_input_may_answer() {
    let mut session = start(shell("exec <&-; sleep 0.2; echo here; sleep 100"));
    session.channel.send(&"x".repeat(1 << 18), soon()).unwrap();
    assert_eq!(session.channel.receive(soon()).unwrap(), "here");
    session.ends();
}

#[test]
fn a_line_that_is_too_long_and_a_flood_are_faults_of_their_own() {
    let mut session = start(python("print('x' * (1 << 20)); print('x' * ((1 << 20) + 1))"));
    assert_eq!(session.channel.receive(soon()).unwrap().len(), 1 << 20);
    assert_eq!(fault(&mut session), ChannelFault::LongLine);
    session.ends();
    let mut session = start(python("while True: print('x', end='')"));
    assert_eq!(fault(&mut session), ChannelFault::LongLine);
    session.ends();
    let mut session = start(python("input(); print('{}\\n' * 100000)"));
    session.channel.send("", soon()).unwrap();
    assert_eq!(fault(&mut session), ChannelFault::Flood);
    session.ends();
}

#[test]
fn a_line_that_is_not_utf8_is_a_fault_after_which_lines_can_be_read() {
    let mut session = start(shell("printf '\\377\\nok\\n'"));
    assert_eq!(fault(&mut session), ChannelFault::NotUtf8);
    assert_eq!(session.channel.receive(soon()).unwrap(), "ok");
    session.ends();
}

#[test]
fn a_flood_on_stderr_is_dropped_up_to_a_limit() {
    let flood = |blocks| {
        python(&format!(
            "import sys\nfor _ in range({blocks}): sys.stderr.write('x' * (1 << 20))\nprint('ok')"
        ))
    };
    let mut session = start(flood(8));
    assert_eq!(session.channel.receive(soon()).unwrap(), "ok");
    assert_eq!(session.ends().text().len(), 1 << 16);
    let mut session = start(flood(1 << 20));
    assert_eq!(fault(&mut session), ChannelFault::Flood);
    session.ends();
}

#[test]
fn a_program_that_waits_is_stopped_with_all_its_processes() {
    // One of the two processes has a session of its own.
    let script = "setsid sh -c 'while :; do :; done' &
while read line; do echo $line; done";
    let mut session = start(shell(script));
    for text in ["one", "two"] {
        session.channel.send(text, soon()).unwrap();
        assert_eq!(session.channel.receive(soon()).unwrap(), text);
        let until = soon().unwrap();
        // The referee does not wait for the stop.
        while states(&session.folder) != "TT" {
            assert!(Instant::now() < until, "the states are {}", states(&session.folder));
            std::thread::sleep(Duration::from_millis(5));
        }
    }
    session.ends();
}

/// The states of the threads of a process, a letter each.
fn thread_states(pid: &str) -> String {
    let threads = std::fs::read_dir(format!("/proc/{pid}/task")).into_iter().flatten().flatten();
    let state = |stat: String| stat.rsplit_once(") ")?.1.chars().next();
    let mut found: Vec<char> = threads
        .filter_map(|thread| state(std::fs::read_to_string(thread.path().join("stat")).ok()?))
        .collect();
    found.sort_unstable();
    found.into_iter().collect()
}

/// Waits until these processes have threads in these states.
fn wait_for_states(processes: &[&str], expected: [&str; 2]) {
    let until = soon().unwrap();
    loop {
        let found: Vec<String> = processes.iter().map(|pid| thread_states(pid)).collect();
        if found == expected {
            return;
        }
        assert!(Instant::now() < until, "{found:?} are not {expected:?}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_process_is_stopped_that_looks_ended_or_that_a_thread_has_started() {
    // The first thread of a process that only waits for its parent has ended too. A thread has a list of
    // children of its own.
    let mut session = start(python(
        "import ctypes, os, sys, threading
def spin():
    while True: pass
def detached(act):
    pid = os.fork()
    if pid == 0:
        os.setsid()
        act()
    return pid
def without_first_thread():
    threading.Thread(target=spin).start()
    ctypes.CDLL(None).pthread_exit(None)
children = [detached(without_first_thread)]
starter = threading.Thread(target=lambda: (children.append(detached(spin)), threading.Event().wait()))
starter.daemon = True
starter.start()
while len(children) < 2 or ') Z ' not in open(f'/proc/{children[0]}/stat').read(): pass
for line in sys.stdin: print(*children, flush=True)",
    ));
    for _ in 0..2 {
        session.channel.send("", soon()).unwrap();
        let children = session.channel.receive(soon()).unwrap();
        let children: Vec<&str> = children.split(' ').collect();
        wait_for_states(&children, ["TZ", "T"]);
        session.channel.send("", soon()).unwrap();
        wait_for_states(&children, ["RZ", "R"]);
        session.channel.receive(soon()).unwrap();
    }
    session.ends();
}

#[test]
fn nothing_is_left_of_processes_that_hide_or_refuse_to_end() {
    for script in [
        // SIGTERM is ignored.
        "trap '' TERM; while :; do sleep 1; done",
        // A child that outlives the program.
        "sleep 100 & exit 0",
        // A daemon: its parent has ended, and its session is its own.
        "(setsid sh -c 'trap \"\" TERM HUP; exec sleep 100' &) ; exit 0",
        "(setsid sh -c 'trap \"\" TERM HUP; exec sleep 100' &) ; sleep 100",
        // Stopped by itself.
        "kill -STOP $$",
    ] {
        let mut session = start(shell(script));
        std::thread::sleep(Duration::from_millis(50));
        let _ = session.channel.receive(after(50));
        session.ends();
    }
}

/// Not a test of its own: the referee that the next test kills.
#[test]
#[ignore = "the next test runs it"]
fn a_referee_with_a_program() {
    let session = start(shell("(setsid sleep 100 &); sleep 100"));
    println!("folder={}", session.folder.display());
    std::thread::sleep(Duration::from_secs(60));
}

#[test]
fn nothing_is_left_if_the_referee_is_killed() {
    let mut referee = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "a_referee_with_a_program", "--ignored", "--nocapture"])
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let lines = BufReader::new(referee.stdout.take().unwrap()).lines();
    let folder = lines
        .map_while(Result::ok)
        .find_map(|line| Some(PathBuf::from(line.split_once("folder=")?.1)));
    let folder = folder.unwrap();
    assert!(!processes_with(&folder).is_empty());
    referee.kill().unwrap();
    referee.wait().unwrap();
    let until = Instant::now() + Duration::from_secs(20);
    while folder.exists() && Instant::now() < until {
        std::thread::sleep(Duration::from_millis(10));
    }
    assert_eq!(processes_with(&folder), Vec::<String>::new());
    assert!(!folder.exists());
}

#[test]
fn a_fork_bomb_is_ended() {
    for script in [
        // Each process starts two; up to 500 of them.
        "import os, time
for _ in range(9): os.fork()
time.sleep(100)",
        // One process after another, each in a session of its own.
        "import os
while True:
    if os.fork(): os._exit(0)
    os.setsid()",
    ] {
        let mut session = start(python(script));
        let found = session.channel.receive(after(700)).unwrap_err();
        assert!(matches!(found, ChannelFault::Crash(_) | ChannelFault::TimeOver), "{found:?}");
        session.ends();
    }
}

#[test]
fn a_program_with_too_many_processes_or_too_much_memory_is_ended() {
    let many = "for i in 1 2 3 4 5 6 7 8; do sleep 100 & done; wait";
    let mut order = shell(many);
    order.limits.processes = 4;
    let mut session = start(order);
    let ChannelFault::Crash(why) = fault(&mut session) else { panic!("no crash") };
    assert_eq!(why, "the program ended because it had more than 4 processes");
    session.ends();
    let mut order = python("import time\nmuch = b'x' * (200 << 20)\ntime.sleep(100)");
    order.limits.memory = 100 << 20;
    let mut session = start(order);
    let ChannelFault::Crash(why) = fault(&mut session) else { panic!("no crash") };
    assert_eq!(why, "the program ended because it used more than 100 MiB of memory");
    session.ends();
}

#[test]
fn a_program_that_takes_much_memory_at_once_is_ended_with_the_same_reason() {
    // Where control groups work the kernel ends it before the supervisor looks.
    let mut order = python("import time\nmuch = b'x' * (1 << 30)\ntime.sleep(100)");
    order.limits.memory = 100 << 20;
    let mut session = start(order);
    let ChannelFault::Crash(why) = fault(&mut session) else { panic!("no crash") };
    assert_eq!(why, "the program ended because it used more than 100 MiB of memory");
    session.ends();
}

#[test]
fn a_program_that_answers_at_once_cannot_evade_the_limits() {
    // It is stopped long before the next look at a program that runs.
    let mut order = python(
        "much = []
while True:
    input()
    much.append(b'x' * (20 << 20))
    print(len(much), flush=True)",
    );
    order.limits.memory = 100 << 20;
    let mut session = start(order);
    let mut answers = 0;
    let fault = loop {
        match session.channel.send("", soon()).and_then(|()| session.channel.receive(soon())) {
            Ok(_) => answers += 1,
            Err(fault) => break fault,
        }
        assert!(answers < 20, "it has {answers} times 20 MiB");
        // The referee plays the shot.
        std::thread::sleep(Duration::from_millis(100));
    };
    let ChannelFault::Crash(why) = fault else { panic!("{fault:?}") };
    assert_eq!(why, "the program ended because it used more than 100 MiB of memory");
    session.ends();
}

#[test]
fn the_limits_of_the_kernel_are_in_force() {
    let mut order = python(
        "import resource as r
print([r.getrlimit(x) for x in (r.RLIMIT_CPU, r.RLIMIT_NOFILE, r.RLIMIT_FSIZE, r.RLIMIT_CORE)])
try:
    with open('huge', 'wb') as f:
        for _ in range(100): f.write(b'x' * 1000)
except OSError as error: print(error.errno)",
    );
    order.limits.cpu_seconds = 77;
    order.limits.open_files = 33;
    order.limits.file_bytes = 50_000;
    let mut session = start(order);
    let expected = "[(77, 77), (33, 33), (50000, 50000), (0, 0)]";
    assert_eq!(session.channel.receive(soon()).unwrap(), expected);
    assert_eq!(session.channel.receive(soon()).unwrap(), "27", "EFBIG");
    session.ends();
}

#[test]
fn the_environment_is_small_and_the_folder_is_its_own() {
    let order = ProgramOrder::new(vec!["env".into()], Confinement::Plain);
    let mut channel = ProgramChannel::start(&order, &supervisor(), Arc::new(|| false)).unwrap();
    let mut keys: Vec<String> = (0..4).map(|_| channel.receive(soon()).unwrap()).collect();
    keys.iter_mut().for_each(|line| line.truncate(line.find('=').unwrap()));
    keys.sort();
    assert_eq!(keys, ["HOME", "LANG", "PATH", "TMPDIR"]);
    assert!(matches!(channel.receive(soon()), Err(ChannelFault::Crash(_))));
    let mut session = start(shell("pwd; ls -A; echo end"));
    assert_eq!(session.channel.receive(soon()).unwrap(), session.folder.display().to_string());
    assert_eq!(session.channel.receive(soon()).unwrap(), "end");
    session.ends();
}

#[test]
fn a_stopped_match_does_not_wait_for_a_program() {
    let mut order = shell("sleep 100");
    order.grace = Duration::from_millis(20);
    let begin = Instant::now();
    let stop = move || begin.elapsed() > Duration::from_millis(300);
    let mut channel = ProgramChannel::start(&order, &supervisor(), Arc::new(stop)).unwrap();
    channel.receive(soon()).unwrap();
    assert_eq!(channel.receive(None), Err(ChannelFault::Stopped));
    drop(channel);
    assert!(begin.elapsed() < Duration::from_secs(20));
}

#[test]
fn a_confined_program_has_no_network_and_writes_only_in_its_folder() {
    let confinement = Confinement::strongest();
    let mut order = python(
        "import os, socket
try: socket.create_connection(('127.0.0.1', int(os.sys.argv[1])), 1); print('connected')
except OSError: print('no network')
try: open(os.sys.argv[2], 'w'); print('written')
except OSError: print('no file')
try: print(open(os.sys.argv[3]).read())
except OSError: print('hidden')
open('own', 'w').write('x'); print(os.listdir('.'))",
    );
    let server = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (other, secret) = (folder.path().join("other"), folder.path().join("secret"));
    std::fs::write(&secret, "secret").unwrap();
    order.words.push(server.local_addr().unwrap().port().to_string());
    order.words.extend([&other, &secret].map(|path| path.display().to_string()));
    order.confinement = confinement;
    order.hidden = vec![secret];
    let mut session = start(order);
    let mut line = || session.channel.receive(soon()).unwrap();
    let has = |what: &str| confinement.enforced().contains(&what);
    assert_eq!(line(), if has("network") { "no network" } else { "connected" });
    assert_eq!(line(), if has("files") { "no file" } else { "written" });
    assert_eq!(line(), if has("files") { "hidden" } else { "secret" });
    assert_eq!(line(), "['own']");
    session.ends();
}
