//! The checker detects a wrong restitution and a wrong friction of two balls, a contact that clings
//! or does not, and a wrong restitution of a rail that a flying ball hits. The record of a shot with
//! one law is checked against another law.

use carom::Shot;
use carom::event::Recorder;
use carom_check::CheckRecorder;

use crate::owned_event::events;

/// A stunned ball meets a second one at 45°, which then cuts a third one. `ball_ball` is the law, and
/// `cling` a further key of the file.
fn two_cuts(ball_ball: &str, cling: &str) -> Shot {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": {{"cloth": "unbounded"}},
            "physics": {{"base": "pool", "ball_ball": {ball_ball}}},
            "balls": [{{"id": "cue", "position": [0.6, 0.6], "velocity": [0, 1.5, 0]}},
            {{"id": "1", "position": [0.640411, 0.640911]}},
            {{"id": "2", "position": [0.66134, 0.71898]}}]{cling}}}"#
    );
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
}

/// A ball that flies against a nose, with this law of the cushion.
fn flight(cushion: &str) -> Shot {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": "carom-10ft",
            "physics": {{"base": "carom", "cushion": {cushion}}},
            "balls": [{{"id": "a", "position": [1.3, 0.9, 0.05], "velocity": [3, 0.5, 0.2],
            "angular_velocity": [5, -3, 20]}}]}}"#
    );
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
}

/// The faults of the record of `played`, judged as one of `told`.
fn faults(played: &Shot, told: &Shot) -> Vec<String> {
    let mut checker = CheckRecorder::new(told);
    events(played).iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(word: &str, played: &Shot, told: &Shot) {
    for shot in [played, told] {
        assert_eq!(faults(shot, shot), Vec::<String>::new());
    }
    let found = faults(played, told);
    assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
}

/// A law of two balls.
fn law(model: &str, restitution: f64, friction: &str) -> String {
    format!(r#"{{"model": "{model}", "restitution": {restitution}, "friction": {friction}}}"#)
}

#[test]
fn detects_another_restitution_of_two_balls() {
    for model in ["frictional", "compliant"] {
        let shot = |e| two_cuts(&law(model, e, r#""used""#), "");
        assert_detected("where the law has", &shot(0.94), &shot(0.941));
    }
}

#[test]
fn detects_another_friction_of_two_balls() {
    for model in ["frictional", "compliant"] {
        let shot = |surface| two_cuts(&law(model, 0.94, surface), "");
        assert_detected("where the law has", &shot(r#""used""#), &shot(r#""clean""#));
        assert_detected("where the law has", &shot("0.06"), &shot("0.0602"));
    }
}

#[test]
fn detects_a_cling_at_another_contact() {
    for model in ["frictional", "compliant"] {
        let at = |contacts| {
            let cling = format!(r#", "cling": {{"contacts": {contacts}, "friction": 0.2}}"#);
            two_cuts(&law(model, 0.94, r#""used""#), &cling)
        };
        for (played, told) in [("[1]", "[]"), ("[]", "[1]"), ("[0]", "[1]"), ("[0, 1]", "[0]")] {
            assert_detected("where the law has", &at(played), &at(told));
        }
    }
}

#[test]
fn accepts_a_cling_between_smooth_balls() {
    for friction in ["0", "0.2"] {
        let cling = format!(r#", "cling": {{"contacts": [0, 1], "friction": {friction}}}"#);
        let shot = two_cuts(&law("frictional", 0.94, "0"), &cling);
        assert_eq!(faults(&shot, &shot), Vec::<String>::new());
    }
}

#[test]
fn detects_another_restitution_of_a_rail_at_a_flying_ball() {
    for model in ["restitution", "han-2005", "stronge"] {
        let shot = |a: f64| {
            let fit = format!(r#"{{"a": {a}, "b": -0.05, "c": 0, "lowest": 0.3}}"#);
            flight(&format!(r#"{{"model": "{model}", "restitution": {fit}}}"#))
        };
        assert_detected("where the law has", &shot(1.0), &shot(1.001));
    }
}

#[test]
fn detects_other_factors_of_a_rail_at_a_flying_ball() {
    let shot = |factors: &str| flight(&format!(r#"{{"model": "factors", {factors}}}"#));
    let usual = shot(r#""restitution": 0.6, "tangential_factor": 0.9, "spin_factor": 0.1"#);
    for other in [
        r#""restitution": 0.601, "tangential_factor": 0.9, "spin_factor": 0.1"#,
        r#""restitution": 0.6, "tangential_factor": 0.901, "spin_factor": 0.1"#,
        r#""restitution": 0.6, "tangential_factor": 0.9, "spin_factor": 0.101"#,
    ] {
        assert_detected("by factors is off", &usual, &shot(other));
    }
}
