//! Counts missed and false contacts of each finder in the hard families:
//! `cargo run --release -p carom-peers --example accuracy -- [CASES]`.
//!
//! CASES is the number of cases per family (default 100 000).

use carom_peers::families::{Case, Family, cluster_pair, uniform_pair};
use carom_peers::finder::Finder;
use carom_peers::judge::{Verdict, judge};
use carom_peers::random::Random;

/// Faults smaller than this have no meaning on a table, m.
const DEPTH: f64 = 1e-15;

#[derive(Default)]
struct Tally {
    contacts: usize,
    missed: usize,
    deepest: f64,
    false_contacts: usize,
    farthest: f64,
    widest_gap: f64,
    out_of_range: usize,
}

impl Tally {
    fn add(&mut self, case: &Case, answer: Option<f64>) {
        self.contacts += usize::from(answer.is_some());
        match judge(case, answer, DEPTH) {
            Verdict::Right { gap } => self.widest_gap = self.widest_gap.max(gap),
            Verdict::Missed { depth } => {
                self.missed += 1;
                self.deepest = self.deepest.max(depth / case.metre);
            }
            Verdict::FalseContact { clearance } => {
                self.false_contacts += 1;
                self.farthest = self.farthest.max(clearance / case.metre);
            }
            Verdict::OutOfRange => self.out_of_range += 1,
        }
    }
}

fn report(name: &str, seed: u64, count: usize, sample: &dyn Fn(&mut Random) -> Case) {
    for finder in Finder::ALL {
        let mut random = Random::new(seed);
        let mut tally = Tally::default();
        for _ in 0..count {
            let case = sample(&mut random);
            tally.add(&case, finder.first_contact(&case.motion, case.distance, case.horizon));
        }
        let Tally { contacts, missed, deepest, false_contacts, farthest, widest_gap, out_of_range } =
            tally;
        println!(
            "{name:<22} {:<22} {contacts:>8} contacts; missed {missed:>7} (<= {deepest:.1e} m); \
             false {false_contacts:>7} (<= {farthest:.1e} m); out of range {out_of_range}; \
             gap <= {widest_gap:.1e} m",
            finder.name(),
        );
    }
}

fn main() {
    let argument = std::env::args().nth(1);
    let count = argument.map_or(100_000, |n| n.parse().expect("the argument is a count"));
    for (seed, family) in Family::ALL.into_iter().enumerate() {
        let name = format!("N{} {family:?}", seed + 1);
        report(&name, seed as u64, count, &|random| family.sample(random));
    }
    report("uniform pairs", 100, count, &uniform_pair);
    report("pairs of a break", 101, count, &cluster_pair);
}
