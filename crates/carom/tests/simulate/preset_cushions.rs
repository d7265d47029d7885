//! The cushions of the presets in whole shots, compared with measurements.

use carom::trace::TraceEventKind;
use carom::{Physics, Shot};

/// Speeds (m/s) before and after the first contact with the top rail, for a ball that rolls
/// squarely at this rail of `table` with `speed` m/s at the start.
fn square_rebound(table: &str, physics: &str, speed: f64) -> (f64, f64) {
    let radius = Physics::preset(physics).expect("a preset").ball.radius;
    let size = carom::Table::preset(table).expect("a preset").size;
    let spin = -speed / radius;
    let text = format!(
        r#"{{"format": "carom-shot/1", "table": "{table}", "physics": "{physics}",
            "balls": [{{"id": "cue", "position": [{x:?}, {y:?}],
                        "velocity": [0.0, {speed:?}, 0.0], "angular_velocity": [{spin:?}, 0.0, 0.0]}}]}}"#,
        x = 0.5 * size.x,
        y = size.y - 0.05,
    );
    let trace = Shot::from_json(&text).and_then(|shot| shot.simulate());
    let trace = trace.unwrap_or_else(|e| panic!("{speed} m/s: {e}"));
    let hit = trace.events().find(|e| matches!(e.kind, TraceEventKind::RailCollision { .. }));
    let hit = hit.expect("it reaches the rail");
    (hit.before[0].velocity.length(), hit.after[0].velocity.length())
}

#[test]
fn a_snooker_ball_rebounds_as_in_mathavans_film() {
    // Mathavan, Jackson & Parkin 2009, Fig. 9 (row CU-8): 31 rebounds, 0.28 to 3.5 m/s.
    let film = |x: f64| -0.0877 * x * x + 1.131 * x - 0.0953;
    /// Tolerance of the row, m/s.
    const TOLERANCE: f64 = 0.05;
    /// Error of the preset's fit, m/s.
    const RMS: f64 = 0.025;
    const SPEEDS: u32 = 40;
    let mut sum = 0.0;
    for n in 0..SPEEDS {
        let speed = 0.29 + 3.21 * f64::from(n) / f64::from(SPEEDS - 1);
        let (before, after) = square_rebound("snooker-12ft", "snooker", speed);
        let miss = after - film(before);
        assert!(miss.abs() <= TOLERANCE, "{before} m/s: {after}, on film {}", film(before));
        sum += miss * miss;
    }
    let rms = (sum / f64::from(SPEEDS)).sqrt();
    println!("CU-8: {rms:.4} m/s rms");
    assert!(rms <= RMS, "{rms} m/s rms");
}

#[test]
fn restitution_of_a_cushion_falls_with_the_speed_and_never_vanishes() {
    for (table, physics) in [("snooker-12ft", "snooker"), ("english-7ft", "english")] {
        let mut last = 1.0;
        for n in 4..40 {
            let (before, after) = square_rebound(table, physics, 0.25 * f64::from(n));
            let share = after / before;
            assert!(share <= last + 1e-9 && share > 0.5, "{physics}, {before} m/s: {share}");
            last = share;
        }
    }
}
