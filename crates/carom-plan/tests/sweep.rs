//! The rows of a table of shots.

use carom::batch::{draw_strikes, simulate_strikes};
use carom::format::{KeyPath, Node};
use carom::runner::Runner;
use carom::{Noise, ShotFile};
use carom_plan::sweep::{self, Column, RowResults, SweepRows, Values};

const SPEEDS: [f64; 6] = [0.5, 1.0, 1.5, 2.0, 4.0, 8.0];

fn cut() -> ShotFile {
    let file = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.5, 0.7]}, {"id": "1", "position": [0.5, 1.4]}],
        "strike": {"ball": "cue", "speed": 1.5, "azimuth_deg": 92.3}}"#;
    ShotFile::from_json(file).unwrap()
}

#[test]
fn rows_of_strikes_are_the_batch_of_the_same_strikes() {
    let shot = cut();
    let (_, own) = shot.strike().unwrap();
    let strikes = SPEEDS.map(|speed| carom::resolve::cue_ball::Strike { speed, ..own });
    let batch = simulate_strikes(&shot, &strikes, &Runner::default());
    let rows = SweepRows {
        layouts: &[&shot],
        layout: &[0; SPEEDS.len()],
        columns: &[],
        strike: &[(0, &SPEEDS)],
        noise: None,
    };
    for outcomes in [false, true] {
        let RowResults { events, pocket, end, errors, .. } = sweep::play(&rows, 2, outcomes);
        assert_eq!((&events, &pocket, errors.len()), (&batch.events, &batch.pocket, 0));
        let places: Vec<_> = (0..end[0].len()).map(|i| [end[0][i], end[1][i], end[2][i]]).collect();
        assert_eq!(places, batch.final_position);
    }
}

#[test]
fn a_row_with_noise_plays_the_variant_of_its_index() {
    let shot = cut();
    let (noise, seed) = (Noise::olympiad(1.0), 7);
    let rows = SweepRows {
        layouts: &[&shot],
        layout: &[0; 3],
        columns: &[],
        strike: &[],
        noise: Some((&noise, seed, &[5, 1, 5])),
    };
    let played = sweep::play(&rows, 2, false);
    let drawn = draw_strikes(&shot, &noise, 6, seed, 0).unwrap();
    assert_eq!(played.strike[0], [5, 1, 5].map(|i: usize| drawn[i].speed));
    assert_eq!(played.end[0][..2], played.end[0][4..]);
}

#[test]
fn the_result_of_a_row_does_not_depend_on_the_row_before() {
    let shot = cut();
    let path = KeyPath::parse("physics.cue.tip_friction").unwrap();
    // With a slippery tip, strikes far off centre cannot be played.
    let choices = [0.1, 0.7].map(Node::Number);
    let play = |order: &[usize]| {
        let choice: Vec<i32> = order.iter().map(|i| i32::from(i % 2 == 0)).collect();
        let side: Vec<f64> = order.iter().map(|i| 0.1 * *i as f64).collect();
        let columns = [Column { path: &path, values: Values::Choices(&choices, &choice) }];
        let layout = vec![0; order.len()];
        let rows = SweepRows {
            layouts: &[&shot],
            layout: &layout,
            columns: &columns,
            strike: &[(3, &side)],
            noise: None,
        };
        let played = sweep::play(&rows, 2, true);
        let error = |row| played.errors.iter().find(|(k, _)| *k == row).map(|(_, e)| e.to_string());
        let mut rows: Vec<_> = (0..order.len())
            .map(|k| (order[k], played.events[k], played.outcomes[k], error(k)))
            .collect();
        rows.sort_by_key(|row| row.0);
        rows
    };
    let there = play(&[0, 1, 2, 3, 4, 5]);
    assert_eq!(there, play(&[5, 3, 1, 4, 2, 0]));
    assert_eq!(there, play(&[0, 2, 4, 1, 3, 5]));
    assert!(there.iter().any(|row| row.3.is_some()) && there.iter().any(|row| row.3.is_none()));
}
