//! Simulates the 100 000 random shots of Leckie & Greenspan 2006, section 3, with each root finder
//! in the event loop, and prints as JSON how many have an impossible result and how long a shot
//! takes. The engine's own finder is timed with its proofs of no contact, the others without (the
//! key `proofs`).
//!
//! `cargo run --release -p carom-peers --example root_finders -- [SHOTS [TIMED [METHOD]]]`
//!
//! METHOD is the name of one method, such as `carom`; the default is all of them.

use carom_peers::whole_shots::{Contestant, RootRule, ShotSource, TOLERANCES};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, usual: u64| {
        arguments.get(place).map_or(usual, |text| text.parse().expect("a number"))
    };
    let (shots, timed) = (number(0, 100_000), number(1, 1_000));
    let wanted = |finder: &&Contestant| arguments.get(2).is_none_or(|m| finder.method == m);
    let mut lines = Vec::new();
    for family in [ShotSource::Ordinary, ShotSource::Frozen] {
        for finder in Contestant::ALL.iter().filter(wanted) {
            if let Some(share) = share(family, finder) {
                lines.push(line(family, finder, shots / share, timed));
            }
        }
    }
    println!("{{");
    println!(
        r#" "command": "cargo run --release -p carom-peers --example root_finders -- {shots} {timed}","#
    );
    println!(" \"finders\": [\n{}\n ]\n}}", lines.join(",\n"));
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

fn line(family: ShotSource, finder: &Contestant, shots: u64, timed: u64) -> String {
    let found = finder.check(family, shots);
    let microseconds = 1e6 * finder.seconds_per_shot(family, timed.min(shots));
    let impossible: Vec<String> = TOLERANCES
        .iter()
        .zip(found.impossible)
        .map(|((name, _), count)| format!(r#""{name}": {count}"#))
        .collect();
    let (family, reading) = (family.name(), finder.rule.name());
    eprintln!("{family}, {}, {reading}: {found:?}, {microseconds:.1} µs", finder.method);
    format!(
        r#"  {{"family": "{family}", "method": "{}", "reading": "{reading}", "shots": {shots}, "proofs": {}, "impossible": {{{}}}, "overlap": {}, "apart": {}, "endless": {}, "other": {}, "microseconds_per_shot": {microseconds:.1}}}"#,
        finder.method,
        finder.rule == RootRule::FirstContact,
        impossible.join(", "),
        found.overlap,
        found.apart,
        found.endless,
        found.other,
    )
}
