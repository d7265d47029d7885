//! Rolling resistance in bands of speed: where balls stop, when they meet, and what a trace has.

use carom::event::EventKind;
use carom::math::{Vec3, log, sqrt};
use carom::physics::{RollingBand, RollingFriction, RollingLaw, RollingTolerance};
use carom::{Outcome, Shot, Trace};

use crate::support::{play, shot};

const RADIUS: f64 = 0.028575;
const GRAVITY: f64 = 9.80665;

/// Three bands, the lowest with the least resistance.
const GROWING: &str =
    r#"[{"up_to": 0.2, "friction": 0.005}, {"up_to": 0.8, "friction": 0.01}, {"friction": 0.03}]"#;
const BANDS: [(f64, f64); 3] = [(0.2, 0.005), (0.8, 0.01), (f64::INFINITY, 0.03)];

/// Balls that roll along +y from the given places at the given speeds.
fn rolling(friction: &str, balls: &[([f64; 2], f64)]) -> Shot {
    let ball = |(k, &([x, y], v)): (usize, &([f64; 2], f64))| {
        let spin = -v / RADIUS;
        format!(
            r#"{{"id": "{k}", "position": [{x:?}, {y:?}], "velocity": [0, {v:?}, 0],
                "angular_velocity": [{spin:?}, 0, 0]}}"#
        )
    };
    let balls: Vec<String> = balls.iter().enumerate().map(ball).collect();
    shot(&format!(
        r#""table": {{"cloth": "unbounded"}},
           "physics": {{"base": "pool", "cloth": {{"rolling_friction": {friction}}}}},
           "balls": [{}]"#,
        balls.join(", ")
    ))
}

fn is_band_end(kind: &EventKind) -> bool {
    matches!(kind, EventKind::MotionTransition { from, to } if from == to)
}

/// Time and distance in which a ball slows from `speed` to `to` in the bands of [`BANDS`], band by
/// band.
fn slowed(speed: f64, to: f64) -> (f64, f64) {
    let (mut time, mut distance, mut low) = (0.0, 0.0, 0.0);
    for (end, friction) in BANDS {
        let (high, below) = (speed.min(end), to.max(low));
        if high > below {
            time += (high - below) / (friction * GRAVITY);
            distance += (high * high - below * below) / (2.0 * friction * GRAVITY);
        }
        low = end;
    }
    (time, distance)
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{found} {expected}");
}

#[test]
fn a_ball_rolls_as_far_and_as_long_as_its_bands_say() {
    for speed in [0.05, 0.2, 0.5, 0.8, 1.7] {
        let (log, summary) = play(&rolling(GROWING, &[([0.0, 0.0], speed)]));
        let (time, distance) = slowed(speed, 0.0);
        close(summary.duration, time);
        close(log.events.last().expect("it stops").after[0].position.y, distance);
        let ends = log.of(is_band_end);
        let passed: Vec<f64> =
            BANDS.iter().rev().map(|(end, _)| *end).filter(|end| *end < speed).collect();
        assert_eq!(ends.len(), passed.len(), "{speed}");
        for (event, end) in ends.iter().zip(passed) {
            close(event.time, slowed(speed, end).0);
            close(event.before[0].velocity.y, end);
            // Exactly, so that the next path is in the next band.
            assert_eq!(event.after[0].velocity, Vec3::new(0.0, end, 0.0));
            assert_eq!(event.after[0].angular_velocity.x, -end / RADIUS);
            assert_eq!(event.before[0].position, event.after[0].position);
        }
    }
}

#[test]
fn sidespin_decays_through_the_ends_of_bands() {
    let shot = shot(&format!(
        r#""table": {{"cloth": "unbounded"}}, "physics": {{"cloth": {{"rolling_friction": {GROWING}}}}},
           "balls": [{{"id": "a", "position": [0, 0], "velocity": [0, 1, 0],
                       "angular_velocity": [{:?}, 0, 30]}}]"#,
        -1.0 / RADIUS
    ));
    let (log, _) = play(&shot);
    assert_eq!(log.of(is_band_end).len(), 2);
    for event in log.of(is_band_end) {
        let left = (30.0 - 10.0 * event.time).max(0.0);
        close(event.after[0].angular_velocity.z, left);
        assert_eq!(event.before[0].angular_velocity.z, event.after[0].angular_velocity.z);
    }
}

