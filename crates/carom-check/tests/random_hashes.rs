//! 10 000 random shots of all families keep their bits: in every build, on every processor
//! (`scripts/everywhere.sh`). `CAROM_WRITE=1` writes the hashes again, after an intended change of results.

use std::fmt::Write;
use std::path::Path;

use carom::{Error, Shot};
use carom_check::random_shots::{ShotFamily, shot_file};

/// Shots of each family; together at least 10 000.
const SHOTS: u64 = 10_000_u64.div_ceil(ShotFamily::ALL.len() as u64);

/// Seeds that no other run has.
const FIRST_SEED: u64 = 900_000_000;

/// A hash over the hashes of all shots of a family; a refused or capped shot counts by its kind.
fn hash(family: ShotFamily) -> u64 {
    (FIRST_SEED..FIRST_SEED + SHOTS).fold(0xcbf2_9ce4_8422_2325, |hash, seed| {
        let played = Shot::from_json(&shot_file(family, seed)).and_then(|shot| shot.simulate());
        let bits = played.map_or_else(|error: Error| error.kind() as u64, |trace| trace.hash());
        (hash ^ bits).wrapping_mul(0x0100_0000_01b3).rotate_left(23)
    })
}

#[test]
fn random_shots_have_the_same_bits_everywhere() {
    let mut found = String::new();
    for family in ShotFamily::ALL {
        writeln!(found, "{family:?} {SHOTS} {:016x}", hash(family)).unwrap();
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/random_hashes.txt");
    if std::env::var_os("CAROM_WRITE").is_some() {
        std::fs::write(&file, &found).unwrap();
    }
    assert_eq!(found, std::fs::read_to_string(&file).unwrap_or_default());
}
