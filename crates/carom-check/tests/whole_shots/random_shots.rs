//! The checker finds no fault in random shots of each family. `make stress` runs the same with
//! millions.

use carom::Shot;
use carom_check::random_shots::{ShotFamily, shot_file};
use carom_check::{CheckRecorder, Tally};
use rayon::prelude::*;

/// Shots per family: 110 000 in all in an optimised build. A debug build is several times slower
/// and has the same bits, so it checks only some of them.
const SHOTS: u64 = if cfg!(debug_assertions) { 500 } else { 8_500 };

/// Largest share of drawn layouts of [`ShotFamily::Jaws`] that may be refused, %: 21 % have a ball
/// in a jaw or over a hole. One in twelve layouts of [`ShotFamily::Laws`] is of that family. No
/// layout of the other families is refused.
const REFUSED_IN_JAWS: u64 = 22;
const REFUSED_OF_LAWS: u64 = 4;

/// Largest share of shots with a collision of several balls that leaves touching balls approaching,
/// %: in breaks and among falling balls up to 2 % do (docs/guarantees.md).
const UNFINISHED: u64 = 4;

fn check(family: ShotFamily) {
    let tally = (0..SHOTS)
        .into_par_iter()
        .map(|seed| {
            let file = shot_file(family, seed);
            match Shot::from_json(&file) {
                Ok(shot) => Tally::of(seed, &CheckRecorder::run(&shot), &file),
                Err(_) => Tally::refused(),
            }
        })
        .reduce(Tally::default, Tally::with);
    println!("{family:?}: {tally}");
    let refused = match family {
        ShotFamily::Jaws => SHOTS * REFUSED_IN_JAWS / 100,
        ShotFamily::Laws => SHOTS * REFUSED_OF_LAWS / 100,
        _ => 0,
    };
    assert!(tally.refused <= refused, "{tally}");
    assert_eq!(tally.shots + tally.refused, SHOTS);
    assert!(tally.unfinished <= SHOTS * UNFINISHED / 100, "{tally}");
    assert_eq!(tally.faulty, 0, "{:#?}", tally.examples);
}

#[test]
fn pot_shots_are_physical() {
    check(ShotFamily::Pot);
}

#[test]
fn eight_ball_breaks_are_physical() {
    check(ShotFamily::EightBallBreak);
}

#[test]
fn nine_ball_breaks_are_physical() {
    check(ShotFamily::NineBallBreak);
}

#[test]
fn shots_among_frozen_balls_are_physical() {
    check(ShotFamily::Frozen);
}

#[test]
fn shots_in_which_everything_moves_are_physical() {
    check(ShotFamily::Wild);
}

#[test]
fn rows_of_balls_are_physical() {
    check(ShotFamily::Row);
}

#[test]
fn shots_with_a_raised_cue_are_physical() {
    check(ShotFamily::Elevated);
}

#[test]
fn flights_over_cloth_and_rails_are_physical() {
    check(ShotFamily::Flying);
}

#[test]
fn balls_that_fall_on_others_are_physical() {
    check(ShotFamily::Dropped);
}

#[test]
fn jump_shots_are_physical() {
    check(ShotFamily::Jump);
}

#[test]
fn shots_into_the_jaws_of_pockets_are_physical() {
    check(ShotFamily::Jaws);
}

#[test]
fn balls_in_the_mouths_of_pockets_are_physical() {
    check(ShotFamily::Mouths);
}

#[test]
fn shots_with_any_law_are_physical() {
    check(ShotFamily::Laws);
}
