//! Kick and bank tables list what the events of single shots say.

use carom::Shot;
use carom::resolve::cue_ball::Strike;
use carom::trace::TraceEventKind;
use carom_plan::cushions::{Met, bank_table, kick_table};

fn shot() -> Shot {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "2", "position": [0.6, 1.3]}, {"id": "cue", "position": [0.5, 1.2]},
                  {"id": "1", "position": [0.9, 1.9]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#;
    Shot::from_json(text).expect("a shot")
}

/// Noses up to the first jaw.
fn met(shot: &Shot) -> Vec<Met> {
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
fn kicks_are_the_struck_ball_alone_on_the_table() {
    let (shot, speeds, sides) = (shot(), [2.0, 5.0], [-0.3, 0.0, 0.3]);
    let mut told = 0;
    let mut tell = |done| {
        told = done;
        true
    };
    let found = kick_table(&shot, &AZIMUTHS, &speeds, &sides, 0.1, 3, None, &mut tell);
    let found = found.expect("a table");
    assert_eq!((found.len(), told), (24, 4));
    let (_, own) = shot.strike().expect("a strike");
    let mut most = 0;
    for (k, cell) in found.iter().enumerate() {
        let (azimuth, speed) = (AZIMUTHS[k / 6], speeds[k / 3 % 2]);
        let strike = Strike { azimuth, speed, side: sides[k % 3], height: 0.1, ..own };
        let alone = vec![shot.balls()[1].clone()];
        let mut expected = met(&shot.with_balls(alone, Some((0, strike))).expect("a shot"));
        expected.truncate(3);
        assert_eq!(*cell, expected);
        most = most.max(cell.len());
    }
    assert_eq!(most, 3, "kicks that meet nothing test nothing");
    let alone = kick_table(&shot, &AZIMUTHS, &speeds, &sides, 0.1, 3, Some(1), &mut |_| true);
    assert_eq!(alone.expect("a table"), found, "threads change nothing");
}

#[test]
fn banks_are_a_ball_that_is_sent_off() {
    let (shot, speeds) = (shot(), [1.0, 4.0]);
    let found = bank_table(&shot, 2, &AZIMUTHS, &speeds, 2, None, &mut |_| true).expect("a table");
    assert_eq!(found.len(), 8);
    for (k, cell) in found.iter().enumerate() {
        let (sin, cos) = carom::math::sin_cos(AZIMUTHS[k / 2]);
        let mut ball = shot.balls()[2].clone();
        ball.state.velocity.x = speeds[k % 2] * cos;
        ball.state.velocity.y = speeds[k % 2] * sin;
        let mut expected = met(&shot.with_balls(vec![ball], None).expect("a shot"));
        expected.truncate(2);
        assert_eq!(*cell, expected);
    }
    assert!(found.iter().any(|cell| cell.len() == 2));
}

#[test]
fn a_table_that_is_stopped_ends_there() {
    let many: Vec<f64> = (0..5000).map(|k| 0.001 * f64::from(k)).collect();
    let found = bank_table(&shot(), 2, &many, &[3.0], 2, Some(1), &mut |_| false);
    let found = found.expect("a table");
    assert_eq!(found.len(), 5000);
    assert!(!found[0].is_empty() && found[4999].is_empty());
}

#[test]
fn nonsense_is_refused() {
    let without = shot().with_balls(shot().balls().to_vec(), None).expect("a shot");
    let kick = |shot: &Shot, speed| {
        let error = kick_table(shot, &[0.0], &[speed], &[0.0], 0.0, 3, None, &mut |_| true);
        error.expect_err("nonsense").to_string()
    };
    assert!(kick(&without, 1.0).starts_with("strike: "));
    assert!(kick(&shot(), -1.0).starts_with("strike.speed: "));
    let bank = |ball, speed| {
        let error = bank_table(&shot(), ball, &[0.0], &[speed], 3, None, &mut |_| true);
        error.expect_err("nonsense").to_string()
    };
    assert!(bank(7, 1.0).starts_with("ball: "));
    assert!(bank(2, 1e9).starts_with("balls[0].velocity: "));
}
