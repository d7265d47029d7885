//! The defaults of a shot file, and the values that it takes from a base.

use carom::edition::PHYSICS;
use carom::format::Node;
use carom::physics::{BallBallModel, CushionModel, RollingFriction, Tip};
use carom::{Physics, Shot};

fn read(table: &str, physics: &str, balls: &str) -> Shot {
    let text =
        format!(r#"{{"format": "carom-shot/1", "table": {table}{physics}, "balls": [{balls}]}}"#);
    Shot::from_json(&text).unwrap_or_else(|e| panic!("{text}: {e}"))
}

const BALL: &str = r#"{"id": "cue", "position": [0.5, 0.5]}"#;

#[test]
fn the_default_physics_is_that_of_the_table_and_pool_for_a_table_without_one() {
    for (table, physics) in [
        ("\"wpa-9ft\"", "pool"),
        ("\"bar-7ft\"", "pool"),
        ("\"snooker-12ft\"", "snooker"),
        ("\"english-7ft\"", "english"),
        ("\"carom-10ft\"", "carom"),
        (r#"{"base": "snooker-12ft", "cushion_height": 0.036}"#, "snooker"),
        (r#"{"cloth": "unbounded"}"#, "pool"),
        (r#"{"length": 2.0, "width": 1.0, "pockets": "none"}"#, "pool"),
    ] {
        let expected = Physics::preset(physics).expect("a preset");
        assert_eq!(**read(table, "", BALL).physics(), expected, "{table}");
        assert_eq!(**read(table, r#", "physics": {}"#, BALL).physics(), expected, "{table}");
        let changed = read(table, r#", "physics": {"gravity": 1.62}"#, BALL);
        assert_eq!(**changed.physics(), Physics { gravity: 1.62, ..expected }, "{table}");
        let ideal = read(table, r#", "physics": {"base": "ideal"}"#, BALL);
        assert_eq!(**ideal.physics(), Physics::ideal(), "{table}");
    }
}

#[test]
fn one_key_of_a_section_leaves_the_others_as_in_the_base() {
    let shot = read("\"wpa-9ft\"", r#", "physics": {"cloth": {"rolling_friction": 0.02}}"#, BALL);
    let mut expected = Physics::pool();
    expected.cloth.rolling_friction = RollingFriction::constant(0.02);
    assert_eq!(**shot.physics(), expected);
}

/// The physics of `changes`, a section of the physics file, over `base`.
fn over(base: &str, changes: &str) -> Physics {
    let physics = format!(r#", "physics": {{"base": "{base}", {changes}}}"#);
    read("\"wpa-9ft\"", &physics, BALL).physics().as_ref().clone()
}

#[test]
fn another_model_keeps_every_value_and_every_whole_fit_of_its_base() {
    for base in PHYSICS.iter().map(|edition| edition.dated) {
        let own = Physics::preset(base).expect("a preset").to_node();
        for (section, models) in [
            ("cushion", CushionModel::ALL.map(CushionModel::name).to_vec()),
            ("ball_ball", BallBallModel::ALL.map(BallBallModel::name).to_vec()),
        ] {
            for model in models {
                let mut values = own.get(section).expect("a section").clone();
                values.set("model", model);
                if model == "elastic" {
                    // The exception that docs/formats.md names.
                    values.set("restitution", 1.0);
                }
                let mut expected = own.clone();
                expected.set(section, values);
                let changed = over(base, &format!(r#""{section}": {{"model": "{model}"}}"#));
                assert_eq!(changed.to_node(), expected, "{section} of {base} as {model}");
            }
        }
    }
}

#[test]
fn the_rails_of_pool_lose_energy_in_every_model() {
    for model in ["restitution", "han-2005", "mathavan-2010", "stronge", "factors"] {
        let cushion = over("pool", &format!(r#""cushion": {{"model": "{model}"}}"#)).cushion;
        assert!(cushion.restitution.at(2.0) < 0.95, "{model}");
    }
}

#[test]
fn one_number_of_a_fit_leaves_the_others_as_in_the_base() {
    for (base, section, fit) in [
        ("snooker", "cushion", "restitution"),
        ("carom", "cushion", "friction"),
        ("pool", "ball_ball", "friction"),
    ] {
        let own = Physics::preset(base).expect("a preset").to_node();
        let Some(Node::Object(numbers)) = own.get(section).and_then(|s| s.get(fit)) else {
            panic!("{base} has no fit of {section}.{fit}");
        };
        for (key, value) in numbers {
            let Node::Number(x) = value else { panic!("{key}: {value:?}") };
            let new = 0.99 * x;
            let mut expected = own.clone();
            let mut values = own.get(section).expect("a section").clone();
            let mut changed = Node::Object(numbers.clone());
            changed.set(key, new);
            values.set(fit, changed);
            expected.set(section, values);
            let written = format!(r#""{section}": {{"{fit}": {{"{key}": {new:?}}}}}"#);
            assert_eq!(over(base, &written).to_node(), expected, "{base} {key}");
        }
    }
}

#[test]
fn writing_one_of_tip_restitution_and_tip_efficiency_drops_the_other() {
    let cue = |text: &str| {
        let physics = format!(r#", "physics": {{"cue": {{{text}}}}}"#);
        read("\"wpa-9ft\"", &physics, BALL).physics().cue.tip
    };
    assert_eq!(cue(""), Physics::pool().cue.tip);
    assert_eq!(cue(r#""tip_efficiency": 0.87"#), Tip::Efficiency(0.87));
    assert_eq!(cue(r#""tip_restitution": 0.8"#), Tip::Restitution(0.8));
}

#[test]
fn by_default_a_ball_is_the_physics_ball_at_rest_on_the_cloth() {
    let shot = read("\"snooker-12ft\"", "", BALL);
    let ball = &shot.balls()[0];
    assert_eq!(ball.ball, Physics::snooker().ball);
    assert_eq!(ball.state.position.z, Physics::snooker().ball.radius);
    assert_eq!(ball.state.velocity.length() + ball.state.angular_velocity.length(), 0.0);
    let shot = read(
        "\"snooker-12ft\"",
        "",
        r#"{"id": "big", "position": [0.5, 0.5], "radius": 0.03, "mass": 0.2}"#,
    );
    assert_eq!(shot.balls()[0].state.position.z, 0.03);
    assert_eq!(shot.balls()[0].ball.mass, 0.2);
}

#[test]
fn a_shot_without_a_strike_starts_with_the_balls_own_velocities_and_lists_no_strike() {
    let moving = r#"{"id": "a", "position": [0.5, 0.5], "velocity": [0.0, 1.0, 0.0]}"#;
    let trace = read(r#"{"cloth": "unbounded"}"#, "", moving).simulate().expect("it rolls out");
    let kinds: Vec<_> = trace.events().map(|e| e.kind).collect();
    assert!(!kinds.is_empty() && kinds.iter().all(|kind| kind.name() != "cue-strike"), "{kinds:?}");
}

#[test]
fn other_balls_may_move_when_the_cue_strikes() {
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "cue", "position": [0, 0]},
                  {"id": "1", "position": [3, 0], "velocity": [0, 1, 0]}],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 0}}"#;
    let shot = Shot::from_json(text).expect("a good file");
    assert_eq!(shot.max_events(), 100_000);
    shot.simulate().expect("it ends");
}

#[test]
fn a_ball_may_lie_in_a_pockets_mouth_but_not_over_its_hole() {
    let at = |x: f64, y: f64| {
        let ball = format!(r#"{{"id": "cue", "position": [{x:?}, {y:?}]}}"#);
        let text =
            format!(r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{ball}]}}"#);
        Shot::from_json(&text)
    };
    // On the bisector of the bottom left corner: nearer to both nose lines than a rail would allow.
    at(0.02, 0.02).expect("in the mouth, before the hole");
    let sentence = at(-0.03, -0.03).expect_err("over the hole").to_string();
    assert!(sentence.contains("bottom-left pocket"), "{sentence}");
    let sentence = at(0.02, 0.4).expect_err("in the left rail").to_string();
    assert!(sentence.contains("cushion"), "{sentence}");
}
