//! Limits of a whole program by the kernel: control groups (cgroups(7)) of version 2, or of version 1.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

use super::confinement::SCRATCH_BYTES;
use super::limits::ProgramLimits;

/// Where the system has its control groups.
const MOUNT: &str = "/sys/fs/cgroup";

/// Tasks for each process that a program may have: the kernel counts threads, and the supervisor processes.
const TASKS_PER_PROCESS: u64 = 64;

/// Attempts to remove a group, 10 ms apart. The kernel needs a moment after its last process.
const ATTEMPTS: u32 = 50;

/// The number of the next group of this process.
static NUMBER: AtomicU32 = AtomicU32::new(0);

/// Whether groups can be made and entered here.
static WORKS: LazyLock<bool> = LazyLock::new(|| try_out().unwrap_or(false));

/// A control group of the kernel: one folder in version 2, one for each controller in version 1.
#[derive(Debug)]
pub(super) struct ControlGroup {
    parts: Vec<Part>,
}

/// A folder of a group.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Part {
    /// The group's own folder.
    folder: PathBuf,
    /// The folder of the group that this process comes from.
    home: PathBuf,
    /// Its limits.
    limits: &'static [Limit],
    /// The file that counts the processes that the kernel killed because it had no memory for them.
    kills: Option<&'static str>,
}

/// A file with a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Limit {
    file: &'static str,
    amount: Amount,
    /// A system without swap lacks the file.
    is_optional: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Amount {
    Memory,
    Tasks,
    Nothing,
}

const fn limit(file: &'static str, amount: Amount) -> Limit {
    Limit { file, amount, is_optional: false }
}

const fn optional(file: &'static str, amount: Amount) -> Limit {
    Limit { file, amount, is_optional: true }
}

/// Both controllers of version 2.
const VERSION_2: &[Limit] = &[
    limit("memory.max", Amount::Memory),
    optional("memory.swap.max", Amount::Nothing),
    limit("pids.max", Amount::Tasks),
];
/// The controllers of version 1. The limit with swap must not be below that without it.
const VERSION_1_MEMORY: &[Limit] = &[
    limit("memory.limit_in_bytes", Amount::Memory),
    optional("memory.memsw.limit_in_bytes", Amount::Memory),
];
const VERSION_1_TASKS: &[Limit] = &[limit("pids.max", Amount::Tasks)];

impl ControlGroup {
    /// Whether groups can be made and entered here.
    pub(super) fn works() -> bool {
        *WORKS
    }

    /// Makes a group with these limits. It has no process yet.
    ///
    /// # Errors
    /// Those of the operating system. Nothing is left then.
    pub(super) fn new(limits: &ProgramLimits) -> io::Result<Self> {
        let own = fs::read_to_string("/proc/self/cgroup")?;
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("carom-{}-{number}", std::process::id());
        let group = Self { parts: parts(Path::new(MOUNT), &own, &name) };
        if group.parts.is_empty() {
            return Err(io::ErrorKind::Unsupported.into());
        }
        let made = group.parts.iter().try_for_each(|part| part.make(limits));
        if made.is_err() {
            group.remove();
        }
        made.map(|()| group)
    }

    /// Moves this process into the group; what it starts is in the group, too.
    pub(super) fn enter(&self) -> io::Result<()> {
        self.parts.iter().try_for_each(|part| move_here(&part.folder))
    }

    /// Moves this process back, and removes the group. One with a process that cannot be ended stays.
    pub(super) fn leave(&self) {
        for part in &self.parts {
            let _ = move_here(&part.home);
        }
        self.remove();
    }

    /// Whether the kernel has killed a process of the group because there was no more memory for it.
    pub(super) fn has_run_out_of_memory(&self) -> bool {
        let counts = self.parts.iter().filter_map(|part| Some(part.folder.join(part.kills?)));
        let texts = counts.filter_map(|file| fs::read_to_string(file).ok());
        texts.into_iter().any(|text| count(&text, "oom_kill") > 0)
    }

