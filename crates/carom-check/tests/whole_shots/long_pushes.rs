//! Shots that once never ended.

use carom::Shot;
use carom::format::Node;
use carom_check::CheckRecorder;

/// Largest allowed number of events; each shot once reached the limit of 100 000.
const MOST_EVENTS: u64 = 5_000;

/// The same for the cradle, in which the cue ball pushes five balls for 0.2 s.
const MOST_EVENTS_OF_THE_CRADLE: u64 = 40_000;

/// Checks a shot and returns its number of events.
fn checked(name: &str) -> u64 {
    let all = Node::from_json(include_str!("../data/long_pushes.json")).expect("JSON");
    let file = all.get(name).unwrap_or_else(|| panic!("no shot {name}"));
    let shot = Shot::from_node(file).unwrap_or_else(|e| panic!("{name}: {e}"));
    let checker = CheckRecorder::run(&shot);
    assert!(checker.faults.is_empty(), "{name}: {:#?}", checker.faults);
    checker.events
}

fn assert_ends_soon(name: &str) {
    let events = checked(name);
    assert!(events < MOST_EVENTS, "{name}: {events} events");
}

/// Seen: two to five touching balls, one of them struck from above or along the row at 1 mm/s to 12
/// m/s, reached 100 000 events. Expected: an end after some dozens. Cause: the cloth presses a
/// spinning ball against its neighbour and brakes each recoil, so the bounces shrink for ever,
/// unless balls in persistent contact separate with a minimum speed.
#[test]
fn touching_balls_pressed_by_a_spinning_ball_come_to_rest() {
    for k in 0..10 {
        assert_ends_soon(&format!("found-by-fuzzing-{k}"));
    }
}

/// Seen: a row of touching balls without losses in collisions, struck at 1 mm/s, never ended.
/// Expected: an end. Cause: only the cloth takes energy, so the minimum separation speed of
/// persistent contacts must add less energy than the cloth takes.
#[test]
fn a_slow_push_through_a_chain_without_losses_ends() {
    assert_ends_soon("ideal-chain");
}

/// Seen: the same with the usual losses never ended. Expected: an end. Cause: below 1 mm/s the
/// restitution is 1 (otherwise bounces would shrink for ever), so a slow row has no losses in
/// collisions.
#[test]
fn a_slow_push_through_a_chain_ends() {
    assert_ends_soon("slow-chain");
}

/// Seen: Newton's cradle hit by a rolling ball, without friction between the balls, never ended.
/// Expected: the first impulse passes through the row at once; then the ball, which still has
/// forward spin, pushes four balls until the spin is used up. It takes many events: without
/// friction the separation speed is only 0.1 mm/s, so each contact lasts 0.1 ms.
#[test]
fn a_rolling_ball_that_pushes_a_cradle_comes_to_rest() {
    let events = checked("rolling-cradle");
    assert!(events < MOST_EVENTS_OF_THE_CRADLE, "{events} events");
}

/// Seen: two balls of a break that rolled at 1 nm/s and separated collided 99 000 times at one
/// instant. Expected: they collide once the cloth has turned them back. Cause: see the test of the
/// same motion in carom-roots/tests/contact_rule.rs.
#[test]
fn balls_that_separate_by_less_than_rounding_do_not_collide_for_ever() {
    assert_ends_soon("parting-below-a-rounding");
}
