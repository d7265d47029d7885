//! Limits of a program: those of the kernel for each process, and those that the supervisor watches.

use std::io;

use carom::Error;
use carom::format::{Node, Reader};
use rustix::process::{Resource, Rlimit, setrlimit};

/// What a program may use. The kernel enforces the limits of a process. The supervisor looks at the
/// limits of the whole program a few times a second and ends a program that exceeds one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgramLimits {
    /// Processor time of each process, s.
    pub cpu_seconds: u32,
    /// Open files of each process.
    pub open_files: u32,
    /// Size of each file that is written, bytes.
    pub file_bytes: u64,
    /// Address space of each process, bytes; `None` for no limit. Node and Java reserve far more than
    /// they use and end under a limit.
    pub address_space: Option<u64>,
    /// Processes of the program, which the supervisor counts. `RLIMIT_NPROC` would count all
    /// processes of the user and would not bind root.
    pub processes: u32,
    /// Memory of all processes of the program, bytes, as the supervisor adds it up. Shared pages
    /// count in every process.
    pub memory: u64,
}

impl Default for ProgramLimits {
    /// An hour of processor time, 256 files, 256 MiB a file, 64 processes, 4 GiB.
    fn default() -> Self {
        Self {
            cpu_seconds: 3600,
            open_files: 256,
            file_bytes: 256 << 20,
            address_space: None,
            processes: 64,
            memory: 4 << 30,
        }
    }
}

impl ProgramLimits {
    /// The limits as an object.
    pub fn to_node(self) -> Node {
        let bytes = |bytes: u64| Node::Integer(i64::try_from(bytes).unwrap_or(i64::MAX));
        Node::object([
            ("cpu_seconds", self.cpu_seconds.into()),
            ("open_files", self.open_files.into()),
            ("file_bytes", bytes(self.file_bytes)),
            ("address_space", self.address_space.map_or(Node::Null, bytes)),
            ("processes", self.processes.into()),
            ("memory", bytes(self.memory)),
        ])
    }

    /// Reads what [`Self::to_node`] wrote.
    pub(super) fn read(reader: &Reader<'_>) -> Result<Self, Error> {
        let number = |key| reader.require(key, "a number")?.whole(0, i64::MAX);
        let small = |key| number(key).map(|amount| u32::try_from(amount).unwrap_or(u32::MAX));
        let bytes = |key| number(key).map(i64::unsigned_abs);
        Ok(Self {
            cpu_seconds: small("cpu_seconds")?,
            open_files: small("open_files")?,
            file_bytes: bytes("file_bytes")?,
            address_space: reader
                .get("address_space")
                .map(|_| bytes("address_space"))
                .transpose()?,
            processes: small("processes")?,
            memory: bytes("memory")?,
        })
    }

    /// Sets the limits of a process for this one, and so for all that it starts.
    pub(super) fn apply(&self) -> io::Result<()> {
        let set = |resource, amount: Option<u64>| {
            // The hard limit can only go down for a user who is not root.
            let most = rustix::process::getrlimit(resource).maximum;
            let amount = match (amount, most) {
                (Some(amount), Some(most)) => Some(amount.min(most)),
                (amount, most) => amount.or(most),
            };
            setrlimit(resource, Rlimit { current: amount, maximum: amount })
        };
        set(Resource::Cpu, Some(u64::from(self.cpu_seconds)))?;
        set(Resource::Nofile, Some(u64::from(self.open_files)))?;
        set(Resource::Fsize, Some(self.file_bytes))?;
        set(Resource::Core, Some(0))?;
        if self.address_space.is_some() {
            set(Resource::As, self.address_space)?;
        }
        Ok(())
    }
}
