//! The checker detects faults of the spin where a motion state ends: records of simulated shots are
//! falsified in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, MotionState, Shot};
use carom_check::CheckRecorder;

use crate::owned_event::{OwnedEvent, events};

/// A ball that slides, rolls and at last spins in place.
fn a_shot() -> Shot {
    let file = r#"{"format": "carom-shot/1", "table": "carom-10ft", "balls": [{"id": "a",
        "position": [0.7, 0.4], "velocity": [0.1, 1.0, 0], "angular_velocity": [5, -3, 90]}]}"#;
    Shot::from_json(file).unwrap_or_else(|e| panic!("{e}"))
}

fn faults(falsify: impl FnOnce(&mut Vec<OwnedEvent>)) -> Vec<String> {
    let shot = a_shot();
    let mut all = events(&shot);
    falsify(&mut all);
    let mut checker = CheckRecorder::new(&shot);
    all.iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(word: &str, falsify: impl FnOnce(&mut Vec<OwnedEvent>)) {
    let found = faults(falsify);
    assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
}

/// Index of the event in which `to` begins.
fn start_of(all: &[OwnedEvent], to: MotionState) -> usize {
    let begins = |e: &OwnedEvent| matches!(e.kind, EventKind::MotionTransition { to: next, .. } if next == to);
    all.iter().position(begins).unwrap_or_else(|| panic!("no {}", to.name()))
}

/// Changes the state after the event in which `to` begins.
fn at_start_of(
    to: MotionState,
    change: impl Fn(&mut BallState),
) -> impl FnOnce(&mut Vec<OwnedEvent>) {
    move |all| {
        let k = start_of(all, to);
        change(&mut all[k].after[0]);
    }
}

#[test]
fn accepts_an_unchanged_record() {
    assert_eq!(faults(|_| {}), Vec::<String>::new());
}

#[test]
fn detects_sidespin_that_jumps_where_rolling_begins() {
    let change = |s: &mut BallState| s.angular_velocity.z *= 1.0 + 1e-9;
    assert_detected("the spin of ball 0 jumps", at_start_of(MotionState::Rolling, change));
}

#[test]
fn detects_sidespin_that_jumps_where_rolling_ends() {
    let change = |s: &mut BallState| s.angular_velocity.z -= 1e-7;
    assert_detected("the spin of ball 0 jumps", at_start_of(MotionState::Spinning, change));
}

#[test]
fn detects_a_ball_that_rolls_with_slip() {
    let change = |s: &mut BallState| s.angular_velocity.x += 1e-7;
    assert_detected("rolls with a slip of", at_start_of(MotionState::Rolling, change));
}

#[test]
fn detects_a_spin_in_place_about_a_leaning_axis() {
    let change = |s: &mut BallState| s.angular_velocity += Vec3::new(1e-9, 0.0, 0.0);
    assert_detected("about a horizontal axis", at_start_of(MotionState::Spinning, change));
}

#[test]
fn detects_a_ball_at_rest_that_spins() {
    let change = |s: &mut BallState| s.angular_velocity.z = 1e-12;
    assert_detected("rests with a speed of", at_start_of(MotionState::Stationary, change));
}

#[test]
fn detects_a_motion_state_that_lasts_too_long() {
    for to in [MotionState::Rolling, MotionState::Spinning] {
        assert_detected("longer than friction lets it", |all| {
            let k = start_of(all, to);
            all.remove(k);
        });
    }
}

#[test]
fn detects_a_state_that_begins_too_early() {
    assert_detected("rolls with a slip of", |all| {
        // The slide is cut short: the ball rolls on with the states that it has by then.
        let k = start_of(all, MotionState::Rolling);
        let begun = all[k].before[0];
        let early =
            BallState { velocity: begun.velocity * 1.001, motion: MotionState::Rolling, ..begun };
        all[k].after[0] = early;
    });
}

#[test]
fn detects_a_ball_that_slides_again_without_an_impact() {
    assert_detected("goes from spinning back to sliding", |all| {
        let k = start_of(all, MotionState::Stationary);
        let (from, to) = (MotionState::Spinning, MotionState::Sliding);
        all[k].kind = EventKind::MotionTransition { from, to };
        all[k].after[0].motion = to;
        all[k].after[0].angular_velocity.x = 1.0;
    });
}
