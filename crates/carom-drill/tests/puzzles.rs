//! Puzzles depend on their theme and number alone, and their ways solve them.

use std::collections::BTreeSet;

use carom::Simulator;
use carom_drill::puzzle::{accepted, rating_of};
use carom_drill::{Played, Puzzle, Theme, judge};

#[test]
fn there_are_two_thousand_puzzles_and_each_theme_has_some() {
    let all: Vec<_> = accepted().collect();
    assert!(all.len() >= 2000, "{}", all.len());
    let ids: BTreeSet<String> = all.iter().map(|one| one.id()).collect();
    assert_eq!(ids.len(), all.len());
    for theme in Theme::ALL {
        assert!(all.iter().filter(|one| one.theme == theme).count() >= 100, "{theme:?}");
    }
}

#[test]
fn a_sample_of_the_list_is_made_again_with_its_rating() {
    let all: Vec<_> = accepted().collect();
    for one in all.iter().step_by(67) {
        let puzzle = Puzzle::read(&one.id()).unwrap();
        assert_eq!(
            (puzzle.id(), (puzzle.rating / 10.0).round() as u32 * 10),
            (one.id(), one.rating)
        );
        assert_eq!(Puzzle::read(&one.id()).unwrap().to_node(), puzzle.to_node());
    }
}

#[test]
fn the_ways_of_a_puzzle_solve_it_and_the_best_comes_first() {
    let mut simulator = Simulator::new();
    for theme in Theme::ALL {
        let one = accepted().find(|one| one.theme == theme).unwrap();
        let puzzle = Puzzle::read(&one.id()).unwrap();
        for way in &puzzle.ways {
            let played = Played::of(&mut simulator, &puzzle.shot, Some(&way.strike)).unwrap();
            let verdict = judge(&puzzle.shot, &played, &puzzle.goal, &[]).unwrap();
            assert_eq!(verdict.fault, None, "{}", puzzle.id());
            assert!(way.chances[2] <= puzzle.ways[0].chances[2]);
            assert!((0..5).all(|level| way.chances[level] <= puzzle.chances[level]));
        }
    }
}

#[test]
fn an_id_that_is_no_puzzle_is_refused() {
    for id in ["cut", "cut-", "moon-3", "cut--1", "cut-99999999999", ""] {
        assert!(Puzzle::read(id).is_err(), "{id}");
    }
}

#[test]
fn the_rating_is_that_of_a_level_whose_chance_is_one_half() {
    let chances = |rating: f64| {
        [1000.0, 1300.0, 1600.0, 1900.0, 2200.0]
            .map(|level: f64| 1.0 / (1.0 + carom::math::pow(10.0, (rating - level) / 400.0)))
    };
    for rating in [900.0, 1300.0, 1777.0, 2400.0] {
        assert!((rating_of(&chances(rating)) - rating).abs() < 0.01, "{rating}");
    }
    assert!(rating_of(&[1.0; 5]) < rating_of(&[0.9; 5]));
}
