//! The order in which a file lists its balls decides ties and nothing else.

use carom::Shot;

fn events(balls: &str) -> u32 {
    let text = format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{balls}],
            "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0}}}}"#
    );
    let shot = Shot::from_json(&text).unwrap();
    carom::simulate(&shot, &mut carom::event::NullRecorder).unwrap().events
}

/// Seen: a cue ball listed last passed through every ball. Cause: at time 0 only pairs of a moving
/// ball with later ones were searched.
#[test]
fn a_struck_ball_meets_the_balls_listed_before_it() {
    let cue = r#"{"id": "cue", "position": [0.635, 0.635]}"#;
    let one = r#"{"id": "1", "position": [0.640, 1.905]}"#;
    let first = events(&format!("{cue}, {one}"));
    let last = events(&format!("{one}, {cue}"));
    assert_eq!(first, last);
    let alone = events(cue);
    assert_ne!(first, alone);
}
