//! Nothing is allocated while a shot runs.

use carom::event::NullRecorder;
use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;

use crate::support::shot;

/// Balls in a frozen row, struck: clusters, pushes, cushions and a pocket.
fn busy_shot() -> carom::Shot {
    let balls: Vec<String> = (0..10)
        .map(|k| {
            let y = 1.3 + 0.05715 * f64::from(k);
            format!(r#"{{"id": "{k}", "position": [0.635, {y:?}]}}"#)
        })
        .collect();
    shot(&format!(
        r#""table": "wpa-9ft", "balls": [{{"id": "cue", "position": [0.6, 0.6]}}, {}],
           "strike": {{"ball": "cue", "speed": 8.0, "azimuth_deg": 88.0, "side": 0.3}}"#,
        balls.join(", ")
    ))
}

#[test]
fn a_shot_allocates_nothing_from_its_strike_to_rest() {
    let shot = busy_shot();
    let mut simulation = Box::new(Simulation::<SMALL_CAPACITY>::new());
    let mut events = 0;
    let measured = allocation_counter::measure(|| {
        events = simulation.play(&shot, &mut NullRecorder).map_or(0, |summary| summary.events);
    });
    assert!(events > 50, "{events}");
    assert_eq!(measured.count_total, 0);
    let counts = allocation_counter::measure(|| drop(std::hint::black_box(shot.simulate())));
    assert!(counts.count_total > 0, "the counter counts");
}
