//! Lines to and from a program, with a deadline for every wait.

use std::ffi::OsString;
use std::io::{self, IoSlice, PipeReader, PipeWriter};
use std::mem::MaybeUninit;
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::{Errno, ioctl_fionbio};
use rustix::net::{SendAncillaryBuffer, SendAncillaryMessage, SendFlags, sendmsg};

use super::error_log::ErrorLog;
use super::order::ProgramOrder;
use super::supervisor::{END, ENDED, FAILED, PROCEED, PROCEEDING, STARTED, STOP};
use crate::protocol::{ChannelFault, LONGEST_LINE, LineChannel};

/// Lines that may wait to be read. A request has one answer, so more are a flood.
pub const MOST_PENDING_LINES: usize = 64;
/// What a program may write to stderr in a frame, bytes: 256 MiB. It is read and mostly dropped, which
/// uses time of the machine.
const MOST_ERRORS: u64 = 256 << 20;
/// Bytes that are read at once: the usual size of a pipe.
const BLOCK: usize = 1 << 16;
/// Longest time without a look at whether the match was stopped. A person notices a delay of a second.
const SLICE: Duration = Duration::from_millis(50);
/// How long a program without a clock of seconds may take for an answer: the ten minutes that a whole
/// frame has by default.
const STALL: Duration = Duration::from_secs(600);
/// How long the supervisor may take to start the program, or to let it proceed: far longer than on a
/// busy machine.
const SUPERVISOR_PATIENCE: Duration = Duration::from_secs(30);

/// Whether the match was stopped. It is asked many times a second while a program is waited for.
pub type StopCheck<'s> = Arc<dyn Fn() -> bool + Send + Sync + 's>;

/// What is called with the log of a program at its end.
pub type LogKeeper<'s> = Box<dyn FnOnce(&ErrorLog) + Send + 's>;

/// How to start a supervisor: an executable whose main function is [`crate::supervise`], such as
/// `carom-supervisor` of this crate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SupervisorCommand {
    /// The executable.
    pub program: OsString,
    /// Its arguments.
    pub arguments: Vec<OsString>,
}

/// A running program, and the lines to and from it.
///
/// The program runs from a call of [`LineChannel::send`] until a line of its own was read, and is
/// stopped the rest of the time, with all its processes. Dropping the channel ends them.
pub struct ProgramChannel<'s> {
    supervisor: Child,
    socket: UnixStream,
    /// Unread output of the supervisor.
    unread: Vec<u8>,
    /// `None` once the program has closed it.
    stdin: Option<PipeWriter>,
    stdout: Option<PipeReader>,
    stderr: Option<PipeReader>,
    /// Unread output of the program.
    pending: Vec<u8>,
    log: ErrorLog,
    /// What gets the log at the end.
    log_keeper: Option<LogKeeper<'s>>,
    runs: bool,
    /// How the program has ended.
    ended: Option<String>,
    /// Whether the supervisor has ended.
    is_closed: bool,
    is_stopped: StopCheck<'s>,
    grace: Duration,
}

impl<'s> ProgramChannel<'s> {
    /// Starts a program.
    ///
    /// # Errors
    /// [`ChannelFault::Crash`] if it cannot be started, [`ChannelFault::Stopped`].
    pub fn start(
        order: &ProgramOrder,
        supervisor: &SupervisorCommand,
        is_stopped: StopCheck<'s>,
    ) -> Result<Self, ChannelFault> {
        let failed = |what: &str, error: String| {
            ChannelFault::Crash(format!("{what} could not be started: {error}"))
        };
        let mut begun = Self::begin(order, supervisor, is_stopped)
            .map_err(|error| failed("the supervisor", error.to_string()))?;
        let first = begun.supervisor_line(&Wait::supervisor())?;
        match first.strip_prefix(FAILED) {
            Some(error) => Err(failed("the program", error.into())),
            None if first == STARTED => Ok(begun),
            None => Err(failed("the program", first)),
        }
    }

