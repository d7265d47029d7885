//! The descendants of a process: found, stopped, continued and killed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use rustix::process::{Pid, Signal, kill_process, kill_process_group};

/// Rounds of looking for processes that were started while others were being stopped. Each round
/// stops all that are there, so a tree that still grows is made of processes that the round before
/// had not seen; the number only bounds the loop.
const ROUNDS: u32 = 64;

/// A running process, as `/proc/PID/stat` describes it (proc(5)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TreeProcess {
    pub(super) pid: Pid,
    parent: i32,
    state: u8,
    /// Resident memory, pages.
    pages: u64,
}

impl TreeProcess {
    /// Reads a line `PID (NAME) STATE PARENT …`. The name may contain anything, so the last bracket
    /// counts.
    fn read(stat: &str) -> Option<Self> {
        let (head, rest) = stat.rsplit_once(')')?;
        let pid = Pid::from_raw(head.split_once(' ')?.0.parse().ok()?)?;
        // Field 3 of the line is the first one here.
        let mut fields = rest.split_ascii_whitespace();
        let state = *fields.next()?.as_bytes().first()?;
        let parent = fields.next()?.parse().ok()?;
        let pages = fields.nth(24 - 5)?.parse().ok()?;
        Some(Self { pid, parent, state, pages })
    }

    /// Whether it has ended and only waits for its parent.
    const fn has_ended(&self) -> bool {
        matches!(self.state, b'Z' | b'X')
    }
}

/// The processes of a program: all descendants of its supervisor.
#[derive(Debug)]
pub(super) struct ProcessTree {
    root: Pid,
    /// The processes that were stopped.
    stopped: BTreeSet<i32>,
}

impl ProcessTree {
    /// The descendants of `root`.
    pub(super) const fn of(root: Pid) -> Self {
        Self { root, stopped: BTreeSet::new() }
    }

    /// The descendants that run or are stopped.
    pub(super) fn processes(&self) -> Vec<TreeProcess> {
        let mut children: BTreeMap<i32, Vec<TreeProcess>> = BTreeMap::new();
        for entry in fs::read_dir("/proc").into_iter().flatten().flatten() {
            let name = entry.file_name();
            if !name.as_encoded_bytes().first().is_some_and(u8::is_ascii_digit) {
                continue;
            }
            let Ok(stat) = fs::read(entry.path().join("stat")) else { continue };
            if let Some(found) = TreeProcess::read(&String::from_utf8_lossy(&stat)) {
                children.entry(found.parent).or_default().push(found);
            }
        }
        let mut found = children.remove(&self.root.as_raw_pid()).unwrap_or_default();
        let mut next = 0;
        while let Some(process) = found.get(next) {
            let of_it = children.remove(&process.pid.as_raw_pid()).unwrap_or_default();
            found.extend(of_it);
            next += 1;
        }
        found.retain(|process| !process.has_ended());
        found
    }

    /// The number of processes, and their resident memory, bytes.
    pub(super) fn usage(&self) -> (usize, u64) {
        let processes = self.processes();
        let pages: u64 = processes.iter().map(|process| process.pages).sum();
        (processes.len(), pages * rustix::param::page_size() as u64)
    }

    /// Stops all processes. The group of the program comes first: most programs are nothing else.
    pub(super) fn stop(&mut self, group: Option<Pid>) {
        if let Some(group) = group {
            let _ = kill_process_group(group, Signal::STOP);
            self.stopped.insert(group.as_raw_pid());
        }
        for _ in 0..ROUNDS {
            let mut is_new = false;
            for process in self.processes() {
                let _ = kill_process(process.pid, Signal::STOP);
                is_new |= self.stopped.insert(process.pid.as_raw_pid());
            }
            if !is_new {
                break;
            }
        }
    }

    /// Continues all that were stopped.
    pub(super) fn proceed(&mut self, group: Option<Pid>) {
        if let Some(group) = group {
            let _ = kill_process_group(group, Signal::CONT);
            self.stopped.remove(&group.as_raw_pid());
        }
        let stopped = core::mem::take(&mut self.stopped);
        if stopped.is_empty() {
            return;
        }
        // A number may by now belong to a process that is none of these.
        for process in self.processes() {
            if stopped.contains(&process.pid.as_raw_pid()) {
                let _ = kill_process(process.pid, Signal::CONT);
            }
        }
    }

    /// Asks all processes to end.
    pub(super) fn terminate(&self) {
        for process in self.processes() {
            let _ = kill_process(process.pid, Signal::TERM);
        }
    }

    /// Kills all processes. They are stopped first, so that none can start another one meanwhile.
    pub(super) fn kill(&mut self) {
        self.stop(None);
        for process in self.processes() {
            let _ = kill_process(process.pid, Signal::KILL);
        }
        self.stopped.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::TreeProcess;
    use rustix::process::Pid;

    #[test]
    fn a_name_with_brackets_and_blanks_does_not_shift_the_fields() {
        let line = "17 (a ) R 1 (b) S 5 17 17 0 -1 4194560 100 0 0 0 1 2 0 0 20 0 1 0 99 8192 333 \
                    18446744073709551615 0";
        let found = TreeProcess::read(line).unwrap();
        let expected =
            TreeProcess { pid: Pid::from_raw(17).unwrap(), parent: 5, state: b'S', pages: 333 };
        assert_eq!(found, expected);
        for wrong in ["", "17", "17 (a)", "17 (a) S", "x (a) S 1"] {
            assert_eq!(TreeProcess::read(wrong), None, "{wrong}");
        }
    }
}
