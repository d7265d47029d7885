//! `make stress`: checks millions of random shots. Prints the tally of each family and, for some
//! faulty shots, the shot file.
//!
//! Usage: `stress [SHOTS] [FIRST_SEED]`, by default 10 million from seed 0. The shots are divided
//! equally among the families, rounded up.

use std::process::ExitCode;

use carom::Shot;
use carom_check::random_shots::{ShotFamily, shot_file};
use carom_check::{CheckRecorder, Tally};
use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let mut number = |default: u64| -> Result<u64, String> {
        arguments.next().map_or(Ok(default), |text| {
            text.replace('_', "").parse().map_err(|_| format!("not a number: {text}"))
        })
    };
    let (shots, first) = match (number(10_000_000), number(0)) {
        (Ok(shots), Ok(first)) => (shots, first),
        (Err(e), _) | (_, Err(e)) => {
            eprintln!("{e}; usage: stress [SHOTS] [FIRST_SEED]");
            return ExitCode::from(2);
        }
    };
    let mut faulty = false;
    for family in ShotFamily::ALL {
        let count = shots.div_ceil(ShotFamily::ALL.len() as u64);
        let style = ProgressStyle::with_template("{msg:16} {wide_bar} {pos}/{len} {eta}")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::new(count).with_style(style).with_message(format!("{family:?}"));
        let tally = (first..first.saturating_add(count))
            .into_par_iter()
            .progress_with(bar)
            .map(|seed| check(family, seed))
            .reduce(Tally::default, Tally::with);
        println!("{family:?}: {tally}");
        for (seed, text) in &tally.examples {
            println!("--- {family:?} seed {seed}\n{text}");
        }
        faulty |= tally.faulty > 0;
    }
    if faulty { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

fn check(family: ShotFamily, seed: u64) -> Tally {
    let file = shot_file(family, seed);
    match Shot::from_json(&file) {
        Ok(shot) => Tally::of(seed, &CheckRecorder::run(&shot), &file),
        Err(_) => Tally::refused(),
    }
}
