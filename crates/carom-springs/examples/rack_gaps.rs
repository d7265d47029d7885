//! Eight-ball breaks from racks with various gaps: the engine, and springs integrated in time.
//!
//! Usage: `rack_gaps [--racks N] [--first SEED] [--speed M_PER_S]`
//!
//! Prints JSON: for every gap and method the share of breaks in which an object ball falls, and the
//! mean number of balls that fall, with standard errors. Break k has rack k and errors k of a
//! professional's strike, the same for all methods.

use std::process::ExitCode;
use std::time::Instant;

use carom_springs::breaks::{BreakMethod, BreakResult, opening, play};
use indicatif::{ParallelProgressIterator, ProgressBar};
use rayon::prelude::*;
use serde_json::{Value, json};

/// Mean gaps of the racks, m.
const GAPS: [f64; 7] = [0.0, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 1e-3];

const METHODS: [(&str, BreakMethod); 3] = [
    ("engine", BreakMethod::Engine),
    ("springs", BreakMethod::MovingSprings),
    ("springs, fixed normals", BreakMethod::FixedSprings),
];

fn main() -> ExitCode {
    let (mut racks, mut first, mut speed) = (300_u64, 0_u64, 8.0);
    let mut arguments = std::env::args().skip(1);
    while let Some(flag) = arguments.next() {
        let number = arguments.next().and_then(|text| text.parse::<f64>().ok());
        match (flag.as_str(), number) {
            ("--racks", Some(n)) => racks = n as u64,
            ("--first", Some(n)) => first = n as u64,
            ("--speed", Some(v)) => speed = v,
            _ => {
                eprintln!("{flag}: write --racks N, --first SEED or --speed M_PER_S");
                return ExitCode::from(2);
            }
        }
    }
    let mut rows = Vec::new();
    for gap in GAPS {
        for (name, method) in METHODS {
            eprintln!("gap {gap} m, {name}");
            rows.push(row(gap, name, method, speed, first..first + racks));
        }
    }
    let result = json!({
        "command": format!(
            "cargo run --release -p carom-springs --example rack_gaps -- --racks {racks} \
             --first {first} --speed {speed}"
        ),
        "racks": racks, "first": first, "cue_speed": speed, "rows": rows,
    });
    println!("{result:#}");
    ExitCode::SUCCESS
}

fn row(
    gap: f64,
    name: &str,
    method: BreakMethod,
    speed: f64,
    racks: std::ops::Range<u64>,
) -> Value {
    let begin = Instant::now();
    let bar = ProgressBar::new(racks.end - racks.start);
    let results: Vec<Result<BreakResult, String>> = racks
        .into_par_iter()
        .progress_with(bar)
        .map(|k| opening(gap, speed, k).and_then(|shot| play(&shot, method)))
        .collect();
    let played: Vec<BreakResult> =
        results.iter().filter_map(|r| r.as_ref().ok().copied()).collect();
    let errors: Vec<&String> = results.iter().filter_map(|r| r.as_ref().err()).collect();
    let statistics = |value: fn(&BreakResult) -> f64| {
        let n = played.len() as f64;
        let mean = played.iter().map(value).sum::<f64>() / n;
        let square = played.iter().map(|r| (value(r) - mean).powi(2)).sum::<f64>() / (n - 1.0);
        json!([mean, (square / n).sqrt()])
    };
    json!({
        "gap": gap,
        "method": name,
        "breaks": played.len(),
        "refused": errors.len(),
        "why": errors.first(),
        "success": statistics(|r| f64::from(u8::from(r.potted > 0))),
        "success_without_scratch": statistics(|r| f64::from(u8::from(r.potted > 0 && !r.scratch))),
        "potted": statistics(|r| r.potted as f64),
        "seconds": begin.elapsed().as_secs_f64(),
    })
}
