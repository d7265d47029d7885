//! Balls that start in the air: their allowed positions and their motion states.

use carom::{MotionState, Shot};

const RADIUS: f64 = 0.028575;
const NOSE: f64 = 0.635 * 2.0 * RADIUS;

fn shot(balls: &str) -> Result<Shot, carom::Error> {
    Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{balls}]}}"#
    ))
}

/// One ball at x, y, z without velocity.
fn at(x: f64, y: f64, z: f64) -> Result<Shot, carom::Error> {
    shot(&format!(r#"{{"id": "a", "position": [{x:?}, {y:?}, {z:?}]}}"#))
}

fn motion(shot: Result<Shot, carom::Error>) -> MotionState {
    shot.unwrap_or_else(|e| panic!("{e}")).balls()[0].state.motion
}

fn refusal(shot: Result<Shot, carom::Error>) -> String {
    shot.expect_err("refused").to_string()
}

#[test]
fn a_ball_above_the_bed_or_with_a_vertical_velocity_is_airborne() {
    assert_eq!(motion(at(0.5, 0.5, RADIUS)), MotionState::Stationary);
    assert_eq!(motion(at(0.5, 0.5, RADIUS + 1e-6)), MotionState::Airborne);
    for velocity in ["[0, 0, 1]", "[1, 0, -1]"] {
        let ball = format!(r#"{{"id": "a", "position": [0.5, 0.5], "velocity": {velocity}}}"#);
        assert_eq!(motion(shot(&ball)), MotionState::Airborne);
    }
}

#[test]
fn a_height_within_rounding_of_the_radius_is_the_radius() {
    for z in [RADIUS - 0.9e-9, RADIUS + 0.9e-9] {
        let shot = at(0.5, 0.5, z).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(shot.balls()[0].state.position.z.to_bits(), RADIUS.to_bits());
        assert_eq!(motion(Ok(shot)), MotionState::Stationary);
    }
}

#[test]
fn low_balls_must_keep_the_distance_from_the_nose_at_their_height() {
    for z in [RADIUS + 1e-3, NOSE, NOSE + 0.5 * RADIUS] {
        let reach = (RADIUS * RADIUS - (z - NOSE) * (z - NOSE)).sqrt();
        assert_eq!(motion(at(reach, 0.8, z)), MotionState::Airborne, "touching at {z} m");
        let sentence = refusal(at(reach - 2e-9, 0.8, z));
        assert!(sentence.contains("deep in the nose of the left-lower"), "{sentence}");
        assert!(sentence.contains("raise it above the rails"), "{sentence}");
    }
}

#[test]
fn a_ball_may_start_on_or_above_a_rails_top_but_not_inside_the_rail() {
    let width = 6.0 * 0.0254;
    let top = NOSE + RADIUS;
    for x in [0.0, -0.05, 1e-9 - width] {
        assert_eq!(motion(at(x, 0.8, top)), MotionState::Airborne);
        assert_eq!(motion(at(x, 0.8, 1.0)), MotionState::Airborne);
        assert!(refusal(at(x, 0.8, top - 2e-9)).starts_with("balls[0].position: "));
    }
    let sentence = refusal(at(-1e-6 - width, 0.8, top));
    assert!(sentence.contains("beyond the rails"), "{sentence}");
}

#[test]
fn a_ball_may_start_above_a_hole_but_not_inside_its_wall() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let pocket = &table.pockets[0];
    let at = |along: f64, z: f64| {
        let p = pocket.center + table.center() + pocket.axis * along;
        at(p.x, p.y, z)
    };
    let low = RADIUS + 1e-3;
    assert_eq!(motion(at(0.0, low)), MotionState::Airborne);
    let resting = refusal(at(0.0, RADIUS));
    assert!(resting.contains("stands over the bottom-left pocket"), "{resting}");
    // Over the lip, and between the lip and the wall at the back.
    let touching = pocket.radius - RADIUS;
    for along in [-pocket.radius, -touching, 0.9 * touching, touching] {
        assert_eq!(motion(at(along, low)), MotionState::Airborne, "{along}");
    }
    let sentence = refusal(at(touching + 2e-9, low));
    assert!(sentence.contains("deep in the liner of the"), "{sentence}");
    // Above the wall the ball may touch the rim.
    let above = 0.8 * RADIUS;
    let reach = (RADIUS * RADIUS - above * above).sqrt();
    assert_eq!(motion(at(pocket.radius - reach, NOSE + above)), MotionState::Airborne);
    assert!(refusal(at(pocket.radius - reach + 2e-9, NOSE + above)).contains("liner"));
    let in_the_wood = refusal(at(pocket.radius + 1e-3, NOSE + above));
    assert!(in_the_wood.contains("deep in the top of the"), "{in_the_wood}");
    assert_eq!(motion(at(pocket.radius + 1e-3, NOSE + RADIUS)), MotionState::Airborne);
}

#[test]
fn beyond_a_mouth_line_no_ball_may_start_below_the_rails() {
    let at = |z: f64| {
        Shot::from_json(&format!(
            r#"{{"format": "carom-shot/1",
                "table": {{"base": "wpa-9ft", "pocket_model": "mouth-line"}},
                "balls": [{{"id": "a", "position": [0.0, 0.0, {z:?}]}}]}}"#
        ))
    };
    assert!(refusal(at(NOSE)).contains("over the bottom-left pocket"));
    assert_eq!(motion(at(NOSE + RADIUS)), MotionState::Airborne);
}

#[test]
fn overlaps_in_the_air_are_measured_in_space() {
    let two = |z: f64| {
        shot(&format!(
            r#"{{"id": "a", "position": [0.5, 0.5]}}, {{"id": "b", "position": [0.5, 0.5, {z:?}]}}"#
        ))
    };
    two(3.0 * RADIUS).unwrap_or_else(|e| panic!("balls that touch: {e}"));
    assert!(refusal(two(3.0 * RADIUS - 2e-9)).contains("overlaps"));
}

#[test]
fn a_ball_in_the_air_cannot_be_struck() {
    let sentence = refusal(Shot::from_json(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.5, 0.5, 0.1]}],
            "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 90}}"#,
    ));
    assert!(sentence.starts_with("strike.ball: "), "{sentence}");
    assert!(sentence.contains("does not lie on the cloth"), "{sentence}");
}
