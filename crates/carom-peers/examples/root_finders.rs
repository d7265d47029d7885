//! Simulates random shots of Leckie & Greenspan 2006, section 3, with one root finder in the event
//! loop, and prints as JSON how many have an impossible result. `scripts/root_finders.py` runs it
//! for every finder and stores the sums.
//!
//! * `root_finders list` prints one JSON object per finder and family of shots, in a line each: the
//!   names, whether the engine's proofs of no contact are on, and how many times fewer shots are
//!   played than with the others.
//! * `root_finders check FAMILY METHOD READING FIRST COUNT` checks the shots from number FIRST on.
//! * `root_finders time FAMILY METHOD READING COUNT` prints the mean time of a shot, µs.
//!
//! `cargo run --release -p carom-peers --example root_finders -- list`

use std::process::ExitCode;

use carom_check::FaultKind;
use carom_peers::whole_shots::{Contestant, FaultCounts, RootRule, ShotSource, TOLERANCES};

const USAGE: &str = "usage: root_finders list | check FAMILY METHOD READING FIRST COUNT | \
                     time FAMILY METHOD READING COUNT";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match answer(&words) {
        Some(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        None => {
            eprintln!("{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// What to print; `None` if the words cannot be read.
fn answer(words: &[&str]) -> Option<String> {
    match *words {
        ["list"] => Some(list().join("\n")),
        ["check", family, method, reading, first, count] => {
            let (source, finder) = (source(family)?, finder(method, reading)?);
            let (first, count): (u64, u64) = (first.parse().ok()?, count.parse().ok()?);
            Some(checked(&finder.check(source, first..first + count)))
        }
        ["time", family, method, reading, count] => {
            let (source, finder) = (source(family)?, finder(method, reading)?);
            let seconds = finder.seconds_per_shot(source, count.parse().ok()?);
            Some(format!("{:.1}", 1e6 * seconds))
        }
        _ => None,
    }
}

fn source(family: &str) -> Option<ShotSource> {
    [ShotSource::Ordinary, ShotSource::Frozen].into_iter().find(|s| s.name() == family)
}

fn finder(method: &str, reading: &str) -> Option<&'static Contestant> {
    Contestant::ALL.iter().find(|c| c.method == method && c.rule.name() == reading)
}

fn list() -> Vec<String> {
    let mut lines = Vec::new();
    for family in [ShotSource::Ordinary, ShotSource::Frozen] {
        for finder in &Contestant::ALL {
            if let Some(share) = share(family, finder) {
                lines.push(format!(
                    r#"{{"family": "{}", "method": "{}", "reading": "{}", "proofs": {}, "share": {share}}}"#,
                    family.name(),
                    finder.method,
                    finder.rule.name(),
                    finder.has_proofs(),
                ));
            }
        }
    }
    lines
}

/// The divisor of the number of shots: a tenth of the hard shots is simulated, and a hundredth
/// where many shots run until the limit of events. None: the combination is left out.
fn share(family: ShotSource, finder: &Contestant) -> Option<u64> {
    match (family, finder.rule) {
        // With this method, the shots that never end would take hours.
        (_, RootRule::Smallest) if finder.method == "companion matrix" => None,
        (ShotSource::Ordinary, RootRule::Smallest) => Some(100),
        (ShotSource::Frozen, RootRule::Smallest) => None,
        (ShotSource::Ordinary, RootRule::Approaching | RootRule::FirstContact) => Some(1),
        (ShotSource::Ordinary, RootRule::FromTheStart) | (ShotSource::Frozen, _) => Some(10),
    }
}

/// Counts of first faults by tolerance and kind. Kinds without a fault are left out.
fn checked(counts: &FaultCounts) -> String {
    let at = |tolerance: usize| {
        let of_kind = |kind: &FaultKind| (kind.name(), counts.of_kind(tolerance, *kind));
        let kinds: Vec<String> = FaultKind::ALL
            .iter()
            .map(of_kind)
            .filter(|(_, count)| *count > 0)
            .map(|(name, count)| format!(r#""{name}": {count}"#))
            .collect();
        format!(r#""{}": {{{}}}"#, TOLERANCES[tolerance].0, kinds.join(", "))
    };
    let faults: Vec<String> = (0..TOLERANCES.len()).map(at).collect();
    format!(r#"{{"shots": {}, "first_faults": {{{}}}}}"#, counts.shots, faults.join(", "))
}