    fn begin(
        order: &ProgramOrder,
        supervisor: &SupervisorCommand,
        is_stopped: StopCheck<'s>,
    ) -> io::Result<Self> {
        let (socket, of_supervisor) = UnixStream::pair()?;
        let ((stdin_end, stdin), (stdout, stdout_end)) = (io::pipe()?, io::pipe()?);
        let (stderr, stderr_end) = io::pipe()?;
        for ours in [stdin.as_fd(), stdout.as_fd(), stderr.as_fd()] {
            ioctl_fionbio(ours, true)?;
        }
        let child = Command::new(&supervisor.program)
            .args(&supervisor.arguments)
            .stdin(Stdio::from(std::os::fd::OwnedFd::from(of_supervisor)))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()?;
        let begun = Self {
            supervisor: child,
            socket,
            unread: Vec::new(),
            stdin: Some(stdin),
            stdout: Some(stdout),
            stderr: Some(stderr),
            pending: Vec::new(),
            log: ErrorLog::default(),
            log_keeper: None,
            runs: true,
            ended: None,
            is_closed: false,
            is_stopped,
            grace: order.grace,
        };
        let pipes = [stdin_end.as_fd(), stdout_end.as_fd(), stderr_end.as_fd()];
        begun.send_order(order, &pipes)?;
        Ok(begun)
    }

