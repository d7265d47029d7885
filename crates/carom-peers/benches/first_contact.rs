//! Time per pair of each finder, ns: `cargo bench -p carom-peers --bench first_contact`.
//!
//! The pairs of breaks and of pot shots are those that the engine's cheap proofs leave to its
//! finder. Times are noisy, so each figure is the smallest of several passes over the same pairs.

use std::hint::black_box;
use std::time::Instant;

use carom_peers::families::{Case, uniform_pair};
use carom_peers::finder::Finder;
use carom_peers::harvest::{break_pairs, pot_pairs};
use carom_peers::random::Random;
use carom_roots::Row;

/// Pairs per set. A set fits into a second-level cache, as the pairs of a shot do.
const PAIRS: usize = 4096;

/// Number of passes over a set; the fastest counts.
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

fn uniform(seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    (0..PAIRS).map(|_| uniform_pair(&mut random)).collect()
}

fn uniform_hits(seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let hit = |c: &Case| carom_roots::first_contact(&c.motion, c.distance, c.horizon).is_some();
    std::iter::repeat_with(|| uniform_pair(&mut random)).filter(hit).take(PAIRS).collect()
}

/// Lanes of a row: the largest number of balls on a table, in full vectors.
const LANES: usize = 24;

fn row_nanoseconds_per_pair(cases: &[Case]) -> (f64, f64) {
    let rows: Vec<Row<LANES>> = cases
        .as_chunks::<LANES>()
        .0
        .iter()
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
    let open: usize = rows.iter().filter_map(Row::open).flatten().filter(|&open| open).count();
    let pass = || {
        let start = Instant::now();
        for row in &rows {
            black_box(row.open());
        }
        start.elapsed().as_nanos() as f64 / pairs
    };
    let least = (0..PASSES).map(|_| pass()).fold(f64::INFINITY, f64::min);
    (least, 1.0 - open as f64 / pairs)
}

fn main() {
    let sets = [
        ("8-ball break", break_pairs(1, PAIRS)),
        ("pot shots", pot_pairs(1, PAIRS)),
        ("uniform, hits", uniform_hits(2)),
        ("uniform, all", uniform(3)),
    ];
    print!("{:<24}", "ns per pair");
    for (name, _) in &sets {
        print!("{name:>16}");
    }
    println!();
    for finder in Finder::ALL {
        print!("{:<24}", finder.name());
        for (_, cases) in &sets {
            print!("{:>16.1}", nanoseconds_each(cases, finder));
        }
        println!();
    }
    for (name, cases) in &sets {
        let (each, share) = row_nanoseconds_per_pair(cases);
        println!("row of {LANES}, {name}: {each:.2} ns per pair, {:.1} % rejected", 100.0 * share);
    }
}
