//! Shot files are read and written without losing a bit or a word.

use carom::format::{FilmedBall, KeyPath, MarkColor, MarkShape, Node, TableMark};
use carom::resolve::cue_ball::Strike;
use carom::{Physics, Shot, ShotFile};

const SHOT: &str = r#"{
    "format": "carom-shot/1",
    "table": {"base": "wpa-9ft", "pocket_model": "mouth-line"},
    "physics": {"cloth": {"rolling_friction": 0.011}, "cue": {"tip_efficiency": 0.87}},
    "balls": [
        {"id": "cue \"ä\" \\ \u0001", "position": [0.1234567890123456789, 0.3], "mass": 0.17},
        {"id": "1", "position": [0.7, 1, 0.028575], "angular_velocity": [0, -0.0, 1e-17]}
    ],
    "strike": {"ball": "1", "speed": 2, "azimuth_deg": 359.99999999999994, "side": 0.1},
    "max_events": 77
}"#;

#[track_caller]
fn shot(text: &str) -> Shot {
    Shot::from_json(text).unwrap_or_else(|e| panic!("{e}"))
}

/// The spin of ball 1 of [`SHOT`], which cannot be struck with it.
const SPIN: &str = r#", "angular_velocity": [0, -0.0, 1e-17]"#;

/// [`SHOT`] without the spin, so that its ball can be struck.
fn at_rest() -> Shot {
    shot(&SHOT.replace(SPIN, ""))
}

