//! The descendants of a process: found, stopped, continued and killed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use rustix::process::{Pid, Signal, kill_process, kill_process_group};

/// Rounds of looking for processes that were started while others were being stopped. Each round
/// stops all that are there, so a tree that still grows is made of processes that the round before
/// had not seen; the number only bounds the loop.
const ROUNDS: u32 = 64;

/// Longest `/proc/PID/stat`, bytes: a name of at most 64 bytes and 51 numbers of at most 20 digits.
const LONGEST_STAT: usize = 2048;

/// A running process, as `/proc/PID/stat` describes it (proc(5)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TreeProcess {
    pid: Pid,
    parent: i32,
    /// Its process group.
    group: i32,
    state: u8,
    threads: u32,
    /// Resident memory, pages.
    pages: u64,
}

impl TreeProcess {
    /// The process with this number, if there is one.
    fn of(pid: i32) -> Option<Self> {
        let found = Self::read_file(&Path::new("/proc").join(pid.to_string()))?;
        if found.state == b'Z' && found.threads > 1 {
            // Its first thread, which has ended, has given up its memory.
            let threads = found.threads().filter_map(|thread| Self::read_file(&thread));
            let pages = threads.map(|thread| thread.pages).max().unwrap_or(found.pages);
            return Some(Self { pages, ..found });
        }
        Some(found)
    }

    /// What `stat` in the folder of a process or a thread describes.
    fn read_file(folder: &Path) -> Option<Self> {
        let mut stat = [0; LONGEST_STAT];
        // A single read gets the whole line.
        let length = File::open(folder.join("stat")).ok()?.read(&mut stat).ok()?;
        Self::read(&String::from_utf8_lossy(&stat[..length]))
    }

    /// The folders of its threads.
    fn threads(&self) -> impl Iterator<Item = PathBuf> {
        let tasks = fs::read_dir(format!("/proc/{}/task", self.number()));
        tasks.into_iter().flatten().flatten().map(|task| task.path())
    }

    /// Reads a line `PID (NAME) STATE PARENT …`. The name may contain anything, so the last bracket
    /// counts.
    fn read(stat: &str) -> Option<Self> {
        let (head, rest) = stat.rsplit_once(')')?;
        let pid = Pid::from_raw(head.split_once(' ')?.0.parse().ok()?)?;
        // Field 3 of the line is the first one here.
        let mut fields = rest.split_ascii_whitespace();
        let state = *fields.next()?.as_bytes().first()?;
        let parent = fields.next()?.parse().ok()?;
        let group = fields.next()?.parse().ok()?;
        let threads = fields.nth(20 - 6)?.parse().ok()?;
        let pages = fields.nth(24 - 21)?.parse().ok()?;
        Some(Self { pid, parent, group, state, threads, pages })
    }

    const fn number(&self) -> i32 {
        self.pid.as_raw_pid()
    }

    /// Whether it has ended and only waits for its parent. A process whose first thread has ended looks
    /// the same, but has other threads.
    const fn has_ended(&self) -> bool {
        matches!(self.state, b'Z' | b'X') && self.threads <= 1
    }

    /// Its children in the lists of the kernel: each thread has a list of its own.
    fn listed_children(&self) -> Vec<Self> {
        let number = self.number();
        let numbers = if self.threads <= 1 {
            let only = format!("/proc/{number}/task/{number}");
            children_of_thread(Path::new(&only)).unwrap_or_default()
        } else {
            self.threads().filter_map(|thread| children_of_thread(&thread)).flatten().collect()
        };
        // A number may by now belong to another process.
        numbers.into_iter().filter_map(Self::of).filter(|child| child.parent == number).collect()
    }
}

/// The children that a thread has started or adopted; none if it has ended, or the kernel does not list
/// them (before Linux 4.2, or without `CONFIG_PROC_CHILDREN`).
fn children_of_thread(task: &Path) -> Option<Vec<i32>> {
    let mut file = File::open(task.join("children")).ok()?;
    let (mut list, mut block) = (Vec::new(), [0; 512]);
    // Unlike `read_to_end` this does not ask for the size first, which is unknown.
    loop {
        match file.read(&mut block).ok()? {
            0 => break,
            length => list.extend_from_slice(&block[..length]),
        }
    }
    let list = String::from_utf8_lossy(&list);
    Some(list.split_ascii_whitespace().filter_map(|number| number.parse().ok()).collect())
}

/// The number of processes, and their resident memory, bytes.
pub(super) fn usage(processes: &[TreeProcess]) -> (usize, u64) {
    let pages: u64 = processes.iter().map(|process| process.pages).sum();
    (processes.len(), pages * rustix::param::page_size() as u64)
}

/// The processes of a program: all descendants of its supervisor.
#[derive(Debug)]
pub(super) struct ProcessTree {
    root: Pid,
    /// Whether the kernel lists the children of a process. Without these lists all processes of the
    /// machine are looked at, which takes about a millisecond for each hundred.
    has_lists: bool,
    /// Whether one that was stopped is outside of the program's process group.
    has_stopped_others: bool,
}

impl ProcessTree {
    /// The descendants of `root`.
    pub(super) fn of(root: Pid) -> Self {
        let number = root.as_raw_pid();
        let own = format!("/proc/{number}/task/{number}");
        let has_lists = children_of_thread(Path::new(&own)).is_some();
        Self { root, has_lists, has_stopped_others: false }
    }

