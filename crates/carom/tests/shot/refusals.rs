//! Every bad shot file is refused with one sentence: the place, the fault and the remedy.

use carom::{Error, Shot};

/// A good shot on a plain rectangle, with `from` replaced by `to`.
fn edited(from: &str, to: &str) -> String {
    let good = r#"{
        "format": "carom-shot/1",
        "table": {"width": 1.27, "length": 2.54, "pockets": "none"},
        "physics": {"base": "pool"},
        "balls": [
            {"id": "cue", "position": [0.635, 0.635]},
            {"id": "1", "position": [0.635, 1.905]}
        ],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0, "side": 0.0, "height": 0.0},
        "max_events": 1000
    }"#;
    assert_eq!(good.matches(from).count(), 1, "`{from}` must occur once in the good file");
    good.replace(from, to)
}

fn refusal(from: &str, to: &str) -> String {
    match Shot::from_json(&edited(from, to)) {
        Err(e @ Error::Input(_)) => e.to_string(),
        other => panic!("{to}: expected a refusal, got {other:?}"),
    }
}

#[track_caller]
fn refused(from: &str, to: &str, place: &str, words: &[&str]) {
    let sentence = refusal(from, to);
    assert!(sentence.starts_with(&format!("{place}: ")), "`{sentence}` should name `{place}`");
    for word in words {
        assert!(sentence.contains(word), "`{sentence}` should say `{word}`");
    }
    assert!(!sentence.contains('\n'), "`{sentence}` is more than one line");
}

const BALL_1: &str = r#"{"id": "1", "position": [0.635, 1.905]}"#;
const BASE: &str = r#""base": "pool""#;

#[test]
fn the_good_file_is_accepted() {
    let shot = Shot::from_json(&edited("1000", "1000")).expect("a good file");
    assert_eq!(shot.balls().len(), 2);
    assert_eq!(shot.max_events(), 1000);
}

