//! Strikes in which the tip, the slate and other balls act at once.

use crate::support::{LogRecorder, RecordedEvent, play, shot};
use carom::MotionState;
use carom::event::EventKind;
use carom::math::{Vec2, Vec3, atan2, cos, degrees, radians, sin};

/// Diameter of a ball, m.
const D: f64 = 0.057_15;
/// Speed of 1 mph, m/s.
const MPH: f64 = 0.447_04;

/// A cue ball at the origin of unbounded cloth, struck along +y; `others` are `, {...}` balls.
fn strike(strike: &str, others: &str, physics: &str) -> (carom::Shot, LogRecorder) {
    let shot = shot(&format!(
        r#""table": {{"cloth": "unbounded"}}, "physics": {physics},
           "balls": [{{"id": "cue", "position": [0, 0]}}{others}],
           "strike": {{"ball": "cue", "azimuth_deg": 90, {strike}}}"#
    ));
    let (log, _) = play(&shot);
    (shot, log)
}

fn first(log: &LogRecorder) -> &RecordedEvent {
    &log.events[0]
}

/// A ball that touches the cue ball at the angle `cut` (rad) right of the aim.
fn beside(cut: f64) -> String {
    format!(r#", {{"id": "1", "position": [{:?}, {:?}]}}"#, D * sin(cut), D * cos(cut))
}

fn angle(from: Vec2, to: Vec2) -> f64 {
    degrees(atan2(from.cross(to), from.dot(to)))
}

/// Alciatore, Billiards Digest, July 2008 (BB28): the angle between the line of centres and the way
/// of a cue ball that is frozen to an object ball, ±4°.
#[test]
fn a_frozen_cue_ball_leaves_between_the_aim_and_the_tangent_line_as_measured() {
    for (cut, measured) in
        [(8.0, 13.0), (20.0, 34.0), (34.0, 50.0), (46.0, 61.0), (57.0, 70.0), (67.0, 78.0)]
    {
        for speed in [1.0, 3.0] {
            let cut = radians(cut);
            let level = format!(r#""speed": {speed:?}, "elevation_deg": 0"#);
            let (_, log) = strike(&level, &beside(cut), r#""pool""#);
            let event = first(&log);
            assert_eq!(event.balls, [0, 1]);
            let line = Vec2::new(sin(cut), cos(cut));
            let leaves = angle(line, event.after[0].velocity.xy());
            assert!((leaves - measured).abs() < 4.0, "{leaves} at {cut} rad, {speed} m/s");
        }
    }
}

/// TP A.19: tan θ = a·sin φ/(R·cos φ + b), whatever the speed and the friction.
#[test]
fn a_masse_rolls_in_the_direction_of_coriolis_and_hops_by_less_than_15_mm() {
    let expected = degrees(atan2(0.25 * sin(radians(75.0)), cos(radians(75.0)) - 0.25));
    for friction in [0.1, 0.2, 0.3] {
        for (elevation, speed) in [(72.0, 3.5), (75.0, 2.0), (75.0, 3.0), (75.0, 3.5), (78.0, 3.5)]
        {
            let physics = format!(
                r#"{{"slate": {{"friction": {friction:?}}}, "cloth": {{"sliding_friction": 0.2}}}}"#
            );
            let text = format!(
                r#""speed": {speed:?}, "elevation_deg": {elevation:?}, "side": 0.25, "height": -0.25"#
            );
            let (_, log) = strike(&text, "", &physics);
            let up = first(&log).after[0].velocity.z;
            assert!(up * up / (2.0 * 9.806_65) < 0.015, "{elevation}°, {speed} m/s: {up} m/s");
            let rolls = log.events.iter().find(|e| e.after[0].motion == MotionState::Rolling);
            let way = rolls.expect("the ball rolls at last").after[0].velocity.xy();
            let turned = -angle(Vec2::new(0.0, 1.0), way);
            if elevation == 75.0 {
                assert!((turned - expected).abs() < 1.0, "{turned}, expected {expected}");
            }
        }
    }
}

#[test]
fn a_cue_at_45_degrees_and_5_metres_a_second_lifts_a_ball_over_another() {
    let (_, log) = strike(r#""speed": 5, "elevation_deg": 45"#, "", r#""pool""#);
    let up = first(&log).after[0].velocity.z;
    assert!(up * up / (2.0 * 9.806_65) > D);
}

/// TP B.10, A.30: half a radius off the centre, a cue at 15 mph gives a ball of 11.194 mph.
#[test]
fn a_tip_off_the_centre_loses_speed_as_published() {
    let text = format!(r#""speed": {:?}, "elevation_deg": 0, "height": 0.5"#, 15.0 * MPH);
    let (_, log) = strike(&text, "", r#""pool""#);
    let speed = first(&log).after[0].velocity.length() / MPH;
    assert!((speed - 11.194).abs() < 1e-3, "{speed} mph");
}

#[test]
fn the_loss_of_a_tip_grows_smoothly_up_to_the_miscue_limit_for_every_cue() {
    for mass in [0.1, 0.3, 0.567, 2.0] {
        let mut last = f64::INFINITY;
        for n in 0..=51 {
            let text =
                format!(r#""speed": 2, "elevation_deg": 0, "side": {:?}"#, 0.01 * f64::from(n));
            let physics = format!(r#"{{"cue": {{"mass": {mass:?}}}}}"#);
            let (_, log) = strike(&text, "", &physics);
            let speed = first(&log).after[0].velocity.length();
            assert!(speed < last && (last == f64::INFINITY || last - speed < 0.06), "{n}");
            last = speed;
        }
    }
}

#[test]
fn writing_a_restitution_or_an_efficiency_replaces_the_loss_off_the_centre() {
    let speed = |cue: &str| {
        let text = r#""speed": 2, "elevation_deg": 0, "side": 0.4"#;
        let (_, log) = strike(text, "", &format!(r#"{{"cue": {{{cue}}}}}"#));
        first(&log).after[0].velocity.length()
    };
    let ratio = |e: f64| 2.0 * (1.0 + e) / (0.170_097 / 0.567 + 1.4);
    assert!((speed(r#""tip_restitution": 0.73"#) - ratio(0.73)).abs() < 1e-12);
    let both = r#""tip_restitution": 0.73, "tip_off_centre_loss": 5.388423"#;
    assert_eq!(speed(both), speed(""));
    assert!(speed(r#""tip_efficiency": 0.87"#) != speed(""));
}

#[test]
fn a_level_strike_of_a_ball_alone_has_the_bits_of_the_sequential_law() {
    let text = r#""speed": 2.3, "elevation_deg": 0, "side": 0.3, "height": -0.2"#;
    let after = |physics: &str| {
        let (_, log) = strike(text, "", physics);
        first(&log).after[0]
    };
    assert_eq!(after(r#""pool""#), after(r#"{"cue": {"model": "sequential"}}"#));
}

#[test]
fn a_ball_behind_the_cue_ball_stays_where_it_is() {
    let (_, log) = strike(
        r#""speed": 2, "elevation_deg": 0"#,
        &format!(r#", {{"id": "1", "position": [0, {:?}]}}"#, -D),
        r#""pool""#,
    );
    assert_eq!(first(&log).balls, [0]);
    assert!(log.ball_collisions().is_empty());
}

#[test]
fn a_strike_mirrored_has_the_mirrored_bits() {
    let velocity = |side: f64| {
        let text = format!(r#""speed": 2.5, "elevation_deg": 40, "side": {side:?}, "height": 0.1"#);
        let other = beside(if side > 0.0 { 0.6 } else { -0.6 });
        let (_, log) = strike(&text, &other, r#""pool""#);
        first(&log).after.iter().map(|s| s.velocity).collect::<Vec<_>>()
    };
    // cos 90° is 6e-17, not 0, so the last bits may differ.
    for (right, left) in velocity(0.2).into_iter().zip(velocity(-0.2)) {
        let mirrored = Vec3::new(-left.x, left.y, left.z);
        assert!((right - mirrored).length() < 1e-13, "{right:?} and {left:?}");
    }
}

/// The tip is still on the cue ball when it has crossed half a millimetre.
#[test]
fn a_ball_met_across_a_narrow_gap_is_pushed_and_one_further_away_is_not() {
    let pushed = |gap: f64| {
        let other = format!(r#", {{"id": "1", "position": [0, {:?}]}}"#, D + gap);
        let (_, log) = strike(r#""speed": 2, "elevation_deg": 0"#, &other, r#""pool""#);
        matches!(first(&log).kind, EventKind::CueStrike { pushed: true, .. })
    };
    assert!(!pushed(0.0) && pushed(5e-4) && !pushed(5e-3));
}

#[test]
fn the_strike_gives_less_energy_than_the_cue_had() {
    for elevation in [0.0, 30.0, 60.0, 85.0] {
        for cut in [0.0, 0.5, 1.2] {
            let text = format!(r#""speed": 4, "elevation_deg": {elevation:?}, "side": 0.1"#);
            let (shot, log) = strike(&text, &beside(cut), r#""pool""#);
            let energies = first(&log).after.iter().zip(&first(&log).balls);
            let given: f64 = energies.map(|(s, &i)| shot.balls()[i].ball.kinetic_energy(s)).sum();
            let had = 0.5 * shot.physics().cue.mass * 16.0;
            assert!(given > 0.0 && given < had, "{given} of {had} J at {elevation}°");
        }
    }
}

#[test]
fn contact_times_and_losses_out_of_range_are_refused_with_their_place() {
    for (physics, place) in [
        (r#"{"contact_times": {"tip": 0}}"#, "physics.contact_times.tip"),
        (r#"{"contact_times": {"slate": 1}}"#, "physics.contact_times.slate"),
        (r#"{"cue": {"tip_off_centre_loss": -1}}"#, "physics.cue.tip_off_centre_loss"),
        (
            r#"{"cue": {"tip_efficiency": 0.8, "tip_off_centre_loss": 1}}"#,
            "physics.cue.tip_off_centre_loss",
        ),
        (r#"{"cue": {"model": "newton"}}"#, "physics.cue.model"),
    ] {
        let text = format!(
            r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "physics": {physics},
                "balls": [{{"id": "cue", "position": [0.5, 0.5]}}]}}"#
        );
        let sentence = carom::Shot::from_json(&text).expect_err("out of range").to_string();
        assert!(sentence.starts_with(place), "{sentence}");
    }
}