    fn remove(&self) {
        for part in &self.parts {
            for _ in 0..ATTEMPTS {
                match fs::remove_dir(&part.folder) {
                    Err(error) if error.kind() == io::ErrorKind::ResourceBusy => {
                        thread::sleep(Duration::from_millis(10));
                    }
                    _ => break,
                }
            }
        }
    }
}

impl Part {
    fn make(&self, limits: &ProgramLimits) -> io::Result<()> {
        // An empty one is from an earlier process with this number, which was killed.
        let _ = fs::remove_dir(&self.folder);
        fs::create_dir(&self.folder)?;
        for limit in self.limits {
            let amount = match limit.amount {
                // The folder of a confined program is in memory.
                Amount::Memory => limits.memory.saturating_add(SCRATCH_BYTES),
                Amount::Tasks => u64::from(limits.processes) * TASKS_PER_PROCESS,
                Amount::Nothing => 0,
            };
            let file = self.folder.join(limit.file);
            if !limit.is_optional || file.exists() {
                // Without `create`: a file that the kernel does not offer must not be made.
                fs::OpenOptions::new().write(true).open(file).and_then(|mut file| {
                    io::Write::write_all(&mut file, amount.to_string().as_bytes())
                })?;
            }
        }
        Ok(())
    }
}

/// The folders of the group `name`, from the file /proc/self/cgroup of this process; none if the system has
/// no control groups.
fn parts(mount: &Path, own: &str, name: &str) -> Vec<Part> {
    // Each line is NUMBER:CONTROLLERS:PATH.
    let path_of = |controller: &str| {
        own.lines().find_map(|line| {
            let (controllers, path) = line.split_once(':')?.1.split_once(':')?;
            controllers
                .split(',')
                .any(|each| each == controller)
                .then(|| path.trim_start_matches('/'))
        })
    };
    if mount.join("cgroup.controllers").exists() {
        // A group with processes has no limited groups in it, so the new one stands beside that of
        // this process.
        return path_of("")
            .into_iter()
            .map(|path| {
                let home = mount.join(path);
                let parent = if path.is_empty() { mount } else { home.parent().unwrap_or(mount) };
                let folder = parent.join(name);
                Part { folder, home, limits: VERSION_2, kills: Some("memory.events") }
            })
            .collect();
    }
    let version_1 =
        [("memory", VERSION_1_MEMORY, Some("memory.oom_control")), ("pids", VERSION_1_TASKS, None)];
    let found: Option<Vec<Part>> = version_1
        .into_iter()
        .map(|(controller, limits, kills)| {
            let root = mount.join(controller);
            // In a container the path is that of the machine, which the container does not see.
            let home = root.join(path_of(controller)?);
            let home = if home.exists() { home } else { root };
            Some(Part { folder: home.join(name), home, limits, kills })
        })
        .collect();
    found.unwrap_or_default()
}

/// Moves this process into the group in `folder`.
fn move_here(folder: &Path) -> io::Result<()> {
    fs::write(folder.join("cgroup.procs"), std::process::id().to_string())
}

/// The number after `key` in lines KEY NUMBER.
fn count(text: &str, key: &str) -> u64 {
    let lines = text.lines().filter_map(|line| line.split_once(' '));
    lines.filter(|(name, _)| *name == key).filter_map(|(_, n)| n.trim().parse::<u64>().ok()).sum()
}

