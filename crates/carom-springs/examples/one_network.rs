//! Prints one random network: its shot file, and the velocities by the engine and by the springs.
//!
//! Usage: `one_network KIND SEED [--with-walls] [--fixed-normals]`, with the kinds of `networks`.

use std::process::ExitCode;

use carom::Shot;
use carom_springs::build::Springs;
use carom_springs::judge::{CaseKind, integrated, nearest, played};
use carom_springs::motion::Settings;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let kind = CaseKind::all().into_iter().find(|kind| arguments.first() == Some(&kind.name()));
    let seed = arguments.get(1).and_then(|text| text.parse().ok());
    let (Some(kind), Some(seed)) = (kind, seed) else {
        let known: Vec<String> = CaseKind::all().iter().map(CaseKind::name).collect();
        eprintln!("write a kind and a seed; the kinds are {}", known.join(", "));
        return ExitCode::from(2);
    };
    let has = |flag: &str| arguments.iter().any(|argument| argument == flag);
    let springs = Springs {
        walls: has("--with-walls"),
        keeps_normals: has("--fixed-normals"),
        ..Springs::USUAL
    };
    match print(&kind.shot_file(seed), &springs) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn print(file: &str, springs: &Springs) -> Result<(), String> {
    println!("{file}");
    let shot = Shot::from_json(file).map_err(|error| error.to_string())?;
    let found = played(&shot)?;
    let impact = integrated(&shot, springs, &Settings::FINE)?;
    println!("nearest end: {:?}", nearest(&found, &impact));
    for (time, exact) in &impact.pauses {
        println!("without force after {:.1} us; engine, springs (m/s):", 1e6 * time);
        for (k, (found, exact)) in found.balls.iter().zip(&exact.balls).enumerate() {
            let (v, w) = (found.velocity.as_slice(), exact.velocity.as_slice());
            println!("  {k:2} {v:9.5?} {w:9.5?}");
        }
    }
    Ok(())
}
