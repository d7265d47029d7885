//! Time per search for a contact of a flying ball, ns:
//! `cargo bench -p carom-peers --bench flight_contact`.
//!
//! Times are noisy, so each figure is the smallest of several passes over the same cases.

use std::hint::black_box;
use std::time::Instant;

use carom_peers::families::Case;
use carom_peers::flight_families::FlightFamily;
use carom_peers::random::{Random, RandomMotion};
use carom_peers::ring_families::{RingCase, RingFamily};
use carom_roots::{Motion, first_contact, first_ring_contact};

/// Cases per set. A set fits into a second-level cache.
const CASES: usize = 4096;

/// Number of passes over a set; the fastest counts.
const PASSES: usize = 15;

fn nanoseconds_each<C>(cases: &[C], search: impl Fn(&C) -> Option<f64>) -> f64 {
    let pass = || {
        let start = Instant::now();
        for case in cases {
            black_box(search(black_box(case)));
        }
        start.elapsed().as_nanos() as f64 / cases.len() as f64
    };
    (0..PASSES).map(|_| pass()).fold(f64::INFINITY, f64::min)
}

/// Prints one line: the time per case with a contact, and per case without.
fn report<C>(name: &str, mut draw: impl FnMut() -> C, search: impl Fn(&C) -> Option<f64>) {
    let (mut hits, mut misses) = (Vec::new(), Vec::new());
    for _ in 0..40 * CASES {
        let case = draw();
        let set = if search(&case).is_some() { &mut hits } else { &mut misses };
        if set.len() < CASES {
            set.push(case);
        }
    }
    print!("{name:<28}");
    for set in [&hits, &misses] {
        if set.len() < CASES / 8 {
            print!("{:>10}", "-");
        } else {
            print!("{:>10.1}", nanoseconds_each(set, &search));
        }
    }
    println!();
}

fn ring_contact(case: &RingCase) -> Option<f64> {
    first_ring_contact(&case.motion, case.ring, case.distance, case.from, case.horizon)
}

/// A hop at a random place on a 9-ft table, and the lip of a corner pocket.
fn hop_on_a_table(random: &mut Random) -> RingCase {
    let d = [random.between(-2.5, 0.0), random.between(0.0, 1.2), 0.0286];
    let [x, y] = random.direction();
    let (speed, lift) = (random.between(0.3, 6.0), random.between(0.05, 1.0));
    let motion = Motion { d, v: [speed * x, speed * y, lift], h: [0.0, 0.0, -4.905] };
    RingCase { motion, ring: 0.06, distance: 0.0286, from: 0.0, horizon: 2.0 * lift / 9.81 }
}

fn main() {
    println!("{:<28}{:>10}{:>10}", "ns per search", "hit", "miss");
    let mut random = Random::new(12);
    report("ring, hop on a table", || hop_on_a_table(&mut random), ring_contact);
    for family in RingFamily::ALL {
        report(&format!("ring, {family:?}"), || family.sample(&mut random), ring_contact);
    }
    for family in FlightFamily::ALL {
        let search = |c: &Case<3>| first_contact(&c.motion, c.distance, c.horizon);
        report(&format!("pair, {family:?}"), || family.sample::<3>(&mut random), search);
    }
    for family in FlightFamily::ALL {
        let search = |c: &Case<2>| first_contact(&c.motion, c.distance, c.horizon);
        report(&format!("straight edge, {family:?}"), || family.sample::<2>(&mut random), search);
    }
}