    /// Sends the order with the ends of the pipes that belong to the program.
    fn send_order(&self, order: &ProgramOrder, pipes: &[BorrowedFd<'_>; 3]) -> io::Result<()> {
        let line = format!("{}\n", order.to_node().to_json_line());
        let mut space = [MaybeUninit::uninit(); rustix::cmsg_space!(ScmRights(3))];
        let mut rights = SendAncillaryBuffer::new(&mut space);
        rights.push(SendAncillaryMessage::ScmRights(pipes));
        let blocks = [IoSlice::new(line.as_bytes())];
        let sent = sendmsg(&self.socket, &blocks, &mut rights, SendFlags::NOSIGNAL)?;
        io::Write::write_all(&mut &self.socket, &line.as_bytes()[sent..])
    }

    /// What the program has written to stderr.
    pub const fn log(&self) -> &ErrorLog {
        &self.log
    }

    /// Has `keeper` called with the log at the end.
    pub fn keep_log(&mut self, keeper: LogKeeper<'s>) {
        self.log_keeper = Some(keeper);
    }

    /// Ends the program with all its processes, and returns what it wrote to stderr.
    pub fn end(mut self) -> ErrorLog {
        self.end_now();
        core::mem::take(&mut self.log)
    }

    fn end_now(&mut self) {
        if self.is_closed {
            return;
        }
        self.stdin = None;
        self.command(END);
        // The supervisor ends after the last process, and a stop of the match does not hurry it.
        // Meanwhile the program's output is read, so that one that writes before it ends is not held up.
        let longest = Instant::now() + 2 * self.grace + SUPERVISOR_PATIENCE;
        while !self.is_closed && Instant::now() < longest {
            self.pass(&mut &[][..], SLICE);
            self.pending.clear();
        }
        self.is_closed = true;
        let _ = self.supervisor.kill();
        let _ = self.supervisor.wait();
        if let Some(keep) = self.log_keeper.take() {
            keep(&self.log);
        }
    }

    fn command(&self, command: u8) {
        // A supervisor that has gone is noticed when its socket is read.
        let _ = rustix::net::send(&self.socket, &[command], SendFlags::NOSIGNAL);
    }

    /// Lets the program run.
    fn proceed(&mut self) -> Result<(), ChannelFault> {
        if self.runs {
            return Ok(());
        }
        self.command(PROCEED);
        self.runs = true;
        let patience = Wait::supervisor();
        while self.supervisor_line(&patience)? != PROCEEDING {}
        Ok(())
    }

    /// Stops the program.
    fn stop(&mut self) {
        self.command(STOP);
        self.runs = false;
    }

    /// The next line of the supervisor.
    fn supervisor_line(&mut self, wait: &Wait) -> Result<String, ChannelFault> {
        loop {
            if let Some(line) = self.read_supervisor_line() {
                return Ok(line);
            }
            if self.is_closed {
                return Err(self.crash());
            }
            self.turn(&mut &[][..], wait)?;
        }
    }

    /// A line of the supervisor that has come. One that the program has ended is noted.
    fn read_supervisor_line(&mut self) -> Option<String> {
        let line = split_line(&mut self.unread)?;
        let line = String::from_utf8_lossy(&line).into_owned();
        if let Some(how) = line.strip_prefix(ENDED) {
            self.ended.get_or_insert_with(|| how.into());
        }
        Some(line)
    }

    /// Waits once, until something can be read or written or the wait is over, and reads and writes it.
    fn turn(&mut self, out: &mut &[u8], wait: &Wait) -> Result<(), ChannelFault> {
        if (self.is_stopped)() {
            return Err(ChannelFault::Stopped);
        }
        self.pass(out, wait.slice());
        if self.log.size() > MOST_ERRORS {
            return Err(ChannelFault::Flood);
        }
        if wait.is_over() { Err(wait.fault.clone()) } else { Ok(()) }
    }

    /// Waits until something can be read or written, at most this long, and reads and writes it.
    fn pass(&mut self, out: &mut &[u8], longest: Duration) {
        let ready = self.poll(!out.is_empty(), longest);
        let mut block = [0; BLOCK];
        if ready.stdin {
            self.write(out);
        }
        if ready.stdout {
            match read(&self.stdout, &mut block) {
                Taken::Bytes(bytes) => self.pending.extend_from_slice(bytes),
                Taken::Nothing => {}
                Taken::End => self.stdout = None,
            }
        }
        if ready.stderr {
            match read(&self.stderr, &mut block) {
                Taken::Bytes(bytes) => self.log.add(bytes),
                Taken::Nothing => {}
                Taken::End => self.stderr = None,
            }
        }
        if ready.socket {
            match read(&Some(&self.socket), &mut block) {
                Taken::Bytes(bytes) => self.unread.extend_from_slice(bytes),
                Taken::Nothing => {}
                Taken::End => self.is_closed = true,
            }
        }
    }

    /// The streams that are ready. A signal or an error of the system makes none ready.
    fn poll(&self, writes: bool, slice: Duration) -> Ready {
        let slice = Timespec::try_from(slice).ok();
        let fds = [
            self.stdin.as_ref().filter(|_| writes).map(|fd| (fd.as_fd(), PollFlags::OUT)),
            // What is not read stays in the pipe, and a program that writes on has to wait.
            self.stdout
                .as_ref()
                .filter(|_| self.pending.len() <= 2 * LONGEST_LINE)
                .map(|fd| (fd.as_fd(), PollFlags::IN)),
            self.stderr.as_ref().map(|fd| (fd.as_fd(), PollFlags::IN)),
            Some((self.socket.as_fd(), PollFlags::IN)),
        ];
        let mut open: Vec<PollFd<'_>> =
            fds.iter().flatten().map(|(fd, flags)| PollFd::from_borrowed_fd(*fd, *flags)).collect();
        if poll(&mut open, slice.as_ref()).is_err() {
            return Ready::default();
        }
        let mut events = open.iter().map(|fd| !fd.revents().is_empty());
        let [stdin, stdout, stderr, socket] =
            fds.map(|fd| fd.is_some() && events.next().unwrap_or(false));
        Ready { stdin, stdout, stderr, socket }
    }

    fn write(&mut self, out: &mut &[u8]) {
        let Some(stdin) = &self.stdin else { return };
        match rustix::io::write(stdin, out) {
            Ok(count) => *out = &out[count..],
            Err(Errno::INTR | Errno::AGAIN) => {}
            // A program that has closed its input may still answer.
            Err(_) => self.stdin = None,
        }
    }

    /// The next line that has come.
    fn take_line(&mut self) -> Result<Option<String>, ChannelFault> {
        if self.pending.iter().filter(|byte| **byte == b'\n').count() > MOST_PENDING_LINES {
            return Err(ChannelFault::Flood);
        }
        let end = self.pending.iter().position(|byte| *byte == b'\n');
        if end.unwrap_or(self.pending.len()) > LONGEST_LINE {
            return Err(ChannelFault::LongLine);
        }
        let Some(mut line) = split_line(&mut self.pending) else { return Ok(None) };
        if line.last() == Some(&b'\r') {
            line.pop();
        }
        String::from_utf8(line).map(Some).map_err(|_| ChannelFault::NotUtf8)
    }

    /// Notes the end of a program and reads what it wrote before. Whether it has ended.
    fn has_ended(&mut self) -> bool {
        while self.read_supervisor_line().is_some() {}
        let has_ended = self.is_closed || self.ended.is_some();
        if has_ended || self.stdout.is_none() {
            // The notice of the end comes a little after the last output, or before it is read.
            let wait = Wait { until: Some(Instant::now() + SLICE), fault: ChannelFault::Stall };
            let is_read = |channel: &Self| channel.stdout.is_none() && channel.ended.is_some();
            while !is_read(self) && !self.is_closed && self.turn(&mut &[][..], &wait).is_ok() {
                while self.read_supervisor_line().is_some() {}
            }
            return true;
        }
        false
    }

    /// The fault of a program that has ended.
    fn crash(&self) -> ChannelFault {
        let how = match (&self.ended, self.is_closed) {
            (Some(how), _) => format!("the program ended {how}"),
            (None, true) => String::from("the supervisor of the program was killed"),
            (None, false) => String::from("the program closed its output"),
        };
        let last = self.log.last_line();
        let said = last.map(|line| format!("; the last line on its stderr: {line}"));
        ChannelFault::Crash(format!("{how}{}", said.unwrap_or_default()))
    }
}

impl LineChannel for ProgramChannel<'_> {
    fn send(&mut self, line: &str, deadline: Option<Instant>) -> Result<(), ChannelFault> {
        self.proceed()?;
        let text = format!("{line}\n");
        let mut out = text.as_bytes();
        let wait = Wait::answer(deadline);
        // A program that has closed its input misses the line; whether it answers is seen later.
        while !out.is_empty() && self.stdin.is_some() {
            if self.ended.is_some() || self.is_closed {
                return Err(self.crash());
            }
            self.turn(&mut out, &wait)?;
            while self.read_supervisor_line().is_some() {}
        }
        Ok(())
    }

