//! Compares the engine's impacts of many bodies with springs integrated in time.
//!
//! Usage: `networks [--kind NAME] [--count N] [--first SEED] [--with-walls] [--fixed-normals]
//! [--own-error]`
//!
//! Prints JSON: for every kind the median, the 99th percentile and the worst of the largest
//! difference of a ball's velocity, as a share of the fastest ball's speed, with the seeds of the
//! worst cases. `--own-error` compares two accuracies of the springs instead. A range of seeds can
//! be run in parts: `--first` continues where another run ended.

use std::process::ExitCode;
use std::time::Instant;

use carom_springs::build::Springs;
use carom_springs::judge::{CaseKind, judge, own_error};
use carom_springs::motion::Settings;
use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde_json::{Value, json};

/// The worst cases that are listed.
const LISTED: usize = 5;

struct Plan {
    kind: Option<String>,
    count: u64,
    first: u64,
    walls: bool,
    fixed: bool,
    own_error: bool,
}

fn main() -> ExitCode {
    let plan = match read(std::env::args().skip(1)) {
        Ok(plan) => plan,
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    };
    let kinds: Vec<CaseKind> = CaseKind::all()
        .into_iter()
        .filter(|kind| plan.kind.as_ref().is_none_or(|name| *name == kind.name()))
        .collect();
    if kinds.is_empty() {
        let known: Vec<String> = CaseKind::all().iter().map(CaseKind::name).collect();
        eprintln!("--kind: there is no such kind; write one of {}", known.join(", "));
        return ExitCode::from(2);
    }
    let rows: Vec<Value> = kinds.iter().map(|kind| distribution(kind, &plan)).collect();
    println!("{:#}", json!({"first": plan.first, "count": plan.count, "kinds": rows}));
    ExitCode::SUCCESS
}

fn read(mut arguments: impl Iterator<Item = String>) -> Result<Plan, String> {
    let mut plan =
        Plan { kind: None, count: 1000, first: 0, walls: false, fixed: false, own_error: false };
    while let Some(flag) = arguments.next() {
        let mut value = || arguments.next().ok_or_else(|| format!("{flag} needs a value"));
        let number = |text: String| {
            text.replace('_', "").parse().map_err(|_| format!("{flag}: not a number: {text}"))
        };
        match flag.as_str() {
            "--kind" => plan.kind = Some(value()?),
            "--count" => plan.count = number(value()?)?,
            "--first" => plan.first = number(value()?)?,
            "--with-walls" => plan.walls = true,
            "--fixed-normals" => plan.fixed = true,
            "--own-error" => plan.own_error = true,
            _ => return Err(format!("unknown argument {flag}; see the head of this example")),
        }
    }
    Ok(plan)
}

/// The differences of velocity and of Rω, or why there are none.
type Judged = Result<(f64, f64), String>;

fn distribution(kind: &CaseKind, plan: &Plan) -> Value {
    let springs = Springs { walls: plan.walls, keeps_normals: plan.fixed, ..Springs::USUAL };
    let style = ProgressStyle::with_template("{msg:28} {wide_bar} {pos}/{len} {eta}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(plan.count).with_style(style).with_message(kind.name());
    let begin = Instant::now();
    let results: Vec<(u64, Judged)> = (plan.first..plan.first + plan.count)
        .into_par_iter()
        .progress_with(bar)
        .map(|seed| {
            let file = kind.shot_file(seed);
            let result = if plan.own_error {
                let both = [&Settings::USUAL, &Settings::FINE];
                own_error(&file, &springs, both).map(|error| (error, 0.0))
            } else {
                judge(&file, &springs, &Settings::USUAL).map(|d| (d.velocity, d.surface))
            };
            (seed, result)
        })
        .collect();
    let seconds = begin.elapsed().as_secs_f64();
    let mut found: Vec<(f64, u64)> = Vec::new();
    let mut surfaces = Vec::new();
    let mut refused: Vec<(u64, &String)> = Vec::new();
    for (seed, result) in &results {
        match result {
            Ok((velocity, surface)) => {
                found.push((*velocity, *seed));
                surfaces.push(*surface);
            }
            Err(why) => refused.push((*seed, why)),
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    surfaces.sort_by(f64::total_cmp);
    let quantile = |share: f64| match found.len() {
        0 => Value::Null,
        n => json!(found[((n - 1) as f64 * share).round() as usize].0),
    };
    let above = |bound: f64| found.iter().filter(|(d, _)| *d > bound).count();
    json!({
        "kind": kind.name(),
        "judged": found.len(),
        "median": quantile(0.5),
        "p99": quantile(0.99),
        "p999": quantile(0.999),
        "worst": quantile(1.0),
        "above_1e-3": above(1e-3),
        "above_1e-4": above(1e-4),
        "spin_median": surfaces.get(surfaces.len() / 2),
        "spin_worst": surfaces.last(),
        "worst_seeds": found.iter().rev().take(LISTED).map(|(d, s)| json!([s, d])).collect::<Vec<_>>(),
        "not_judged": refused.len(),
        "why": refused.iter().take(LISTED).map(|(s, w)| json!([s, w])).collect::<Vec<_>>(),
        "ms_per_case": 1e3 * seconds * rayon::current_num_threads() as f64 / plan.count as f64,
    })
}
