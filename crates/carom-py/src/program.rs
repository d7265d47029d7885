//! External programs as players of a match. Their supervisor is this library in another Python.

use std::path::PathBuf;

use carom_arena::{MatchPlayer, PlayerEntry, ProtocolSettings};
use pyo3::prelude::*;

/// A program: its name as a player; the folder to which its files are relative; the executable of Python;
/// the file of this library; a function that gets what it writes to stderr; files that it must not read;
/// and whether everything must be enforced.
pub(crate) type ProgramArguments =
    (String, PathBuf, PathBuf, PathBuf, Option<Py<PyAny>>, Vec<PathBuf>, bool);

#[cfg(target_os = "linux")]
mod linux {
    use std::path::Path;
    use std::sync::Arc;

    use carom::Error;
    use carom_arena::{
        Confinement, ProgramCommand, ProgramPlayer, ProgramSite, StopCheck, SupervisorCommand,
    };
    use pyo3::prelude::*;

    use super::{MatchPlayer, PlayerEntry, ProgramArguments, ProtocolSettings};

    /// What Python runs as a supervisor: it loads this library, and nothing else of the package.
    const SUPERVISOR: &str = "import sys
from importlib import machinery, util
loader = machinery.ExtensionFileLoader('_core', sys.argv[1])
module = util.module_from_spec(util.spec_from_loader('_core', loader))
loader.exec_module(module)
module.supervise()";

    /// A program, whose files are relative to `folder`, as the header of a record has it; None for the
    /// name of another player.
    pub(crate) fn program_entry(name: &str, folder: &Path) -> Option<Result<PlayerEntry, Error>> {
        let read = || ProgramCommand::read(name, folder)?.entry(Confinement::strongest());
        ProgramCommand::is_one(name).then(read)
    }

    /// A program, before the frames.
    pub(crate) struct Program {
        command: Arc<ProgramCommand>,
        site: Arc<ProgramSite>,
        entry: PlayerEntry,
    }

    impl Program {
        pub(crate) fn read(arguments: ProgramArguments) -> Result<Self, Error> {
            let (name, folder, python, library, log, hidden, strict) = arguments;
            let command = Arc::new(ProgramCommand::read(&name, &folder)?);
            let confinement = Confinement::here(strict)?;
            let entry = command.entry(confinement)?;
            let arguments = ["-I", "-S", "-c", SUPERVISOR].map(Into::into).to_vec();
            let mut supervisor = SupervisorCommand { program: python.into(), arguments };
            supervisor.arguments.push(library.into());
            let log = log.map(|log| -> Box<dyn Fn(String) + Send + Sync> {
                Box::new(move |block| {
                    // A full disk must not change the result of the frame.
                    let _ = Python::attach(|py| log.call1(py, (block,)).map(drop));
                })
            });
            let site = ProgramSite { supervisor, confinement, hidden, log };
            Ok(Self { command, site: site.into(), entry })
        }

        pub(crate) fn entry(&self) -> PlayerEntry {
            self.entry.clone()
        }

        /// The program in a frame, asked as `settings` say, or else as its name says.
        pub(crate) fn player<'s>(
            &self,
            is_stopped: StopCheck<'s>,
            settings: Option<ProtocolSettings>,
        ) -> Box<dyn MatchPlayer + 's> {
            let (command, site) = (Arc::clone(&self.command), Arc::clone(&self.site));
            let player = ProgramPlayer::new(command, site, is_stopped);
            Box::new(match settings {
                Some(settings) => player.asked(settings),
                None => player,
            })
        }
    }
}

#[cfg(not(target_os = "linux"))]
mod elsewhere {
    use std::path::Path;
    use std::sync::Arc;

    use carom::{Error, ErrorKind};

    use super::{MatchPlayer, PlayerEntry, ProgramArguments, ProtocolSettings};

    pub(crate) type StopCheck<'s> = Arc<dyn Fn() -> bool + Send + Sync + 's>;

    pub(crate) fn program_entry(name: &str, _: &Path) -> Option<Result<PlayerEntry, Error>> {
        name.starts_with("exec").then(|| Err(unsupported()))
    }

    fn unsupported() -> Error {
        let what = "external programs play on Linux only";
        ErrorKind::Unsupported.at("player", what, "write a player in Python")
    }

    /// No program plays on this system.
    pub(crate) enum Program {}

    impl Program {
        pub(crate) fn read(_: ProgramArguments) -> Result<Self, Error> {
            Err(unsupported())
        }

        pub(crate) fn entry(&self) -> PlayerEntry {
            match *self {}
        }

        pub(crate) fn player<'s>(
            &self,
            _: StopCheck<'s>,
            _: Option<ProtocolSettings>,
        ) -> Box<dyn MatchPlayer + 's> {
            match *self {}
        }
    }
}

#[cfg(target_os = "linux")]
pub(crate) use carom_arena::StopCheck;
#[cfg(not(target_os = "linux"))]
pub(crate) use elsewhere::{Program, StopCheck, program_entry};
#[cfg(target_os = "linux")]
pub(crate) use linux::{Program, program_entry};

/// The main function of a supervisor.
#[pyfunction]
pub(crate) fn supervise(py: Python<'_>) -> PyResult<()> {
    #[cfg(target_os = "linux")]
    return Ok(py.detach(carom_arena::supervise)?);
    #[cfg(not(target_os = "linux"))]
    Err(py.detach(|| std::io::Error::from(std::io::ErrorKind::Unsupported)).into())
}
