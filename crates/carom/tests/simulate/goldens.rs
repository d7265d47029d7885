//! Every example shot keeps its bits: in this build, with and without a trace, alone and in batches
//! of one and two threads.

use std::fs;
use std::path::Path;

use carom::batch::simulate_batch;
use carom::event::NullRecorder;
use carom::runner::Runner;
use carom::{Shot, Trace};
use serde_json::{Map, Value, json};

struct Golden {
    name: String,
    shot: Shot,
    events: u64,
    hash: String,
}

fn goldens() -> Vec<Golden> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(root.join("goldens/shots.json")).expect("goldens/shots.json");
    let all: Map<String, Value> = serde_json::from_str(&text).expect("JSON");
    let read = |(name, golden): (String, Value)| {
        let file = fs::read_to_string(root.join(format!("shots/{name}.json"))).expect(&name);
        Golden {
            shot: Shot::from_json(&file).expect(&name),
            events: golden["events"].as_u64().expect("a count"),
            hash: golden["hash"].as_str().expect("a hash").to_owned(),
            name,
        }
    };
    all.into_iter().map(read).collect()
}

fn simulated(golden: &Golden) -> Trace {
    golden.shot.simulate().unwrap_or_else(|e| panic!("{}: {e}", golden.name))
}

#[test]
fn every_example_shot_has_a_golden() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shots");
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .map(|path| path.file_stem().expect("a name").to_str().expect("ASCII").to_owned())
        .collect();
    names.sort();
    let held: Vec<String> = goldens().into_iter().map(|g| g.name).collect();
    assert_eq!(held, names, "run `make goldens`");
}

#[test]
fn every_example_shot_has_the_bits_of_its_golden() {
    let held = goldens();
    let form = |g: &Golden, events: u64, hash: &str| {
        (g.name.clone(), json!({"events": events, "hash": hash}))
    };
    let ours: Map<String, Value> = held
        .iter()
        .map(|g| {
            let trace = simulated(g);
            form(g, trace.events().len() as u64, &format!("{:016x}", trace.hash()))
        })
        .collect();
    let golden: Map<String, Value> = held.iter().map(|g| form(g, g.events, &g.hash)).collect();
    // All shots are compared before the test fails, so that an intended change shows every shot it
    // affects.
    assert_eq!(ours, golden, "see goldens/README.md");
}

#[test]
fn a_shot_without_a_trace_is_the_same_shot() {
    for golden in goldens() {
        let trace = simulated(&golden);
        let summary = carom::simulate(&golden.shot, &mut NullRecorder).expect("it ends");
        assert_eq!(u64::from(summary.events), golden.events, "{}", golden.name);
        let last = trace.events().last().expect("an event").time;
        assert_eq!(summary.duration.to_bits(), last.to_bits(), "{}", golden.name);
    }
}

#[test]
fn batches_of_one_and_two_threads_end_in_the_same_bits_as_single_shots() {
    let held = goldens();
    let shots: Vec<&Shot> = held.iter().map(|g| &g.shot).collect();
    for threads in [1, 2] {
        let batch = simulate_batch(&shots, &Runner::new(Some(threads)).expect("threads"));
        assert!(batch.errors.is_empty(), "{:?}", batch.errors);
        for (k, golden) in held.iter().enumerate() {
            assert_eq!(batch.events[k] as u64, golden.events, "{}", golden.name);
            let row = &batch.final_position[k * batch.balls..];
            for (i, state) in simulated(golden).last().iter().enumerate() {
                let p = state.position;
                let bits = [p.x, p.y, p.z].map(f64::to_bits);
                assert_eq!(row[i].map(f64::to_bits), bits, "{} ball {i}", golden.name);
            }
        }
    }
}
