//! The command line of a program, `exec:COMMAND ARGUMENTS` or `exec[KEY=VALUE,...]:COMMAND ARGUMENTS`.

use std::env;
use std::fs::{self, File};
use std::io::{self, Read};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};

use sha2::{Digest, Sha256};

use super::confinement::Confinement;
use super::control_group::ControlGroup;
use super::limits::ProgramLimits;
use crate::built_in::{read_settings, written_settings};
use crate::protocol::{MOST_PLAYS, ProtocolSettings};
use crate::secret::hex;
use crate::settings::{LONGEST_NAME, PlayerEntry};

/// A program with its arguments, as a player's name gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramCommand {
    text: String,
    /// The words as they were written.
    written: Vec<String>,
    /// The words with full paths.
    words: Vec<String>,
    settings: Node,
    limits: ProgramLimits,
    protocol: ProtocolSettings,
}

impl ProgramCommand {
    /// Whether a player's name is that of a program.
    pub fn is_one(name: &str) -> bool {
        name.starts_with("exec:") || name.starts_with("exec[")
    }

    /// Reads a player's name: words as a shell separates them, with its quotes, but without variables
    /// and patterns. The program is looked up in `PATH`. It will run in a folder of its own, so a word
    /// with a dot or a slash that names a file or folder in `folder` gets its full path.
    ///
    /// Settings are `menu`, the largest number of plays in the menu of a request; and `memory` (MiB),
    /// `processes`, `cpu` (s) and `file` (MiB), limits of [`ProgramLimits`].
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for a name without the prefix, for a quote without an end, for a
    /// program that does not exist or may not be run, and with the key of an invalid setting.
    pub fn read(name: &str, folder: &Path) -> Result<Self, Error> {
        let refuse = |kind: ErrorKind, what: String, remedy: &str| kind.at("player", what, remedy);
        let example = "write a command, as in \"exec:python3 mine.py\"";
        let not_one = || refuse(ErrorKind::Syntax, format!("\"{name}\" is not a program"), example);
        let rest = name.strip_prefix("exec").ok_or_else(not_one)?;
        let (text, settings) = match rest.strip_prefix('[') {
            Some(inside) => {
                let (settings, text) = inside.split_once("]:").ok_or_else(not_one)?;
                (text, read_settings(&format!("{settings}]"))?)
            }
            None => (rest.strip_prefix(':').ok_or_else(not_one)?, Node::object([])),
        };
        let (limits, protocol) = limits_of(&Reader::new(&settings, "player"))?;
        let Some(written) = shlex::split(text) else {
            let what = format!("a quote in \"{text}\" has no end");
            return Err(refuse(ErrorKind::Syntax, what, "close it, or write \\ before it"));
        };
        let Some((program, arguments)) = written.split_first() else {
            return Err(refuse(ErrorKind::Missing, "the command is empty".into(), example));
        };
        let Some(found) = find_program(program, folder) else {
            let what = format!("there is no program \"{program}\"");
            let remedy = "write its path, and make it executable (chmod +x)";
            return Err(refuse(ErrorKind::Missing, what, remedy));
        };
        let mut words = vec![found.display().to_string()];
        words.extend(arguments.iter().map(|word| full_path(word, folder)));
        Ok(Self { text: text.trim().into(), written, words, settings, limits, protocol })
    }

    /// The program and its arguments, with full paths.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The name in tables and records: the text that was read, shortened.
    pub fn name(&self) -> String {
        let settings =
            if self.has_settings() { written_settings(&self.settings) } else { String::new() };
        shortened(&format!("exec{settings}:{}", self.text))
    }

    fn has_settings(&self) -> bool {
        self.settings != Node::object([])
    }

    /// What the program may use.
    pub const fn limits(&self) -> ProgramLimits {
        self.limits
    }

    /// How it is asked.
    pub const fn protocol(&self) -> ProtocolSettings {
        self.protocol
    }

