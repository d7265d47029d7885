//! One program at a time plays the match of a folder.
//!
//! The operating system locks a file, and unlocks it when the program ends, also by a kill. Some network
//! drives have no such locks. There a second file beside the first keeps other programs out; a killed
//! program leaves it, and the refusal names it.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use carom::ErrorKind;

use crate::error::ArenaError;

/// Ends with the program's right to the file.
#[derive(Debug)]
pub(crate) struct Hold {
    /// The file that keeps other programs out where there are no locks.
    running: Option<PathBuf>,
}

impl Hold {
    /// Locks `file`, which is open at `path`, until it is closed.
    pub(crate) fn lock(file: &File, path: &Path) -> Result<Self, ArenaError> {
        Self::after(file.try_lock(), path)
    }

    /// What follows an attempt to lock the file at `path`.
    fn after(attempt: Result<(), TryLockError>, path: &Path) -> Result<Self, ArenaError> {
        match attempt {
            Ok(()) => Ok(Self { running: None }),
            Err(TryLockError::WouldBlock) => {
                Err(refusal("wait for its end, or choose another folder"))
            }
            Err(TryLockError::Error(_)) => Self::claim(path.with_extension("running")),
        }
    }

    fn claim(running: PathBuf) -> Result<Self, ArenaError> {
        match File::create_new(&running) {
            Ok(_) => Ok(Self { running: Some(running) }),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let remedy = "wait for its end, or choose another folder; if that program was killed, delete";
                Err(refusal(&format!("{remedy} {}", running.display())))
            }
            Err(error) => Err(ArenaError::file(&running)(error)),
        }
    }
}

impl Drop for Hold {
    fn drop(&mut self) {
        if let Some(running) = &self.running {
            // A file that cannot be removed keeps other programs out; their refusal names it.
            let _ = fs::remove_file(running);
        }
    }
}

fn refusal(remedy: &str) -> ArenaError {
    ErrorKind::Busy.at("folder", "another program is playing this match", remedy).into()
}

#[cfg(test)]
mod tests {
    use std::fs::TryLockError;
    use std::io::{Error, ErrorKind};

    use super::Hold;

    /// Seen: two programs that began one match on a drive without locks both played it, and mixed their
    /// frames.
    #[test]
    fn on_a_drive_without_locks_a_second_program_is_refused_until_the_first_ends() {
        let name = format!("carom-hold-{}.jsonl", std::process::id());
        let path = std::env::temp_dir().join(name);
        let begin = || {
            let no_locks = TryLockError::Error(Error::from(ErrorKind::Unsupported));
            Hold::after(Err(no_locks), &path)
        };
        let first = begin().expect("the folder is free");
        let refused = begin().expect_err("the first goes on").to_string();
        assert!(refused.starts_with("folder: another program is playing this match"), "{refused}");
        assert!(refused.ends_with(".running"), "{refused}");
        drop(first);
        begin().expect("the first has ended");
    }
}
