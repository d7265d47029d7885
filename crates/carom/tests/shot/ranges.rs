//! Values within the documented ranges are accepted and their shots end; values outside are refused
//! with their place.

use carom::resolve::cue_ball::Strike;
use carom::{Error, Shot};

/// A shot on a bounded table with its cue ball at rest, and more keys for physics, ball and strike.
fn file(physics: &str, ball: &str, strike: &str) -> String {
    format!(
        r#"{{"format": "carom-shot/1",
            "table": {{"width": 1.27, "length": 2.54, "pockets": "none"}},
            "physics": {{"base": "pool"{physics}}},
            "balls": [{{"id": "cue", "position": [0.4, 0.6]}},
                      {{"id": "1", "position": [0.9, 1.9]{ball}}}],
            "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 70.0{strike}}}}}"#
    )
}

fn with_physics(section: &str, key: &str, value: &str) -> String {
    match section {
        "" => file(&format!(r#", "{key}": {value}"#), "", ""),
        _ => file(&format!(r#", "{section}": {{"{key}": {value}}}"#), "", ""),
    }
}

fn with_ball(key: &str, value: &str) -> String {
    file("", &format!(r#", "{key}": {value}"#), "")
}

fn with_strike(key: &str, value: &str) -> String {
    let text = file("", "", &format!(r#", "{key}": {value}"#));
    if key == "speed" { text.replacen("\"speed\": 2.0, ", "", 1) } else { text }
}

#[track_caller]
fn plays(text: &str) {
    let trace = Shot::from_json(text).and_then(|shot| shot.simulate());
    let trace = match trace {
        Ok(trace) => trace,
        // No friction slows the balls: the shot ends at the cap on events.
        Err(Error::TooManyEvents(_)) => return,
        Err(e) => panic!("{text}: {e}"),
    };
    assert!(trace.duration().is_finite(), "{text}");
    for state in trace.last() {
        let all = [state.position, state.velocity, state.angular_velocity];
        assert!(all.iter().flat_map(|v| v.to_array()).all(f64::is_finite), "{text}: {state:?}");
    }
}

#[track_caller]
fn refused(text: &str, place: &str) {
    match Shot::from_json(text) {
        Err(e @ Error::Input(_)) => {
            let sentence = e.to_string();
            assert!(
                sentence.starts_with(&format!("{place}: ")),
                "`{sentence}` should name {place}"
            );
            assert!(sentence.contains("write"), "`{sentence}` should name the remedy");
        }
        other => panic!("{text}: {other:?}"),
    }
}

/// Section and key of every coefficient of restitution.
const RESTITUTIONS: [(&str, &str); 5] = [
    ("ball_ball", "restitution"),
    ("cushion", "restitution"),
    ("slate", "restitution"),
    ("cue", "tip_restitution"),
    ("cue", "tip_efficiency"),
];
/// Section and key of every coefficient of friction.
const FRICTIONS: [(&str, &str); 6] = [
    ("cloth", "sliding_friction"),
    ("cloth", "rolling_friction"),
    ("ball_ball", "friction"),
    ("cushion", "friction"),
    ("slate", "friction"),
    ("cue", "tip_friction"),
];
/// Section and key of every mass and radius.
const SIZES: [(&str, &str); 4] =
    [("ball", "mass"), ("ball", "radius"), ("cue", "mass"), ("cue", "tip_radius")];

#[test]
fn restitutions_from_0_to_1_are_accepted_and_others_refused() {
    for (section, key) in RESTITUTIONS {
        let place = format!("physics.{section}.{key}");
        for value in ["0", "0.0", "1e-12", "0.5", "1", "1.0"] {
            // By TP A.30 an efficiency this low is unreachable.
            if key != "tip_efficiency" || value.starts_with('1') && !value.contains('e') {
                plays(&with_physics(section, key, value));
            }
        }
        for value in ["-1e-12", "1.0000001", "-1", "1e300", "true", "\"0.9\"", "null", "[0.9]"] {
            refused(&with_physics(section, key, value), &place);
        }
    }
}

#[test]
fn frictions_from_0_up_are_accepted_and_others_refused() {
    for (section, key) in FRICTIONS {
        for value in ["0", "1e-12", "0.3", "1", "5.0", "100"] {
            plays(&with_physics(section, key, value));
        }
        for value in ["-1e-12", "-0.2", "1e10", "\"0.2\"", "false"] {
            refused(&with_physics(section, key, value), &format!("physics.{section}.{key}"));
        }
    }
    for value in ["0", "5", "40"] {
        plays(&with_physics("cloth", "spin_deceleration", value));
    }
    refused(&with_physics("cloth", "spin_deceleration", "-1"), "physics.cloth.spin_deceleration");
}

#[test]
fn masses_and_radii_above_0_are_accepted_and_others_refused() {
    for (section, key) in SIZES {
        // A ball far larger or smaller than the nose's height is refused for another reason.
        let fits = section == "ball" && key == "radius";
        let values: &[&str] =
            if fits { &["0.02", "0.028", "0.035"] } else { &["1e-6", "0.01", "1", "50"] };
        for value in values {
            plays(&with_physics(section, key, value));
        }
    }
    for value in ["1e-6", "0.1", "3", "1000"] {
        plays(&with_ball("mass", value));
    }
    for key in ["mass", "radius"] {
        for value in ["0", "-0.1", "1e-10", "1e10", "\"big\""] {
            refused(&with_physics("ball", key, value), &format!("physics.ball.{key}"));
            refused(&with_ball(key, value), &format!("balls[1].{key}"));
        }
    }
    for value in ["0", "-0.5", "1e10"] {
        refused(&with_physics("cue", "mass", value), "physics.cue.mass");
        refused(&with_physics("", "gravity", value), "physics.gravity");
    }
    for value in ["0", "0.001", "0.1"] {
        plays(&with_physics("cue", "end_mass", value));
    }
    refused(&with_physics("cue", "end_mass", "-0.001"), "physics.cue.end_mass");
    for value in ["1e-3", "1.62", "9.81", "274"] {
        plays(&with_physics("", "gravity", value));
    }
}

#[test]
fn a_strike_has_the_documented_ranges() {
    for value in ["1e-9", "0.001", "12", "50", "50.0"] {
        plays(&with_strike("speed", value));
    }
    for value in ["0", "-1", "50.000001", "1e300"] {
        refused(&with_strike("speed", value), "strike.speed");
    }
    for value in ["0", "4.5", "45", "89.9", "89.999999999"] {
        plays(&with_strike("elevation_deg", value));
    }
    for value in ["-0.001", "90", "90.0", "180"] {
        refused(&with_strike("elevation_deg", value), "strike.elevation_deg");
    }
    for key in ["side", "height"] {
        for value in ["-0.5", "0", "0.5"] {
            plays(&with_strike(key, value));
        }
        for value in ["1.5", "-1.1"] {
            refused(&with_strike(key, value), &format!("strike.{key}"));
        }
    }
    for azimuth in ["-720.5", "0", "359.9", "1e6"] {
        plays(&file("", "", "").replace("70.0", azimuth));
    }
}

#[test]
fn velocities_to_100_and_spins_to_10000_are_accepted_and_larger_ones_refused() {
    for value in ["[100, 0, 0]", "[0.0, -100.0, 0.0]", "[60, 80, 0]", "[1e-300, 0, 0]"] {
        plays(&with_ball("velocity", value));
    }
    for value in ["[100.001, 0, 0]", "[0, -101, 0]", "[80, 80, 0]"] {
        refused(&with_ball("velocity", value), "balls[1].velocity");
    }
    for value in ["[10000, 0, 0]", "[0, -10000, 0]", "[0, 0, 10000]", "[0, 6000, -8000]"] {
        plays(&with_ball("angular_velocity", value));
    }
    for value in ["[10000.001, 0, 0]", "[0, 0, -10001]"] {
        refused(&with_ball("angular_velocity", value), "balls[1].angular_velocity");
    }
}

#[test]
fn a_shot_without_losses_on_unbounded_cloth_ends() {
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "physics": {"cloth": {"sliding_friction": 0, "rolling_friction": 0, "spin_deceleration": 0}},
        "balls": [{"id": "cue", "position": [-1e6, 0]}, {"id": "1", "position": [1e6, 2e6]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 70.0, "side": 0.3, "height": 0.2}}"#;
    plays(text);
    plays(&text.replace("\"sliding_friction\": 0", "\"sliding_friction\": 0.2"));
}

#[test]
fn a_number_too_small_or_too_large_is_refused_with_the_limits() {
    for (value, limit) in [("1e-10", "1e-9"), ("1e10", "1e9")] {
        let e = Shot::from_json(&with_ball("mass", value)).expect_err("out of range");
        assert!(e.to_string().contains(limit), "{e}");
    }
    let e = Shot::from_json(&with_physics("cloth", "sliding_friction", "1e10"));
    let e = e.expect_err("out of range").to_string();
    assert!(e.contains("≥ 0") && e.contains("1e9"), "{e}");
}

#[test]
fn a_number_of_a_strike_that_a_file_reads_as_0_is_refused_in_memory() {
    // A fuzzer played it in a game: the saved game could not be read, or had another hash.
    let shot = Shot::from_json(&file("", "", "")).unwrap();
    let (_, usual) = shot.strike().unwrap();
    for (x, is_played) in [(2.273e-321, false), (-1e-151, false), (1e-149, true), (-0.0, true)] {
        for (key, strike) in [
            ("azimuth", Strike { azimuth: x, ..usual }),
            ("elevation", Strike { elevation: x.abs(), ..usual }),
            ("side", Strike { side: x, ..usual }),
            ("height", Strike { height: x, ..usual }),
            ("speed", Strike { speed: if x == 0.0 { 1.0 } else { x.abs() }, ..usual }),
        ] {
            let found = [shot.with_strike(&strike).map(drop), shot.check_strike(&strike)];
            for result in found {
                assert_eq!(result.is_ok(), is_played, "{key} {x:e}: {result:?}");
                if let Err(error) = result {
                    let place = format!("strike.{key}: ");
                    assert!(error.to_string().starts_with(&place), "{error}");
                }
            }
        }
    }
}
