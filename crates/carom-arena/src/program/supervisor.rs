//! The supervisor: a small process between the referee and a program.
//!
//! Its standard input is a socket to the referee. The first line on it is a [`ProgramOrder`], with the
//! three pipes of the program as file descriptors (unix(7), SCM_RIGHTS). Then each byte is a command:
//! [`STOP`], [`PROCEED`] or [`END`]; a closed socket is `END` too, so that nothing is left if the
//! referee is killed. The supervisor answers with lines: [`STARTED`], [`PROCEEDING`], and what
//! happened to the program in words, after [`FAILED`] or [`ENDED`].

use std::env;
use std::io::{self, IoSliceMut, Write};
use std::mem::MaybeUninit;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::net::UnixStream;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use carom::format::Node;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;
use rustix::net::{RecvAncillaryBuffer, RecvAncillaryMessage, RecvFlags, recvmsg};
use rustix::process::{Pid, WaitOptions, WaitStatus, getpid, set_child_subreaper, setsid, wait};
use tempfile::TempDir;

use super::control_group::ControlGroup;
use super::limits::ProgramLimits;
use super::order::ProgramOrder;
use super::process_tree::{ProcessTree, TreeProcess, usage};

/// Stop the program.
pub(super) const STOP: u8 = b'S';
/// Let it proceed. The answer is [`PROCEEDING`].
pub(super) const PROCEED: u8 = b'C';
/// End it.
pub(super) const END: u8 = b'E';

/// The program was started.
pub(super) const STARTED: &str = "started";
/// The program runs again.
pub(super) const PROCEEDING: &str = "proceeding";
/// The program could not be started: why.
pub(super) const FAILED: &str = "failed ";
/// The program has ended, or the supervisor ends it: why.
pub(super) const ENDED: &str = "ended ";

/// Time between two looks at what a running program uses. One takes less than a tenth of a millisecond.
const LOOK: Duration = Duration::from_millis(200);
/// Time between two attempts to kill what is left.
const AGAIN: Duration = Duration::from_millis(5);
/// How long the supervisor tries to kill a program. Only a process that the kernel cannot end resists.
const PATIENCE: Duration = Duration::from_secs(10);

/// What the thread that waits for ended processes reports to the other one.
#[derive(Default)]
struct Reaped {
    state: Mutex<ReapedState>,
    changed: Condvar,
}

#[derive(Clone, Copy, Default)]
struct ReapedState {
    leader_ended: bool,
    all_ended: bool,
}

impl Reaped {
    fn state(&self) -> MutexGuard<'_, ReapedState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut ReapedState)) {
        change(&mut self.state());
        self.changed.notify_all();
    }

    /// Waits until all processes have ended, at most this long. Whether they have.
    fn wait(&self, patience: Duration) -> bool {
        let unfinished = |state: &mut ReapedState| !state.all_ended;
        let waited = self.changed.wait_timeout_while(self.state(), patience, unfinished);
        waited.unwrap_or_else(PoisonError::into_inner).0.all_ended
    }
}

/// The main function of a supervisor: starts the program that is ordered on standard input, obeys the
/// referee, and returns when no process of the program is left.
///
/// # Errors
/// Those of the operating system, before the program was started.
pub fn supervise() -> io::Result<()> {
    let socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    // Ctrl-C in a terminal is for the referee alone.
    setsid()?;
    set_child_subreaper(Some(getpid()))?;
    let (order, pipes) = receive_order(&socket)?;
    let scratch = tempfile::Builder::new().prefix("carom-").tempdir()?;
    let reaped = Arc::new(Reaped::default());
    let group = match order.grouped.then(|| ControlGroup::new(&order.limits)).transpose() {
        Ok(group) => group.map(Arc::new),
        Err(error) => {
            say(&socket, &format!("{FAILED}{error}, for its control group"));
            return Ok(());
        }
    };
    let reaper = begin_reaper(&socket, &reaped, group.clone(), order.limits)?;
    match start(&order, group.as_deref(), pipes, &scratch) {
        Err(error) => say(&socket, &format!("{FAILED}{error}")),
        Ok(leader) => {
            // Before the notice of the end, which the thread may send at once.
            say(&socket, STARTED);
            // The thread waits for this, so it is there.
            let _ = reaper.send(leader);
            let tree = ProcessTree::of(getpid());
            Supervised { socket, order, leader, reaped, tree, group: group.clone() }.obey();
        }
    }
    if let Some(group) = group {
        group.leave();
    }
    // A folder without rights, or one that grows, is left to the system.
    let _ = scratch.close();
    Ok(())
}