    /// The descendants that run or are stopped. One is missing if another process starts or ends it, or
    /// its parent, meanwhile.
    pub(super) fn processes(&self) -> Vec<TreeProcess> {
        let by_parent = if self.has_lists { BTreeMap::new() } else { all_processes() };
        let children = |parent: &TreeProcess| match self.has_lists {
            true => parent.listed_children(),
            false => by_parent.get(&parent.number()).cloned().unwrap_or_default(),
        };
        let Some(root) = TreeProcess::of(self.root.as_raw_pid()) else { return Vec::new() };
        let mut found = children(&root);
        let mut next = 0;
        while let Some(process) = found.get(next) {
            let of_it = children(process);
            found.extend(of_it);
            next += 1;
        }
        found.retain(|process| !process.has_ended());
        found
    }

    /// Stops all processes, and returns them. The group of the program comes first: most programs are
    /// nothing else.
    pub(super) fn stop(&mut self, group: Option<Pid>) -> Vec<TreeProcess> {
        if let Some(group) = group {
            let _ = kill_process_group(group, Signal::STOP);
        }
        let mut before = BTreeSet::new();
        let mut processes = Vec::new();
        // A list of children can lack one if another one ends while it is read. That one is missing in
        // the next round, so two rounds that find the same processes have missed none.
        for _ in 0..ROUNDS {
            processes = self.processes();
            for process in &processes {
                // Again, if it was stopped: one that was found later may have continued it.
                let _ = kill_process(process.pid, Signal::STOP);
            }
            let now = processes.iter().map(TreeProcess::number).collect();
            if now == before {
                break;
            }
            before = now;
        }
        let group = group.map(Pid::as_raw_pid);
        self.has_stopped_others = processes.iter().any(|process| Some(process.group) != group);
        processes
    }

    /// Continues all that were stopped.
    pub(super) fn proceed(&mut self, group: Option<Pid>) {
        if let Some(group) = group {
            let _ = kill_process_group(group, Signal::CONT);
        }
        if self.has_stopped_others || group.is_none() {
            self.signal(Signal::CONT);
        }
        self.has_stopped_others = false;
    }

    /// Asks all processes to end.
    pub(super) fn terminate(&self) {
        self.signal(Signal::TERM);
    }

    /// Kills all processes. They are stopped first, so that none can start another one meanwhile.
    pub(super) fn kill(&mut self) {
        self.stop(None);
        self.signal(Signal::KILL);
    }

    /// Sends a signal to all processes. They are looked up for it: an earlier number may by now belong
    /// to a process that is none of these.
    fn signal(&self, signal: Signal) {
        for process in self.processes() {
            let _ = kill_process(process.pid, signal);
        }
    }
}

/// All processes of the machine, by the number of their parent.
fn all_processes() -> BTreeMap<i32, Vec<TreeProcess>> {
    let mut children: BTreeMap<i32, Vec<TreeProcess>> = BTreeMap::new();
    for entry in fs::read_dir("/proc").into_iter().flatten().flatten() {
        let number = entry.file_name().to_str().and_then(|name| name.parse().ok());
        if let Some(found) = number.and_then(TreeProcess::of) {
            children.entry(found.parent).or_default().push(found);
        }
    }
    children
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::io::{BufRead, BufReader};
    use std::process::{Command, Stdio};

    use rustix::process::{Pid, Signal};

    use super::{ProcessTree, TreeProcess};

    #[test]
    fn a_name_with_brackets_and_blanks_does_not_shift_the_fields() {
        let line = "17 (a ) R 1 (b) S 5 16 17 0 -1 4194560 100 0 0 0 1 2 0 0 20 0 3 0 99 8192 333 \
                    18446744073709551615 0";
        let found = TreeProcess::read(line).unwrap();
        let pid = Pid::from_raw(17).unwrap();
        let expected =
            TreeProcess { pid, parent: 5, group: 16, state: b'S', threads: 3, pages: 333 };
        assert_eq!(found, expected);
        for wrong in ["", "17", "17 (a)", "17 (a) S", "x (a) S 1"] {
            assert_eq!(TreeProcess::read(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn the_lists_of_children_and_a_look_at_all_processes_find_the_same_tree() {
        // The third child has a thread that starts the fourth one.
        let script = "import os, threading, time
def start():
    if not os.fork():
        print('ready', flush=True)
        time.sleep(100)
    time.sleep(100)
for _ in range(2):
    if not os.fork(): time.sleep(100)
if not os.fork():
    threading.Thread(target=start).start()
time.sleep(100)";
        let mut command = Command::new("python3");
        let mut child = command.args(["-c", script]).stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let lists = ProcessTree::of(Pid::from_child(&child));
        let no_lists = ProcessTree { has_lists: false, ..ProcessTree::of(lists.root) };
        let found = [&lists, &no_lists].map(|tree| {
            let processes = tree.processes();
            processes.iter().map(TreeProcess::number).collect::<BTreeSet<i32>>()
        });
        lists.signal(Signal::KILL);
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(lists.has_lists, "this kernel has no lists of children");
        assert_eq!(found[0], found[1]);
        assert!(found[0].len() >= 4, "{line}: {found:?}");
    }
}
