//! Kick and bank tables agree with the events of single shots.

use carom::Shot;
use carom::resolve::cue_ball::Strike;
use carom::trace::TraceEventKind;
use carom_plan::Progress;
use carom_plan::cushions::{CushionContact, Kicks, bank_table, kick_table};

fn shot() -> Shot {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "2", "position": [0.6, 1.3]}, {"id": "cue", "position": [0.5, 1.2]},
                  {"id": "1", "position": [0.9, 1.9]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#;
    Shot::from_json(text).expect("a shot")
}

/// The contacts with noses up to the first jaw.
fn contacts(shot: &Shot) -> Vec<CushionContact> {
    let trace = shot.simulate().expect("a trace");
    let mut met = Vec::new();
    for event in trace.events() {
        if let TraceEventKind::RailCollision { rail, part, .. } = event.kind {
            if part != carom::table::Part::Nose {
                break;
            }
            let place = event.before[0].position;
            met.push((rail, [place.x, place.y]));
        }
    }
    met
}

const AZIMUTHS: [f64; 4] = [0.3, 1.1, 2.5, 4.4];

#[test]
fn a_kick_is_the_struck_ball_alone_on_the_table() {
    let (shot, speeds, sides) = (shot(), [2.0, 5.0], [-0.3, 0.0, 0.3]);
    let kicks = Kicks { azimuths: &AZIMUTHS, speeds: &speeds, sides: &sides, height: 0.1 };
    let progress = Progress::default();
    let found = kick_table(&shot, &kicks, 3, None, &progress).expect("a table");
    assert_eq!((found.len(), progress.read().done, progress.read().total), (24, 24, 24));
    let (_, own) = shot.strike().expect("a strike");
    let mut most = 0;
    for (k, cell) in found.iter().enumerate() {
        let (azimuth, speed) = (AZIMUTHS[k / 6], speeds[k / 3 % 2]);
        let strike = Strike { azimuth, speed, side: sides[k % 3], height: 0.1, ..own };
        let alone = vec![shot.balls()[1].clone()];
        let mut expected = contacts(&shot.with_balls(alone, Some((0, strike))).expect("a shot"));
        expected.truncate(3);
        assert_eq!(*cell, expected);
        most = most.max(cell.len());
    }
    assert_eq!(most, 3, "kicks that meet nothing test nothing");
    let alone = kick_table(&shot, &kicks, 3, Some(1), &Progress::default());
    assert_eq!(alone.expect("a table"), found, "threads change nothing");
}

#[test]
fn a_bank_is_a_ball_that_starts_with_a_velocity() {
    let (shot, speeds) = (shot(), [1.0, 4.0]);
    let found = bank_table(&shot, 2, &AZIMUTHS, &speeds, 2, None, &Progress::default());
    let found = found.expect("a table");
    assert_eq!(found.len(), 8);
    for (k, cell) in found.iter().enumerate() {
        let (sin, cos) = carom::math::sin_cos(AZIMUTHS[k / 2]);
        let mut ball = shot.balls()[2].clone();
        ball.state.velocity.x = speeds[k % 2] * cos;
        ball.state.velocity.y = speeds[k % 2] * sin;
        let mut expected = contacts(&shot.with_balls(vec![ball], None).expect("a shot"));
        expected.truncate(2);
        assert_eq!(*cell, expected);
    }
    assert!(found.iter().any(|cell| cell.len() == 2));
}

#[test]
fn a_stopped_table_leaves_the_rest_empty() {
    let progress = Progress::default();
    progress.stop();
    let found = bank_table(&shot(), 2, &AZIMUTHS, &[3.0], 2, None, &progress).expect("a table");
    assert_eq!(found, vec![Vec::new(); 4]);
}

#[test]
fn bad_arguments_are_rejected_by_name() {
    let without = shot().with_balls(shot().balls().to_vec(), None).expect("a shot");
    let kick = |shot: &Shot, speed| {
        let kicks = Kicks { azimuths: &[0.0], speeds: &[speed], sides: &[0.0], height: 0.0 };
        let found = kick_table(shot, &kicks, 3, None, &Progress::default());
        found.expect_err("nonsense").to_string()
    };
    assert!(kick(&without, 1.0).starts_with("strike: "));
    assert!(kick(&shot(), -1.0).starts_with("strike.speed: "));
    let bank = |shot: &Shot, ball, speed| {
        let found = bank_table(shot, ball, &[0.0], &[speed], 3, None, &Progress::default());
        found.expect_err("nonsense").to_string()
    };
    assert!(bank(&shot(), 7, 1.0).starts_with("ball: "));
    for speed in [-1.0, 0.0, 1e9, f64::NAN] {
        assert!(bank(&shot(), 2, speed).starts_with("speed: "), "{speed}");
    }
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "cue", "position": [0, 0]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#;
    let endless = Shot::from_json(text).expect("a shot");
    assert!(kick(&endless, 1.0).starts_with("table: "));
    assert!(bank(&endless, 0, 1.0).starts_with("table: "));
}

#[test]
fn the_error_of_the_first_cell_that_fails_is_returned_for_any_number_of_threads() {
    let speeds = [1.0, 200.0, 300.0];
    let kicks = Kicks { azimuths: &AZIMUTHS, speeds: &speeds, sides: &[0.0], height: 0.0 };
    for threads in [Some(1), Some(2), None] {
        let found = kick_table(&shot(), &kicks, 2, threads, &Progress::default());
        let text = found.expect_err("too fast").to_string();
        assert!(text.contains("200"), "{text}");
    }
}
