//! Nanoseconds per pair of each finder: `cargo bench -p carom-peers --bench first_contact`.
//!
//! Times here are noisy, so each figure is the least of several passes over the same pairs.

use std::hint::black_box;
use std::time::Instant;

use carom_peers::families::{Case, cluster_pair, uniform_pair};
use carom_peers::finder::Finder;
use carom_peers::random::Random;
use carom_roots::Row;

/// Pairs per set: they fit a second-level cache, as a shot's pairs do.
const PAIRS: usize = 4096;

/// Passes over a set, of which the fastest counts.
const PASSES: usize = 15;

fn nanoseconds_each(cases: &[Case], finder: Finder) -> f64 {
    let pass = || {
        let start = Instant::now();
        for case in cases {
            black_box(finder.first_contact(&case.motion, case.distance, case.horizon));
        }
        start.elapsed().as_nanos() as f64 / cases.len() as f64
    };
    (0..PASSES).map(|_| pass()).fold(f64::INFINITY, f64::min)
}

fn sample(seed: u64, hits_only: bool, draw: impl Fn(&mut Random) -> Case) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    while cases.len() < PAIRS {
        let case = draw(&mut random);
        let hit = carom_roots::first_contact(&case.motion, case.distance, case.horizon).is_some();
        if hit || !hits_only {
            cases.push(case);
        }
    }
    cases
}

/// Lanes of a row: the most balls that a table holds, in full vectors.
const LANES: usize = 24;

fn row_nanoseconds_per_pair(cases: &[Case]) -> (f64, f64) {
    let rows: Vec<Row<LANES>> = cases
        .chunks_exact(LANES)
        .map(|chunk| {
            let lane = |of: fn(&Case) -> f64| std::array::from_fn(|i| of(&chunk[i]));
            Row {
                dx: lane(|case| case.motion.d[0]),
                dy: lane(|case| case.motion.d[1]),
                vx: lane(|case| case.motion.v[0]),
                vy: lane(|case| case.motion.v[1]),
                hx: lane(|case| case.motion.h[0]),
                hy: lane(|case| case.motion.h[1]),
                distance: lane(|case| case.distance),
                horizon: lane(|case| case.horizon),
            }
        })
        .collect();
    let pairs = (rows.len() * LANES) as f64;
    let rejected: usize =
        rows.iter().flat_map(|row| row.cannot_touch()).filter(|&proved| proved).count();
    let pass = || {
        let start = Instant::now();
        for row in &rows {
            black_box(row.cannot_touch());
        }
        start.elapsed().as_nanos() as f64 / pairs
    };
    let least = (0..PASSES).map(|_| pass()).fold(f64::INFINITY, f64::min);
    (least, rejected as f64 / pairs)
}

fn main() {
    let sets = [
        ("pairs of a break, hits", sample(1, true, cluster_pair)),
        ("uniform pairs, hits", sample(2, true, uniform_pair)),
        ("uniform pairs, all", sample(3, false, uniform_pair)),
    ];
    println!("{:<24}{:>24}{:>24}{:>24}", "ns per pair", sets[0].0, sets[1].0, sets[2].0);
    for finder in Finder::ALL {
        print!("{:<24}", finder.name());
        for (_, cases) in &sets {
            print!("{:>24.1}", nanoseconds_each(cases, finder));
        }
        println!();
    }
    for (name, cases) in &sets {
        let (each, share) = row_nanoseconds_per_pair(cases);
        println!("row of {LANES}, {name}: {each:.2} ns per pair, {:.1} % rejected", 100.0 * share);
    }
}