    fn receive(&mut self, deadline: Option<Instant>) -> Result<String, ChannelFault> {
        let wait = Wait::answer(deadline);
        let mut has_ended = false;
        loop {
            let line = self.take_line().transpose();
            if let Some(line) = line {
                self.stop();
                return line;
            }
            if has_ended {
                return Err(self.crash());
            }
            self.proceed()?;
            has_ended = self.has_ended();
            if !has_ended {
                self.turn(&mut &[][..], &wait)?;
            }
        }
    }
}

impl Drop for ProgramChannel<'_> {
    fn drop(&mut self) {
        self.end_now();
    }
}

/// How long to wait.
struct Wait {
    until: Option<Instant>,
    /// The fault afterwards.
    fault: ChannelFault,
}

impl Wait {
    /// Until the time of the player is over, or until a program without such a time is given up.
    fn answer(deadline: Option<Instant>) -> Self {
        let fault = if deadline.is_some() { ChannelFault::TimeOver } else { ChannelFault::Stall };
        Self { until: deadline.or_else(|| Instant::now().checked_add(STALL)), fault }
    }

    /// Until a supervisor must have obeyed.
    fn supervisor() -> Self {
        let fault = ChannelFault::Crash("the supervisor of the program did not answer".into());
        Self { until: Instant::now().checked_add(SUPERVISOR_PATIENCE), fault }
    }

    /// The time until the next look at the clock.
    fn slice(&self) -> Duration {
        let left = self.until.map(|until| until.saturating_duration_since(Instant::now()));
        left.unwrap_or(SLICE).min(SLICE)
    }

    fn is_over(&self) -> bool {
        self.until.is_some_and(|until| Instant::now() >= until)
    }
}

/// The streams that can be read or written.
#[derive(Clone, Copy, Default)]
struct Ready {
    stdin: bool,
    stdout: bool,
    stderr: bool,
    socket: bool,
}

/// What was read from a stream.
enum Taken<'b> {
    Bytes(&'b [u8]),
    Nothing,
    End,
}

fn read<'b>(stream: &Option<impl AsFd>, block: &'b mut [u8]) -> Taken<'b> {
    let Some(stream) = stream else { return Taken::Nothing };
    match rustix::io::read(stream, &mut *block) {
        Ok(0) => Taken::End,
        Ok(count) => Taken::Bytes(&block[..count]),
        Err(Errno::INTR | Errno::AGAIN) => Taken::Nothing,
        Err(_) => Taken::End,
    }
}

/// Takes the first line, without its line feed.
fn split_line(bytes: &mut Vec<u8>) -> Option<Vec<u8>> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    let rest = bytes.split_off(end + 1);
    let mut line = core::mem::replace(bytes, rest);
    line.truncate(end);
    Some(line)
}
