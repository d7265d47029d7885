//! Obstructed cues are reported, or refused on request.

use carom::batch::simulate_strikes;
use carom::math::{Vec3, atan2, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Shot, Table, Trace};

fn shot(strike: &str, others: &str) -> Result<Shot, carom::Error> {
    shot_from(1.27, strike, others)
}

/// A shot with the cue ball `y` m from the bottom rail.
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
        Some(carom::format::Node::Text(name)) => Some(name),
        Some(carom::format::Node::Null) => None,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_cue_must_be_raised_over_the_rail_behind_a_near_ball() {
    let near = |elevation: f64| {
        let strike = format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#);
        obstruction_of(shot_from(0.06, &strike, ""))
    };
    // The nose is 60 mm behind the ball's centre and 7.7 mm above it. The axis rotates about that
    // centre and must be 6.7 mm above the nose: asin(6.7/60.5) + atan(7.7/60) = 13.7°.
    assert_eq!(near(0.0).as_deref(), Some("bottom"));
    assert_eq!(near(12.0).as_deref(), Some("bottom"));
    assert_eq!(near(13.5).as_deref(), Some("bottom"));
    assert_eq!(near(13.8), None);
}

#[test]
fn a_level_cue_may_be_raised_by_the_few_degrees_of_a_usual_stance() {
    // From the middle of the table 0.95° is enough to clear the rail.
    assert_eq!(obstructed(r#""azimuth_deg": 90, "elevation_deg": 0"#, ""), None);
    assert_eq!(obstructed(r#""azimuth_deg": -90, "elevation_deg": 0"#, ""), None);
}

#[test]
fn a_ball_behind_the_cue_ball_obstructs_the_cue_until_it_is_raised_over_it() {
    let behind = r#", {"id": "8", "position": [0.635, 1.1]}"#;
    let at = |elevation: f64| {
        obstructed(&format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#), behind)
    };
    assert_eq!(at(3.0).as_deref(), Some("8"));
    // Seen from the contact point, the axis must be 28.6 + 7.3 mm above the 8's centre, 141 mm
    // behind: asin(35.9/141) = 14.7°, a little less because the contact point rises with the cue.
    assert_eq!(at(11.0).as_deref(), Some("8"));
    assert_eq!(at(15.0), None);
    let beside = r#", {"id": "8", "position": [0.68, 1.1]}"#;
    assert_eq!(obstructed(r#""azimuth_deg": 90, "elevation_deg": 3"#, beside), None);
}

#[test]
fn a_ball_ahead_does_not_obstruct_the_cue() {
    let ahead = r#", {"id": "8", "position": [0.635, 1.33]}"#;
    assert_eq!(obstructed(r#""azimuth_deg": 90, "elevation_deg": 3"#, ahead), None);
}

#[test]
fn there_is_no_nose_over_a_side_pocket_and_none_on_unbounded_cloth() {
    assert_eq!(obstructed(r#""azimuth_deg": 0, "elevation_deg": 0"#, ""), None);
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "cue", "position": [0, 0]}],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 12, "elevation_deg": 0}}"#;
    let shot = Shot::from_json(text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(shot.cue_obstruction(), None);
}

#[test]
fn an_obstructed_cue_is_refused_on_request() {
    let e =
        shot_from(0.06, r#""azimuth_deg": 90, "elevation_deg": 0, "obstruction": "refuse""#, "")
            .expect_err("refused");
    let sentence = e.to_string();
    assert!(sentence.starts_with("strike.elevation_deg: "), "{sentence}");
    assert!(sentence.contains("the bottom rail"), "{sentence}");
    let least = sentence.split("raise the elevation to ").nth(1);
    let least: f64 = least
        .and_then(|rest| rest.split(' ').next()?.parse().ok())
        .unwrap_or_else(|| panic!("`{sentence}` names no elevation"));
    let at = |elevation: f64| {
        let strike =
            format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}, "obstruction": "refuse""#);
        shot_from(0.06, &strike, "")
    };
    assert!(at(least).is_ok(), "{sentence}");
    assert!(at(least - 0.02).is_err(), "{sentence}");
}

#[test]
fn a_shot_that_refuses_an_obstructed_cue_refuses_it_for_every_strike_of_a_batch() {
    let behind = r#", {"id": "8", "position": [0.635, 1.1]}"#;
    let level = r#""azimuth_deg": 0, "elevation_deg": 0, "obstruction": "refuse""#;
    let shot = shot(level, behind).unwrap_or_else(|e| panic!("{e}"));
    let (_, sideways) = shot.strike().expect("the shot has a strike");
    let upwards = Strike { azimuth: core::f64::consts::FRAC_PI_2, ..sideways };
    let result = simulate_strikes(&shot, &[sideways, upwards], &Runner::default());
    let errors: Vec<_> = result.errors.iter().map(|(k, e)| (*k, e.to_string())).collect();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert_eq!(errors[0].0, 1);
    assert!(errors[0].1.contains("pass through ball \"8\""), "{errors:?}");
}

fn least_elevation(shot: Result<Shot, carom::Error>) -> Option<f64> {
    let trace: Trace = shot.and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    let outcome =
        trace.to_node().get("outcome").and_then(|o| o.get("least_elevation_deg")).cloned();
    match outcome {
        Some(carom::format::Node::Number(degrees)) => Some(degrees),
        Some(carom::format::Node::Null) => None,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_least_elevation_does_not_depend_on_the_elevation_of_the_strike() {
    for elevation in [0.0, 12.0, 60.0] {
        let strike = format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#);
        let least = least_elevation(shot_from(0.06, &strike, "")).expect("there is one");
        assert!((13.6..13.8).contains(&least), "{least} at {elevation}");
    }
    let far = least_elevation(shot_from(1.27, r#""azimuth_deg": 90"#, "")).expect("there is one");
    // (7.7 mm + 13 mm)/1.24 m.
    assert!((0.8..1.1).contains(&far), "{far}");
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "cue", "position": [0, 0]}],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 12}}"#;
    assert_eq!(least_elevation(Shot::from_json(text)), Some(0.0));
    let no_strike = text.split(",\n        \"strike\"").next().map(|head| format!("{head}}}"));
    assert_eq!(least_elevation(Shot::from_json(&no_strike.expect("a strike"))), None);
}

/// A ball that touches the cue ball from above and behind, its centre at 60° of elevation.
fn leaning_ball() -> String {
    let (y, z) = (1.27 - RADIUS, RADIUS + 2.0 * RADIUS * 0.75_f64.sqrt());
    format!(r#", {{"id": "8", "position": [0.635, {y:?}, {z:?}]}}"#)
}

#[test]
fn a_level_cue_passes_under_a_ball_in_the_air_that_obstructs_a_raised_one() {
    let at = |elevation: f64| {
        shot(&format!(r#""azimuth_deg": 90, "elevation_deg": {elevation}"#), &leaning_ball())
    };
    let least = least_elevation(at(0.0)).expect("there is one");
    assert!((0.8..1.1).contains(&least), "the rail's: {least}");
    assert_eq!(obstruction_of(at(0.0)), None);
    assert_eq!(obstruction_of(at(30.0)).as_deref(), Some("8"));
}

#[test]
fn a_ball_behind_and_one_above_can_obstruct_every_elevation() {
    let y = 1.27 - 2.0 * RADIUS;
    let both = format!(r#"{}, {{"id": "7", "position": [0.635, {y:?}]}}"#, leaning_ball());
    let strike = r#""azimuth_deg": 90, "elevation_deg": 20"#;
    assert_eq!(least_elevation(shot(strike, &both)), None);
    assert_eq!(obstructed(strike, &both).as_deref(), Some("7"));
    let sentence = shot(r#""azimuth_deg": 90, "elevation_deg": 0, "obstruction": "refuse""#, &both)
        .expect_err("refused")
        .to_string();
    assert!(sentence.contains("ball \"7\"; turn the azimuth"), "{sentence}");
}

#[test]
fn behind_a_pockets_mouth_the_rail_begins_at_the_back_of_the_hole() {
    // The ball is in a side pocket's mouth and the cue over the hole: 7.7 mm + about 6.8 mm above
    // the back of the hole, which is further away than the nose by the shelf and the hole.
    let y = 1.27;
    let least = |x: f64, y: f64| {
        least_elevation(Shot::from_json(&format!(
            r#"{{"format": "carom-shot/1", "table": "wpa-9ft",
                "balls": [{{"id": "cue", "position": [{x}, {y}]}}],
                "strike": {{"ball": "cue", "speed": 1, "azimuth_deg": 0}}}}"#
        )))
        .expect("there is one")
    };
    let table = Table::preset("wpa-9ft").expect("a preset");
    let side = &table.pockets[2];
    let back = -side.center.x - table.center().x + side.radius;
    let expected = atan2(7.7 + 7.1, 1e3 * (0.05 + back)).to_degrees();
    assert!((least(0.05, y) - expected).abs() < 0.5, "{} {expected}", least(0.05, y));
    assert!(least(0.05, y + 0.3) > 1.5 * expected, "over the nose: {}", least(0.05, y + 0.3));
}

const RADIUS: f64 = 0.028575;
const NOSE: f64 = 0.635 * 2.0 * RADIUS;

/// Clearance, m, between balls and rails of a table without pockets and the cue as a row of
/// spheres: a cone of 1.47 m, 13 mm and 29 mm.
fn room(shot: &Shot, elevation: f64) -> f64 {
    let (struck, strike) = shot.strike().expect("a strike");
    let description = shot.table().description.as_ref().expect("rails");
    let (sin_a, cos_a) = sin_cos(strike.azimuth);
    let (sin, cos) = sin_cos(elevation);
    let ahead = Vec3::new(cos * cos_a, cos * sin_a, -sin);
    let right = Vec3::new(sin_a, -cos_a, 0.0);
    let up = right.cross(ahead);
    let (x, y) = (strike.side, strike.height);
    let contact = right * x + up * y - ahead * (1.0 - x * x - y * y).sqrt();
    let tip = shot.balls()[struck].state.position + contact * RADIUS;
    let beyond = |x: f64, low: f64, high: f64| (low - x).max(x - high);
    let mut room = f64::INFINITY;
    for k in 0..=1470 {
        let s = 1e-3 * f64::from(k);
        let (p, radius) = (tip - ahead * s, 0.0065 + 0.008 * s / 1.47);
        for (_, ball) in shot.balls().iter().enumerate().filter(|(i, _)| *i != struck) {
            room = room.min((ball.state.position - p).length() - ball.ball.radius - radius);
        }
        // Distance to the slab below NOSE, between playing area and border.
        let (w, l, rail) = (description.width, description.length, description.rail_width);
        let outside = beyond(p.x, -rail, w + rail).max(beyond(p.y, -rail, l + rail));
        let inside = -beyond(p.x, 0.0, w).max(beyond(p.y, 0.0, l));
        let above = p.z - NOSE;
        let aside = inside.max(outside).max(0.0);
        let above = above.max(0.0);
        room = room.min((aside * aside + above * above).sqrt() - radius);
    }
    room
}

#[test]
fn the_least_elevation_is_that_of_a_cue_made_of_spheres() {
    let mut seed = 0x1234_5678_u64;
    let mut unit = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    // Largest difference between the spheres and the engine's cue, m.
    let same = 3e-4;
    let (mut seen, mut steep) = (0, 0);
    while seen < 300 {
        let mut near = |from: f64, size: f64| from + (size - 2.0 * from) * unit();
        let (x, y) = (near(0.03, 0.3), near(0.03, 0.35));
        let others: Vec<[f64; 3]> =
            (0..4).map(|_| [near(0.03, 0.3), near(0.03, 0.35), near(RADIUS, 0.15)]).collect();
        let [azimuth, side, height] = [360.0 * unit(), unit() - 0.5, 0.6 * unit() - 0.3];
        let list = others.iter().enumerate();
        let list: String =
            list.map(|(i, p)| format!(r#", {{"id": "{i}", "position": {p:?}}}"#)).collect();
        let Ok(shot) = Shot::from_json(&format!(
            r#"{{"format": "carom-shot/1", "table": {{"width": 0.3, "length": 0.35, "pockets": "none"}},
                "balls": [{{"id": "cue", "position": [{x:?}, {y:?}]}}{list}],
                "strike": {{"ball": "cue", "speed": 1, "azimuth_deg": {azimuth:?},
                            "side": {side:?}, "height": {height:?}}}}}"#
        )) else {
            continue;
        };
        seen += 1;
        let least = shot.least_elevation();
        let end = least.unwrap_or(core::f64::consts::FRAC_PI_2);
        if let Some(least) = least {
            assert!(
                room(&shot, least) > -same,
                "{} at {least} in {}",
                room(&shot, least),
                shot.to_json()
            );
        }
        steep += u32::from(end > 0.3);
        let mut elevation = 0.0;
        while elevation < end {
            let room = room(&shot, elevation);
            assert!(room < same, "{room} at {elevation} of {end} in {}", shot.to_json());
            elevation += 0.02;
        }
    }
    assert!(steep > 30, "{steep} of {seen}");
}