    /// The program as a match has it. The settings have its words, the hashes of the files among them,
    /// and what is enforced.
    ///
    /// # Errors
    /// [`Error::Input`] at `player` for a file that cannot be read.
    pub fn entry(&self, confinement: Confinement) -> Result<PlayerEntry, Error> {
        let mut files = Node::object([]);
        for (written, word) in self.written.iter().zip(&self.words) {
            if Path::new(word).is_absolute() && Path::new(word).is_file() {
                let hash = hash(Path::new(word)).map_err(|error| {
                    let what = format!("\"{written}\" cannot be read ({error})");
                    ErrorKind::Syntax.at("player", what, "check the rights of the file")
                })?;
                files.set(written, hash);
            }
        }
        let group = ControlGroup::works().then_some("groups");
        let enforced = confinement.enforced().iter().copied().chain(group);
        let mut settings = Node::object([
            ("program", Node::list(&self.written)),
            ("sha256", files),
            ("enforced", Node::list(enforced)),
        ]);
        if self.has_settings() {
            settings.set("settings", self.settings.clone());
        }
        Ok(PlayerEntry { name: self.name(), settings })
    }
}

/// The limits and the kind of requests that the settings give.
fn limits_of(settings: &Reader<'_>) -> Result<(ProgramLimits, ProtocolSettings), Error> {
    settings.keys(&["menu", "memory", "processes", "cpu", "file"])?;
    let mut limits = ProgramLimits::default();
    let whole = |key, most| settings.get(key).map(|value| value.whole(1, most)).transpose();
    if let Some(mib) = whole("memory", i64::from(u32::MAX))? {
        limits.memory = mib.unsigned_abs() << 20;
    }
    if let Some(processes) = whole("processes", i64::from(u32::MAX))? {
        limits.processes = processes as u32;
    }
    if let Some(mib) = whole("file", i64::from(u32::MAX))? {
        limits.file_bytes = mib.unsigned_abs() << 20;
    }
    if let Some(seconds) = whole("cpu", i64::from(u32::MAX))? {
        limits.cpu_seconds = seconds as u32;
    }
    let menu = settings.get("menu").map(|value| value.whole(0, i64::from(MOST_PLAYS)));
    let menu = menu.transpose()?.unwrap_or(0) as u32;
    let protocol = ProtocolSettings { menu, ..ProtocolSettings::default() };
    protocol.check().map_err(|error| error.inside("player"))?;
    Ok((limits, protocol))
}

/// A name that is too long loses its middle: the program stands at the start, and what
/// distinguishes two calls of it often at the end.
fn shortened(name: &str) -> String {
    let letters: Vec<char> = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if letters.len() <= LONGEST_NAME {
        return letters.into_iter().collect();
    }
    let half = (LONGEST_NAME - 1) / 2;
    let (start, end) = (&letters[..half], &letters[letters.len() - half..]);
    start.iter().chain(&['…']).chain(end).collect()
}

/// The file of a program, as a shell finds it in `folder`.
fn find_program(word: &str, folder: &Path) -> Option<PathBuf> {
    let is_program = |path: &PathBuf| {
        fs::metadata(path)
            .is_ok_and(|found| found.is_file() && found.permissions().mode() & 0o111 != 0)
    };
    if word.contains('/') {
        return std::path::absolute(folder.join(word)).ok().filter(is_program);
    }
    let folders = env::var_os("PATH").unwrap_or_default();
    let mut found = env::split_paths(&folders).map(|folder| folder.join(word));
    found.find_map(|path| std::path::absolute(path).ok().filter(is_program))
}

/// The full path of a word that names a file or folder in `folder`.
fn full_path(word: &str, folder: &Path) -> String {
    let path = folder.join(word);
    if word.contains(['.', '/']) && path.exists() {
        return std::path::absolute(&path)
            .map_or_else(|_| word.into(), |p| p.display().to_string());
    }
    word.into()
}

