//! Programs for tests, and whether anything is left of them.

#![allow(dead_code, reason = "every test file uses some of them")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use carom_arena::{
    Confinement, ErrorLog, LineChannel, ProgramChannel, ProgramOrder, SupervisorCommand,
};

/// The supervisor of this crate.
pub(crate) fn supervisor() -> SupervisorCommand {
    SupervisorCommand { program: env!("CARGO_BIN_EXE_carom-supervisor").into(), arguments: vec![] }
}

fn order(words: [&str; 3]) -> ProgramOrder {
    let words = words.map(String::from).to_vec();
    let grace = Duration::from_millis(50);
    ProgramOrder { grace, ..ProgramOrder::new(words, Confinement::Plain) }
}

/// A program in the language of the shell. It first prints its folder.
pub(crate) fn shell(script: &str) -> ProgramOrder {
    order(["sh", "-c", &format!("echo $HOME\n{script}")])
}

/// A program in Python. It first prints its folder.
pub(crate) fn python(script: &str) -> ProgramOrder {
    order(["python3", "-c", &format!("import os; print(os.environ['HOME'], flush=True)\n{script}")])
}

/// A running program.
pub(crate) struct Session {
    pub(crate) channel: ProgramChannel<'static>,
    pub(crate) folder: PathBuf,
}

/// Starts a program that first prints its folder.
pub(crate) fn start(order: ProgramOrder) -> Session {
    let mut channel = ProgramChannel::start(&order, &supervisor(), Arc::new(|| false)).unwrap();
    let deadline = Some(Instant::now() + Duration::from_secs(20));
    let folder = PathBuf::from(channel.receive(deadline).unwrap());
    Session { channel, folder }
}

impl Session {
    /// Ends the program, and checks that neither a process nor a file of it is left. Its processes
    /// have the folder in their environment.
    pub(crate) fn ends(self) -> ErrorLog {
        let begin = Instant::now();
        let log = self.channel.end();
        let needed = begin.elapsed();
        assert_eq!(processes_with(&self.folder), Vec::<String>::new());
        assert!(!self.folder.exists(), "{} is left", self.folder.display());
        assert!(needed < Duration::from_secs(15), "the end took {needed:?}");
        log
    }
}

/// The command lines of the processes of the program with this folder.
pub(crate) fn processes_with(folder: &Path) -> Vec<String> {
    let line = |process: PathBuf| fs::read(process.join("cmdline")).unwrap_or_default();
    found(folder).map(|process| String::from_utf8_lossy(&line(process)).into_owned()).collect()
}

/// The states of these processes, a letter each: T for a stopped one (proc(5)).
pub(crate) fn states(folder: &Path) -> String {
    let state = |process: PathBuf| {
        let stat = fs::read_to_string(process.join("stat")).ok()?;
        stat.rsplit_once(") ")?.1.chars().next()
    };
    found(folder).filter_map(state).collect()
}

/// The processes in `/proc` with the folder in their environment.
fn found(folder: &Path) -> impl Iterator<Item = PathBuf> {
    let folder = folder.as_os_str().as_encoded_bytes().to_vec();
    let processes = fs::read_dir("/proc").unwrap().flatten().map(|entry| entry.path());
    processes.filter(move |process| {
        let environment = fs::read(process.join("environ")).unwrap_or_default();
        environment.windows(folder.len()).any(|part| part == folder)
    })
}
