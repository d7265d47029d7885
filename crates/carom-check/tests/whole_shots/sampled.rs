//! Traces at sampled times, by `Trace::at`.

use carom::Shot;
use carom_check::check_samples;
use carom_check::random_shots::{ShotFamily, shot_file};
use rayon::prelude::*;

/// Number of times at which each trace is checked.
const SAMPLES: u32 = 200;

/// Shots of each family, fewer in a debug build.
const SHOTS: u64 = if cfg!(debug_assertions) { 20 } else { 200 };

#[test]
fn no_ball_overlaps_anything_at_a_sampled_time() {
    for family in ShotFamily::ALL {
        (0..SHOTS).into_par_iter().for_each(|seed| {
            let file = shot_file(family, seed);
            let Ok(shot) = Shot::from_json(&file) else { return };
            let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}\n{file}"));
            let faults = check_samples(&shot, &trace, SAMPLES);
            assert!(faults.is_empty(), "{family:?} {seed}: {faults:#?}\n{file}");
        });
    }
}