#[test]
fn a_shot_file_is_written_back_with_every_number_and_word() {
    let moving = SHOT.replace(
        r#""strike": {"ball": "1", "speed": 2, "azimuth_deg": 359.99999999999994, "side": 0.1},"#,
        "",
    );
    let level = SHOT.replace(SPIN, "").replace(r#""side""#, r#""elevation_deg": 0, "side""#);
    for text in [level, moving] {
        let file = ShotFile::from_json(&text).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(*file.to_node(), Node::from_json(&text).unwrap_or_else(|e| panic!("{e}")));
        let again = ShotFile::from_json(&file.to_json()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(file, again);
        assert_eq!(file.to_json(), again.to_json());
    }
}

#[test]
fn a_shot_written_from_its_data_reads_back_as_the_same_shot() {
    let moving = SHOT.replace(
        r#""strike": {"ball": "1", "speed": 2, "azimuth_deg": 359.99999999999994, "side": 0.1},"#,
        "",
    );
    let slipping = SHOT.replace(SPIN, "").replace(
        r#""side": 0.1"#,
        r#""side": 0.55, "miscue": "report", "obstruction": "refuse", "elevation": 0.5"#,
    );
    let plain = |table: &str, physics: &str| {
        format!(
            r#"{{"format": "carom-shot/1", "table": {table}, "physics": {physics},
            "balls": [{{"id": "a", "position": [0.5, 0.5]}}]}}"#
        )
    };
    let mut texts = vec![SHOT.replace(SPIN, ""), moving, slipping];
    texts.push(plain(r#"{"cloth": "unbounded"}"#, r#""ideal""#));
    texts.push(plain(r#"{"length": 2, "width": 1}"#, r#"{"gravity": 9.5}"#));
    texts.push(plain(
        r#"{"length": 2, "width": 1, "sights": {"along_length": 8, "along_width": 4, "setback": 0.09},
            "markings": {"head_string": 0.5, "spots": [{"name": "head", "position": [0.5, 0.5]}]}}"#,
        r#"{"base": "snooker", "ball_ball": {"model": "compliant"}}"#,
    ));
    for name in carom::table::PRESETS {
        texts.push(plain(&format!("\"{name}\""), r#""carom""#));
        texts.push(plain(&format!(r#"{{"base": "{name}", "rail_width": 0.2}}"#), r#""pool""#));
    }
    for text in texts {
        let first = shot(&text);
        let again = shot(&first.to_json());
        assert_eq!((&first, first.to_json()), (&again, again.to_json()), "{text}");
        let bits = |shot: &Shot| shot.simulate().map(|trace| trace.hash());
        assert_eq!(bits(&first), bits(&again), "{text}");
    }
}

#[test]
fn a_shot_written_from_its_data_names_presets_and_leaves_out_default_values() {
    let text = r#"{"format": "carom-shot/1", "table": {"base": "wpa-9ft"}, "physics": "pool",
        "balls": [{"id": "cue", "position": [0.5, 0.5, 0.028575], "mass": 0.170097138}], "max_events": 100000}"#;
    let named = r#"{"format": "carom-shot/1", "table": "wpa-9ft", "physics": "pool",
        "balls": [{"id": "cue", "position": [0.5, 0.5]}], "max_events": 100000}"#;
    let written = shot(named).to_node();
    let keys = |node: &Node| match node {
        Node::Object(fields) => fields.iter().map(|(key, _)| key.clone()).collect(),
        _ => Vec::new(),
    };
    assert_eq!(keys(&written), ["format", "table", "balls"]);
    assert_eq!(written.get("table"), Some(&"wpa-9ft".into()));
    assert!(shot(text).to_node().get("max_events").is_none());
}

#[test]
fn every_angle_that_a_program_sets_reads_back_to_the_same_bits() {
    let file = ShotFile::from_json(&SHOT.replace(SPIN, "")).unwrap_or_else(|e| panic!("{e}"));
    let (_, own) = file.strike().expect("it has one");
    // No double in degrees reads back as the first angle; the second is 12.25 degrees.
    for (azimuth, key) in
        [(-1.822_407_699_024_793, "azimuth"), (carom::math::radians(12.25), "azimuth_deg")]
    {
        let strike = Strike { azimuth, elevation: 0.123_456_789, ..own };
        let changed = file.with_strike(&strike).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(changed.strike(), Some((1, strike)));
        for text in [changed.to_json(), changed.shot().to_json()] {
            let (_, read) = shot(&text).strike().expect("it has one");
            assert_eq!(read.azimuth.to_bits(), azimuth.to_bits());
            assert_eq!(read.elevation.to_bits(), strike.elevation.to_bits());
        }
        let written = changed.to_node().get("strike").cloned().expect("a strike");
        assert!(written.get(key).is_some(), "{written:?}");
        let both = written.get("azimuth").is_some() && written.get("azimuth_deg").is_some();
        assert!(!both, "{written:?}");
    }
}

#[test]
fn angles_in_radians_mean_the_same_as_in_degrees() {
    let read = |strike: &str| {
        let text = SHOT.replace(SPIN, "").replace(r#""azimuth_deg": 359.99999999999994"#, strike);
        shot(&text).strike().expect("it has one").1
    };
    let degrees = read(r#""azimuth_deg": 90, "elevation_deg": 45"#);
    let radians = read(r#""azimuth": 1.5707963267948966, "elevation": 0.7853981633974483"#);
    assert_eq!(degrees, radians);
    assert_eq!(read(r#""azimuth": 0.3, "elevation_deg": 45"#).elevation, radians.elevation);
}

#[test]
fn bits_survive_including_the_sign_of_zero() {
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "a", "position": [5e-324, -0.0], "velocity": [-0.0, 1e-300, 0]}]}"#;
    let state = shot(&shot(text).to_json()).balls()[0].state;
    assert_eq!(state.position.x.to_bits(), 1);
    assert_eq!(state.position.y.to_bits(), (-0.0f64).to_bits());
    assert_eq!(state.velocity.x.to_bits(), (-0.0f64).to_bits());
    assert_eq!(state.velocity.y.to_bits(), 1e-300f64.to_bits());
}

#[test]
fn missing_values_come_from_the_preset_of_the_table() {
    let shot = at_rest();
    let pool = Physics::pool();
    let physics = shot.physics();
    assert_eq!(physics.cloth.rolling_friction.as_constant(), Some(0.011));
    assert_eq!(physics.cloth.sliding_friction, pool.cloth.sliding_friction);
    assert_eq!(physics.cushion, pool.cushion);
    assert_eq!(
        physics.cue.tip,
        carom::physics::Tip::Efficiency(0.87),
        "instead of the restitution"
    );
    assert_eq!(shot.balls()[0].ball.mass, 0.17);
    assert_eq!(shot.balls()[0].ball.radius, pool.ball.radius);
    assert_eq!(shot.balls()[0].state.position.z, pool.ball.radius);
    let on = |table: &str| {
        let text = format!(
            r#"{{"format": "carom-shot/1", "table": "{table}", "balls": [{{"id": "a", "position": [0.5, 0.5]}}]}}"#
        );
        self::shot(&text).physics().as_ref().clone()
    };
    assert_eq!(on("snooker-12ft"), Physics::snooker());
    assert_eq!(on("carom-10ft"), Physics::carom());
    assert_eq!(on("english-7ft"), Physics::english());
    assert_eq!(on("showood-7ft"), pool);
}

#[test]
fn every_table_preset_may_be_named_or_be_a_base() {
    for name in carom::table::PRESETS {
        let on = |table: &str| {
            shot(&format!(
                r#"{{"format": "carom-shot/1", "table": {table}, "balls": [{{"id": "a", "position": [0.5, 0.5]}}]}}"#
            ))
        };
        let named = on(&format!("\"{name}\""));
        let based = on(&format!("{{\"base\": \"{name}\"}}"));
        assert_eq!(named.table().description, based.table().description, "{name}");
        assert_eq!(named.physics(), based.physics(), "{name}");
    }
}

#[test]
fn a_physics_written_out_reads_back_over_any_base() {
    let mut fitted = Physics::carom();
    fitted.cushion.model = carom::physics::CushionModel::Han2005;
    for physics in Physics::PRESETS.iter().filter_map(|n| Physics::preset(n)).chain([fitted]) {
        for base in Physics::PRESETS {
            let mut node = physics.to_node();
            node.set("base", base);
            // Physics with other balls: z follows the radius.
            let text = SHOT.replace(SPIN, "").replace(", 0.028575]", "]");
            let mut file = Node::from_json(&text).unwrap_or_else(|e| panic!("{e}"));
            file.set("physics", node);
            let read = Shot::from_node(&file).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(**read.physics(), physics);
        }
    }
}

#[test]
fn with_strike_writes_the_strike_into_the_file() {
    let shot = at_rest();
    let (ball, mut strike) = shot.strike().expect("it has one");
    assert_eq!(ball, 1);
    strike.azimuth = carom::math::radians(12.25);
    strike.height = -0.2;
    let changed = shot.with_strike(&strike).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(changed.strike(), Some((1, strike)));
    let written = changed.to_node().get("strike").and_then(|s| s.get("azimuth_deg")).cloned();
    assert_eq!(written, Some(Node::Number(12.25)));
    strike.side = 0.9;
    let sentence = shot.with_strike(&strike).expect_err("a miscue").to_string();
    assert!(sentence.starts_with("strike.side: a miscue"), "{sentence}");
}

#[test]
fn with_balls_gives_the_shot_of_a_file_with_these_balls() {
    let shot = at_rest();
    let (_, mut strike) = shot.strike().expect("it has one");
    strike.azimuth = 0.7;
    let mut balls = shot.balls().to_vec();
    balls[0].state.position.x += 0.1;
    balls[1].ball.mass = 0.2;
    balls.swap(0, 1);
    let changed =
        shot.with_balls(balls.clone(), Some((0, strike))).unwrap_or_else(|e| panic!("{e}"));
    let read = Shot::from_json(&changed.to_json()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(changed, read);
    assert_eq!(changed.to_json(), read.to_json());
    let played = |shot: &Shot| shot.simulate().unwrap_or_else(|e| panic!("{e}")).hash();
    assert_eq!(played(&changed), played(&read));

    let unstruck = shot.with_balls(balls.clone(), None).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(unstruck.to_node().get("strike"), None);
    assert_eq!(unstruck.strike(), None);

    let refused = |balls| shot.with_balls(balls, None).expect_err("it is wrong").to_string();
    let mut twice = balls.clone();
    twice[1].id = twice[0].id.clone();
    assert!(refused(twice).starts_with("balls[1].id: "));
    let mut outside = balls.clone();
    outside[1].state.position.x = -1.0;
    assert!(refused(outside).starts_with("balls[1].position: the ball is outside"));
    let mut sunk = balls.clone();
    sunk[1].state.position.z = 0.02;
    assert!(refused(sunk).starts_with("balls[1].position: the ball is "));
    let mut heavy = balls.clone();
    heavy[0].ball.mass = f64::INFINITY;
    assert!(refused(heavy).starts_with("balls[0].mass: an infinite number is not a number"));
    let mut lost = balls.clone();
    lost[1].state.position.y = f64::NAN;
    assert!(refused(lost).starts_with("balls[1].position: NaN is not a number"));
    let no_such_ball = shot.with_balls(balls.clone(), Some((2, strike))).expect_err("no such ball");
    assert!(
        no_such_ball.to_string().starts_with("strike.ball: there is no ball 2; count the 2 balls")
    );
    let mut flown = balls;
    flown[0].state.velocity.x = f64::NAN;
    assert!(refused(flown).starts_with("balls[0].velocity: NaN m/s is out of range"));
    assert!(refused(Vec::new()).starts_with("balls: found 0 balls"));
}

#[test]
fn speed_bands_keep_their_bits_and_replace_those_of_the_base() {
    let bands = r#"[{"up_to": 0.1, "friction": 0.3}, {"up_to": 0.7000000000000001, "friction": 0.0045},
        {"friction": 1e-149}]"#;
    let read = |friction: &str| {
        let file = format!(
            r#"{{"format": "carom-shot/1", "table": "carom-10ft",
                "physics": {{"base": "carom", "cloth": {{"rolling_friction": {friction}}}}},
                "balls": [{{"id": "a", "position": [0.5, 0.5], "velocity": [1, 0, 0]}}]}}"#
        );
        ShotFile::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
    };
    let shot = read(bands);
    let again = ShotFile::from_json(&shot.to_json()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(again.physics(), shot.physics());
    let path = KeyPath::parse("physics").unwrap_or_else(|e| panic!("{e}"));
    let whole = shot.physics().to_node();
    let written = shot.with_values([(&path, whole)]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(written.physics(), shot.physics());
    let number = KeyPath::parse("physics.cloth.rolling_friction").unwrap_or_else(|e| panic!("{e}"));
    let plain = shot.with_values([(&number, 0.02.into())]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(plain.physics(), read("0.02").physics());
    let one = KeyPath::parse("physics.cloth.rolling_friction[1].friction");
    let one = one.unwrap_or_else(|e| panic!("{e}"));
    let changed = shot.with_values([(&one, 0.006.into())]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(changed.physics(), read(&bands.replace("0.0045", "0.006")).physics());
}

#[test]
fn a_track_stays_in_the_file_and_changes_nothing_in_the_shot() {
    let bare = ShotFile::from_json(&SHOT.replace(SPIN, "")).unwrap();
    assert!(bare.track().is_empty());
    let samples = vec![[-0.04, 0.7, 1.0], [0.0, 0.7, 1.0], [0.04, 0.71, 1.000_01]];
    let track = [FilmedBall { ball: "1".into(), samples }];
    let filmed = bare.with_track(&track).unwrap();
    assert_eq!(filmed, bare);
    assert_eq!(filmed.simulate().unwrap().hash(), bare.simulate().unwrap().hash());
    let again = ShotFile::from_json(&filmed.to_json()).unwrap();
    assert_eq!(again.track(), track);
    assert_eq!(again.to_json(), filmed.to_json());
    let strike = Strike { speed: 1.0, ..again.strike().unwrap().1 };
    assert_eq!(again.with_strike(&strike).unwrap().track(), track);
    assert!(again.with_track(&[]).unwrap().track().is_empty());
    let other = [FilmedBall { ball: "2".into(), samples: vec![[0.0, 1.0, 1.0]] }];
    assert!(bare.with_track(&other).is_err());
}

#[test]
fn marks_stay_in_the_file_and_change_nothing_in_the_shot() {
    let bare = ShotFile::from_json(&SHOT.replace(SPIN, "")).unwrap();
    assert!(bare.marks().is_empty());
    let (from, to) = ([0.1, 0.2], [0.635, 1.270_01]);
    let label = MarkShape::Label { at: from, text: "½ Ball: 左塞".into() };
    let marks = [
        TableMark { shape: MarkShape::Line([from, to]), color: MarkColor::White },
        TableMark { shape: MarkShape::Arrow([to, from]), color: MarkColor::Yellow },
        TableMark { shape: MarkShape::Circle { center: to, radius: 0.1 }, color: MarkColor::Red },
        TableMark { shape: MarkShape::Area(vec![from, to, [1.0, -0.1]]), color: MarkColor::Blue },
        TableMark { shape: label, color: MarkColor::White },
    ];
    let marked = bare.with_marks(&marks).unwrap();
    assert_eq!(marked, bare);
    assert_eq!(marked.simulate().unwrap().hash(), bare.simulate().unwrap().hash());
    let again = ShotFile::from_json(&marked.to_json()).unwrap();
    assert_eq!(again.marks(), marks);
    assert_eq!(again.to_json(), marked.to_json());
    let strike = Strike { speed: 1.0, ..again.strike().unwrap().1 };
    assert_eq!(again.with_strike(&strike).unwrap().marks(), marks);
    assert!(again.with_marks(&[]).unwrap().marks().is_empty());
    let other = MarkShape::Circle { center: from, radius: -1.0 };
    assert!(bare.with_marks(&[TableMark { shape: other, color: MarkColor::Red }]).is_err());
}
