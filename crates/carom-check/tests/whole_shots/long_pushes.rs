//! Shots that once went on for ever.

use carom::Shot;
use carom::format::Node;
use carom_check::CheckRecorder;

/// Most events of such a shot; each once reached the cap of 100 000.
const MOST_EVENTS: u64 = 5_000;

/// The same for the cradle: its cue ball pushes five balls along for 0.2 s.
const MOST_EVENTS_OF_THE_CRADLE: u64 = 40_000;

fn judged(name: &str) -> u64 {
    let all = Node::from_json(include_str!("../data/long_pushes.json")).expect("JSON");
    let file = all.get(name).unwrap_or_else(|| panic!("no shot {name}"));
    let shot = Shot::from_node(&file).unwrap_or_else(|e| panic!("{name}: {e}"));
    let checker = CheckRecorder::run(&shot);
    assert!(checker.faults.is_empty(), "{name}: {:#?}", checker.faults);
    checker.events
}

fn assert_ends_soon(name: &str) {
    let events = judged(name);
    assert!(events < MOST_EVENTS, "{name}: {events} events");
}

/// Seen: two to five touching balls, one of them struck from above or along the row at a
/// millimetre a second to 12 m/s, reached 100 000 events. Right: an end after some dozens. Why: the
/// cloth presses a spinning ball against the one that it touches, each recoil is braked, and bounces
/// shrink for ever, unless contacts under a push part with a least speed.
#[test]
fn touching_balls_that_a_spinning_one_presses_come_to_an_end() {
    for k in 0..10 {
        assert_ends_soon(&format!("found-by-fuzzing-{k}"));
    }
}

/// Seen: a row of touching balls without losses in their collisions, struck at 1 mm/s, never
/// ended. Right: it does. Why: no restitution takes energy out, so that only the cloth can; the
/// least speed of a push must never lend more than the cloth takes.
#[test]
fn a_slow_push_through_a_chain_without_losses_ends() {
    assert_ends_soon("ideal-chain");
}

/// Seen: the same with the usual losses. Right: it ends. Why: below 1 mm/s restitution is 1 (or
/// bounces would shrink for ever), so that a slow chain is one without losses.
#[test]
fn a_slow_push_through_a_chain_ends() {
    assert_ends_soon("slow-chain");
}

/// Seen: Newton's cradle hit by a rolling ball, without friction between the balls, never ended.
/// Right: the first blow goes through the row at once, and then the ball, which still rolls
/// forward, pushes four balls along until it has no spin to spare. Why so many events: without
/// friction the push lends energy only up to 0.1 mm/s a contact, so that each lasts 0.1 ms.
#[test]
fn a_rolling_ball_pushes_a_cradle_along_and_that_ends() {
    let events = judged("rolling-cradle");
    assert!(events < MOST_EVENTS_OF_THE_CRADLE, "{events} events");
}

/// Seen: two of the balls of a break, rolling at 1 nm/s and parting, met 99 000 times in one instant.
/// Right: they meet once the cloth has turned them back. Why: see the test of the same motion in
/// carom-roots/tests/contact_rule.rs.
#[test]
fn balls_that_part_by_less_than_a_rounding_do_not_meet_for_ever() {
    assert_ends_soon("parting-below-a-rounding");
}
