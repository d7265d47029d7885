//! Traces as an outside reader sees them: states at many times, by `Trace::at`.

use carom::Shot;
use carom_check::check_samples;
use carom_check::random_shots::{ShotFamily, shot_file};
use rayon::prelude::*;

/// Times at which each trace is looked at.
const SAMPLES: u32 = 200;

/// Shots of each family.
const SHOTS: u64 = if cfg!(debug_assertions) { 20 } else { 200 };

#[test]
fn at_no_sampled_time_is_a_ball_in_anything() {
    for scene in ShotFamily::ALL {
        (0..SHOTS).into_par_iter().for_each(|seed| {
            let file = shot_file(scene, seed);
            let Ok(shot) = Shot::from_json(&file) else { return };
            let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}\n{file}"));
            let faults = check_samples(&shot, &trace, SAMPLES);
            assert!(faults.is_empty(), "{scene:?} {seed}: {faults:#?}\n{file}");
        });
    }
}
