//! The elevation of a strike that gives none: the least angle of a real stroke at which the cue
//! clears the rails and the other balls.

use carom::batch::{simulate_at_own_elevation, simulate_strikes};
use carom::format::{DefaultElevation, KeyPath, Node, PresetNames};
use carom::math::{degrees, radians};
use carom::noise::{Noise, Perception, StruckBall};
use carom::rack::{Break, Game, break_shot};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, Physics, Shot, ShotFile};

/// Rounding error of an angle in degrees.
const ROUNDING: f64 = 1e-12;

const UP: f64 = core::f64::consts::FRAC_PI_2;

/// A shot on a pool table with the cue ball `y` m from the bottom rail.
fn file(y: f64, strike: &str, others: &str, physics: &str) -> Result<ShotFile, Error> {
    ShotFile::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "physics": {physics},
            "balls": [{{"id": "cue", "position": [0.635, {y}]}}{others}],
            "strike": {{"ball": "cue", "speed": 2, "azimuth_deg": 90{strike}}}}}"#
    ))
}

fn shot(y: f64, strike: &str, others: &str) -> ShotFile {
    file(y, strike, others, r#""pool""#).unwrap_or_else(|e| panic!("{e}"))
}

/// The elevation that is used, in degrees.
fn elevation(shot: &Shot) -> f64 {
    degrees(shot.strike().expect("a strike").1.elevation)
}

/// A ball 150 mm behind a cue ball in the middle of the table.
const BEHIND: &str = r#", {"id": "8", "position": [0.635, 1.12]}"#;

#[test]
fn a_strike_from_the_middle_of_the_table_has_the_elevation_of_a_real_stroke() {
    let free = shot(1.27, "", "");
    assert_eq!(elevation(&free), 3.0);
    assert!(free.has_default_elevation());
    for (elevation_key, expected) in
        [(r#", "elevation_deg": 0"#, 0.0), (r#", "elevation": 0.1"#, 0.1)]
    {
        let given = shot(1.27, elevation_key, "");
        assert_eq!(given.strike().expect("a strike").1.elevation, expected);
        assert!(!given.has_default_elevation());
    }
}

#[test]
fn a_strike_near_a_rail_or_a_ball_has_the_least_elevation_that_clears_it() {
    for (y, others) in [(0.06, ""), (1.27, BEHIND), (0.028, "")] {
        let made = shot(y, "", others);
        let least = degrees(made.least_elevation().expect("there is one"));
        assert!(least > 10.0, "{least}");
        assert!((elevation(&made) - least).abs() < ROUNDING, "{least}");
        assert_eq!(made.cue_obstruction(), None);
        // A cue that is not raised as far passes through the obstacle.
        let lower = format!(r#", "elevation_deg": {:?}"#, least - 0.05);
        assert!(shot(y, &lower, others).cue_obstruction().is_some(), "{y}");
    }
}

#[test]
fn the_default_elevation_depends_on_the_tip_offset() {
    // The axis is higher above the rail by the height of the tip.
    let [low, middle, high] =
        [-0.3, 0.0, 0.3].map(|h| elevation(&shot(0.06, &format!(r#", "height": {h}"#), "")));
    assert!(low > middle + 5.0 && middle > high + 5.0, "{low} {middle} {high}");
    let beside = |side: f64| elevation(&shot(1.27, &format!(r#", "side": {side}"#), BEHIND));
    assert!(beside(0.5) < beside(0.0), "the cue passes the ball off its centre");
}

#[test]
fn a_default_elevation_is_never_obstructed_unless_every_angle_is() {
    let mut seed = 5_u64;
    let mut unit = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut raised, mut blocked) = (0, 0);
    for _ in 0..4000 {
        let mut ball = |id: &str| {
            let (x, y) = (0.03 + 1.21 * unit(), 0.03 + 0.3 * unit());
            format!(r#"{{"id": "{id}", "position": [{x:?}, {y:?}]}}"#)
        };
        let balls = ["cue", "1", "2", "3"].map(&mut ball).join(", ");
        let [azimuth, side, height] = [360.0 * unit(), unit() - 0.5, 0.6 * unit() - 0.3];
        let Ok(shot) = Shot::from_json(&format!(
            r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{balls}],
                "strike": {{"ball": "cue", "speed": 1, "azimuth_deg": {azimuth:?},
                            "side": {side:?}, "height": {height:?}}}}}"#
        )) else {
            continue;
        };
        let angle = elevation(&shot);
        raised += u32::from(angle > 3.0);
        if shot.cue_obstruction().is_some() {
            blocked += 1;
            assert_eq!(angle, 3.0, "{}", shot.to_json());
            let least = shot.least_elevation();
            assert!(least.is_none_or(|least| degrees(least) > 80.0), "{}", shot.to_json());
        }
    }
    assert!(raised > 300 && blocked < 20, "{raised} raised, {blocked} blocked");
}

#[test]
fn poolfiz_ideal_and_unbounded_cloth_have_a_level_cue() {
    for name in Physics::PRESETS {
        let made = file(0.06, "", "", &format!("\"{name}\"")).unwrap_or_else(|e| panic!("{e}"));
        let is_level = matches!(name, "poolfiz" | "ideal");
        assert_eq!(elevation(&made) == 0.0, is_level, "{name}");
        let free = file(1.27, "", "", &format!("\"{name}\"")).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(elevation(&free), if is_level { 0.0 } else { 3.0 }, "{name}");
    }
    let unbounded = Shot::from_json(
        r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
            "balls": [{"id": "cue", "position": [0, 0]}, {"id": "1", "position": [0, -0.1]}],
            "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 90}}"#,
    );
    assert_eq!(elevation(&unbounded.expect("a shot")), 0.0);
}

#[test]
fn the_least_elevation_of_a_stroke_is_a_parameter_of_the_cue() {
    let with = |cue: &str| file(1.27, "", "", &format!(r#"{{"cue": {{{cue}}}}}"#));
    for (cue, expected) in [
        (r#""stroke_elevation_deg": 7.5"#, 7.5),
        (r#""stroke_elevation": 0.1"#, degrees(0.1)),
        (r#""stroke_elevation_deg": 0"#, 0.0),
    ] {
        let made = with(cue).unwrap_or_else(|e| panic!("{e}"));
        assert!((elevation(&made) - expected).abs() < ROUNDING, "{cue}");
        let again = Shot::from_json(&made.shot().to_json()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(again.physics().cue, made.physics().cue, "{cue}");
    }
    for (cue, place, why) in [
        (r#""stroke_elevation_deg": 90"#, "physics.cue.stroke_elevation_deg", "[0, 90) degrees"),
        (r#""stroke_elevation_deg": -1"#, "physics.cue.stroke_elevation_deg", "[0, 90) degrees"),
        (r#""stroke_elevation": 1.6"#, "physics.cue.stroke_elevation", "out of range"),
        (
            r#""stroke_elevation": 0.1, "stroke_elevation_deg": 5"#,
            "physics.cue.stroke_elevation",
            "stroke_elevation_deg gives the same angle",
        ),
    ] {
        let sentence = with(cue).expect_err(cue).to_string();
        assert!(sentence.starts_with(&format!("{place}: ")), "{sentence}");
        assert!(sentence.contains(why), "{sentence}");
    }
    // The angle in the other unit is replaced.
    let degrees_key = KeyPath::parse("physics.cue.stroke_elevation_deg").expect("a path");
    let made = with(r#""stroke_elevation": 0.1"#).unwrap_or_else(|e| panic!("{e}"));
    let changed = made.with_values([(&degrees_key, Node::Number(4.0))]);
    assert_eq!(elevation(&changed.unwrap_or_else(|e| panic!("{e}"))), 4.0);
}

#[test]
fn what_is_written_always_has_the_elevation_that_was_used() {
    for (strike, expected) in
        [("", 3.0), (r#", "elevation_deg": 0"#, 0.0), (r#", "side": 0.2"#, 3.0)]
    {
        let made = shot(1.27, strike, "");
        let trace = made.simulate().unwrap_or_else(|e| panic!("{e}"));
        for node in [
            made.to_node().into_owned(),
            made.shot().to_node(),
            trace.to_node().get("shot").cloned().expect("a shot"),
        ] {
            let written = node.get("strike").and_then(|s| s.get("elevation_deg").cloned());
            let found = match written {
                Some(Node::Number(angle)) => angle,
                Some(Node::Integer(angle)) => angle as f64,
                other => panic!("{other:?}"),
            };
            assert_eq!(found, expected, "{strike}");
            let again = Shot::from_node(&node).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(again, *made.shot());
            assert!(!again.has_default_elevation());
        }
    }
    // The source reads back with the default elevation.
    let made = shot(1.27, "", "");
    let source =
        |shot: &ShotFile| shot.written(DefaultElevation::Omitted, PresetNames::AsRead).into_owned();
    assert!(Shot::from_node(&source(&made)).is_ok_and(|s| s.has_default_elevation()));
    let given = shot(1.27, r#", "elevation_deg": 0"#, "");
    assert_eq!(source(&given), *given.to_node());
}

#[test]
fn a_default_elevation_follows_the_aim_and_the_balls_and_a_given_one_does_not() {
    let (default, given) = (shot(0.06, "", ""), shot(0.06, r#", "elevation_deg": 20"#, ""));
    let (_, own) = default.strike().expect("a strike");
    let turned = Strike { azimuth: 0.0, ..own };
    assert_eq!(degrees(default.at_own_elevation(&turned).elevation), 3.0);
    assert_eq!(degrees(given.at_own_elevation(&turned).elevation), 20.0);
    let again = default.with_default_elevation(&turned).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(elevation(&again), 3.0);
    assert!(again.has_default_elevation());
    let kept = default.with_strike(&turned).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(elevation(&kept), elevation(&default));
    assert!(!kept.has_default_elevation());

    let mut balls = default.balls().to_vec();
    balls[0].state.position.y = 1.27;
    let moved = |shot: &Shot| elevation(&shot.with_layout(balls.clone()).expect("a shot"));
    assert_eq!((moved(&default), moved(&given)), (3.0, 20.0));

    let place = KeyPath::parse("balls[0].position").expect("a path");
    let values = [(&place, Node::list([0.635, 1.27]))];
    let read = |file: &ShotFile| elevation(&file.with_values(values.clone()).expect("a shot"));
    assert_eq!((read(&default), read(&given)), (3.0, 20.0));
}

#[test]
fn a_batch_gives_each_variant_its_own_elevation() {
    let default = shot(0.06, "", "");
    let (_, own) = default.strike().expect("a strike");
    let strikes: Vec<Strike> =
        (0..8).map(|k| Strike { azimuth: 0.8 * f64::from(k), ..own }).collect();
    let batch = simulate_at_own_elevation(&default, &strikes, &Runner::default());
    let elevations: Vec<f64> =
        strikes.iter().map(|s| default.at_own_elevation(s).elevation).collect();
    assert!(elevations.iter().any(|e| *e != elevations[0]), "{elevations:?}");
    let explicit: Vec<Strike> =
        strikes.iter().zip(&elevations).map(|(s, e)| Strike { elevation: *e, ..*s }).collect();
    assert_eq!(batch, simulate_strikes(&default, &explicit, &Runner::default()));
}

#[test]
fn a_shot_that_refuses_an_obstructed_cue_accepts_its_default_elevation() {
    let refuses = |strike: &str| file(0.06, strike, BEHIND, r#""pool""#);
    assert!(refuses(r#", "elevation_deg": 0, "obstruction": "refuse""#).is_err());
    assert!(refuses(r#", "obstruction": "refuse""#).is_ok());
}

#[test]
fn noise_varies_the_angle_that_was_used() {
    let made = shot(1.27, "", "");
    let (_, meant) = made.strike().expect("a strike");
    let noise = Noise { elevation: radians(0.1), ..Noise::default() };
    let struck = StruckBall { radius: 0.028_575, largest_offset: 0.5 };
    let angles: Vec<f64> =
        (0..400).map(|k| noise.draw(&meant, &struck, 1, k).elevation).map(degrees).collect();
    let mean = angles.iter().sum::<f64>() / 400.0;
    assert!((mean - 3.0).abs() < 0.02, "{mean}");
    assert!(angles.iter().any(|a| (a - 3.0).abs() > 0.1));
}

#[test]
fn a_perceived_layout_has_the_default_elevation_of_its_own_balls() {
    let made = shot(1.27, "", BEHIND);
    let perception = Perception::round(0.01);
    let seen = perception.draw(&made, 3, 0).unwrap_or_else(|e| panic!("{e}"));
    assert!(seen.has_default_elevation());
    assert_eq!(seen.strike().map(|(_, s)| s.elevation), seen.least_elevation());
    assert_ne!(elevation(&seen), elevation(&made));
}

#[test]
fn every_break_is_struck_at_the_default_elevation() {
    for game in Game::ALL {
        let made = break_shot(&Break::new(game, 1)).unwrap_or_else(|e| panic!("{e}"));
        assert!(made.has_default_elevation(), "{game:?}");
        assert!(elevation(&made) >= 3.0, "{game:?}");
        assert_eq!(made.cue_obstruction(), None, "{game:?}");
    }
}

#[test]
fn a_strike_with_invalid_numbers_is_refused_and_not_searched() {
    let made = shot(1.27, "", "");
    let (_, own) = made.strike().expect("a strike");
    for wrong in [
        Strike { azimuth: f64::NAN, ..own },
        Strike { azimuth: f64::INFINITY, ..own },
        Strike { side: f64::NAN, ..own },
        Strike { side: 1e300, ..own },
        Strike { height: -7.0, ..own },
    ] {
        assert!(made.with_default_elevation(&wrong).is_err(), "{wrong:?}");
    }
    let level = Strike { azimuth: UP, ..own };
    assert!(made.with_default_elevation(&level).is_ok());
}
