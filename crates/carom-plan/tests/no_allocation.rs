//! A sampler allocates nothing once its memory is large enough. In a binary of its own, because the
//! counter replaces the allocator of the whole program.

#[path = "sampler/support.rs"]
mod support;

use carom::Noise;
use carom::noise::{Errors, Perception};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Frame, Game};

use support::positions;

/// Shots of each game.
const SHOTS: usize = 40;

/// Allocations of one variant of every play, ruled on, apart from those that rack balls again.
fn allocations(
    sampler: &mut Sampler,
    successor: &mut Frame,
    prepared: &[(Prepared<'_>, carom_rules::Play)],
    errors: &Errors,
) -> u64 {
    let mut count = 0;
    for (k, (prepared, play)) in (0..).zip(prepared) {
        let simulated = allocation_counter::measure(|| {
            sampler.simulate_variant(prepared, &play.strike, errors, k).expect("by the law");
        });
        let mut racked = false;
        let ruled = allocation_counter::measure(|| {
            let ruling = sampler.rule(prepared, play.call, successor).expect("it is allowed");
            racked = ruling.racked;
        });
        count += simulated.count_total + if racked { 0 } else { ruled.count_total };
    }
    count
}

#[test]
fn simulating_and_ruling_allocate_nothing_in_any_game() {
    let clinging = Noise { cling_probability: 0.1, ..Noise::olympiad(1.0) };
    let of_the_strike = Errors { noise: Noise::olympiad(1.0), seed: 1, ..Errors::default() };
    let all = Errors { noise: clinging, perception: Perception::round(0.002), seed: 2 };
    for game in Game::ALL {
        let positions = positions(game, 8, SHOTS);
        let prepared: Vec<_> = positions
            .iter()
            .map(|(frame, play)| {
                (Prepared::new(frame, play.cue_ball).expect("a place with room"), *play)
            })
            .collect();
        for errors in [&of_the_strike, &all] {
            let (mut sampler, mut successor) = (Sampler::new(), positions[0].0.clone());
            let first = allocations(&mut sampler, &mut successor, &prepared, errors);
            assert!(first > 0, "the counter counts");
            // Shots of other numbers of balls need other variants, so each shot is repeated at once.
            let again: u64 = prepared
                .iter()
                .map(|one| {
                    let one = std::slice::from_ref(one);
                    allocations(&mut sampler, &mut successor, one, errors);
                    allocations(&mut sampler, &mut successor, one, errors)
                })
                .sum();
            assert_eq!(again, 0, "{}", game.name());
        }
    }
}
