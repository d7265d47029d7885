//! The hard families of paths near a round edge, judged with 106 bits: no contact is missed
//! or false beyond rounding errors of position.
//!
//! `CAROM_CASES=1000000 cargo test --release -p carom-roots --test ring_hard_families` runs more
//! cases.

use carom_peers::judge::Verdict;
use carom_peers::random::Random;
use carom_peers::ring_families::{RingCase, RingFamily};
use carom_peers::ring_judge::judge_ring;
use carom_roots::{Motion, first_ring_contact};

/// Missed or false contacts shallower than this, m, are ignored: a position of a metre is rounded
/// to 2e-16 m.
const DEPTH: f64 = 1e-15;

/// Largest and median gap at a returned time, m.
const GAP_ALWAYS: f64 = 1e-14;
const GAP_MEDIAN: f64 = 1e-15;

/// Overlaps at the start of less than this, m, are ignored.
const ROUNDINGS: f64 = 1e-16;

fn cases() -> usize {
    std::env::var("CAROM_CASES").map_or(3_000, |n| n.parse().expect("CAROM_CASES is a count"))
}

fn contact(case: &RingCase) -> Option<f64> {
    first_ring_contact(&case.motion, case.ring, case.distance, case.from, case.horizon)
}

fn overlaps_at_first(case: &RingCase) -> bool {
    let [x, y, z] = case.motion.at(case.from);
    let out = (x * x + y * y).sqrt() - case.ring;
    (out * out + z * z).sqrt() < case.distance - ROUNDINGS
}

#[test]
fn no_contact_is_missed_or_false_near_a_ring() {
    for (seed, family) in RingFamily::ALL.into_iter().enumerate() {
        let mut random = Random::new(300 + seed as u64);
        let (mut gaps, mut worst) = (Vec::new(), 0.0f64);
        for index in 0..cases() {
            let case = family.sample(&mut random);
            let answer = contact(&case);
            match judge_ring(&case, answer, DEPTH) {
                // Bodies that overlap at the start and turn back do not meet at a gap of zero.
                Verdict::Right { gap } if answer.is_some() && !overlaps_at_first(&case) => {
                    gaps.push(gap);
                    worst = worst.max(gap);
                }
                Verdict::Right { .. } => {}
                fault => panic!("{family:?} {index}: {answer:?} is {fault:?} for {case:?}"),
            }
        }
        assert!(gaps.len() > cases() / 50, "{family:?} hardly ever touches: {}", gaps.len());
        gaps.sort_by(f64::total_cmp);
        let median = gaps[gaps.len() / 2];
        println!(
            "{family:?}: {} contacts, gap median {median:.1e} m, worst {worst:.1e} m",
            gaps.len()
        );
        assert!(median <= GAP_MEDIAN && worst <= GAP_ALWAYS, "{family:?}: {median:e}, {worst:e}");
    }
}

#[test]
fn mirrors_and_units_that_are_powers_of_two_change_no_bit() {
    let mut random = Random::new(2007);
    for _ in 0..cases() {
        for family in RingFamily::ALL {
            let case = family.sample(&mut random);
            let t = contact(&case);
            let Motion { d, v, h } = case.motion;
            for [x, y, z] in [[-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [-1.0, -1.0, -1.0]] {
                let mirror = |w: [f64; 3]| [w[0] * x, w[1] * y, w[2] * z];
                let motion = Motion { d: mirror(d), v: mirror(v), h: mirror(h) };
                assert_eq!(t, contact(&RingCase { motion, ..case }), "{case:?}");
            }
            let (metre, second) = (1024.0, 1.0 / 64.0);
            let scaled = RingCase {
                motion: Motion {
                    d: d.map(|x| x * metre),
                    v: v.map(|x| x * (metre / second)),
                    h: h.map(|x| x * (metre / (second * second))),
                },
                ring: case.ring * metre,
                distance: case.distance * metre,
                from: case.from * second,
                horizon: case.horizon * second,
            };
            assert_eq!(t.map(|t| t * second), contact(&scaled), "{case:?}");
        }
    }
}
