//! Batches on a device: flat arrays, what the device leaves to this machine, and its failures.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use carom::batch::{BatchResult, simulate_batch, simulate_strikes, simulate_variants};
use carom::device::{Device, FlatEnds, FlatRow, FlatShots};
use carom::limits::SMALL_CAPACITY;
use carom::noise::Errors;
use carom::runner::Runner;
use carom::simulate::Simulation;
use carom::{Error, ErrorKind, Noise, Shot};

/// A device that plays the flat arrays on this machine, a few at a time.
#[derive(Debug, Default)]
struct Flat {
    calls: AtomicUsize,
    shots: AtomicUsize,
}

impl Device for Flat {
    fn most_balls(&self) -> usize {
        SMALL_CAPACITY
    }

    fn most_shots(&self) -> usize {
        7
    }

    fn play(&self, shots: &FlatShots) -> Result<FlatEnds, Error> {
        assert!(shots.shots.len() <= 7);
        self.calls.fetch_add(1, Ordering::Relaxed);
        self.shots.fetch_add(shots.shots.len(), Ordering::Relaxed);
        let mut simulation = Box::new(Simulation::<SMALL_CAPACITY>::new());
        let mut ends = FlatEnds::of(shots);
        let width = ends.width;
        for k in 0..shots.shots.len() {
            let row = FlatRow {
                position: &mut ends.position[k * width..][..width],
                pocket: &mut ends.pocket[k * width..][..width],
            };
            ends.end[k] = shots.view().play(k, &mut simulation, row);
        }
        Ok(ends)
    }
}

/// A device that fails.
#[derive(Debug)]
struct Broken;

impl Device for Broken {
    fn most_balls(&self) -> usize {
        SMALL_CAPACITY
    }

    fn most_shots(&self) -> usize {
        100
    }

    fn play(&self, _: &FlatShots) -> Result<FlatEnds, Error> {
        Err(ErrorKind::System.at("device", "it is broken", "repair it"))
    }
}

/// Every example shot.
fn examples() -> Vec<Shot> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shots");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("shots/")
        .map(|file| file.expect("a file").path())
        .collect();
    files.sort();
    let read = |file: &std::path::PathBuf| {
        Shot::from_json(&std::fs::read_to_string(file).expect("a text")).expect("a shot")
    };
    files.iter().map(read).collect()
}

/// The same results, bit for bit.
fn assert_equal(device: &BatchResult, here: &BatchResult) {
    let bits = |result: &BatchResult| {
        result.final_position.iter().map(|place| place.map(f64::to_bits)).collect::<Vec<_>>()
    };
    assert_eq!(bits(device), bits(here));
    assert_eq!((&device.pocket, &device.events), (&here.pocket, &here.events));
    assert_eq!(device.errors, here.errors);
}

#[test]
fn shots_on_a_device_have_the_bits_of_this_machine() {
    let mut shots = examples();
    // A shot that fails, and one with more balls than the device can play.
    shots.insert(3, shots[0].with_max_events(1));
    let rows: String = (0..30)
        .map(|k| format!(r#",{{"id":"{k}","position":[{},1.2]}}"#, 0.2 + 0.06 * f64::from(k)))
        .collect();
    let crowd = format!(
        r#"{{"format":"carom-shot/1","table":{{"cloth":"unbounded"}},
            "balls":[{{"id":"cue","position":[0,0],"velocity":[1,1,0]}}{rows}]}}"#
    );
    shots.push(Shot::from_json(&crowd).expect("a shot"));
    let device = Arc::new(Flat::default());
    let on_device = simulate_batch(&shots, &Runner::default().on(device.clone()));
    let here = simulate_batch(&shots, &Runner::default());
    assert_equal(&on_device, &here);
    assert_eq!(here.errors.len(), 1);
    assert_eq!(device.shots.load(Ordering::Relaxed), shots.len() - 1);
    assert_eq!(device.calls.load(Ordering::Relaxed), shots.len().div_ceil(7));
}

#[test]
fn variants_of_a_shot_share_its_flat_table_physics_and_balls() {
    let shot = examples().into_iter().find(|shot| shot.strike().is_some()).expect("a strike");
    let (_, strike) = shot.strike().expect("a strike");
    let mut flat = FlatShots::default();
    for _ in 0..5 {
        flat.push(&shot, shot.strike());
    }
    assert_eq!((flat.tables.len(), flat.physics.len()), (1, 1));
    assert_eq!((flat.balls.len(), flat.shots.len()), (shot.balls().len(), 5));

    let strikes: Vec<_> = (0..20)
        .map(|k| carom::resolve::cue_ball::Strike { speed: 0.1 * f64::from(k), ..strike })
        .collect();
    let device = Runner::default().on(Arc::new(Flat::default()));
    let here = simulate_strikes(&shot, &strikes, &Runner::default());
    assert_eq!(here.errors.len(), 1, "a speed of 0 is refused");
    assert_equal(&simulate_strikes(&shot, &strikes, &device), &here);
}

#[test]
fn a_device_that_fails_is_an_error_of_its_shots_and_of_variants() {
    let shots = examples();
    let broken = Runner::default().on(Arc::new(Broken));
    let result = simulate_batch(&shots, &broken);
    assert_eq!(result.errors.len(), shots.len());
    assert!(result.errors.iter().all(|(_, error)| error.kind() == ErrorKind::System));
    let shot = shots.into_iter().find(|shot| shot.strike().is_some()).expect("a strike");
    let (_, strike) = shot.strike().expect("a strike");
    let errors = Errors { noise: Noise::default(), ..Errors::default() };
    let failed = simulate_variants(&shot, &[strike], &errors, 0, &broken).expect_err("a failure");
    assert_eq!(failed.kind(), ErrorKind::System);
}
