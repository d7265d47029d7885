//! Rolling resistance in bands of speed: random shots are physical, and the checker detects faults
//! at the ends of bands.

use carom::event::{EventKind, Recorder};
use carom::format::{KeyPath, Node};
use carom::{MotionState, Shot, ShotFile};
use carom_check::CheckRecorder;
use carom_check::random_shots::{ShotFamily, shot_file};
use proptest::prelude::*;

use crate::owned_event::{OwnedEvent, events};
use crate::plan::any_plan;

/// Random shots of each family.
const SHOTS: u64 = if cfg!(debug_assertions) { 200 } else { 2_000 };

/// `shot` on a cloth with these bands: ends, m/s, and coefficients; the last one holds for all
/// faster balls.
fn on_bands(shot: &str, ends: &[f64], friction: &[f64]) -> Result<Shot, carom::Error> {
    let band = |(k, &mu): (usize, &f64)| {
        let mut band = Node::object([("friction", mu.into())]);
        if let Some(end) = ends.get(k) {
            band.set("up_to", *end);
        }
        band
    };
    let bands = Node::list(friction.iter().enumerate().map(band));
    let path = KeyPath::parse("physics.cloth.rolling_friction")?;
    let file = ShotFile::from_json(shot)?.with_values([(&path, bands)])?;
    Shot::from_json(&file.to_json())
}

proptest! {
    /// The coefficients rise and fall with speed.
    #[test]
    fn every_shot_in_bands_of_speed_ends_and_has_no_fault(
        plan in any_plan(8),
        steps in prop::collection::vec(0.001..0.6, 1..15),
        friction in prop::collection::vec(0.001..0.05, 16),
    ) {
        let ends: Vec<f64> = steps.iter().scan(0.0, |end, step| {
            *end += step;
            Some(*end)
        }).collect();
        let shot = on_bands(&plan.shot().to_json(), &ends, &friction[..=ends.len()]);
        let shot = shot.unwrap_or_else(|e| panic!("{e}"));
        let checker = CheckRecorder::run(&shot);
        prop_assert!(checker.faults.is_empty(), "{:#?}\n{}", checker.faults, shot.to_json());
        let trace = shot.simulate().expect("it ends");
        let again = carom::Trace::from_json(&trace.to_json()).unwrap_or_else(|e| panic!("{e}"));
        prop_assert_eq!(trace, again);
    }
}

#[test]
fn shots_of_every_family_in_bands_of_speed_are_physical() {
    let mut ends_of_bands = 0;
    for family in [ShotFamily::Pot, ShotFamily::EightBallBreak, ShotFamily::Frozen, ShotFamily::Row]
    {
        for seed in 0..SHOTS {
            let file = shot_file(family, seed);
            let shot = on_bands(&file, &[0.05, 0.3, 0.9, 2.0], &[0.007, 0.008, 0.01, 0.013, 0.02]);
            let shot = shot.unwrap_or_else(|e| panic!("{e}\n{file}"));
            let checker = CheckRecorder::run(&shot);
            assert!(checker.faults.is_empty(), "{:#?}\n{}", checker.faults, shot.to_json());
            if seed % 50 == 0 {
                ends_of_bands += events(&shot).iter().filter(|e| is_band_end(e)).count();
            }
        }
    }
    assert!(ends_of_bands > 0);
}

fn is_band_end(event: &OwnedEvent) -> bool {
    matches!(event.kind, EventKind::MotionTransition { from, to } if from == to)
}

/// A ball that rolls through three bands.
fn a_shot() -> Shot {
    let file = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "a", "position": [0, 0], "velocity": [0, 1.5, 0]}]}"#;
    on_bands(file, &[0.2, 0.8], &[0.005, 0.01, 0.03]).unwrap_or_else(|e| panic!("{e}"))
}

fn faults(falsify: impl FnOnce(&mut Vec<OwnedEvent>)) -> Vec<String> {
    let shot = a_shot();
    let mut all = events(&shot);
    falsify(&mut all);
    let mut checker = CheckRecorder::new(&shot);
    all.iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(word: &str, falsify: impl FnOnce(&mut Vec<OwnedEvent>, usize)) {
    let found = faults(|all| {
        let first = all.iter().position(is_band_end).expect("a band ends");
        falsify(all, first);
    });
    assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
}

#[test]
fn accepts_an_unchanged_record() {
    assert_eq!(faults(|_| {}), Vec::<String>::new());
}

#[test]
fn detects_a_ball_that_stays_too_long_in_a_band() {
    assert_detected("rolling for", |all, k| drop(all.remove(k)));
}

#[test]
fn detects_a_transition_where_no_band_ends() {
    assert_detected("where no band ends", |all, k| {
        let event = &mut all[k];
        for state in event.before.iter_mut().chain(&mut event.after) {
            state.velocity = state.velocity * 1.001;
            state.angular_velocity = state.angular_velocity * 1.001;
        }
    });
}

#[test]
fn detects_a_speed_that_jumps_at_the_end_of_a_band() {
    assert_detected("the velocity of ball 0 jumps", |all, k| {
        let after = &mut all[k].after[0];
        after.velocity = after.velocity * (1.0 - 1e-9);
        after.angular_velocity = after.angular_velocity * (1.0 - 1e-9);
    });
}

#[test]
fn detects_a_ball_that_goes_back_to_a_faster_state() {
    assert_detected("back to sliding", |all, k| {
        let (from, to) = (MotionState::Rolling, MotionState::Sliding);
        all[k].kind = EventKind::MotionTransition { from, to };
        all[k].after[0].motion = to;
        all[k].after[0].angular_velocity.x *= 1.1;
    });
}
