//! What separates a program from the rest of the machine, where the system allows it.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::thread;

use carom::{Error, ErrorKind};
use rustix::thread::set_no_new_privs;

/// The most that a confined program may write into its folder, bytes. The folder is in memory.
pub(super) const SCRATCH_BYTES: u64 = 256 << 20;

/// What separates a program from the rest of the machine. It is a command that stands before the
/// program's own. Whether the system allows it is found by trying it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Confinement {
    /// [bubblewrap](https://github.com/containers/bubblewrap): no network, processes of its own, files
    /// that it can only read, and a folder of limited size.
    Bubblewrap,
    /// `unshare` of util-linux with a user namespace: no network, and processes of its own.
    Namespaces,
    /// Nothing but what is always enforced.
    Plain,
}

/// The strongest confinement that works here.
static STRONGEST: LazyLock<Confinement> = LazyLock::new(|| {
    let works = |confinement: &Confinement| confinement.works();
    Confinement::ALL.into_iter().find(works).unwrap_or(Confinement::Plain)
});

impl Confinement {
    /// From the strongest to the weakest.
    pub(super) const ALL: [Self; 3] = [Self::Bubblewrap, Self::Namespaces, Self::Plain];

    /// The strongest confinement that works here.
    pub fn strongest() -> Self {
        *STRONGEST
    }

    /// Whether the system allows it.
    pub fn works(self) -> bool {
        let folder = std::env::temp_dir();
        let words = self.wrap(vec!["true".into()], &folder, &[]);
        let Some((program, arguments)) = words.split_first() else { return false };
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        let succeeds = move || {
            // As the supervisor does. It holds for this thread and what it starts.
            set_no_new_privs(true).is_ok() && command.status().is_ok_and(|ended| ended.success())
        };
        thread::spawn(succeeds).join().unwrap_or(false)
    }

    /// The name in orders and messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bubblewrap => "bubblewrap",
            Self::Namespaces => "namespaces",
            Self::Plain => "plain",
        }
    }

    /// What is enforced, in the words of a record.
    pub const fn enforced(self) -> &'static [&'static str] {
        match self {
            Self::Bubblewrap => &["limits", "environment", "tree", "network", "processes", "files"],
            Self::Namespaces => &["limits", "environment", "tree", "network", "processes"],
            Self::Plain => &["limits", "environment", "tree"],
        }
    }

    /// The strongest confinement that works here. If it is `strict`, it covers network, processes and
    /// files.
    ///
    /// # Errors
    /// [`Error::Input`] at `strict` if none here covers them.
    pub fn here(strict: bool) -> Result<Self, Error> {
        match Self::strongest() {
            found @ Self::Bubblewrap => Ok(found),
            found if !strict => Ok(found),
            _ => Err(ErrorKind::Unsupported.at(
                "strict",
                "network, processes and files cannot be closed off for a program here",
                "install bubblewrap and allow user namespaces, or leave strict out",
            )),
        }
    }

    /// The words of a program that runs under this confinement, in the folder `scratch`.
    pub(super) fn wrap(
        self,
        words: Vec<String>,
        scratch: &Path,
        hidden: &[PathBuf],
    ) -> Vec<String> {
        let scratch = scratch.display().to_string();
        let mut wrapped: Vec<String> = Vec::new();
        let mut add = |more: &[&str]| wrapped.extend(more.iter().map(|word| String::from(*word)));
        match self {
            Self::Plain => return words,
            Self::Namespaces => add(&[
                "unshare",
                "--user",
                "--map-root-user",
                "--net",
                "--ipc",
                "--pid",
                "--fork",
                "--kill-child",
                "--mount-proc",
            ]),
            Self::Bubblewrap => {
                add(&["bwrap", "--unshare-all", "--die-with-parent", "--new-session"]);
                add(&["--ro-bind", "/", "/", "--dev", "/dev", "--proc", "/proc"]);
                // Sockets of services, which a read-only folder would still offer.
                add(&["--tmpfs", "/run"]);
                for file in hidden.iter().filter(|file| file.exists()) {
                    add(&["--ro-bind", "/dev/null", &file.display().to_string()]);
                }
                add(&["--size", &SCRATCH_BYTES.to_string(), "--tmpfs", &scratch]);
                add(&["--chdir", &scratch]);
            }
        }
        add(&["--"]);
        wrapped.extend(words);
        wrapped
    }
}

#[cfg(test)]
mod tests {
    use super::Confinement;

    #[test]
    fn what_is_always_enforced_is_enforced_by_all() {
        let always = Confinement::Plain.enforced();
        for confinement in Confinement::ALL {
            assert!(confinement.enforced().starts_with(always), "{}", confinement.name());
        }
    }

    #[test]
    fn the_strongest_confinement_works() {
        assert!(Confinement::Plain.works());
        assert!(Confinement::strongest().works());
    }
}
