//! Every random shot ends, and nothing is ever where it cannot be. `make stress` runs the same
//! with millions.

use carom::Shot;
use carom_check::scenes::{Scene, shot_file};
use carom_check::{Checker, Tally};
use rayon::prelude::*;

/// Shots per family: 100 000 in all in an optimised build, a share of that in a debug build, which
/// is some ten times slower and checks the same bits.
const SHOTS: u64 = if cfg!(debug_assertions) { 1_000 } else { 17_000 };

fn judge(scene: Scene) {
    let tally = (0..SHOTS)
        .into_par_iter()
        .map(|seed| {
            let file = shot_file(scene, seed);
            match Shot::from_json(&file) {
                Ok(shot) => Tally::of(seed, &Checker::run(&shot), &file),
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
    judge(Scene::Pot);
}

#[test]
fn eight_ball_breaks_are_physical() {
    judge(Scene::EightBallBreak);
}

#[test]
fn nine_ball_breaks_are_physical() {
    judge(Scene::NineBallBreak);
}

#[test]
fn shots_among_frozen_balls_are_physical() {
    judge(Scene::Frozen);
}

#[test]
fn shots_in_which_everything_moves_are_physical() {
    judge(Scene::Wild);
}

#[test]
fn rows_of_balls_are_physical() {
    judge(Scene::Row);
}
