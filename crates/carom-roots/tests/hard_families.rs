//! The nine hard families, and those of flight, judged with 106 bits: no contact is missed
//! or false beyond rounding errors of position.
//!
//! `CAROM_CASES=1000000 cargo test --release -p carom-roots --test hard_families` runs more cases.

use carom_peers::families::{Case, Family, cluster_pair, uniform_pair};
use carom_peers::flight_families::FlightFamily;
use carom_peers::harvest::{break_pairs, pot_pairs};
use carom_peers::judge::{Verdict, judge};
use carom_peers::random::Random;
use carom_roots::{Motion, cannot_touch, first_contact};

/// Missed or false contacts shallower than this, m, are ignored: a position of a metre is rounded
/// to 2e-16 m.
const DEPTH: f64 = 1e-15;

/// Largest and median gap |x| − D at a returned time, m.
const GAP_ALWAYS: f64 = 1e-14;
const GAP_MEDIAN: f64 = 1e-15;

/// Overlaps at the start of less than this fraction of the contact distance are ignored.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

fn cases() -> usize {
    std::env::var("CAROM_CASES").map_or(20_000, |n| n.parse().expect("CAROM_CASES is a count"))
}

fn assert_all_right<const N: usize>(
    name: &str,
    seed: u64,
    sample: impl Fn(&mut Random) -> Case<N>,
) {
    let mut random = Random::new(seed);
    let mut gaps = Vec::new();
    let mut worst = 0.0f64;
    for index in 0..cases() {
        let case = sample(&mut random);
        let Case { motion, distance, horizon, .. } = case;
        let answer = first_contact(&motion, distance, horizon);
        match judge(&case, answer, DEPTH) {
            Verdict::Right { gap } => {
                // Bodies that overlap at the start and turn back do not meet at a gap of zero.
                let squared = motion.d.iter().map(|x| x * x).sum::<f64>();
                let apart = squared >= distance * distance * (1.0 - ROUNDINGS);
                if answer.is_some() && apart {
                    gaps.push(gap);
                    worst = worst.max(gap);
                }
            }
            fault => panic!("{name} {index}: {answer:?} is {fault:?} for {case:?}"),
        }
    }
    assert!(gaps.len() > cases() / 250, "{name} hardly ever touches: {}", gaps.len());
    gaps.sort_by(f64::total_cmp);
    let median = gaps[gaps.len() / 2];
    println!("{name}: {} contacts, gap median {median:.1e} m, worst {worst:.1e} m", gaps.len());
    assert!(median <= GAP_MEDIAN && worst <= GAP_ALWAYS, "{name}: {median:e}, {worst:e}");
}

#[test]
fn no_contact_is_missed_or_false_in_the_nine_hard_families() {
    for (seed, family) in Family::ALL.into_iter().enumerate() {
        assert_all_right(&format!("N{} {family:?}", seed + 1), seed as u64, |r| family.sample(r));
    }
}

#[test]
fn no_contact_is_missed_or_false_between_flying_balls() {
    for (seed, family) in FlightFamily::ALL.into_iter().enumerate() {
        assert_all_right(&format!("in the air: {family:?}"), 200 + seed as u64, |r| {
            family.sample::<3>(r)
        });
    }
}

#[test]
fn no_contact_is_missed_or_false_between_a_flying_ball_and_a_straight_edge() {
    for (seed, family) in FlightFamily::ALL.into_iter().enumerate() {
        assert_all_right(&format!("edge {family:?}"), 220 + seed as u64, |r| family.sample::<2>(r));
    }
}

#[test]
fn no_contact_is_missed_or_false_among_random_pairs() {
    assert_all_right("uniform pairs", 100, uniform_pair);
    assert_all_right("pairs of a break", 101, cluster_pair);
}

#[test]
fn no_contact_is_missed_or_false_among_pairs_of_shots() {
    for (name, pairs) in [("breaks", break_pairs(5, cases())), ("pot shots", pot_pairs(5, cases()))]
    {
        let next = std::cell::Cell::new(0);
        assert_all_right(&format!("pairs of {name}"), 0, |_| {
            next.set(next.get() + 1);
            pairs[next.get() - 1]
        });
    }
}

#[test]
fn pairs_that_the_cheap_proofs_reject_have_no_contact() {
    let mut rejected = 0;
    let mut total = 0;
    let mut check = |case: Case| {
        let Motion { d, v, h } = case.motion;
        total += 1;
        if cannot_touch(d[0], d[1], v[0], v[1], h[0], h[1], case.distance, case.horizon) {
            rejected += 1;
            let verdict = judge(&case, None, DEPTH);
            assert!(matches!(verdict, Verdict::Right { .. }), "{verdict:?} for {case:?}");
        }
    };
    let mut random = Random::new(7);
    for _ in 0..cases() {
        check(uniform_pair(&mut random));
        check(cluster_pair(&mut random));
        for family in Family::ALL {
            check(family.sample(&mut random));
        }
    }
    assert!(rejected * 5 > total, "the proofs reject {rejected} of {total}");
}