/// Writes a line to the referee. One that has gone needs none.
fn say(mut socket: &UnixStream, line: &str) {
    let line = line.replace(['\n', '\r'], " ");
    let _ = socket.write_all(format!("{line}\n").as_bytes());
}

/// Reads the order and the program's stdin, stdout and stderr.
fn receive_order(socket: &UnixStream) -> io::Result<(ProgramOrder, [OwnedFd; 3])> {
    let (mut text, mut pipes) = (Vec::new(), Vec::new());
    while text.last() != Some(&b'\n') {
        let mut block = [0; 4096];
        let mut space = [MaybeUninit::uninit(); rustix::cmsg_space!(ScmRights(3))];
        let mut rights = RecvAncillaryBuffer::new(&mut space);
        let mut blocks = [IoSliceMut::new(&mut block)];
        let got = recvmsg(socket, &mut blocks, &mut rights, RecvFlags::CMSG_CLOEXEC)?.bytes;
        for message in rights.drain() {
            if let RecvAncillaryMessage::ScmRights(sent) = message {
                pipes.extend(sent);
            }
        }
        if got == 0 {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        text.extend_from_slice(&block[..got]);
    }
    let text = String::from_utf8_lossy(&text);
    let order = Node::from_json(text.trim_end()).and_then(|node| ProgramOrder::read(&node));
    let pipes = pipes.try_into().map_err(|_| io::Error::from(io::ErrorKind::InvalidInput))?;
    Ok((order.map_err(io::Error::other)?, pipes))
}

/// Starts the program: a process group in the session of the supervisor, the folder `scratch`, a
/// small environment, the limits. It can gain no rights by programs that have them (setuid).
fn start(
    order: &ProgramOrder,
    group: Option<&ControlGroup>,
    pipes: [OwnedFd; 3],
    scratch: &TempDir,
) -> io::Result<Pid> {
    let folder = scratch.path();
    let words = order.confinement.wrap(order.words.clone(), folder, &order.hidden);
    let Some((program, arguments)) = words.split_first() else {
        return Err(io::Error::from(io::ErrorKind::InvalidInput));
    };
    rustix::thread::set_no_new_privs(true)?;
    group.map_or(Ok(()), ControlGroup::enter)?;
    order.limits.apply()?;
    let [stdin, stdout, stderr] = pipes;
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).process_group(0).env_clear();
    command.envs(environment(folder));
    command.stdin(Stdio::from(stdin)).stdout(Stdio::from(stdout)).stderr(Stdio::from(stderr));
    let started = command.spawn()?;
    let pid = i32::try_from(started.id()).ok().and_then(Pid::from_raw);
    pid.ok_or_else(|| io::Error::from(io::ErrorKind::InvalidData))
}

/// The environment of a program: where programs and its own folder are, and UTF-8.
fn environment(folder: &Path) -> impl Iterator<Item = (&'static str, std::ffi::OsString)> {
    let path = env::var_os("PATH").map(|path| ("PATH", path));
    let folders = ["HOME", "TMPDIR"].map(|key| (key, folder.as_os_str().to_owned()));
    path.into_iter().chain(folders).chain([("LANG", "C.UTF-8".into())])
}

/// Begins the thread that waits for the ended processes of the program, after it gets the process ID
/// of the program.
fn begin_reaper(
    socket: &UnixStream,
    reaped: &Arc<Reaped>,
    group: Option<Arc<ControlGroup>>,
    limits: ProgramLimits,
) -> io::Result<mpsc::Sender<Pid>> {
    let (sender, receiver) = mpsc::channel::<Pid>();
    let (socket, reaped) = (socket.try_clone()?, Arc::clone(reaped));
    thread::Builder::new().spawn(move || {
        let Ok(leader) = receiver.recv() else { return };
        loop {
            match wait(WaitOptions::empty()) {
                Ok(Some((pid, status))) if pid == leader => {
                    reaped.change(|state| state.leader_ended = true);
                    let why = out_of_memory(group.as_deref(), &limits);
                    say(&socket, &format!("{ENDED}{}", why.unwrap_or_else(|| describe(status))));
                }
                Ok(_) | Err(Errno::INTR) => {}
                // No child is left, so no descendant.
                Err(_) => break,
            }
        }
        reaped.change(|state| state.all_ended = true);
    })?;
    Ok(sender)
}

