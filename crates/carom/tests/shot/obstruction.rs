//! The cue as a body: what it would pass through is reported, or refused on request.

use carom::batch::simulate_strikes;
use carom::resolve::cue_ball::Strike;
use carom::{Shot, Trace};

fn shot(strike: &str, others: &str) -> Result<Shot, carom::Error> {
    shot_from(1.27, strike, others)
}

/// With the cue ball `y` m from the bottom rail.
fn shot_from(y: f64, strike: &str, others: &str) -> Result<Shot, carom::Error> {
    Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{{"id": "cue", "position": [0.635, {y}]}}{others}],
            "strike": {{"ball": "cue", "speed": 1, {strike}}}}}"#
    ))
}

fn obstructed(strike: &str, others: &str) -> Option<String> {
    obstruction_of(shot(strike, others))
}

fn obstruction_of(shot: Result<Shot, carom::Error>) -> Option<String> {
    let trace: Trace = shot.and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    let outcome = trace.to_node().get("outcome").and_then(|o| o.get("cue_obstructed")).cloned();
    match outcome {
        Some(carom::shot::Node::Text(name)) => Some(name),
        Some(carom::shot::Node::Null) => None,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_cue_must_be_raised_over_the_rail_behind_a_near_ball() {
    let near = |elevation: f64| {
        let strike = format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#);
        obstruction_of(shot_from(0.06, &strike, ""))
    };
    // 31 mm behind the contact the axis must be 7.7 mm + 6.7 mm higher: 25°, a little less for
    // the contact that rises with it.
    assert_eq!(near(0.0).as_deref(), Some("bottom"));
    assert_eq!(near(12.0).as_deref(), Some("bottom"));
    assert_eq!(near(25.0), None);
}

#[test]
fn the_few_degrees_by_which_a_player_raises_every_cue_are_granted() {
    // From the middle of the table 0.95° clear the rail.
    assert_eq!(obstructed(r#""azimuth_deg": 90"#, ""), None);
    assert_eq!(obstructed(r#""azimuth_deg": -90"#, ""), None);
}

#[test]
fn a_ball_behind_the_cue_ball_is_in_the_way_until_the_cue_is_raised_over_it() {
    let behind = r#", {"id": "8", "position": [0.635, 1.1]}"#;
    let at = |elevation: f64| {
        obstructed(&format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#), behind)
    };
    assert_eq!(at(3.0).as_deref(), Some("8"));
    // From the contact at the ball's back, the axis must pass the 8's centre, 141 mm behind, at
    // 28.6 + 7.3 mm: asin(35.9/141) = 14.7°, a little less for the contact that rises with it.
    assert_eq!(at(11.0).as_deref(), Some("8"));
    assert_eq!(at(15.0), None);
    let beside = r#", {"id": "8", "position": [0.68, 1.1]}"#;
    assert_eq!(obstructed(r#""azimuth_deg": 90, "elevation_deg": 3"#, beside), None);
}

#[test]
fn a_ball_ahead_is_not_in_the_way() {
    let ahead = r#", {"id": "8", "position": [0.635, 1.33]}"#;
    assert_eq!(obstructed(r#""azimuth_deg": 90, "elevation_deg": 3"#, ahead), None);
}

#[test]
fn there_is_no_nose_over_a_side_pocket_and_none_on_unbounded_cloth() {
    assert_eq!(obstructed(r#""azimuth_deg": 0"#, ""), None);
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "cue", "position": [0, 0]}],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 12}}"#;
    let shot = Shot::from_json(text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(shot.cue_obstruction(), None);
}

#[test]
fn an_obstructed_cue_is_refused_on_request() {
    let e =
        shot_from(0.06, r#""azimuth_deg": 90, "obstruction": "refuse""#, "").expect_err("refused");
    let sentence = e.to_string();
    assert!(sentence.starts_with("strike.elevation_deg: "), "{sentence}");
    assert!(sentence.contains("the bottom rail") && sentence.contains("raise"), "{sentence}");
    shot_from(0.06, r#""azimuth_deg": 90, "elevation_deg": 30, "obstruction": "refuse""#, "")
        .unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn a_shot_that_refuses_an_obstructed_cue_refuses_it_for_every_strike_of_a_batch() {
    let behind = r#", {"id": "8", "position": [0.635, 1.1]}"#;
    let level = r#""azimuth_deg": 0, "obstruction": "refuse""#;
    let shot = shot(level, behind).unwrap_or_else(|e| panic!("{e}"));
    let (_, sideways) = shot.strike().expect("the shot has a strike");
    let upwards = Strike { azimuth: core::f64::consts::FRAC_PI_2, ..sideways };
    let result = simulate_strikes(&shot, &[sideways, upwards], Some(1), &|_| ());
    let errors: Vec<_> = result.errors.iter().map(|(k, e)| (*k, e.to_string())).collect();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert_eq!(errors[0].0, 1);
    assert!(errors[0].1.contains("pass through ball \"8\""), "{errors:?}");
}