#[test]
fn an_unknown_key_is_refused_with_the_nearest_known_one() {
    refused("max_events", "max_event", "max_event", &["unknown key", "`max_events`"]);
    refused("\"speed\"", "\"sped\"", "strike.sped", &["unknown key", "`speed`"]);
    refused("azimuth_deg", "azimut_deg", "strike.azimut_deg", &["`azimuth_deg`"]);
    refused(BASE, r#""cue": {"weight": 1}"#, "physics.cue.weight", &["mass", "tip_radius"]);
    refused(
        BASE,
        r#""ball_ball": {"friction": {"a": 0.1, "d": 1}}"#,
        "physics.ball_ball.friction.d",
        &[],
    );
}

#[test]
fn an_angle_in_both_units_is_refused() {
    let both = r#""azimuth_deg": 90, "azimuth": 1.5"#;
    let sentence =
        &["azimuth_deg gives the same angle", "keep azimuth (rad) or azimuth_deg (degrees)"];
    refused(r#""azimuth_deg": 90.0"#, both, "strike.azimuth", sentence);
    let both = r#""azimuth": 1.5, "elevation": 0.1, "elevation_deg": 5"#;
    refused(r#""azimuth_deg": 90.0"#, both, "strike.elevation", &["elevation_deg gives the same"]);
}

#[test]
fn an_angle_in_radians_has_the_range_of_the_one_in_degrees() {
    let angle = |text: &str, place, expected: &str| {
        refused(r#""azimuth_deg": 90.0"#, text, place, &[expected]);
    };
    angle(r#""azimuth": 1e300"#, "strike.azimuth", "out of range");
    angle(r#""azimuth": "north""#, "strike.azimuth", "found the text");
    let right_angle = r#""azimuth": 0, "elevation": 1.5707963267948966"#;
    angle(
        right_angle,
        "strike.elevation",
        "write a number in [0, 1.5707963267948966) rad (the key with _deg takes degrees)",
    );
    angle(r#""azimuth": 0, "elevation": -0.1"#, "strike.elevation", "out of range");
    angle(r#""elevation": 0.1"#, "strike.azimuth_deg", "the key is missing");
}

#[test]
fn a_file_of_another_format_is_refused_for_its_format_and_not_for_its_keys() {
    let trace = r#""format": "carom-trace/1", "engine": "carom 0.1.0""#;
    refused(r#""format": "carom-shot/1""#, trace, "format", &["carom-trace/1", "carom-shot/1"]);
    for (format, what) in [
        ("carom-trace/1", "the file is a trace"),
        ("carom-frame/1", "the file is the record of a frame"),
        ("carom-sweep/1", "the file is the spec of a sweep"),
        ("carom-shot/9", "there is no format"),
    ] {
        let with = format!(r#""format": "{format}""#);
        refused(r#""format": "carom-shot/1""#, &with, "format", &[what]);
    }
    let later = r#""format": "carom-shot/2", "players": 2"#;
    refused(r#""format": "carom-shot/1""#, later, "format", &["carom-shot/2"]);
}

#[test]
fn a_missing_key_is_refused() {
    refused("\"format\": \"carom-shot/1\",", "", "format", &["missing", "carom-shot/1"]);
    refused("\"speed\": 2.0, ", "", "strike.speed", &["missing"]);
    refused(BALL_1, r#"{"id": "1"}"#, "balls[1].position", &["missing"]);
}

#[test]
fn a_wrong_type_is_refused() {
    refused("\"speed\": 2.0", "\"speed\": \"fast\"", "strike.speed", &["\"fast\"", "number"]);
    refused("\"speed\": 2.0", "\"speed\": null", "strike.speed", &["null", "number"]);
    refused(BALL_1, "7", "balls[1]", &["the number 7", "object"]);
    refused("[0.635, 1.905]", "[0.635]", "balls[1].position", &["list of 1", "2 or 3 numbers"]);
    refused("1000", "10.5", "max_events", &["10.5", "whole"]);
    refused("\"id\": \"1\"", "\"id\": 1", "balls[1].id", &["the number 1", "text"]);
}

#[test]
fn a_nan_is_refused_with_its_place() {
    refused("1.905", "NaN", "balls[1].position[1]", &["NaN", "finite"]);
    refused("\"speed\": 2.0", "\"speed\": -Infinity", "strike.speed", &["-Infinity", "finite"]);
    refused("\"speed\": 2.0", "\"speed\": 1e999", "strike.speed", &["too large"]);
}

#[test]
fn a_nan_in_a_tree_of_values_is_refused_with_its_place() {
    use carom::format::Node;
    let shot = Shot::from_json(&edited("1000", "1000")).expect("a good file");
    let mut node = shot.to_node();
    let mut strike = node.get("strike").cloned().expect("it has a strike");
    strike.set("side", f64::NAN);
    node.set("strike", strike);
    let sentence = Shot::from_node(&node).expect_err("a NaN").to_string();
    assert!(sentence.starts_with("strike.side: NaN"), "{sentence}");
    let mut node: Node = shot.to_node();
    node.set(
        "balls",
        Node::list([Node::object([
            ("id", "cue".into()),
            ("position", [0.5, f64::INFINITY].into()),
        ])]),
    );
    let sentence = Shot::from_node(&node).expect_err("an infinity").to_string();
    assert!(sentence.starts_with("balls[0].position[1]: an infinite number"), "{sentence}");
}

#[test]
fn a_duplicate_key_is_refused() {
    refused("\"speed\": 2.0", "\"speed\": 2.0, \"speed\": 3.0", "strike.speed", &["twice"]);
}

#[test]
fn text_that_is_not_json_is_refused_with_its_line() {
    for text in ["", "{", "{\"format\": }", "[1, 2", "{} x", "{\"a\": 1,}"] {
        let sentence = Shot::from_json(text).expect_err("not JSON").to_string();
        assert!(sentence.contains("not JSON") && sentence.contains("line 1"), "{sentence}");
    }
}

#[test]
fn a_syntax_error_is_located_by_the_last_complete_keys() {
    for (text, start) in [
        ("{\"a\": 1,}", "not JSON"),
        ("{\"balls\": [{\"id\": \"a\" \"b\": 1}]}", "balls[0]: not JSON"),
        ("{\"strike\": {\"speed\": 2.0 1}}", "strike: not JSON"),
    ] {
        let sentence = Shot::from_json(text).expect_err("not JSON").to_string();
        assert!(sentence.starts_with(start), "{sentence}");
    }
    let deep = Shot::from_json(&"[".repeat(100_000)).expect_err("not JSON").to_string();
    assert!(deep.len() < 250, "{deep}");
}

#[test]
fn balls_are_refused_before_the_strike_on_one_of_them() {
    let none = r#"{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 90}}"#;
    let sentence = Shot::from_json(none).expect_err("no balls").to_string();
    assert!(sentence.starts_with("balls: found 0 balls"), "{sentence}");
}

#[test]
fn overlapping_balls_are_refused_with_their_depth() {
    refused("1.905", "0.690", "balls[1].position", &["balls[0]", "2.15", "0.05715"]);
}

#[test]
fn overlaps_up_to_a_nanometre_count_as_touching() {
    let at = |y: f64| Shot::from_json(&edited("1.905", &format!("{y:?}")));
    let contact = 0.635 + 2.0 * 0.028575;
    assert!(at(contact - 0.9e-9).is_ok());
    assert!(at(contact - 1.1e-9).is_err());
}

#[test]
fn a_ball_outside_or_in_a_cushion_is_refused() {
    let reach = carom::table::nose_reach(0.635 * 0.05715, 0.028575).expect("the nose meets it");
    let at = |x: f64| Shot::from_json(&edited("[0.635, 1.905]", &format!("[{x:?}, 1.905]")));
    assert!(at(reach).is_ok(), "frozen to the rail");
    assert!(at(1.27 - reach).is_ok(), "frozen to the other rail");
    for x in [-0.5, 0.0, reach - 2e-9, 1.27 - reach + 2e-9, 2.0] {
        let sentence = at(x).expect_err("outside").to_string();
        assert!(sentence.starts_with("balls[1].position: "), "{sentence}");
        assert!(sentence.contains("0.027"), "{sentence}");
    }
}

#[test]
fn a_ball_in_the_slate_is_refused() {
    refused("1.905]", "1.905, 0.01]", "balls[1].position", &["deep in the slate"]);
    refused(
        "1.905]",
        "1.905, 0.01], \"velocity\": [0, 0, 1]",
        "balls[1].position",
        &["deep in the slate"],
    );
}

#[test]
fn a_number_out_of_range_is_refused_with_its_range() {
    refused("\"speed\": 2.0", "\"speed\": 0", "strike.speed", &["(0, 50] m/s"]);
    refused("\"speed\": 2.0", "\"speed\": 51", "strike.speed", &["(0, 50] m/s"]);
    refused("\"side\"", "\"elevation_deg\": 90, \"side\"", "strike.elevation_deg", &["[0, 90)"]);
    refused("1.905]", "1.905], \"mass\": -0.1", "balls[1].mass", &["greater than 0"]);
    refused(
        "1.905]",
        "1.905], \"velocity\": [80, 80, 0]",
        "balls[1].velocity",
        &["at most 100 m/s"],
    );
    refused(
        "1.905]",
        "1.905], \"angular_velocity\": [0, 0, 10001]",
        "balls[1].angular_velocity",
        &["10000 rad/s"],
    );
    refused(
        BASE,
        r#""ball_ball": {"restitution": 1.1}"#,
        "physics.ball_ball.restitution",
        &["[0, 1]"],
    );
    refused(
        BASE,
        r#""cloth": {"sliding_friction": -0.1}"#,
        "physics.cloth.sliding_friction",
        &["≥ 0"],
    );
    refused("1000", "0", "max_events", &["from 1 to"]);
}

#[test]
fn a_strike_that_no_tip_can_play_is_refused() {
    refused("\"side\": 0.0", "\"side\": 1.0", "strike.side", &["miss the ball"]);
    refused("\"height\": 0.0", "\"height\": -0.9", "strike.height", &["miscue", "tip_friction"]);
    let efficient = edited(BASE, r#""cue": {"tip_efficiency": 0.87, "tip_friction": 5}"#)
        .replace("\"side\": 0.0", "\"side\": 0.9");
    let sentence = Shot::from_json(&efficient).expect_err("unreachable").to_string();
    assert!(
        sentence.starts_with("strike.side: physics.cue.tip_efficiency is too low"),
        "{sentence}"
    );
}

#[test]
fn a_miscue_may_be_reported_instead() {
    let with = |height: &str| {
        edited("\"height\": 0.0", &format!("\"height\": {height}, \"miscue\": \"report\""))
    };
    let shot = Shot::from_json(&with("0.9")).expect("reported, not refused");
    assert!(shot.is_miscue());
    let shot = Shot::from_json(&with("0.1")).expect("a clean strike");
    assert!(!shot.is_miscue());
}

#[test]
fn the_struck_ball_must_exist_and_be_at_rest() {
    refused("\"ball\": \"cue\"", "\"ball\": \"white\"", "strike.ball", &["\"cue\", \"1\""]);
    refused(
        "[0.635, 0.635]",
        "[0.635, 0.635], \"velocity\": [1, 0, 0]",
        "strike.ball",
        &["is already moving"],
    );
}

#[test]
fn two_balls_with_one_id_are_refused() {
    refused("\"id\": \"1\"", "\"id\": \"cue\"", "balls[1].id", &["balls[0]", "own id"]);
}

#[test]
fn a_preset_that_does_not_exist_is_refused_with_the_nearest() {
    refused("\"pool\"", "\"pol\"", "physics.base", &["\"pool\""]);
    refused(r#"{"base": "pool"}"#, "\"snoker\"", "physics", &["\"snooker\""]);
    refused(BASE, r#""cushion": {"model": "strong"}"#, "physics.cushion.model", &["\"stronge\""]);
}

#[test]
fn a_tip_cannot_have_both_restitution_and_efficiency() {
    refused(
        BASE,
        r#""cue": {"tip_restitution": 0.7, "tip_efficiency": 0.87}"#,
        "physics.cue.tip_efficiency",
        &["same property", "keep one"],
    );
}

#[test]
fn a_factor_above_1_is_refused() {
    for key in ["tangential_factor", "spin_factor"] {
        refused(
            BASE,
            &format!(r#""cushion": {{"model": "factors", "{key}": 1.1}}"#),
            &format!("physics.cushion.{key}"),
            &["1.1"],
        );
    }
}

#[test]
fn a_nose_height_that_no_ball_can_touch_is_refused() {
    refused("1.905]", "1.905], \"radius\": 0.01", "balls[1].radius", &["cushion nose"]);
}

#[test]
fn a_ball_larger_than_a_hole_is_refused() {
    const CUSTOM: &str = r#"{"width": 1.27, "length": 2.54, "pockets": "none"},
        "physics": {"base": "pool"}"#;
    let pool = |radius: f64| {
        format!(r#""wpa-9ft", "physics": {{"base": "pool", "ball": {{"radius": {radius}}}}}"#)
    };
    // The corner's hole has a radius of 61.9 mm, the side's 63.5 mm.
    for radius in [0.062, 0.07] {
        refused(CUSTOM, &pool(radius), "balls[0].radius", &["cannot fall", "hole_radius"]);
    }
    assert!(Shot::from_json(&edited(CUSTOM, &pool(0.0618))).is_ok());
}

#[test]
fn every_cushion_model_takes_fits() {
    for model in ["restitution", "han-2005", "mathavan-2010", "stronge", "factors"] {
        let cushion = format!(
            r#""cushion": {{"model": "{model}",
                "restitution": {{"a": 0.39, "b": 0.257, "c": -0.044, "lowest": 0.5, "highest": 0.8}},
                "friction": {{"a": 0.471, "b": -0.241}}}}"#
        );
        let shot = Shot::from_json(&edited(BASE, &cushion)).expect(model);
        let e = &shot.physics().cushion.restitution;
        let at = |v: f64| e.at(v);
        // The polynomial is 0.39, 0.603, 0.765 and −1.44.
        assert_eq!([at(0.0), at(6.5)], [0.5, 0.5], "{model}");
        assert!((at(1.0) - 0.603).abs() < 1e-15 && (at(2.5) - 0.7575).abs() < 1e-15, "{model}");
        assert!((shot.physics().cushion.friction.b + 0.241).abs() < 1e-15, "{model}");
    }
}

#[test]
fn limits_of_a_fit_that_contradict_each_other_are_refused() {
    let fit = |keys: &str| {
        format!(r#""cushion": {{"restitution": {{"a": 0.9, "b": -0.05, "c": 0, {keys}}}}}"#)
    };
    let place = |key: &str| format!("physics.cushion.restitution{key}");
    let both = r#""lowest": 0.9, "highest": 0.4"#;
    refused(BASE, &fit(both), &place(".lowest"), &["highest is 0.4", "lowest ≤ highest"]);
    refused(BASE, &fit(r#""highest": 1.1"#), &place(".highest"), &["1.1"]);
    refused(BASE, &fit(r#""lowest": -0.1"#), &place(".lowest"), &["-0.1"]);
    // A falling polynomial never reaches a range above its start.
    refused(BASE, &fit(r#""lowest": 0.95"#), &place(""), &["[0.95, 1] at every normal speed"]);
    Shot::from_json(&edited(BASE, &fit(r#""lowest": 0.5, "highest": 0.5"#))).expect("one value");
}

#[test]
fn a_fit_outside_0_to_1_at_every_speed_is_refused() {
    // The limits of the fit of `pool` are closer, so the file gives its own.
    let fit = |a: f64, b: f64, c: f64| {
        format!(
            r#""cushion": {{"model": "stronge", "restitution":
                {{"a": {a:?}, "b": {b:?}, "c": {c:?}, "lowest": 0, "highest": 1}}}}"#
        )
    };
    let place = "physics.cushion.restitution";
    // Constant, rising from above 1, falling from below 0, and two parabolas that never enter [0,
    // 1].
    for (a, b, c) in
        [(1.5, 0.0, 0.0), (1.5, 0.1, 0.0), (-0.5, -0.1, 0.0), (1.5, -0.2, 0.1), (-0.5, 0.2, -0.1)]
    {
        refused(BASE, &fit(a, b, c), place, &["[0, 1] at every normal speed"]);
    }
    for (a, b, c) in [(1.5, -0.1, 0.0), (1.24, -0.132, 0.0066), (-0.5, 0.2, 0.0), (2.0, 0.1, -0.1)]
    {
        Shot::from_json(&edited(BASE, &fit(a, b, c))).expect("a fit");
    }
}

#[test]
fn unbounded_cloth_has_no_other_keys() {
    let table = r#"{"width": 1.27, "length": 2.54, "pockets": "none"}"#;
    refused(table, r#"{"cloth": "unbounded", "length": 2}"#, "table.length", &["unbounded"]);
    refused(table, r#"{"cloth": "endless"}"#, "table.cloth", &["\"unbounded\""]);
    Shot::from_json(&edited(table, r#"{"cloth": "unbounded"}"#)).expect("unbounded cloth");
}

#[test]
fn bad_speed_bands_are_refused_with_their_place() {
    let bad = |bands: &str, place: &str, words: &[&str]| {
        let physics = format!(r#""cloth": {{"rolling_friction": {bands}}}"#);
        refused(BASE, &physics, &format!("physics.cloth.rolling_friction{place}"), words);
    };
    let last = r#"{"friction": 0.01}"#;
    bad("[]", "", &["a list of 0 bands", "write 1 to 16 bands, or a number"]);
    let band = |k: u32| format!(r#"{{"up_to": {k}, "friction": 0.01}}"#);
    let many: Vec<String> = (1..=16).map(band).collect();
    bad(&format!("[{}, {last}]", many.join(", ")), "", &["a list of 17 bands", "1 to 16"]);
    bad("{\"a\": 0.01}", "", &["an object", "a number ≥ 0, or a list of speed bands"]);
    bad("\"0.01\"", "", &["or a list of speed bands"]);
    bad(&format!("[0.01, {last}]"), "[0]", &["an object {...}"]);
    bad(&format!(r#"[{{"upto": 1, "friction": 0.01}}, {last}]"#), "[0].upto", &["`up_to`"]);
    bad(&format!(r#"[{{"up_to": 1}}, {last}]"#), "[0].friction", &["missing"]);
    bad(&format!("[{last}, {last}]"), "[0].up_to", &["has no end", "give the largest speed"]);
    bad(&format!("[{}]", band(1)), "[0].up_to", &["the last band ends at 1.0 m/s", "leave it out"]);
    let (one, two) = (band(1), band(2));
    bad(&format!("[{one}, {one}, {last}]"), "[1].up_to", &["not above", "sort the bands"]);
    bad(&format!("[{two}, {one}, {last}]"), "[1].up_to", &["1.0 m/s is not above", "2.0 m/s"]);
    for speed in ["0", "-1", "1e10", "null", "\"fast\""] {
        bad(&format!(r#"[{{"up_to": {speed}, "friction": 0.01}}, {last}]"#), "[0].up_to", &[]);
    }
    for friction in ["-0.01", "1e10", "null", "[0.01]"] {
        bad(&format!(r#"[{one}, {{"friction": {friction}}}]"#), "[1].friction", &[]);
    }
}

#[test]
fn a_vanishing_parameter_is_read_as_zero() {
    let hash = |section: &str, key: &str, value: &str| {
        let shot = Shot::from_json(&format!(
            r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "physics": {{"{section}": {{"{key}": {value}}}}},
                "balls": [{{"id": "a", "position": [0.3, 0.6], "velocity": [1, 2, 0], "angular_velocity": [1, 2, 30]}},
                          {{"id": "b", "position": [0.35, 0.7]}}], "max_events": 40}}"#
        ));
        let shot = shot.unwrap_or_else(|e| panic!("{section}.{key}: {e}"));
        // Without friction no ball comes to rest, and the cap ends the shot.
        shot.simulate().map_or(0, |trace| {
            let finite = |s: &carom::BallState| s.position.to_array().iter().all(|x| x.is_finite());
            assert!(trace.events().all(|e| e.before.iter().all(finite)), "{section}.{key} {value}");
            trace.hash()
        })
    };
    for (section, key) in [
        ("cloth", "sliding_friction"),
        ("cloth", "rolling_friction"),
        ("cloth", "spin_deceleration"),
        ("cushion", "friction"),
        ("cushion", "restitution"),
        ("ball_ball", "friction"),
        ("ball_ball", "restitution"),
    ] {
        let zero = hash(section, key, "0");
        for value in ["-0.0", "5e-324", "1e-308", "1e-200"] {
            assert_eq!(hash(section, key, value), zero, "{section}.{key} {value}");
        }
    }
}

#[test]
fn a_surface_that_does_not_exist_is_refused_with_the_known_ones() {
    let place = "physics.ball_ball.friction";
    refused(BASE, r#""ball_ball": {"friction": "used up"}"#, place, &["\"clean\"", "\"dirty\""]);
    let used =
        Shot::from_json(&edited(BASE, r#""ball_ball": {"friction": "used"}"#)).expect("used");
    assert_eq!(used.physics().ball_ball.friction, carom::physics::ball_surface::USED);
}

#[test]
fn a_track_names_balls_of_the_shot_and_has_times_that_increase() {
    let track = |text: &str, place: &str, words: &[&str]| {
        refused("1000", &format!("1000, \"track\": {text}"), place, words);
    };
    let ball = |samples: &str| format!(r#"[{{"ball": "1", "samples": {samples}}}]"#);
    let of = |samples: &str, place: &str, words: &[&str]| {
        track(&ball(samples), &format!("track[0].samples{place}"), words);
    };
    let cue = r#"{"ball": "cue", "samples": [[0, 1, 1]]}"#;
    track("{}", "track", &["a list of filmed balls"]);
    track(r#"[{"ball": "cue"}]"#, "track[0].samples", &["the key is missing"]);
    track(r#"[{"ball": "2", "samples": [[0, 1, 1]]}]"#, "track[0].ball", &["no ball has the id"]);
    track(&format!("[{cue}, {cue}]"), "track[1].ball", &["listed twice"]);
    track(r#"[{"ball": "1", "sample": []}]"#, "track[0].sample", &["`samples`"]);
    of("[]", "", &["found 0 samples", "1 to 10000"]);
    of("[[0, 1]]", "[0]", &["a list of 2", "[t, x, y]"]);
    of("[[0, 1, null]]", "[0][2]", &["null"]);
    of("[[0, 1, 1e10]]", "[0][2]", &["out of range"]);
    of("[[0, 1, 1], [0, 1, 1]]", "[1]", &["not after the sample before it"]);
    let many: Vec<String> = (0..=10_000).map(|t| format!("[{t}, 1, 1]")).collect();
    of(&format!("[{}]", many.join(",")), "", &["found 10001 samples"]);
}

#[test]
fn marks_have_the_keys_of_their_kind_and_bounded_sizes() {
    let marks = |text: &str, place: &str, words: &[&str]| {
        refused("1000", &format!("1000, \"marks\": {text}"), place, words);
    };
    let of = |rest: &str, place: &str, words: &[&str]| {
        marks(&format!(r#"[{{"color": "red", {rest}}}]"#), &format!("marks[0]{place}"), words);
    };
    let label = |text: &str, words: &[&str]| {
        of(&format!(r#""kind": "label", "at": [0, 1], "text": "{text}""#), ".text", words);
    };
    marks("{}", "marks", &["a list of marks"]);
    marks(r#"[{"kind": "line", "from": [0, 1], "to": [1, 1]}]"#, "marks[0].color", &["missing"]);
    of(r#""from": [0, 1]"#, ".kind", &["the key is missing"]);
    of(r#""kind": "star""#, ".kind", &["no kind of mark \"star\"", "circle"]);
    of(r#""kind": "line", "from": [0, 1]"#, ".to", &["the key is missing"]);
    of(r#""kind": "line", "from": [0, 1], "to": [1]"#, ".to", &[]);
    of(r#""kind": "line", "from": [0, 1], "to": [1, 1e10]"#, ".to[1]", &["out of range"]);
    of(r#""kind": "circle", "center": [0, 1], "radius": 0"#, ".radius", &["out of range"]);
    of(r#""kind": "circle", "center": [0, 1], "radius": 1, "to": [1, 1]"#, ".to", &["unknown key"]);
    of(
        r#""kind": "area", "outline": [[0, 1], [1, 1]]"#,
        ".outline",
        &["found 2 corners", "3 to 64"],
    );
    label("", &["found 0 characters"]);
    label(&"x".repeat(41), &["found 41 characters", "1 to 40"]);
    label("two\\nlines", &["a control character"]);
    let colored = r#"[{"kind": "label", "at": [0, 1], "text": "A", "color": "green"}]"#;
    marks(colored, "marks[0].color", &["no colour \"green\"", "yellow"]);
    let line = r#"{"kind": "line", "color": "red", "from": [0, 1], "to": [1, 1]}"#;
    marks(&format!("[{}]", vec![line; 101].join(",")), "marks", &["found 101 marks"]);
}