/// SHA-256 of a file, as 64 hexadecimal digits.
fn hash(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let (mut hash, mut block) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut block)? {
            0 => return Ok(hex(&hash.finalize())),
            count => hash.update(&block[..count]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str) -> Result<ProgramCommand, Error> {
        ProgramCommand::read(name, Path::new(""))
    }

    fn refusal(name: &str) -> String {
        read(name).unwrap_err().to_string()
    }

    #[test]
    fn words_are_separated_as_a_shell_does() {
        let command = read("exec: sh -c 'echo \"a b\"' x\\ y $HOME * ").unwrap();
        assert!(command.words[0].ends_with("/sh"), "{:?}", command.words);
        assert_eq!(command.words[1..], ["-c", "echo \"a b\"", "x y", "$HOME", "*"]);
    }

    #[test]
    fn rejects_a_command_that_cannot_run() {
        for (name, what) in [
            ("sh", "\"sh\" is not a program"),
            ("exec:", "the command is empty"),
            ("exec:sh 'a", "has no end"),
            ("exec:no-such-program", "there is no program"),
            ("exec:/etc/passwd", "there is no program"),
            ("exec:/", "there is no program"),
            ("exec[menu=3:sh", "is not a program"),
        ] {
            let error = refusal(name);
            assert!(error.starts_with("player: ") && error.contains(what), "{error}");
        }
    }

    #[test]
    fn settings_are_limits_and_a_menu() {
        let command = read("exec[menu=12,memory=100,cpu=7]:sh -c ]:").unwrap();
        assert_eq!(command.protocol().menu, 12);
        let expected =
            ProgramLimits { memory: 100 << 20, cpu_seconds: 7, ..ProgramLimits::default() };
        assert_eq!(command.limits(), expected);
        let entry = command.entry(Confinement::Plain).unwrap();
        assert_eq!(entry.name, "exec[menu=12,memory=100,cpu=7]:sh -c ]:");
        assert!(entry.settings.get("settings").is_some());
        for (name, place) in [
            ("exec[menus=3]:sh", "player.menus: "),
            ("exec[menu=100000]:sh", "player.menu: "),
            ("exec[memory=0]:sh", "player.memory: "),
            ("exec[cpu=x]:sh", "player.cpu: "),
        ] {
            let error = refusal(name);
            assert!(error.starts_with(place), "{error}");
        }
    }

    #[test]
    fn files_get_full_paths_and_hashes() {
        let command = read("exec:sh Cargo.toml src ./src").unwrap();
        let here = env::current_dir().unwrap();
        let full = |name: &str| here.join(name).display().to_string();
        assert_eq!(command.words[1..], [full("Cargo.toml"), "src".into(), full("src")]);
        let entry = command.entry(Confinement::Plain).unwrap();
        assert_eq!(entry.name, "exec:sh Cargo.toml src ./src");
        let hashes = entry.settings.get("sha256").unwrap();
        let expected = crate::secret::sha256(&fs::read("Cargo.toml").unwrap());
        assert_eq!(hashes.get("Cargo.toml"), Some(&Node::from(expected)));
        assert!(hashes.get("sh").is_some() && hashes.get("./src").is_none());
    }

    #[test]
    fn the_entry_of_a_program_does_not_depend_on_the_folder_in_which_it_is_read() {
        let here = read("exec:sh ./src/lib.rs src").unwrap();
        let folder = env::current_dir().unwrap();
        let text = "exec:sh ./src/lib.rs src";
        let elsewhere = ProgramCommand::read(text, &folder.join("src/..")).unwrap();
        let of = |command: &ProgramCommand| command.entry(Confinement::Plain).unwrap();
        assert_eq!(of(&here), of(&elsewhere));
        assert_eq!(elsewhere.words[1..], [full(&folder, "src/../src/lib.rs"), "src".into()]);
        let error = ProgramCommand::read("exec:./Cargo.toml", Path::new("/etc")).unwrap_err();
        assert!(error.to_string().contains("there is no program"), "{error}");
    }

    fn full(folder: &Path, name: &str) -> String {
        folder.join(name).display().to_string()
    }

    #[test]
    fn a_long_name_keeps_its_start_and_its_end() {
        let name = shortened(&format!("exec:{}7", "x".repeat(200)));
        assert!(name.starts_with("exec:x") && name.ends_with("x7"));
        assert!(name.chars().count() <= LONGEST_NAME, "{name}");
    }
}
