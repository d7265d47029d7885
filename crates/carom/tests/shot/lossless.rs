//! A shot file is read and written without losing anything, and means the same either way.

use carom::shot::{Node, physics_to_node};
use carom::{Physics, Shot};

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

/// [`SHOT`] at rest, so that it may be struck.
fn at_rest() -> Shot {
    shot(&SHOT.replace(r#", "angular_velocity": [0, -0.0, 1e-17]"#, ""))
}

#[test]
fn json_in_json_out_keeps_every_number_and_word() {
    let moving = SHOT.replace(
        r#""strike": {"ball": "1", "speed": 2, "azimuth_deg": 359.99999999999994, "side": 0.1},"#,
        "",
    );
    for first in [at_rest(), shot(&moving)] {
        let again = shot(&first.to_json());
        assert_eq!(first, again);
        assert_eq!(first.to_node(), again.to_node());
        assert_eq!(first.to_json(), again.to_json());
    }
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
fn what_is_left_out_comes_from_the_preset_of_the_table() {
    let shot = at_rest();
    let pool = Physics::pool();
    let physics = shot.physics();
    assert_eq!(physics.cloth.rolling_friction, 0.011);
    assert_eq!(physics.cloth.sliding_friction, pool.cloth.sliding_friction);
    assert_eq!(physics.cushion, pool.cushion);
    assert_eq!(physics.cue.tip, carom::physics::Tip::Efficiency(0.87), "it drops the restitution");
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
            let mut node = physics_to_node(&physics);
            node.set("base", base);
            // Physics with other balls: z follows the radius.
            let mut file =
                shot(&at_rest().to_json().replace(", 0.028575]", "]")).to_node().into_owned();
            file.set("physics", node);
            let read = Shot::from_node(file).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(**read.physics(), physics);
        }
    }
}

#[test]
fn another_strike_is_kept_in_the_file() {
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
fn other_balls_on_the_same_table_are_what_a_file_with_them_would_be() {
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
    let mut flown = balls;
    flown[0].state.velocity.x = f64::NAN;
    assert!(refused(flown).starts_with("balls[0].velocity: NaN m/s is out of range"));
    assert!(refused(Vec::new()).starts_with("balls: found 0 balls"));
}
