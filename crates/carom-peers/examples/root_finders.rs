//! The 100 000 random shots of Leckie & Greenspan 2006, section 3, with each root finder in the event
//! loop: how many have an impossible result, and how long a shot takes. Prints JSON.
//!
//! `cargo run --release -p carom-peers --example root_finders -- [SHOTS [TIMED [METHOD]]]`
//!
//! METHOD is one method's name, such as `carom`; all of them without it.

use carom_peers::whole_shots::{Contestant, Reading, ShotSource, TOLERANCES};

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

/// One of so many shots is played: a tenth of the hard ones, and a hundredth where many a shot runs
/// until it is stopped.
fn share(family: ShotSource, finder: &Contestant) -> Option<u64> {
    match (family, finder.reading) {
        // Its stopped shots would take hours.
        (_, Reading::Smallest) if finder.method == "companion matrix" => None,
        (ShotSource::Ordinary, Reading::Smallest) => Some(100),
        (ShotSource::Frozen, Reading::Smallest) => None,
        (ShotSource::Ordinary, Reading::Approaching | Reading::FirstContact) => Some(1),
        (ShotSource::Ordinary, Reading::FromTheStart) | (ShotSource::Frozen, _) => Some(10),
    }
}

fn line(family: ShotSource, finder: &Contestant, shots: u64, timed: u64) -> String {
    let found = finder.judge(family, shots);
    let microseconds = 1e6 * finder.seconds_per_shot(family, timed.min(shots));
    let impossible: Vec<String> = TOLERANCES
        .iter()
        .zip(found.impossible)
        .map(|((name, _), count)| format!(r#""{name}": {count}"#))
        .collect();
    let (family, reading) = (family.name(), finder.reading.name());
    eprintln!("{family}, {}, {reading}: {found:?}, {microseconds:.1} µs", finder.method);
    format!(
        r#"  {{"family": "{family}", "method": "{}", "reading": "{reading}", "shots": {shots}, "impossible": {{{}}}, "overlap": {}, "apart": {}, "endless": {}, "other": {}, "microseconds_per_shot": {microseconds:.1}}}"#,
        finder.method,
        impossible.join(", "),
        found.overlap,
        found.apart,
        found.endless,
        found.other,
    )
}
