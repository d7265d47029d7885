//! Every random shot ends, and nothing is ever where it cannot be. `make stress` runs the same
//! with millions.

use carom::Shot;
use carom_check::random_shots::{ShotFamily, shot_file};
use carom_check::{CheckRecorder, Tally};
use rayon::prelude::*;

/// Shots per family: 100 000 in all in an optimised build, a share of that in a debug build, which
/// is some ten times slower and checks the same bits.
const SHOTS: u64 = if cfg!(debug_assertions) { 500 } else { 8_500 };

fn judge(scene: ShotFamily) {
    let tally = (0..SHOTS)
        .into_par_iter()
        .map(|seed| {
            let file = shot_file(scene, seed);
            match Shot::from_json(&file) {
                Ok(shot) => Tally::of(seed, &CheckRecorder::run(&shot), &file),
                Err(_) => Tally::refused(),
            }
        })
        .reduce(Tally::default, Tally::with);
    println!("{scene:?}: {tally}");
    assert!(tally.shots > SHOTS / 2, "{tally}");
    assert_eq!(tally.faulty, 0, "{:#?}", tally.examples);
}

#[test]
fn pot_shots_are_physical() {
    judge(ShotFamily::Pot);
}

#[test]
fn eight_ball_breaks_are_physical() {
    judge(ShotFamily::EightBallBreak);
}

#[test]
fn nine_ball_breaks_are_physical() {
    judge(ShotFamily::NineBallBreak);
}

#[test]
fn shots_among_frozen_balls_are_physical() {
    judge(ShotFamily::Frozen);
}

#[test]
fn shots_in_which_everything_moves_are_physical() {
    judge(ShotFamily::Wild);
}

#[test]
fn rows_of_balls_are_physical() {
    judge(ShotFamily::Row);
}

#[test]
fn shots_with_a_raised_cue_are_physical() {
    judge(ShotFamily::Elevated);
}

#[test]
fn flights_over_cloth_and_rails_are_physical() {
    judge(ShotFamily::Flying);
}

#[test]
fn balls_that_fall_on_others_are_physical() {
    judge(ShotFamily::Dropped);
}

#[test]
fn jump_shots_are_physical() {
    judge(ShotFamily::Jump);
}

#[test]
fn shots_into_the_jaws_of_pockets_are_physical() {
    judge(ShotFamily::Jaws);
}

#[test]
fn balls_in_the_mouths_of_pockets_are_physical() {
    judge(ShotFamily::Mouths);
}
