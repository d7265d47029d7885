//! Pairs of balls from real shots: those that the engine's cheap proofs leave to the finder.

use std::cell::RefCell;

use carom::Shot;
use carom::event::NullRecorder;
use carom::limits::SMALL_CAPACITY;
use carom::resolve::cue_ball::Strike;
use carom::simulate::Simulation;
use carom::simulate::peer::PeerFinder;
use carom_roots::Motion;

use crate::families::{BALL_DIAMETER, Case};
use crate::random::Random;

thread_local! {
    static HARVEST: RefCell<Vec<Case>> = const { RefCell::new(Vec::new()) };
}

/// The engine's finder. It stores the input of every call.
fn harvesting_finder(motion: &Motion<2>, distance: f64, horizon: f64) -> Option<f64> {
    let case = Case { motion: *motion, distance, horizon, metre: 1.0 };
    HARVEST.with_borrow_mut(|harvest| harvest.push(case));
    carom_roots::first_contact(motion, distance, horizon)
}

/// `count` pairs from eight-ball breaks.
pub fn break_pairs(seed: u64, count: usize) -> Vec<Case> {
    let rack = include_str!("../../../shots/eight_ball_break.json");
    let shot = Shot::from_json(rack).expect("a shot of the project");
    let mut random = Random::new(seed);
    harvest(count, || {
        let strike = Strike {
            speed: random.between(6.0, 10.0),
            azimuth: core::f64::consts::FRAC_PI_2 + random.between(-0.01, 0.01),
            elevation: 0.0,
            side: random.between(-0.1, 0.1),
            height: random.between(-0.2, 0.3),
        };
        (shot.clone(), strike)
    })
}

/// `count` pairs from shots at random layouts of ten balls on a 9-ft table.
pub fn pot_pairs(seed: u64, count: usize) -> Vec<Case> {
    let mut random = Random::new(seed);
    harvest(count, || {
        let strike = Strike {
            speed: random.between(0.7, 4.0),
            azimuth: random.between(-3.1, 3.1),
            elevation: 0.0,
            side: random.between(-0.3, 0.3),
            height: random.between(-0.3, 0.3),
        };
        (layout(&mut random, 10), strike)
    })
}

/// Simulates the shots of `next` until the finder was called `count` times.
fn harvest(count: usize, mut next: impl FnMut() -> (Shot, Strike)) -> Vec<Case> {
    HARVEST.with_borrow_mut(Vec::clear);
    let mut simulation = Simulation::<SMALL_CAPACITY>::new();
    let finder = PeerFinder { first_contact: harvesting_finder, has_proofs: true };
    finder.run(|| {
        while HARVEST.with_borrow(Vec::len) < count {
            let (shot, strike) = next();
            // Shots that are refused or stopped count too.
            let _ = simulation.play_strike(&shot, Some((0, strike)), &mut NullRecorder);
        }
    });
    let mut pairs = HARVEST.with_borrow_mut(std::mem::take);
    pairs.truncate(count);
    pairs
}

/// Balls at random places on a 9-ft table that do not touch; the first is the cue ball.
fn layout(random: &mut Random, balls: usize) -> Shot {
    Shot::from_json(&shot_file(&places(random, balls))).expect("a layout without overlaps")
}

/// Random places (m) of balls on a 9-ft table that do not touch.
pub(crate) fn places(random: &mut Random, balls: usize) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> = Vec::new();
    while places.len() < balls {
        let place = [random.between(0.04, 1.23), random.between(0.04, 2.5)];
        let apart = |other: &[f64; 2]| {
            let (x, y) = (other[0] - place[0], other[1] - place[1]);
            x * x + y * y > 1.1 * BALL_DIAMETER * BALL_DIAMETER
        };
        if places.iter().all(apart) {
            places.push(place);
        }
    }
    places
}

/// Limit of events of a shot; ordinary ones have fewer than 300.
pub(crate) const MAX_EVENTS: u32 = 5000;

/// Balls at rest on a 9-ft table; the first is the cue ball.
pub(crate) fn shot_file(places: &[[f64; 2]]) -> String {
    let balls: Vec<String> = places
        .iter()
        .enumerate()
        .map(|(i, [x, y])| {
            let id = if i == 0 { "cue".to_owned() } else { i.to_string() };
            format!(r#"{{"id": "{id}", "position": [{x}, {y}]}}"#)
        })
        .collect();
    format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "max_events": {MAX_EVENTS},
            "balls": [{}]}}"#,
        balls.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::{break_pairs, pot_pairs};

    #[test]
    fn most_pairs_that_reach_the_finder_are_contacts() {
        for pairs in [break_pairs(1, 2000), pot_pairs(1, 2000)] {
            let contacts = pairs
                .iter()
                .filter(|c| carom_roots::first_contact(&c.motion, c.distance, c.horizon).is_some())
                .count();
            assert!(pairs.len() == 2000 && contacts > 1200, "{contacts} of {}", pairs.len());
        }
    }
}