/// Makes a group and moves a process into it.
fn try_out() -> io::Result<bool> {
    let group = ControlGroup::new(&ProgramLimits::default())?;
    let mut enters = true;
    for part in &group.parts {
        let mut command = Command::new("sh");
        command.args(["-c", "echo $$ > \"$0\""]).arg(part.folder.join("cgroup.procs"));
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        enters &= command.status().is_ok_and(|ended| ended.success());
    }
    group.remove();
    Ok(enters)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_version_2_a_group_stands_beside_that_of_the_process() {
        let mount = tempfile::tempdir().unwrap();
        fs::write(mount.path().join("cgroup.controllers"), "cpu memory pids").unwrap();
        let found = parts(mount.path(), "0::/user.slice/a.scope\n", "carom-1");
        let slice = mount.path().join("user.slice");
        let [part] = &found[..] else { panic!("{found:?}") };
        assert_eq!((&part.folder, &part.home), (&slice.join("carom-1"), &slice.join("a.scope")));
        let root = parts(mount.path(), "0::/\n", "carom-1");
        assert_eq!(root[0].folder, mount.path().join("carom-1"));
    }

    #[test]
    fn in_version_1_each_controller_has_a_folder_within_that_of_the_process() {
        let mount = tempfile::tempdir().unwrap();
        fs::create_dir_all(mount.path().join("memory/jobs/a")).unwrap();
        let own = "8:cpu,pids:/\n4:memory:/jobs/a\n1:name=systemd:/\n0::/\n";
        let found = parts(mount.path(), own, "carom-1");
        let folders: Vec<PathBuf> = found.into_iter().map(|part| part.folder).collect();
        assert_eq!(
            folders,
            ["memory/jobs/a/carom-1", "pids/carom-1"].map(|path| mount.path().join(path))
        );
        // A path of the machine that a container does not see.
        let outside = own.replace("/jobs/a", "/docker/1");
        assert_eq!(parts(mount.path(), &outside, "x")[0].folder, mount.path().join("memory/x"));
        assert_eq!(parts(mount.path(), "1:cpu:/\n", "x"), []);
    }

    #[test]
    fn a_system_that_lacks_a_limit_is_refused() {
        let mount = tempfile::tempdir().unwrap();
        fs::write(mount.path().join("cgroup.controllers"), "").unwrap();
        let [part] = &parts(mount.path(), "0::/\n", "x")[..] else { panic!() };
        assert!(part.make(&ProgramLimits::default()).is_err());
        assert!(!part.folder.join("memory.max").exists());
    }

    #[test]
    fn kills_are_counted_in_both_versions() {
        assert_eq!(count("low 0\noom 3\noom_kill 2\noom_group_kill 1\n", "oom_kill"), 2);
        assert_eq!(count("oom_kill_disable 0\nunder_oom 0\noom_kill 1\n", "oom_kill"), 1);
    }

    /// Runs a script in a group with these limits, if groups work here: how it ended, and whether the kernel
    /// killed it for its memory.
    fn run_in_group(script: &str, limits: &ProgramLimits) -> Option<(std::process::Output, bool)> {
        if !ControlGroup::works() {
            eprintln!("Not run: no control group can be made here");
            return None;
        }
        let group = ControlGroup::new(limits).unwrap();
        let folders = group.parts.iter().map(|part| &part.folder);
        let enter = "for group; do echo $$ > \"$group/cgroup.procs\"; done;";
        let mut command = Command::new("sh");
        command.args(["-c", &format!("{enter} {script}"), "sh"]).args(folders);
        let output = command.output().unwrap();
        let killed = group.has_run_out_of_memory();
        group.remove();
        assert!(group.parts.iter().all(|part| !part.folder.exists()));
        Some((output, killed))
    }

    #[test]
    fn the_kernel_ends_a_process_that_exceeds_the_memory_of_its_group() {
        let limits = ProgramLimits { memory: 64 << 20, ..ProgramLimits::default() };
        for (size, is_killed) in [(32, false), (1024, true)] {
            let script = format!("exec python3 -c 'b\"x\" * ({size} << 20)'");
            let Some((output, killed)) = run_in_group(&script, &limits) else { return };
            assert_eq!((output.status.success(), killed), (!is_killed, is_killed), "{output:?}");
        }
    }

    #[test]
    fn the_kernel_refuses_processes_beyond_those_of_the_group() {
        let limits = ProgramLimits { processes: 1, ..ProgramLimits::default() };
        let script = "for i in $(seq 100); do sleep 1 & done 2>/dev/null; echo started";
        let Some((output, _)) = run_in_group(script, &limits) else { return };
        assert!(!String::from_utf8_lossy(&output.stdout).contains("started"), "{output:?}");
    }
}
