//! Sampled states and residuals of many candidates.
#![cfg(feature = "json")]

mod candidates;
mod residuals;
mod start_states;
mod states;

use carom::Shot;
use carom::runner::Runner;

/// An example shot of `shots/`.
fn example(name: &str) -> Shot {
    let path = format!("{}/../../shots/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    Shot::from_json(&text).unwrap_or_else(|e| panic!("{e}"))
}

/// Every example shot.
fn examples() -> Vec<(String, Shot)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shots");
    let files = std::fs::read_dir(folder).expect("shots/").map(|f| f.expect("a file").path());
    let name = |file: std::path::PathBuf| file.file_stem()?.to_str().map(String::from);
    let mut names: Vec<String> = files.filter_map(name).collect();
    names.sort();
    names.into_iter().map(|name| (name.clone(), example(&name))).collect()
}

/// Three balls on a table without pockets, as in three-cushion.
fn three_balls() -> Shot {
    Shot::from_json(
        r#"{"format": "carom-shot/1", "table": "carom-10ft",
            "balls": [{"id": "cue", "position": [0.7, 0.6]}, {"id": "1", "position": [0.9, 2.2]},
                      {"id": "2", "position": [0.4, 2.0]}],
            "strike": {"ball": "cue", "speed": 4, "azimuth_deg": 78, "side": 0.3, "height": 0.2}}"#,
    )
    .unwrap_or_else(|e| panic!("{e}"))
}

fn runner(threads: usize) -> Runner {
    Runner::new(Some(threads)).unwrap_or_else(|e| panic!("{e}"))
}
