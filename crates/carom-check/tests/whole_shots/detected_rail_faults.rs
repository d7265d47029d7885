//! The checker detects wrong impulses of a rail on a ball on the bed: records of simulated shots
//! are falsified in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, Shot};
use carom_check::CheckRecorder;

use crate::owned_event::{OwnedEvent, events};

const MODELS: [&str; 5] = ["restitution", "factors", "han-2005", "mathavan-2010", "stronge"];

/// Models whose impulse acts at the nose.
const AT_THE_NOSE: [&str; 2] = ["han-2005", "stronge"];

/// A ball with sidespin that slides into the right rail at this speed, m/s. The physics has a date,
/// because the falsified amounts are shares of what its rail does.
fn a_shot(model: &str, speed: f64) -> Shot {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": "carom-10ft",
            "physics": {{"base": "carom-2026-11", "cushion": {{"model": "{model}"}}}},
            "balls": [{{"id": "a", "position": [1.38, 0.9], "velocity": [{speed}, {}, 0],
            "angular_velocity": [{}, {}, {}]}}]}}"#,
        0.4 * speed,
        5.0 * speed,
        2.0 * speed,
        30.0 * speed
    );
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
}

fn is_rail(e: &OwnedEvent) -> bool {
    matches!(e.kind, EventKind::RailCollision(_))
}

fn faults(model: &str, speed: f64, change: impl Fn(&mut BallState)) -> Vec<String> {
    let shot = a_shot(model, speed);
    let mut all = events(&shot);
    let k = all.iter().position(is_rail).expect("a rail");
    change(&mut all[k].after[0]);
    all.truncate(k + 1);
    let mut checker = CheckRecorder::new(&shot);
    all.iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(models: &[&str], word: &str, change: impl Fn(&mut BallState)) {
    for model in models {
        let found = faults(model, 1.0, &change);
        assert!(found.iter().any(|f| f.contains(word)), "{model}: no {word:?} in {found:#?}");
    }
}

#[test]
fn accepts_unchanged_records() {
    for model in MODELS {
        for speed in [0.2, 1.0, 6.0] {
            assert_eq!(faults(model, speed, |_| {}), Vec::<String>::new(), "{model} {speed}");
        }
    }
}

#[test]
fn detects_a_rebound_that_is_too_slow() {
    assert_detected(&MODELS, "the rail gives ball 0", |s| s.velocity.x *= 0.9);
}

#[test]
fn detects_a_rebound_that_is_a_little_too_slow() {
    let closed = ["restitution", "factors", "han-2005"];
    assert_detected(&closed, "the rail gives ball 0", |s| s.velocity.x *= 1.0 - 1e-9);
}

#[test]
fn detects_spin_that_the_impulse_does_not_explain() {
    assert_detected(&AT_THE_NOSE, "a spin that its impulse does not explain", |s| {
        s.angular_velocity.z *= 1.0 - 1e-9;
    });
    assert_detected(&["mathavan-2010"], "a spin that its impulse does not explain", |s| {
        s.velocity.y += 1e-9;
    });
}

/// Adds the impulse `push` (m/s; per unit mass) at the nose. The nose pushes along −x, and rubs along
/// y.
fn at_the_nose(s: &mut BallState, push: Vec3) {
    let (radius, height) = (0.030_75, 0.037);
    let sin: f64 = (height - radius) / radius;
    let arm = Vec3::new((1.0 - sin * sin).sqrt(), 0.0, sin);
    s.velocity += push;
    s.angular_velocity += arm.cross(push) * (2.5 / radius);
}

#[test]
fn detects_friction_beyond_the_cone() {
    assert_detected(&AT_THE_NOSE, "friction of", |s| {
        // The spin drags the ball along −y.
        at_the_nose(s, Vec3::new(0.0, -0.4, 0.0));
    });
}

#[test]
fn detects_friction_that_is_less_than_the_laws() {
    assert_detected(&AT_THE_NOSE, "more than", |s| at_the_nose(s, Vec3::new(0.0, 0.01, 0.0)));
}

/// The ball just before the rail, which is the same with every model.
fn at_the_rail() -> BallState {
    let all = events(&a_shot("stronge", 1.0));
    all.iter().find(|e| is_rail(e)).expect("a rail").before[0]
}

#[test]
fn detects_a_rail_that_pulls() {
    // The ball goes on, a little slower; friction at the nose has turned it back.
    assert_detected(&AT_THE_NOSE, "a pull of", |s| {
        let before = at_the_rail();
        *s = BallState { motion: s.motion, ..before };
        s.velocity.x -= 0.01;
        s.angular_velocity.y -= 8.0;
    });
}

#[test]
fn detects_an_impulse_of_the_slate_along_the_rail() {
    assert_detected(&AT_THE_NOSE, "an impulse of the slate", |s| {
        // Friction at the lowest point.
        let push = Vec3::new(0.0, 1e-6, 0.0);
        s.velocity += push;
        s.angular_velocity += Vec3::new(0.0, 0.0, -1.0).cross(push) * (2.5 / 0.030_75);
    });
}

#[test]
fn detects_a_slow_impact_that_changes_the_motion_along_the_rail() {
    for model in MODELS {
        let slow = 5e-4;
        // A ball this slow does not reach the rail, unless it starts at it.
        let file = format!(
            r#"{{"format": "carom-shot/1", "table": "carom-10ft",
                "physics": {{"base": "carom-2026-11", "cushion": {{"model": "{model}"}}}},
                "balls": [{{"id": "a", "position": [{:?}, 0.9], "velocity": [{slow}, 0.1, 0]}}]}}"#,
            1.42 - (0.030_75_f64 * 0.030_75 - 0.006_25 * 0.006_25).sqrt() - 1e-9
        );
        let shot = Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"));
        let mut all = events(&shot);
        let k = all.iter().position(is_rail).expect("a rail");
        all.truncate(k + 1);
        let found = |all: &[OwnedEvent]| {
            let mut checker = CheckRecorder::new(&shot);
            all.iter().for_each(|e| checker.record(&e.event()));
            checker.faults
        };
        assert!(found(&all).is_empty(), "{:#?}", found(&all));
        all[k].after[0].velocity.y *= 0.999;
        let faults = found(&all);
        assert!(faults.iter().any(|f| f.what.contains("the rail gives")), "{faults:#?}");
    }
}