fn describe(status: WaitStatus) -> String {
    match (status.exit_status(), status.terminating_signal()) {
        (Some(status), _) => format!("with exit status {status}"),
        (None, Some(signal)) => format!("by signal {signal}"),
        (None, None) => String::from("for an unknown reason"),
    }
}

/// The limit of memory in words, if the kernel has killed a process of the group for it.
fn out_of_memory(group: Option<&ControlGroup>, limits: &ProgramLimits) -> Option<String> {
    group.filter(|group| group.has_run_out_of_memory()).map(|_| too_much_memory(limits))
}

fn too_much_memory(limits: &ProgramLimits) -> String {
    format!("because it used more than {} MiB of memory", limits.memory >> 20)
}

/// A program that was started.
struct Supervised {
    socket: UnixStream,
    order: ProgramOrder,
    leader: Pid,
    reaped: Arc<Reaped>,
    tree: ProcessTree,
    group: Option<Arc<ControlGroup>>,
}

impl Supervised {
    /// Obeys the referee until the end.
    fn obey(&mut self) {
        let mut runs = true;
        loop {
            match self.next_command(runs) {
                Some(STOP) => {
                    let stopped = self.tree.stop(self.group());
                    self.limit(&stopped);
                    runs = false;
                }
                Some(PROCEED) => {
                    self.tree.proceed(self.group());
                    say(&self.socket, PROCEEDING);
                    runs = true;
                }
                Some(_) => break,
                None => {
                    let running = self.tree.processes();
                    self.limit(&running);
                }
            }
        }
        self.end();
    }

    /// The process group of the program, while its number is certain to be its own.
    fn group(&self) -> Option<Pid> {
        (!self.reaped.state().leader_ended).then_some(self.leader)
    }

    /// The next command; `None` if it is time to look at what the program uses.
    fn next_command(&self, runs: bool) -> Option<u8> {
        let look = Timespec::try_from(LOOK).ok().filter(|_| runs);
        let mut ready = [PollFd::new(&self.socket, PollFlags::IN)];
        match poll(&mut ready, look.as_ref()) {
            Ok(0) => return None,
            Ok(_) => {}
            Err(Errno::INTR) => return None,
            Err(_) => return Some(END),
        }
        let mut command = [END];
        // At the end of the stream the command stays what it is.
        match rustix::io::read(&self.socket, &mut command) {
            Err(Errno::INTR) => None,
            _ => Some(command[0]),
        }
    }

    /// Kills the program if its processes exceed a limit.
    fn limit(&mut self, processes: &[TreeProcess]) {
        if let Some(excess) = self.excess(processes) {
            // Before the notice of the end that follows.
            say(&self.socket, &format!("{ENDED}{excess}"));
            self.tree.kill();
        }
    }

    /// The limit that the processes of the program exceed, in words.
    fn excess(&self, processes: &[TreeProcess]) -> Option<String> {
        let limits = &self.order.limits;
        let (processes, memory) = usage(processes);
        if processes > limits.processes as usize {
            return Some(format!("because it had more than {} processes", limits.processes));
        }
        if memory > limits.memory {
            return Some(too_much_memory(limits));
        }
        out_of_memory(self.group.as_deref(), limits)
    }

    /// Ends the program: its input is closed, so it may end by itself; then SIGTERM, then SIGKILL.
    fn end(&mut self) {
        self.tree.proceed(self.group());
        if self.reaped.wait(self.order.grace) {
            return;
        }
        self.tree.terminate();
        if self.reaped.wait(self.order.grace) {
            return;
        }
        let until = Instant::now() + PATIENCE;
        while Instant::now() < until {
            self.tree.kill();
            if self.reaped.wait(AGAIN) {
                return;
            }
        }
    }
}
