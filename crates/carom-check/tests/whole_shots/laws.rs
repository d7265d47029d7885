//! Conservation laws in random shots with every model on every ground. The tests in
//! `detected_faults` show that the checker detects violations.

use carom::batch::simulate_batch;
use carom::math::Vec3;
use carom::runner::Runner;
use carom::shot::PlacedBall;
use carom::{BallState, Shot};
use carom_check::CheckRecorder;
use proptest::prelude::*;

use crate::owned_event::events;
use crate::plan::any_plan;

/// Relative rounding error of a shot's total energy and of a sum of ten momenta.
const ROUNDING: f64 = 1e-12;

proptest! {
    #[test]
    fn every_shot_ends_and_the_checker_finds_no_fault(plan in any_plan(10)) {
        let shot = plan.shot();
        let checker = CheckRecorder::run(&shot);
        prop_assert!(checker.faults.is_empty(), "{:#?}\n{}", checker.faults, shot.to_json());
    }

    /// The total energy of all balls never rises, and at the end none is left.
    #[test]
    fn the_energy_of_all_balls_only_falls(plan in any_plan(8)) {
        let shot = plan.shot();
        let mut states: Vec<_> = events_start(&shot);
        let energy = |i: usize, s: &BallState| -> f64 {
            let PlacedBall { ball, .. } = &shot.balls()[i];
            let raised = s.position.z - ball.radius;
            ball.kinetic_energy(s) + ball.mass * shot.physics().gravity * raised
        };
        let mut energies: Vec<f64> = states.iter().enumerate().map(|(i, s)| energy(i, s)).collect();
        let first: f64 = energies.iter().sum();
        let mut last = first;
        for event in events(&shot) {
            for (&ball, after) in event.balls.iter().zip(&event.after) {
                let i = usize::from(ball);
                states[i] = *after;
                // A ball that leaves play takes its energy with it, unless that is negative.
                let in_play = after.motion.in_play();
                energies[i] = if in_play { energy(i, after) } else { energies[i].min(0.0) };
            }
            // The states of the other balls are older, so their energy is at most overestimated.
            let now: f64 = energies.iter().sum();
            prop_assert!(now <= last + ROUNDING * first + carom_check::PUSH_ENERGY, "{now} after {last}");
            last = now;
        }
        let at_rest = states.iter().all(|s| !s.motion.in_play() || s.velocity == Vec3::ZERO);
        prop_assert!(at_rest);
        prop_assert!(last <= ROUNDING * first, "{last} J of {first} J are left");
    }

    #[test]
    fn a_shot_simulated_again_has_the_same_bits(plan in any_plan(8)) {
        let shot = plan.shot();
        let trace = shot.simulate().expect("it ends");
        let again = Shot::from_json(&shot.to_json()).expect("a shot file").simulate().expect("it ends");
        prop_assert_eq!(trace.hash(), again.hash());
        prop_assert_eq!(trace, again);
    }

    #[test]
    fn a_batch_has_the_results_of_its_single_shots(plans in prop::collection::vec(any_plan(6), 1..6)) {
        let shots: Vec<Shot> = plans.iter().map(|p| p.shot()).collect();
        for threads in [1, 2] {
            let batch = simulate_batch(&shots, &Runner::new(Some(threads)).expect("threads"));
            prop_assert!(batch.errors.is_empty());
            for (k, shot) in shots.iter().enumerate() {
                let trace = shot.simulate().expect("it ends");
                prop_assert_eq!(batch.events[k] as usize, trace.events().len());
                for (i, state) in trace.last().iter().enumerate() {
                    let Vec3 { x, y, z } = state.position;
                    prop_assert_eq!(batch.final_position[k * batch.balls + i], [x, y, z]);
                }
            }
        }
    }
}

fn events_start(shot: &Shot) -> Vec<BallState> {
    shot.balls().iter().map(|b| shot.table().to_engine_coordinates(&b.state)).collect()
}