#[test]
fn a_list_of_one_band_has_the_bits_of_its_number() {
    let balls = [([0.0, 0.0], 1.3), ([0.01, 0.4], 0.2)];
    let hash = |friction: &str| rolling(friction, &balls).simulate().expect("it ends").hash();
    assert_eq!(hash(r#"[{"friction": 0.0123}]"#), hash("0.0123"));
    assert_ne!(hash(r#"[{"friction": 0.0123}]"#), hash("0.0124"));
}

#[test]
fn bands_of_one_coefficient_change_nothing_but_rounding() {
    let balls = [([0.0, 0.0], 1.3), ([0.01, 0.9], 0.2)];
    let last = |friction: &str| {
        let shot = rolling(friction, &balls);
        let (log, _) = play(&shot);
        [0, 1].map(|i| log.last(&shot, i).position)
    };
    let equal = r#"[{"up_to": 0.1, "friction": 0.01}, {"up_to": 0.7, "friction": 0.01},
        {"friction": 0.01}]"#;
    for (a, b) in last(equal).into_iter().zip(last("0.01")) {
        assert!((a - b).length() < 1e-11, "{a:?} {b:?}");
    }
}

/// The contact is in a lower band than the start, so the search has to begin again at each end.
#[test]
fn a_ball_meets_another_one_in_a_lower_band_at_the_right_time() {
    let gap = 2.0;
    let shot = rolling(GROWING, &[([0.0, 0.0], 1.2), ([0.0, gap + 2.0 * RADIUS], 0.0)]);
    let (log, _) = play(&shot);
    let hit = log.ball_collisions()[0];
    let (_, first) = slowed(1.2, 0.8);
    let speed = sqrt(0.8 * 0.8 - 2.0 * 0.01 * GRAVITY * (gap - first));
    assert!((0.2..0.8).contains(&speed));
    close(hit.time, slowed(1.2, speed).0);
    close(hit.before[0].velocity.y, speed);
}

#[test]
fn a_ball_that_is_a_rounding_error_above_the_end_of_a_band_begins_the_band_below() {
    for speed in [0.8, 0.8_f64.next_up(), 0.8 * (1.0 + 9e-13)] {
        let (log, _) = play(&rolling(GROWING, &[([0.0, 0.0], speed)]));
        assert_eq!(log.of(is_band_end).len(), 1, "{speed:?}");
    }
    let (log, _) = play(&rolling(GROWING, &[([0.0, 0.0], 0.8 * (1.0 + 2e-12))]));
    assert_eq!(log.of(is_band_end).len(), 2);
}

#[test]
fn a_ball_that_nothing_stops_in_its_band_ends_the_shot_in_motion() {
    let shot =
        rolling(r#"[{"up_to": 0.4, "friction": 0}, {"friction": 0.02}]"#, &[([0.0, 0.0], 1.0)]);
    let trace = shot.simulate().expect("it ends");
    assert_eq!(trace.outcome().never_resting, [0]);
    assert_eq!(trace.last()[0].velocity.y, 0.4);
}

/// A trace is evaluated from the states after its events alone.
#[test]
fn a_trace_gives_the_state_at_every_time_also_after_it_was_read_again() {
    let shot = rolling(GROWING, &[([0.0, 0.0], 1.5), ([0.01, 3.0], 0.0)]);
    let trace = shot.simulate().expect("it ends");
    let again = Trace::from_json(&trace.to_json()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(trace, again);
    let hit = play(&shot).0.ball_collisions()[0].time;
    for k in 0..200 {
        let time = hit * f64::from(k) / 200.0;
        let state = trace.at(time).expect("a time of the shot")[0];
        assert_eq!(again.at(time).expect("a time of the shot")[0], state);
        let (passed, _) = slowed(1.5, state.velocity.y);
        assert!((passed - time).abs() < 1e-12, "{passed} {time}");
    }
}

/// Rules and outcomes look at contacts only.
#[test]
fn the_outcome_does_not_contain_the_ends_of_bands() {
    let outcome = |friction: &str| {
        let shot = rolling(friction, &[([0.0, 0.0], 1.5), ([0.0, 1.0], 0.0)]);
        shot.simulate().expect("it ends").outcome().clone()
    };
    let (found, plain) = (outcome(GROWING), outcome("0.01"));
    assert!(found.events > plain.events);
    assert_eq!(Outcome { events: plain.events, ..found }, plain);
}

/// Heated carom: D = 0.0410 + 0.0142 v m/s². The exact law has v dv/ds = −D.
#[test]
fn bands_of_a_law_stop_a_ball_where_the_law_does() {
    let law = RollingLaw { a: 0.0410, b: 0.0142 };
    let tolerance = RollingTolerance { fastest: 3.0, share: 0.005, least: 0.005 };
    let bands = law.bands(GRAVITY, &tolerance).unwrap_or_else(|e| panic!("{e}"));
    let friction = bands.to_node().to_json();
    for k in 1..=30 {
        let speed = 0.1 * f64::from(k);
        let shot = rolling(&friction, &[([0.0, 0.0], speed)]);
        let found = play(&shot).0.last(&shot, 0).position.y;
        let ratio = law.b / law.a;
        let exact = (speed - log(1.0 + ratio * speed) / ratio) / law.b;
        assert!((exact - found).abs() <= (0.005 * exact).max(0.005), "{speed} {exact} {found}");
    }
}

#[test]
fn bands_are_what_they_were_made_of() {
    let bands = BANDS.map(|(up_to, friction)| RollingBand { up_to, friction });
    let law = RollingFriction::from_bands(&bands).unwrap_or_else(|e| panic!("{e}"));
    assert!(law.bands().eq(bands));
    assert_eq!(law.as_constant(), None);
    for (speed, friction) in [(0.0, 0.005), (0.2, 0.005), (0.21, 0.01), (0.9, 0.03), (50.0, 0.03)] {
        assert_eq!(law.at(speed), friction, "{speed}");
    }
    assert_eq!(RollingFriction::constant(0.01).as_constant(), Some(0.01));
}
